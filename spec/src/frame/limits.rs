//! Variable travel limits, in machine coordinates.

use crate::fault::{Outcome, fail};
use crate::integer::{Limited, TravelLimit};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Limit, Setup};

/// The limits of the axes that have them.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// X.
    pub x: TravelLimit,
    /// Z.
    pub z: TravelLimit,
    /// W.
    pub w: TravelLimit,
}

impl Limits {
    /// The limits of a set-up.
    pub fn new(setup: &Setup) -> Self {
        let limits = &setup.limits;
        Self { x: limit(limits.x), z: limit(limits.z), w: limit(limits.w) }
    }
}

/// A limit of a set-up.
pub fn limit(limit: Limit) -> TravelLimit {
    TravelLimit {
        positive: limit.positive.map(|value| value.0),
        negative: limit.negative.map(|value| value.0),
    }
}

impl TravelLimit {
    /// E100L-LIM-02: a target beyond the negative limit is not approached. E100L-LIM-01: one beyond the positive
    /// limit is replaced by the limit; the second value tells whether it was.
    pub fn clamp(&self, target: i64) -> Outcome<(i64, bool)> {
        match self.of(target) {
            Limited::Negative => fail(AlarmName::TravelLimitNegative, LIM_02),
            Limited::Positive(limit) => Ok((limit, true)),
            Limited::Allowed => Ok((target, false)),
        }
    }

    /// E100L-LIM-01 where a target cannot be replaced: both limits alarm.
    pub fn check(&self, target: i64) -> Outcome<()> {
        match self.clamp(target)? {
            (_, true) => fail(AlarmName::TravelLimitPositive, LIM_01),
            (_, false) => Ok(()),
        }
    }
}
