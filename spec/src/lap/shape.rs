//! Where elements meet (execution-lap.md, section 12): lines and arcs of the plane, and their common points.

use std::cmp::Ordering;

use super::contour::{Outline, is_clockwise};
use super::number::Number;
use super::plane::{Place, Plane, Spot};
use crate::quantity::{Exact, whole};

/// An exact point: run and height.
pub type Exactly = (Exact, Exact);

/// An element in the plane. Runs do not become less along it.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Where it begins.
    pub from: Exactly,
    /// Where it ends.
    pub to: Exactly,
    /// The circle through its beginning, if it is an arc: the part on its side of the centre, between the runs of its
    /// ends; its end need not lie on it.
    pub arc: Option<Round>,
}

/// The circle of an arc.
#[derive(Clone, Debug)]
pub struct Round {
    /// Run and height of its centre.
    pub centre: Exactly,
    /// The square of its radius.
    pub square: Exact,
    /// Whether the arc lies over the centre.
    pub over: bool,
}

impl Round {
    fn side(&self) -> Exact {
        if self.over { Exact::ONE } else { -Exact::ONE }
    }

    fn height_at(&self, run: &Exact) -> Number {
        let aside = run - &self.centre.0;
        Number::new(self.centre.1.clone(), self.side(), &self.square - &aside * &aside)
    }

    fn is_on_side(&self, height: &Number) -> bool {
        let middle = Number::from(self.centre.1.clone());
        if self.over { *height >= middle } else { *height <= middle }
    }

    /// Its highest point.
    fn top(&self) -> Place {
        let height = Number::new(self.centre.1.clone(), self.side(), self.square.clone());
        Place { run: self.centre.0.clone().into(), height }
    }
}

/// The elements of a contour or a blank.
pub fn shapes(outline: &Outline, plane: Plane) -> Vec<Shape> {
    let exactly = |spot: Spot| (plane.run(spot.cutting), plane.height(spot.infeed));
    let mut from = exactly(outline.start);
    let mut shapes = Vec::new();
    for element in &outline.elements {
        let to = exactly(element.end);
        let arc = element.arc.map(|(centre, sense)| {
            let centre = exactly(centre);
            let (aside, above) = (&from.0 - &centre.0, &from.1 - &centre.1);
            let square = &aside * &aside + &above * &above;
            Round { centre, square, over: is_clockwise(sense, plane) }
        });
        shapes.push(Shape { from: std::mem::replace(&mut from, to.clone()), to, arc });
    }
    shapes
}

/// The place of an exact point.
pub fn place((run, height): &Exactly) -> Place {
    Place { run: run.clone().into(), height: height.clone().into() }
}

impl Shape {
    /// Whether it has no run.
    pub fn is_wall(&self) -> bool {
        self.from.0 == self.to.0
    }

    /// The same, lower.
    pub fn lowered(&self, by: &Exact) -> Self {
        let lowered = |(run, height): &Exactly| (run.clone(), height - by);
        let arc = self.arc.as_ref().map(|arc| Round { centre: lowered(&arc.centre), ..arc.clone() });
        Self { from: lowered(&self.from), to: lowered(&self.to), arc }
    }

    /// The height at a run between those of its ends, if it is no wall.
    pub fn height_at(&self, run: &Exact) -> Number {
        if let Some(arc) = &self.arc {
            return arc.height_at(run);
        }
        let travel = &self.to.0 - &self.from.0;
        if travel.is_zero() {
            return self.from.1.clone().into();
        }
        (&self.from.1 + (run - &self.from.0) / travel * (&self.to.1 - &self.from.1)).into()
    }

    /// Which of two of its points comes first: at the run of its end a point of the circle before its end.
    pub fn order(&self, first: &Place, second: &Place) -> Ordering {
        if !self.is_wall() {
            let is_end = |point: &Place| self.loose_end().is_some_and(|end| end == *point);
            return first.run.cmp(&second.run).then_with(|| is_end(first).cmp(&is_end(second)));
        }
        let rising = first.height.cmp(&second.height);
        if self.to.1 < self.from.1 { rising.reverse() } else { rising }
    }

    /// The highest height between two of its points.
    pub fn highest(&self, from: &Place, to: &Place) -> Number {
        let ends = from.height.clone().max(to.height.clone());
        match &self.arc {
            Some(arc) if arc.over && from.run < arc.top().run && arc.top().run < to.run => {
                ends.max(arc.top().height)
            }
            _ => ends,
        }
    }

    /// The point of the arc that lies off its circle: its end.
    fn loose_end(&self) -> Option<Place> {
        self.arc.as_ref().map(|_| place(&self.to))
    }

    /// Whether a point with the run and height of one of the ends of an element lies on it.
    pub fn holds(&self, (run, height): &Exactly) -> bool {
        if *run < self.from.0 || *run > self.to.0 {
            return false;
        }
        if self.arc.is_none() && self.is_wall() {
            let (low, high) = ((&self.from.1).min(&self.to.1), (&self.from.1).max(&self.to.1));
            return low <= height && height <= high;
        }
        let is_end = (run, height) == (&self.to.0, &self.to.1);
        is_end || self.height_at(run) == Number::from(height.clone())
    }

    /// The points that two elements have in common; where they run along together, the ends of that part.
    pub fn common(&self, other: &Self) -> Vec<Place> {
        let mut points = match (&self.arc, &other.arc) {
            (None, None) => lines(self, other),
            (None, Some(arc)) => line_and_circle(self, arc),
            (Some(arc), None) => line_and_circle(other, arc),
            (Some(first), Some(second)) => circles(first, second),
        };
        if let (Some(first), Some(second)) = (&self.arc, &other.arc)
            && first.centre == second.centre
            && first.square == second.square
            && first.over == second.over
        {
            let (from, to) = ((&self.from.0).max(&other.from.0), (&self.to.0).min(&other.to.0));
            points.extend(
                [from, to].map(|run| Place { run: run.clone().into(), height: first.height_at(run) }),
            );
        }
        points.retain(|point| self.reaches(point) && other.reaches(point));
        points.extend(self.loose_end().filter(|_| other.holds(&self.to)));
        points.extend(other.loose_end().filter(|_| self.holds(&other.to)));
        points
    }

    /// Whether a point of its line or circle lies between its ends, on its side of the centre.
    fn reaches(&self, point: &Place) -> bool {
        let run = |exact: &Exact| Number::from(exact.clone());
        let within = point.run >= run(&self.from.0) && point.run <= run(&self.to.0);
        let (low, high) = ((&self.from.1).min(&self.to.1), (&self.from.1).max(&self.to.1));
        within
            && match &self.arc {
                Some(arc) => arc.is_on_side(&point.height),
                None => point.height >= run(low) && point.height <= run(high),
            }
    }
}

/// Where two lines meet; where they run along together, the ends of both.
fn lines(first: &Shape, second: &Shape) -> Vec<Place> {
    let direction = |shape: &Shape| (&shape.to.0 - &shape.from.0, &shape.to.1 - &shape.from.1);
    let cross = |a: &Exactly, b: &Exactly| &a.0 * &b.1 - &a.1 * &b.0;
    let (along, across) = (direction(first), direction(second));
    let between = (&second.from.0 - &first.from.0, &second.from.1 - &first.from.1);
    let turned = cross(&along, &across);
    if turned.is_zero() {
        if !cross(&between, &along).is_zero() || !cross(&between, &across).is_zero() {
            return Vec::new();
        }
        return [&first.from, &first.to, &second.from, &second.to].map(place).into();
    }
    let share = cross(&between, &across) / turned;
    vec![place(&(&first.from.0 + &share * &along.0, &first.from.1 + &share * &along.1))]
}

/// Where the line of an element meets a circle.
fn line_and_circle(line: &Shape, arc: &Round) -> Vec<Place> {
    let (aside, above) = (&line.from.0 - &arc.centre.0, &line.from.1 - &arc.centre.1);
    let (run, rise) = (&line.to.0 - &line.from.0, &line.to.1 - &line.from.1);
    // The share t of the way of the line: a t² + 2 b t + c = 0.
    let a = &run * &run + &rise * &rise;
    if a.is_zero() {
        return Vec::new();
    }
    let b = &aside * &run + &above * &rise;
    let c = &aside * &aside + &above * &above - &arc.square;
    let root = &b * &b - &a * c;
    if root < Exact::ZERO {
        return Vec::new();
    }
    let at = |sign: i32| {
        let coordinate = |from: &Exact, travel: &Exact| {
            Number::new(from - &b * travel / &a, whole(sign) * travel / &a, root.clone())
        };
        Place { run: coordinate(&line.from.0, &run), height: coordinate(&line.from.1, &rise) }
    };
    vec![at(1), at(-1)]
}

/// Where two circles meet that are not the same.
fn circles(first: &Round, second: &Round) -> Vec<Place> {
    let (run, rise) = (&second.centre.0 - &first.centre.0, &second.centre.1 - &first.centre.1);
    let square = &run * &run + &rise * &rise;
    if square.is_zero() {
        return Vec::new();
    }
    // The line through both points stands on that of the centres, at this share of it.
    let share = (&first.square - &second.square + &square) / (whole(2) * &square);
    let root = &first.square / &square - &share * &share;
    if root < Exact::ZERO {
        return Vec::new();
    }
    let at = |sign: i32| Place {
        run: Number::new(&first.centre.0 + &share * &run, whole(-sign) * &rise, root.clone()),
        height: Number::new(&first.centre.1 + &share * &rise, whole(sign) * &run, root.clone()),
    };
    vec![at(1), at(-1)]
}

#[cfg(test)]
mod tests {
    use super::{Exactly, Round, Shape};
    use crate::quantity::{ratio, whole};

    fn at(run: i64, height: i64) -> Exactly {
        (whole(run), whole(height))
    }

    fn line(from: Exactly, to: Exactly) -> Shape {
        Shape { from, to, arc: None }
    }

    fn arc(from: Exactly, to: Exactly, centre: Exactly, square: i64, over: bool) -> Shape {
        Shape { from, to, arc: Some(Round { centre, square: whole(square), over }) }
    }

    fn found(first: &Shape, second: &Shape) -> Vec<(i64, i64)> {
        let mut points: Vec<_> =
            first.common(second).iter().map(|point| (point.run.nearest(), point.height.nearest())).collect();
        points.sort_unstable();
        points.dedup();
        points
    }

    #[test]
    fn lines_meet_or_run_together() {
        let slope = line(at(0, 0), at(10, 10));
        assert_eq!(found(&slope, &line(at(0, 4), at(10, 4))), [(4, 4)]);
        assert_eq!(found(&slope, &line(at(3, -5), at(3, 5))), [(3, 3)]);
        assert_eq!(found(&slope, &line(at(3, 5), at(3, 9))), []);
        assert_eq!(found(&slope, &line(at(4, 4), at(20, 20))), [(4, 4), (10, 10)]);
        assert_eq!(found(&slope, &line(at(0, 1), at(10, 11))), []);
    }

    #[test]
    fn a_line_meets_the_side_of_a_circle_that_is_the_arc() {
        let over = arc(at(0, 0), at(10, 0), at(5, 0), 25, true);
        assert_eq!(found(&over, &line(at(-5, 4), at(15, 4))), [(2, 4), (8, 4)]);
        assert_eq!(found(&over, &line(at(-5, -4), at(15, -4))), []);
        assert_eq!(found(&line(at(5, -9), at(5, 9)), &over), [(5, 5)]);
        assert_eq!(found(&over, &line(at(0, 5), at(9, 5))), [(5, 5)]);
    }

    #[test]
    fn circles_meet_twice_or_run_together() {
        let over = arc(at(0, 0), at(10, 0), at(5, 0), 25, true);
        assert_eq!(found(&over, &arc(at(6, 0), at(16, 0), at(11, 0), 25, true)), [(8, 4)]);
        assert_eq!(found(&over, &arc(at(5, 5), at(10, 0), at(5, 0), 25, true)), [(5, 5), (10, 0)]);
        // Its end lies off its circle.
        let loose = arc(at(0, 0), (whole(10), ratio(1, 1)), at(5, 0), 25, true);
        assert_eq!(found(&loose, &line(at(10, 1), at(20, 1))), [(10, 1)]);
    }
}
