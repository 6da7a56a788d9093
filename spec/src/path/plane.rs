//! Points and vectors of the turning plane: z to the right, x (a radius) up.

use crate::quantity::{Exact, ratio, whole};
use crate::real::{self, Interval};

/// A latched point: X as a diameter, and Z, in nanometres.
pub type Point = (i64, i64);

/// A point or vector with exact coordinates in nanometres.
#[derive(Clone, PartialEq, Debug)]
pub struct Vector {
    /// z.
    pub z: Exact,
    /// x, as a radius.
    pub x: Exact,
}

impl Vector {
    /// From a diameter and a Z coordinate in nanometres.
    pub fn of(diameter: i64, z: i64) -> Self {
        Self { z: whole(z), x: ratio(diameter, 2) }
    }

    /// `self - other`.
    pub fn minus(&self, other: &Self) -> Self {
        Self { z: &self.z - &other.z, x: &self.x - &other.x }
    }

    /// A latched point.
    pub fn at(point: Point) -> Self {
        Self::of(point.0, point.1)
    }

    /// Scalar product.
    pub fn dot(&self, other: &Self) -> Exact {
        &self.z * &other.z + &self.x * &other.x
    }

    /// Vector product: positive when `other` is counter-clockwise of `self`.
    pub fn cross(&self, other: &Self) -> Exact {
        &self.z * &other.x - &self.x * &other.z
    }

    /// Square of the length.
    pub fn square(&self) -> Exact {
        self.dot(self)
    }

    /// The vector turned a quarter counter-clockwise.
    pub fn left(&self) -> Self {
        Self { z: -self.x.clone(), x: self.z.clone() }
    }

    /// The vector times a number.
    pub fn times(&self, factor: &Exact) -> Self {
        Self { z: &self.z * factor, x: &self.x * factor }
    }

    /// Whether it is no vector.
    pub fn is_zero(&self) -> bool {
        self.z.is_zero() && self.x.is_zero()
    }
}

/// `origin + direction * factor`, latched: X as a diameter, and Z.
pub fn latch(origin: &Vector, direction: &Vector, factor: impl Fn(usize) -> Interval) -> Point {
    let along = |start: &Exact, step: &Exact, scale: u32| {
        let nearest = real::nearest_whole(|precision| {
            let offset = factor(precision).mul(&Interval::of(&(step * whole(scale)), precision));
            Interval::of(&(start * whole(scale)), precision).add(&offset)
        });
        crate::quantity::narrow(&nearest)
    };
    (along(&origin.x, &direction.x, 2), along(&origin.z, &direction.z, 1))
}
