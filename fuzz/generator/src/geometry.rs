//! Points of the Z-X plane, in nanometres with X as a radius, and the lines that words with A describe.

use crate::builder::Builder;
use crate::program::Item;
use crate::state::Axis;

/// A point, or a vector, of the plane.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Point {
    /// Along Z.
    pub z: f64,
    /// Along X, as a radius.
    pub x: f64,
}

impl Point {
    /// From program coordinates, X as a diameter.
    pub fn of(x: i64, z: i64) -> Self {
        Self { z: z as f64, x: x as f64 / 2.0 }
    }

    /// X as a diameter, to the nanometre.
    pub fn diameter(self) -> i64 {
        (self.x * 2.0).round() as i64
    }

    /// Z, to the nanometre.
    pub fn coordinate(self) -> i64 {
        self.z.round() as i64
    }

    pub fn minus(self, other: Self) -> Self {
        Self { z: self.z - other.z, x: self.x - other.x }
    }

    pub fn plus(self, other: Self) -> Self {
        Self { z: self.z + other.z, x: self.x + other.x }
    }

    pub fn times(self, factor: f64) -> Self {
        Self { z: self.z * factor, x: self.x * factor }
    }

    pub fn length(self) -> f64 {
        self.z.hypot(self.x)
    }

    pub fn cross(self, other: Self) -> f64 {
        self.z * other.x - self.x * other.z
    }

    /// The angle from Z, counter-clockwise, in degrees.
    pub fn angle(self) -> f64 {
        self.x.atan2(self.z).to_degrees()
    }

    /// The same in micro-degrees, to a thousandth of a degree.
    pub fn milli(self) -> i64 {
        (self.angle() * 1_000.0).round() as i64 * 1_000
    }

    /// The angle by which the direction turns from this one to another, 0 to 180 degrees.
    pub fn turn(self, other: Self) -> f64 {
        let difference = (other.angle() - self.angle()).abs();
        if difference > 180.0 { 360.0 - difference } else { difference }
    }

    /// The unit vector at an angle in micro-degrees.
    pub fn direction(angle: i64) -> Self {
        let radians = (angle as f64 / 1e6).to_radians();
        Self { z: radians.cos(), x: radians.sin() }
    }
}

/// Where the line through a point at an angle in micro-degrees meets the line through another one, to the nanometre; none
/// of lines that are almost parallel.
pub(crate) fn meeting_of(base: Point, first: i64, end: Point, second: i64) -> Option<Point> {
    let (d1, d2) = (Point::direction(first), Point::direction(second));
    if d1.cross(d2).abs() < 0.2 {
        return None;
    }
    let corner = base.plus(d1.times(end.minus(base).cross(d2) / d1.cross(d2)));
    Some(Point::of(corner.diameter(), corner.coordinate()))
}

impl Builder<'_, '_, '_> {
    /// The present point.
    pub(crate) fn present(&self) -> Point {
        Point::of(self.state.program(Axis::X), self.state.program(Axis::Z))
    }

    /// Whether a point lies within the limits.
    pub(crate) fn point_fits(&self, point: Point) -> bool {
        let within = point.x.abs() < 4e10 && point.z.abs() < 8e10;
        within && self.state.fits(Axis::X, point.diameter()) && self.state.fits(Axis::Z, point.coordinate())
    }

    /// A point where a block may end, not on the same X or Z as the base and at least 2 mm away.
    pub(crate) fn somewhere_near(&mut self, base: Point) -> Point {
        let x = self.state.somewhere(Axis::X, self.choices);
        let z = self.state.somewhere(Axis::Z, self.choices);
        let mut point = Point::of(x, z);
        let away = |distance: f64| if distance.abs() < 2e6 { 5e6 } else { 0.0 };
        let (low_x, high_x) = self.state.window(Axis::X);
        let (low_z, high_z) = self.state.window(Axis::Z);
        let toward =
            |value: f64, low: i64, high: i64| if value * 2.0 > (low + high) as f64 { -1.0 } else { 1.0 };
        point.x += away(point.x - base.x) * toward(point.x * 2.0, low_x, high_x);
        point.z += away(point.z - base.z) * toward(point.z, low_z, high_z);
        point
    }

    /// An A word for an angle in micro-degrees: that angle, or another one of the same line.
    pub(crate) fn inclination(&mut self, angle: i64) -> Item {
        let half_turns = self.choices.weighted(&[(70, 0), (12, 1), (12, -1), (6, 2)]);
        self.angle("A", angle + half_turns * 180_000_000).0
    }

    /// Words of a line at an angle with one coordinate, near a wanted point; and where it ends.
    pub(crate) fn inclined(&mut self, base: Point, wanted: Point) -> Option<(Vec<Item>, Point)> {
        let travel = wanted.minus(base);
        let angle = travel.milli();
        let direction = Point::direction(angle);
        let by_x = (travel.x.abs() > travel.z.abs()) != self.choices.chance(10);
        let steep = if by_x { direction.x } else { direction.z };
        if steep.abs() < 0.02 {
            return None;
        }
        let (item, end) = if by_x {
            let (item, x) = self.coordinate(Axis::X, wanted.diameter(), base.diameter());
            let x = x as f64 / 2.0;
            (item, Point { x, z: base.z + (x - base.x) * direction.z / direction.x })
        } else {
            let (item, z) = self.coordinate(Axis::Z, wanted.coordinate(), base.coordinate());
            let z = z as f64;
            (item, Point { z, x: base.x + (z - base.z) * direction.x / direction.z })
        };
        let end = Point::of(end.diameter(), end.coordinate());
        self.point_fits(end).then(|| (vec![item, self.inclination(angle)], end))
    }

    /// Words of a line to a wanted point by X and Z; and where it ends.
    pub(crate) fn straight(&mut self, base: Point, wanted: Point) -> Option<(Vec<Item>, Point)> {
        let (x_item, x) = self.coordinate(Axis::X, wanted.diameter(), base.diameter());
        let (z_item, z) = self.coordinate(Axis::Z, wanted.coordinate(), base.coordinate());
        let end = Point::of(x, z);
        self.point_fits(end).then(|| (vec![x_item, z_item], end))
    }
}
