//! Angles of the C axis and the way between them (E100L-CAX-05, E100L-CAX-06, E100L-G50-04).

/// A full turn in micro-degrees.
pub const FULL_TURN: i64 = 360_000_000;

/// The same direction as an angle from 0 to below a full turn. Any angle.
#[must_use]
pub fn within(angle: i64) -> i64 {
    angle.rem_euclid(FULL_TURN)
}

/// A zero shift of C without its whole turns, which say nothing of a rotary axis. Any shift.
#[must_use]
pub fn shift(shift: i64) -> i64 {
    shift % FULL_TURN
}

/// E100L-CAX-05, E100L-CAX-06: the signed way to a target, in the positive or the negative direction, and so many
/// whole turns. Angles below 2^60, turns below 2^32.
#[must_use]
pub fn travel(present: i64, target: i64, turns: i64, positive: bool) -> i64 {
    let turns = turns * FULL_TURN;
    if positive { within(target - present) + turns } else { -within(present - target) - turns }
}
