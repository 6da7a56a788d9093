//! What is tested first at step 7 of a block (E100L-CRC-14, E100L-CRC-18).

use super::programmed::Programmed;
use crate::fault::{Fault, Outcome, fail};
use crate::modal::{Change, CutterPlane, Plan};
use crate::state::State;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// Tests a block, in the order of execution-contour.md, section 9.
pub fn refuse(programmed: &Programmed, plan: &Plan, state: &State) -> Outcome<()> {
    if !plan.moves {
        return Ok(());
    }
    let (plane, present) = (programmed.plane, state.frame.program().x);
    let destination = programmed.destination(plan, state)?;
    if plane == CutterPlane::Side && destination.x != present {
        return fail(AlarmName::ContourXChanged, CRC_18);
    }
    if !plan.moves_in(plane) {
        return Ok(());
    }
    if !programmed.has_frame(state) {
        return Err(Fault::about(AlarmName::Unspecified, CRC_14, "frame"));
    }
    if state.watch.chuck || state.watch.tailstock {
        return Err(Fault::about(AlarmName::NotModelled, CRC_14, "barrier"));
    }
    if state.is_active(147) {
        return fail(AlarmName::CAxisClamped, CAX_07);
    }
    let stays = destination.point.is_some() && destination.point == programmed.point;
    if plan.compensation == Change::Stays && stays {
        return Err(Fault::about(AlarmName::Unspecified, CRC_14, "repetition"));
    }
    match plane {
        CutterPlane::Face if !plan.converts && (present < 0 || destination.x < 0) => {
            fail(AlarmName::ContourXNotPositive, CGF_08)
        }
        CutterPlane::Side if present <= 0 => fail(AlarmName::ContourXNotPositive, CGS_01),
        _ => Ok(()),
    }
}
