//! Intervals with dyadic ends: arithmetic that always contains the exact result.

use dashu_int::ops::{DivEuclid, SquareRoot};
use dashu_int::{IBig, UBig};

use crate::quantity::Exact;

/// All real numbers from `low / 2^precision` to `high / 2^precision`.
#[derive(Clone, Debug)]
pub struct Interval {
    low: IBig,
    high: IBig,
    precision: usize,
}

impl Interval {
    /// The interval of the working precision around an exact number.
    pub fn of(value: &Exact, precision: usize) -> Self {
        let scaled = value * Exact::from(IBig::ONE << precision);
        Self { low: scaled.floor(), high: scaled.ceil(), precision }
    }

    /// The interval from `low / 2^precision` to the next number of the precision.
    pub(super) fn between(low: IBig, precision: usize) -> Self {
        Self { high: &low + 1, low, precision }
    }

    /// Lower end.
    pub fn low(&self) -> Exact {
        Exact::from_parts(self.low.clone(), UBig::ONE << self.precision)
    }

    /// Upper end.
    pub fn high(&self) -> Exact {
        Exact::from_parts(self.high.clone(), UBig::ONE << self.precision)
    }

    /// Its sign, if the interval does not contain zero.
    pub fn sign(&self) -> Option<i8> {
        if self.low > IBig::ZERO {
            Some(1)
        } else if self.high < IBig::ZERO {
            Some(-1)
        } else {
            None
        }
    }

    /// Sum.
    pub fn add(&self, other: &Self) -> Self {
        Self { low: &self.low + &other.low, high: &self.high + &other.high, precision: self.precision }
    }

    /// Difference.
    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    /// Negative.
    pub fn neg(&self) -> Self {
        Self { low: -self.high.clone(), high: -self.low.clone(), precision: self.precision }
    }

    /// Product.
    pub fn mul(&self, other: &Self) -> Self {
        let products = [
            &self.low * &other.low,
            &self.low * &other.high,
            &self.high * &other.low,
            &self.high * &other.high,
        ];
        let low = products.iter().min().cloned().unwrap_or_default();
        let high = products.iter().max().cloned().unwrap_or_default();
        Self { low: low >> self.precision, high: -(-high >> self.precision), precision: self.precision }
    }

    /// Quotient by an interval that may contain zero only through lack of precision; the result is then
    /// as wide as the precision allows, and a higher one decides.
    pub fn div(&self, other: &Self) -> Self {
        if other.sign().is_none() {
            let bound = IBig::ONE << (4 * self.precision);
            return Self { low: -bound.clone(), high: bound, precision: self.precision };
        }
        let one = IBig::ONE << (2 * self.precision);
        let (low, high) = (&one / &other.high, &one / &other.low);
        let inverse = Self { low: low - 1, high: high + 1, precision: self.precision };
        self.mul(&inverse)
    }

    /// Square root of the non-negative part.
    pub fn sqrt(&self) -> Self {
        let root = |end: &IBig| {
            let (sign, magnitude) = (end.clone() << self.precision).into_parts();
            if sign == dashu_int::Sign::Negative { IBig::ZERO } else { IBig::from(magnitude.sqrt()) }
        };
        Self { low: root(&self.low), high: root(&self.high) + 1, precision: self.precision }
    }

    /// Product with a whole number, exact.
    pub fn times(&self, factor: i64) -> Self {
        let (one, other) = (&self.low * factor, &self.high * factor);
        let (low, high) = if factor < 0 { (other, one) } else { (one, other) };
        Self { low, high, precision: self.precision }
    }

    /// Quotient by a positive whole number.
    pub fn over(&self, divisor: u64) -> Self {
        let divisor = IBig::from(divisor.max(1));
        let low = (&self.low).div_euclid(&divisor);
        let high = -(-self.high.clone()).div_euclid(&divisor);
        Self { low, high, precision: self.precision }
    }

    /// Half-open growth of both ends by `2^-precision * ulps`, for the remainder of a series.
    pub(super) fn widen(&self, ulps: u32) -> Self {
        Self { low: &self.low - ulps, high: &self.high + ulps, precision: self.precision }
    }

    /// Whether both ends are closer to zero than `2^-precision`.
    pub(super) fn vanishes(&self) -> bool {
        let one = IBig::ONE;
        -&one <= self.low && self.high <= one
    }
}

#[cfg(test)]
mod tests {
    use super::Interval;
    use crate::quantity::{Exact, ratio, whole};

    fn contains(interval: &Interval, value: &Exact) -> bool {
        interval.low() <= *value && *value <= interval.high()
    }

    #[test]
    fn operations_contain_the_exact_result() {
        for (a, b) in [(7, 3), (-7, 3), (7, -3), (-1, -9), (0, 5), (1, 1000)] {
            let (x, y) = (ratio(a, 11), ratio(b, 13));
            let (left, right) = (Interval::of(&x, 64), Interval::of(&y, 64));
            assert!(contains(&left.add(&right), &(&x + &y)));
            assert!(contains(&left.sub(&right), &(&x - &y)));
            assert!(contains(&left.mul(&right), &(&x * &y)));
            assert!(contains(&left.div(&right), &(&x / &y)), "{a} {b}");
        }
    }

    #[test]
    fn whole_factors_and_divisors_contain_the_exact_result() {
        for value in [ratio(7, 11), ratio(-7, 11)] {
            let interval = Interval::of(&value, 64);
            for factor in [3, -3, 0] {
                assert!(contains(&interval.times(factor), &(&value * whole(factor))));
            }
            assert!(contains(&interval.over(7), &(&value / whole(7))));
            assert!(interval.over(7).high() - interval.over(7).low() <= ratio(1, 1 << 62));
        }
    }

    #[test]
    fn a_root_squares_back() {
        for value in [0, 1, 2, 9, 1_000_003] {
            let root = Interval::of(&whole(value), 80).sqrt();
            assert!(contains(&root.mul(&root), &whole(value)));
            assert!(root.high() - root.low() < ratio(1, 1 << 60));
        }
    }

    /// What may be zero may be of any size below: the quotient says nothing, on both sides.
    #[test]
    fn a_quotient_by_what_may_be_zero_says_nothing() {
        let nothing = Interval::of(&whole(0), 64).widen(1);
        let quotient = Interval::of(&whole(1), 64).div(&nothing);
        assert!(quotient.low() < whole(-1_000_000) && quotient.high() > whole(1_000_000));
        assert_eq!(quotient.sign(), None);
    }

    #[test]
    fn what_touches_zero_has_no_sign() {
        let zero = Interval::of(&whole(0), 64);
        assert_eq!([zero.sign(), Interval::of(&ratio(1, 3), 64).sign()], [None, Some(1)]);
        assert_eq!(Interval::of(&ratio(-1, 3), 64).sign(), Some(-1));
    }

    /// With few bits every unit counts.
    #[test]
    fn quotients_of_coarse_intervals_contain_the_exact_result() {
        for (a, b) in (-20..=20).flat_map(|a| (-20..=20).map(move |b| (a, b))).filter(|(_, b)| *b != 0) {
            let (x, y) = (ratio(a, 3), ratio(b, 7));
            let quotient = Interval::of(&x, 6).div(&Interval::of(&y, 6));
            assert!(contains(&quotient, &(&x / &y)), "{a} {b}");
        }
    }
}
