//! One pass of a thread cycle: approach, cut, with a chamfer exit, withdrawal, return (E100L-G33-04, E100L-G32-02,
//! E100L-G71-03, E100L-G72-02).
//!
//! A point has a *lead* coordinate, on the axis along which the lead is measured, and a *level* on the other one; X is a
//! diameter on either.

use super::chamfer::{Chamfer, exits};
use super::lead::{length, measure};
use super::motion::{Cited, Step, Thread, Work, carry_out};
use super::taper::Taper;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::integer::thread as integer;
use crate::modal::Plan;
use crate::path::{Axes, Point};
use crate::quantity::{Exact, round_narrow, whole};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, LeadAxis, Part};

/// A point by its coordinates on the lead axis and on the other one, in nanometres.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Spot {
    /// On the lead axis.
    pub lead: i64,
    /// On the other axis.
    pub level: i64,
}

impl Spot {
    /// A point given as X (a diameter) and Z.
    pub fn of((x, z): Point, axis: LeadAxis) -> Self {
        match axis {
            LeadAxis::X => Self { lead: x, level: z },
            LeadAxis::Z => Self { lead: z, level: x },
        }
    }

    /// X (as a diameter) and Z.
    fn point(self, axis: LeadAxis) -> Point {
        match axis {
            LeadAxis::X => (self.lead, self.level),
            LeadAxis::Z => (self.level, self.lead),
        }
    }
}

/// A pass as it is programmed.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// Lead, its axis, and the start angle.
    pub thread: Thread,
    /// Where the tool stands before and after it.
    pub start: Spot,
    /// Where the thread ends.
    pub end: i64,
    /// The level that is programmed.
    pub level: i64,
    /// On which side of the level the cycle start lies: 1 where coordinates are greater.
    pub side: i64,
    /// The taper.
    pub taper: Taper,
    /// The shift of the start of the thread.
    pub shift: i64,
    /// The shift along the flank, of start and end.
    pub flank: i64,
    /// L.
    pub chamfer: Option<i64>,
    /// Its number in the cycle.
    pub number: u32,
    /// What its events name.
    pub citations: Citations,
}

/// What the events of a pass name, by their parts.
#[derive(Clone, Copy, Default, Debug)]
pub struct Citations {
    /// All.
    pub all: Cited,
    /// All but the return.
    pub work: Cited,
    /// Of a taper, besides its own rule.
    pub taper: Cited,
    /// The approach.
    pub approach: Cited,
    /// What cuts.
    pub thread: Cited,
    /// The chamfer.
    pub exit: Cited,
    /// The return.
    pub back: Cited,
}

/// The thread of a pass, in its place.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    /// Where it begins.
    pub from: Spot,
    /// Where it would end without chamfer.
    pub to: Spot,
    /// The way of its lead axis: 1 toward greater coordinates.
    pub direction: i64,
}

impl Pass {
    /// Cuts it.
    pub fn cut(&self, plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
        for step in self.steps(state)? {
            let present = state.frame.program();
            if step.end != (present.x, present.z) {
                emissions.push(carry_out(&step, &self.thread, plan, state)?);
            }
        }
        Ok(())
    }

    /// Its motions.
    fn steps(&self, state: &State) -> Outcome<Vec<Step>> {
        let course = self.course(state)?;
        let whole_length = length(self.thread.axis, course.from.lead, course.to.lead, state.setup);
        self.thread.lead.check_end(&whole_length)?;
        let chamfer = Chamfer::of(self.chamfer, self.thread.lead, &whole_length, state)?;
        let tapered = course.from.level != course.to.level;
        // E100L-TMOD-02: the thread as a whole is shifted.
        let shifted = |spot: Spot| Spot { lead: spot.lead + self.flank, ..spot };
        let course = Course { from: shifted(course.from), to: shifted(course.to), ..course };
        let work = self.work(tapered, state);
        let rapid = |end, part, cited| self.step(end, Work::Rapid, part, cited);
        let first = self.thread.lead.first;
        let mut steps = vec![rapid(course.from, Part::Approach, work.and(self.citations.approach))];
        let mut end = course.to;
        match chamfer {
            None => steps.push(self.step(end, Work::Thread(first), Part::Cut, self.cutting(work))),
            Some(chamfer) => {
                let begin = chamfer_begin(&course, &chamfer.length, self.thread.axis, state);
                steps.push(self.step(begin, Work::Thread(first), Part::Cut, self.cutting(work)));
                let cited = self.cutting(work).and(chamfer.cited).and(self.citations.exit);
                for (spot, lead) in exits(self, &course, begin, &chamfer, state)? {
                    steps.push(self.step(spot, Work::Thread(lead), Part::Exit, cited));
                    end = spot;
                }
            }
        }
        let out = Spot { level: self.start.level, ..end };
        steps.push(self.step(out, Work::Withdrawal, Part::Retract, work));
        steps.push(rapid(self.start, Part::Return, self.citations.all.and(self.citations.back)));
        Ok(steps)
    }

    fn step(&self, end: Spot, work: Work, part: Part, cited: Cited) -> Step {
        let part = Some((self.number, part));
        Step { end: end.point(self.thread.axis), axes: Axes::PLANE, work, part, cited }
    }

    /// Where the thread begins and ends, on its axis and on the other one, without the shift along the flank.
    fn course(&self, state: &State) -> Outcome<Course> {
        let (direction, from) = self.beginning(state)?;
        let rise = self.taper.rise(self.thread.axis, from, self.end)?;
        // E100L-G33-05.
        let (first, last) = integer::levels(self.level, rise, state.setup.readings.taper_reference);
        let is_beyond = |level: i64| integer::is_beyond(self.side, self.start.level, level);
        if is_beyond(first) || is_beyond(last) {
            return Err(Fault::about(AlarmName::Unspecified, G33_04, "side"));
        }
        Ok(Course {
            from: Spot { lead: from, level: first },
            to: Spot { lead: self.end, level: last },
            direction,
        })
    }

    /// E100L-G33-04, E100L-G33-07: the way of the lead axis, and where the thread begins on it.
    fn beginning(&self, state: &State) -> Outcome<(i64, i64)> {
        let reading = state.setup.readings.thread_shift;
        integer::beginning(self.start.lead, self.end, self.shift, reading)
            .ok_or_else(|| Fault::about(AlarmName::Unspecified, G33_04, "length"))
    }

    /// What every event but that of the return names.
    fn work(&self, tapered: bool, state: &State) -> Cited {
        let readings = &state.setup.readings;
        let taper = Cited::rules(&[self.taper.rule()]).reading(readings.taper_reference);
        let shift = Cited::rules(&[G33_07]).reading(readings.thread_shift);
        let work = self.citations.all.and(self.citations.work);
        work.and_if(tapered, taper.and(self.citations.taper)).and_if(self.shift != 0, shift)
    }

    /// What the events name that cut.
    fn cutting(&self, work: Cited) -> Cited {
        work.and(self.citations.thread)
            .and_if(self.thread.lead.divided, Cited::rules(&[THRD_06]))
            .and_if(self.thread.lead.change != 0, Cited::rules(&[G33_09]))
    }
}

/// E100L-TCHM-02, E100L-TCHM-04: where the chamfer begins: its length before the end, on the taper.
fn chamfer_begin(course: &Course, chamfer: &Exact, axis: LeadAxis, state: &State) -> Spot {
    let back = chamfer / measure(axis == LeadAxis::X, state.setup);
    let lead = round_narrow(&(whole(course.to.lead) - whole(course.direction) * back));
    let way = |from, to| length(axis, from, to, state.setup);
    let all = way(course.from.lead, course.to.lead);
    let part = way(course.from.lead, lead);
    let rise = whole(course.to.level - course.from.level);
    let level = round_narrow(&(whole(course.from.level) + rise * part / all));
    Spot { lead, level }
}
