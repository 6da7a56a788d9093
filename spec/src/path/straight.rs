//! G00 and G01 (E100L-G00-01 to -04, E100L-G01-01 to -04), with the C axis (E100L-CAX-02, -05 to -07).

use super::element::{Axes, Element, LINEAR, Shape};
use super::target::{Ahead, line_end, origin, target_of_next};
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::integer::turn;
use crate::modal::Plan;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleSet};

/// Positions, or moves along a line.
pub fn straight(plan: &Plan, ahead: &[Ahead], state: &mut State) -> Outcome<Vec<Element>> {
    let (origin, mut rules, mut readings) = origin(plan, state);
    let end = line_end(plan, origin, state.angle_target.take(), ahead)?;
    rules = rules.union(end.rules);
    readings = readings.union(end.readings);
    let words = &plan.words;
    let angle = words.get('A').is_some();
    let counted = state.base.is_some_and(|base| base.whole);
    let w = words
        .get('W')
        .map(|value| if plan.modes.incremental() { state.frame.program().w + value } else { value });
    let axes = Axes {
        x: angle || counted || words.get('X').is_some(),
        z: angle || counted || words.get('Z').is_some(),
        w: w.is_some(),
        c: None,
    };
    let (shape, own) =
        if plan.motion() == 0 { (Shape::Rapid, RuleSet::of(&[G00_01])) } else { (Shape::Line, LINEAR) };
    let target = Amounts { x: end.point.0, z: end.point.1, c: 0, w: w.unwrap_or(0) };
    let mut element = Element { target, axes, shape, rules: rules.union(own), readings };
    if state.lap.definition.is_none() {
        // In a definition of LAP its coordinates are not those of the program yet (E100L-LAPC-06).
        element.check_range(state.setup)?;
    }
    if let Some((place, travel)) = c_target(plan, state)? {
        element.target.c = place;
        element.axes.c = Some(travel);
        element.rules = element.rules.with(CAX_05);
        if words.extended("QA").is_some() {
            element.rules = element.rules.with(CAX_06);
        }
    }
    state.angle_target = target_of_next(plan, origin.incremental, ahead);
    Ok(vec![element])
}

/// E100L-CAX-05, E100L-CAX-06: program C target in a full turn, and signed travel.
fn c_target(plan: &Plan, state: &State) -> Outcome<Option<(i64, i64)>> {
    let (word, turns) = (plan.words.get('C'), plan.words.extended("QA"));
    if word.is_none() && turns.is_none() {
        return Ok(None);
    }
    if !state.c_joined() {
        return fail(AlarmName::CAxisNotJoined, CAX_02);
    }
    if state.is_active(147) {
        return fail(AlarmName::CAxisClamped, CAX_07);
    }
    let present = state.frame.program().c;
    let target = match word {
        None => present,
        Some(value) if plan.modes.incremental() => present + value,
        Some(value) => value,
    };
    let travel = turn::travel(present, target, turns.unwrap_or(0), state.is_active(15));
    Ok(Some((turn::within(target), travel)))
}
