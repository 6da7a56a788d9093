//! Mode V: passes along the blank, then along the contour, with cuts along the blank where the contour falls below it
//! (E100L-AP5-01 to -08; execution-lap.md, section 12).

use std::sync::Arc;

use super::bar::{LIFT, go_home};
use super::contour::{Element, Outline};
use super::job::{Job, check_direction};
use super::leave::{Cover, Leave, Search};
use super::motion::{Course, Role, Tool};
use super::number::Number;
use super::plane::{Place, Spot};
use super::shape::{Shape, place, shapes};
use super::track::{Path, Target, Track};
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::quantity::Exact;
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Part, RuleId};

/// What the passes of a cycle go by.
#[derive(Debug)]
struct Ground {
    job: Job,
    /// The blank, its start moved up if need be.
    blank: Outline,
    /// Whether it was.
    moved_up: bool,
    track: Vec<Shape>,
    target: Target,
    cover: Cover,
    /// D as a height.
    step: Exact,
}

/// A cycle with the passes that are left of it.
#[derive(Debug)]
pub struct BarCopy {
    ground: Arc<Ground>,
    /// How many passes have begun.
    number: u32,
    /// Which multiple of D the next pass along the blank has.
    multiple: i64,
    stage: Stage,
}

/// How far a cycle has come.
#[derive(Debug)]
enum Stage {
    /// A pass along the blank is next, or the run along the contour.
    Passes,
    /// The contour is left.
    Contour(Box<Left>),
}

/// Where the contour is left.
#[derive(Debug)]
struct Left {
    /// On which element.
    element: usize,
    /// That element was looked at up to there.
    search: Search,
    leave: Leave,
}

impl Ground {
    fn new(job: Job) -> Outcome<Self> {
        check_direction(&job)?;
        let plane = job.plane;
        let start = job.blank.as_ref().map_or(job.rough.start, |blank| blank.start);
        if plane.onward * (start.cutting - job.rough.start.cutting) > job.clearance {
            let allowance = if plane.transverse { "U" } else { "W" };
            return Err(Fault::about(AlarmName::LapAllowance, AP5_02, allowance));
        }
        let (blank, moved_up) = moved_up(&job)?;
        let track = shapes(&blank, plane);
        let contour = shapes(&job.rough, plane);
        let end = job.rough.end();
        let target = Target { shapes: contour, end: (plane.run(end.cutting), plane.height(end.infeed)) };
        let front = plane.run(job.rough.start.cutting);
        let step = plane.height(plane.up * job.depth());
        let cover = Cover::new(&track, &front, step.clone());
        Ok(Self { job, blank, moved_up, track, target, cover, step })
    }

    /// K of a multiple of D.
    fn track(&self, multiple: i64) -> Track {
        let lowered = crate::quantity::whole(multiple) * &self.step;
        Track::new(&self.track, &lowered, &self.job.plane.length(self.job.clearance))
    }

    /// X1 less a multiple of D.
    fn level(&self, multiple: i64) -> i64 {
        let lowered = multiple.saturating_mul(self.job.depth());
        self.blank.start.infeed.saturating_sub(self.job.plane.up.saturating_mul(lowered))
    }

    /// Cuts along K.
    fn cut(&self, path: &Path, multiple: i64, role: Role, tool: &mut Tool) -> Outcome<()> {
        let (plane, feed) = (self.job.plane, self.job.feed);
        let lowered = -plane.up * multiple.saturating_mul(self.job.depth());
        for leg in &path.legs {
            let arc =
                leg.element.and_then(|element| self.blank.elements.get(element)).and_then(|each| each.arc);
            let course = match arc {
                Some((centre, sense)) => {
                    Course::Arc(Spot { infeed: centre.infeed + lowered, ..centre }, sense, feed)
                }
                None => Course::Line(feed),
            };
            tool.go(plane.latched(&leg.to), &course, role)?;
        }
        let (infeed, cutting) = self.job.double_relief();
        tool.relieve(infeed, cutting, Role { part: Part::Relief, ..role })
    }

    /// E100L-AP5-04, E100L-AP5-06: above what was cut.
    fn clear(&self, highest: &Number, role: Role, tool: &mut Tool) -> Outcome<()> {
        let plane = self.job.plane;
        tool.lift(plane.infeed(highest) + plane.up * LIFT, Role { part: Part::Clear, ..role })
    }
}

/// E100L-AP5-01: a front face of the blank is no guide for passes; whether there was one.
fn moved_up(job: &Job) -> Outcome<(Outline, bool)> {
    let Some(blank) = job.blank.clone() else {
        return Ok((Outline { start: job.rough.start, elements: Vec::new() }, false));
    };
    let Some(Element { end, arc, .. }) = blank.elements.first() else { return Ok((blank, false)) };
    if job.plane.up * (end.infeed - blank.start.infeed) <= 0 {
        return Ok((blank, false));
    }
    if arc.is_some() {
        return Err(Fault::about(AlarmName::Unspecified, AP5_01, "blank"));
    }
    let start = Spot { infeed: end.infeed, ..blank.start };
    Ok((Outline { start, ..blank }.without_standing(), true))
}

impl BarCopy {
    /// The cycle of a call, before its first pass.
    pub fn begin(job: Job) -> Outcome<Self> {
        let ground = Arc::new(Ground::new(job)?);
        Ok(Self { ground, number: 0, multiple: 1, stage: Stage::Passes })
    }

    /// Cuts the next pass, or the next cut from the contour, and goes to where the one after it begins; whether there is
    /// one.
    pub fn pass(&mut self, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<bool> {
        let ground = Arc::clone(&self.ground);
        let mut tool = Tool { job: &ground.job, state, emissions };
        match std::mem::replace(&mut self.stage, Stage::Passes) {
            Stage::Passes => {
                self.number = self.number.saturating_add(1);
                let level = ground.level(self.multiple);
                let above = ground.job.plane.up * (level - ground.job.rough.start.infeed) > 0;
                if above {
                    self.pass_along_blank(&ground, &mut tool)?;
                    return Ok(true);
                }
                self.go_in(ground.job.rough.start, false, &ground, &mut tool)?;
                self.along_contour(0, None, &ground, &mut tool)
            }
            Stage::Contour(left) => {
                let Left { element, search, leave } = *left;
                self.cut_from_contour(&leave, &ground, &mut tool)?;
                self.along_contour(element, Some(search), &ground, &mut tool)
            }
        }
    }

    fn role(&self, part: Part, rules: &[RuleId]) -> Role {
        Role { pass: Some(self.number), part, cited: Cited::rules(rules) }
    }

    /// E100L-AP5-02, E100L-AP5-05: first the infeed axis, then the cutting axis.
    fn go_in(&self, to: Spot, along_blank: bool, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
        let first = self.number == 1;
        let own: RuleId = if along_blank { AP5_02 } else { AP5_05 };
        let role = self.role(Part::Infeed, &[own, if first { LAP_05 } else { AP5_04 }]);
        let line = first && !ground.job.rapid_first;
        let course = if line { Course::Line(ground.job.feed) } else { Course::Rapid };
        tool.go(Spot { infeed: to.infeed, ..tool.present() }, &course, role)?;
        tool.go(to, &course, role)
    }

    /// E100L-AP5-03, E100L-AP5-04: a pass along the blank, and the way back.
    fn pass_along_blank(&mut self, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
        let plane = ground.job.plane;
        let track = ground.track(self.multiple);
        let (Some(start), Some(path)) = (track.start(), track.whole(&ground.target)) else { return Ok(()) };
        self.go_in(plane.latched(&start), true, ground, tool)?;
        let role = self.role(Part::Cut, &[AP5_03]);
        let role = Role { cited: role.cited.and_if(ground.moved_up, Cited::rules(&[AP5_01])), ..role };
        ground.cut(&path, self.multiple, role, tool)?;
        let role = self.role(Part::Return, &[AP5_04]);
        ground.clear(&path.highest, role, tool)?;
        tool.rapid_cutting(ground.job.start.cutting, role)?;
        self.multiple = self.multiple.saturating_add(1);
        Ok(())
    }

    /// E100L-AP5-05: along the contour from an element on, up to the point in which it is left next, or to its end. Whether
    /// a cut is left.
    fn along_contour(
        &mut self,
        from: usize,
        mut begun: Option<Search>,
        ground: &Ground,
        tool: &mut Tool,
    ) -> Outcome<bool> {
        let (job, plane) = (&ground.job, ground.job.plane);
        for (index, (element, shape)) in
            job.rough.elements.iter().zip(&ground.target.shapes).enumerate().skip(from)
        {
            let mut search = begun.take().unwrap_or_else(|| ground.cover.search(shape));
            let (course, cited) = job.along(element, job.feed);
            let role = self.role(Part::Contour, &[AP5_05]);
            let role = Role { cited: role.cited.and(cited), ..role };
            let Some(leave) = ground.cover.next(shape, &mut search) else {
                tool.go(element.end, &course, role)?;
                continue;
            };
            tool.go(plane.latched(&leave.at), &course, role)?;
            self.stage = Stage::Contour(Box::new(Left { element: index, search, leave }));
            return Ok(true);
        }
        self.leave(ground, tool)?;
        Ok(false)
    }

    /// E100L-AP5-06: a cut along the blank from the contour, and back.
    fn cut_from_contour(&self, leave: &Leave, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
        let Leave { at, multiple } = leave;
        let path = ground.track(*multiple).behind(at, &ground.target);
        let role = |part| self.role(part, &[AP5_06]);
        ground.cut(&path, *multiple, role(Part::Cut), tool)?;
        ground.clear(&path.highest, role(Part::Clear), tool)?;
        let back = ground.job.plane.latched(at);
        tool.rapid_cutting(back.cutting, role(Part::Return))?;
        tool.go(back, &Course::Line(ground.job.feed), role(Part::Return))
    }

    /// E100L-AP5-07: the end of the contour.
    fn leave(&self, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
        let job = &ground.job;
        tool.relieve(job.relief, job.relief, self.role(Part::Relief, &[AP5_07]))?;
        let end: Place = job.plane.place(job.rough.end());
        let top = |shape: &Shape| shape.highest(&place(&shape.from), &place(&shape.to));
        let tops = ground.target.shapes.iter().map(top);
        if let Some(top) = tops.reduce(Number::max).filter(|top| end.height < *top) {
            ground.clear(&top, self.role(Part::Clear, &[AP5_07]), tool)?;
        }
        go_home(job, Role { pass: None, ..self.role(Part::Home, &[AP5_07, LAP_06]) }, tool)
    }
}
