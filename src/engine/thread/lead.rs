//! The lead of a thread, constant or changing, and its range (E100L-THRD-04, E100L-G33-09).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, FeedUnit, Label};

use crate::engine::Interpreter;
use crate::engine::arithmetic::lead;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::unspecified;

/// A lead where the thread begins and its change in a revolution, in picometres.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lead {
    pub start: i64,
    pub change: i64,
}

impl Lead {
    /// Tests the lead at the end of a thread, of whose length the double is given.
    pub fn check_end(self, twice: i128) -> Result<(), Fault> {
        if lead::stays_in_range(self.start, self.change, twice) {
            return Ok(());
        }
        Fault::raise(AlarmName::ThreadLeadRange, rules::G33_09)
    }

    /// The lead at a distance within the thread, of which the double is given.
    pub fn at(self, twice: i128) -> i64 {
        lead::at(self.start, self.change, twice)
    }
}

impl Interpreter<'_> {
    /// A thread needs a spindle that turns freely.
    pub(in crate::engine) fn check_spindle(&self) -> Result<(), Fault> {
        if self.state.c_joined {
            return Err(unspecified(rules::THRD_10, "c_axis"));
        }
        if self.state.thread.phase_matching {
            let detail = const { Label::new("M194") };
            return Err(Fault::about(AlarmName::NotModelled, rules::THRD_10, detail));
        }
        Ok(())
    }

    /// What a thread needs besides its path: a spindle that turns freely, and a lead.
    pub(super) fn lead(&self) -> Result<i64, Fault> {
        self.check_spindle()?;
        let kept = &self.state.thread;
        let Some(feed) = self.state.feed.filter(|feed| feed.given == FeedUnit::PerRevolution) else {
            return Fault::raise(AlarmName::NoFeed, rules::THRD_04);
        };
        let [_, per_revolution] = feed.values;
        let divisor = if planted::is(Bug::DivisorIgnored) { 1 } else { kept.divisor.max(1) };
        let lead = lead::of_feed(per_revolution, divisor);
        lead.ok_or_else(|| Fault::new(AlarmName::ThreadLeadRange, rules::THRD_04))
    }
}
