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
    let [nearest] = nearest_wholes(|precision| [number(precision)]);
    nearest
}

/// The whole numbers nearest to real ones that are computed together, a tie away from zero.
pub fn nearest_wholes<const COUNT: usize>(numbers: impl Fn(usize) -> [Interval; COUNT]) -> [IBig; COUNT] {
    let mut candidates = [const { (IBig::ZERO, IBig::ZERO) }; COUNT];
    for precision in PRECISIONS {
        let ends = |number: Interval| (quantity::round(&number.low()), quantity::round(&number.high()));
        candidates = numbers(precision).map(ends);
        if candidates.iter().all(|(low, high)| low == high) {
            break;
        }
    }
    candidates.map(|(low, high)| if high > IBig::ZERO { high } else { low })
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

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::cmp::Ordering;

    use super::{Interval, PRECISIONS, nearest_real, nearest_whole, sign};
    use crate::quantity::{Exact, ratio};

    /// A number known to one unit of the working precision, and the precisions at which it was asked for.
    struct Number {
        value: Exact,
        asked: RefCell<Vec<usize>>,
    }

    impl Number {
        fn new(value: Exact) -> Self {
            Self { value, asked: RefCell::default() }
        }

        fn at(&self, precision: usize) -> Interval {
            self.asked.borrow_mut().push(precision);
            Interval::of(&self.value, precision).widen(1)
        }
    }

    #[test]
    fn a_certain_rounding_needs_the_first_precision_only() {
        let third = Number::new(ratio(1, 3));
        assert_eq!(nearest_whole(|precision| third.at(precision)), 0.into());
        assert_eq!(nearest_real(10, |precision| third.at(precision)).to_bits(), (1.0_f64 / 3.0).to_bits());
        assert_eq!(*third.asked.borrow(), [96, 106]);
    }

    #[test]
    fn a_boundary_is_looked_at_with_every_precision() {
        // 5/2 is a tie of whole numbers, 1 + 2^-53 one of binary64 numbers.
        for (halves, rounded) in [(5, 3), (-5, -3), (1, 1), (-1, -1)] {
            let tie = Number::new(ratio(halves, 2));
            assert_eq!(nearest_whole(|precision| tie.at(precision)), rounded.into());
            assert_eq!(*tie.asked.borrow(), PRECISIONS);
        }
        let tie = Number::new(ratio((1_i64 << 53) + 1, 1 << 53));
        let result = nearest_real(0, |precision| tie.at(precision));
        assert!((1.0..=1.0_f64.next_up()).contains(&result));
        assert_eq!(*tie.asked.borrow(), PRECISIONS);
    }

    #[test]
    fn a_number_just_off_a_boundary_is_decided() {
        let off = Exact::from_parts(1.into(), dashu_int::UBig::ONE << 150);
        let above = Number::new(ratio(-1, 2) + &off);
        assert_eq!(nearest_whole(|precision| above.at(precision)), 0.into());
        assert_eq!(*above.asked.borrow(), [96, 192]);
        let small = Number::new(off);
        assert_eq!(sign(|precision| small.at(precision)), Ordering::Greater);
        assert_eq!(sign(|precision| small.at(precision).neg()), Ordering::Less);
        assert_eq!(sign(|precision| Number::new(ratio(0, 1)).at(precision)), Ordering::Equal);
    }
}
