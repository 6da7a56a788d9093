//! Threads, as far as whole numbers go: where a pass begins, its levels, its flank, and the withdrawal rate
//! (E100L-G33-04, E100L-G33-05, E100L-G33-07, E100L-G71-02, E100L-TMOD-03, E100L-TMOD-04, E100L-TCHM-03).
//!
//! Coordinates and tapers are nanometres of at most 2^60 in size; X is a diameter. A side is 1 where coordinates are
//! greater, or -1.

use crate::vocabulary::{TaperReference, ThreadFlank, ThreadShift};

/// E100L-G33-04, E100L-G33-07: the way of the lead axis, 1 toward greater coordinates, and where the thread begins, from
/// cycle start, end and the word that shifts the start; none where there is no way to go.
#[must_use]
pub fn beginning(start: i64, end: i64, shift: i64, reading: ThreadShift) -> Option<(i64, i64)> {
    let direction = (end - start).signum();
    let from = match reading {
        ThreadShift::TowardEnd => start + direction * shift,
        ThreadShift::Coordinate => start + shift,
    };
    (direction != 0 && direction * (end - from) > 0).then_some((direction, from))
}

/// E100L-G33-05: the levels where the thread begins and where it ends, which stay at the end of 64 bits, out of every
/// range, where a taper leads beyond.
#[must_use]
pub fn levels(level: i64, rise: i64, reading: TaperReference) -> (i64, i64) {
    match reading {
        TaperReference::Start => (level, level.saturating_add(rise)),
        TaperReference::End => (level.saturating_sub(rise), level),
    }
}

/// E100L-G33-04: whether a level is not on its side of the cycle start; levels of any size. A side of 0 is none.
#[must_use]
pub fn is_beyond(side: i64, start: i64, level: i64) -> bool {
    side == 0 || start.saturating_sub(level).signum() != side
}

/// E100L-G71-02: the level of a pass that lies so much above the last one.
#[must_use]
pub fn level_above(last: i64, side: i64, above: i64) -> i64 {
    last + side * above
}

/// E100L-TMOD-03: to which side a pass on the left flank, or on the right one, is shifted.
#[must_use]
pub fn shift_side(left: bool, reading: ThreadFlank) -> i64 {
    let negative = left == (reading == ThreadFlank::Negative);
    if negative { -1 } else { 1 }
}

/// E100L-TMOD-04: whether the pass of this number, from 1, is on the left flank when they take turns.
#[must_use]
pub fn is_left_by_turns(number: u32) -> bool {
    number % 2 == 1
}

/// E100L-TCHM-03: the rate of chamfer and withdrawal, in picometres per minute, by its parameter: 0.001 mm in 12.8 ms
/// are 4.6875 mm/min.
#[must_use]
pub fn withdrawal_rate(parameter: u16) -> i64 {
    i64::from(parameter) * 4_687_500_000
}
