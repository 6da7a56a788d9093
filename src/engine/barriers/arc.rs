//! Whether an arc enters a rectangle (E100L-BARR-09, Arcs).
//!
//! Everything is counted from the centre in half nanometres: twice Z, and the diameter X. The circle meets the
//! line of an edge where one coordinate is a whole number and the other one the root of one, so that every sign
//! is decided exactly. Directions are at most 2^60 in size.

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::Sense;

use crate::engine::arithmetic::plane::{Direction, Point, bounded, difference, dot, square, tangent};
use crate::engine::arithmetic::rectangle::Rectangle;
use crate::engine::arithmetic::surd::sign;
use crate::engine::planted::{self, Bug};

/// The path of an arc: on the circle through its start up to the ray from the centre through its end, and the
/// end itself.
#[derive(Clone, Copy, Debug)]
pub struct Sweep {
    pub from: Point,
    pub to: Point,
    pub centre: Point,
    pub sense: Sense,
}

/// A sweep about the centre as origin.
struct Turn {
    start: Direction,
    end: Direction,
    /// 1 counter-clockwise, -1 clockwise.
    sense: i128,
}

/// A coordinate that is a whole number and a number of roots.
type Coordinate = (i128, i128);

/// A point of the circle on the line of an edge.
struct Crossing {
    z: Coordinate,
    x: Coordinate,
    /// What the root is taken of.
    square: i128,
}

/// The bounds of a rectangle along one axis.
type Bounds = (i128, i128);

impl Sweep {
    /// Whether it has a point in the rectangle.
    pub fn enters(&self, rectangle: &Rectangle) -> bool {
        if rectangle.contains(self.from) || rectangle.contains(self.to) {
            return true;
        }
        let [start, end] = [self.from, self.to].map(|point| bounded(difference(point, self.centre)));
        let counter = (self.sense == Sense::CounterClockwise) != planted::is(Bug::SweepSense);
        let sense = if counter { 1 } else { -1 };
        let turn = Turn { start, end, sense };
        if !turn.has_length() {
            return false;
        }
        let [low, high] = [(rectangle.x.0, rectangle.z.0), (rectangle.x.1, rectangle.z.1)]
            .map(|(x, z)| difference(Point { x, z }, self.centre));
        let (z, x) = ((low.0, high.0), (low.1, high.1));
        let on_z = [z.0, z.1].map(|edge| (edge, true));
        let on_x = [x.0, x.1].map(|edge| (edge, false));
        on_z.into_iter().chain(on_x).any(|(edge, of_z)| {
            [-1, 1].into_iter().any(|side| {
                Crossing::new(square(start), edge, of_z, side)
                    .is_some_and(|point| point.leads_inside(sense, z, x) && turn.covers(&point))
            })
        })
    }
}

impl Turn {
    /// Whether it leaves its start: its end lies neither on the ray from the centre through it nor in the centre.
    fn has_length(&self) -> bool {
        self.place_of_end() != Place { beyond: false, across: Ordering::Equal }
    }

    /// Whether a point of the circle is passed, the start included and the end excluded.
    fn covers(&self, point: &Crossing) -> bool {
        let across = tangent(self.start, self.sense);
        let place = Place::new(point.along(across), point.along(self.start));
        match (place.beyond, self.place_of_end().beyond) {
            _ if planted::is(Bug::WholeCircle) => true,
            (false, true) => true,
            (true, false) => false,
            // Both in one half of the turn: the point is passed first if the end lies ahead of it.
            _ => point.along(tangent(self.end, self.sense)) == Ordering::Less,
        }
    }

    fn place_of_end(&self) -> Place {
        let across = dot(tangent(self.start, self.sense), self.end);
        Place::new(across.cmp(&0), dot(self.start, self.end).cmp(&0))
    }
}

/// Where a direction lies in the turn from the start.
#[derive(PartialEq, Eq)]
struct Place {
    /// Half a turn or more away.
    beyond: bool,
    /// On which side of the line through start and centre: ahead is greater.
    across: Ordering,
}

impl Place {
    /// From the signs of a direction across the start and along it.
    fn new(across: Ordering, along: Ordering) -> Self {
        Self { beyond: across.then(along) == Ordering::Less, across }
    }
}

impl Crossing {
    /// Where the circle meets the line of an edge of Z or X, on one side; none if it does not.
    fn new(radius_square: i128, edge: i128, of_z: bool, side: i128) -> Option<Self> {
        let square = radius_square - edge.checked_mul(edge)?;
        let (whole, root) = ((edge, 0), (0, side));
        let (z, x) = if of_z { (whole, root) } else { (root, whole) };
        (square >= 0).then_some(Self { z, x, square })
    }

    /// The sign of its scalar product with a direction.
    fn along(&self, (z, x): Direction) -> Ordering {
        sign(z * self.z.0 + x * self.x.0, z * self.z.1 + x * self.x.1, self.square)
    }

    /// Whether it lies on the edge of a rectangle, and the arc goes on from it into the inside.
    fn leads_inside(&self, sense: i128, z: Bounds, x: Bounds) -> bool {
        let travel = |axis: Direction| self.along(tangent(axis, -sense));
        self.goes_in(self.z, z, travel((1, 0))) && self.goes_in(self.x, x, travel((0, 1)))
    }

    /// Whether a coordinate is between its bounds, or on one of them and goes on to its inner side: by the
    /// travel, or along it if the centre is there.
    fn goes_in(&self, (whole, roots): Coordinate, (low, high): Bounds, travel: Ordering) -> bool {
        let against = |bound: i128| sign(whole - bound, roots, self.square);
        match (against(low), against(high)) {
            (Ordering::Greater, Ordering::Less) => true,
            (Ordering::Equal, _) => travel.then(0.cmp(&low)) == Ordering::Greater,
            (_, Ordering::Equal) => travel.then(0.cmp(&high)) == Ordering::Less,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Point, Rectangle, Sense, Sweep};

    /// How deep points of the sweep lie inside at most, in half nanometres, by many of them.
    fn depth(sweep: &Sweep, rectangle: &Rectangle) -> f64 {
        let turn = if sweep.sense == Sense::CounterClockwise { 1.0 } else { -1.0 };
        let polar = |point: Point| {
            let (z, x) = (2 * (point.z - sweep.centre.z), point.x - sweep.centre.x);
            let (z, x) = (z as f64, x as f64);
            (z.hypot(x), turn * x.atan2(z))
        };
        let ((radius, start), (reach, end)) = (polar(sweep.from), polar(sweep.to));
        let full = std::f64::consts::TAU;
        let angle = if reach == 0.0 { 0.0 } else { (end - start + 1e-9).rem_euclid(full) - 1e-9 };
        let inside = |z: f64, x: f64| {
            let bounds =
                [2 * rectangle.z.0, 2 * rectangle.z.1, rectangle.x.0, rectangle.x.1].map(|b| b as f64);
            (z - bounds[0]).min(bounds[1] - z).min(x - bounds[2]).min(bounds[3] - x)
        };
        let last = inside(2.0 * sweep.to.z as f64, sweep.to.x as f64);
        (0..=2000).fold(last, |most, step| {
            let angle = turn * (start + angle * f64::from(step) / 2000.0);
            let z = 2.0 * sweep.centre.z as f64 + radius * angle.cos();
            let x = sweep.centre.x as f64 + radius * angle.sin();
            most.max(inside(z, x))
        })
    }

    #[test]
    fn sweeps_about_a_rectangle() {
        let rectangle = Rectangle { z: (-1, 2), x: (1, 5) };
        let points: Vec<Point> =
            (-3..=3).flat_map(|z| [-4, -1, 1, 3, 5, 6].map(|x| Point { x, z })).collect();
        let mut entered = [0; 2];
        for centre in [(0, 0), (0, 3), (-1, 1), (2, 1), (-1, -4), (4, 5), (1, 9)].map(|(z, x)| Point { x, z })
        {
            for (from, to) in points.iter().flat_map(|from| points.iter().map(move |to| (*from, *to))) {
                for sense in [Sense::Clockwise, Sense::CounterClockwise] {
                    let sweep = Sweep { from, to, centre, sense };
                    let found = sweep.enters(&rectangle);
                    let depth = depth(&sweep, &rectangle);
                    assert_eq!(found, depth > 1e-9, "{sweep:?} {depth}");
                    entered[usize::from(found)] += 1;
                }
            }
        }
        assert!(entered.iter().all(|count| *count > 1000), "{entered:?}");
    }

    #[test]
    fn nothing_overflows() {
        let rectangle = Rectangle { z: (-10, 10), x: (-10, 10) };
        let [from, to] = [(i64::MIN, 0), (i64::MAX, 1)].map(|(z, x)| Point { x, z });
        let centre = Point { x: i64::MAX, z: i64::MAX };
        assert!(!Sweep { from, to, centre, sense: Sense::Clockwise }.enters(&rectangle));
    }
}
