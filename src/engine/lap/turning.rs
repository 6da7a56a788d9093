//! Modes I and IV: passes at falling levels, each with what it meets of the contour, then one along the contour
//! (execution of LAP, 9 and 11; E100L-AP1-01 to E100L-AP1-12, E100L-AP4-01 to E100L-AP4-08).

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids::GOTO_03;
use turnspec_oracle::vocabulary::{AlarmName, Part, ReadingSet, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::lap;
use crate::engine::arithmetic::plane::Point;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::job::{Cut, Job};
use super::rules::{self, Rules};
use super::travel::{SMALL_LIFT, Step, Way};
use super::value::Value;
use super::walk::Place;

/// One pass.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// The level above it, and its own.
    pub upper: i64,
    pub level: i64,
    pub cut: Cut,
    /// Whether it belongs to a recess.
    pub deeper: bool,
    /// Whether it goes along the contour.
    pub last: bool,
    /// Whether it goes on to the end of the contour.
    pub to_end: bool,
}

/// The number of the pass in progress, and whether its depth or feed is another.
#[derive(Clone, Copy, Default, Debug)]
pub struct Count {
    pub number: u32,
    differs: bool,
}

impl Interpreter<'_> {
    /// G85.
    pub(super) fn turn_bar(&mut self, job: &Job, sink: &mut impl Sink) -> Result<(), Fault> {
        let (from_i, _) = job.axes.split(job.contour.start);
        let mut upper = self.first_level(job);
        let mut count = Count::default();
        loop {
            let cut = job.below(upper);
            let level = lap::next_level(upper, job.axes.infeed, cut.depth);
            let last = !job.is_above(level, from_i);
            let to_end = job.blank.is_some() && count.number == 0;
            let pass = Pass { upper, level, cut, deeper: false, last, to_end };
            self.turn_level(job, &pass, &mut count, sink)?;
            if last {
                return self.go_home(job, sink);
            }
            upper = level;
        }
    }

    /// The level above that of the first pass.
    fn first_level(&mut self, job: &Job) -> i64 {
        let Some(blank) = &job.blank else { return job.axes.split(job.start).0 };
        let first = Place::start_of(0);
        let contour = job.contour.highest_from(first, &mut self.slow);
        let highest = contour.max(blank.highest_from(first, &mut self.slow), &mut self.slow);
        job.axes.latch_height(highest)
    }

    /// A pass of the cycle with the recesses that it meets.
    fn turn_level(
        &mut self,
        job: &Job,
        pass: &Pass,
        count: &mut Count,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let contour = &job.contour;
        let first = Place::start_of(0);
        let (infeed, run) = self.feed_in(job, pass, count, sink)?;
        let mut recesses = Vec::new();
        let begin = match pass.last {
            true => Some(first),
            false => {
                let met = contour.up(first, contour.level(pass.level));
                self.cut_level(job, pass, count, (run, met, false), sink)?;
                met
            }
        };
        let path = match begin {
            Some(begin) => {
                let end = self.run_along(job, pass, count, begin, &mut recesses, sink)?;
                end.map(|end| (begin, end))
            }
            None => None,
        };
        let any = !recesses.is_empty();
        self.relieve(job, pass, count, !any, sink)?;
        self.clear_path(job, count, path, sink)?;
        self.finish_recesses(job, pass, recesses, count, sink)?;
        if any {
            self.clear_to(job, count, pass.upper, rules::AP1_12, sink)?;
        }
        if job.blank.is_none() && !pass.last {
            let (_, infeed_k) = job.axes.split(infeed);
            let (present_i, _) = job.axes.split(self.present());
            for end in [job.axes.point(present_i, infeed_k), infeed] {
                self.rapid(job, count, (Part::Return, end, rules::AP1_07), sink)?;
            }
        }
        Ok(())
    }

    /// The next pass begins.
    pub(super) fn begin_rough_pass(&mut self, count: &mut Count, differs: bool) -> Result<(), Fault> {
        if count.number > 0 && !planted::is(Bug::LevelsUncounted) && !self.task.count_pass() {
            return Fault::raise(AlarmName::StepLimit, GOTO_03);
        }
        *count = Count { number: count.number.saturating_add(1), differs };
        Ok(())
    }

    /// What a motion of a pass cites.
    pub(super) fn cited(job: &Job, count: &Count, own: Rules) -> Rules {
        let deeper = rules::LAPC_02.and(rules::LAPC_03);
        let first = job.has_levels && job.blank.is_some() && count.number == 1;
        job.every.and(own).and_if(count.differs, deeper).and_if(first, rules::AP4_01)
    }

    /// A motion of a pass.
    pub(super) fn go_in_pass(
        &mut self,
        job: &Job,
        count: &Count,
        (part, way, end): (Part, Way, Point),
        own: Rules,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let rules = Self::cited(job, count, own);
        let pass = Some(count.number);
        let (others, readings) = (RuleSet::EMPTY, ReadingSet::default());
        self.travel(&Step { way, end, part, pass, rules, others, readings }, sink)
    }

    pub(super) fn rapid(
        &mut self,
        job: &Job,
        count: &Count,
        (part, end, own): (Part, Point, Rules),
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.go_in_pass(job, count, (part, Way::Rapid, end), own, sink)
    }

    /// The run along the contour from a place; its last height if it ends in the end of the contour, or at its run.
    pub(super) fn run_along(
        &mut self,
        job: &Job,
        pass: &Pass,
        count: &Count,
        from: Place,
        recesses: &mut Vec<Place>,
        sink: &mut impl Sink,
    ) -> Result<Option<Value>, Fault> {
        let contour = &job.contour;
        let (level, upper) = (contour.level(pass.level), contour.level(pass.upper));
        let mut place = from;
        loop {
            let end = if pass.to_end && !planted::is(Bug::FirstPassLeaves) {
                None
            } else {
                contour.above(place, upper)
            };
            let recess = contour.down(place, level);
            let recess = recess.filter(|recess| end.is_none_or(|end| recess.is_before(end)));
            let Some(recess) = recess else {
                let last = contour.last_place();
                self.follow_pieces(job, pass, count, (place, end.unwrap_or(last), false), sink)?;
                return Ok(end.is_none().then(|| contour.height(last)));
            };
            self.follow_pieces(job, pass, count, (place, recess, true), sink)?;
            recesses.push(recess);
            let back = contour.rise(recess.piece, level);
            self.cut_level(job, pass, count, (contour.run(recess), back, true), sink)?;
            match back {
                Some(back) => place = back,
                None => return Ok(Some(Value::whole(level.1))),
            }
        }
    }

    /// Along the contour from a place to another one, which may be where a recess begins.
    fn follow_pieces(
        &mut self,
        job: &Job,
        pass: &Pass,
        count: &Count,
        (from, to, falls): (Place, Place, bool),
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let contour = &job.contour;
        let Some(piece) = contour.pieces.get(from.piece) else { return Ok(()) };
        for (number, element) in contour.elements.iter().enumerate().skip(piece.element) {
            let behind = contour.end_of_element(number);
            let first = contour.first_pieces.get(number).copied().unwrap_or_default();
            if to == Place::start_of(first) {
                break;
            }
            let whole = to.piece >= behind;
            let end = if whole { element.to } else { contour.point(to) };
            let is_last = !whole || to == Place::start_of(behind);
            let own = match () {
                () if pass.deeper => rules::AP1_11,
                () if is_last && falls => rules::AP1_10,
                () if pass.last => rules::AP1_08,
                () => rules::AP1_05,
            };
            let own = own.and_if(job.blank.is_some(), rules::AP4_06);
            self.cut_element(job, count, (element, end, pass.cut.feed), own, sink)?;
            if is_last {
                break;
            }
        }
        Ok(())
    }

    /// The relief behind a pass; behind the last one of a recess it is greater on X (E100L-AP1-12).
    pub(super) fn relieve(
        &mut self,
        job: &Job,
        pass: &Pass,
        count: &Count,
        is_last: bool,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let twice = pass.deeper && is_last;
        let own = rules::AP1_06.and_if(pass.deeper, rules::AP1_11).and_if(twice, rules::AP1_12);
        let end = job.relieved(self.present(), twice);
        let own = own.and_if(job.blank.is_some(), rules::AP4_06);
        self.rapid(job, count, (Part::Relief, end, own), sink)
    }

    /// Above the highest point of the path of a pass from a place on, if that has ended at the end of the contour at a
    /// lower height.
    pub(super) fn clear_path(
        &mut self,
        job: &Job,
        count: &Count,
        path: Option<(Place, Value)>,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let Some((begin, end)) = path else { return Ok(()) };
        let highest = job.contour.highest_from(begin, &mut self.slow);
        if end.cmp(highest, &mut self.slow) != Ordering::Less {
            return Ok(());
        }
        self.clear_above(job, count, job.lifted(highest), rules::AP1_06, sink)
    }

    /// A little above a level.
    pub(super) fn clear_to(
        &mut self,
        job: &Job,
        count: &Count,
        level: i64,
        own: Rules,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let target = level.saturating_add(job.axes.infeed * SMALL_LIFT.0);
        self.clear_above(job, count, target, own, sink)
    }

    fn clear_above(
        &mut self,
        job: &Job,
        count: &Count,
        target: i64,
        own: Rules,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        if !self.is_above_present(job.axes, target) {
            return Ok(());
        }
        let (_, present_k) = job.axes.split(self.present());
        let own = own.and_if(job.blank.is_some(), rules::AP4_06);
        self.rapid(job, count, (Part::Clear, job.axes.point(target, present_k), own), sink)
    }
}

impl Job {
    /// A point a relief away from what was cut, twice the relief on X or not.
    pub fn relieved(&self, from: Point, twice: bool) -> Point {
        let Point { x, z } = self.axes.point(self.axes.infeed, -self.axes.cutting);
        let on_x =
            if twice && !planted::is(Bug::SingleReliefInRecess) { 2 * self.relief } else { self.relief };
        from.plus(Point { x: x * on_x, z: z * self.relief })
    }

    /// The coordinate on the infeed axis a little above a height, latched.
    pub fn lifted(&self, height: Value) -> i64 {
        self.axes.latch_height(height.plus(i128::from(SMALL_LIFT.0) * self.axes.infeed_halves()))
    }
}
