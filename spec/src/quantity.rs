//! Exact numbers and the three ways in which a rule rounds them.

use dashu_int::IBig;
use dashu_ratio::RBig;

/// An exact rational number.
pub type Exact = RBig;

/// `numerator / denominator`.
pub fn ratio(numerator: impl Into<IBig>, denominator: u64) -> Exact {
    RBig::from_parts(numerator.into(), denominator.into())
}

/// A whole number.
pub fn whole(value: impl Into<IBig>) -> Exact {
    RBig::from(value.into())
}

/// The exact value of a finite binary64 number, 0 for the others.
pub fn of_real(value: f64) -> Exact {
    RBig::try_from(value).unwrap_or(RBig::ZERO)
}

/// The nearest whole number, a tie away from zero.
pub fn round(value: &Exact) -> IBig {
    let half = ratio(1, 2);
    if *value < RBig::ZERO { (value - half).ceil() } else { (value + half).floor() }
}

/// The whole part, toward zero.
pub fn cut(value: &Exact) -> IBig {
    value.trunc()
}

/// The next whole number away from zero.
pub fn raise(value: &Exact) -> IBig {
    if *value < RBig::ZERO { value.floor() } else { value.ceil() }
}

/// As `i64`; what is beyond it becomes the largest value of its sign, which no range admits.
pub fn narrow(value: &IBig) -> i64 {
    i64::try_from(value.clone()).unwrap_or(if *value < IBig::ZERO { i64::MIN } else { i64::MAX })
}

/// The nearest whole number as `i64`.
pub fn round_narrow(value: &Exact) -> i64 {
    narrow(&round(value))
}

/// The binary64 number nearest to an exact one, a tie to even.
pub fn nearest_real(value: &Exact) -> f64 {
    value.to_f64().value()
}

#[cfg(test)]
mod tests {
    use super::{cut, narrow, nearest_real, of_real, raise, ratio, round, whole};

    #[test]
    fn rounding_is_symmetric() {
        for (numerator, rounded, cut_off, raised) in
            [(5, 3, 2, 3), (-5, -3, -2, -3), (4, 2, 2, 2), (1, 1, 0, 1), (-1, -1, 0, -1)]
        {
            let value = ratio(numerator, 2);
            assert_eq!(round(&value), rounded.into(), "{value}");
            assert_eq!(cut(&value), cut_off.into(), "{value}");
            assert_eq!(raise(&value), raised.into(), "{value}");
        }
    }

    #[test]
    fn what_is_beyond_64_bits_keeps_its_sign() {
        for (value, narrowed) in [(i128::MAX, i64::MAX), (i128::MIN, i64::MIN), (0, 0), (-7, -7)] {
            assert_eq!(narrow(&whole(value).trunc()), narrowed);
        }
    }

    #[test]
    fn binary64_is_exact_both_ways() {
        for value in [0.1, -2.5, 1e300, 5e-324, 0.0] {
            assert_eq!(nearest_real(&of_real(value)).to_bits(), value.to_bits());
        }
    }
}
