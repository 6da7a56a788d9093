//! Feed and dwell (E100L-G01-02, E100L-FEED-01 to -03, E100L-DWELL-01, E100L-DWELL-02).

use crate::controls::e100l::g_codes::GGroup;
use crate::controls::e100l::units;
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::quantity::{Exact, ratio, round_narrow, whole};
use crate::state::{Modes, State, StoredFeed};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{
    Action, AlarmName, Duration, Feed, FeedRate, FeedUnit, RuleId, RuleSet, Setup, UnitSystem,
};

/// Stores the number of an F word, and J, which belongs to it (E100L-THRD-06). Its range is that of the feed unit in
/// force (E100L-ADDR-01); a lead is one per revolution in G94 too (E100L-THRD-04).
pub fn store(number: &Exact, is_lead: bool, leads: Option<i64>, state: &mut State) -> Outcome<()> {
    let read = readings(number, is_lead, state)?;
    state.feed = Some(StoredFeed { leads: leads.unwrap_or(1), ..read });
    Ok(())
}

/// Both readings of a number that is a feed.
pub fn readings(number: &Exact, is_lead: bool, state: &State) -> Outcome<StoredFeed> {
    let system = state.setup.unit_system;
    let per_minute = number * units::feed_per_minute(system);
    let per_revolution = number * units::length(system);
    check_range(if state.modes.per_minute() && !is_lead { &per_minute } else { &per_revolution }, system)?;
    let picometres = |nanometres: &Exact| round_narrow(&(nanometres * whole(1_000)));
    Ok(StoredFeed {
        per_minute: picometres(&per_minute),
        per_revolution: picometres(&per_revolution),
        given_in: if is_lead { 95 } else { state.modes.get(GGroup::FeedUnit) },
        leads: 1,
    })
}

/// E100L-ADDR-01: the range of a feed in nanometres.
fn check_range(feed: &Exact, system: UnitSystem) -> Outcome<()> {
    if is_feed(feed, system) { Ok(()) } else { fail(AlarmName::AddressRange, ADDR_01) }
}

/// Whether a feed in nanometres is in the range of feeds.
pub fn is_feed(feed: &Exact, system: UnitSystem) -> bool {
    let lowest = whole(if system.is_inch() { 2_540 } else { 1_000 });
    let highest = whole(units::largest_length(system));
    *feed >= lowest && *feed <= highest
}

/// The feed of a cutting motion with the rules that it obeys.
pub fn active_feed(state: &State) -> Outcome<(Feed, RuleSet)> {
    if state.lap.is_reading() {
        // Nothing is cut; the feeds of the passes are tested.
        let feed = Feed { value: FeedRate(0), unit: FeedUnit::PerRevolution };
        return Ok((feed, RuleSet::EMPTY));
    }
    in_force(state.feed, state)
}

/// A stored feed as it is in force, with the rules that it obeys.
pub fn in_force(stored: Option<StoredFeed>, state: &State) -> Outcome<(Feed, RuleSet)> {
    let Some(stored) = stored else { return fail(AlarmName::NoFeed, G01_03) };
    let modes: &Modes = &state.modes;
    let (value, unit, rule): (i64, FeedUnit, RuleId) = if modes.per_minute() {
        (stored.per_minute, FeedUnit::PerMinute, FEED_02)
    } else {
        (stored.per_revolution, FeedUnit::PerRevolution, FEED_01)
    };
    let mut rules = RuleSet::of(&[rule]);
    if stored.given_in != modes.get(GGroup::FeedUnit) {
        check_range(&ratio(value, 1_000), state.setup.unit_system)?;
        rules = rules.with(FEED_03);
    }
    Ok((Feed { value: FeedRate(value), unit }, rules))
}

/// E100L-DWELL-01, E100L-DWELL-02: G04 waits for F seconds, 0.01 to 9999.99.
pub fn dwell(number: &Exact, state: &State) -> Outcome<Emission> {
    let time = dwell_time(number, state.setup)?;
    Ok(Emission::new(Action::Dwell { time }, RuleSet::of(&[DWELL_01, DWELL_02])))
}

/// E100L-DWELL-02: the time of a dwell.
pub fn dwell_time(number: &Exact, setup: &Setup) -> Outcome<Duration> {
    let seconds = number * units::seconds(setup.unit_system);
    if seconds < ratio(1, 100) || seconds > ratio(999_999, 100) {
        return fail(AlarmName::AddressRange, DWELL_02);
    }
    Ok(Duration(round_narrow(&(seconds * whole(1_000_000)))))
}
