//! The plane of a cycle: heights from which the tool comes, runs in which it cuts (execution of LAP, 8).

use crate::engine::arithmetic::lap;
use crate::engine::arithmetic::plane::Point;

use super::value::Value;

/// Infeed axis and cutting axis, and their senses.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    /// G81: the infeed axis is X.
    pub along: bool,
    /// σ: the sense of the infeed axis in which heights grow.
    pub infeed: i64,
    /// γ: the sense of the cutting axis in which runs grow; 0 where no way along it matters.
    pub cutting: i64,
}

/// A point by run and height, in half nanometres.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Spot {
    pub run: i128,
    pub height: i128,
}

impl Axes {
    /// The coordinates of a point on the infeed axis and on the cutting axis.
    pub fn split(self, point: Point) -> (i64, i64) {
        if self.along { (point.x, point.z) } else { (point.z, point.x) }
    }

    /// The point with a coordinate on the infeed axis and one on the cutting axis.
    pub fn point(self, infeed: i64, cutting: i64) -> Point {
        if self.along { Point { x: infeed, z: cutting } } else { Point { x: cutting, z: infeed } }
    }

    /// How many half nanometres a nanometre on the infeed axis is.
    pub fn infeed_halves(self) -> i128 {
        lap::halves(self.along)
    }

    /// The same of the cutting axis.
    pub fn cutting_halves(self) -> i128 {
        lap::halves(!self.along)
    }

    /// The height of a coordinate on the infeed axis.
    pub fn height(self, infeed: i64) -> i128 {
        lap::scaled(infeed, self.infeed, self.along)
    }

    /// The run of a coordinate on the cutting axis.
    pub fn run(self, cutting: i64) -> i128 {
        lap::scaled(cutting, self.cutting, !self.along)
    }

    /// A point of the plane, of at most 2^40 in either direction: what is beyond lies out of the range of every address,
    /// and the bound keeps products in range.
    pub fn spot(self, point: Point) -> Spot {
        const MOST: i128 = 1 << 40;
        let (infeed, cutting) = self.split(point);
        let bounded = |value: i128| value.clamp(-MOST, MOST);
        Spot { run: bounded(self.run(cutting)), height: bounded(self.height(infeed)) }
    }

    /// The coordinate on the cutting axis of a run, latched.
    pub fn latch_run(self, run: Value) -> i64 {
        run.latch(self.cutting, self.along)
    }

    /// The coordinate on the infeed axis of a height, latched.
    pub fn latch_height(self, height: Value) -> i64 {
        height.latch(self.infeed, !self.along)
    }

    /// Whether the sense of an arc, seen with runs to the right and heights up, is that of its event.
    pub fn keeps_sense(self) -> bool {
        lap::keeps_sense(self.infeed, self.cutting, self.along)
    }
}
