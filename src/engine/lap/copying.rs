//! Mode II: the contour itself, moved from the AP start to its place (execution of LAP, 10; E100L-AP2-01 to
//! E100L-AP2-05).

use turnspec_oracle::vocabulary::{Part, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::lap;
use crate::engine::fault::Fault;

use super::job::Job;
use super::rules::{self, Rules};
use super::travel::Way;
use super::turning::Count;
use super::value::Value;

impl Interpreter<'_> {
    /// G86 without a blank.
    pub(super) fn copy_contour(&mut self, job: &Job, sink: &mut impl Sink) -> Result<(), Fault> {
        let axes = job.axes;
        let from = job.contour.start;
        let (start_i, start_k) = axes.split(job.start);
        let (from_i, _) = axes.split(from);
        let mut count = Count::default();
        let mut level = start_i;
        loop {
            level = lap::next_level(level, axes.infeed, job.depth);
            let last = !job.is_above(level, from_i);
            let (over, rise) = job.on_start_line(level);
            let begin = match last {
                true => from,
                false => axes.point(level, Value::ratio(over, rise).latch(1, false)),
            };
            self.begin_rough_pass(&mut count, false)?;
            let of_pass = Rules::default().and_if(last, rules::AP2_05);
            let way = if job.first_rapid { Way::Rapid } else { Way::Line(job.feed) };
            let own = of_pass.and(rules::AP2_01).and(rules::LAP_05);
            self.go_in_pass(job, &count, (Part::Infeed, way, begin), own, sink)?;
            let offset = begin.minus(from);
            for element in &job.contour.elements {
                let element = element.moved(offset);
                let cut = (&element, element.to, job.feed);
                self.cut_element(job, &count, cut, of_pass.and(rules::AP2_03), sink)?;
            }
            let (present_i, _) = axes.split(self.present());
            let back = axes.point(present_i, start_k);
            if last {
                if !job.stays {
                    self.home_step(job, back, rules::AP2_05, sink)?;
                    self.home_step(job, job.start, rules::AP2_05, sink)?;
                }
                return Ok(());
            }
            self.rapid(job, &count, (Part::Return, back, rules::AP2_04), sink)?;
        }
    }
}
