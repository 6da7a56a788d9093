//! The corner of two lines: where their offset lines meet (E100L-NRC-26, E100L-NRC-62).

use crate::engine::arithmetic::plane::{Direction, cross, square};
use crate::engine::exact::Real;

use super::corner::{Along, NoseCentre};

/// The corner of two lines that are not parallel, by their directions and offsets in half nanometres:
/// (o1 |d1| d2 - o2 |d2| d1) / cross(d1, d2) from the programmed point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LinesCorner {
    first: Direction,
    first_offset: i128,
    second: Direction,
    second_offset: i128,
}

impl LinesCorner {
    /// The corner of a line and the next one, with their offsets to the left.
    pub fn new((first, first_offset): (Direction, i128), (second, second_offset): (Direction, i128)) -> Self {
        Self { first, first_offset, second, second_offset }
    }
}

impl NoseCentre for LinesCorner {
    fn component<R: Real>(&self, along: Along, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let term = |offset, line, other| {
            let length = integer(square(line)).root();
            integer(offset).times(&length).times(&integer(along.of(other)))
        };
        let first: R = term(self.first_offset, self.first, self.second);
        let second = term(self.second_offset, self.second, self.first);
        first.minus(&second).over(&integer(cross(self.first, self.second)))
    }
}
