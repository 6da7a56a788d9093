//! Mode V: passes along the blank, then along the contour (execution of LAP, 12; E100L-AP5-01 to E100L-AP5-07).

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids::{self, GOTO_03};
use turnspec_oracle::vocabulary::{AlarmName, Label, Part, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::plane::Point;
use crate::engine::exact::SlowPaths;
use crate::engine::fault::Fault;

use super::arrival::Arrival;
use super::front::{Front, Leave};
use super::graph::Graph;
use super::job::Job;
use super::meeting::{Coordinate, Meeting};
use super::outline::{Element, Outline};
use super::rules::{self, Rules};
use super::travel::{SMALL_LIFT, Way};
use super::turning::Count;
use super::unspecified;
use super::walk::Place;

/// What the passes have in common.
struct Copying {
    front: Front,
    /// The coordinate X1 of the start of the blank on the infeed axis, and that of the start of a pass on the other.
    level: i64,
    before: i64,
    /// Whether the start of the blank was moved.
    moved: bool,
}

impl Copying {
    fn new(job: &Job, blank: &Outline) -> Result<Self, Fault> {
        let axes = job.axes;
        let mut elements = blank.elements.clone();
        let mut start = blank.start;
        let first = elements.first().copied();
        let is_higher = |first: &Element| axes.spot(first.to).height > axes.spot(start).height;
        let moved = first.filter(is_higher);
        if let Some(first) = moved {
            if first.arc.is_some() {
                return Err(unspecified(rule_ids::AP5_01, const { Label::new("blank") }));
            }
            start = axes.point(axes.split(first.to).0, axes.split(start).1);
            if let Some(element) = elements.first_mut() {
                element.from = start;
            }
            elements.retain(|element| element.arc.is_some() || element.from != element.to);
        }
        let (level, begin) = axes.split(start);
        let before = begin.saturating_sub(axes.cutting * job.clearance);
        let from = axes.point(level, before);
        elements.insert(0, Element::line(from, start));
        let graph = Graph::new(axes, axes.spot(from), &elements);
        let contour = Graph::new(axes, axes.spot(job.contour.start), &job.contour.elements);
        let depth = i128::from(job.depth) * axes.infeed_halves();
        let front = Front::new(axes, elements, (graph, contour), depth, axes.run(begin));
        Ok(Self { front, level, before, moved: moved.is_some() })
    }

    /// The level of a pass along the blank.
    fn level(&self, job: &Job, times: i64) -> i64 {
        self.level.saturating_sub((job.axes.infeed * times).saturating_mul(job.depth))
    }

    /// How far on the infeed axis the blank is moved.
    fn offset(job: &Job, times: i64) -> Point {
        job.axes.point((-job.axes.infeed * times).saturating_mul(job.depth), 0)
    }
}

impl Interpreter<'_> {
    /// G86 with a blank.
    pub(super) fn copy_bar(&mut self, job: &Job, blank: &Outline, sink: &mut impl Sink) -> Result<(), Fault> {
        let copying = Copying::new(job, blank)?;
        let (from_i, from_k) = job.axes.split(job.contour.start);
        let mut count = Count::default();
        let mut highest = None;
        let mut times = 1;
        while job.is_above(copying.level(job, times), from_i) {
            let level = copying.level(job, times);
            self.go_before(job, (&mut count, highest), (level, copying.before, rules::AP5_02), sink)?;
            let start = job.axes.spot(job.axes.point(level, copying.before));
            let point =
                Meeting { run: Coordinate::whole(start.run), height: Coordinate::whole(start.height) };
            let leave = Leave { times, point, blank: 0, contour: 0, at_joint: false, root: None };
            let own = rules::AP5_03.and_if(copying.moved, rules::AP5_01);
            highest = Some(self.cut_front(job, &copying.front, &count, (&leave, 0, own), sink)?);
            times += 1;
        }
        self.go_before(job, (&mut count, highest), (from_i, from_k, rules::AP5_05), sink)?;
        self.run_along_contour(job, &copying.front, &count, sink)?;
        self.leave_contour(job, &count, sink)
    }

    /// From where a pass has ended, with the highest height of its path, to where the next one begins; in the first
    /// pass from the AP start.
    fn go_before(
        &mut self,
        job: &Job,
        (count, highest): (&mut Count, Option<Coordinate>),
        (level, k, of_point): (i64, i64, Rules),
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let axes = job.axes;
        let is_first = highest.is_none();
        if let Some(highest) = highest {
            self.lift(job, count, (highest, rules::AP5_04), sink)?;
            let (present_i, _) = axes.split(self.present());
            let back = axes.point(present_i, axes.split(job.start).1);
            self.rapid(job, count, (Part::Return, back, rules::AP5_04), sink)?;
        }
        self.begin_rough_pass(count, false)?;
        let way = if is_first && !job.first_rapid { Way::Line(job.feed) } else { Way::Rapid };
        let own = of_point.and(if is_first { rules::LAP_05 } else { rules::AP5_04 });
        let (_, present_k) = axes.split(self.present());
        for end in [axes.point(level, present_k), axes.point(level, k)] {
            self.go_in_pass(job, count, (Part::Infeed, way, end), own, sink)?;
        }
        Ok(())
    }

    /// A little above a height.
    fn lift(
        &mut self,
        job: &Job,
        count: &Count,
        (highest, own): (Coordinate, Rules),
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let axes = job.axes;
        let lift = i128::from(SMALL_LIFT.0) * axes.infeed_halves();
        let target = highest.latch(lift, axes.infeed, !axes.along, &mut self.slow);
        if !self.is_above_present(axes, target) {
            return Ok(());
        }
        let (_, present_k) = axes.split(self.present());
        self.rapid(job, count, (Part::Clear, axes.point(target, present_k), own), sink)
    }

    /// Along the lowered blank from a point to where it meets the contour, from one of its elements on, and the relief;
    /// the highest height of the path.
    fn cut_front(
        &mut self,
        job: &Job,
        front: &Front,
        count: &Count,
        (leave, first, own): (&Leave, usize, Rules),
        sink: &mut impl Sink,
    ) -> Result<Coordinate, Fault> {
        let arrival = front.arrival(leave, &mut self.slow);
        let offset = Copying::offset(job, leave.times);
        let end = self.latched(job, &arrival.point);
        for (number, element) in front.elements.iter().enumerate().skip(first) {
            let element = element.moved(offset);
            let is_last = number >= arrival.element;
            let way = match element.arc {
                Some((sense, centre)) => Way::Arc(job.feed, sense, centre),
                None => Way::Line(job.feed),
            };
            let end = if is_last { end } else { element.to };
            self.go_in_pass(job, count, (Part::Cut, way, end), own, sink)?;
            if is_last {
                break;
            }
        }
        let end = job.relieved(self.present(), true);
        self.rapid(job, count, (Part::Relief, end, own), sink)?;
        Ok(front.highest(leave, first, &arrival, &mut self.slow))
    }

    /// A point of the plane, latched.
    fn latched(&mut self, job: &Job, point: &Meeting) -> Point {
        let axes = job.axes;
        let infeed = point.height.latch(0, axes.infeed, !axes.along, &mut self.slow);
        axes.point(infeed, point.run.latch(0, axes.cutting, axes.along, &mut self.slow))
    }

    /// Along the contour, with what is cut from it.
    fn run_along_contour(
        &mut self,
        job: &Job,
        front: &Front,
        count: &Count,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let mut slow = SlowPaths::default();
        let (mut span, mut blank) = (0, 0);
        for element in &job.contour.elements {
            let (from, to) = (job.axes.spot(element.from), job.axes.spot(element.to));
            let mut leave = |leave: Leave| self.leave(job, front, count, (element, &leave), sink);
            blank = if from.run == to.run {
                front.leaves_in_joint(span, (from.height, to.height), blank, &mut slow, &mut leave)?
            } else {
                let reached = front.leaves(span, blank, &mut slow, &mut leave)?;
                span += 1;
                reached
            };
            self.cut_element(job, count, (element, element.to, job.feed), rules::AP5_05, sink)?;
        }
        self.slow = self.slow.and(slow);
        Ok(())
    }

    /// Leaves the contour in a point of an element, cuts along the blank and returns (E100L-AP5-06).
    fn leave(
        &mut self,
        job: &Job,
        front: &Front,
        count: &Count,
        (element, leave): (&Element, &Leave),
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let axes = job.axes;
        let point = self.latched(job, &leave.point);
        self.cut_element(job, count, (element, point, job.feed), rules::AP5_05, sink)?;
        if !self.task.count_pass() {
            return Fault::raise(AlarmName::StepLimit, GOTO_03);
        }
        let own = rules::AP5_06;
        let first = front.first_element(leave, &mut self.slow);
        let highest = self.cut_front(job, front, count, (leave, first, own), sink)?;
        self.lift(job, count, (highest, own), sink)?;
        let (present_i, _) = axes.split(self.present());
        let over = axes.point(present_i, axes.split(point).1);
        self.rapid(job, count, (Part::Return, over, own), sink)?;
        self.go_in_pass(job, count, (Part::Return, Way::Line(job.feed), point), own, sink)
    }

    /// The end of the contour, and the return to the AP start (E100L-AP5-07).
    fn leave_contour(&mut self, job: &Job, count: &Count, sink: &mut impl Sink) -> Result<(), Fault> {
        let own = rules::AP5_07;
        let end = job.relieved(self.present(), false);
        self.rapid(job, count, (Part::Relief, end, own), sink)?;
        let highest = job.contour.highest_from(Place::start_of(0), &mut self.slow);
        let last = job.contour.height(job.contour.last_place());
        if last.cmp(highest, &mut self.slow) == Ordering::Less {
            self.lift(job, count, (Coordinate::Value(highest), own), sink)?;
        }
        if job.stays {
            return Ok(());
        }
        self.go_home_by(job, own.and(rules::LAP_06), sink)
    }
}

impl Front {
    /// The highest height of a way along the lowered blank, from a point and one of its elements on.
    fn highest(&self, leave: &Leave, first: usize, arrival: &Arrival, slow: &mut SlowPaths) -> Coordinate {
        let drop = self.drop(leave.times);
        let mut highest = leave.point.height.max(arrival.point.height, slow);
        for (number, element) in self.elements.iter().enumerate().skip(first) {
            if number > arrival.element {
                break;
            }
            if number < arrival.element {
                highest = highest.max(Coordinate::whole(self.end_height(element) - drop), slow);
            }
            let Some((run, top)) = self.blank.span_of(number).and_then(super::graph::Span::top) else {
                continue;
            };
            let begun = number > first || leave.point.run.cmp_whole(run, slow) == Ordering::Less;
            let passed =
                number < arrival.element || arrival.point.run.cmp_whole(run, slow) == Ordering::Greater;
            if begun && passed {
                highest = highest.max(Coordinate::Value(top.plus(-drop)), slow);
            }
        }
        highest
    }
}
