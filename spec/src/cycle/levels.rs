//! Where the holes of a block begin and end along the axis of their infeed (E100L-MCYC-05, E100L-MCYC-22).

use super::block::{CycleBlock, Role};
use super::kept::Mode;
use super::motion::Axis;
use crate::fault::{Fault, Outcome};
use crate::frame::Amounts;
use crate::state::State;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// Levels in program coordinates, in nanometres.
#[derive(Clone, Copy, Debug)]
pub struct Levels {
    /// The axis of the infeed.
    pub axis: Axis,
    /// The cycle start.
    pub start: Amounts,
    /// The direction of the cut.
    pub direction: i64,
    /// Where the cut begins.
    pub cut: i64,
    /// Where it ends.
    pub bottom: i64,
}

impl Levels {
    /// Those of a block of a hole cycle, whose words are kept; the direction of a first block stays.
    pub fn of(block: CycleBlock, mode: &mut Mode, state: &State) -> Outcome<Self> {
        let kept = mode.words;
        let (axis, bottom, approach) = match kept.i {
            Some(approach) => (Axis::X, kept.x, approach),
            None => (Axis::Z, kept.z, kept.k.unwrap_or(0)),
        };
        let start = state.frame.to_program(mode.start);
        let from = axis.of(start);
        if block.role == Role::First {
            // E100L-MCYC-22: the sign of R is the direction.
            mode.direction = kept.r.or(bottom.map(|bottom| bottom - from)).unwrap_or(0).signum();
        }
        let direction = mode.direction;
        let cut = from + direction * approach;
        let bottom = kept.r.map(|depth| cut + depth).or(bottom).unwrap_or(cut);
        let levels = Self { axis, start, direction, cut, bottom };
        if levels.depth() <= 0 {
            return Err(Fault::about(AlarmName::Unspecified, MCYC_05, "depth"));
        }
        Ok(levels)
    }

    /// From the cutting start to the bottom.
    pub fn depth(&self) -> i64 {
        self.direction * (self.bottom - self.cut)
    }

    /// The cycle start on the axis of the infeed.
    pub fn start_level(&self) -> i64 {
        self.axis.of(self.start)
    }
}
