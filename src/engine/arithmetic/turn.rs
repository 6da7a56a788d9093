//! Angles of the C axis within a full turn, and the way between two of them (E100L-CAX-05, E100L-CAX-06,
//! E100L-CGF-10, E100L-G50-04); the angles at which a thread starts.

use super::round::Rounding;

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

/// The angle of the start with a number, from 0, of a thread with so many starts, at most 9999: an even share of a turn,
/// rounded (E100L-TMUL-01).
#[must_use]
pub fn share(number: i64, starts: i64) -> i64 {
    Rounding::HalfAway.divide_narrow(number * TURN, starts)
}

/// The way from one angle to another, both within a turn, in the positive or in the negative direction, with so
/// many full turns more; at most 2^32 of them.
#[inline]
#[must_use]
pub fn travel(present: i64, target: i64, turns: i64, negative: bool) -> i64 {
    if negative { -within(present - target) - turns * TURN } else { within(target - present) + turns * TURN }
}

/// The way in a direction in which the target is known to lie by less than half a turn but for rounding, which never makes
/// it a whole turn (E100L-CRC-14). Both within a turn.
#[inline]
#[must_use]
pub fn beside(present: i64, target: i64, negative: bool) -> i64 {
    const MOST: i64 = TURN / 4 * 3;
    match travel(present, target, 0, negative) {
        way if way > MOST => way - TURN,
        way if way < -MOST => way + TURN,
        way => way,
    }
}

/// The way in a direction in which the target is known to lie by more than half a turn but for rounding, which never takes
/// a whole turn away (E100L-CRC-14). Both within a turn.
#[inline]
#[must_use]
pub fn around(present: i64, target: i64, negative: bool) -> i64 {
    const LEAST: i64 = TURN / 4;
    match travel(present, target, 0, negative) {
        way if way.abs() >= LEAST => way,
        way if negative => way - TURN,
        way => way + TURN,
    }
}
