//! The planes of contour generation: points, rational values of sine and cosine, lengths and feeds at the centre
//! (E100L-CGF-01, E100L-CGF-04, E100L-CGF-06, E100L-CGF-11, E100L-CGF-12, E100L-CGS-01, E100L-CSC-03).
//!
//! Points are in nanometres, each coordinate at most 2^42 in size: words reach 2^37, and the frame shifts them by a
//! few amounts of that size. Products of two coordinates stay below 2^86. On the side, in compensation of a cutter, the
//! first coordinate counts over whole turns; there only ways between points near to each other are multiplied.

use super::round::Rounding;

/// A point of a contour plane, or the way from one to another, in nanometres.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Spot {
    /// Along the first axis of the plane.
    pub p: i64,
    /// Along the second axis.
    pub q: i64,
}

impl Spot {
    /// Whether it is the centre of the face.
    #[inline]
    #[must_use]
    pub fn is_centre(self) -> bool {
        self == Self::default()
    }
}

/// From one point to another.
#[inline]
#[must_use]
pub fn way(from: Spot, to: Spot) -> Spot {
    Spot { p: to.p.saturating_sub(from.p), q: to.q.saturating_sub(from.q) }
}

/// Vector product: positive when the second point lies to the left of the ray from the centre through the first.
#[inline]
#[must_use]
pub fn cross(first: Spot, second: Spot) -> i128 {
    i128::from(first.p) * i128::from(second.q) - i128::from(first.q) * i128::from(second.p)
}

/// Scalar product: negative when the second point lies on the other side of the centre.
#[inline]
#[must_use]
pub fn dot(first: Spot, second: Spot) -> i128 {
    i128::from(first.p) * i128::from(second.p) + i128::from(first.q) * i128::from(second.q)
}

/// The square of a way or of the distance of a point from the centre.
#[inline]
#[must_use]
pub fn square(way: Spot) -> i128 {
    dot(way, way)
}

/// Twice the sine of micro-degrees, where it is rational: at some multiples of 30 degrees, and nowhere else.
#[inline]
#[must_use]
pub fn twice_sine(angle: i64) -> Option<i64> {
    const STEP: i64 = 30_000_000;
    if angle % STEP != 0 {
        return None;
    }
    match (angle / STEP).rem_euclid(12) {
        0 | 6 => Some(0),
        1 | 5 => Some(1),
        3 => Some(2),
        7 | 11 => Some(-1),
        9 => Some(-2),
        _ => None,
    }
}

/// Twice the cosine of micro-degrees, where it is rational. At most 2^60 in size.
#[inline]
#[must_use]
pub fn twice_cosine(angle: i64) -> Option<i64> {
    twice_sine(angle + 90_000_000)
}

/// A diameter times a rational fraction of at most 2 in size, by four: a coordinate, rounded half away from zero.
#[inline]
#[must_use]
pub fn quarter(diameter: i64, fraction: i64) -> i64 {
    Rounding::HalfAway.divide_narrow(diameter.saturating_mul(fraction), 4)
}

/// Half a whole number, rounded half away from zero. At most 2^64 in size.
#[inline]
#[must_use]
pub fn half(sum: i128) -> i128 {
    Rounding::HalfAway.divide(sum, 2)
}

/// The length on which the feed of a turn is measured: 500 mm in 360 degrees, 25/18 nm a micro-degree. At most a few
/// turns.
#[inline]
#[must_use]
pub fn turn_length(turn: i64) -> i64 {
    Rounding::HalfAway.divide_narrow(turn.saturating_abs().saturating_mul(25), 18)
}

/// So many percent of a feed, rounded half away from zero. A feed below 2^48, at most 1000 percent.
#[inline]
#[must_use]
pub fn percent_of(feed: i64, percent: u16) -> i64 {
    Rounding::HalfAway.divide_narrow(feed.saturating_mul(percent.into()), 100)
}

/// Whether a circle of a radius about a point passes the centre of the face at less than a distance; the square of
/// the distance of its centre is at most 2^120, radius and distance are not negative.
#[inline]
#[must_use]
pub fn passes_near(square: i128, radius: i64, distance: i64) -> bool {
    let (outer, inner) =
        (i128::from(radius) + i128::from(distance), i128::from(radius) - i128::from(distance));
    square < outer * outer && (inner < 0 || square > inner * inner)
}

#[cfg(test)]
mod tests {
    use super::{half, passes_near, percent_of, quarter, turn_length, twice_cosine, twice_sine};

    #[test]
    fn rational_sines_and_cosines() {
        let degrees = |degrees: i64| degrees * 1_000_000;
        let sines = [0, 30, 60, 90, 150, 180, 210, 270, 330].map(|angle| twice_sine(degrees(angle)));
        let expected = [Some(0), Some(1), None, Some(2), Some(1), Some(0), Some(-1), Some(-2), Some(-1)];
        assert_eq!(sines, expected);
        let cosines = [0, 30, 60, 90, 120, 180, 240, 300].map(|angle| twice_cosine(degrees(angle)));
        let expected = [Some(2), None, Some(1), Some(0), Some(-1), Some(-2), Some(-1), Some(1)];
        assert_eq!(cosines, expected);
        assert_eq!(twice_sine(1), None);
    }

    #[test]
    fn roundings_are_half_away_from_zero() {
        assert_eq!((quarter(5, 2), quarter(-5, 2), quarter(5, 1)), (3, -3, 1));
        assert_eq!((half(3), half(-3), half(4)), (2, -2, 2));
        // 100 degrees: 100 000 000 * 25 / 18.
        assert_eq!(turn_length(-100_000_000), 138_888_889);
        assert_eq!(percent_of(30, 25), 8);
    }

    #[test]
    fn a_circle_near_the_centre() {
        assert!(passes_near(0, 999, 1000));
        assert!(!passes_near(0, 1000, 1000));
        assert!(passes_near(1, 1000, 1000));
        assert!(!passes_near(4_000_000, 3000, 1000));
        assert!(passes_near(4_000_001, 3000, 1000));
        assert!(!passes_near(16_000_000, 3000, 1000));
    }
}
