//! The return to the AP start (execution of LAP, 9, "The end"; E100L-LAP-06, E100L-AP1-09, E100L-AP4-08).

use turnspec_oracle::vocabulary::{Part, ReadingSet, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::plane::Point;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::job::Job;
use super::rules::{self, Rules};
use super::travel::{Step, Way};

impl Interpreter<'_> {
    /// The return to the AP start (E100L-LAP-06).
    pub(super) fn go_home(&mut self, job: &Job, sink: &mut impl Sink) -> Result<(), Fault> {
        if job.stays {
            return Ok(());
        }
        let own = if job.blank.is_some() { rules::AP4_08 } else { rules::AP1_09 };
        self.go_home_by(job, own.and(rules::LAP_06), sink)
    }

    /// The return to the AP start with rules of its own.
    pub(super) fn go_home_by(&mut self, job: &Job, own: Rules, sink: &mut impl Sink) -> Result<(), Fault> {
        let (start_i, _) = job.axes.split(job.start);
        let (_, present_k) = job.axes.split(self.present());
        let first = if job.first_rapid || planted::is(Bug::HomeAtOnce) {
            job.start
        } else {
            job.axes.point(start_i, present_k)
        };
        for end in [first, job.start] {
            self.home_step(job, end, own, sink)?;
        }
        Ok(())
    }

    pub(super) fn home_step(
        &mut self,
        job: &Job,
        end: Point,
        own: Rules,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let (others, readings) = (RuleSet::EMPTY, ReadingSet::default());
        let rules = job.every.and(own);
        let step = Step { way: Way::Rapid, end, part: Part::Home, pass: None, rules, others, readings };
        self.travel(&step, sink)
    }
}
