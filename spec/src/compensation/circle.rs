//! E100L-NRC-48: the offset circle of an arc.

use super::nose::Nose;
use super::reach::{root, signed_root};
use crate::path::Vector;
use crate::quantity::{Exact, whole};
use crate::real::Interval;
use crate::vocabulary::Sense;

/// The circle about the centre of an arc on which the nose centre runs, seen from a point of the arc.
#[derive(Clone, Debug)]
pub struct Circle {
    /// From the centre of the arc to the point.
    pub from_centre: Vector,
    /// σ·s·R: how much nearer to the centre the nose centre is.
    inward: Exact,
}

impl Circle {
    /// The circle of a nose.
    pub fn new(from_centre: &Vector, sense: Sense, nose: &Nose) -> Self {
        let inward = match sense {
            Sense::CounterClockwise => nose.offset(),
            Sense::Clockwise => -nose.offset(),
        };
        Self { from_centre: from_centre.clone(), inward: whole(inward) }
    }

    /// Whether there is none, r' = r − s·σ·R < 0, or the point is the centre of the arc, which has no tangent there.
    pub fn is_none(&self) -> bool {
        let square = self.from_centre.square();
        square.is_zero() || self.inward > Exact::ZERO && square < &self.inward * &self.inward
    }

    /// r', in a unit of length with this square.
    pub fn radius(&self, unit_square: &Exact, precision: usize) -> Interval {
        let of_arc = root(&(self.from_centre.square() / unit_square), precision);
        let inward_square = &self.inward * &self.inward / unit_square;
        of_arc.sub(&signed_root(&self.inward, &inward_square, precision))
    }
}
