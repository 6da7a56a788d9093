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

/// E100L-CRC-14: the way from one angle to another that lies on a known side of it by less than half a turn. Where the angles
/// contradict that by rounding, it leads back a little instead of once round. Angles of a full turn.
#[must_use]
pub fn beside(present: i64, target: i64, positive: bool) -> i64 {
    let turned = travel(present, target, 0, positive);
    let contradicts = turned.abs() > 3 * (FULL_TURN / 4);
    if contradicts { turned - turned.signum() * FULL_TURN } else { turned }
}

/// E100L-CRC-14: the way round the other side of the centre, by more than half a turn; where the angles contradict that by
/// rounding, it is a little more than a full turn instead of nothing. Angles of a full turn.
#[must_use]
pub fn around(present: i64, target: i64, positive: bool) -> i64 {
    let turned = travel(present, target, 0, positive);
    let full = if positive { FULL_TURN } else { -FULL_TURN };
    if turned.abs() < FULL_TURN / 4 { turned + full } else { turned }
}
