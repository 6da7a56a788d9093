//! E100L-BARR-09, lines: whether a straight segment has a point in a rectangle.

use super::rectangle::Rectangle;
use crate::path::Vector;
use crate::quantity::Exact;

/// The t at which S + t(E − S) satisfies conditions; the ends are excluded.
enum Times {
    All,
    None,
    Between(Exact, Exact),
}

/// Whether one t from 0 to 1, both included, satisfies all four conditions.
pub fn enters(start: &Vector, end: &Vector, rectangle: &Rectangle) -> bool {
    let travel = end.minus(start);
    let z = times(&start.z, &travel.z, &rectangle.low.z, &rectangle.high.z);
    let x = times(&start.x, &travel.x, &rectangle.low.x, &rectangle.high.x);
    match (z, x) {
        (Times::None, _) | (_, Times::None) => false,
        (Times::All, Times::All) => true,
        (Times::All, Times::Between(first, last)) | (Times::Between(first, last), Times::All) => {
            falls_within(&first, &last)
        }
        (Times::Between(first, last), Times::Between(other_first, other_last)) => {
            let (first, last) = (first.max(other_first), last.min(other_last));
            first < last && falls_within(&first, &last)
        }
    }
}

/// When a coordinate lies between two others.
fn times(start: &Exact, travel: &Exact, low: &Exact, high: &Exact) -> Times {
    if travel.is_zero() {
        return if low < start && start < high { Times::All } else { Times::None };
    }
    let (at_low, at_high) = ((low - start) / travel, (high - start) / travel);
    if at_low < at_high { Times::Between(at_low, at_high) } else { Times::Between(at_high, at_low) }
}

/// Whether an open interval that is not empty has a point from 0 to 1, both included.
fn falls_within(first: &Exact, last: &Exact) -> bool {
    *last > Exact::ZERO && *first < Exact::ONE
}
