//! G22 (E100L-TRQ-03 to -07): feed toward a stop until the torque reaches its preset value.

use super::element::{Axes, check_range, line};
use super::target;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::frame::Amounts;
use crate::modal::{Plan, active_feed};
use crate::quantity::{ratio, round_narrow, whole};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, FeedRate, RuleSet};

/// Largest feed: 2.5 m/min, in picometres.
const LARGEST_FEED: i64 = 2_500_000_000_000;

/// Feeds an axis toward its target, slowly from the approach point on.
pub fn torque_skip(plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    target::forget_base(state);
    let words = &plan.words;
    let on_w = words.get('W').is_some();
    let of = |amounts: Amounts| if on_w { amounts.w } else { amounts.z };
    let word = words.get('W').or(words.get('Z')).unwrap_or(0);
    let present = state.frame.program();
    let goal = if plan.modes.incremental() { of(present) + word } else { word };
    check_range(0, goal, 0)?;
    let start = of(state.frame.machine);
    let goal = of(state.frame.to_machine(Amounts { z: goal, w: goal, ..Amounts::default() }));
    let direction = (goal - start).signum();
    let (before, beyond) = (words.get('D').unwrap_or(0), words.get('L').unwrap_or(0));
    if direction == 0 || before > (goal - start).abs() {
        return Err(Fault::about(AlarmName::Unspecified, TRQ_04, "approach"));
    }
    let (feed, _) = active_feed(state)?;
    let per_minute = plan.modes.per_minute();
    if per_minute && feed.value.0 > LARGEST_FEED {
        return Err(Fault::about(AlarmName::Unspecified, TRQ_03, "feed"));
    }
    let delay = i64::from(state.setup.parameters.torque_monitor_delay);
    if !per_minute && delay != 0 {
        return Err(Fault::about(AlarmName::Unspecified, TRQ_07, "delay"));
    }
    let (approach, end) = (goal - direction * before, goal + direction * beyond);
    let limit = if on_w { state.limits.w } else { state.limits.z };
    limit.check(goal)?;
    limit.check(approach)?;
    limit.check(end)?;

    let stop = state.setup.inputs.torque_stops.get(state.stops_used).map(|stop| stop.0);
    state.stops_used += usize::from(stop.is_some());
    let distance = |to: i64| direction * (to - start);
    // pm/min · 10 ms / (6000 · 10 ms per minute) / 1000 pm per nm.
    let unwatched = ratio(feed.value.0, 6_000_000) * whole(delay);
    let seen = stop.filter(|stop| {
        let way = distance(*stop);
        way > 0 && way <= distance(end) && (way > distance(approach) || whole(way) >= unwatched)
    });
    let rules = RuleSet::of(&[TRQ_03, TRQ_04]);
    let mut feed_to = |place: i64, slow: bool, state: &mut State| -> Outcome<()> {
        let mut machine = state.frame.machine;
        *(if on_w { &mut machine.w } else { &mut machine.z }) = place;
        let axes = Axes { z: !on_w, w: on_w, ..Axes::default() };
        let mut event = line(state.frame.to_program(machine), axes, rules, plan, state)?;
        if let (true, Action::Linear { feed, .. }) = (slow, &mut event.action) {
            feed.value = FeedRate(round_narrow(&ratio(feed.value.0, 5)));
        }
        emissions.push(event);
        Ok(())
    };
    match seen {
        Some(stop) if distance(stop) <= distance(approach) => {
            feed_to(stop, false, state)?;
            fail(AlarmName::TorqueReachedEarly, TRQ_06)
        }
        Some(stop) => {
            feed_to(approach, false, state)?;
            feed_to(stop, true, state)
        }
        None => {
            feed_to(approach, false, state)?;
            feed_to(end, true, state)?;
            fail(AlarmName::TorqueNotReached, TRQ_05)
        }
    }
}
