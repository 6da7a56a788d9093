//! K: the blank moved by a multiple of D, and where it meets the contour (execution-lap.md, section 12).

use super::number::Number;
use super::plane::Place;
use super::shape::{Exactly, Shape, place};
use crate::quantity::Exact;

/// The rough contour as K meets it.
#[derive(Clone, Debug)]
pub struct Target {
    /// Its elements.
    pub shapes: Vec<Shape>,
    /// G'.
    pub end: Exactly,
}

/// The blank moved, with the level in front of it; the elements have the numbers of those of the blank, 1 more.
#[derive(Clone, Debug)]
pub struct Track {
    shapes: Vec<(usize, Shape)>,
}

/// A part of an element of K that is cut.
#[derive(Clone, Debug)]
pub struct Leg {
    /// The number of the element of the blank; none for the level in front.
    pub element: Option<usize>,
    /// Where it ends.
    pub to: Place,
}

/// A cut along K.
#[derive(Clone, Debug)]
pub struct Path {
    /// Its parts.
    pub legs: Vec<Leg>,
    /// Its highest height.
    pub highest: Number,
}

impl Track {
    /// The blank lowered by so much, with a level of this length in front.
    pub fn new(blank: &[Shape], lowered: &Exact, front: &Exact) -> Self {
        let mut shapes: Vec<_> = (1..).zip(blank.iter().map(|shape| shape.lowered(lowered))).collect();
        if let Some((_, first)) = shapes.first().filter(|_| !front.is_zero()) {
            let to = first.from.clone();
            let from = (&to.0 - front, to.1.clone());
            shapes.insert(0, (0, Shape { from, to, arc: None }));
        }
        Self { shapes }
    }

    /// Where it begins.
    pub fn start(&self) -> Option<Place> {
        self.shapes.first().map(|(_, first)| place(&first.from))
    }

    /// From its beginning to where it meets the contour, which may be there already.
    pub fn whole(&self, target: &Target) -> Option<Path> {
        let (_, first) = self.shapes.first()?;
        let start = place(&first.from);
        if target.shapes.iter().any(|shape| shape.holds(&first.from)) {
            return Some(Path { legs: Vec::new(), highest: start.height });
        }
        Some(self.path(&start, 0, target))
    }

    /// From one of its points on to where it meets the contour behind the run of that.
    pub fn behind(&self, from: &Place, target: &Target) -> Path {
        self.path(from, self.element_of(from), target)
    }

    fn path(&self, from: &Place, begin: usize, target: &Target) -> Path {
        let mut path = Path { legs: Vec::new(), highest: from.height.clone() };
        let mut present = from.clone();
        for (index, (number, shape)) in self.shapes.iter().enumerate().skip(begin) {
            let met = target.first_common(shape, from);
            let last = met.clone().or_else(|| self.last_of(index, target));
            let ends = last.is_some();
            let to = last.unwrap_or_else(|| place(&shape.to));
            let highest = shape.highest(&present, &to);
            path.highest = path.highest.max(highest);
            path.legs.push(Leg { element: number.checked_sub(1), to: to.clone() });
            if ends {
                break;
            }
            present = to;
        }
        path
    }

    /// The element on which a point lies: a wall with its height, or the first one that leads on behind its run.
    fn element_of(&self, point: &Place) -> usize {
        let run = |exact: &Exact| Number::from(exact.clone());
        let holds = |shape: &Shape| {
            if shape.is_wall() {
                let rises = shape.to.1 > shape.from.1;
                let (low, high) = (run(&shape.from.1), run(&shape.to.1));
                rises && point.run == run(&shape.from.0) && low <= point.height && point.height <= high
            } else {
                point.run < run(&shape.to.0)
            }
        };
        self.shapes.iter().position(|(_, shape)| holds(shape)).unwrap_or(self.shapes.len())
    }

    /// Should K not meet the contour: its last point with no more run than G', if that lies on this element.
    fn last_of(&self, index: usize, target: &Target) -> Option<Place> {
        let (_, shape) = self.shapes.get(index)?;
        let end = &target.end.0;
        if shape.to.0 > *end {
            return Some(Place { run: end.clone().into(), height: shape.height_at(end) });
        }
        let next = self.shapes.get(index + 1);
        next.is_none_or(|(_, next)| next.from.0 == *end && !next.is_wall()).then(|| place(&shape.to))
    }
}

impl Target {
    /// The first point of an element of K that is one of the contour too, or of the half-line that rises from G', with
    /// more run than the point from which it is looked at.
    fn first_common(&self, shape: &Shape, from: &Place) -> Option<Place> {
        let mut points: Vec<Place> = self.shapes.iter().flat_map(|other| shape.common(other)).collect();
        points.extend(self.on_half_line(shape));
        points.retain(|point| point.run > from.run);
        points.into_iter().min_by(|first, second| shape.order(first, second))
    }

    fn on_half_line(&self, shape: &Shape) -> Vec<Place> {
        let (end, bottom) = (&self.end.0, Number::from(self.end.1.clone()));
        if shape.from.0 > *end || shape.to.0 < *end {
            return Vec::new();
        }
        let mut points = vec![place(&shape.from), place(&shape.to), place(&self.end)];
        if shape.is_wall() {
            let (low, high) = ((&shape.from.1).min(&shape.to.1), (&shape.from.1).max(&shape.to.1));
            points.retain(|point| {
                point.height >= Number::from(low.clone()) && point.height <= Number::from(high.clone())
            });
        } else {
            points.retain(|point| *point == place(&shape.to));
            points.push(Place { run: end.clone().into(), height: shape.height_at(end) });
        }
        points.retain(|point| point.run == Number::from(end.clone()) && point.height >= bottom);
        points
    }
}
