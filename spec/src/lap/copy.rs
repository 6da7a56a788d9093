//! Mode II: the contour itself, moved from S to its place (E100L-AP2-01 to -05; execution-lap.md, section 10).

use super::job::Job;
use super::motion::{Course, Role, Tool};
use super::plane::Spot;
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::quantity::{ratio, round_narrow, whole};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Part, RuleId};

/// A cycle with the passes that are left of it.
#[derive(Clone, Debug)]
pub struct Copy {
    job: Job,
    /// How many passes have begun.
    number: u32,
}

impl Copy {
    /// The cycle of a call, before its first pass.
    pub fn begin(job: Job) -> Self {
        Self { job, number: 0 }
    }

    /// Cuts the next pass; whether one is left then.
    pub fn pass(&mut self, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<bool> {
        self.number = self.number.saturating_add(1);
        let job = &self.job;
        let mut tool = Tool { job, state, emissions };
        let (start, last) = self.start();
        let role = |part, rules: &[RuleId]| Role {
            pass: Some(self.number),
            part,
            cited: Cited::rules(rules).and_if(last, Cited::rules(&[AP2_05])),
        };
        let infeed = if job.rapid_first { Course::Rapid } else { Course::Line(job.feed) };
        tool.go(start, &infeed, role(Part::Infeed, &[AP2_01, LAP_05]))?;
        // E100L-AP2-03.
        let to = job.rough.start;
        let moved = job.rough.clone().moved(start.infeed - to.infeed, start.cutting - to.cutting);
        for element in &moved.elements {
            let (course, cited) = job.along(element, job.feed);
            let role = role(Part::Contour, &[AP2_03]);
            tool.go(element.end, &course, Role { cited: role.cited.and(cited), ..role })?;
        }
        if !last {
            tool.rapid_cutting(job.start.cutting, role(Part::Return, &[AP2_04]))?;
        } else if job.returns {
            let role = Role { pass: None, part: Part::Home, cited: Cited::rules(&[AP2_05]) };
            tool.rapid_cutting(job.start.cutting, role)?;
            tool.rapid_infeed(job.start.infeed, role)?;
        }
        Ok(!last)
    }

    /// Where the pass starts, and whether it is the last one (E100L-AP2-01, E100L-AP2-02).
    fn start(&self) -> (Spot, bool) {
        let (from, to, up) = (self.job.start, self.job.rough.start, self.job.plane.up);
        let all = up * (from.infeed - to.infeed);
        let fed = i64::from(self.number).saturating_mul(self.job.depth());
        if fed >= all {
            return (to, true);
        }
        // S lies above A'.
        let left = ratio(all - fed, all.unsigned_abs());
        let cutting = whole(to.cutting) + whole(from.cutting - to.cutting) * left;
        (Spot { infeed: from.infeed - up * fed, cutting: round_narrow(&cutting) }, false)
    }
}
