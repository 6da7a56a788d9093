//! Theorems about square roots of whole numbers.
//!
//! The whole part of a root comes from the standard library and the first estimate of a root from `f64`; the
//! theorems hold for any whole part that is one, and from any estimate nearby. That the library finds the whole
//! part, and that the estimate is near, is tested, not proved.

use turnspec::engine::arithmetic::root::{narrow, reaches, round_half, round_whole, settle};

use crate::draw::{between, one_of, within, within_wide};
#[cfg(stand_in)]
use crate::kani;

/// Divisors of path lengths.
const DIVISORS: [u64; 3] = [1, 2, 18];

/// A number from 0 to a bound.
fn small(most: i64) -> u128 {
    u128::from(between(0, most).unsigned_abs())
}

/// A square and the whole part of its root, which is at most 15.
fn square_and_floor() -> (u128, u128) {
    let floor = between(0, 15);
    let beyond = if kani::any() { 0 } else { between(0, 2 * floor) };
    let [floor, beyond] = [floor, beyond].map(|value| u128::from(value.unsigned_abs()));
    (floor * floor + beyond, floor)
}

/// 1 or -1.
fn side() -> i128 {
    if kani::any() { 1 } else { -1 }
}

fn square(value: i128) -> i128 {
    value * value
}

/// A rounded root, and a square and a divisor that it is the rounded root of.
fn rounded_root(most: i64) -> (u64, u128, u64) {
    let divisor = one_of(&DIVISORS);
    let root = u64::try_from(between(0, most)).unwrap_or(0);
    let edge = |twice: u64| i64::try_from(twice * divisor).unwrap_or(i64::MAX);
    let (low, high) = (edge((2 * root).saturating_sub(1)), edge(2 * root + 1));
    // (low / 2)^2 <= square < (high / 2)^2
    let square = between((low * low + 3) / 4, (high * high - 1) / 4);
    (root, u128::from(square.unsigned_abs()), divisor)
}

theorems! {
    /// Whether a root reaches a candidate is decided without overflow, and it always reaches zero.
    /// Of: `root::reaches`
    /// Assumes: a square below 2^120, a divisor of at most 64, their candidate times it of at most 2^61.
    /// Rules: E100L-G01-04, E100L-CFEED-03
    #[unwind(2)]
    fn no_candidate_overflows() {
        let square: u128 = kani::any();
        kani::assume(square < 1 << 120);
        let divisor = u64::try_from(between(1, 64)).unwrap_or(1);
        let candidate = u64::try_from(between(0, 1 << 60)).unwrap_or(0);
        kani::assume(u128::from(divisor) * u128::from(candidate) <= 1 << 61);
        kani::cover!(candidate == 1 << 60, "the largest candidate");
        assert!(!reaches(square, divisor, candidate) || square > 0 || candidate == 0);
        assert!(reaches(square, divisor, 0));
    }

    /// A root that reaches a candidate reaches every smaller one.
    /// Of: `root::reaches`
    /// Assumes: squares of at most 2^10, candidates of at most 15.
    /// Rules: E100L-G01-04
    #[unwind(4)]
    fn reaching_is_monotone() {
        let (square, divisor) = (small(1 << 10), one_of(&DIVISORS));
        let candidate = u64::try_from(between(0, 15)).unwrap_or(0);
        if reaches(square, divisor, candidate + 1) {
            kani::cover!(candidate > 0, "a root above one");
            assert!(reaches(square, divisor, candidate));
        }
    }

    /// From an estimate that is at most two off, settling finds the root rounded half up.
    /// Of: `root::settle`, `root::reaches`
    /// Assumes: results of at most 7, the divisors 1, 2 and 18.
    /// Rules: E100L-G01-04, E100L-CFEED-03
    #[unwind(5)]
    fn settling_finds_the_rounded_root() {
        let (root, square, divisor) = rounded_root(7);
        let estimate = u64::try_from(between(0, 9)).unwrap_or(0);
        let estimate = if estimate.abs_diff(root) <= 2 { estimate } else { root + 1 };
        kani::cover!(estimate > root && square > 0, "too large an estimate");
        kani::cover!(estimate < root, "too small an estimate");
        assert!(settle(square, divisor, estimate) == root);
    }

    /// A rounded root from an origin lies within half a unit of the root.
    /// Of: `root::round_whole`
    /// Assumes: whole parts of at most 15, origins of at most 2^30 in size.
    /// Rules: E100L-CIRC-08
    #[unwind(4)]
    fn a_whole_root_is_the_nearest() {
        let (origin, side, (size, floor)) = (within(1 << 30), side(), square_and_floor());
        let root = side * i128::from(round_whole(origin.into(), side, size, floor) - origin);
        let size = size.cast_signed();
        kani::cover!(root == 1 && size == 2, "rounded down");
        kani::cover!(root == 2 && size == 3, "rounded up");
        assert!(root >= 0 && 4 * size <= square(2 * root + 1));
        assert!(root == 0 || square(2 * root - 1) <= 4 * size);
    }

    /// Half of a root from an even origin lies within half a unit; at a tie it is the one further from zero.
    /// Of: `root::round_half`
    /// Assumes: whole parts of at most 15, even origins of at most 2^30 in size.
    /// Rules: E100L-CIRC-08
    #[unwind(4)]
    fn half_a_root_is_the_nearest() {
        let (origin, side, (size, floor)) = (2 * within(1 << 29), side(), square_and_floor());
        let result = round_half(origin.into(), side, size, floor);
        let size = size.cast_signed();
        // In halves, from the origin to the result: at most one from the root.
        let way = side * i128::from(2 * result - origin);
        kani::cover!(size == square(way - 1), "a tie away from the origin");
        kani::cover!(size == square(way + 1), "a tie toward the origin");
        assert!(way >= 0 && size <= square(way + 1) && (way == 0 || square(way - 1) <= size));
        // A tie has an odd root, exactly: the result lies further from zero than the exact value.
        let exact = i128::from(origin) + side * if size == square(way + 1) { way + 1 } else { way - 1 };
        let tie = size == square(way + 1) || way > 0 && size == square(way - 1);
        assert!(!tie || 2 * i128::from(result).abs() > exact.abs());
    }

    /// Half of a root is rounded alike on both sides of zero.
    /// Of: `root::round_half`
    /// Assumes: whole parts of at most 15, even origins of at most 2^30 in size.
    /// Rules: E100L-CIRC-08
    #[unwind(4)]
    fn half_a_root_is_odd() {
        let (origin, side, (size, floor)) = (i128::from(2 * within(1 << 29)), side(), square_and_floor());
        kani::cover!(floor > 0 && size == floor * floor, "a whole root");
        assert!(round_half(-origin, -side, size, floor) == -round_half(origin, side, size, floor));
    }

    /// A coordinate within 64 bits is kept; beyond them it becomes the extreme of its sign.
    /// Of: `root::narrow`
    /// Assumes: any value.
    /// Rules: E100L-ADDR-01
    #[unwind(2)]
    fn narrowing_saturates() {
        let value = within_wide(i128::MAX);
        kani::cover!(value > i128::from(i64::MAX), "beyond 64 bits");
        kani::cover!(value < i128::from(i64::MIN), "beyond them on the other side");
        let clamped = value.clamp(i64::MIN.into(), i64::MAX.into());
        assert!(i128::from(narrow(value)) == clamped);
    }
}

refutations! {
    /// False: a rounded root is at most the root.
    #[unwind(5)]
    fn roots_are_cut() {
        let (root, square, divisor) = rounded_root(7);
        let root = settle(square, divisor, root);
        assert!(u128::from(root * divisor) * u128::from(root * divisor) <= square);
    }
}

#[cfg(test)]
mod tests {
    use super::{between, rounded_root, side, small, within};
    use crate::kani::holds;
    use turnspec::engine::arithmetic::root::{half_root, root_over, round_half, round_whole, whole_root};

    #[test]
    fn roots_start_from_their_whole_part() {
        holds(|| {
            let floor = small((1 << 62) - 1);
            let square = floor * floor + small(i64::MAX).min(2 * floor);
            let (origin, side) = (i128::from(2 * within(1 << 60)), side());
            let whole = round_whole(origin, side, square, floor);
            assert_eq!(whole_root(origin, side, square.cast_signed()), whole);
            let half = round_half(origin, side, square, floor);
            assert_eq!(half_root(origin, side, square.cast_signed()), half);
        });
    }

    #[test]
    fn the_estimate_is_near_enough() {
        // Squares up to (36 * 2^24)^2 / 4, at their edges and between them.
        holds(|| {
            let (root, square, divisor) = rounded_root(1 << 24);
            assert_eq!(root_over(square, divisor), i64::try_from(root).unwrap());
        });
    }

    #[test]
    fn the_estimate_is_near_enough_for_the_longest_path() {
        // Squares of whole numbers up to 2^59, and their neighbours.
        holds(|| {
            let root = between(2, 1 << 59);
            let square = u128::from(root.unsigned_abs()).pow(2);
            for near in [square - 1, square, square + 1] {
                assert_eq!(root_over(near, 1), root);
            }
        });
    }
}
