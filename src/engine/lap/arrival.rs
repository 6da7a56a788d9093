//! Along the blank of mode V, lowered, to where it meets the rough contour (execution of LAP, 12; E100L-AP5-03,
//! E100L-AP5-06).

use std::cmp::Ordering;

use crate::engine::exact::SlowPaths;
use crate::engine::planted::{self, Bug};

use super::front::{Front, Leave};
use super::graph::{Graph, Joint, Span};
use super::meeting::{Coordinate, Meeting, Meetings};
use super::value::Value;

/// Where a way along the lowered blank ends.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    pub point: Meeting,
    /// The element of the blank in which it ends.
    pub element: usize,
}

/// What of the contour lies at a run.
#[derive(Clone, Copy, Debug)]
enum Wall {
    /// One point.
    Point(Value),
    /// The points of a joint from its lowest to its highest one, without end above at the end of the contour, and one
    /// more to which an arc leads; the bounds of all.
    Joint { before: Option<Value>, low: i128, high: Option<i128>, bounds: (i128, i128) },
}

impl Wall {
    fn of(joint: &Joint, is_last: bool) -> Self {
        let Joint { before, low, high, bounds, .. } = *joint;
        Self::Joint { before, low, high: (!is_last).then_some(high), bounds }
    }

    fn holds(&self, height: Value, slow: &mut SlowPaths) -> bool {
        match *self {
            Self::Point(value) => value.cmp(height, slow) == Ordering::Equal,
            Self::Joint { before, low, high, bounds } => {
                if height.cmp_whole(bounds.0) == Ordering::Less
                    || high.is_some() && height.cmp_whole(bounds.1) == Ordering::Greater
                {
                    return false;
                }
                let inside = height.cmp_whole(low) != Ordering::Less
                    && high.is_none_or(|high| height.cmp_whole(high) != Ordering::Greater);
                inside || before.is_some_and(|before| before.cmp(height, slow) == Ordering::Equal)
            }
        }
    }

    /// The first of its points on the way from a height that it does not hold straight to another one.
    fn first_on(&self, from: i128, to: i128, slow: &mut SlowPaths) -> Option<Value> {
        let values = match *self {
            Self::Point(value) => [Some(value), None, None],
            Self::Joint { before, low, high, .. } => {
                [before, Some(Value::whole(low)), high.map(Value::whole)]
            }
        };
        let rises = to > from;
        let on_way = |value: &Value| {
            let (begin, end) = (value.cmp_whole(from), value.cmp_whole(to));
            if rises {
                begin == Ordering::Greater && end != Ordering::Greater
            } else {
                begin == Ordering::Less && end != Ordering::Less
            }
        };
        let found = values.into_iter().flatten().filter(on_way);
        found.reduce(|first, next| if rises { first.min(next, slow) } else { first.max(next, slow) })
    }
}

impl Front {
    /// The element of the blank with which the way from a point goes on.
    pub fn first_element(&self, leave: &Leave, slow: &mut SlowPaths) -> usize {
        let span = self.blank.spans.get(leave.blank).map_or(0, |span| span.element);
        let Some(joint) = self.blank.joints.get(leave.blank).filter(|_| leave.at_joint) else { return span };
        if leave.point.run != Coordinate::whole(joint.run) {
            return span;
        }
        let drop = self.drop(leave.times);
        let rises = |number: &usize| {
            let end = self.elements.get(*number).map(|element| self.end_height(element) - drop);
            end.is_some_and(|end| leave.point.height.cmp_whole(end, slow) == Ordering::Less)
        };
        joint.elements.clone().find(rises).unwrap_or(span)
    }

    /// The way along the lowered blank from where the contour was left, or from its beginning: the first point behind
    /// that which is also one of the contour; its beginning too, on a wall in which the contour begins.
    pub fn arrival(&self, leave: &Leave, slow: &mut SlowPaths) -> Arrival {
        let drop = self.drop(leave.times);
        let mut number = leave.blank;
        let mut contour = self.starting_span(leave);
        if contour.is_none() && self.begins_at(leave.point, slow) && !planted::is(Bug::WallEntered) {
            return Arrival { point: leave.point, element: 0 };
        }
        let mut low = leave.point.run;
        let mut is_first = true;
        let mut last = None;
        while let Some(span) = self.blank.spans.get(number) {
            let passed = contour.map(|contour| self.first_near(contour, (span, drop)));
            if let Some(joint) =
                passed.filter(|_| passed != contour).and_then(|at| self.contour.joints.get(at))
            {
                (contour, low, is_first) = (passed, Coordinate::whole(joint.run), false);
            }
            let piece = contour.and_then(|contour| self.contour.spans.get(contour));
            let end = match (contour, piece) {
                (_, Some(piece)) => piece.to.run.min(span.to.run),
                (None, None) => {
                    self.contour.joints.first().map_or(span.to.run, |joint| joint.run.min(span.to.run))
                }
                (Some(_), None) => break,
            };
            if let Some(piece) = piece {
                let skip = leave.root.filter(|_| is_first);
                if let Some(point) = first_crossing((piece, span, drop), (low, end), skip, slow) {
                    return Arrival { point, element: span.element };
                }
            }
            is_first = false;
            let next = match contour {
                None => self.contour.joints.first().filter(|joint| joint.run == end).map(|_| 0),
                Some(contour) => piece.filter(|piece| piece.to.run == end).map(|_| contour + 1),
            };
            let is_end = next.is_some_and(|next| next + 1 >= self.contour.joints.len());
            let wall = match (next.and_then(|next| self.contour.joints.get(next)), piece) {
                (Some(joint), _) => Some(Wall::of(joint, is_end)),
                (None, Some(piece)) => Some(Wall::Point(piece.height(end))),
                (None, None) => None,
            };
            // Where it begins it does not arrive.
            let wall = wall.filter(|_| low != Coordinate::whole(end));
            let ends = span.to.run == end;
            let behind = self.blank.joints.get(number + 1).filter(|_| ends);
            let reached = self.reached_at((span, behind), (end, drop), wall, slow);
            if reached.arrives {
                return reached.at(end);
            }
            last = Some((reached, end));
            if is_end {
                break;
            }
            contour = next.or(contour);
            number += usize::from(ends);
            low = Coordinate::whole(end);
        }
        last.map_or(Arrival { point: leave.point, element: 0 }, |(reached, run)| reached.at(run))
    }

    /// The first span of the contour, from one on, along which or behind which it may meet a span of the lowered blank;
    /// the last one, or the one in which that ends, at the latest. Bounds say nothing before the span of the blank.
    fn first_near(&self, mut contour: usize, (span, drop): (&Span, i128)) -> usize {
        let Graph { spans, joints } = &self.contour;
        while let (Some(piece), Some(joint)) = (spans.get(contour), joints.get(contour + 1)) {
            let is_last = contour + 1 >= spans.len() || piece.to.run >= span.to.run;
            let is_before = piece.to.run < span.from.run;
            if is_last
                || is_before
                || !span.is_apart(piece.bounds, drop)
                || !span.is_apart(joint.bounds, drop)
            {
                break;
            }
            contour += 1;
        }
        contour
    }

    /// The span of the contour behind the beginning of a way; none before its start.
    fn starting_span(&self, leave: &Leave) -> Option<usize> {
        if leave.root.is_some() || leave.at_joint { Some(leave.contour) } else { None }
    }

    /// Whether a point lies on the wall in which the contour begins.
    fn begins_at(&self, point: Meeting, slow: &mut SlowPaths) -> bool {
        let joint = self.contour.joints.first().filter(|joint| point.run == Coordinate::whole(joint.run));
        let (Some(joint), Coordinate::Value(height)) = (joint, point.height) else { return false };
        Wall::of(joint, false).holds(height, slow)
    }

    /// How far the way along the lowered blank leads at a run.
    fn reached_at(
        &self,
        (span, joint): (&Span, Option<&Joint>),
        (run, drop): (i128, i128),
        wall: Option<Wall>,
        slow: &mut SlowPaths,
    ) -> Reached {
        let holds = |height: Value, slow: &mut SlowPaths| wall.is_some_and(|wall| wall.holds(height, slow));
        let height = span.height(run).plus(-drop);
        let arrives = holds(height, slow);
        let mut reached = Reached { height, element: span.element, arrives };
        let Some(joint) = joint.filter(|_| !arrives) else { return reached };
        let mut at = joint.first - drop;
        reached.height = Value::whole(at);
        reached.arrives = holds(reached.height, slow);
        if reached.arrives {
            return reached;
        }
        for number in joint.elements.clone() {
            let Some(to) = self.elements.get(number).map(|element| self.end_height(element) - drop) else {
                continue;
            };
            if let Some(height) = wall.and_then(|wall| wall.first_on(at, to, slow)) {
                return Reached { height, element: number, arrives: true };
            }
            at = to;
            reached = Reached { height: Value::whole(at), element: number, arrives: false };
        }
        reached
    }
}

/// How far a way along the lowered blank leads at a run.
struct Reached {
    height: Value,
    element: usize,
    /// Whether it arrives at the contour there; else it goes on.
    arrives: bool,
}

impl Reached {
    /// As the end of the way.
    fn at(self, run: i128) -> Arrival {
        let point = Meeting { run: Coordinate::whole(run), height: Coordinate::Value(self.height) };
        Arrival { point, element: self.element }
    }
}

/// The first point in which spans meet behind a coordinate and before a run, behind one of their meetings if one is
/// given.
fn first_crossing(
    (contour, blank, drop): (&Span, &Span, i128),
    (low, end): (Coordinate, i128),
    skip: Option<usize>,
    slow: &mut SlowPaths,
) -> Option<Meeting> {
    if blank.is_apart(contour.bounds, drop) {
        return None;
    }
    let begin = contour.from.run.max(blank.from.run);
    let found = Meetings::between((contour, blank, drop), (begin, end), slow);
    let behind =
        found.points.into_iter().enumerate().filter(|(root, _)| skip.is_none_or(|skip| *root > skip));
    let mut behind = behind.filter_map(|(_, point)| point);
    match skip {
        Some(_) => behind.next(),
        None => behind.find(|point| point.run.cmp(low, slow) == Ordering::Greater),
    }
}
