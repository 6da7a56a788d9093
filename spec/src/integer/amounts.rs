//! Amounts of the four axes: positions, offsets, shifts.

use super::turn;
use crate::vocabulary::AxisAmounts;

/// One amount an axis: X (as a diameter), Z and W in nanometres, C in micro-degrees. Every amount of a set-up, a
/// variable or a word is below 2^38; sums of them are below 2^60.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Amounts {
    /// X.
    pub x: i64,
    /// Z.
    pub z: i64,
    /// C.
    pub c: i64,
    /// W.
    pub w: i64,
}

impl Amounts {
    /// The amounts of a set-up.
    #[must_use]
    pub fn of(amounts: &AxisAmounts) -> Self {
        Self { x: amounts.x.0, z: amounts.z.0, c: amounts.c.0, w: amounts.w.0 }
    }

    /// The sum, or with the sign -1 the difference (E100L-COORD-03).
    #[must_use]
    pub fn plus(self, other: Self, sign: i64) -> Self {
        Self {
            x: self.x + sign * other.x,
            z: self.z + sign * other.z,
            c: self.c + sign * other.c,
            w: self.w + sign * other.w,
        }
    }

    /// With C brought into a full turn.
    #[must_use]
    pub fn turned(self) -> Self {
        Self { c: turn::within(self.c), ..self }
    }
}
