//! Real numbers as wide integers: a whole number of units of 2^-digits, with an error bound in units.
//! The slow path; it allocates.

use std::cmp::Ordering;

use dashu_int::ops::{Abs, BitTest, SquareRoot};
use dashu_int::{IBig, UBig};

use super::Real;

/// A number, the bound of its error, and the digits of both.
#[derive(Clone, Debug)]
pub struct Big {
    value: IBig,
    error: IBig,
    digits: usize,
}

impl Big {
    fn new(value: IBig, error: IBig, digits: usize) -> Self {
        Self { value, error, digits }
    }

    /// A fraction of two whole numbers times a power of two.
    pub fn ratio(numerator: &IBig, denominator: &IBig, power: isize, digits: usize) -> Self {
        let shift = digits.saturating_add_signed(power);
        let value = if power >= 0 || digits >= power.unsigned_abs() {
            (numerator << shift) / denominator
        } else {
            (numerator >> (power.unsigned_abs() - digits)) / denominator
        };
        Self::new(value, IBig::from(2), digits)
    }

    /// The whole number on the far side of a tie: the nearest one to a value a little further from zero.
    pub fn away_from_zero(&self) -> i64 {
        let half = IBig::ONE << (self.digits - 1);
        let magnitude: IBig = (self.value.clone().abs() + &self.error + half) >> self.digits;
        let magnitude = i64::try_from(magnitude).unwrap_or(i64::MAX);
        if self.value < IBig::ZERO { -magnitude } else { magnitude }
    }

    /// The nearest binary64, if it is certain.
    pub fn certain_double(&self) -> Option<f64> {
        let low = to_double(&(&self.value - &self.error), self.digits);
        let high = to_double(&(&self.value + &self.error), self.digits);
        (low == high).then_some(low)
    }

    fn halve_twice(&self, times: usize) -> Self {
        Self::new(&self.value >> times, (&self.error >> times) + 1, self.digits)
    }

    /// Sine and cosine of an angle in radians of at most 4, by the power series at a reduced argument.
    pub fn sine_cosine_of(&self) -> (Self, Self) {
        const HALVINGS: usize = 8;
        let digits = self.digits + 32;
        let wide = Self::new(&self.value << 32, &self.error << 32, digits);
        let reduced = wide.halve_twice(HALVINGS);
        let square = reduced.times(&reduced);
        let (mut sine, mut cosine) = (reduced.clone(), Self::integer(1, digits));
        let mut term = reduced;
        let mut power = 1_u32;
        // The odd and the even terms of the series, alternating in sign by pairs.
        let mut even = Self::integer(1, digits);
        while term.value != IBig::ZERO || even.value != IBig::ZERO {
            even = even.times(&square).divided(-IBig::from(u64::from(power) * u64::from(power + 1)));
            term = term.times(&square).divided(-IBig::from(u64::from(power + 1) * u64::from(power + 2)));
            cosine = cosine.plus(&even);
            sine = sine.plus(&term);
            power += 2;
            if term.value.clone().abs() <= term.error && even.value.clone().abs() <= even.error {
                // What is left of the series is smaller than its first omitted term.
                sine.error += &term.error * 4;
                cosine.error += &even.error * 4;
                break;
            }
        }
        for _ in 0..HALVINGS {
            let product = sine.times(&cosine);
            let squared = sine.times(&sine);
            sine = product.plus(&product);
            cosine = Self::integer(1, digits).minus(&squared).minus(&squared);
        }
        (sine.narrowed(self.digits), cosine.narrowed(self.digits))
    }

    fn divided(&self, divisor: IBig) -> Self {
        let error = &self.error / divisor.clone().abs() + 2;
        Self::new(&self.value / divisor, error, self.digits)
    }

    fn narrowed(&self, digits: usize) -> Self {
        let shift = self.digits - digits;
        Self::new(&self.value >> shift, (&self.error >> shift) + 2, digits)
    }

    /// The angle in radians, in [0, π/2], whose tangent is `ordinate / abscissa`, both not negative, not
    /// both zero. Newton's iteration from an approximation.
    pub fn angle(ordinate: &Self, abscissa: &Self, approximation: f64) -> Self {
        let digits = ordinate.digits;
        let mut angle = Self::ratio(&IBig::from(double_units(approximation)), &IBig::ONE, -64, digits);
        for _ in 0..8 {
            angle.error = IBig::ZERO;
            let (sine, cosine) = angle.sine_cosine_of();
            let across = ordinate.times(&cosine).minus(&abscissa.times(&sine));
            let along = abscissa.times(&cosine).plus(&ordinate.times(&sine));
            // The tangent of the rest; the arc tangent differs from it by less than its cube.
            let rest = across.over(&along);
            let cube = rest.times(&rest).times(&rest);
            let converged = cube.value.clone().abs() <= IBig::from(1);
            angle = angle.plus(&rest);
            angle.error += cube.value.abs() + cube.error;
            if converged {
                break;
            }
        }
        angle
    }

    /// Half the circumference over the radius, from Machin's formula.
    fn machin(digits: usize) -> IBig {
        let wide = digits + 32;
        let part = |divisor: u32| {
            let square = IBig::from(divisor) * IBig::from(divisor);
            let mut power = (IBig::ONE << wide) / IBig::from(divisor);
            let mut sum = power.clone();
            let mut odd = 1_u32;
            while power != IBig::ZERO {
                power = -(power / &square);
                odd += 2;
                sum += &power / IBig::from(odd);
            }
            sum
        };
        (part(5) * 16 - part(239) * 4) >> 32_usize
    }
}

impl Real for Big {
    type Precision = usize;

    fn integer(value: i128, digits: usize) -> Self {
        Self::new(IBig::from(value) << digits, IBig::ZERO, digits)
    }

    fn plus(&self, other: &Self) -> Self {
        Self::new(&self.value + &other.value, &self.error + &other.error, self.digits)
    }

    fn minus(&self, other: &Self) -> Self {
        Self::new(&self.value - &other.value, &self.error + &other.error, self.digits)
    }

    fn times(&self, other: &Self) -> Self {
        let error = self.value.clone().abs() * &other.error
            + other.value.clone().abs() * &self.error
            + &self.error * &other.error;
        Self::new((&self.value * &other.value) >> self.digits, (error >> self.digits) + 2, self.digits)
    }

    fn over(&self, other: &Self) -> Self {
        let least = other.value.clone().abs() - &other.error;
        if least <= IBig::ZERO {
            return Self::new(IBig::ZERO, IBig::ONE << (self.digits * 2), self.digits);
        }
        let value = (&self.value << self.digits) / &other.value;
        let error = ((&self.error << self.digits) + value.clone().abs() * &other.error) / least + 2;
        Self::new(value, error, self.digits)
    }

    fn root(&self) -> Self {
        let root = |value: &IBig| IBig::from(magnitude(&(value << self.digits)).sqrt());
        let least = &self.value - &self.error;
        let error = if least > IBig::ZERO {
            (&self.error << self.digits) / (root(&least).max(IBig::ONE)) + 2
        } else {
            root(&(&self.error * 2)) + 2
        };
        Self::new(root(&self.value), error, self.digits)
    }

    fn pi(digits: usize) -> Self {
        Self::new(Self::machin(digits), IBig::from(2), digits)
    }

    fn sine_cosine(microdegrees: i64, digits: usize) -> (Self, Self) {
        let turned = Self::integer(i128::from(microdegrees.rem_euclid(360_000_000)) - 180_000_000, digits);
        let radians = turned.times(&Self::pi(digits)).over(&Self::integer(180_000_000, digits));
        let (sine, cosine) = radians.sine_cosine_of();
        let zero = Self::integer(0, digits);
        (zero.minus(&sine), zero.minus(&cosine))
    }

    fn certain_sign(&self) -> Option<Ordering> {
        if self.value.clone().abs() > self.error {
            return Some(self.value.cmp(&IBig::ZERO));
        }
        (self.value == IBig::ZERO && self.error == IBig::ZERO).then_some(Ordering::Equal)
    }

    fn certain_round(&self) -> Option<i64> {
        let half = IBig::ONE << (self.digits - 1);
        let low: IBig = (&self.value - &self.error + &half) >> self.digits;
        let high: IBig = (&self.value + &self.error + &half) >> self.digits;
        // At a tie the two sides differ, or the error is zero and the magnitude decides.
        if low != high || (self.error == IBig::ZERO && self.value < IBig::ZERO) {
            return None;
        }
        i64::try_from(low).ok()
    }
}

fn magnitude(value: &IBig) -> UBig {
    UBig::try_from(value.clone()).unwrap_or(UBig::ZERO)
}

/// A non-negative number of at most 4 in units of 2^-64.
#[allow(clippy::cast_possible_truncation)]
fn double_units(value: f64) -> i128 {
    (value * 18_446_744_073_709_551_616.0) as i128
}

/// The binary64 nearest to `value * 2^-digits`, ties to even, subnormal numbers included.
fn to_double(value: &IBig, digits: usize) -> f64 {
    let size = magnitude(&value.clone().abs());
    let length = i64::try_from(size.bit_len()).unwrap_or(i64::MAX);
    let digits = i64::try_from(digits).unwrap_or(i64::MAX);
    // Exponent of the last place of the result.
    let last = (length - digits - 53).max(-1074);
    let shift = last + digits;
    let mantissa = match usize::try_from(shift) {
        Ok(0) | Err(_) => &size << usize::try_from(-shift).unwrap_or(0),
        Ok(shift) => {
            let low = &size & ((UBig::ONE << shift) - UBig::ONE);
            let mut high = &size >> shift;
            let half = UBig::ONE << (shift - 1);
            if low > half || (low == half && high.bit(0)) {
                high += UBig::ONE;
            }
            high
        }
    };
    let mantissa = u64::try_from(mantissa).unwrap_or(u64::MAX);
    let exponent = i32::try_from(last).unwrap_or(i32::MAX);
    let result = scale(mantissa, exponent);
    if *value < IBig::ZERO { -result } else { result }
}

/// `mantissa * 2^exponent`, for results that are binary64 numbers.
#[allow(clippy::cast_precision_loss)]
fn scale(mantissa: u64, exponent: i32) -> f64 {
    let half = exponent / 2;
    mantissa as f64 * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}

#[cfg(test)]
mod tests {
    use super::{Big, IBig, Real, to_double};

    #[test]
    fn pi_has_its_digits() {
        // The first 36 decimals of π, as everyone knows them.
        let digits = 3_141_592_653_589_793_238_462_643_383_279_502_884_i128;
        let scaled = Big::pi(256).times(&Big::integer(10_i128.pow(36), 256));
        assert_eq!(scaled.value >> 256_usize, IBig::from(digits));
    }

    #[test]
    fn doubles_round_to_even() {
        let one = IBig::ONE << 60_usize;
        assert_eq!(to_double(&one, 60), 1.0);
        assert_eq!(to_double(&(&one + IBig::from(1 << 7)), 60), 1.0);
        assert_eq!(to_double(&(&one + IBig::from((1 << 7) + 1)), 60), 1.0 + f64::EPSILON);
        assert_eq!(to_double(&(&one + IBig::from(3 << 7)), 60), 1.0 + 2.0 * f64::EPSILON);
        assert_eq!(to_double(&IBig::from(1), 1074), f64::from_bits(1));
        assert_eq!(to_double(&IBig::from(1), 1075), 0.0);
        assert_eq!(to_double(&IBig::from(3), 1075), f64::from_bits(2));
    }

    #[test]
    fn thirty_degrees() {
        let (sine, cosine) = Big::sine_cosine(30_000_000, 256);
        let two = Big::integer(2, 256);
        let zero = sine.times(&two).minus(&Big::integer(1, 256));
        assert!(zero.value.clone() <= zero.error);
        let square = cosine.times(&cosine).times(&Big::integer(4, 256)).minus(&Big::integer(3, 256));
        assert!(square.value.clone() <= square.error && square.error < IBig::ONE << 64_usize);
    }
}
