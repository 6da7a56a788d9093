//! Motion: from the words of a block to the elements of the path.

mod angle;
mod arc;
mod chamfer;
mod element;
mod plane;
mod straight;
mod target;
mod torque_skip;

pub use chamfer::chamfer;
pub use plane::Point;
pub use straight::straight;
pub use target::{Ahead, forget_base};
pub use torque_skip::torque_skip;

use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::state::State;

/// Carries out the motion of a block that has one. `ahead` are the blocks that look-ahead has read.
pub fn motion(plan: &Plan, ahead: &[Ahead], state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    match plan.motion() {
        _ if plan.is_chamfer() => chamfer(plan, ahead, state, emissions),
        0 | 1 => straight(plan, ahead, state, emissions),
        _ => arc::arc(plan, state, emissions),
    }
}
