//! Where a pass of a thread begins, and its levels there and at its end (E100L-G33-04, E100L-G33-05, E100L-G33-07). Any
//! coordinates: what is beyond 64 bits stays at their end, out of every range.

use turnspec_oracle::vocabulary::{TaperReference, ThreadShift};

/// Where the thread begins along the lead axis, by cycle start, end, and the word that shifts the start; none when its
/// end is its start or lies behind it. The word is not the least of 64 bits.
#[must_use]
pub fn begin(start: i64, end: i64, shift: i64, reading: ThreadShift) -> Option<i64> {
    let direction = end.saturating_sub(start).signum();
    let begin = match reading {
        ThreadShift::TowardEnd => start.saturating_add(direction * shift),
        ThreadShift::Coordinate => start.saturating_add(shift),
    };
    (direction != 0 && end.saturating_sub(begin).signum() == direction).then_some(begin)
}

/// The levels at the start and at the end, by the level of the pass and its taper.
#[must_use]
pub fn levels(level: i64, taper: i64, reading: TaperReference) -> (i64, i64) {
    match reading {
        TaperReference::Start => (level, level.saturating_add(taper)),
        TaperReference::End => (level.saturating_sub(taper), level),
    }
}

/// Whether the cycle start lies on a side of both levels: 1 above, -1 below.
#[must_use]
pub fn is_clear(side: i64, start: i64, levels: (i64, i64)) -> bool {
    let clear = |level: i64| start.saturating_sub(level).signum() == side;
    side != 0 && clear(levels.0) && clear(levels.1)
}
