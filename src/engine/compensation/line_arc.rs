//! The corner of a line and an arc: where the offset line meets the offset circle (E100L-NRC-51,
//! E100L-NRC-63).
//!
//! With p from the centre M to the programmed point, d the direction of the line, o its offset to the left
//! and r' the radius of the nose centre, the offset line passes M at the distance h = cross(d, p) / |d| + o
//! to the left, and C = M + (h left(d) ± √(r'² - h²) d) / |d|, on the side of M on which p·d lies: that is
//! the common point nearer to the programmed one.

use crate::engine::arithmetic::plane::{Direction, cross, dot, left, square};
use crate::engine::exact::{Formula, Real, SlowPaths, sign};
use crate::engine::planted::{self, Bug};

use super::contour::Circle;
use super::corner::{Along, Meeting, NoseCentre};

/// An offset line and an offset circle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Pair {
    line: Direction,
    offset: i128,
    circle: Circle,
}

impl Pair {
    /// The length of the direction of the line.
    fn length<R: Real>(&self, precision: R::Precision) -> R {
        R::integer(square(self.line), precision).root()
    }

    /// The distance at which the offset line passes the centre, to its left.
    fn distance<R: Real>(&self, precision: R::Precision) -> R {
        let across = R::integer(cross(self.line, self.circle.from_centre), precision);
        across.over(&self.length(precision)).plus(&R::integer(self.offset, precision))
    }
}

/// The radius of the circle of the nose centre.
pub fn radius<R: Real>(circle: &Circle, precision: R::Precision) -> R {
    R::integer(square(circle.from_centre), precision).root().minus(&R::integer(circle.inward, precision))
}

/// The radius less the distance of the line, or more by it.
struct Gap {
    pair: Pair,
    beyond: bool,
}

impl Formula for Gap {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let radius: R = radius(&self.pair.circle, precision);
        let distance = self.pair.distance(precision);
        if self.beyond { radius.plus(&distance) } else { radius.minus(&distance) }
    }
}

/// The corner of a line and an arc that have a common point and are not parallel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LineArcCorner {
    pair: Pair,
    meeting: Meeting,
}

impl LineArcCorner {
    /// The corner of a line with its offset to the left and of a circle at their common programmed point;
    /// none if they have no common point when offset.
    pub fn new(line: Direction, offset: i128, circle: Circle, slow: &mut SlowPaths) -> Option<Self> {
        let pair = Pair { line, offset, circle };
        let gaps = [true, false].map(|beyond| sign(&Gap { pair, beyond }, slow));
        Meeting::of(gaps).map(|meeting| Self { pair, meeting })
    }
}

impl NoseCentre for LineArcCorner {
    fn component<R: Real>(&self, along: Along, precision: R::Precision) -> R {
        let Pair { line, circle, .. } = self.pair;
        let integer = |value| R::integer(value, precision);
        let distance: R = self.pair.distance(precision);
        let mut from_centre = distance.times(&integer(along.of(left(line))));
        if self.meeting == Meeting::Crossing {
            let radius: R = radius(&circle, precision);
            let half_chord = radius.minus(&distance).times(&radius.plus(&distance)).root();
            let ahead = planted::is(Bug::CommonPointAhead);
            let side = if ahead { 1 } else { dot(circle.from_centre, line).signum() };
            from_centre = from_centre.plus(&half_chord.times(&integer(side * along.of(line))));
        }
        from_centre.over(&self.pair.length(precision)).minus(&integer(along.of(circle.from_centre)))
    }
}
