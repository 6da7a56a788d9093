//! Cutter radius compensation in the planes of rotary tools, G17 and G119 (E100L-CRC-05 to -18): execution-contour.md,
//! section 9.
//!
//! Elements, corners and waiting are those of the nose, in the plane (p, q) instead of (z, x). [`programmed`] knows where P
//! is in that plane, [`refuse`] what is not accepted, [`motion`] finds P of a block, [`plane`] where the axes go for a
//! point, [`course`] how they get there, [`pending`] what the events tell; [`other`] carries out motions of other axes
//! alone, [`cancel`] leads out.

mod cancel;
mod course;
mod motion;
mod other;
mod pending;
mod plane;
mod programmed;
mod refuse;

use super::nose::Nose;
use super::on::{On, Waiting};
use super::stream::Stream;
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::modal::{CutterPlane, Plan};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleSet};
use motion::Motion;
use pending::Pending;
use programmed::Programmed;

/// Compensation in force in a plane of rotary tools.
pub struct Cutter {
    /// What waits, and what is held behind it.
    pub on: On<Pending>,
    /// P.
    pub programmed: Programmed,
}

/// The rules that every motion cites.
fn cited(plane: CutterPlane) -> RuleSet {
    let every = RuleSet::of(&[NRC_07, CRC_05, CRC_14]);
    match plane {
        CutterPlane::Face => every.with(CRC_06),
        CutterPlane::Side => every.with(CRC_07).with(CRC_18),
    }
}

/// Step 7 of a block in which G41 or G42 was or is in force; what goes on, and whether the block has a motion in the plane.
pub fn block(
    before: Option<Cutter>,
    plane: CutterPlane,
    plan: &Plan,
    dwell: Option<Emission>,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<(Option<Cutter>, bool)> {
    let (on, mut programmed) = match before {
        Some(Cutter { on, programmed }) => (Some(on), programmed),
        None => (None, Programmed::begin(plane, plan, state)),
    };
    refuse::refuse(&programmed, plan, state)?;
    if !plan.moves_in(plane) {
        stream.emissions.extend(dwell);
        if plan.moves {
            other::carry_out(plane, plan, stream, state)?;
        }
        return Ok((on.map(|on| Cutter { on, programmed }), false));
    }
    let on = match (on, Nose::of_cutter(state)) {
        (on, Some(nose)) => {
            let axes = programmed.standing(state);
            let motion = Motion::find(&mut programmed, nose, plan, stream.place, state)?;
            match on {
                None => begin(motion, nose, axes, stream),
                Some(on) => follow(on, motion, nose, stream, state)?,
            }
        }
        (Some(on), None) => {
            let destination = programmed.destination(plan, state)?;
            cancel::cancel(on, plane, &destination, plan, stream, state)?;
            return Ok((None, true));
        }
        (None, None) => return Ok((None, true)),
    };
    Ok((Some(Cutter { on, programmed }), true))
}

/// The start-up waits for the first element (E100L-NRC-15).
fn begin(motion: Motion, nose: Nose, axes: plane::Standing, stream: &mut Stream) -> On<Pending> {
    stream.flush();
    stream.holding = true;
    On::started(axes, Waiting::StartUp(motion.start_up(), nose, None))
}

/// The motion is the next element: what waits ends in the corner with it.
fn follow(
    on: On<Pending>,
    motion: Motion,
    nose: Nose,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<On<Pending>> {
    let (start, end) = motion.legs(nose);
    if start.is_too_small() || end.is_too_small() || motion.has_no_radius() {
        return fail(AlarmName::CompensationArcTooSmall, NRC_48);
    }
    let axes = on.meet(&start, stream, state)?;
    Ok(On::started(axes, Waiting::Element(motion.element(), end)))
}
