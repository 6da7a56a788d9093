//! G00 and G01 (E100L-G00-01 to -04, E100L-G01-01 to -04), with the C axis (E100L-CAX-02, -05 to -07).

use super::element::{
    Axes, Beyond, LINEAR, check_range, coordinate_readings, coordinate_rules, go, line, with_speed,
};
use super::target::{Ahead, angle_end, line_end, origin};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::integer::turn;
use crate::modal::Plan;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, RuleSet};

/// Positions, or moves along a line.
pub fn straight(
    plan: &Plan,
    ahead: &[Ahead],
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
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
    let mut axes = Axes {
        x: angle || counted || words.get('X').is_some(),
        z: angle || counted || words.get('Z').is_some(),
        w: w.is_some(),
        c: None,
    };
    let mut target = Amounts { x: end.point.0, z: end.point.1, c: 0, w: w.unwrap_or(0) };
    check_range(target, axes, state.setup)?;
    let c = c_target(plan, state)?;
    if let Some((place, travel)) = c {
        target.c = place;
        axes.c = Some(travel);
        rules = rules.with(CAX_05);
        if words.extended("QA").is_some() {
            rules = rules.with(CAX_06);
        }
    }
    let event = if plan.motion() == 0 {
        let (motion, replaced) = go(target, axes, Beyond::Replaced, state)?;
        state.cut_last = false;
        let rules = RuleSet::of(&[G00_01]).union(coordinate_rules(plan)).union(rules);
        let event = Emission::new(Action::Rapid { motion }, rules).rule_if(replaced, LIM_01);
        with_speed(event.readings(coordinate_readings(plan, state.setup)), true, state)
    } else {
        line(target, axes, Beyond::Replaced, rules.union(LINEAR), plan, state)?
    };
    emissions.push(event.readings(readings));
    if plan.is_angle_only()
        && let Some(Ahead { plan: next, .. }) = ahead.first()
    {
        state.angle_target = Some(angle_end(next, origin.incremental));
    }
    Ok(())
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
