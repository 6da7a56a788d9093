//! Where the passes of modes I and IV are begun (E100L-AP1-03, E100L-AP4-02 to -04).

use super::bar::Ground;
use super::course::Stop;
use super::follow::Level;
use super::motion::{Course, Tool};
use super::number::Number;
use super::plane::{Place, Spot};
use super::roles::Pass;
use crate::fault::{Fault, Outcome};
use crate::quantity::{Exact, ratio};
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// The way in of a pass.
#[derive(Clone, Debug)]
pub struct Infeed {
    /// Its levels and its feed.
    pub level: Level,
    /// Whether it is the last one, along the contour.
    pub last: bool,
    /// Where its level meets the contour.
    pub met: Option<Stop>,
    /// The infeed point, exact.
    pub from: Place,
}

impl Infeed {
    /// That of the pass below a level.
    pub fn below(ground: &Ground, upper: i64) -> Outcome<Self> {
        let (plane, start) = (ground.job.plane, ground.job.rough.start);
        let level = ground.level_below(upper);
        // E100L-AP1-02: where the level is that of the start, both would begin in the same point.
        let last = plane.up * (level.level - start.infeed) <= 0;
        let height = plane.height(level.level);
        let begin = ground.contour.start();
        let met = begin.and_then(|begin| ground.contour.up(&begin, &height));
        let from = if last {
            plane.place(start_of_last(ground))
        } else {
            Place { run: run_of_infeed(ground, &level, met.as_ref())?, height: height.into() }
        };
        Ok(Self { level, last, met, from })
    }

    /// The infeed point, latched.
    pub fn spot(&self, ground: &Ground) -> Spot {
        ground.job.plane.latched(&self.from)
    }

    /// E100L-LAP-05, E100L-AP4-04: goes there, in the last pass of mode IV on to the start of the contour.
    pub fn go_in(&self, pass: &Pass, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
        let role = ground.roles.infeed(pass);
        let fast = ground.job.rapid_first || ground.blank.is_some() && self.last;
        let course = if fast { Course::Rapid } else { Course::Line(self.level.feed) };
        tool.go(self.spot(ground), &course, role)?;
        if self.last { tool.go(ground.job.rough.start, &Course::Line(self.level.feed), role) } else { Ok(()) }
    }
}

/// Where the last pass leads to first: the start of the contour, or in mode IV the point in front of it.
fn start_of_last(ground: &Ground) -> Spot {
    let (job, start) = (&ground.job, ground.job.rough.start);
    if ground.blank.is_none() || ground.roles.near {
        return start;
    }
    Spot { cutting: start.cutting - job.plane.onward * job.clearance, ..start }
}

fn run_of_infeed(ground: &Ground, level: &Level, met: Option<&Stop>) -> Outcome<Number> {
    let Some(blank) = &ground.blank else { return Ok(on_line(ground, level.level).into()) };
    let (job, plane) = (&ground.job, ground.job.plane);
    let stock = blank.above_level(&plane.height(level.level)).into_iter().next().map(|(begin, _)| begin);
    let met = met.map(|met| met.place.run.clone()).or_else(|| end_of(ground));
    let front = match (stock, met) {
        (Some(stock), Some(met)) => stock.min(met),
        (stock, met) => stock.or(met).unwrap_or_else(|| Exact::ZERO.into()),
    };
    let before = front.plus(&-plane.length(job.clearance));
    if !ground.roles.near {
        return Ok(before);
    }
    if plane.up * (level.level - job.start.infeed) > 0 {
        return Err(Fault::about(AlarmName::Unspecified, AP4_03, "start"));
    }
    Ok(before.max(on_line(ground, level.level).into()))
}

/// The run at which the contour ends (E100L-LAP-21, E100L-AP4-07).
pub fn end_of(ground: &Ground) -> Option<Number> {
    ground.contour.end().map(|end| end.place.run)
}

/// E100L-AP1-03: the run of the line from S to the start of the rough contour at a level.
fn on_line(ground: &Ground, level: i64) -> Exact {
    let (plane, from, to) = (ground.job.plane, ground.job.start, ground.job.rough.start);
    let (first, last) = (plane.run(from.cutting), plane.run(to.cutting));
    let rise = to.infeed - from.infeed;
    if rise == 0 {
        return first;
    }
    // S lies above A'.
    let share = ratio((level - from.infeed) * rise.signum(), rise.unsigned_abs());
    &first + share * (last - &first)
}
