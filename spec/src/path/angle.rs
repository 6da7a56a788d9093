//! Lines by their inclination (E100L-ANG-01, E100L-ANG-02, E100L-ANG-06, E100L-DTAP-01 to -05).
//!
//! An angle fixes a line, not a ray.

use super::plane::{Point, Vector};
use crate::fault::{Fault, Outcome, fail};
use crate::quantity::{Exact, narrow, ratio, whole};
use crate::real::{self, Interval};
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

const HALF_TURN: i64 = 180_000_000;

/// The inclination of a line in micro-degrees.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Inclination(pub i64);

impl Inclination {
    fn degrees(self) -> Exact {
        ratio(self.0, 1_000_000)
    }

    fn along_z(self) -> bool {
        self.0 % HALF_TURN == 0
    }

    fn along_x(self) -> bool {
        self.0.rem_euclid(HALF_TURN) == HALF_TURN / 2
    }

    fn sin(self, precision: usize) -> Interval {
        real::sin_degrees(&self.degrees(), precision)
    }

    fn cos(self, precision: usize) -> Interval {
        real::cos_degrees(&self.degrees(), precision)
    }
}

/// E100L-DTAP-03, X given: Z of the line through a start point.
pub fn z_at(start: &Vector, inclination: Inclination, diameter: i64) -> Outcome<i64> {
    let rise = ratio(diameter, 2) - &start.x;
    if inclination.along_z() {
        return Err(no_intersection());
    }
    if inclination.along_x() || rise.is_zero() {
        return Ok(narrow(&crate::quantity::round(&start.z)));
    }
    let z = real::nearest_whole(|precision| {
        let run = Interval::of(&rise, precision).div(&real::tan_degrees(&inclination.degrees(), precision));
        Interval::of(&start.z, precision).add(&run)
    });
    Ok(narrow(&z))
}

/// E100L-DTAP-03, Z given: X (as a diameter) of the line through a start point.
pub fn x_at(start: &Vector, inclination: Inclination, z: i64) -> Outcome<i64> {
    let run = whole(z) - &start.z;
    if inclination.along_x() {
        return Err(no_intersection());
    }
    let start_diameter = &start.x * whole(2);
    let diameter = real::nearest_whole(|precision| {
        let rise = Interval::of(&(&run * whole(2)), precision)
            .mul(&real::tan_degrees(&inclination.degrees(), precision));
        Interval::of(&start_diameter, precision).add(&rise)
    });
    Ok(narrow(&diameter))
}

/// E100L-DTAP-04.
fn no_intersection() -> Fault {
    Fault::new(AlarmName::AngleNoIntersection, DTAP_04)
}

/// E100L-ANG-06: where the line through `start` meets the line through `end`; X as a diameter, and Z.
pub fn meeting(start: &Vector, first: Inclination, end: &Vector, second: Inclination) -> Outcome<Point> {
    if (second.0 - first.0) % HALF_TURN == 0 {
        return fail(AlarmName::AngleNoIntersection, ANG_06);
    }
    let between = Inclination(second.0 - first.0);
    let offset = end.minus(start);
    // cross(P2 - P0, d2) / cross(d1, d2), and cross(d1, d2) = sin(a2 - a1).
    let factor = |precision: usize| {
        let (z, x) = (Interval::of(&offset.z, precision), Interval::of(&offset.x, precision));
        let cross = z.mul(&second.sin(precision)).sub(&x.mul(&second.cos(precision)));
        cross.div(&between.sin(precision))
    };
    let at = |origin: &Exact, scale: u32, direction: &dyn Fn(usize) -> Interval| {
        let nearest = real::nearest_whole(|precision| {
            let step =
                factor(precision).mul(&direction(precision)).mul(&Interval::of(&whole(scale), precision));
            Interval::of(&(origin * whole(scale)), precision).add(&step)
        });
        narrow(&nearest)
    };
    Ok((
        at(&start.x, 2, &|precision| first.sin(precision)),
        at(&start.z, 1, &|precision| first.cos(precision)),
    ))
}
