//! The types of the user task (E100L-TYPE-01).

use crate::fault::{Outcome, fail};
use crate::quantity::{self, Exact, whole};
use crate::vocabulary::{AlarmName, RuleId};

/// A value: an integer of 32 bits or a binary64 real. A logical value is the integer 1 or 0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Number {
    /// Integer.
    Integer(i32),
    /// Real.
    Real(f64),
}

impl Number {
    /// As a real; an integer converts exactly.
    pub fn real(self) -> f64 {
        match self {
            Self::Integer(integer) => f64::from(integer),
            Self::Real(real) => real,
        }
    }

    /// Its exact value.
    pub fn exact(self) -> Exact {
        match self {
            Self::Integer(integer) => whole(integer),
            Self::Real(real) => quantity::of_real(real),
        }
    }

    /// A logical value.
    pub fn logical(truth: bool) -> Self {
        Self::Integer(i32::from(truth))
    }

    /// As an integer, a fraction cut off (E100L-TYPE-12).
    pub fn cut(self, rule: RuleId) -> Outcome<i32> {
        match self {
            Self::Integer(integer) => Ok(integer),
            Self::Real(_) => integer(&quantity::cut(&self.exact()), rule),
        }
    }
}

/// A whole number as an integer of 32 bits, or `integer_overflow`.
pub fn integer(value: &dashu_int::IBig, rule: RuleId) -> Outcome<i32> {
    match i32::try_from(value.clone()) {
        Ok(integer) => Ok(integer),
        Err(_) => fail(AlarmName::IntegerOverflow, rule),
    }
}

/// A finite real, or `real_overflow`.
pub fn finite(value: f64, rule: RuleId) -> Outcome<Number> {
    if value.is_finite() { Ok(Number::Real(value)) } else { fail(AlarmName::RealOverflow, rule) }
}
