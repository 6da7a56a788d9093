//! E100L-NRC-52: where two offset circles meet.

use std::cmp::Ordering;

use super::circle::Circle;
use super::reach::{Reach, along, sum};
use crate::path::Vector;
use crate::quantity::Exact;
use crate::real::{self, Interval};

/// The circles, seen from P. D is the distance of their centres.
struct Pair {
    i: Circle,
    j: Circle,
    /// Mj − Mi.
    between: Vector,
    /// D².
    square: Exact,
}

/// From P to the meeting point on its side of the line of centres; none if the circles have no common point. The
/// tangents of the arcs are not parallel.
pub fn meeting(i: Circle, j: Circle) -> Option<Reach> {
    let between = i.from_centre.minus(&j.from_centre);
    let pair = Pair { i, j, square: between.square(), between };
    // |ri' − rj'| ≤ D ≤ ri' + rj'.
    let rooms = [
        real::sign(|precision| pair.rooms(precision).0),
        real::sign(|precision| pair.rooms(precision).1),
        real::sign(|precision| pair.rooms(precision).2),
    ];
    if rooms.contains(&Ordering::Less) {
        return None;
    }
    let touches = rooms.contains(&Ordering::Equal);
    Some(Reach::new(move |precision| pair.reach(touches, precision)))
}

impl Pair {
    /// ri'/D and rj'/D.
    fn radii(&self, precision: usize) -> (Interval, Interval) {
        (self.i.radius(&self.square, precision), self.j.radius(&self.square, precision))
    }

    /// (ri' + rj' − D)/D, (D + ri' − rj')/D, (D − ri' + rj')/D: the circles meet when none is negative, and touch
    /// when one is 0.
    fn rooms(&self, precision: usize) -> (Interval, Interval, Interval) {
        let (one, (i, j)) = (Interval::of(&Exact::ONE, precision), self.radii(precision));
        (i.add(&j).sub(&one), one.add(&i).sub(&j), one.sub(&i).add(&j))
    }

    /// (Mi − P) + g·e ± h·left(e): with e = (Mj − Mi)/D, g/D = (ri'²/D² − rj'²/D² + 1)/2 and, by Heron's formula,
    /// h/D is half the root of (ri' + rj' + D)/D and the three rooms.
    fn reach(&self, touches: bool, precision: usize) -> (Interval, Interval) {
        let one = Interval::of(&Exact::ONE, precision);
        let (i, j) = self.radii(precision);
        let foot = i.mul(&i).sub(&j.mul(&j)).add(&one).over(2);
        let left = self.between.left();
        let height = if touches {
            Interval::of(&Exact::ZERO, precision)
        } else {
            let (apart, around, within) = self.rooms(precision);
            let product = i.add(&j).add(&one).mul(&apart).mul(&around).mul(&within);
            product.sqrt().over(2)
        };
        let height = if self.i.from_centre.dot(&left) < Exact::ZERO { height.neg() } else { height };
        let back = along(&self.i.from_centre, &one.neg(), precision);
        sum(&back, &sum(&along(&self.between, &foot, precision), &along(&left, &height, precision)))
    }
}
