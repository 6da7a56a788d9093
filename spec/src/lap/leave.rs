//! Where the contour falls below the blank moved by multiples of D (E100L-AP5-06; execution-lap.md, section 12).

use super::number::Number;
use super::plane::Place;
use super::shape::{Shape, place};
use crate::quantity::{Exact, whole};

/// The blank as heights are compared with it: in front of its start it has the height that it has there.
#[derive(Clone, Debug)]
pub struct Cover {
    shapes: Vec<Shape>,
}

/// A point in which the contour is left.
#[derive(Clone, Debug)]
pub struct Leave {
    /// The point.
    pub at: Place,
    /// By what multiple of D the blank is moved that it falls below there.
    pub multiple: i64,
}

/// A run at which it may be left.
struct Candidate {
    run: Number,
    /// Its value, if it is a run at which the blank or the contour changes.
    change: Option<Exact>,
}

impl Cover {
    /// The blank, with a level in front of it up to this run.
    pub fn new(blank: &[Shape], from: &Exact) -> Self {
        let mut shapes = blank.to_vec();
        let Some(first) = shapes.first() else { return Self { shapes } };
        let start = first.from.0.clone();
        if *from < start {
            let low = lowest_at(&shapes, &start).and_then(|low| low.rational().cloned());
            let height = low.unwrap_or_else(|| first.from.1.clone());
            let level = Shape { from: (from.clone(), height.clone()), to: (start, height), arc: None };
            shapes.insert(0, level);
        }
        Self { shapes }
    }

    /// The lowest height at a run, lowered.
    fn lowest(&self, run: &Exact, lowered: &Exact) -> Option<Number> {
        lowest_at(&self.shapes, run).map(|low| low.plus(&-lowered.clone()))
    }

    /// The height between two runs at which it changes.
    fn height_within(&self, run: &Exact, lowered: &Exact) -> Option<Number> {
        let shape = self.shapes.iter().find(|shape| shape.from.0 < *run && *run < shape.to.0)?;
        Some(shape.height_at(run).plus(&-lowered.clone()))
    }

    /// Bounds of its heights from one run to another.
    fn bounds(&self, from: &Exact, to: &Exact) -> Option<(Number, Number)> {
        let within = self.shapes.iter().filter(|shape| shape.to.0 >= *from && shape.from.0 <= *to);
        within
            .map(Shape::bounds)
            .reduce(|(low, high), (other_low, other_high)| (low.min(other_low), high.max(other_high)))
    }

    /// The points in which an element of the contour is left, in the order in which it is run through, and at one point in
    /// that of the multiples of `step`.
    pub fn leaves(&self, element: &Shape, step: &Exact) -> Vec<Leave> {
        let mut leaves = Vec::new();
        for multiple in self.multiples(element, step) {
            let lowered = whole(multiple) * step;
            let points = if element.is_wall() {
                self.on_wall(element, &lowered).into_iter().collect()
            } else {
                self.on_slope(element, &lowered)
            };
            leaves.extend(points.into_iter().map(|at| Leave { at, multiple }));
        }
        // The order of multiples is kept at one point.
        leaves.sort_by(|first, second| element.order(&first.at, &second.at));
        leaves
    }

    /// The multiples by which the moved blank can have heights of an element.
    fn multiples(&self, element: &Shape, step: &Exact) -> std::ops::RangeInclusive<i64> {
        let none = std::ops::RangeInclusive::new(1, 0);
        let Some((low, high)) = self.bounds(&element.from.0, &element.to.0) else { return none };
        let (lowest, highest) = element.bounds();
        // A nanometre or two more do not matter.
        let difference = |of: &Number, less: &Number| whole(of.nearest()) - whole(less.nearest());
        let first = ((difference(&low, &highest) - whole(2)) / step).ceil();
        let last = ((difference(&high, &lowest) + whole(2)) / step).floor();
        let narrow = |value| crate::quantity::narrow(&value).max(1);
        if last < dashu_int::IBig::ONE { none } else { narrow(first)..=narrow(last) }
    }

    /// On a wall that falls.
    fn on_wall(&self, element: &Shape, lowered: &Exact) -> Option<Place> {
        let low = self.lowest(&element.from.0, lowered)?;
        let height = |exact: &Exact| Number::from(exact.clone());
        let falls = height(&element.from.1) >= low && low > height(&element.to.1);
        falls.then(|| Place { run: element.from.0.clone().into(), height: low })
    }

    /// On an element with a run: behind each candidate it is looked whether the contour is below.
    fn on_slope(&self, element: &Shape, lowered: &Exact) -> Vec<Place> {
        let candidates = self.candidates(element, lowered);
        let end = Number::from(element.to.0.clone());
        let mut found = Vec::new();
        for (index, Candidate { run, change }) in candidates.iter().enumerate() {
            let next = candidates.get(index + 1).map_or(&end, |next| &next.run);
            let sample = run.between(next);
            let below = |run: &Exact, cover: Option<Number>| {
                cover.is_some_and(|cover| element.height_at(run) < cover)
            };
            if !below(&sample, self.height_within(&sample, lowered)) {
                continue;
            }
            match change {
                Some(exact) if below(exact, self.lowest(exact, lowered)) => {}
                Some(exact) => found.push(Place { run: run.clone(), height: element.height_at(exact) }),
                None => found.extend(self.crossing(element, run, lowered)),
            }
        }
        found.extend(self.in_loose_end(element, lowered));
        found
    }

    /// The runs of an element at which it may be left, in order.
    fn candidates(&self, element: &Shape, lowered: &Exact) -> Vec<Candidate> {
        let (from, to) = (&element.from.0, &element.to.0);
        let changes = self.shapes.iter().flat_map(|shape| [&shape.from.0, &shape.to.0]);
        let mut candidates: Vec<Candidate> = changes
            .filter(|run| from < *run && *run < to)
            .chain([from])
            .map(|run| Candidate { run: run.clone().into(), change: Some(run.clone()) })
            .collect();
        let (first, last) = (Number::from(from.clone()), Number::from(to.clone()));
        for point in self.shapes.iter().flat_map(|shape| element.common(&shape.lowered(lowered))) {
            if first < point.run && point.run < last {
                candidates.push(Candidate { run: point.run, change: None });
            }
        }
        // Changes stand before crossings at the same run.
        candidates.sort_by(|one, other| {
            one.run.cmp(&other.run).then(one.change.is_none().cmp(&other.change.is_none()))
        });
        candidates.dedup_by(|later, earlier| later.run == earlier.run);
        candidates
    }

    /// The common point at a run.
    fn crossing(&self, element: &Shape, run: &Number, lowered: &Exact) -> Option<Place> {
        let mut points = self.shapes.iter().flat_map(|shape| element.common(&shape.lowered(lowered)));
        points.find(|point| point.run == *run)
    }

    /// Where the end of an arc lies below its circle, and the contour falls there.
    fn in_loose_end(&self, element: &Shape, lowered: &Exact) -> Option<Place> {
        element.arc.as_ref()?;
        let low = self.lowest(&element.to.0, lowered)?;
        let falls = element.height_at(&element.to.0) >= low && low > Number::from(element.to.1.clone());
        falls.then(|| place(&element.to))
    }
}

/// The lowest height of elements at a run.
fn lowest_at(shapes: &[Shape], run: &Exact) -> Option<Number> {
    let at = |shape: &Shape| {
        if *run < shape.from.0 || *run > shape.to.0 {
            return None;
        }
        let ends = [(&shape.from, *run == shape.from.0), (&shape.to, *run == shape.to.0)];
        let of_ends =
            ends.into_iter().filter(|(_, here)| *here).map(|((_, height), _)| Number::from(height.clone()));
        let inner = (!shape.is_wall()).then(|| shape.height_at(run));
        of_ends.chain(inner).reduce(Number::min)
    };
    shapes.iter().filter_map(at).reduce(Number::min)
}
