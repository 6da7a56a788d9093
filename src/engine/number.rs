//! Exact values of words and expressions, and their conversion to increments.

use std::cmp::Ordering;

use super::arithmetic::round::Rounding;
use super::arithmetic::scale::{self, TEN};
use super::exact::Double;

/// A value as written or computed, without rounding.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Number {
    /// A plain number: digits with their sign, and how many of them (at most eight) stand after the point.
    Decimal { digits: i64, scale: u8, point: bool },
    /// An integer result.
    Integer(i32),
    /// A real result, finite.
    Real(f64),
}

/// `numerator / (tens * 2^twos)`, exactly.
#[derive(Clone, Copy, Debug)]
struct Ratio {
    numerator: i128,
    tens: i128,
    twos: u32,
}

impl Number {
    /// Whether the value counts as real where the control tells reals from integers.
    pub fn is_real(self) -> bool {
        match self {
            Self::Decimal { point, .. } => point,
            Self::Integer(_) => false,
            Self::Real(_) => true,
        }
    }

    fn ratio(self) -> Ratio {
        match self {
            Self::Decimal { digits, scale, .. } => {
                Ratio { numerator: digits.into(), tens: TEN[usize::from(scale)].into(), twos: 0 }
            }
            Self::Integer(value) => Ratio { numerator: value.into(), tens: 1, twos: 0 },
            Self::Real(value) => {
                let Double { mantissa, exponent } = Double::new(value);
                // Beyond 2^20 a mantissa of 53 bits exceeds every range, whatever its size.
                let up = exponent.clamp(0, 20);
                let twos = u32::try_from(-exponent).unwrap_or(0);
                Ratio { numerator: i128::from(mantissa) << up, tens: 1, twos }
            }
        }
    }

    /// Compares `self * unit` with a bound. Units and bounds are below 2^60.
    #[inline]
    pub fn compare(self, unit: i64, bound: i64) -> Ordering {
        if let Self::Decimal { digits, scale, .. } = self {
            return scale::compare(digits, scale, unit, bound);
        }
        let Ratio { numerator, tens, twos } = self.ratio();
        let value = numerator.saturating_mul(unit.into());
        let bound = i128::from(bound) * tens;
        if bound.unsigned_abs().leading_zeros() > twos + 1 {
            return value.cmp(&(bound << twos));
        }
        // The scaled bound is beyond 127 bits, the value is not.
        if bound == 0 { value.cmp(&0) } else { 0.cmp(&bound) }
    }

    /// Whether `self * unit` lies within two bounds.
    #[inline]
    pub fn within(self, unit: i64, low: i64, high: i64) -> bool {
        self.compare(unit, low) != Ordering::Less && self.compare(unit, high) != Ordering::Greater
    }

    /// `self * unit / increment` as a whole number, rounded by a rule. The result must fit into 64 bits,
    /// which the range of the value has to see to.
    #[inline]
    fn converted(self, unit: i64, increment: i64, rule: Rounding) -> i64 {
        if let Self::Decimal { digits, scale, .. } = self
            && let Some(result) = scale::increments(digits, scale, unit, increment, rule)
        {
            return result;
        }
        let Ratio { numerator, tens, twos } = self.ratio();
        let value = numerator.saturating_mul(unit.into());
        let divisor = tens * i128::from(increment);
        if divisor.leading_zeros() <= twos + 1 {
            // Less than half a unit by far.
            return if rule == Rounding::Up { value.signum() as i64 } else { 0 };
        }
        if let (Ok(cut), Ok(narrow)) = (u64::try_from(value.unsigned_abs() >> twos), u64::try_from(divisor)) {
            // The bits cut off do not change the quotient, only the rest.
            let quotient = cut / narrow;
            let rest = value.unsigned_abs() - ((u128::from(quotient) * u128::from(narrow)) << twos);
            let away = rule.goes_away(2 * rest >= u128::from(narrow) << twos, rest != 0);
            let size = i64::try_from(quotient + u64::from(away)).unwrap_or(i64::MAX);
            return if value < 0 { -size } else { size };
        }
        i64::try_from(rule.divide(value, divisor << twos)).unwrap_or(i64::MAX)
    }

    /// `self * unit` rounded half away from zero to whole increments, in the unit's own scale.
    pub fn rounded(self, unit: i64, increment: i64) -> i64 {
        self.converted(unit, increment, Rounding::HalfAway).saturating_mul(increment)
    }

    /// `self * unit` cut toward zero to whole increments, in the unit's own scale.
    pub fn cut(self, unit: i64, increment: i64) -> i64 {
        self.converted(unit, increment, Rounding::Cut).saturating_mul(increment)
    }

    /// The whole number that a rule makes of `self * unit`.
    pub fn whole(self, unit: i64, rule: Rounding) -> i64 {
        self.converted(unit, 1, rule)
    }
}

/// The quotient of a whole number by a positive one of at most 53 bits as binary64, rounded once.
#[allow(clippy::cast_precision_loss)]
pub fn quotient(value: i64, divisor: i64) -> f64 {
    const EXACT: u64 = 1 << 53;
    if value.unsigned_abs() <= EXACT {
        return value as f64 / divisor as f64;
    }
    // 2^53 times the value leaves at least 64 bits of quotient; the lowest one keeps what is cut.
    let (scaled, divisor) = (u128::from(value.unsigned_abs()) << 53, u128::from(divisor.unsigned_abs()));
    let size = (scaled / divisor) | u128::from(scaled % divisor != 0);
    let result = size as f64 / EXACT as f64;
    if value < 0 { -result } else { result }
}

#[cfg(test)]
mod tests {
    use super::{Number, quotient};
    use crate::engine::arithmetic::round::Rounding;
    use std::cmp::Ordering;

    fn decimal(digits: i64, scale: u8) -> Number {
        Number::Decimal { digits, scale, point: scale > 0 }
    }

    #[test]
    fn decimals_round_half_away() {
        // 1.2345 mm is 1 234 500 nm: to micrometres a tie.
        assert_eq!(decimal(12_345, 4).rounded(1_000_000, 1000), 1_235_000);
        assert_eq!(decimal(-12_345, 4).rounded(1_000_000, 1000), -1_235_000);
        assert_eq!(decimal(12_344, 4).rounded(1_000_000, 1000), 1_234_000);
        assert_eq!(decimal(19_999, 4).cut(25_400_000, 1000), 50_797_000);
    }

    #[test]
    fn reals_are_taken_exactly() {
        // The binary64 nearest to 1.2345 lies below or above the tie; its exact value decides:
        // 1.2345 * 2^52 = 5559691....: compare through exact integers of f64 arithmetic.
        let below = 0.5_f64.next_down();
        assert_eq!(Number::Real(below).whole(1, Rounding::HalfAway), 0);
        assert_eq!(Number::Real(0.5).whole(1, Rounding::HalfAway), 1);
        assert_eq!(Number::Real(-0.5).whole(1, Rounding::HalfAway), -1);
        assert_eq!(Number::Real(5e-324).whole(1, Rounding::Up), 1);
        assert_eq!(Number::Real(-5e-324).compare(1_000_000, 0), Ordering::Less);
        assert_eq!(Number::Real(5e-324).compare(1_000_000, 1), Ordering::Less);
        assert_eq!(Number::Real(1e300).compare(1, 99_999_999), Ordering::Greater);
        assert_eq!(Number::Real(-1e300).compare(1, 99_999_999), Ordering::Less);
        assert_eq!(Number::Real(2.5).compare(2, 5), Ordering::Equal);
    }

    #[test]
    fn quotients_round_once() {
        assert_eq!(quotient(1, 3), 1.0 / 3.0);
        assert_eq!(quotient((1 << 53) + 1, 1), 9_007_199_254_740_992.0);
        assert_eq!(quotient((1 << 53) + 3, 1), 9_007_199_254_740_996.0);
        assert_eq!(quotient(-((1 << 54) + 2), 2), -9_007_199_254_740_992.0);
    }
}
