//! The run-out chamfer at the end of a pass (E100L-TCHM-02 to E100L-TCHM-04).
//!
//! Coordinates are at most 2^60 in size, lengths along the lead axis doubled nanometres of at most 2^62, half a
//! diameter being whole; `halves` is 1 or 2. The withdrawal is [`rise`] by [`turn`], as a difference of levels.

use super::root::narrow;
use super::round::Rounding;

/// Picometres of a nanometre.
const PICO: i128 = 1000;
/// The withdrawal rate of a parameter of 1, in picometres per minute: 4.6875 mm/min.
const RATE: i64 = 4_687_500_000;

/// The withdrawal rate of a parameter of 1 to 9999, in picometres per minute.
#[must_use]
pub fn withdrawal_rate(parameter: i64) -> i64 {
    RATE * parameter
}

/// Whether a length in picometres, at most 2^80, is longer than a thread.
#[must_use]
pub fn is_too_long(length: i128, thread: i128) -> bool {
    2 * length > PICO * thread
}

/// Where a chamfer of a length in picometres, at most 2^80, begins before the end of the thread, latched; the way is 1
/// or -1 along the lead axis.
#[must_use]
pub fn begin(end: i64, way: i128, length: i128, halves: i128) -> i64 {
    let back = 2 * length / halves;
    narrow(Rounding::HalfAway.divide(PICO * i128::from(end) - way * back, PICO))
}

/// The level at a rest of the whole length before the end, latched: from the first level to the last one. The whole is
/// not 0, the rest not longer.
#[must_use]
pub fn level_at(first: i64, last: i64, whole: i128, rest: i128) -> i64 {
    let (first, last) = (i128::from(first), i128::from(last));
    narrow(Rounding::HalfAway.divide(first * whole + (last - first) * (whole - rest), whole))
}

/// The factor of [`rise`] by the parameter of the withdrawal rate, 1 to 9999: 4.6875 mm/min are 4 687 500 nm/min, halved
/// with the doubled length, and 10^6 with the units of [`turn`]. `halves` are those of the other axis.
#[must_use]
pub fn unit(parameter: i128, halves: i128) -> i128 {
    2_343_750_000_000 * parameter * (2 / halves)
}

/// The withdrawal over a rest, multiplied by [`turn`]; below 2^119.
#[must_use]
pub fn rise(unit: i128, rest: i128) -> i128 {
    unit * rest
}

/// What the withdrawal is divided by: the feed of the lead axis, of a speed in thousandths of a revolution per minute,
/// below 2^27, and a lead in picometres of at most 2^60.
#[must_use]
pub fn turn(speed: i64, lead: i64) -> i128 {
    i128::from(speed) * i128::from(lead)
}

/// Whether the withdrawal reaches the level of the cycle start, from which the room is left, not negative.
#[must_use]
pub fn reaches_start(room: i128, rise: i128, turn: i128) -> bool {
    room.saturating_mul(turn) <= rise
}

/// Whether the tool is deeper at the end than without a chamfer: the level at its beginning is above the last one by
/// so much, of either sign.
#[must_use]
pub fn is_deeper(above: i128, rise: i128, turn: i128) -> bool {
    above.saturating_mul(turn).saturating_add(rise) < 0
}

/// The level after a withdrawal to a side, 1 or -1, latched; the turn is not 0.
#[must_use]
pub fn withdrawn(level: i64, side: i128, rise: i128, turn: i128) -> i64 {
    let level = i128::from(level).saturating_mul(turn).saturating_add(side * rise);
    narrow(Rounding::HalfAway.divide(level, turn))
}

/// Where the level of the cycle start is reached along the lead axis, latched: where way and withdrawal have the same
/// share of the whole. The start is reached (see [`reaches_start`]), `halves` are those of the lead axis.
#[must_use]
pub fn reached(begin: i64, way: i128, room: i128, turn: i128, unit: i128, halves: i128) -> i64 {
    let whole = unit * halves;
    let reached = i128::from(begin).saturating_mul(whole).saturating_add(way * room.saturating_mul(turn));
    narrow(Rounding::HalfAway.divide(reached, whole))
}
