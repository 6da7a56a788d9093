//! Amounts of grooving, drilling and tapping cycles (E100L-GRV-04, E100L-MCYC-20, E100L-G190-06, E100L-STAP-01,
//! E100L-CTHR-01).
//!
//! Lengths are nanometres, leads and feeds picometres, angles micro-degrees. Coordinates and depths are below 2^60,
//! words below 2^38; within that range nothing saturates.

use super::root::narrow;
use super::round::Rounding;
use super::turn::TURN;

/// The depth at which the peck after one that ended at `done` ends: `step` deeper, at most at `depth`. All are
/// positive, `done` is less than `depth`.
#[inline]
#[must_use]
pub fn next_depth(done: i64, step: i64, depth: i64) -> i64 {
    done.saturating_add(step).min(depth)
}

/// The depth to which a tool returns from one by an amount: the beginning of the cut at the most. Neither is
/// negative.
#[inline]
#[must_use]
pub fn relieved(depth: i64, amount: i64) -> i64 {
    depth.saturating_sub(amount).max(0)
}

/// The coordinate at a depth from a level, in a direction of -1 or 1.
#[inline]
#[must_use]
pub fn at_depth(level: i64, direction: i64, depth: i64) -> i64 {
    level.saturating_add(direction.saturating_mul(depth))
}

/// How many equal steps of at most `step` make a depth; both are positive.
#[must_use]
pub fn equal_steps(depth: i64, step: i64) -> i64 {
    Rounding::Up.divide_narrow(depth, step)
}

/// The coordinate at `part / parts` of a depth, less an amount, from a level in a direction of -1 or 1, latched; not
/// on the other side of the level. The parts are positive and below 2^60, the amount is not negative.
#[must_use]
pub fn at_part(level: i64, direction: i64, (depth, part, parts): (i64, i64, i64), amount: i64) -> i64 {
    let parts = i128::from(parts);
    let deep = i128::from(depth) * i128::from(part) - parts * i128::from(amount);
    let whole = parts * i128::from(level) + i128::from(direction) * deep.max(0);
    narrow(Rounding::HalfAway.divide(whole, parts))
}

/// The angle of one of `count` holes round the axis, by its number from 0, latched and not yet within a turn. The
/// first angle is less than a turn either way, number and count are below 2^14.
#[must_use]
pub fn hole_angle(first: i64, number: i64, count: i64, negative: bool) -> i64 {
    let way = number * TURN;
    let way = if negative { -way } else { way };
    Rounding::HalfAway.divide_narrow(first * count + way, count)
}

/// The lead of a tap: the feed over a divisor, and over the thousandths of a revolution per minute when the feed is
/// one per minute. The divisor is at most 9999, the speed positive and below 2^27.
#[must_use]
pub fn tap_lead(feed: i64, divisor: i64, speed: Option<i64>) -> i64 {
    let (feed, divisor) = (i128::from(feed), i128::from(divisor.max(1)));
    narrow(match speed {
        Some(speed) => Rounding::HalfAway.divide(1000 * feed, divisor * i128::from(speed.max(1))),
        None => Rounding::HalfAway.divide(feed, divisor),
    })
}

/// How far the C axis turns on a way of which the double is given, at a lead; the double is below 2^65 and not
/// negative, the lead positive.
#[must_use]
pub fn helix_turn(twice: i128, lead: i64) -> i64 {
    // 500 picometres are half a nanometre.
    let turn = 500 * i128::from(TURN);
    narrow(Rounding::HalfAway.divide(turn * twice, i128::from(lead.max(1))))
}

/// The feed per minute of a lead at a speed in thousandths of a revolution per minute.
#[must_use]
pub fn helix_feed(lead: i64, speed: i64) -> i64 {
    narrow(Rounding::HalfAway.divide(i128::from(lead) * i128::from(speed), 1000))
}

#[cfg(test)]
mod tests {
    use super::{at_part, equal_steps, helix_feed, helix_turn, hole_angle, next_depth, relieved, tap_lead};

    #[test]
    fn pecks_end_at_the_bottom() {
        assert_eq!(next_depth(0, 4, 10), 4);
        assert_eq!(next_depth(8, 4, 10), 10);
        assert_eq!(relieved(4, 1), 3);
        assert_eq!(relieved(4, 5), 0);
    }

    #[test]
    fn equal_steps_are_as_few_as_can_be() {
        assert_eq!(equal_steps(5_000_000, 2_000_000), 3);
        assert_eq!(equal_steps(6_000_000, 2_000_000), 3);
        // 10 - 5/3 and 10 - 10/3 mm.
        assert_eq!(at_part(10_000_000, -1, (5_000_000, 1, 3), 0), 8_333_333);
        assert_eq!(at_part(10_000_000, -1, (5_000_000, 2, 3), 0), 6_666_667);
        assert_eq!(at_part(10_000_000, -1, (5_000_000, 1, 3), 100_000), 8_433_333);
        assert_eq!(at_part(10_000_000, -1, (5_000_000, 1, 3), 9_000_000), 10_000_000);
        // Half a nanometre below and above zero.
        assert_eq!(at_part(0, -1, (1, 1, 2), 0), -1);
        assert_eq!(at_part(0, 1, (1, 1, 2), 0), 1);
    }

    #[test]
    fn holes_are_spread_over_a_turn() {
        assert_eq!(hole_angle(0, 1, 7, false), 51_428_571);
        assert_eq!(hole_angle(0, 6, 7, false), 308_571_429);
        assert_eq!(hole_angle(30_000_000, 1, 3, true), -90_000_000);
    }

    #[test]
    fn leads_follow_feed_and_speed() {
        assert_eq!(tap_lead(10_160_000_000_000, 20, Some(400_000)), 1_270_000_000);
        assert_eq!(tap_lead(25_400_000_000, 20, None), 1_270_000_000);
        // 10 mm at a lead of 0.7 mm.
        assert_eq!(helix_turn(20_000_000, 700_000_000), 5_142_857_143);
        assert_eq!(helix_feed(10_000_000_000, 12_000), 120_000_000_000);
    }
}
