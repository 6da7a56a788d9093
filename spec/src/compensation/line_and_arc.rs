//! E100L-NRC-51: where an offset line and an offset circle meet.

use std::cmp::Ordering;

use super::circle::Circle;
use super::nose::Nose;
use super::reach::{Reach, sum, unit};
use crate::path::Vector;
use crate::quantity::{Exact, whole};
use crate::real::{self, Interval};

/// The line and the circle, seen from P. With the unit vector d of the line: w = (P − M) + s·R·left(d),
/// b = w·d = (P − M)·d, and a = w·left(d) is the distance of the offset line from M. So
/// b² − |w|² + r'² = r'² − a² = (r' − a)(r' + a).
struct Pair {
    /// A vector along the line.
    line: Vector,
    /// s·R of the line.
    offset: Exact,
    circle: Circle,
}

/// From P to the meeting point that is nearer to it; none if the line passes by the circle. The tangent of the arc
/// is not parallel to the line.
pub fn meeting(line: &Vector, nose: Nose, circle: Circle) -> Option<Reach> {
    let pair = Pair { line: line.clone(), offset: whole(nose.offset()), circle };
    let inside = real::sign(|precision| pair.inside(precision).0);
    let beyond = real::sign(|precision| pair.inside(precision).1);
    if inside.is_lt() || beyond.is_lt() {
        return None;
    }
    let touches = inside == Ordering::Equal || beyond == Ordering::Equal;
    Some(Reach::new(move |precision| pair.reach(touches, precision)))
}

impl Pair {
    /// r' − a and r' + a.
    fn inside(&self, precision: usize) -> (Interval, Interval) {
        let (z, x) = unit(&self.line.left(), precision);
        let aside = scalar_product(&self.circle.from_centre, &(z, x), precision);
        let aside = aside.add(&Interval::of(&self.offset, precision));
        let radius = self.circle.radius(&Exact::ONE, precision);
        (radius.sub(&aside), radius.add(&aside))
    }

    /// s·R·left(d) + τ·d, τ = −b ± √(r'² − a²) with the sign of b: the smaller of the two.
    fn reach(&self, touches: bool, precision: usize) -> (Interval, Interval) {
        let (z, x) = unit(&self.line, precision);
        let along_line = |distance: &Interval| (z.mul(distance), x.mul(distance));
        let across_line = |distance: &Interval| (x.mul(distance).neg(), z.mul(distance));
        let zero = Interval::of(&Exact::ZERO, precision);
        let (less, more) = self.inside(precision);
        let half_chord = if touches { zero } else { less.mul(&more).sqrt() };
        let back = scalar_product(&self.circle.from_centre, &(z.clone(), x.clone()), precision);
        let forward = self.circle.from_centre.dot(&self.line) > Exact::ZERO;
        let onward = if forward { half_chord.sub(&back) } else { half_chord.add(&back).neg() };
        sum(&across_line(&Interval::of(&self.offset, precision)), &along_line(&onward))
    }
}

fn scalar_product(one: &Vector, other: &(Interval, Interval), precision: usize) -> Interval {
    let (z, x) = (Interval::of(&one.z, precision), Interval::of(&one.x, precision));
    z.mul(&other.0).add(&x.mul(&other.1))
}
