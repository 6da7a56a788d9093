//! The end of compensation, and what it leaves behind (E100L-NRC-66 to -72).

use super::Compensation;
use super::ending::{Pending, left_behind};
use super::on::On;
use super::start_up::imaginary_point;
use super::stream::Stream;
use crate::barrier;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::frame::{Amounts, TravelLimit};
use crate::integer::Limited;
use crate::modal::Plan;
use crate::path::{Element, Point, Shape, Tested, Way, carry_out};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleSet};

/// A block with G40 in compensation.
pub fn cancel(
    on: On<Pending>,
    plan: &Plan,
    elements: &[Element],
    dwell: Option<Emission>,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<Compensation> {
    if let Some(first) = elements.first() {
        check(first, state)?;
    }
    let in_plane = elements.iter().any(Element::in_plane);
    let imaginary = imaginary_point(plan);
    let rule = if in_plane { NRC_66 } else { NRC_71 };
    let axes = on.conclude(rule, imaginary.as_ref(), stream, state)?;
    stream.holding = false;
    stream.emissions.extend(dwell);
    let mut after = Compensation::LeftOver { axes };
    for (index, element) in elements.iter().enumerate() {
        let rules = if element.in_plane() { RuleSet::of(&[NRC_66]) } else { RuleSet::EMPTY };
        // The first one was tested against the barriers before.
        after = uncompensated(after, element, rules, index > 0, plan, stream, state)?;
    }
    Ok(after)
}

/// The tests of the motion of a G40 block that come before the end of the element in front.
fn check(element: &Element, state: &State) -> Outcome<()> {
    element.check_range(state.setup)?;
    if matches!(element.shape, Shape::Arc { .. }) {
        // The rounding of a chamfer block without a line before it: as E100L-NRC-19 at the start.
        return fail(AlarmName::CompensationNotLinear, NRC_72);
    }
    element.feed(state)?;
    if element.axes.w {
        let target = state.frame.to_machine(Amounts { w: element.target.w, ..Amounts::default() });
        state.limits.w.clamp(target.w)?;
    }
    // E100L-BARR-09: before the limits of X and Z are tested.
    barrier::check(element, state.frame.program(), cut_back(element, state), state)
}

/// Where the motion of a G40 block ends, cut back to the positive limits; what lies beyond a negative one stays.
fn cut_back(element: &Element, state: &State) -> Amounts {
    let wanted = state.frame.to_machine(element.programmed_end(state.frame.program()));
    let within = |limit: &TravelLimit, place: i64| match limit.of(place) {
        Limited::Positive(limit) => limit,
        _ => place,
    };
    let (x, z) = (within(&state.limits.x, wanted.x), within(&state.limits.z, wanted.z));
    state.frame.to_program(Amounts { x, z, ..wanted })
}

/// A motion without compensation; what is left over goes away with the first one of X or Z. `barriers`: they are
/// tested now.
pub fn uncompensated(
    before: Compensation,
    element: &Element,
    rules: RuleSet,
    barriers: bool,
    plan: &Plan,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<Compensation> {
    let present = (state.frame.machine.x, state.frame.machine.z);
    let mut go = |from: Point, limits| {
        carry_out(element, Way { from, limits, barriers }, plan, state).map(|event| event.rules(rules))
    };
    let (event, after) = match before {
        Compensation::LeftOver { axes } if element.in_plane() => {
            (go(axes, Tested::Plane)?, Compensation::Off)
        }
        Compensation::LeftOver { axes } => (left_behind(go(present, Tested::Commanded)?, axes), before),
        _ => (go(present, Tested::Commanded)?, before),
    };
    stream.emissions.push(event);
    Ok(after)
}

/// E100L-NRC-71: the rule of the motion that takes the displacement away; an arc cannot.
pub fn taken_away(axes: Point, element: &Element, state: &State) -> Outcome<RuleSet> {
    if !element.in_plane() {
        return Ok(RuleSet::EMPTY);
    }
    element.check_range(state.setup)?;
    let present = (state.frame.machine.x, state.frame.machine.z);
    if matches!(element.shape, Shape::Arc { .. }) && present != axes {
        return Err(Fault::about(AlarmName::Unspecified, NRC_71, "arc"));
    }
    Ok(RuleSet::of(&[NRC_71]))
}
