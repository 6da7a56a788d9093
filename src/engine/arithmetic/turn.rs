//! Angles of the C axis within a full turn, and the way between two of them (E100L-CAX-05, E100L-CAX-06,
//! E100L-CGF-10, E100L-G50-04).

/// A full turn in micro-degrees.
pub const TURN: i64 = 360_000_000;

/// An angle in `[0, 360)` degrees. All of `i64`.
#[inline]
#[must_use]
pub fn within(angle: i64) -> i64 {
    angle.rem_euclid(TURN)
}

/// A zero shift of C: whole turns are taken off toward zero. All of `i64`.
#[must_use]
pub fn shift(shift: i64) -> i64 {
    shift % TURN
}

/// The shorter way from one angle to another, both within a turn; half a turn is positive.
#[inline]
#[must_use]
pub fn shorter(present: i64, target: i64) -> i64 {
    let ahead = within(target - present);
    if ahead <= TURN / 2 { ahead } else { ahead - TURN }
}

/// The way from one angle to another, both within a turn, in the positive or in the negative direction, with so
/// many full turns more; at most 2^32 of them.
#[inline]
#[must_use]
pub fn travel(present: i64, target: i64, turns: i64, negative: bool) -> i64 {
    if negative { -within(present - target) - turns * TURN } else { within(target - present) + turns * TURN }
}
