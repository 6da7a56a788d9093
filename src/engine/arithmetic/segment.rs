//! Whether a straight path enters a rectangle (E100L-BARR-09, Lines).
//!
//! Two convex sets, one of them open, are apart exactly if a line along one of their sides parts them.

use super::plane::{Point, bounded, cross, difference};
use super::rectangle::Rectangle;

/// Whether the segment between two points, both included, has a point in the rectangle.
#[must_use]
pub fn enters(from: Point, to: Point, rectangle: &Rectangle) -> bool {
    if is_beside(from, to, rectangle) {
        return false;
    }
    if from == to {
        return true;
    }
    let along = bounded(difference(to, from));
    let sides = rectangle.corners().map(|corner| cross(along, bounded(difference(corner, from))));
    straddles(sides)
}

/// Whether the line of an edge parts a segment from the rectangle.
#[must_use]
pub fn is_beside(from: Point, to: Point, rectangle: &Rectangle) -> bool {
    let beside = |a: i64, b: i64, (low, high): (i64, i64)| a.max(b) <= low || a.min(b) >= high;
    beside(from.z, to.z, rectangle.z) || beside(from.x, to.x, rectangle.x)
}

/// Whether corners lie on both sides of a line.
#[must_use]
pub fn straddles(sides: [i128; 4]) -> bool {
    sides.iter().any(|side| *side > 0) && sides.iter().any(|side| *side < 0)
}

#[cfg(test)]
mod tests {
    use super::{Point, Rectangle, enters};

    /// The half-lines of t of the rule, for small numbers.
    fn by_conditions(from: Point, to: Point, rectangle: &Rectangle) -> bool {
        // Twice the least common multiple of all differences up to 6, and all steps between.
        const STEPS: i64 = 120;
        (0..=STEPS).any(|step| {
            let at = |from: i64, to: i64| STEPS * from + step * (to - from);
            let (low, high) = rectangle.z;
            let (below, above) = rectangle.x;
            let (z, x) = (at(from.z, to.z), at(from.x, to.x));
            STEPS * low < z && z < STEPS * high && STEPS * below < x && x < STEPS * above
        })
    }

    #[test]
    fn segments_about_a_rectangle() {
        let rectangle = Rectangle { z: (-1, 2), x: (0, 2) };
        let points: Vec<Point> = (-3..=3).flat_map(|z| (-2..=3).map(move |x| Point { x, z })).collect();
        for from in &points {
            for to in &points {
                let expected = by_conditions(*from, *to, &rectangle);
                assert_eq!(enters(*from, *to, &rectangle), expected, "{from:?} {to:?}");
            }
        }
    }

    #[test]
    fn nothing_overflows() {
        let far = |x, z| Point { x, z };
        let rectangle = Rectangle { z: (-10, 10), x: (-10, 10) };
        assert!(enters(far(0, i64::MIN), far(0, i64::MAX), &rectangle));
        assert!(!enters(far(i64::MIN, i64::MIN), far(i64::MIN, i64::MAX), &rectangle));
    }
}
