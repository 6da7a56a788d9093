//! How deep the passes of a compound thread cycle go, and to which flank, as far as whole numbers tell (E100L-TINF-02 to
//! E100L-TINF-07, E100L-TMOD-02 to E100L-TMOD-04).
//!
//! Depths are nanometres of 1 to 2^37, numbers of passes count from 1.

use turnspec_oracle::vocabulary::ThreadFlank;

use super::round::Rounding;
use crate::engine::planted::{self, Bug};

/// The square of a depth.
#[must_use]
pub fn square(depth: i64) -> i128 {
    i128::from(depth) * i128::from(depth)
}

/// Steps up to the target less a step, then that less a half, a quarter and an eighth of one (E100L-TINF-02); none behind
/// them. The target is at least a step.
#[must_use]
pub fn halving(number: i64, step: i64, target: i64) -> Option<i64> {
    let before = target - step;
    let rest = before % step != 0 && !planted::is(Bug::RemainderLeft);
    let steps = before / step + i64::from(rest);
    match number - steps {
        ..=0 => Some(number.saturating_mul(step).min(before)),
        parts @ 1..=3 => Some(Rounding::HalfAway.divide_narrow((target << parts) - step, 1 << parts)),
        _ => None,
    }
}

/// Steps as long as they are less than the target (E100L-TINF-03).
#[must_use]
pub fn steps(number: i64, step: i64, target: i64) -> Option<i64> {
    Some(number.saturating_mul(step)).filter(|depth| *depth < target)
}

/// The square of the depth of so many equal areas of a first pass, if it is less than the target (E100L-TINF-04). Any
/// number.
#[must_use]
pub fn areas(number: i64, step: i64, target: i64) -> Option<i128> {
    let area = i128::from(number).saturating_mul(square(step));
    let twice = area == square(target) && planted::is(Bug::TargetTwice);
    (area < square(target) || twice).then_some(area)
}

/// How many passes remove at most an area each, the first of them aside, until the target is reached (E100L-TINF-06).
#[must_use]
pub fn balanced_count(step: i64, target: i64, area: i128) -> i64 {
    let rest = square(target) - square(step);
    if rest <= 0 || area <= 0 {
        return 1;
    }
    let rounding = if planted::is(Bug::BalancedCut) { Rounding::Cut } else { Rounding::Up };
    i64::try_from(rounding.divide(rest, area).max(1) + 1).unwrap_or(i64::MAX)
}

/// The sign of the shift of a pass along the lead axis, on the left flank or on the right one (E100L-TMOD-03).
#[must_use]
pub fn flank_sign(left: bool, reading: ThreadFlank) -> i64 {
    if left == (reading == ThreadFlank::Negative) { -1 } else { 1 }
}

/// Whether a pass is on the left flank when they take turns: the odd ones (E100L-TMOD-04). Any number.
#[must_use]
pub fn is_left_by_turns(number: i64) -> bool {
    number % 2 != 0
}

/// The shift along a flank of half a right angle, whose tangent is 1, by the depth that is left (E100L-TMOD-02); of 0 to
/// 2^37. Along Z that is a diameter and counts half, along X a length that counts twice.
#[must_use]
pub fn right_angle_shift(rest: i64, along_z: bool) -> i64 {
    if along_z { Rounding::HalfAway.divide_narrow(rest, 2) } else { 2 * rest }
}
