//! Mode III: a thread of several legs, pass by pass (execution of LAP, 10; E100L-AP3-01 to E100L-AP3-04).

use turnspec_oracle::vocabulary::rule_ids::{self, GOTO_03};
use turnspec_oracle::vocabulary::{AlarmName, Label, LeadAxis, Part, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::plane::Point;
use crate::engine::fault::Fault;
use crate::engine::thread::{Cited, Depth, Depths, Heights};
use crate::engine::words::{Address, Words};

use super::definition::{Course, Recorded};
use super::job::Job;
use super::rules::{self, Rules};
use super::travel::{Step, Way};
use super::unspecified;

impl Interpreter<'_> {
    /// G88.
    pub(super) fn cut_legs(
        &mut self,
        job: &Job,
        words: &Words,
        motions: &[Recorded],
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let word = |address| words.get(address).unwrap_or_default();
        let allowance = word(if job.axes.along { Address::U } else { Address::W });
        let height = word(Address::H);
        let heights = Heights { step: word(Address::D), height, target: height.saturating_sub(allowance) };
        let sequence = self.sequence(heights)?;
        let mut depths = Depths::new(sequence, heights);
        let axis = if job.axes.along { LeadAxis::Z } else { LeadAxis::X };
        let mut is_first = true;
        while let Some(depth) = depths.next(&mut self.slow) {
            let rest = height.saturating_sub(depth.depth);
            if is_first {
                check_side(job, rest)?;
            } else if !self.task.count_pass() {
                return Fault::raise(AlarmName::StepLimit, GOTO_03);
            }
            is_first = false;
            let flank = self.flank_shift(axis, rest, word(Address::B), depth.number);
            let cited = self.infeed_cites(job.axes.along, sequence, depth, flank);
            let offset = job.axes.point(job.axes.infeed * rest, flank);
            self.cut_legs_once(job, motions, (depth, offset, depths.are_done()), cited, sink)?;
        }
        Ok(())
    }

    /// One pass, moved by an offset.
    fn cut_legs_once(
        &mut self,
        job: &Job,
        motions: &[Recorded],
        (depth, offset, last): (Depth, Point, bool),
        cited: Cited,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let pass = u32::try_from(depth.number).unwrap_or(u32::MAX);
        let every = job.every.and(rules::AP3_02);
        let Cited { rules: others, readings } = cited;
        let step = |part, way, end, own: Rules| Step {
            way,
            end,
            part,
            pass: Some(pass),
            rules: every.and(own),
            others,
            readings,
        };
        for (number, motion) in motions.iter().enumerate() {
            let end = motion.end.plus(offset);
            let step = match motion.course {
                _ if number == 0 => step(Part::Approach, Way::Rapid, end, Rules::default()),
                Course::Leg(leg) => {
                    let step = step(Part::Cut, Way::Thread(leg), end, rules::AP3_01);
                    let of_leg = leg.readings;
                    Step { others: others.union(leg.rules), readings: readings.union(of_leg), ..step }
                }
                _ => step(Part::Exit, Way::Line(motion.feed), end, Rules::default()),
            };
            self.travel(&step, sink)?;
        }
        let of_last = Rules::default().and_if(last, rules::AP3_04);
        let (start_i, _) = job.axes.split(job.start);
        let (_, present_k) = job.axes.split(self.present());
        let above = job.axes.point(start_i, present_k);
        self.travel(&step(Part::Retract, Way::Rapid, above, of_last), sink)?;
        let back = step(Part::Return, Way::Rapid, job.start, of_last);
        let Cited { rules: others, readings } = Cited::default();
        self.travel(&Step { others, readings, ..back }, sink)
    }
}

/// The AP start lies beyond the start of the first pass.
fn check_side(job: &Job, rest: i64) -> Result<(), Fault> {
    let (start_i, _) = job.axes.split(job.start);
    let (from_i, _) = job.axes.split(job.contour.start);
    let apart = (i128::from(start_i) - i128::from(from_i)) * i128::from(job.axes.infeed);
    if apart <= i128::from(rest) {
        return Err(unspecified(rule_ids::AP3_02, const { Label::new("side") }));
    }
    Ok(())
}
