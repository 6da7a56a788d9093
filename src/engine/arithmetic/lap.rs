//! Levels and lines of LAP (E100L-AP1-02, E100L-AP1-03, E100L-AP1-04, E100L-LAPC-03; execution of LAP, 8).
//!
//! Coordinates are nanometres below 2^60, words below 2^38; runs and heights half nanometres below 2^41, but for
//! the line from a far AP start. Within these ranges nothing saturates or overflows.

/// How many half nanometres a nanometre of an axis is: diameters count half.
#[inline]
#[must_use]
pub fn halves(is_diameter: bool) -> i128 {
    if is_diameter { 1 } else { 2 }
}

/// A coordinate of an axis in half nanometres, in the sense (-1, 0 or 1) in which runs or heights grow.
#[inline]
#[must_use]
pub fn scaled(coordinate: i64, sense: i64, is_diameter: bool) -> i128 {
    i128::from(sense) * i128::from(coordinate) * halves(is_diameter)
}

/// Whether the sense of an arc, seen with runs to the right and heights up, is that of its event: `along` that X is the
/// infeed axis, senses of -1 or 1.
#[inline]
#[must_use]
pub fn keeps_sense(infeed: i64, cutting: i64, along: bool) -> bool {
    (infeed * cutting > 0) == along
}

/// Whether a level has come to a change point or is beyond it; heights grow in the sense of -1 or 1.
#[inline]
#[must_use]
pub fn is_reached(level: i64, place: i64, sense: i64) -> bool {
    i128::from(sense) * (i128::from(level) - i128::from(place)) <= 0
}

/// The level below one by a depth; heights grow in the sense of -1 or 1.
#[inline]
#[must_use]
pub fn next_level(level: i64, sense: i64, depth: i64) -> i64 {
    level.saturating_sub(sense.saturating_mul(depth))
}

/// The coordinate of the cutting axis on the line between two points (coordinates of the infeed axis and of the cutting
/// axis), at a level: a quotient of two numbers. The points have different levels, and so the second is not zero.
#[inline]
#[must_use]
pub fn on_line(start: (i64, i64), end: (i64, i64), level: i64) -> (i128, i128) {
    let wide = |value: i64| i128::from(value);
    let rise = wide(start.0) - wide(end.0);
    let over = wide(end.1) * rise + (wide(start.1) - wide(end.1)) * (wide(level) - wide(end.0));
    (over, rise)
}

/// The second coordinate of the point of a line through two points that has a first coordinate: a quotient of two
/// numbers. The points have different first coordinates.
#[inline]
#[must_use]
pub fn across(from: (i128, i128), to: (i128, i128), at: i128) -> (i128, i128) {
    let length = to.0 - from.0;
    (from.1 * length + (at - from.0) * (to.1 - from.1), length)
}
