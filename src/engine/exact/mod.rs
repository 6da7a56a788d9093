//! Numbers that leave the rationals, decided for certain.
//!
//! A formula is written once, over any [`Real`]. It is first computed in `f64` with a running error
//! bound; when that bound leaves a rounding or a sign in doubt, with wide integers at 256, 512 and at last
//! 1024 binary digits after the point. What is still in doubt then is an exact tie: the numbers here are
//! algebraic of small degree over coordinates of at most 64 bits, or contain π linearly, so that
//! different ones differ long before the 300th decimal.

mod approx;
mod big;
mod fixed;

use std::cmp::Ordering;

pub use approx::Approx;
pub use big::Big;
pub use fixed::{Double, arc_tangent, arc_tangent_microdegrees, sine_cosine, tangent};

/// A real number that is known within an error bound.
pub trait Real: Sized {
    /// What a number of this kind needs to come into being: its precision.
    type Precision: Copy;

    /// A whole number.
    fn integer(value: i128, precision: Self::Precision) -> Self;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// The quotient; of unbounded error when the divisor may be zero.
    fn over(&self, other: &Self) -> Self;
    /// The square root; the argument is known not to be negative.
    fn root(&self) -> Self;
    /// The circle constant.
    fn pi(precision: Self::Precision) -> Self;
    /// Sine and cosine of an angle in micro-degrees.
    fn sine_cosine(microdegrees: i64, precision: Self::Precision) -> (Self, Self);
    /// The sign, if it is certain.
    fn certain_sign(&self) -> Option<Ordering>;
    /// The nearest whole number, if it is certain and within 64 bits.
    fn certain_round(&self) -> Option<i64>;
}

/// A formula over real numbers.
pub trait Formula {
    /// Its value.
    fn value<R: Real>(&self, precision: R::Precision) -> R;
}

/// How often a computation in `f64` left a result in doubt and exact integers had to decide.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SlowPaths {
    /// Roundings to the nearest nanometre, micro-degree or thousandth of a revolution.
    pub roundings: u64,
    /// Comparisons.
    pub signs: u64,
    /// Functions of expressions, rounded to binary64.
    pub functions: u64,
}

impl SlowPaths {
    /// The sums of two counts.
    pub fn and(self, other: Self) -> Self {
        Self {
            roundings: self.roundings + other.roundings,
            signs: self.signs + other.signs,
            functions: self.functions + other.functions,
        }
    }
}

/// Binary digits after the point, one attempt after the other.
const DIGITS: [usize; 3] = [256, 512, 1024];

/// The value of a formula, rounded once to a whole number, ties away from zero.
pub fn round(formula: &impl Formula, slow: &mut SlowPaths) -> i64 {
    if let Some(result) = formula.value::<Approx>(()).certain_round() {
        return result;
    }
    slow.roundings += 1;
    let mut last = 0;
    for digits in DIGITS {
        let value = formula.value::<Big>(digits);
        if let Some(result) = value.certain_round() {
            return result;
        }
        last = value.away_from_zero();
    }
    last
}

/// The sign of a formula.
pub fn sign(formula: &impl Formula, slow: &mut SlowPaths) -> Ordering {
    if let Some(result) = formula.value::<Approx>(()).certain_sign() {
        return result;
    }
    slow.signs += 1;
    DIGITS.iter().find_map(|digits| formula.value::<Big>(*digits).certain_sign()).unwrap_or(Ordering::Equal)
}

#[cfg(test)]
mod tests {
    use super::{Formula, Real, SlowPaths, round, sign};
    use std::cmp::Ordering;

    /// (a + b * sqrt(c)) / d
    struct Surd(i128, i128, i128, i128);

    impl Formula for Surd {
        fn value<R: Real>(&self, precision: R::Precision) -> R {
            let root = R::integer(self.2, precision).root();
            let sum = R::integer(self.0, precision).plus(&R::integer(self.1, precision).times(&root));
            sum.over(&R::integer(self.3, precision))
        }
    }

    #[test]
    fn ties_go_away_from_zero_and_near_ties_do_not() {
        let mut slow = SlowPaths::default();
        // (1 + 2 * sqrt(4)) / 2 = 2.5 exactly.
        assert_eq!(round(&Surd(1, 2, 4, 2), &mut slow), 3);
        assert_eq!(round(&Surd(-1, -2, 4, 2), &mut slow), -3);
        assert_eq!(slow.roundings, 2);
        // sqrt(n^2 + n) lies just below n + 1/2: (2n+1)^2 / 4 = n^2 + n + 1/4.
        let n = 100_000_000_000_i128;
        assert_eq!(round(&Surd(0, 1, n * n + n, 1), &mut slow), 100_000_000_000);
        assert_eq!(round(&Surd(0, 1, n * n + n + 1, 1), &mut slow), 100_000_000_001);
    }

    #[test]
    fn signs_are_exact() {
        let mut slow = SlowPaths::default();
        let n = 1_000_000_000_000_000_i128;
        assert_eq!(sign(&Surd(-n, 1, n * n, 1), &mut slow), Ordering::Equal);
        assert_eq!(sign(&Surd(-n, 1, n * n + 1, 1), &mut slow), Ordering::Greater);
        assert_eq!(sign(&Surd(-n, 1, n * n - 1, 1), &mut slow), Ordering::Less);
        assert_eq!(slow.signs, 3);
    }
}
