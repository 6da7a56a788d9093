//! E100L-BARR-09, arcs: whether an arc goes into a rectangle.

use std::cmp::Ordering;

use super::rectangle::{Limits, Rectangle, Side};
use super::surd::Surd;
use crate::path::Vector;
use crate::quantity::{Exact, whole};
use crate::vocabulary::Sense;

/// The circle about M through S, from S until the ray from M through E is met.
pub struct Arc {
    /// M.
    centre: Vector,
    /// S − M.
    to_start: Vector,
    /// E − M.
    to_end: Vector,
    /// 1 counter-clockwise, −1 clockwise.
    sense: Exact,
}

/// Q − M, of a point Q in which the circle meets a side.
struct Meeting {
    z: Surd,
    x: Surd,
}

impl Arc {
    /// From S, E and M.
    pub fn new(start: &Vector, end: &Vector, centre: Vector, sense: Sense) -> Self {
        Self {
            to_start: start.minus(&centre),
            to_end: end.minus(&centre),
            centre,
            sense: whole(if sense == Sense::CounterClockwise { 1 } else { -1 }),
        }
    }

    /// Whether it goes from the edge of a rectangle into the inside. An arc that starts outside and has a point inside
    /// does.
    pub fn enters(&self, rectangle: &Rectangle) -> bool {
        let sides = rectangle.sides();
        let goes_inside = |meeting: &Meeting| {
            self.passes(meeting) && sides.iter().all(|side| self.goes_inside_of(meeting, side))
        };
        !self.is_without_sweep() && sides.iter().any(|side| self.meetings(side).iter().any(goes_inside))
    }

    /// Whether E lies on the ray from M through S, or is M.
    fn is_without_sweep(&self) -> bool {
        self.to_start.cross(&self.to_end).is_zero() && self.to_start.dot(&self.to_end) >= Exact::ZERO
    }

    /// Where the circle meets the line of a side: the other coordinate is ±√(rs² − c²).
    fn meetings(&self, side: &Side) -> Vec<Meeting> {
        let along = &side.at - coordinate(&self.centre, side.limits);
        let square = self.to_start.square() - &along * &along;
        if square < Exact::ZERO {
            return Vec::new();
        }
        let meeting = |sign: i32| {
            let known = Surd::new(along.clone(), Exact::ZERO, &square);
            let other = Surd::new(Exact::ZERO, whole(sign), &square);
            match side.limits {
                Limits::Z => Meeting { z: known, x: other },
                Limits::X => Meeting { z: other, x: known },
            }
        };
        vec![meeting(1), meeting(-1)]
    }

    /// Whether the sweep has a point: S is one, its end is not. The arc has a sweep.
    fn passes(&self, point: &Meeting) -> bool {
        let (start, end) = (&self.to_start, &self.to_end);
        // Vector products are positive when the second one comes later, within half a turn.
        let of_point = (self.turned(point.left_of(start)), point.ahead_of(start));
        let of_end = (self.turned(start.cross(end).cmp(&Exact::ZERO)), start.dot(end).cmp(&Exact::ZERO));
        match (in_first_half(of_point), in_first_half(of_end)) {
            (true, false) => true,
            (false, true) => false,
            _ => self.turned(point.left_of(end)).is_lt(),
        }
    }

    /// A side of a direction, as it is when the arc runs counter-clockwise.
    fn turned(&self, side: Ordering) -> Ordering {
        if self.sense < Exact::ZERO { side.reverse() } else { side }
    }

    /// Whether a point lies on the inner side of a line, or the arc goes on to it from the line. A circle that touches
    /// the line is on the side of its centre.
    fn goes_inside_of(&self, point: &Meeting, side: &Side) -> bool {
        let centre = (coordinate(&self.centre, side.limits) - &side.at) * &side.inward;
        let inside = point.coordinate(side.limits).times(&side.inward).plus_rational(&centre);
        let travel = match side.limits {
            Limits::Z => point.x.times(&-&self.sense),
            Limits::X => point.z.times(&self.sense),
        };
        let onward = travel.times(&side.inward);
        inside.sign().then(onward.sign()).then(centre.cmp(&Exact::ZERO)).is_gt()
    }
}

/// Whether a direction is less than half a turn ahead, by the signs of its vector and scalar product with the first
/// one.
fn in_first_half((left, ahead): (Ordering, Ordering)) -> bool {
    left.then(ahead).is_gt()
}

fn coordinate(vector: &Vector, limits: Limits) -> &Exact {
    match limits {
        Limits::Z => &vector.z,
        Limits::X => &vector.x,
    }
}

impl Meeting {
    fn coordinate(&self, limits: Limits) -> &Surd {
        match limits {
            Limits::Z => &self.z,
            Limits::X => &self.x,
        }
    }

    /// Whether it is to the left of a direction: the sign of the vector product of the direction and it.
    fn left_of(&self, direction: &Vector) -> Ordering {
        self.x.times(&direction.z).plus(&self.z.times(&-&direction.x)).sign()
    }

    /// Whether it lies ahead in a direction: the sign of the scalar product.
    fn ahead_of(&self, direction: &Vector) -> Ordering {
        self.z.times(&direction.z).plus(&self.x.times(&direction.x)).sign()
    }
}
