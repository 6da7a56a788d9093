//! G22 (E100L-TRQ-03 to -07): feed toward a stop until the torque reaches its preset value.

use super::element::{Axes, Element, Shape, Tested, Way as Travel, carry_out, check_range};
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::frame::Amounts;
use crate::modal::{Plan, active_feed};
use crate::quantity::{Exact, ratio, round_narrow, whole};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, FeedRate, ReadingSet, RuleSet};

/// Largest feed: 2.5 m/min, in picometres.
const LARGEST_FEED: i64 = 2_500_000_000_000;

/// The way of a torque skip, in machine coordinates of its axis.
struct Way {
    on_w: bool,
    start: i64,
    goal: i64,
    /// From here on the feed is a fifth.
    approach: i64,
    /// Virtual approach point, beyond the goal.
    end: i64,
}

impl Way {
    fn distance(&self, to: i64) -> i64 {
        (self.goal - self.start).signum() * (to - self.start)
    }

    fn in_approach(&self, place: i64) -> bool {
        self.distance(place) <= self.distance(self.approach)
    }
}

/// Feeds an axis toward its target, slowly from the approach point on.
pub fn torque_skip(plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    let way = way(plan, state)?;
    let unwatched = unwatched_distance(plan, state)?;
    let limit = if way.on_w { state.limits.w } else { state.limits.z };
    if !way.on_w {
        // A corner of before (E100L-CHAM-13) is left behind.
        state.base = None;
    }
    for place in [way.goal, way.approach, way.end] {
        limit.check(place)?;
    }
    match reached(&way, &unwatched, state) {
        Some(stop) if way.in_approach(stop) => {
            feed_to(stop, false, &way, plan, state, emissions)?;
            fail(AlarmName::TorqueReachedEarly, TRQ_06)
        }
        Some(stop) => {
            feed_to(way.approach, false, &way, plan, state, emissions)?;
            feed_to(stop, true, &way, plan, state, emissions)
        }
        None => {
            feed_to(way.approach, false, &way, plan, state, emissions)?;
            feed_to(way.end, true, &way, plan, state, emissions)?;
            fail(AlarmName::TorqueNotReached, TRQ_05)
        }
    }
}

/// E100L-TRQ-03, E100L-TRQ-04: target, approach point D before it, virtual approach point L behind it.
fn way(plan: &Plan, state: &State) -> Outcome<Way> {
    let words = &plan.words;
    let on_w = words.get('W').is_some();
    let of = |amounts: Amounts| if on_w { amounts.w } else { amounts.z };
    let word = words.get('W').or(words.get('Z')).unwrap_or(0);
    let target = if plan.modes.incremental() { of(state.frame.program()) + word } else { word };
    let target = Amounts { z: target, w: target, ..Amounts::default() };
    let (start, goal) = (of(state.frame.machine), of(state.frame.to_machine(target)));
    let (before, beyond) = (words.get('D').unwrap_or(0), words.get('L').unwrap_or(0));
    let direction = (goal - start).signum();
    if direction == 0 || before > (goal - start).abs() {
        return Err(Fault::about(AlarmName::Unspecified, TRQ_04, "approach"));
    }
    check_range(target, axes(on_w), state.setup)?;
    Ok(Way { on_w, start, goal, approach: goal - direction * before, end: goal + direction * beyond })
}

/// E100L-TRQ-07: how far the axis goes before the torque is watched, in nanometres.
fn unwatched_distance(plan: &Plan, state: &State) -> Outcome<Exact> {
    let (feed, _) = active_feed(state)?;
    let delay = i64::from(state.setup.parameters.torque_monitor_delay);
    if !plan.modes.per_minute() {
        return if delay == 0 {
            Ok(whole(0))
        } else {
            Err(Fault::about(AlarmName::Unspecified, TRQ_07, "delay"))
        };
    }
    if feed.value.0 > LARGEST_FEED {
        return Err(Fault::about(AlarmName::Unspecified, TRQ_03, "feed"));
    }
    // Picometres a minute, 6000 units of 10 ms a minute, 1000 picometres a nanometre.
    Ok(ratio(feed.value.0, 6_000_000) * whole(delay))
}

/// Where the torque reaches its preset value: the next stop of the set-up, if it lies on the way and the torque
/// is watched there.
fn reached(way: &Way, unwatched: &Exact, state: &mut State) -> Option<i64> {
    let stop = state.torque_stops().get(state.stops_used)?.0;
    state.stops_used += 1;
    let distance = way.distance(stop);
    let on_the_way = distance > 0 && distance <= way.distance(way.end);
    let watched = !way.in_approach(stop) || whole(distance) >= *unwatched;
    (on_the_way && watched).then_some(stop)
}

fn axes(on_w: bool) -> Axes {
    Axes { z: !on_w, w: on_w, ..Axes::default() }
}

fn feed_to(
    place: i64,
    slow: bool,
    way: &Way,
    plan: &Plan,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    let mut machine = state.frame.machine;
    *(if way.on_w { &mut machine.w } else { &mut machine.z }) = place;
    let rules = RuleSet::of(&[TRQ_03, TRQ_04]);
    let target = state.frame.to_program(machine);
    let element =
        Element { target, axes: axes(way.on_w), shape: Shape::Line, rules, readings: ReadingSet::default() };
    let from = (state.frame.machine.x, state.frame.machine.z);
    let travel = Travel { from, limits: Tested::Nothing, barriers: true };
    let mut event = carry_out(&element, travel, plan, state)?;
    if let (true, Action::Linear { feed, .. }) = (slow, &mut event.action) {
        feed.value = FeedRate(round_narrow(&ratio(feed.value.0, 5)));
    }
    emissions.push(event);
    Ok(())
}
