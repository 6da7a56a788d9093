//! Where the contour falls below the blank moved by multiples of D (E100L-AP5-06; execution-lap.md, section 12).
//!
//! An element of the contour is looked at in phases, in each of which the multiples in question follow each other without
//! a gap, in the order of their points: between two runs at which the blank changes, the height of the contour over the
//! blank falls along one part at most.

use super::number::Number;
use super::plane::Place;
use super::shape::{Shape, place};
use crate::quantity::{Exact, narrow, whole};

/// The blank as heights are compared with it: in front of its start it has the height that it has there.
#[derive(Clone, Debug)]
pub struct Cover {
    shapes: Vec<Shape>,
    /// D as a height.
    step: Exact,
}

/// A point in which the contour is left.
#[derive(Clone, Debug)]
pub struct Leave {
    /// The point.
    pub at: Place,
    /// By what multiple of D the blank is moved that it falls below there.
    pub multiple: i64,
}

/// How far an element of the contour was looked at.
#[derive(Clone, Debug)]
pub struct Search {
    phases: Vec<Phase>,
    next: usize,
    /// The last multiple that was found in the phase.
    found: Option<i64>,
}

/// A part of an element of the contour.
#[derive(Clone, Debug)]
enum Phase {
    /// The whole of it, a wall.
    Wall,
    /// The run at which the blank changes, or the element begins; the next one.
    At(Exact, Exact),
    /// What lies between them.
    Within(Exact, Exact),
    /// The end of an arc, where it lies below its circle.
    LooseEnd,
}

impl Cover {
    /// The blank, with a level in front of it up to this run.
    pub fn new(blank: &[Shape], from: &Exact, step: Exact) -> Self {
        let mut shapes = blank.to_vec();
        if let Some(first) = blank.first().filter(|first| *from < first.from.0) {
            let start = first.from.0.clone();
            let low = lowest_at(blank, &start).and_then(|low| low.rational().cloned());
            let height = low.unwrap_or_else(|| first.from.1.clone());
            shapes.insert(0, Shape { from: (from.clone(), height.clone()), to: (start, height), arc: None });
        }
        Self { shapes, step }
    }

    /// Before anything of an element of the contour was looked at.
    pub fn search(&self, element: &Shape) -> Search {
        let (from, to) = (&element.from.0, &element.to.0);
        if element.is_wall() {
            return Search { phases: vec![Phase::Wall], next: 0, found: None };
        }
        let changes = self.shapes.iter().flat_map(|shape| [&shape.from.0, &shape.to.0]);
        let mut changes: Vec<&Exact> =
            changes.filter(|run| from < *run && *run < to).chain([from, to]).collect();
        changes.sort();
        changes.dedup();
        let pairs = changes.iter().zip(changes.iter().skip(1));
        let sections = pairs.flat_map(|(from, to)| {
            let (from, to): (Exact, Exact) = ((*from).clone(), (*to).clone());
            [Phase::At(from.clone(), to.clone()), Phase::Within(from, to)]
        });
        let phases = sections.chain(element.arc.is_some().then_some(Phase::LooseEnd)).collect();
        Search { phases, next: 0, found: None }
    }

    /// The next point in which an element of the contour is left.
    pub fn next(&self, element: &Shape, search: &mut Search) -> Option<Leave> {
        while let Some(phase) = search.phases.get(search.next) {
            let test = |multiple: i64| self.point(phase, element, multiple).map(|at| Leave { at, multiple });
            let leave = match search.found {
                Some(last) => last.checked_add(1).and_then(test),
                None => self.first(phase, element).and_then(test),
            };
            if let Some(leave) = leave {
                search.found = Some(leave.multiple);
                return Some(leave);
            }
            search.next += 1;
            search.found = None;
        }
        None
    }

    /// The first multiple of a phase.
    fn first(&self, phase: &Phase, element: &Shape) -> Option<i64> {
        let test = |multiple: &i64| self.point(phase, element, *multiple).is_some();
        let about = |guess: i64| guess.saturating_sub(2).max(1)..=guess.max(1).saturating_add(3);
        match phase {
            Phase::Wall => {
                let low = self.lowest(&element.from.0)?;
                about(self.multiple(&low, &element.from.1.clone().into())).find(test)
            }
            Phase::At(run, _) => {
                let low = self.lowest(run)?;
                about(self.multiple(&low, &element.height_at(run))).find(test)
            }
            Phase::LooseEnd => {
                let low = self.lowest(&element.to.0)?;
                about(self.multiple(&low, &element.height_at(&element.to.0))).find(test)
            }
            Phase::Within(from, to) => {
                // The contour is left near the height of one of the ends, if at all.
                let shape = self.shape_within(from, to)?;
                let at = |run: &Exact| self.multiple(&shape.height_at(run), &element.height_at(run));
                let one = about(at(from)).chain(about(at(to))).find(test)?;
                Some(least(one, test))
            }
        }
    }

    /// Which multiple of D lies between two heights, the whole ones below.
    fn multiple(&self, above: &Number, below: &Number) -> i64 {
        narrow(&((whole(above.nearest()) - whole(below.nearest())) / &self.step).floor())
    }

    /// The point of a phase in which the contour falls below the blank moved by a multiple of D.
    fn point(&self, phase: &Phase, element: &Shape, multiple: i64) -> Option<Place> {
        let lowered = whole(multiple) * &self.step;
        let low = |run: &Exact| self.lowest(run).map(|low| low.plus(&-lowered.clone()));
        match phase {
            Phase::Wall => {
                let low = low(&element.from.0)?;
                let height = |exact: &Exact| Number::from(exact.clone());
                let falls = height(&element.from.1) >= low && low > height(&element.to.1);
                falls.then(|| Place { run: element.from.0.clone().into(), height: low })
            }
            Phase::At(run, next) => {
                let height = element.height_at(run);
                let is_not_below = height >= low(run)?;
                let crossed = self.crossings(element, run, next, &lowered).into_iter().next();
                let behind = crossed.map_or_else(|| next.clone().into(), |point| point.run);
                let falls = is_not_below && self.is_below(element, &run.clone().into(), &behind, &lowered);
                falls.then(|| Place { run: run.clone().into(), height })
            }
            Phase::Within(from, to) => {
                let crossings = self.crossings(element, from, to, &lowered);
                let behind = crossings.iter().skip(1).map(|next| next.run.clone()).chain([to.clone().into()]);
                let mut found = crossings.iter().zip(behind);
                let (point, _) =
                    found.find(|(point, behind)| self.is_below(element, &point.run, behind, &lowered))?;
                Some(point.clone())
            }
            Phase::LooseEnd => {
                let low = low(&element.to.0)?;
                let falls = element.height_at(&element.to.0) >= low && low > element.to.1.clone().into();
                falls.then(|| place(&element.to))
            }
        }
    }

    /// The lowest height at a run.
    fn lowest(&self, run: &Exact) -> Option<Number> {
        lowest_at(&self.shapes, run)
    }

    /// The element of the blank between two runs at which it changes.
    fn shape_within(&self, from: &Exact, to: &Exact) -> Option<&Shape> {
        self.shapes.iter().find(|shape| !shape.is_wall() && shape.from.0 <= *from && *to <= shape.to.0)
    }

    /// Where an element of the contour meets the moved blank between two runs at which that changes, in order.
    fn crossings(&self, element: &Shape, from: &Exact, to: &Exact, lowered: &Exact) -> Vec<Place> {
        let Some(shape) = self.shape_within(from, to) else { return Vec::new() };
        let (from, to) = (Number::from(from.clone()), Number::from(to.clone()));
        let mut points = element.common(&shape.lowered(lowered));
        points.retain(|point| from < point.run && point.run < to);
        points.sort_by(|first, second| first.run.cmp(&second.run));
        points.dedup_by(|second, first| second.run == first.run);
        points
    }

    /// Whether an element of the contour lies below the moved blank between two runs between which they do not meet.
    fn is_below(&self, element: &Shape, from: &Number, to: &Number, lowered: &Exact) -> bool {
        let run = from.between(to);
        let within = self.shapes.iter().find(|shape| shape.from.0 < run && run < shape.to.0);
        within.is_some_and(|shape| element.height_at(&run) < shape.height_at(&run).plus(&-lowered.clone()))
    }
}

/// The least multiple from 1 to one that is in question from which on all are.
fn least(one: i64, test: impl Fn(&i64) -> bool) -> i64 {
    let (mut below, mut first) = (0, one);
    while first - below > 1 {
        let middle = below + (first - below) / 2;
        if test(&middle) { first = middle } else { below = middle }
    }
    first
}

/// The lowest height of elements at a run.
fn lowest_at(shapes: &[Shape], run: &Exact) -> Option<Number> {
    let at = |shape: &Shape| {
        if *run < shape.from.0 || *run > shape.to.0 {
            return None;
        }
        let ends = [(&shape.from, *run == shape.from.0), (&shape.to, *run == shape.to.0)];
        let of_ends = ends.into_iter().filter(|(_, here)| *here);
        let of_ends = of_ends.map(|((_, height), _)| Number::from(height.clone()));
        let inner = (!shape.is_wall()).then(|| shape.height_at(run));
        of_ends.chain(inner).reduce(Number::min)
    };
    shapes.iter().filter_map(at).reduce(Number::min)
}
