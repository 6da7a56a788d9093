//! The recesses that the passes of modes I and IV meet (execution of LAP, 9, "The recesses"; E100L-AP1-11,
//! E100L-AP1-12).

use turnspec_oracle::vocabulary::{Part, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::lap;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::job::Job;
use super::rules;
use super::turning::{Count, Pass};
use super::walk::Place;

/// A recess that a pass has met, which is still to be finished.
#[derive(Clone, Copy, Debug)]
struct Recess {
    place: Place,
    /// The level of the pass that has met it, and the one above.
    level: i64,
    upper: i64,
    is_first: bool,
}

impl Interpreter<'_> {
    /// The recesses that a pass has met, each to its bottom, those of its passes before the next one.
    pub(super) fn finish_recesses(
        &mut self,
        job: &Job,
        pass: &Pass,
        met: Vec<Place>,
        count: &mut Count,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let contour = &job.contour;
        let mut waiting = Vec::new();
        add_recesses(&mut waiting, pass, met);
        while let Some(recess) = waiting.pop() {
            if !recess.is_first {
                self.clear_to(job, count, recess.upper, rules::AP1_12, sink)?;
            }
            let own = rules::AP1_11.and_if(job.blank.is_some(), rules::AP4_06);
            let point = contour.point(recess.place);
            let (present_i, _) = job.axes.split(self.present());
            let (_, k) = job.axes.split(point);
            for end in [job.axes.point(present_i, k), job.axes.point(recess.level, k)] {
                self.rapid(job, count, (Part::Return, end, own), sink)?;
            }
            let cut = job.below(recess.level);
            let level = lap::next_level(recess.level, job.axes.infeed, cut.depth);
            let pass = Pass { upper: recess.level, level, cut, deeper: true, last: false, to_end: false };
            self.begin_rough_pass(count, cut.differs)?;
            let mut met = Vec::new();
            let end = self.run_along(job, &pass, count, recess.place, &mut met, sink)?;
            self.relieve(job, &pass, count, met.is_empty(), sink)?;
            self.clear_path(job, count, end.map(|end| (recess.place, end)), sink)?;
            add_recesses(&mut waiting, &pass, met);
        }
        Ok(())
    }
}

/// Puts the recesses of a pass before those that wait already.
fn add_recesses(waiting: &mut Vec<Recess>, pass: &Pass, met: Vec<Place>) {
    let (level, upper) = (pass.level, pass.upper);
    let recesses = met.into_iter().enumerate();
    let recesses = recesses.map(|(number, place)| Recess { place, level, upper, is_first: number == 0 });
    if planted::is(Bug::LastRecessFirst) {
        return waiting.extend(recesses);
    }
    waiting.extend(recesses.rev());
}
