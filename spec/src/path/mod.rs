//! Motion: from the words of a block to the elements of the path.

mod angle;
mod arc;
mod chamfer;
mod element;
mod plane;
mod straight;
mod target;
mod torque_skip;

use chamfer::chamfer;
pub use plane::Point;
use straight::straight;
pub use target::{Ahead, next_block};
use torque_skip::torque_skip;

use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::state::State;

/// Carries out the motion of a block that has one. `ahead` are the blocks that look-ahead has read.
///
/// A corner that a chamfer block leaves behind (E100L-CHAM-13) is forgotten after the next motion of X or Z.
pub fn motion(plan: &Plan, ahead: &[Ahead], state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    match (plan.one_shot, plan.motion()) {
        (Some(75 | 76), _) => return chamfer(plan, ahead, state, emissions),
        (Some(_), _) => torque_skip(plan, state, emissions)?,
        (None, 0 | 1) => straight(plan, ahead, state, emissions)?,
        (None, _) => arc::arc(plan, state, emissions)?,
    }
    if plan.words.has_any("XZA") {
        state.base = None;
    }
    Ok(())
}
