//! Points of a plane of the C axis: of the face (E100L-CGF-01), or of the developed side (E100L-CGS-02).

use crate::integer::turn;
use crate::quantity::{Exact, narrow, ratio, whole};
use crate::real::{self, Interval};

/// A latched point or a vector, in nanometres: coordinates below 2^62.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct PlanePoint {
    /// The first coordinate.
    pub p: i64,
    /// The second one.
    pub q: i64,
}

impl PlanePoint {
    /// The centre of the face.
    pub const CENTRE: Self = Self { p: 0, q: 0 };

    /// E100L-CGF-01: the point of the face with this program X and this C, latched.
    pub fn at(diameter: i64, angle: i64) -> Self {
        let radius = ratio(diameter, 2);
        let times = |cosine: &dyn Fn(usize) -> Interval| {
            narrow(&real::nearest_whole(|precision| Interval::of(&radius, precision).mul(&cosine(precision))))
        };
        let quarter = turn::FULL_TURN / 4;
        Self {
            p: times(&|precision| cosine(angle, precision)),
            q: times(&|precision| cosine(angle - quarter, precision)),
        }
    }

    /// A coordinate, kept within 2^60, which is beyond every range.
    pub fn within(coordinate: i64) -> i64 {
        coordinate.clamp(-(1 << 60), 1 << 60)
    }

    /// The vector from another point, of which no coordinate differs by more than 2^62.
    pub fn from(self, other: Self) -> Self {
        Self { p: self.p - other.p, q: self.q - other.q }
    }

    /// Vector product of the vectors to both points: positive when `other` is counter-clockwise of `self`.
    pub fn cross(self, other: Self) -> i128 {
        i128::from(self.p) * i128::from(other.q) - i128::from(self.q) * i128::from(other.p)
    }

    /// Scalar product.
    pub fn dot(self, other: Self) -> i128 {
        i128::from(self.p) * i128::from(other.p) + i128::from(self.q) * i128::from(other.q)
    }

    /// Square of the distance from the centre.
    pub fn square(self) -> i128 {
        self.dot(self)
    }

    /// Square of the distance of two points.
    pub fn distance_square(self, other: Self) -> Exact {
        let (p, q) = (whole(other.p - self.p), whole(other.q - self.q));
        &p * &p + &q * &q
    }
}

/// Cosine of an angle in micro-degrees: exact where it is rational, at multiples of 30 degrees.
pub fn cosine(angle: i64, precision: usize) -> Interval {
    let twice = match turn::within(angle) {
        0 => 2,
        60_000_000 | 300_000_000 => 1,
        90_000_000 | 270_000_000 => 0,
        120_000_000 | 240_000_000 => -1,
        180_000_000 => -2,
        _ => return real::cos_degrees(&ratio(angle, 1_000_000), precision),
    };
    Interval::of(&ratio(twice, 2), precision)
}

#[cfg(test)]
mod tests {
    use super::PlanePoint;

    #[test]
    fn points_of_the_face_are_latched_half_away_from_zero() {
        for (diameter, angle, p, q) in [
            (100_000_000, 30_000_000, 43_301_270, 25_000_000),
            (100_000_000, 300_000_000, 25_000_000, -43_301_270),
            // 3/4, 1/4 of a nanometre; half of one.
            (3, 180_000_000, -2, 0),
            (2, 120_000_000, -1, 1),
            (1, 0, 1, 0),
            (1, 270_000_000, 0, -1),
            (0, 12_345_678, 0, 0),
        ] {
            assert_eq!(PlanePoint::at(diameter, angle), PlanePoint { p, q }, "{diameter} {angle}");
        }
    }

    #[test]
    fn products_tell_sides() {
        let (right, up) = (PlanePoint { p: 1 << 59, q: 0 }, PlanePoint { p: 0, q: 1 << 59 });
        assert_eq!((right.cross(up), up.cross(right), right.dot(up)), (1 << 118, -(1 << 118), 0));
        assert_eq!(right.square(), 1 << 118);
    }
}
