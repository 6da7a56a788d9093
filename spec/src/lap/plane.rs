//! The plane of a cycle (execution-lap.md, section 8): a point has a run, along the cutting axis, and a height, along the
//! infeed axis; the tool comes from above and cuts toward greater runs.

use super::number::Number;
use crate::path::Point;
use crate::quantity::{Exact, ratio, whole};

/// A point by its coordinates on the infeed axis and on the cutting axis, in nanometres; X is a diameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Spot {
    /// On the infeed axis.
    pub infeed: i64,
    /// On the cutting axis.
    pub cutting: i64,
}

/// How run and height lie to the axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Plane {
    /// Whether the infeed axis is Z (G82).
    pub transverse: bool,
    /// Of the infeed axis: 1 where heights are greater with greater coordinates.
    pub up: i64,
    /// Of the cutting axis: 1 where runs are.
    pub onward: i64,
}

/// An exact point of the plane; heights and runs of X are radii.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Place {
    /// Its run.
    pub run: Number,
    /// Its height.
    pub height: Number,
}

impl Plane {
    /// The coordinates of a point.
    pub fn spot(self, (x, z): Point) -> Spot {
        if self.transverse { Spot { infeed: z, cutting: x } } else { Spot { infeed: x, cutting: z } }
    }

    /// The point of coordinates.
    pub fn point(self, Spot { infeed, cutting }: Spot) -> Point {
        if self.transverse { (cutting, infeed) } else { (infeed, cutting) }
    }

    /// The height of a coordinate of the infeed axis.
    pub fn height(self, infeed: i64) -> Exact {
        ratio(self.up * infeed, if self.transverse { 1 } else { 2 })
    }

    /// The run of a coordinate of the cutting axis, or of a length on it.
    pub fn run(self, cutting: i64) -> Exact {
        whole(self.onward) * self.length(cutting)
    }

    /// An amount on the cutting axis as a length.
    pub fn length(self, amount: i64) -> Exact {
        ratio(amount, if self.transverse { 2 } else { 1 })
    }

    /// The coordinate of a height, latched.
    pub fn infeed(self, height: &Number) -> i64 {
        height.times(&whole(if self.transverse { self.up } else { 2 * self.up })).nearest()
    }

    /// The coordinate of a run, latched.
    pub fn cutting(self, run: &Number) -> i64 {
        run.times(&whole(if self.transverse { 2 * self.onward } else { self.onward })).nearest()
    }

    /// The coordinates of a place, latched.
    pub fn latched(self, place: &Place) -> Spot {
        Spot { infeed: self.infeed(&place.height), cutting: self.cutting(&place.run) }
    }

    /// The place of coordinates.
    pub fn place(self, spot: Spot) -> Place {
        Place { run: self.run(spot.cutting).into(), height: self.height(spot.infeed).into() }
    }
}
