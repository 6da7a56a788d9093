//! Variable travel limits, in machine coordinates.

use crate::fault::{Fault, Outcome};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Limit, Setup};

/// The limits of an axis in nanometres.
#[derive(Clone, Copy, Debug)]
pub struct TravelLimit {
    /// Positive limit.
    pub positive: i64,
    /// Negative limit.
    pub negative: i64,
    unset: (bool, bool),
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
            positive: limit.positive.map_or(Setup::COORDINATE, |value| value.0),
            negative: limit.negative.map_or(-Setup::COORDINATE, |value| value.0),
            unset: (limit.positive.is_none(), limit.negative.is_none()),
        };
        Self { x: of(setup.limits.x), z: of(setup.limits.z), w: of(setup.limits.w) }
    }
}

impl TravelLimit {
    /// Sets the positive limit.
    pub fn set_positive(&mut self, value: i64) {
        self.positive = value;
        self.unset.0 = false;
    }

    /// Sets the negative limit.
    pub fn set_negative(&mut self, value: i64) {
        self.negative = value;
        self.unset.1 = false;
    }

    /// E100L-LIM-02: a target beyond the negative limit is not approached.
    fn check_negative(&self, target: i64) -> Outcome<()> {
        if !self.unset.1 && target < self.negative {
            return Err(Fault::new(AlarmName::TravelLimitNegative, LIM_02));
        }
        Ok(())
    }

    /// E100L-LIM-01: a target beyond the positive limit is replaced by the limit; the second value tells
    /// whether it was.
    pub fn clamp(&self, target: i64) -> Outcome<(i64, bool)> {
        self.check_negative(target)?;
        let beyond = !self.unset.0 && target > self.positive;
        Ok((if beyond { self.positive } else { target }, beyond))
    }

    /// E100L-LIM-01 where a target cannot be replaced: both limits alarm.
    pub fn check(&self, target: i64) -> Outcome<()> {
        match self.clamp(target)? {
            (_, true) => Err(Fault::new(AlarmName::TravelLimitPositive, LIM_01)),
            (_, false) => Ok(()),
        }
    }
}
