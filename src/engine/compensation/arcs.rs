//! The corner of two arcs: where their offset circles meet (E100L-NRC-52, E100L-NRC-63).
//!
//! With D the distance of the centres, E the way from the first to the second, S the sum and T the
//! difference of the radii of the nose centre, C lies from the first centre at
//! ((S T + D²) E ± √((S² - D²)(D² - T²)) left(E)) / (2 D²), on the side of E on which the programmed point is.

use crate::engine::arithmetic::plane::{Direction, cross, left, minus, square};
use crate::engine::exact::{Formula, Real, SlowPaths, sign};

use super::contour::Circle;
use super::corner::{Along, Meeting, NoseCentre};
use super::line_arc::radius;

/// Two offset circles through one programmed point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Pair {
    first: Circle,
    second: Circle,
}

impl Pair {
    /// From the first centre to the second.
    fn centres(&self) -> Direction {
        minus(self.first.from_centre, self.second.from_centre)
    }

    /// Sum and difference of the radii.
    fn radii<R: Real>(&self, precision: R::Precision) -> (R, R) {
        let [first, second] = [self.first, self.second].map(|circle| radius::<R>(&circle, precision));
        (first.plus(&second), first.minus(&second))
    }
}

/// What must not be negative where two circles have a common point.
#[derive(Clone, Copy)]
enum Gap {
    /// S - D
    Apart,
    /// D - T
    SecondInside,
    /// D + T
    FirstInside,
}

struct GapOf {
    pair: Pair,
    gap: Gap,
}

impl Formula for GapOf {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let distance = R::integer(square(self.pair.centres()), precision).root();
        let (sum, difference): (R, R) = self.pair.radii(precision);
        match self.gap {
            Gap::Apart => sum.minus(&distance),
            Gap::SecondInside => distance.minus(&difference),
            Gap::FirstInside => distance.plus(&difference),
        }
    }
}

/// The corner of two arcs that have a common point and are not parallel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ArcsCorner {
    pair: Pair,
    meeting: Meeting,
}

impl ArcsCorner {
    /// The corner of two circles at their common programmed point; none if they have no common point when
    /// offset.
    pub fn new(first: Circle, second: Circle, slow: &mut SlowPaths) -> Option<Self> {
        let pair = Pair { first, second };
        let gaps = [Gap::Apart, Gap::SecondInside, Gap::FirstInside];
        Meeting::of(gaps.map(|gap| sign(&GapOf { pair, gap }, slow))).map(|meeting| Self { pair, meeting })
    }
}

impl NoseCentre for ArcsCorner {
    fn component<R: Real>(&self, along: Along, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let centres = self.pair.centres();
        let square = integer(square(centres));
        let (sum, difference): (R, R) = self.pair.radii(precision);
        let foot = sum.times(&difference).plus(&square);
        let mut from_first = foot.times(&integer(along.of(centres)));
        if self.meeting == Meeting::Crossing {
            let distance = square.root();
            let outer = sum.minus(&distance).times(&sum.plus(&distance));
            let inner = distance.minus(&difference).times(&distance.plus(&difference));
            let side = cross(centres, self.pair.first.from_centre).signum();
            let half_chord = outer.times(&inner).root();
            from_first = from_first.plus(&half_chord.times(&integer(side * along.of(left(centres)))));
        }
        let to_centre = integer(along.of(self.pair.first.from_centre));
        from_first.over(&square.plus(&square)).minus(&to_centre)
    }
}
