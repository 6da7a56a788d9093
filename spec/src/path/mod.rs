//! Motion: from the words of a block to the elements of the path.

mod angle;
mod arc;
mod chamfer;
mod element;
mod plane;
mod straight;
mod target;
mod torque_skip;

pub use angle::{Inclination, x_at, z_at};
use chamfer::chamfer;
pub use element::{
    Axes, Element, LINEAR, Shape, Tested, Way, carry_out, check_range, coordinate_readings, coordinate_rules,
    event, feed_path, standing, with_speed,
};
pub use plane::{Point, Vector};
use straight::straight;
pub use target::{Ahead, End, Origin, line_end, next_block, origin, target_of_next};
pub use torque_skip::torque_skip;

use crate::fault::Outcome;
use crate::modal::Plan;
use crate::state::State;

/// The motions of a block that has one, but for a torque skip. `ahead` are the blocks that look-ahead has read.
///
/// A corner that a chamfer block leaves behind (E100L-CHAM-13) is forgotten after the next motion of X or Z.
pub fn elements(plan: &Plan, ahead: &[Ahead], state: &mut State) -> Outcome<Vec<Element>> {
    if plan.is_chamfer() {
        return chamfer(plan, ahead, state);
    }
    let elements =
        if plan.motion() <= 1 { straight(plan, ahead, state)? } else { vec![arc::arc(plan, state)?] };
    if plan.words.has_any("XZA") {
        state.base = None;
    }
    Ok(elements)
}
