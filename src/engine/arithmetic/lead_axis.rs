//! Lengths along the axes of a thread (execution of threads, "Names"; E100L-G32-03). They are doubled, so that half a
//! diameter is whole.

use turnspec_oracle::vocabulary::FeedLength;

/// How many differences of a coordinate of 1 make a length of two: a radius is half a diameter.
#[must_use]
pub fn halves(is_x: bool, reading: FeedLength) -> i128 {
    if is_x && reading == FeedLength::Radius { 1 } else { 2 }
}

/// Twice the length between any two coordinates, in nanometres; below 2^65.
#[must_use]
pub fn twice_length(from: i64, to: i64, halves: i128) -> i128 {
    i128::from(from.abs_diff(to)) * halves
}
