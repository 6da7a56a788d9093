//! Real numbers as `f64` with a running bound of the absolute error.
//!
//! Every operation adds the rounding error of its own result, at most 2^-53 of its size; 2^-51 is
//! counted, which also covers the rounding of the bound itself.

use std::cmp::Ordering;

use super::Real;
use super::fixed::sine_cosine_of_microdegrees;

/// A number and the bound of its error.
#[derive(Clone, Copy, Debug)]
pub struct Approx {
    value: f64,
    error: f64,
}

/// Counted rounding error of one operation, relative to its result: 2^-51.
const UNIT: f64 = 4.440_892_098_500_626e-16;

impl Approx {
    fn rounded(value: f64, error: f64) -> Self {
        Self { value, error: error + value.abs() * UNIT }
    }
}

#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
impl Real for Approx {
    type Precision = ();

    fn integer(value: i128, (): ()) -> Self {
        if let Ok(narrow) = i64::try_from(value)
            && narrow.unsigned_abs() <= 1 << 53
        {
            return Self { value: narrow as f64, error: 0.0 };
        }
        let value = value as f64;
        Self { value, error: (value * UNIT).abs() }
    }

    fn plus(&self, other: &Self) -> Self {
        Self::rounded(self.value + other.value, self.error + other.error)
    }

    fn minus(&self, other: &Self) -> Self {
        Self::rounded(self.value - other.value, self.error + other.error)
    }

    fn times(&self, other: &Self) -> Self {
        let error =
            self.value.abs() * other.error + other.value.abs() * self.error + self.error * other.error;
        Self::rounded(self.value * other.value, error)
    }

    fn over(&self, other: &Self) -> Self {
        let least = other.value.abs() - other.error;
        if least <= 0.0 {
            return Self { value: 0.0, error: f64::INFINITY };
        }
        let value = self.value / other.value;
        Self::rounded(value, (self.error + value.abs() * other.error) / least)
    }

    fn root(&self) -> Self {
        let value = self.value.max(0.0).sqrt();
        let least = self.value - self.error;
        let error = if least > 0.0 { self.error / least.sqrt() } else { (2.0 * self.error).sqrt() };
        Self::rounded(value, error)
    }

    fn pi((): ()) -> Self {
        Self::rounded(std::f64::consts::PI, 0.0)
    }

    fn sine_cosine(microdegrees: i64, (): ()) -> (Self, Self) {
        let (sine, cosine) = sine_cosine_of_microdegrees(microdegrees);
        (Self::rounded(sine, 0.0), Self::rounded(cosine, 0.0))
    }

    fn certain_sign(&self) -> Option<Ordering> {
        if self.value.abs() > self.error {
            return self.value.partial_cmp(&0.0);
        }
        (self.value == 0.0 && self.error == 0.0).then_some(Ordering::Equal)
    }

    fn certain_round(&self) -> Option<i64> {
        let nearest = self.value.round();
        let distance = (self.value - nearest).abs();
        (nearest.abs() < 9.0e15 && distance + self.error < 0.5).then_some(nearest as i64)
    }
}
