//! An element as it is at one of its ends, P: what a corner is made of (E100L-NRC-13).

use super::circle::Circle;
use super::nose::Nose;
use crate::frame::Amounts;
use crate::path::{Element, Shape, Vector};
use crate::vocabulary::Sense;

/// An element at P.
#[derive(Clone, Debug)]
pub struct Leg {
    /// Its course.
    pub course: Course,
    /// The nose that follows it.
    pub nose: Nose,
}

/// The course of an element.
#[derive(Clone, Debug)]
pub enum Course {
    /// Straight, in this direction.
    Line(Vector),
    /// Round a centre; the vector leads from there to P.
    Arc(Vector, Sense),
}

impl Leg {
    /// A line in a direction.
    pub fn line(direction: Vector, nose: Nose) -> Self {
        Self { course: Course::Line(direction), nose }
    }

    /// A vector along the tangent in P, in the direction of travel (E100L-CIRC-02).
    pub fn tangent(&self) -> Vector {
        match &self.course {
            Course::Line(direction) => direction.clone(),
            Course::Arc(from_centre, Sense::CounterClockwise) => from_centre.left(),
            Course::Arc(from_centre, Sense::Clockwise) => from_centre.left().left().left(),
        }
    }

    /// Whether it is straight.
    pub fn is_line(&self) -> bool {
        matches!(self.course, Course::Line(_))
    }

    /// E100L-NRC-48: whether it is an arc without an offset circle.
    pub fn is_too_small(&self) -> bool {
        match &self.course {
            Course::Line(_) => false,
            Course::Arc(from_centre, sense) => Circle::new(from_centre, *sense, &self.nose).is_none(),
        }
    }
}

/// An element at its start and at its end; none of a motion that has no travel in X or Z. `from` and `to` are its
/// ends in the program coordinates of its block.
pub fn legs(element: &Element, from: Amounts, to: Amounts, nose: Nose) -> Option<(Leg, Leg)> {
    let travel = Vector::at((to.x, to.z)).minus(&Vector::at((from.x, from.z)));
    if travel.is_zero() {
        return None;
    }
    Some(match element.shape {
        Shape::Rapid | Shape::Line => (Leg::line(travel.clone(), nose), Leg::line(travel, nose)),
        Shape::Arc { centre, sense } => {
            let at_end = Vector::at((to.x, to.z)).minus(&Vector::at(centre));
            let at_start = at_end.minus(&travel);
            let leg = |from_centre| Leg { course: Course::Arc(from_centre, sense), nose };
            (leg(at_start), leg(at_end))
        }
    })
}
