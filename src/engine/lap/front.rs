//! The blank of mode V, lowered by multiples of D, against the rough contour: where the contour falls below it, and
//! where it meets the contour again (execution of LAP, 12; E100L-AP5-03, E100L-AP5-06).

use std::cmp::Ordering;

use crate::engine::exact::SlowPaths;
use crate::engine::fault::Fault;

use super::graph::{Graph, Joint, Span};
use super::meeting::{Coordinate, Meeting, meetings};
use super::outline::Element;
use super::plane::Axes;
use super::value::Value;

/// The blank with the level before it, and the contour.
#[derive(Debug)]
pub struct Front {
    axes: Axes,
    /// The elements of the blank, behind the level before it.
    pub elements: Vec<Element>,
    pub blank: Graph,
    pub contour: Graph,
    /// D, as a height.
    pub depth: i128,
    /// The run of the start of the contour as programmed, and the lowest height of the blank there.
    begin: i128,
    floor: i128,
}

/// A point in which the contour falls below the lowered blank.
#[derive(Clone, Copy, Debug)]
pub struct Leave {
    /// How many times D the blank is lowered.
    pub times: i64,
    pub point: Meeting,
    /// The span of the blank along which it goes on.
    pub blank: usize,
    /// The span of the contour behind it.
    pub contour: usize,
    /// Whether the elements in the joint before the span of the blank come first.
    pub at_joint: bool,
    /// Which of the meetings of both spans it is, if it is one.
    pub root: Option<usize>,
}

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
    /// more to which an arc leads.
    Joint { before: Option<Value>, low: i128, high: Option<i128> },
}

impl Wall {
    fn of(joint: &Joint, is_last: bool) -> Self {
        Self::Joint { before: joint.before, low: joint.low, high: (!is_last).then_some(joint.high) }
    }

    fn holds(&self, height: Value, slow: &mut SlowPaths) -> bool {
        match *self {
            Self::Point(value) => value.cmp(height, slow) == Ordering::Equal,
            Self::Joint { before, low, high } => {
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
            Self::Joint { before, low, high } => [before, Some(Value::whole(low)), high.map(Value::whole)],
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
    /// The blank, which begins in a level before the start of the contour, and the contour.
    pub fn new(
        axes: Axes,
        elements: Vec<Element>,
        (blank, contour): (Graph, Graph),
        depth: i128,
        begin: i128,
    ) -> Self {
        let at_begin = blank.joints.iter().find(|joint| joint.run == begin);
        let floor = at_begin.map_or(0, |joint| joint.low);
        Self { axes, elements, blank, contour, depth, begin, floor }
    }

    /// The height in which an element of the blank ends.
    pub(super) fn end_height(&self, element: &Element) -> i128 {
        self.axes.spot(element.to).height
    }

    /// How far the blank is lowered.
    pub fn drop(&self, times: i64) -> i128 {
        i128::from(times) * self.depth
    }

    /// The least multiple of D, at least one, that takes a height of the blank down to one of the contour.
    fn least_drop(&self, blank: Value, contour: Value, slow: &mut SlowPaths) -> i64 {
        let gap = blank.estimate() - contour.estimate();
        let mut times = multiple(gap, self.depth).max(1);
        let mut reaches = |times: i64| blank.plus(-self.drop(times)).cmp(contour, slow) != Ordering::Greater;
        while times > 1 && reaches(times - 1) {
            times -= 1;
        }
        while !reaches(times) {
            times += 1;
        }
        times
    }

    /// The lowest height of the blank at a run in a span of it.
    fn floor(&self, number: usize, run: i128, slow: &mut SlowPaths) -> Value {
        if run < self.begin {
            return Value::whole(self.floor);
        }
        match (self.blank.spans.get(number), self.blank.joints.get(number)) {
            (Some(span), Some(joint)) if span.from.run == run => lowest(joint, slow),
            (Some(span), _) => span.height(run),
            (None, Some(joint)) => lowest(joint, slow),
            (None, None) => Value::whole(self.floor),
        }
    }

    /// The span of the blank at and behind a run, from a span on.
    fn blank_at(&self, mut number: usize, run: i128) -> usize {
        while self.blank.spans.get(number).is_some_and(|span| span.to.run <= run) {
            number += 1;
        }
        number
    }

    /// The points where the contour is left along one of its elements without run, which stands in a joint.
    pub fn leaves_in_joint(
        &self,
        contour: usize,
        (from, to): (i128, i128),
        blank: usize,
        slow: &mut SlowPaths,
        leave: &mut impl FnMut(Leave) -> Result<(), Fault>,
    ) -> Result<usize, Fault> {
        let run = self.contour.joints.get(contour).map_or(0, |joint| joint.run);
        let blank = self.blank_at(blank, run);
        let at = Fall { run, contour, blank };
        self.leaves_in_fall(at, (Value::whole(from), to, None), slow, leave)?;
        Ok(blank)
    }

    /// The points where the contour is left along one of its spans, in order; the span of the blank that is reached,
    /// from one on.
    pub fn leaves(
        &self,
        contour: usize,
        blank: usize,
        slow: &mut SlowPaths,
        leave: &mut impl FnMut(Leave) -> Result<(), Fault>,
    ) -> Result<usize, Fault> {
        let Some(span) = self.contour.spans.get(contour) else { return Ok(blank) };
        let (mut run, mut number) = (span.from.run, self.blank_at(blank, span.from.run));
        while run < span.to.run {
            let Some(level) = self.level_at(number) else { break };
            let end = level.to.run.min(span.to.run);
            self.leaves_between((contour, span), (number, &level), (run, end), slow, leave)?;
            run = end;
            number = self.blank_at(number, run);
        }
        let reached = span.height(span.to.run);
        if reached.cmp_whole(span.to.height) == Ordering::Greater {
            // The end of an arc lies off its circle.
            let at = Fall { run: span.to.run, contour: contour + 1, blank: number };
            let end = span.to.height;
            self.leaves_in_fall(at, (reached, end, Some(end)), slow, leave)?;
        }
        Ok(number)
    }

    /// A span of the blank; before the start of the contour the lowest height there counts.
    fn level_at(&self, number: usize) -> Option<Span> {
        let span = self.blank.spans.get(number)?;
        if span.to.run > self.begin {
            return Some(*span);
        }
        let mut span = Span { circle: None, ..*span };
        (span.from.height, span.to.height) = (self.floor, self.floor);
        // The contour may begin before the level does.
        span.from.run =
            span.from.run.min(self.contour.joints.first().map_or(span.from.run, |joint| joint.run));
        Some(span)
    }

    /// Where the contour falls at one run from a height to another one; it is left there, or else in a point given.
    fn leaves_in_fall(
        &self,
        Fall { run, contour, blank }: Fall,
        (from, to, at): (Value, i128, Option<i128>),
        slow: &mut SlowPaths,
        leave: &mut impl FnMut(Leave) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        if from.cmp_whole(to) != Ordering::Greater {
            return Ok(());
        }
        let floor = self.floor(blank, run, slow);
        let mut times = self.least_drop(floor, from, slow);
        loop {
            let height = floor.plus(-self.drop(times));
            if height.cmp_whole(to) != Ordering::Greater {
                return Ok(());
            }
            let height = at.map_or(height, Value::whole);
            let point = Meeting { run: Coordinate::whole(run), height: Coordinate::Value(height) };
            leave(Leave { times, point, blank, contour, at_joint: true, root: None })?;
            times += 1;
        }
    }

    /// Where the contour falls below the lowered blank between two runs, the first one included.
    fn leaves_between(
        &self,
        (contour, span): (usize, &Span),
        (blank, level): (usize, &Span),
        (begin, end): (i128, i128),
        slow: &mut SlowPaths,
        leave: &mut impl FnMut(Leave) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let from = span.height(begin);
        let (above, floor) = (level.height(begin), self.floor(blank, begin, slow));
        let mut times = self.least_drop(floor, from, slow);
        loop {
            let order = from.cmp(above.plus(-self.drop(times)), slow);
            if order == Ordering::Greater {
                break;
            }
            let falls = order == Ordering::Less
                || self.course((span, level), (begin, end), times, slow).after == Ordering::Less;
            if falls {
                let point = Meeting { run: Coordinate::whole(begin), height: Coordinate::Value(from) };
                leave(Leave { times, point, blank, contour, at_joint: true, root: None })?;
            }
            if order == Ordering::Equal {
                break;
            }
            times += 1;
        }
        let (least, most) = self.crossing_drops((span, level), (begin, end));
        for times in least..=most {
            let course = self.course((span, level), (begin, end), times, slow);
            let mut side = course.after;
            for (root, point) in course.points.iter().enumerate() {
                let Some(point) = *point else { continue };
                let falls = if course.touch { side == Ordering::Less } else { side == Ordering::Greater };
                if falls {
                    let root = Some(root);
                    leave(Leave { times, point, blank, contour, at_joint: false, root })?;
                }
                side = if course.touch { side } else { side.reverse() };
            }
        }
        Ok(())
    }

    /// The multiples of D by which the blank, lowered, may cross the contour upward: those of the gap between them along
    /// the part in which that grows, of which there is one at most.
    #[allow(clippy::cast_precision_loss)]
    fn crossing_drops(&self, (span, level): (&Span, &Span), (begin, end): (i128, i128)) -> (i64, i64) {
        let (begin, end) = (begin as f64, end as f64);
        let gap = |run: f64| level.estimate(run) - span.estimate(run);
        let turn = span.parallel_to(level).filter(|run| begin < *run && *run < end);
        let gaps = [Some(gap(begin)), turn.map(gap), Some(gap(end))];
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut before = None;
        for gap in gaps.into_iter().flatten() {
            if let Some(before) = before.filter(|before| *before <= gap) {
                (least, most) = (least.min(before), most.max(gap));
            }
            before = Some(gap);
        }
        if least > most {
            return (1, 0);
        }
        (multiple(least, self.depth).saturating_sub(1).max(1), multiple(most, self.depth).saturating_add(1))
    }

    /// How the contour lies to the lowered blank behind the first of two runs, and where they meet between them.
    fn course(
        &self,
        (span, level): (&Span, &Span),
        (begin, end): (i128, i128),
        times: i64,
        slow: &mut SlowPaths,
    ) -> Course {
        let drop = self.drop(times);
        let mut side = |run: i128| span.height(run).cmp(level.height(run).plus(-drop), slow);
        let (first, last) = (side(begin), side(end));
        let all = meetings(span, level, drop);
        let points = all.between((span, level, drop), (begin, end), slow);
        let flips = if all.touch { 0 } else { points.iter().flatten().count() };
        let after = match (first, last) {
            (Ordering::Equal, Ordering::Equal) => {
                let sum = begin + end;
                span.twice_height(sum).cmp(level.twice_height(sum).plus(-2 * drop), slow)
            }
            (Ordering::Equal, last) if flips % 2 == 0 => last,
            (Ordering::Equal, last) => last.reverse(),
            (first, _) => first,
        };
        Course { after, points, touch: all.touch }
    }

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
    /// that which is also one of the contour.
    pub fn arrival(&self, leave: &Leave, slow: &mut SlowPaths) -> Arrival {
        let drop = self.drop(leave.times);
        let mut number = leave.blank;
        let mut contour = self.starting_span(leave);
        let mut low = leave.point.run;
        let mut is_first = true;
        let mut last = None;
        while let Some(span) = self.blank.spans.get(number) {
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
            let arrival = self.arrival_at((span, behind), (end, drop), wall, slow);
            match arrival {
                (Some(arrival), _) => return arrival,
                (None, reached) => last = Some(reached),
            }
            if is_end {
                break;
            }
            contour = next.or(contour);
            number += usize::from(ends);
            low = Coordinate::whole(end);
        }
        last.unwrap_or(Arrival { point: leave.point, element: 0 })
    }

    /// The span of the contour behind the beginning of a way; none before its start.
    fn starting_span(&self, leave: &Leave) -> Option<usize> {
        if leave.root.is_some() || leave.at_joint { Some(leave.contour) } else { None }
    }

    /// Whether the lowered blank arrives at the contour at a run, and else where it goes on from there.
    fn arrival_at(
        &self,
        (span, joint): (&Span, Option<&Joint>),
        (run, drop): (i128, i128),
        wall: Option<Wall>,
        slow: &mut SlowPaths,
    ) -> (Option<Arrival>, Arrival) {
        let arrival = |height: Value, element: usize| Arrival {
            point: Meeting { run: Coordinate::whole(run), height: Coordinate::Value(height) },
            element,
        };
        let height = span.height(run).plus(-drop);
        let mut reached = arrival(height, span.element);
        let holds = |height: Value, slow: &mut SlowPaths| wall.is_some_and(|wall| wall.holds(height, slow));
        if holds(height, slow) {
            return (Some(reached), reached);
        }
        let Some(joint) = joint else { return (None, reached) };
        let mut at = joint.first - drop;
        reached = arrival(Value::whole(at), span.element);
        if holds(Value::whole(at), slow) {
            return (Some(reached), reached);
        }
        for number in joint.elements.clone() {
            let Some(to) = self.elements.get(number).map(|element| self.end_height(element) - drop) else {
                continue;
            };
            if let Some(height) = wall.and_then(|wall| wall.first_on(at, to, slow)) {
                let found = arrival(height, number);
                return (Some(found), found);
            }
            at = to;
            reached = arrival(Value::whole(at), number);
        }
        (None, reached)
    }
}

/// Where the contour falls at one run.
#[derive(Clone, Copy, Debug)]
struct Fall {
    run: i128,
    /// The spans behind it.
    contour: usize,
    blank: usize,
}

/// How a span of the contour lies to one of the lowered blank.
#[derive(Clone, Copy, Debug)]
struct Course {
    /// Behind the first run: less when it is below.
    after: Ordering,
    points: [Option<Meeting>; 2],
    touch: bool,
}

/// The lowest of the points of a joint.
fn lowest(joint: &Joint, slow: &mut SlowPaths) -> Value {
    let low = Value::whole(joint.low);
    joint.before.map_or(low, |before| before.min(low, slow))
}

/// The first point in which spans meet behind a coordinate and before a run, behind one of their meetings if one is
/// given.
fn first_crossing(
    (contour, blank, drop): (&Span, &Span, i128),
    (low, end): (Coordinate, i128),
    skip: Option<usize>,
    slow: &mut SlowPaths,
) -> Option<Meeting> {
    let begin = contour.from.run.max(blank.from.run);
    let points = meetings(contour, blank, drop).between((contour, blank, drop), (begin, end), slow);
    let behind = points.into_iter().enumerate().filter(|(root, _)| skip.is_none_or(|skip| *root > skip));
    let mut behind = behind.filter_map(|(_, point)| point);
    match skip {
        Some(_) => behind.next(),
        None => behind.find(|point| point.run.cmp(low, slow) == Ordering::Greater),
    }
}

/// The least whole number of depths that is not less than a height, about.
#[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)]
fn multiple(height: f64, depth: i128) -> i64 {
    (height / depth.max(1) as f64).ceil() as i64
}
