//! Torque skip G22 (execution, chapter 5, Dwell, torque skip).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, Feed, FeedRate, Label, ReadingSet, RuleId, Sink};

use super::Interpreter;
use super::arithmetic::feed::{fifth, is_watched};
use super::arithmetic::frame::coordinate;
use super::arithmetic::limit::{Limited, limited};
use super::cite::{self, Cites};
use super::fault::Fault;
use super::motion::{Element, Kind};
use super::planted::{self, Bug};
use super::state::{W, Z};
use super::words::{Address, Words};

/// Fastest torque skip in picometres per minute: 2500 mm/min.
const FASTEST: i64 = 2_500_000_000_000;

/// The feed axis of a torque skip and the rules of its elements.
#[derive(Clone, Copy)]
struct Skip {
    axis: usize,
    cites: Cites,
}

impl Interpreter<'_> {
    /// A block with G22.
    pub(super) fn torque_skip(&mut self, words: &Words, sink: &mut impl Sink) -> Result<(), Fault> {
        let (axis, address) = if words.has(Address::W) { (W, Address::W) } else { (Z, Address::Z) };
        if axis == Z {
            self.state.base = None;
        }
        let word = words.get(address).unwrap_or_default();
        let before = words.get(Address::D).unwrap_or_default();
        let beyond = words.get(Address::L).unwrap_or_default();
        let present = self.state.program(axis);
        let target = coordinate(present, word, self.state.incremental);
        let start = self.state.machine[axis];
        let target_machine = target.saturating_add(self.state.frame(axis));
        let way = target_machine.saturating_sub(start);
        if way == 0 || before > way.abs() {
            return Err(undefined(rules::TRQ_04, "approach"));
        }
        self.check_coordinate(target)?;
        let feed = self.feed()?;
        let per_minute = self.state.per_minute;
        if per_minute && feed.value.0 > FASTEST {
            return Err(undefined(rules::TRQ_03, "feed"));
        }
        let delay = self.setup.parameters.torque_monitor_delay;
        if !per_minute && delay != 0 {
            return Err(undefined(rules::TRQ_07, "delay"));
        }
        let direction = way.signum();
        let approach = target_machine.saturating_sub(direction.saturating_mul(before));
        let last = target_machine.saturating_add(direction.saturating_mul(beyond));
        for point in [target_machine, approach, last] {
            self.check_limits(axis, point)?;
        }
        let cites = self.coordinate_cites(words).and(self.feed_cites()).and(cite::TRQ_03).and(cite::TRQ_04);
        let skip = Skip { axis, cites };
        // Distances from the start in the direction of the feed.
        let along = |point: i64| direction * point.saturating_sub(start);
        let stop = self.torque_stops().get(self.state.stops_used).map(|stop| stop.0);
        self.state.stops_used += usize::from(!planted::is(Bug::TorqueStopReused));
        let stop = stop.filter(|stop| along(*stop) > 0 && along(*stop) <= along(last));
        if let Some(stop) = stop.filter(|stop| along(*stop) <= along(approach))
            && is_watched(along(stop), feed.value.0, delay)
        {
            self.skip_to(skip, stop, feed, sink)?;
            return Fault::raise(AlarmName::TorqueReachedEarly, rules::TRQ_06);
        }
        self.skip_to(skip, approach, feed, sink)?;
        let slow = Feed { value: FeedRate(fifth(feed.value.0)), ..feed };
        match stop.filter(|stop| along(*stop) > along(approach)) {
            Some(stop) => self.skip_to(skip, stop, slow, sink),
            None => {
                self.skip_to(skip, last, slow, sink)?;
                Fault::raise(AlarmName::TorqueNotReached, rules::TRQ_05)
            }
        }
    }

    fn check_limits(&self, axis: usize, machine: i64) -> Result<(), Fault> {
        match limited(machine, self.state.negative_limits[axis], self.state.positive_limits[axis]) {
            Limited::Within => Ok(()),
            Limited::AbovePositive(_) => Fault::raise(AlarmName::TravelLimitPositive, rules::LIM_01),
            Limited::BelowNegative => Fault::raise(AlarmName::TravelLimitNegative, rules::LIM_02),
        }
    }

    /// One element of the skip to a machine coordinate.
    fn skip_to(&mut self, skip: Skip, machine: i64, feed: Feed, sink: &mut impl Sink) -> Result<(), Fault> {
        let program = Some(machine.saturating_sub(self.state.frame(skip.axis)));
        let (z, w) = if skip.axis == W { (None, program) } else { (program, None) };
        let element = Element {
            kind: Kind::LinearAt(feed),
            x: None,
            z,
            w,
            c: None,
            cites: skip.cites,
            readings: ReadingSet::default(),
            limited: true,
        };
        self.perform(element, sink)
    }
}

#[cold]
fn undefined(rule: RuleId, what: &str) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, Label::new(what))
}
