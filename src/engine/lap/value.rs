//! Heights and runs of points that are found: exact numbers, rational or with one square root (execution of LAP, 8).
//!
//! Unrounded values are in half nanometres, as directions of the plane are. Coordinates of contours are below 2^40,
//! so that a rational one has a numerator below 2^82 and a denominator below 2^41; only on the line from a far AP start
//! they grow, to 2^125 and 2^62, and where lines of mode V meet, to 2^125 and 2^83. The square below a root is below 2^84.

use std::cmp::Ordering;

use crate::engine::arithmetic::root::{half_root, narrow, whole_root};
use crate::engine::arithmetic::round::Rounding;
use crate::engine::arithmetic::surd;
use crate::engine::arithmetic::wide::product;
use crate::engine::exact::{Formula, Real, SlowPaths, sign};

/// An exact number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Value {
    /// A quotient by a positive number.
    Ratio { over: i128, under: i128 },
    /// whole + side * sqrt(square).
    Root { whole: i128, side: i8, square: i128 },
}

/// The difference of two numbers with roots.
struct Gap(Value, Value);

impl Formula for Gap {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        self.0.real::<R>(precision).minus(&self.1.real::<R>(precision))
    }
}

impl Value {
    /// A whole number.
    pub fn whole(value: i128) -> Self {
        Self::Ratio { over: value, under: 1 }
    }

    /// A quotient by any number but zero.
    pub fn ratio(over: i128, under: i128) -> Self {
        if under < 0 { Self::Ratio { over: -over, under: -under } } else { Self::Ratio { over, under } }
    }

    /// The sum with a whole number.
    pub fn plus(self, by: i128) -> Self {
        match self {
            Self::Ratio { over, under } => Self::Ratio { over: over + by * under, under },
            Self::Root { whole, side, square } => Self::Root { whole: whole + by, side, square },
        }
    }

    /// Compares it with a whole number.
    pub fn cmp_whole(self, with: i128) -> Ordering {
        match self {
            Self::Ratio { over, under } => over.cmp(&(with * under)),
            Self::Root { whole, side, square } => surd::sign(whole - with, side.into(), square),
        }
    }

    /// Compares two numbers.
    pub fn cmp(self, other: Self, slow: &mut SlowPaths) -> Ordering {
        match (self, other) {
            (Self::Ratio { over, under }, Self::Ratio { over: over_2, under: under_2 }) => {
                compare_products((over, under_2), (over_2, under))
            }
            (Self::Ratio { over, under }, Self::Root { whole, side, square }) if under < 1 << 62 => {
                surd::sign(over - whole * under, -i128::from(side) * under, square)
            }
            (Self::Root { .. }, Self::Ratio { under, .. }) if under < 1 << 62 => {
                other.cmp(self, slow).reverse()
            }
            (
                Self::Root { whole, side, square },
                Self::Root { whole: whole_2, side: side_2, square: square_2 },
            ) => {
                if (side, square) == (side_2, square_2) {
                    return whole.cmp(&whole_2);
                }
                sign(&Gap(self, other), slow)
            }
            _ => sign(&Gap(self, other), slow),
        }
    }

    /// The greater of two numbers.
    pub fn max(self, other: Self, slow: &mut SlowPaths) -> Self {
        if self.cmp(other, slow) == Ordering::Less { other } else { self }
    }

    /// The less of two numbers.
    pub fn min(self, other: Self, slow: &mut SlowPaths) -> Self {
        if self.cmp(other, slow) == Ordering::Greater { other } else { self }
    }

    /// About the number.
    #[allow(clippy::cast_precision_loss)]
    pub fn estimate(self) -> f64 {
        match self {
            Self::Ratio { over, under } => over as f64 / under as f64,
            Self::Root { whole, side, square } => whole as f64 + f64::from(side) * (square as f64).sqrt(),
        }
    }

    /// The number as a real one.
    pub fn real<R: Real>(self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        match self {
            Self::Ratio { over, under: 1 } => integer(over),
            Self::Ratio { over, under } => integer(over).over(&integer(under)),
            Self::Root { whole, side, square } => {
                integer(whole).plus(&integer(side.into()).times(&integer(square).root()))
            }
        }
    }

    /// The number times a sign, in nanometres, rounded once: half nanometres are diameters, two of them one nanometre
    /// of a length.
    pub fn latch(self, sign: i64, is_length: bool) -> i64 {
        let sign = i128::from(sign);
        match self {
            Self::Ratio { over, under } => {
                let under = if is_length { 2 * under } else { under };
                narrow(Rounding::HalfAway.divide(sign * over, under))
            }
            Self::Root { whole, side, square } => {
                let root = if is_length { half_root } else { whole_root };
                root(sign * whole, sign * i128::from(side), square)
            }
        }
    }
}

/// Compares two products, the second factors of which are positive.
fn compare_products((a, b): (i128, i128), (c, d): (i128, i128)) -> Ordering {
    if let (Some(first), Some(second)) = (a.checked_mul(b), c.checked_mul(d)) {
        return first.cmp(&second);
    }
    let signs = a.signum().cmp(&c.signum());
    let sizes = || {
        let size = |x: i128, y: i128| product(x.unsigned_abs(), y.unsigned_abs());
        size(a, b).cmp(&size(c, d))
    };
    signs.then_with(|| if a < 0 { sizes().reverse() } else { sizes() })
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::{Equal, Greater, Less};

    use super::Value;
    use crate::engine::exact::SlowPaths;

    #[test]
    fn values_compare_exactly() {
        let mut slow = SlowPaths::default();
        let root = |whole, side, square| Value::Root { whole, side, square };
        let third = Value::ratio(-1, -3);
        assert_eq!(third.cmp(Value::ratio(2, 6), &mut slow), Equal);
        assert_eq!(third.cmp_whole(0), Greater);
        assert_eq!(root(1, 1, 2).cmp(Value::ratio(12_071, 5000), &mut slow), Greater);
        assert_eq!(Value::ratio(12_071, 5000).cmp(root(1, 1, 2), &mut slow), Less);
        assert_eq!(root(0, 1, 8).cmp(root(0, 1, 2), &mut slow), Greater);
        assert_eq!(root(0, 1, 9).cmp(root(1, 1, 4), &mut slow), Equal);
        assert_eq!(root(3, -1, 9).cmp_whole(0), Equal);
        let far = Value::ratio(1 << 105, (1 << 60) - 1);
        assert_eq!(far.cmp(Value::ratio(1 << 105, 1 << 60), &mut slow), Greater);
        assert_eq!(far.cmp(Value::ratio(-(1 << 105), 1 << 60), &mut slow), Greater);
    }

    #[test]
    fn values_are_latched_half_away_from_zero() {
        assert_eq!(Value::ratio(5, 2).latch(1, false), 3);
        assert_eq!(Value::ratio(5, 2).latch(-1, false), -3);
        assert_eq!(Value::whole(5).latch(1, true), 3);
        assert_eq!(Value::Root { whole: 4, side: -1, square: 9 }.latch(1, true), 1);
        assert_eq!(Value::Root { whole: 4, side: -1, square: 2 }.latch(-1, false), -3);
    }
}
