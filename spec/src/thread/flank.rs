//! On which flank a pass of a compound cycle cuts (E100L-TMOD-01 to -04).

use super::motion::Cited;
use crate::integer::thread::{is_left_by_turns, shift_side};
use crate::quantity::{narrow, ratio, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{LeadAxis, ThreadFlank};

/// The flanks that a cycle cuts on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Flanks {
    /// M32: the left one.
    Left,
    /// M34: the right one.
    Right,
    /// M33: by turns.
    ByTurns,
}

impl Flanks {
    /// Those of the M code in force.
    pub fn in_force(state: &State) -> Self {
        match state.active("thread_infeed") {
            Some(33) => Self::ByTurns,
            Some(34) => Self::Right,
            _ => Self::Left,
        }
    }

    /// E100L-TMOD-03, E100L-TMOD-04: to which side the pass of a depth of this number is shifted: -1 or 1.
    fn side(self, number: u32, reading: ThreadFlank) -> i64 {
        let left = match self {
            Self::Left => true,
            Self::Right => false,
            Self::ByTurns => is_left_by_turns(number),
        };
        shift_side(left, reading)
    }

    /// What the events of a pass name that is shifted.
    pub fn cited(self, state: &State) -> Cited {
        let side = if self == Self::ByTurns { TMOD_04 } else { TMOD_03 };
        Cited::rules(&[TMOD_01, TMOD_02, side]).reading(state.setup.readings.thread_flank)
    }

    /// E100L-TMOD-02: how far a pass is shifted that lies this much above the last one; `tip` is B.
    pub fn shift(self, above: i64, tip: i64, number: u32, axis: LeadAxis, state: &State) -> i64 {
        // Along Z, above a diameter; or of a diameter, above a length along Z.
        let scale = match axis {
            LeadAxis::Z => ratio(1, 2),
            LeadAxis::X => whole(2),
        };
        let side = self.side(number, state.setup.readings.thread_flank);
        let (factor, half) = (scale * whole(above * side), ratio(tip, 2_000_000));
        narrow(&real::nearest_whole(|precision| {
            Interval::of(&factor, precision).mul(&real::tan_degrees(&half, precision))
        }))
    }
}
