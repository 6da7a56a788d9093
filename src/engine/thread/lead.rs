//! The lead of a thread, constant or changing, and its range (E100L-THRD-04, E100L-G33-09).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, FeedUnit};

use crate::engine::Interpreter;
use crate::engine::arithmetic::root::root_over;
use crate::engine::arithmetic::round::Rounding;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::unspecified;

/// Least and greatest lead, in picometres: 0.001 and 1000 mm.
const LEAST: i64 = 1_000_000;
const MOST: i64 = 1_000_000_000_000;

/// A lead where the thread begins and its change in a revolution, in picometres.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lead {
    pub start: i64,
    pub change: i64,
}

impl Lead {
    /// The square of the lead at a distance from the start, of which the double is given in nanometres: P² + 2 e d,
    /// where twice d is at most 2^65 and the change at most 10^14.
    fn square_at(self, twice: i128) -> i128 {
        let start = i128::from(self.start);
        start * start + 1000 * i128::from(self.change) * twice
    }

    /// Tests the lead at the end of a thread.
    pub fn check_end(self, twice: i128) -> Result<(), Fault> {
        let range = i128::from(LEAST) * i128::from(LEAST)..=i128::from(MOST) * i128::from(MOST);
        if self.change != 0 && !range.contains(&self.square_at(twice)) {
            return Fault::raise(AlarmName::ThreadLeadRange, rules::G33_09);
        }
        Ok(())
    }

    /// The lead at a distance within the thread, of which the double is given.
    pub fn at(self, twice: i128) -> i64 {
        if self.change == 0 {
            return self.start;
        }
        root_over(self.square_at(twice).max(0).unsigned_abs(), 1)
    }
}

impl Interpreter<'_> {
    /// What a thread needs besides its path: a spindle that turns freely, and a lead.
    pub(super) fn lead(&self) -> Result<i64, Fault> {
        if self.state.c_joined {
            return Err(unspecified(rules::THRD_10, "c_axis"));
        }
        let kept = &self.state.thread;
        if kept.phase_matching {
            return Err(Fault { name: AlarmName::NotModelled, ..unspecified(rules::THRD_10, "M194") });
        }
        let Some(feed) = self.state.feed.filter(|feed| feed.given == FeedUnit::PerRevolution) else {
            return Fault::raise(AlarmName::NoFeed, rules::THRD_04);
        };
        let [_, per_revolution] = feed.values;
        let divisor = if planted::is(Bug::DivisorIgnored) { 1 } else { kept.divisor.max(1) };
        let rounding = if planted::is(Bug::LeadCut) { Rounding::Cut } else { Rounding::HalfAway };
        let lead = rounding.divide_narrow(per_revolution, divisor);
        if !(LEAST..=MOST).contains(&lead) {
            return Fault::raise(AlarmName::ThreadLeadRange, rules::THRD_04);
        }
        Ok(lead)
    }
}

#[cfg(test)]
mod tests {
    use super::Lead;

    #[test]
    fn the_lead_changes_along_the_thread() {
        let lead = Lead { start: 2_500_000_000, change: 1_000_000_000 };
        // sqrt(2.5^2 + 2 * 39.5) = sqrt(85.25).
        assert_eq!(lead.at(79_000_000), 9_233_092_656);
        assert_eq!(lead.at(0), 2_500_000_000);
        let constant = Lead { change: 0, ..lead };
        assert_eq!(constant.at(79_000_000), 2_500_000_000);
        assert!(constant.check_end(i128::MAX >> 64).is_ok());
    }

    #[test]
    fn the_lead_stays_within_its_range() {
        let lead = Lead { start: 2_000_000_000, change: -100_000_000 };
        assert!(lead.check_end(38_000_000).is_ok());
        assert!(lead.check_end(40_000_000).is_err());
    }
}
