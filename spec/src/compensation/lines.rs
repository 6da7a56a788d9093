//! E100L-NRC-26: where two offset lines meet.

use super::nose::Nose;
use super::reach::{Reach, along, root, sum};
use crate::path::Vector;
use crate::quantity::whole;

/// From P to the meeting point of the offset lines of two directions that are not parallel:
/// (si·Ri·dj − sj·Rj·di)/cross(di, dj), for directions of any length ni and nj
/// (si·Ri·ni·dj − sj·Rj·nj·di)/cross(di, dj).
pub fn meeting(before: &Vector, i: Nose, after: &Vector, j: Nose) -> Reach {
    let cross = before.cross(after);
    let (of_after, of_before) = (whole(i.offset()) / &cross, whole(-j.offset()) / &cross);
    let (along_after, along_before) = (after.times(&of_after), before.times(&of_before));
    let (before_square, after_square) = (before.square(), after.square());
    Reach::new(move |precision| {
        sum(
            &along(&along_after, &root(&before_square, precision), precision),
            &along(&along_before, &root(&after_square, precision), precision),
        )
    })
}
