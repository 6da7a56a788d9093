//! What a feed is measured on, and the feeds of a torque skip (E100L-G01-04, E100L-CFEED-03, E100L-TRQ-04,
//! E100L-TRQ-07).

use turnspec_oracle::vocabulary::FeedLength;

use super::round::Rounding;

/// Longest way that is measured, in nanometres or micro-degrees: 2^54, 18 000 km. No travel comes near it; the
/// bound keeps the squares in range.
pub const LONGEST: u64 = 1 << 54;

/// A length as `sqrt(square) / divisor`. The square is below 2^120.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Measure {
    /// Square of the multiple.
    pub square: u128,
    /// 1 to 18.
    pub divisor: u64,
}

/// The way of an axis between two of its coordinates, whichever they are; at most [`LONGEST`].
#[inline]
#[must_use]
pub fn way(start: i64, end: i64) -> u64 {
    end.abs_diff(start).min(LONGEST)
}

/// The square of the way of an axis; at most 2^108.
#[inline]
#[must_use]
pub fn square(start: i64, end: i64) -> u128 {
    let way = u128::from(way(start, end));
    way * way
}

/// The length of a motion without the C axis, in nanometres, from the squares of its way on the diameter X and
/// of its way along Z and W. Squares of at most 2^110.
#[inline]
#[must_use]
pub fn path(x: u128, along: u128, reading: FeedLength) -> Measure {
    match reading {
        FeedLength::Radius => Measure { square: x + 4 * along, divisor: 2 },
        FeedLength::Diameter => Measure { square: x + along, divisor: 1 },
    }
}

/// The length of a motion with the C axis, in nanometres: 360 degrees count as 500 mm, which is 25/18 nm a
/// micro-degree. Squares of at most 2^110.
/// X is a diameter with the C axis too (E100L-DIA-02).
#[inline]
#[must_use]
pub fn path_with_turn(x: u128, along: u128, turn: i64) -> Measure {
    Measure { square: 324 * (x + along) + 625 * square(0, turn), divisor: 18 }
}

/// A fifth of a feed, rounded half away from zero.
#[must_use]
pub fn fifth(feed: i64) -> i64 {
    Rounding::HalfAway.divide_narrow(feed, 5)
}

/// Whether the torque is watched after a distance in nanometres at a feed in picometres per minute, with a
/// delay in units of 10 ms: 6000 of those are a minute, 1000 picometres a nanometre.
#[must_use]
pub fn is_watched(distance: i64, feed: i64, delay: u16) -> bool {
    i128::from(distance) * 6_000_000 >= i128::from(feed) * i128::from(delay)
}
