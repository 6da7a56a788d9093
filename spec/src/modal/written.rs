//! The words of a block in written order.

use crate::syntax::Address;
use crate::vocabulary::Label;

/// A word by what names it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Written {
    /// A G word.
    G(u16),
    /// An M word.
    M(u16),
    /// A word of another address.
    Word(Address),
    /// CALRG.
    MajorArc,
}

impl Written {
    /// The code, or the address.
    pub fn label(self) -> Label {
        match self {
            Self::G(code) => Label::of_code(b'G', code),
            Self::M(code) => Label::of_code(b'M', code),
            Self::Word(address) => address.label(),
            Self::MajorArc => Label::new("CALRG"),
        }
    }
}
