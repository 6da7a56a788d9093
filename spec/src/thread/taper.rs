//! The taper of a thread (E100L-G33-05, E100L-G33-06).

use crate::fault::{Fault, Outcome};
use crate::path::{Inclination, Vector, x_at, z_at};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, LeadAxis, RuleId};

/// A taper as it is programmed.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Taper {
    /// The thread is straight.
    #[default]
    None,
    /// The level at the end less the level at the start, in nanometres; of X a diameter.
    Amount(i64),
    /// The angle of the thread, in micro-degrees.
    Angle(i64),
}

impl Taper {
    /// The words of a block: a difference, of X as a radius, or an angle.
    pub fn of(amount: Option<i64>, angle: Option<i64>, axis: LeadAxis) -> Option<Self> {
        // E100L-G33-05: I is a radius; E100L-G32-01: K is a length along Z.
        let scale = if axis == LeadAxis::Z { 2 } else { 1 };
        amount.map(|amount| Self::Amount(amount * scale)).or(angle.map(Self::Angle))
    }

    /// The level at the end less the level at the start of a thread from here to there.
    pub fn rise(self, axis: LeadAxis, from: i64, to: i64) -> Outcome<i64> {
        let square = |_| Fault::new(AlarmName::AngleNoIntersection, G33_06);
        match (self, axis) {
            (Self::None, _) => Ok(0),
            (Self::Amount(amount), _) => Ok(amount),
            (Self::Angle(angle), LeadAxis::Z) => {
                x_at(&Vector::of(0, from), Inclination(angle), to).map_err(square)
            }
            (Self::Angle(angle), LeadAxis::X) => {
                z_at(&Vector::of(from, 0), Inclination(angle), to).map_err(square)
            }
        }
    }

    /// The rule of a taper that is not zero.
    pub fn rule(self) -> RuleId {
        if matches!(self, Self::Angle(_)) { G33_06 } else { G33_05 }
    }
}
