//! Contour generation with the C axis, on the face (G101, G102, G103) and on the side (G132, G133), and coordinate
//! conversion (G136, G137): execution-contour.md.
//!
//! [`check`] refuses blocks, [`kept`] is what goes on in the next block, [`convert`] begins and ends conversion mode. A block
//! of a contour moves in a [`plane`]: on the [`face`] along a [`line`] or a [`face_arc`], on the [`side`] along an arc alone;
//! [`arc`] finds centres, [`motion`] carries each motion out. [`position`] leads to a point of the face in conversion mode.

mod arc;
mod check;
mod convert;
mod face;
mod face_arc;
mod kept;
mod line;
mod motion;
mod plane;
mod position;
mod side;
mod way;

pub use check::{Asked, check_beginning, check_block, check_conversion, check_plane};
pub use convert::convert;
pub use face::{FaceStep, cited as face_cited, is_positive};
pub use face_arc::{FaceArc, travel as arc_travel};
pub use kept::Kept;
pub use line::steps as line_steps;
pub use motion::{Course, Step, carry_out as carry_out_step, face_point, of_turn};
pub use plane::PlanePoint;
pub use position::{
    Direction, axes as axes_of_point, cited as converted, element as positioning, go_to, place,
    target as point_of,
};
pub use side::{Cylinder, cited as side_cited, sense as side_sense, target as side_target};
pub use way::{End, Way, Whose};

use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::modal::Plan;
use crate::state::State;
use crate::vocabulary::{AlarmName, RuleId};

/// Whether a motion code generates contours.
pub fn is_mode(motion: u16) -> bool {
    is_on_face(motion) || is_on_side(motion)
}

fn is_on_face(motion: u16) -> bool {
    matches!(motion, 101..=103)
}

fn is_on_side(motion: u16) -> bool {
    matches!(motion, 132 | 133)
}

/// Whether the motions of a block are those of this chapter: contours, and positionings by X and Y in conversion mode.
pub fn has_own_motions(plan: &Plan) -> bool {
    plan.is_contour() || plan.moves && plan.one_shot.is_none() && plan.converts && plan.words.has_any("XY")
}

/// The motions of such a block.
pub fn carry_out(plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    // It counts from the present point: a corner of before (E100L-CHAM-13) is left behind.
    state.base = None;
    let motion = plan.motion();
    if is_on_face(motion) {
        return face::cut(plan, state, emissions);
    }
    emissions.push(if is_on_side(motion) { side::cut(plan, state)? } else { position::go(plan, state)? });
    Ok(())
}

/// The C axis must be joined and released; the rules that say so.
pub fn needs_c_axis(not_joined: RuleId, clamped: RuleId, state: &State) -> Outcome<()> {
    if !state.c_joined() {
        return fail(AlarmName::CAxisNotJoined, not_joined);
    }
    if state.is_active(147) {
        return fail(AlarmName::CAxisClamped, clamped);
    }
    Ok(())
}
