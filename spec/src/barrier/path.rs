//! What of a motion a barrier looks at (E100L-BARR-08, E100L-BARR-09).

use super::arc::Arc;
use super::line;
use super::rectangle::Rectangle;
use crate::path::{Point, Shape, Vector};
use crate::vocabulary::BarrierPath;

/// The path of the programmed point, in program coordinates.
pub struct Path {
    /// Where it ends.
    end: Vector,
    way: Way,
}

/// The way to the end.
enum Way {
    /// None: the end alone counts.
    End,
    /// Straight from here.
    Line(Vector),
    /// From here along an arc.
    Arc(Vector, Box<Arc>),
}

impl Path {
    /// The path of a motion of this shape. The reading concerns a positioning only (E100L-BARR-08).
    pub fn of(shape: Shape, from: Point, to: Point, reading: BarrierPath) -> Self {
        let (start, end) = (Vector::at(from), Vector::at(to));
        let way = match shape {
            Shape::Rapid if reading == BarrierPath::Ends => Way::End,
            Shape::Rapid | Shape::Line => Way::Line(start),
            Shape::Arc { centre, sense } => {
                let arc = Arc::new(&start, &end, Vector::at(centre), sense);
                Way::Arc(start, Box::new(arc))
            }
        };
        Self { end, way }
    }

    /// Whether it has a point inside a rectangle.
    pub fn enters(&self, rectangle: &Rectangle) -> bool {
        match &self.way {
            Way::End => rectangle.contains(&self.end),
            Way::Line(start) => line::enters(start, &self.end, rectangle),
            // The end need not lie on the circle (E100L-CIRC-11).
            Way::Arc(start, arc) => {
                rectangle.contains(start) || rectangle.contains(&self.end) || arc.enters(rectangle)
            }
        }
    }
}
