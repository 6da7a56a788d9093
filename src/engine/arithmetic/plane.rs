//! Points of the turning plane and the exact signs of their geometry (E100L-CIRC-08, E100L-CIRC-11,
//! E100L-CIRC-16, E100L-CHAM-08, E100L-ANG-03, E100L-NRC-02, E100L-NRC-26, E100L-BARR-09).
//!
//! Points are latched coordinates of at most 2^56 in size: words reach 2^37, and lines meet no further than their
//! smallest angle allows. Directions are in half nanometres, twice Z and the diameter X, at most 2^58 in size;
//! sums of their products stay below 2^118. Those of radius compensation are at most 2^60 in size, and the way from one
//! centre to another at most 2^61; sums of their products stay below 2^124.

/// A point in program coordinates, X as a diameter.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Point {
    /// X as a diameter, in nanometres.
    pub x: i64,
    /// Z in nanometres.
    pub z: i64,
}

impl Point {
    /// The point moved by another one.
    #[inline]
    #[must_use]
    pub fn plus(self, by: Self) -> Self {
        Self { x: self.x.saturating_add(by.x), z: self.z.saturating_add(by.z) }
    }

    /// The point moved back by another one.
    #[inline]
    #[must_use]
    pub fn minus(self, by: Self) -> Self {
        Self { x: self.x.saturating_sub(by.x), z: self.z.saturating_sub(by.z) }
    }
}

/// A direction in half nanometres: along Z, and along X.
pub type Direction = (i128, i128);

/// From one point to another.
#[inline]
#[must_use]
pub fn difference(to: Point, from: Point) -> Direction {
    (2 * (i128::from(to.z) - i128::from(from.z)), i128::from(to.x) - i128::from(from.x))
}

/// A direction less another one: with the ways from two centres to one point, the way from the first centre to the
/// second.
#[inline]
#[must_use]
pub fn minus(first: Direction, second: Direction) -> Direction {
    (first.0 - second.0, first.1 - second.1)
}

/// Square of the distance of two points.
#[must_use]
pub fn square_distance(a: Point, b: Point) -> i128 {
    square(difference(a, b))
}

/// Square of the length of a direction.
#[must_use]
pub fn square((z, x): Direction) -> i128 {
    z * z + x * x
}

/// Vector product: positive when the second direction is to the left of the first, zero when both lie on one
/// line.
#[must_use]
pub fn cross(first: Direction, second: Direction) -> i128 {
    first.0 * second.1 - first.1 * second.0
}

/// Scalar product: negative when the second direction turns back.
#[must_use]
pub fn dot(first: Direction, second: Direction) -> i128 {
    first.0 * second.0 + first.1 * second.1
}

/// A direction turned to the left by a right angle.
#[inline]
#[must_use]
pub fn left((z, x): Direction) -> Direction {
    (-x, z)
}

/// The direction of travel along an arc at a point from its centre; `turn` is 1 counter-clockwise, -1 clockwise.
#[inline]
#[must_use]
pub fn tangent(from_centre: Direction, turn: i128) -> Direction {
    let (z, x) = left(from_centre);
    (turn * z, turn * x)
}

/// A direction of at most 2^60 in each component: what is beyond lies out of the range of every address, and the
/// bound keeps products in range.
#[inline]
#[must_use]
pub fn bounded((z, x): Direction) -> Direction {
    const MOST: i128 = 1 << 60;
    (z.clamp(-MOST, MOST), x.clamp(-MOST, MOST))
}

/// The signs, along Z and along X, of the quadrant in which an arc starts. The start lies at `from` the centre,
/// not on it; `turn` is 1 counter-clockwise and -1 clockwise. On an axis line it is the quadrant that the motion
/// enters, along the tangent `turn * (-x, z)`.
#[must_use]
pub fn quadrant((z, x): Direction, turn: i128) -> Direction {
    let side_z = if z == 0 { -turn * x.signum() } else { z.signum() };
    let side_x = if x == 0 { turn * z.signum() } else { x.signum() };
    (side_z, side_x)
}
