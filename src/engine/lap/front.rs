//! The blank of mode V, lowered by multiples of D, against the rough contour: where the contour falls below it (execution
//! of LAP, 12; E100L-AP5-06).

use std::cmp::Ordering;

use crate::engine::exact::SlowPaths;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::graph::{Graph, Joint, Span};
use super::meeting::{Coordinate, Meeting, Meetings};
use super::outline::Element;
use super::plane::{Axes, Spot};
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
        // The contour may begin before the level does.
        let begin = self.contour.joints.first().map_or(span.from.run, |joint| joint.run);
        let at = |run: i128| Spot { run, height: self.floor };
        Some(Span::new(span.element, (at(span.from.run.min(begin)), at(span.to.run)), None))
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
            if planted::is(Bug::WallLeftOnce) {
                return Ok(());
            }
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
        let Meetings { points, touch } = Meetings::between((span, level, drop), (begin, end), slow);
        let flips = if touch { 0 } else { points.iter().flatten().count() };
        let after = match (first, last) {
            (Ordering::Equal, Ordering::Equal) => {
                let sum = begin + end;
                span.twice_height(sum).cmp(level.twice_height(sum).plus(-2 * drop), slow)
            }
            (Ordering::Equal, last) if flips % 2 == 0 => last,
            (Ordering::Equal, last) => last.reverse(),
            (first, _) => first,
        };
        Course { after, points, touch }
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

/// The least whole number of depths that is not less than a height, about.
#[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)]
fn multiple(height: f64, depth: i128) -> i64 {
    (height / depth.max(1) as f64).ceil() as i64
}
