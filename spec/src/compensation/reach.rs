//! The way from P to the nose centre C, and where C is latched (E100L-NRC-02, E100L-NRC-07).

use super::leg::Leg;
use crate::contour::PlanePoint;
use crate::path::{Point, Vector};
use crate::quantity::{Exact, narrow, whole};
use crate::real::{self, Interval};

/// A vector of real numbers, known to any precision: z, and x as a radius.
pub struct Reach(Box<dyn Fn(usize) -> (Interval, Interval)>);

impl Reach {
    /// From a function that computes it to a working precision.
    pub fn new(vector: impl Fn(usize) -> (Interval, Interval) + 'static) -> Self {
        Self(Box::new(vector))
    }

    /// E100L-NRC-02: contact with one element in P, s·R·left(t).
    pub fn contact(leg: &Leg) -> Self {
        let left = leg.tangent().left();
        let offset = leg.nose.offset();
        Self::new(move |precision| {
            let (z, x) = unit(&left, precision);
            (z.times(offset), x.times(offset))
        })
    }

    /// E100L-CRC-14: the cutter centre seen from a point P of its plane, p for z and q for x, latched. What is beyond every
    /// range is kept within 2^60.
    pub fn in_plane(&self, point: PlanePoint) -> PlanePoint {
        let (p, q) = (whole(point.p), whole(point.q));
        let [p, q] = real::nearest_wholes(|precision| {
            let (along_p, along_q) = (self.0)(precision);
            [Interval::of(&p, precision).add(&along_p), Interval::of(&q, precision).add(&along_q)]
        });
        PlanePoint { p: PlanePoint::within(narrow(&p)), q: PlanePoint::within(narrow(&q)) }
    }

    /// E100L-NRC-07: the nose centre seen from P, latched: X as a diameter, and Z. What is beyond every range is
    /// kept at its end.
    pub fn from(&self, point: Point) -> Point {
        let (diameter, start) = (whole(point.0), whole(point.1));
        let [x, z] = real::nearest_wholes(|precision| {
            let (z, x) = (self.0)(precision);
            [Interval::of(&diameter, precision).add(&x.times(2)), Interval::of(&start, precision).add(&z)]
        });
        (narrow(&x), narrow(&z))
    }
}

/// √ of a number that is not negative.
pub fn root(square: &Exact, precision: usize) -> Interval {
    Interval::of(square, precision).sqrt()
}

/// √ of a square, with the sign of `of`.
pub fn signed_root(of: &Exact, square: &Exact, precision: usize) -> Interval {
    let root = root(square, precision);
    if *of < Exact::ZERO { root.neg() } else { root }
}

/// The unit vector in a direction: each of its coordinates is the root of a rational number.
pub fn unit(direction: &Vector, precision: usize) -> (Interval, Interval) {
    let square = direction.square();
    let of = |part: &Exact| signed_root(part, &(part * part / &square), precision);
    (of(&direction.z), of(&direction.x))
}

/// A vector times a real number.
pub fn along(vector: &Vector, factor: &Interval, precision: usize) -> (Interval, Interval) {
    let of = |coordinate: &Exact| Interval::of(coordinate, precision).mul(factor);
    (of(&vector.z), of(&vector.x))
}

/// The sum of two vectors.
pub fn sum(one: &(Interval, Interval), other: &(Interval, Interval)) -> (Interval, Interval) {
    (one.0.add(&other.0), one.1.add(&other.1))
}
