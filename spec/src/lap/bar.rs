//! Modes I and IV: passes at falling levels, then one along the contour (E100L-AP1-01 to -14, E100L-AP4-01 to -09;
//! execution-lap.md, sections 9 and 11).

use std::sync::Arc;

use super::course::{Course, Stop};
use super::depths::Depths;
use super::follow::{Cutting, Level, follow, straight};
use super::infeed::Infeed;
use super::job::{Job, check_direction};
use super::motion::{Course as Way, Tool};
use super::number::Number;
use super::roles::{Pass, Roles};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::integer::lap::below;
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// By how much the tool is lifted beyond what was cut, an amount on the infeed axis.
pub const LIFT: i64 = 200_000;

/// Most descents of a contour (E100L-AP1-13).
const MOST_DESCENTS: usize = 10;

/// What the passes of a cycle go by.
#[derive(Clone, Debug)]
pub struct Ground {
    /// The data of the call.
    pub job: Job,
    /// The rough contour.
    pub contour: Course,
    /// The blank of mode IV.
    pub blank: Option<Course>,
    /// What its motions name.
    pub roles: Roles,
    depths: Depths,
}

/// A cycle with the passes that are left of it.
#[derive(Clone, Debug)]
pub struct Bar {
    ground: Arc<Ground>,
    /// The pass that has begun last.
    pass: Pass,
    /// The way in of the next pass, if it begins in no recess.
    infeed: Infeed,
    /// The passes whose recesses are not finished, each within a recess of the one before.
    open: Vec<Open>,
    /// The recess in which the next pass begins.
    recess: Option<Stop>,
}

/// A pass that has met recesses.
#[derive(Clone, Debug)]
struct Open {
    level: i64,
    upper: i64,
    recesses: Vec<Stop>,
    /// How many of them were begun.
    begun: usize,
}

impl Ground {
    /// The level of the pass below another level.
    pub fn level_below(&self, upper: i64) -> Level {
        let cut = self.depths.below(upper);
        Level { level: below(upper, self.job.plane.up, cut.depth), upper, feed: cut.feed }
    }

    fn cited_below(&self, upper: i64) -> Cited {
        self.depths.cited(self.depths.below(upper))
    }

    /// E100L-AP4-01: in mode IV levels begin below the highest point of blank and contour.
    fn first_upper(&self) -> i64 {
        let Some(blank) = &self.blank else { return self.job.start.infeed };
        let tops = self.contour.top().into_iter().chain(blank.top());
        tops.reduce(Number::max).map_or(self.job.start.infeed, |top| self.job.plane.infeed(&top))
    }
}

impl Bar {
    /// The cycle of a call, before its first pass.
    pub fn begin(job: Job, state: &State) -> Outcome<Self> {
        let depths = Depths::of(&job, state)?;
        check_direction(&job)?;
        let contour = Course::new(&job.rough, job.plane);
        if contour.descents() > MOST_DESCENTS {
            return fail(AlarmName::DescendingSlopes, AP1_13);
        }
        let blank = job.blank.as_ref().map(|blank| Course::new(blank, job.plane));
        let roles = Roles { high_speed: blank.is_some(), near: job.is_near() };
        let ground = Ground { job, contour, blank, roles, depths };
        let infeed = Infeed::below(&ground, ground.first_upper())?;
        let pass = Pass { number: 0, last: infeed.last, in_recess: false, cited: Cited::default() };
        Ok(Self { ground: Arc::new(ground), pass, infeed, open: Vec::new(), recess: None })
    }

    /// Cuts the next pass, and goes to where the one after it begins; whether there is one.
    pub fn pass(&mut self, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<bool> {
        let ground = Arc::clone(&self.ground);
        let mut tool = Tool { job: &ground.job, state, emissions };
        let number = self.pass.number.saturating_add(1);
        match self.recess.take() {
            Some(recess) => self.pass_in_recess(number, &recess, &ground, &mut tool)?,
            None => self.pass_at_level(number, &ground, &mut tool)?,
        }
        self.settle(&ground, &mut tool)
    }

    /// A pass that begins in no recess.
    fn pass_at_level(&mut self, number: u32, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
        let Infeed { level, last, ref met, ref from, .. } = self.infeed;
        self.pass = Pass { number, last, in_recess: false, cited: ground.cited_below(level.upper) };
        self.infeed.go_in(&self.pass, ground, tool)?;
        let Some(start) = ground.contour.start() else { return Ok(()) };
        // E100L-AP4-01: in the first pass of mode IV there is no level before.
        let followed = ground.blank.is_none() || number > 1;
        let begin =
            if last { start.place.height.clone() } else { ground.job.plane.height(level.level).into() };
        let mut cutting = Cutting::new(self.pass, level, followed.then_some(level.upper), begin);
        let from = if last {
            Some(start)
        } else {
            straight(&from.run, met.clone(), false, &mut cutting, ground, tool)?
        };
        if let Some(from) = from {
            follow(from, &mut cutting, ground, tool)?;
        }
        self.leave(cutting, ground, tool)
    }

    /// E100L-AP1-11: a pass that begins in a recess.
    fn pass_in_recess(
        &mut self,
        number: u32,
        recess: &Stop,
        ground: &Ground,
        tool: &mut Tool,
    ) -> Outcome<()> {
        let Some(outer) = self.open.last() else { return Ok(()) };
        let upper = outer.level;
        self.pass = Pass { number, in_recess: true, cited: ground.cited_below(upper), ..self.pass };
        let level = ground.level_below(upper);
        let mut cutting = Cutting::new(self.pass, level, Some(upper), recess.place.height.clone());
        follow(recess.clone(), &mut cutting, ground, tool)?;
        self.leave(cutting, ground, tool)
    }

    /// E100L-AP1-06, E100L-AP1-12: relief, and the lift of a pass that has ended below its highest point.
    fn leave(&mut self, cutting: Cutting, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
        let (job, roles) = (&ground.job, ground.roles);
        let double = cutting.pass.in_recess && cutting.recesses.is_empty();
        let (infeed, on_z) = if double { job.double_relief() } else { (job.relief, job.relief) };
        tool.relieve(infeed, on_z, roles.relief(&cutting.pass, double))?;
        if cutting.ended.is_some_and(|ended| ended < cutting.highest) {
            let above = job.plane.infeed(&cutting.highest) + job.plane.up * LIFT;
            tool.lift(above, roles.clear(&cutting.pass))?;
        }
        let Level { level, upper, .. } = cutting.level;
        self.open.push(Open { level, upper, recesses: cutting.recesses, begun: 0 });
        Ok(())
    }

    /// The way to the next recess of the passes that are open, or to the next level; whether a pass is left.
    fn settle(&mut self, ground: &Ground, tool: &mut Tool) -> Outcome<bool> {
        let (plane, roles) = (ground.job.plane, ground.roles);
        while let Some(open) = self.open.last_mut() {
            let lifted = open.upper + plane.up * LIFT;
            let level = open.level;
            if let Some(recess) = open.recesses.get(open.begun).cloned() {
                if open.begun > 0 {
                    tool.lift(lifted, roles.clear_of_recess(&self.pass))?;
                }
                open.begun += 1;
                let role = roles.return_to_recess(&self.pass);
                tool.rapid_cutting(plane.cutting(&recess.place.run), role)?;
                tool.rapid_infeed(level, role)?;
                self.recess = Some(recess);
                return Ok(true);
            }
            let met = open.begun > 0;
            self.open.pop();
            if self.open.is_empty() {
                if met {
                    tool.lift(lifted, roles.clear_of_recess(&self.pass))?;
                }
                return self.go_on_below(level, ground, tool);
            }
        }
        Ok(false)
    }

    /// Behind a pass and its recesses: home, or to where the next level is cut.
    fn go_on_below(&mut self, level: i64, ground: &Ground, tool: &mut Tool) -> Outcome<bool> {
        if self.pass.last {
            go_home(&ground.job, ground.roles.home(), tool)?;
            return Ok(false);
        }
        let next = Infeed::below(ground, level)?;
        let role = ground.roles.return_to_infeed(&self.pass);
        if ground.blank.is_some() {
            tool.rapid_cutting(next.spot(ground).cutting, role)?;
        } else {
            // E100L-AP1-07.
            tool.rapid_cutting(self.infeed.spot(ground).cutting, role)?;
            tool.rapid_infeed(level, role)?;
        }
        self.infeed = next;
        Ok(true)
    }
}

/// E100L-LAP-06: back to S, by the first motion of the contour.
pub fn go_home(job: &Job, role: super::motion::Role, tool: &mut Tool) -> Outcome<()> {
    if !job.returns {
        return Ok(());
    }
    if !job.rapid_first {
        tool.rapid_infeed(job.start.infeed, role)?;
    }
    tool.go(job.start, &Way::Rapid, role)
}
