//! An open rectangle in the plane of Z and X, and its sides.

use crate::path::Vector;
use crate::quantity::{Exact, whole};

/// All points between two corners, without the edge.
#[derive(Clone, PartialEq, Debug)]
pub struct Rectangle {
    /// The corner of least Z and X.
    pub low: Vector,
    /// The corner of greatest Z and X.
    pub high: Vector,
}

/// What a side limits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Limits {
    /// Z.
    Z,
    /// X.
    X,
}

/// A line on which an edge lies.
#[derive(Clone, PartialEq, Debug)]
pub struct Side {
    /// The coordinate that it limits.
    pub limits: Limits,
    /// Where it lies.
    pub at: Exact,
    /// 1 if the inner side is that of greater coordinates, −1 if it is the other.
    pub inward: Exact,
}

impl Rectangle {
    /// From Z and from X, as a diameter, in nanometres, the lower one first.
    pub fn new(z: (i64, i64), x: (i64, i64)) -> Self {
        Self { low: Vector::of(x.0, z.0), high: Vector::of(x.1, z.1) }
    }

    /// Whether a point is inside; the edge is not.
    pub fn contains(&self, point: &Vector) -> bool {
        let (low, high) = (&self.low, &self.high);
        low.z < point.z && point.z < high.z && low.x < point.x && point.x < high.x
    }

    /// Its four sides.
    pub fn sides(&self) -> [Side; 4] {
        let side = |limits, at: &Exact, inward: i32| Side { limits, at: at.clone(), inward: whole(inward) };
        [
            side(Limits::Z, &self.low.z, 1),
            side(Limits::Z, &self.high.z, -1),
            side(Limits::X, &self.low.x, 1),
            side(Limits::X, &self.high.x, -1),
        ]
    }
}
