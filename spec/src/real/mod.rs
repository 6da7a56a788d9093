//! Correctly rounded real numbers.
//!
//! A real number is given as a function from a working precision to an [`Interval`] that certainly
//! contains it. [`nearest_whole`] and [`nearest_real`] raise the precision until both ends of the
//! interval round to the same result, so the result is that of the exact number, on every machine.

mod interval;
mod trigonometry;

pub use interval::Interval;
pub use trigonometry::{atan_degrees, atan2_degrees, cos_degrees, pi, sin_degrees, tan_degrees};

use dashu_int::IBig;

use crate::quantity;

/// Working precisions in bits, in the order in which they are tried. A number that still straddles a
/// rounding boundary at the last one (within 2^-1000) is taken to lie on the boundary.
const PRECISIONS: [usize; 4] = [96, 192, 384, 1024];

/// The whole number nearest to a real one, a tie away from zero.
pub fn nearest_whole(number: impl Fn(usize) -> Interval) -> IBig {
    let mut candidates = (IBig::ZERO, IBig::ZERO);
    for precision in PRECISIONS {
        let interval = number(precision);
        candidates = (quantity::round(&interval.low()), quantity::round(&interval.high()));
        if candidates.0 == candidates.1 {
            return candidates.0;
        }
    }
    let (low, high) = candidates;
    if high > IBig::ZERO { high } else { low }
}

/// The binary64 number nearest to a real one, a tie to even. `extra` bits are added to the precision:
/// as many as the number may have zeros behind the point.
pub fn nearest_real(extra: usize, number: impl Fn(usize) -> Interval) -> f64 {
    let mut result = 0.0;
    for precision in PRECISIONS {
        let interval = number(precision + extra);
        let (low, high) = (quantity::nearest_real(&interval.low()), quantity::nearest_real(&interval.high()));
        result = low;
        if low == high {
            break;
        }
    }
    result
}

/// How an algebraic number, or one that is irrational unless it is zero, compares with zero.
///
/// An algebraic number of the sizes that occur here (sums of three square roots of integers below 2^400) is
/// zero or farther from zero than 2^-1000, so that an interval that still contains zero then is zero.
pub fn sign(number: impl Fn(usize) -> Interval) -> std::cmp::Ordering {
    let decided = PRECISIONS.iter().find_map(|precision| number(*precision).sign());
    decided.unwrap_or(0).cmp(&0)
}
