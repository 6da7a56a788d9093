//! An element as compensation sees it: its directions where it begins and ends, its side and its nose.
//!
//! Directions are in half nanometres: twice Z, and the diameter X. Everything is relative to the programmed
//! points, in the coordinates of the element's own block.

use turnspec_oracle::vocabulary::Sense;

use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::nose;
use crate::engine::arithmetic::plane::{Direction, Point, bounded, difference, tangent};
use crate::engine::planted::{self, Bug};

/// A line or an arc.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Its travel.
    Line(Direction),
    /// An arc by the ways from its centre to its ends.
    Arc {
        start: Direction,
        end: Direction,
        /// 1 counter-clockwise, -1 clockwise.
        turn: i128,
    },
}

impl Shape {
    /// A line between two points.
    pub fn line(start: Point, end: Point) -> Self {
        Self::Line(bounded(difference(end, start)))
    }

    /// An arc between two points about a centre.
    pub fn arc(start: Point, end: Point, centre: Point, sense: Sense) -> Self {
        let turn = if sense == Sense::CounterClockwise { 1 } else { -1 };
        let [start, end] = [start, end].map(|point| bounded(difference(point, centre)));
        Self::Arc { start, end, turn }
    }
}

impl Shape {
    /// A line between two points of another plane, whose first axis stands for Z and whose second one for X.
    pub fn line_between(start: Spot, end: Spot) -> Self {
        Self::Line(bounded(way(start, end)))
    }

    /// An arc in such a plane about a centre.
    pub fn arc_between(start: Spot, end: Spot, centre: Spot, sense: Sense) -> Self {
        let turn = if sense == Sense::CounterClockwise { 1 } else { -1 };
        let [start, end] = [start, end].map(|point| bounded(way(centre, point)));
        Self::Arc { start, end, turn }
    }
}

/// From one point of a plane of lengths to another, in half nanometres.
fn way(from: Spot, to: Spot) -> Direction {
    let component = |from: i64, to: i64| 2 * (i128::from(to) - i128::from(from));
    (component(from.p, to.p), component(from.q, to.q))
}

/// The circle of an arc at one of its ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Circle {
    /// From the centre to the programmed end.
    pub from_centre: Direction,
    /// What the nose takes off the radius, in half nanometres: negative outside.
    pub inward: i128,
}

impl Circle {
    /// Whether the nose does not fit into it, or it has no direction there (E100L-NRC-48).
    pub fn is_too_small(self) -> bool {
        // Half a nanometre more than there is.
        let inward = self.inward + i128::from(planted::is(Bug::InsideArcOfTheNose) && self.inward > 0);
        nose::is_too_large(inward, self.from_centre)
    }
}

/// One end of an element.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum End {
    /// Of a line, with its direction.
    Line(Direction),
    /// Of an arc.
    Arc(Circle),
}

/// An element with what is in force in its block.
#[derive(Clone, Copy, Debug)]
pub struct Contour {
    pub shape: Shape,
    /// 1 in G41, -1 in G42.
    pub side: i128,
    /// The nose radius in nanometres.
    pub radius: i64,
    /// From the tip to the nose centre, X as a diameter.
    pub to_centre: Point,
}

impl Default for Contour {
    fn default() -> Self {
        Self { shape: Shape::Line((1, 0)), side: 1, radius: 0, to_centre: Point { x: 0, z: 0 } }
    }
}

impl Contour {
    /// The signed distance of the nose centre to the left of the element, in half nanometres.
    pub fn offset(&self) -> i128 {
        nose::offset(self.side, self.radius)
    }

    /// Its direction of travel where it begins.
    pub fn begin_tangent(&self) -> Direction {
        match self.shape {
            Shape::Line(travel) => travel,
            Shape::Arc { start, turn, .. } => tangent(start, turn),
        }
    }

    /// Its direction of travel where it ends.
    pub fn end_tangent(&self) -> Direction {
        match self.shape {
            Shape::Line(travel) => travel,
            Shape::Arc { end, turn, .. } => tangent(end, turn),
        }
    }

    /// Where it begins.
    pub fn begin(&self) -> End {
        match self.shape {
            Shape::Line(travel) => End::Line(travel),
            Shape::Arc { start, turn, .. } => self.circle(start, turn),
        }
    }

    /// Where it ends.
    pub fn end(&self) -> End {
        match self.shape {
            Shape::Line(travel) => End::Line(travel),
            Shape::Arc { end, turn, .. } => self.circle(end, turn),
        }
    }

    /// Whether it is an arc.
    pub fn is_arc(&self) -> bool {
        matches!(self.shape, Shape::Arc { .. })
    }

    /// Whether it is an arc that the nose does not fit into (E100L-NRC-48).
    pub fn is_too_small(&self) -> bool {
        [self.begin(), self.end()].iter().any(|end| matches!(end, End::Arc(circle) if circle.is_too_small()))
    }

    /// What the nose takes off the radius of an arc, in half nanometres: negative outside; of a line nothing.
    pub fn inward(&self) -> i128 {
        match self.shape {
            Shape::Line(_) => 0,
            Shape::Arc { turn, .. } => turn * self.offset(),
        }
    }

    fn circle(&self, from_centre: Direction, turn: i128) -> End {
        End::Arc(Circle { from_centre, inward: turn * self.offset() })
    }
}
