//! To a level and along it: infeed points and straight cuts, in mode IV only where there is stock (execution of LAP, 9
//! and 11; E100L-AP1-03, E100L-AP1-04, E100L-AP4-02 to E100L-AP4-05, E100L-AP4-07).

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids::AP4_03;
use turnspec_oracle::vocabulary::{Label, Part, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::plane::Point;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::job::Job;
use super::outline::Outline;
use super::rules;
use super::travel::Way;
use super::turning::{Count, Pass};
use super::unspecified;
use super::value::Value;
use super::walk::Place;

/// A stretch of a level, by the runs of its ends.
type Stretch = (Value, Value);

impl Interpreter<'_> {
    /// Begins a pass and goes to its infeed point: the point, and its run unrounded.
    pub(super) fn feed_in(
        &mut self,
        job: &Job,
        pass: &Pass,
        count: &mut Count,
        sink: &mut impl Sink,
    ) -> Result<(Point, Value), Fault> {
        if let Some(blank) = &job.blank {
            return self.feed_in_before(job, blank, pass, count, sink);
        }
        self.begin_rough_pass(count, pass.cut.differs)?;
        let level =
            if planted::is(Bug::InfeedBesideStart) { job.axes.split(job.start).0 } else { pass.level };
        let (over, rise) = job.on_start_line(level);
        let k = Value::ratio(over, rise).latch(1, false);
        let (end, own) = match pass.last {
            true => (job.contour.start, rules::AP1_03.and(rules::AP1_08)),
            false => (job.axes.point(pass.level, k), rules::AP1_03),
        };
        let way = if job.first_rapid { Way::Rapid } else { Way::Line(pass.cut.feed) };
        let own = own.and(rules::LAP_05).and(rules::AP1_02);
        self.go_in_pass(job, count, (Part::Infeed, way, end), own, sink)?;
        Ok((end, Value::whole(job.axes.run(k))))
    }

    /// The same in mode IV: before the stock, or before the contour.
    fn feed_in_before(
        &mut self,
        job: &Job,
        blank: &Outline,
        pass: &Pass,
        count: &mut Count,
        sink: &mut impl Sink,
    ) -> Result<(Point, Value), Fault> {
        let axes = job.axes;
        let near = job.is_near();
        let run = match pass.last {
            true => job.before_start(near),
            false => self.infeed_run(job, blank, pass, near)?,
        };
        let level = if pass.last { axes.split(job.contour.start).0 } else { pass.level };
        let end = axes.point(level, axes.latch_run(run));
        let is_first = count.number == 0;
        if !is_first {
            let (present_i, _) = axes.split(self.present());
            let over = axes.point(present_i, axes.split(end).1);
            self.rapid(job, count, (Part::Return, over, rules::AP4_04), sink)?;
        }
        self.begin_rough_pass(count, pass.cut.differs)?;
        let own = if near { rules::AP4_03 } else { rules::AP4_02 };
        let own =
            own.and_if(!is_first, rules::AP4_04).and(if pass.last { rules::AP1_08 } else { rules::LAP_05 });
        let line = Way::Line(pass.cut.feed);
        let way = if job.first_rapid || pass.last { Way::Rapid } else { line };
        self.go_in_pass(job, count, (Part::Infeed, way, end), own, sink)?;
        if pass.last && !near {
            self.go_in_pass(job, count, (Part::Infeed, line, job.contour.start), own, sink)?;
        }
        Ok((end, run))
    }

    /// The run of the infeed point of a level.
    fn infeed_run(&mut self, job: &Job, blank: &Outline, pass: &Pass, near: bool) -> Result<Value, Fault> {
        let contour = &job.contour;
        let level = contour.level(pass.level);
        let met = contour.up(Place::start_of(0), level).unwrap_or(contour.last_place());
        let mut first = contour.run(met);
        if let Some((begin, _)) = stock(blank, level.1).first() {
            first = first.min(*begin, &mut self.slow);
        }
        let before = first.plus(-job.clearance_run());
        if !near {
            return Ok(before);
        }
        let (start_i, _) = job.axes.split(job.start);
        if job.is_above(pass.level, start_i) {
            return Err(unspecified(AP4_03, const { Label::new("start") }));
        }
        let (over, rise) = job.on_start_line(pass.level);
        let halves = i128::from(job.axes.cutting) * job.axes.cutting_halves();
        Ok(before.max(Value::ratio(over * halves, rise), &mut self.slow))
    }

    /// Cuts straight along the level of a pass, from a run to a place or to the end of the contour, over a recess or
    /// not.
    pub(super) fn cut_level(
        &mut self,
        job: &Job,
        pass: &Pass,
        count: &Count,
        (from, to, over): (Value, Option<Place>, bool),
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let contour = &job.contour;
        let end = contour.run(to.unwrap_or(contour.last_place()));
        let own = match () {
            () if pass.deeper => rules::AP1_11,
            () if over => rules::AP1_10,
            () => rules::AP1_04,
        };
        let own = own.and_if(job.blank.is_some() && to.is_none(), rules::AP4_07);
        let stretches = match &job.blank {
            Some(blank) => self.stretches(job, blank, pass.level, (from, end)),
            None => vec![(from, end)],
        };
        let own = own.and_if(stretches.len() > 1, rules::AP4_05);
        for (number, (begin, end)) in stretches.into_iter().enumerate() {
            let point = |run| job.axes.point(pass.level, job.axes.latch_run(run));
            if number > 0 {
                self.rapid(job, count, (Part::Air, point(begin), rules::AP4_05), sink)?;
            }
            let cut = (Part::Cut, Way::Line(pass.cut.feed), point(end));
            self.go_in_pass(job, count, cut, own, sink)?;
        }
        Ok(())
    }

    /// Where a level is cut on the way between two runs: at the stock and at both ends, a clearance further each, without
    /// gaps that those close (E100L-AP4-05).
    fn stretches(&mut self, job: &Job, blank: &Outline, level: i64, (from, to): Stretch) -> Vec<Stretch> {
        if from.cmp(to, &mut self.slow) != Ordering::Greater {
            return self.parted(job, blank, level, (from, to));
        }
        let mut parted = self.parted(job, blank, level, (to, from));
        parted.reverse();
        parted.into_iter().map(|(low, high)| (high, low)).collect()
    }

    /// The same between a low and a high run.
    fn parted(&mut self, job: &Job, blank: &Outline, level: i64, (low, high): Stretch) -> Vec<Stretch> {
        let slow = &mut self.slow;
        let clearance = job.clearance_run();
        let mut joined: Vec<Stretch> = Vec::new();
        let stock = stock(blank, blank.level(level).1);
        let parts = std::iter::once((low, low)).chain(stock).chain([(high, high)]);
        for (begin, end) in parts {
            if end.cmp(low, slow) == Ordering::Less || begin.cmp(high, slow) == Ordering::Greater {
                continue;
            }
            let before = if planted::is(Bug::StockWithoutClearance) { 0 } else { clearance };
            let begin = begin.plus(-before).max(low, slow);
            let end = end.plus(clearance).min(high, slow);
            match joined.last_mut() {
                Some((_, last)) if begin.cmp(*last, slow) != Ordering::Greater => *last = last.max(end, slow),
                _ => joined.push((begin, end)),
            }
        }
        joined
    }
}

impl Job {
    /// The clearance, as a run.
    fn clearance_run(&self) -> i128 {
        i128::from(self.clearance) * self.axes.cutting_halves()
    }

    /// Whether the AP start is nearer to the contour than the clearance.
    fn is_near(&self) -> bool {
        let start = self.axes.spot(self.start).run;
        let from = self.axes.spot(self.contour.start).run;
        from - start < self.clearance_run() + i128::from(planted::is(Bug::ClearanceIsNear))
    }

    /// The run to which the tool goes in the last pass.
    fn before_start(&self, near: bool) -> Value {
        let from = self.axes.spot(self.contour.start).run;
        Value::whole(if near { from } else { from - self.clearance_run() })
    }
}

/// Where a blank is above a level (E100L-AP4-05).
fn stock(blank: &Outline, level: i128) -> Vec<Stretch> {
    let mut found = Vec::new();
    let Some(first) = blank.pieces.first() else { return found };
    let is_above = first.start().cmp_whole(level) == Ordering::Greater;
    let mut begin = is_above.then(|| Value::whole(first.from.run));
    for slope in &blank.slopes {
        let pieces = blank.pieces.get(slope.first..slope.end).unwrap_or_default();
        let above = |height: Value| height.cmp_whole(level) == Ordering::Greater;
        match begin {
            None if slope.rises => {
                let place = pieces.partition_point(|piece| !above(piece.end()));
                begin = pieces.get(place).map(|piece| piece.run_at(level));
            }
            Some(from) if !slope.rises => {
                let place = pieces.partition_point(|piece| above(piece.end()));
                if let Some(piece) = pieces.get(place) {
                    found.push((from, piece.run_at(level)));
                    begin = None;
                }
            }
            _ => {}
        }
    }
    if let (Some(begin), Some(last)) = (begin, blank.pieces.last()) {
        found.push((begin, Value::whole(last.to.run)));
    }
    found
}
