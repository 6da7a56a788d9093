//! Mode III: a thread of several legs, cut depth by depth (E100L-AP3-01 to -04; execution-lap.md, section 10).

use super::job::Job;
use super::motion::{Course, Role, Tool};
use super::plane::Spot;
use super::recording::{Kind, Recorded};
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::state::State;
use crate::thread::{Cited, Depth, Flanks, Infeed};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, LeadAxis, Part};

/// A cycle with the passes that are left of it.
#[derive(Clone, Debug)]
pub struct Threads {
    job: Job,
    motions: Vec<Recorded>,
    flanks: Flanks,
    infeed: Infeed,
    /// The depth that is cut next.
    depth: Depth,
    /// How many passes have begun.
    number: u32,
}

impl Threads {
    /// The cycle of a call, before its first pass.
    pub fn begin(job: Job, motions: Vec<Recorded>, state: &State) -> Outcome<Self> {
        let word = |letter| job.words.get(letter).unwrap_or(0);
        let allowance = if job.plane.transverse { 'W' } else { 'U' };
        let (step, height) = (word('D'), word('H'));
        let flanks = Flanks::in_force(state);
        let mut infeed = Infeed::new(step, height, height - word(allowance), flanks, state)?;
        let depth = infeed.next();
        let side = job.plane.up * (job.start.infeed - job.rough.start.infeed);
        if side <= height - depth.value {
            return Err(Fault::about(AlarmName::Unspecified, AP3_02, "side"));
        }
        Ok(Self { job, motions, flanks, infeed, depth, number: 0 })
    }

    /// Cuts the next pass; whether one is left then.
    pub fn pass(&mut self, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<bool> {
        self.number = self.number.saturating_add(1);
        let (job, last) = (&self.job, self.depth.last);
        let above = job.words.get('H').unwrap_or(0) - self.depth.value;
        let axis = if job.plane.transverse { LeadAxis::X } else { LeadAxis::Z };
        let tip = job.words.get('B').unwrap_or(0);
        let flank = self.flanks.shift(above, tip, self.number, axis, state);
        let work = self.work(flank != 0, state);
        let mut tool = Tool { job, state, emissions };
        let role = |part, cited| Role { pass: Some(self.number), part, cited };
        let own = Cited::rules(&[AP3_02]);
        let moved = |motion: &Recorded| {
            let Spot { infeed, cutting } = job.plane.spot(motion.end);
            Spot { infeed: infeed + job.plane.up * above, cutting: cutting + flank }
        };
        for (motion, index) in self.motions.iter().zip(0..) {
            let (course, part, cited) = match &motion.kind {
                Kind::Leg(leg) => {
                    (Course::Thread(leg.as_ref().clone()), Part::Cut, Cited::rules(&[AP3_01, AP3_02]))
                }
                _ if index == 0 => (Course::Rapid, Part::Approach, own),
                _ => (Course::Line(motion.own_feed), Part::Exit, own),
            };
            tool.go(moved(motion), &course, role(part, cited.and(work)))?;
        }
        let back = Cited::default().and_if(last, Cited::rules(&[AP3_04]));
        tool.rapid_infeed(job.start.infeed, role(Part::Retract, own.and(work).and(back)))?;
        tool.rapid_cutting(job.start.cutting, role(Part::Return, own.and(back)))?;
        if !last {
            self.depth = self.infeed.next();
        }
        Ok(!last)
    }

    /// What the motions of a pass name but its return (E100L-TINF-01, E100L-TMOD-01, E100L-G71-07, E100L-G72-03).
    fn work(&self, shifted: bool, state: &State) -> Cited {
        let depth = if self.depth.finishing {
            Cited::rules(&[if self.job.plane.transverse { G72_03 } else { G71_07 }])
        } else {
            self.infeed.cited(state)
        };
        depth.and_if(shifted, self.flanks.cited(state))
    }
}
