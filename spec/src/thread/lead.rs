//! The lead of a thread, and how it changes (E100L-THRD-04, E100L-THRD-06, E100L-G33-09).

use std::cmp::Ordering;

use crate::fault::{Fault, Outcome, fail};
use crate::quantity::{Exact, narrow, ratio, round_narrow, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, FeedLength, LeadAxis, Setup};

/// The least and the greatest lead, in picometres: 0.001 and 1000 mm.
const RANGE: (i64, i64) = (1_000_000, 1_000_000_000_000);

/// The lead of a thread, in picometres per revolution.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lead {
    /// Where the thread starts.
    pub first: i64,
    /// By how much it changes in a revolution, with a sign.
    pub change: i64,
    /// Whether it is a part of F (E100L-THRD-06).
    pub divided: bool,
}

/// The lead of a block, before it changes; what a thread does not go with comes first (E100L-THRD-10).
pub fn of_block(state: &State) -> Outcome<Lead> {
    if state.c_joined() {
        return Err(Fault::about(AlarmName::Unspecified, THRD_10, "c_axis"));
    }
    if state.is_active(194) {
        return Err(Fault::about(AlarmName::NotModelled, THRD_10, "M194"));
    }
    // E100L-THRD-04: a feed per minute is no lead.
    let Some(feed) = state.feed.filter(|feed| feed.given_in == 95) else {
        return fail(AlarmName::NoFeed, THRD_04);
    };
    let first = round_narrow(&(whole(feed.per_revolution) / whole(feed.leads)));
    if first < RANGE.0 || first > RANGE.1 {
        return fail(AlarmName::ThreadLeadRange, THRD_04);
    }
    Ok(Lead { first, change: 0, divided: feed.leads != 1 })
}

impl Lead {
    /// The lead that changes so.
    pub fn changing(self, change: i64) -> Self {
        Self { change, ..self }
    }

    /// Square of the lead at a distance in nanometres from the start.
    fn square(self, distance: &Exact) -> Exact {
        let (first, change) = (whole(self.first), whole(self.change));
        // Picometres throughout.
        &first * &first + whole(2_000) * change * distance
    }

    /// E100L-G33-09: the lead at a distance in nanometres from the start.
    pub fn at(self, distance: &Exact) -> i64 {
        if self.change == 0 {
            return self.first;
        }
        let square = self.square(distance);
        narrow(&real::nearest_whole(|precision| Interval::of(&square, precision).sqrt()))
    }

    /// E100L-G33-09: a lead must not leave its range before the end of the thread.
    pub fn check_end(self, length: &Exact) -> Outcome<()> {
        let square = self.square(length);
        let bound = |lead| whole(lead) * whole(lead);
        if self.change != 0 && (square < bound(RANGE.0) || square > bound(RANGE.1)) {
            return fail(AlarmName::ThreadLeadRange, G33_09);
        }
        Ok(())
    }
}

/// E100L-G32-03: what a difference of coordinates counts for as a length: X is a diameter.
pub fn measure(on_x: bool, setup: &Setup) -> Exact {
    if on_x && setup.readings.feed_length == FeedLength::Radius { ratio(1, 2) } else { whole(1) }
}

/// The length of a way along an axis.
pub fn length(axis: LeadAxis, from: i64, to: i64, setup: &Setup) -> Exact {
    measure(axis == LeadAxis::X, setup) * whole((to - from).abs())
}

/// The sign of a number as a whole number.
pub fn sign(value: &Exact) -> i64 {
    match value.cmp(&Exact::ZERO) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}
