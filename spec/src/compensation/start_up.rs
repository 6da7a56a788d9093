//! Start-up: the motion that leads into compensation (E100L-NRC-14 to -24).

use super::corner::corner;
use super::ending::Pending;
use super::leg::Leg;
use super::nose::Nose;
use super::on::{On, Waiting};
use super::reach::Reach;
use super::stream::Stream;
use crate::fault::{Fault, Outcome, fail};
use crate::modal::Plan;
use crate::path::{Axes, Element, LINEAR, Point, Shape, Tested, Vector, Way, carry_out};
use crate::quantity::whole;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Place, ReadingSet, RuleId, RuleSet};

/// E100L-NRC-20: the motion of a start-up block that has none of its own.
pub fn without_words(plan: &Plan, state: &State) -> Element {
    let (shape, rules) =
        if plan.motion() == 0 { (Shape::Rapid, RuleSet::of(&[G00_01])) } else { (Shape::Line, LINEAR) };
    Element {
        target: state.frame.program(),
        axes: Axes::default(),
        shape,
        rules,
        readings: ReadingSet::default(),
    }
}

/// Begins compensation with a motion; the axes are somewhere else than P if a displacement was left over.
pub fn begin(
    element: &Element,
    nose: Nose,
    axes: Point,
    plan: &Plan,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<On<Pending>> {
    element.check_range(state.setup)?;
    if matches!(element.shape, Shape::Arc { .. }) {
        return fail(AlarmName::CompensationNotLinear, NRC_19);
    }
    let from = state.frame.machine;
    let way = Way { from: axes, limits: Tested::OutsidePlane, barriers: true };
    let event = carry_out(element, way, plan, state)?;
    let to = state.frame.machine;
    let event = event
        .rules(RuleSet::of(&[NRC_07, NRC_14]))
        .rule_if(element.shape == Shape::Line, NRC_42)
        .rule_if((from.x, from.z) == (to.x, to.z), NRC_20);
    let motion = Pending::new(event, to.w - from.w, stream.place, state);
    let before = imaginary_point(plan).map(|to_point| Leg::line(to_point.times(&whole(-1)), nose));
    stream.flush();
    stream.holding = true;
    Ok(On::started(axes, Waiting::StartUp(motion, nose, before)))
}

/// E100L-NRC-23, E100L-NRC-24, E100L-NRC-69, E100L-NRC-70: the way from P to the imaginary point, (K, I), if the
/// block that begins or ends compensation has one.
pub fn imaginary_point(plan: &Plan) -> Option<Vector> {
    let part = |letter| whole(plan.words.get(letter).unwrap_or(0));
    plan.words.has_any("IK").then(|| Vector { z: part('K'), x: part('I') })
}

/// The end of the start-up, before the element j: in contact with it (E100L-NRC-15, E100L-NRC-18), or in the corner of
/// the imaginary element and j (E100L-NRC-23).
pub fn end(imaginary: Option<&Leg>, j: &Leg, between: RuleSet) -> Outcome<(Reach, RuleSet)> {
    match imaginary {
        None => {
            let rules = RuleSet::of(&[NRC_15]);
            Ok((Reach::contact(j), if j.is_line() { rules } else { rules.with(NRC_18) }))
        }
        Some(i) => {
            let (reach, rules) = corner(i, j)?;
            Ok((reach, rules.with(NRC_23).union(between)))
        }
    }
}

/// E100L-NRC-15: no element follows the start-up.
pub fn nothing_to_touch(start_up: Place) -> Fault {
    Fault::about(AlarmName::Unspecified, NRC_15, "start_up").of_block(start_up)
}

/// E100L-NRC-21, E100L-NRC-22: no element follows the start-up in time.
pub fn unmet(start_up: Place, rule: RuleId) -> Fault {
    Fault::new(AlarmName::CompensationStartUp, rule).of_block(start_up)
}
