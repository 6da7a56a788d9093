//! Square roots of whole numbers, rounded half away from zero (E100L-G01-04, E100L-CIRC-08).

/// `sqrt(square) / divisor`, rounded half away from zero. The square is below 2^120, the divisor at most
/// 64, the result below 2^60.
#[inline]
#[must_use]
pub fn root_over(square: u128, divisor: u64) -> i64 {
    settle(square, divisor, estimate(square, divisor)).cast_signed()
}

/// The rounded root, from an estimate that may be a little off.
#[inline]
#[must_use]
pub fn settle(square: u128, divisor: u64, estimate: u64) -> u64 {
    let mut candidate = estimate;
    while !reaches(square, divisor, candidate) {
        candidate -= 1;
    }
    while reaches(square, divisor, candidate + 1) {
        candidate += 1;
    }
    candidate
}

/// Whether `sqrt(square) / divisor` is at least `candidate - 1/2`; always for 0. The product of divisor and
/// candidate is below 2^62.
#[inline]
#[must_use]
pub fn reaches(square: u128, divisor: u64, candidate: u64) -> bool {
    let edge = u128::from(divisor) * u128::from((2 * candidate).saturating_sub(1));
    candidate == 0 || edge * edge <= 4 * square
}

/// `sqrt(square) / divisor` in `f64`: within one of it where it is below 2^52, nearly so beyond.
#[inline]
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn estimate(square: u128, divisor: u64) -> u64 {
    let (high, low) = ((square >> 64) as u64, square as u64);
    let square = high as f64 * 18_446_744_073_709_551_616.0 + low as f64;
    (square.sqrt() / divisor as f64 + 0.5) as u64
}

/// `origin + side * sqrt(square)`, rounded half away from zero. The square is not negative and at most 2^126, the
/// side -1, 0 or 1, the origin at most 2^64 in size.
#[must_use]
pub fn whole_root(origin: i128, side: i128, square: i128) -> i64 {
    let square = square.unsigned_abs();
    round_whole(origin, side, square, square.isqrt())
}

/// `(origin + side * sqrt(square)) / 2`, rounded half away from zero, for an even origin. Ranges as of
/// [`whole_root`].
#[must_use]
pub fn half_root(origin: i128, side: i128, square: i128) -> i64 {
    let square = square.unsigned_abs();
    round_half(origin, side, square, square.isqrt())
}

/// [`whole_root`] from the whole part of the root; a root of a whole number is never at a half.
#[must_use]
pub fn round_whole(origin: i128, side: i128, square: u128, floor: u128) -> i64 {
    // root > floor + 1/2 exactly when square > floor^2 + floor.
    let nearest = floor + u128::from(square > floor * floor + floor);
    narrow(origin + side * nearest.cast_signed())
}

/// [`half_root`] from the whole part of the root.
#[must_use]
pub fn round_half(origin: i128, side: i128, square: u128, floor: u128) -> i64 {
    if floor * floor == square {
        let twice = origin + side * floor.cast_signed();
        return narrow((twice + twice.signum()) / 2);
    }
    narrow(origin / 2 + side * floor.div_ceil(2).cast_signed())
}

/// As 64 bits; what is beyond them becomes the largest value of its sign, which no range admits.
#[must_use]
pub fn narrow(value: i128) -> i64 {
    i64::try_from(value).unwrap_or(if value < 0 { i64::MIN } else { i64::MAX })
}

#[cfg(test)]
mod tests {
    use super::{half_root, root_over, whole_root};

    #[test]
    fn roots_over_a_divisor_round_half_up() {
        assert_eq!(root_over(0, 2), 0);
        // sqrt(25) / 2 = 2.5; sqrt(24) / 2 = 2.449...
        assert_eq!(root_over(25, 2), 3);
        assert_eq!(root_over(24, 2), 2);
        let n = 300_000_000_000_u128;
        assert_eq!(root_over(n * n + n, 1), 300_000_000_000);
        assert_eq!(root_over(n * n + n + 1, 1), 300_000_000_001);
    }

    #[test]
    fn roots_from_an_origin_round() {
        assert_eq!(whole_root(10, -1, 6), 8); // 10 - 2.449
        assert_eq!(whole_root(10, -1, 7), 7); // 10 - 2.646
        assert_eq!(half_root(0, 1, 25), 3); // 2.5, away from zero
        assert_eq!(half_root(0, -1, 25), -3);
        assert_eq!(half_root(10, -1, 25), 3); // 5 - 2.5 = 2.5
        assert_eq!(half_root(0, 1, 24), 2); // 2.449
        assert_eq!(half_root(0, 1, 26), 3); // 2.550
        assert_eq!(half_root(0, 1, 35), 3); // 2.958
        assert_eq!(half_root(0, 1, 37), 3); // 3.041
    }
}
