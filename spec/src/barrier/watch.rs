//! Which barriers watch the motions of a block (E100L-BARR-04, E100L-BARR-05).

use crate::state::State;

/// The barriers that watch; none at power-on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Watch {
    /// That of the chuck.
    pub chuck: bool,
    /// That of the tailstock.
    pub tailstock: bool,
}

impl Watch {
    /// The barriers that M25 and M21 have switched on.
    pub fn in_force(state: &State) -> Self {
        Self { chuck: state.is_active(25), tailstock: state.is_active(21) }
    }

    /// E100L-BARR-04: on before the M codes of a block or after them, so that the blocks of the ON code and of the OFF
    /// code are included.
    pub fn or(self, other: Self) -> Self {
        Self { chuck: self.chuck || other.chuck, tailstock: self.tailstock || other.tailstock }
    }
}
