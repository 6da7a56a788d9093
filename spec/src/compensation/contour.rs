//! What a motion does while compensation is in force (E100L-NRC-13, E100L-NRC-41, E100L-NRC-60).

use super::ending::Pending;
use super::leg::legs;
use super::nose::Nose;
use super::on::{On, Waiting};
use super::stream::Stream;
use crate::emission::{AtRest, Emission};
use crate::fault::{Outcome, fail};
use crate::modal::Plan;
use crate::path::{Element, Shape, Tested, Way, carry_out};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleSet};

/// Carries a motion out; its end in X and Z becomes known later.
pub fn motion(
    on: On<Pending>,
    element: &Element,
    nose: Nose,
    plan: &Plan,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<On<Pending>> {
    let from = state.frame.machine;
    let way = Way { from: (from.x, from.z), limits: Tested::OutsidePlane, barriers: true };
    let event = carry_out(element, way, plan, state)?;
    let event = event.rules(RuleSet::of(&[NRC_07])).rule_if(element.shape == Shape::Line, NRC_42);
    if !element.in_plane() {
        let at_rest = AtRest::Tip { to_centre: nose.to_centre, mirrored: state.frame.mirrored };
        stream.emissions.push(Emission { at_rest: Some(at_rest), ..event });
        return Ok(on);
    }
    let to = state.frame.machine;
    let (w_travel, place) = (to.w - from.w, stream.place);
    let Some((start, end)) = legs(element, state.frame.to_program(from), state.frame.program(), nose) else {
        let event = event.rules(RuleSet::of(&[NRC_46]));
        let repetition = Pending::new(event, w_travel, place, state);
        return on.repeat(repetition, stream, state);
    };
    if start.is_too_small() || end.is_too_small() {
        return fail(AlarmName::CompensationArcTooSmall, NRC_48);
    }
    let event = event.rules(match element.shape {
        Shape::Rapid => RuleSet::of(&[NRC_41]),
        Shape::Line => RuleSet::EMPTY,
        Shape::Arc { .. } => RuleSet::of(&[NRC_48, NRC_60]),
    });
    let motion = Pending::new(event, w_travel, place, state);
    let axes = on.meet(&start, stream, state)?;
    Ok(On::started(axes, Waiting::Element(motion, end)))
}
