//! Variable travel limits, in machine coordinates.

use crate::fault::{Fault, Outcome};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Limit, Setup};

/// The limits of an axis in nanometres; none where none is set.
#[derive(Clone, Copy, Debug)]
pub struct TravelLimit {
    /// Positive limit.
    pub positive: Option<i64>,
    /// Negative limit.
    pub negative: Option<i64>,
}

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
        let of = |limit: Limit| TravelLimit {
            positive: limit.positive.map(|value| value.0),
            negative: limit.negative.map(|value| value.0),
        };
        Self { x: of(setup.limits.x), z: of(setup.limits.z), w: of(setup.limits.w) }
    }
}

impl TravelLimit {
    /// E100L-LIM-02: a target beyond the negative limit is not approached. E100L-LIM-01: one beyond the positive
    /// limit is replaced by the limit; the second value tells whether it was.
    pub fn clamp(&self, target: i64) -> Outcome<(i64, bool)> {
        if self.negative.is_some_and(|limit| target < limit) {
            return Err(Fault::new(AlarmName::TravelLimitNegative, LIM_02));
        }
        match self.positive {
            Some(limit) if target > limit => Ok((limit, true)),
            _ => Ok((target, false)),
        }
    }

    /// E100L-LIM-01 where a target cannot be replaced: both limits alarm.
    pub fn check(&self, target: i64) -> Outcome<()> {
        match self.clamp(target)? {
            (_, true) => Err(Fault::new(AlarmName::TravelLimitPositive, LIM_01)),
            (_, false) => Ok(()),
        }
    }
}
