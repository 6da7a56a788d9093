//! A pass of modes I and IV along its level and along the contour (E100L-AP1-04, E100L-AP1-05, E100L-AP1-10).

use super::air::{Section, sections};
use super::bar::Ground;
use super::course::{Stop, Stretch};
use super::infeed::end_of;
use super::motion::{Course, Role, Tool};
use super::number::Number;
use super::plane::Spot;
use super::roles::{Pass, Straight};
use crate::fault::Outcome;
use crate::state::StoredFeed;

/// The level of a pass.
#[derive(Clone, Copy, Debug)]
pub struct Level {
    /// Its coordinate on the infeed axis.
    pub level: i64,
    /// That of the level above it.
    pub upper: i64,
    /// The feed.
    pub feed: Option<StoredFeed>,
}

/// A pass while it is cut.
#[derive(Debug)]
pub struct Cutting {
    /// The pass.
    pub pass: Pass,
    /// Its level.
    pub level: Level,
    /// The level up to which the contour is followed; without one to its end.
    until: Option<i64>,
    /// The recesses that it has met.
    pub recesses: Vec<Stop>,
    /// The highest height of its path.
    pub highest: Number,
    /// The height in which it has ended at the end of the contour.
    pub ended: Option<Number>,
}

impl Cutting {
    /// A pass that begins at a height.
    pub fn new(pass: Pass, level: Level, until: Option<i64>, begin: Number) -> Self {
        Self { pass, level, until, recesses: Vec::new(), highest: begin, ended: None }
    }
}

/// Cuts along the level from a run to where it meets the contour, or to the end; where it has met it.
pub fn straight(
    from: &Number,
    met: Option<Stop>,
    over_recess: bool,
    cutting: &mut Cutting,
    ground: &Ground,
    tool: &mut Tool,
) -> Outcome<Option<Stop>> {
    let (job, plane) = (&ground.job, ground.job.plane);
    let height = plane.height(cutting.level.level);
    let to = met.as_ref().map(|met| met.place.run.clone()).or_else(|| end_of(ground));
    let Some(to) = to else { return Ok(None) };
    let parts = match &ground.blank {
        None => vec![Section { to, air: false }],
        Some(blank) => sections(from, &to, &blank.above_level(&height), &plane.length(job.clearance)),
    };
    let parted = parts.len() > 1;
    let role = ground.roles.cut(&cutting.pass, Straight { over_recess, parted, meets: met.is_some() });
    for Section { to, air } in parts {
        let to = Spot { infeed: cutting.level.level, cutting: plane.cutting(&to) };
        if air {
            tool.rapid(to, ground.roles.air(&cutting.pass))?;
        } else {
            tool.go(to, &Course::Line(cutting.level.feed), role)?;
        }
    }
    if met.is_none() {
        cutting.ended = Some(height.into());
    }
    Ok(met)
}

/// The run along the contour: over the recesses, up to the level before or to the end.
pub fn follow(mut from: Stop, cutting: &mut Cutting, ground: &Ground, tool: &mut Tool) -> Outcome<()> {
    let (contour, plane) = (&ground.contour, ground.job.plane);
    let height = plane.height(cutting.level.level);
    let until = cutting.until.map(|until| plane.height(until));
    loop {
        let above = until.as_ref().and_then(|until| contour.above(&from, until));
        let fallen = contour.down(&from, &height);
        let first = |fallen: &Stop| above.as_ref().is_none_or(|above| above.is_behind(fallen));
        let Some(recess) = fallen.filter(first) else {
            let Some(to) = above.clone().or_else(|| contour.end()) else { return Ok(()) };
            along(&from, &to, false, cutting, ground, tool)?;
            if above.is_none() {
                cutting.ended = Some(to.place.height);
            }
            return Ok(());
        };
        along(&from, &recess, true, cutting, ground, tool)?;
        cutting.recesses.push(recess.clone());
        let met = contour.up_behind(&recess, &height);
        match straight(&recess.place.run, met, true, cutting, ground, tool)? {
            Some(next) => from = next,
            None => return Ok(()),
        }
    }
}

/// The motions along the contour from one point to another.
fn along(
    from: &Stop,
    to: &Stop,
    into_recess: bool,
    cutting: &mut Cutting,
    ground: &Ground,
    tool: &mut Tool,
) -> Outcome<()> {
    let mut present = tool.present();
    let mut motions = Vec::new();
    for Stretch { element, to } in ground.contour.along(from, to) {
        let end = ground.job.plane.latched(&to);
        // What has no travel is no motion.
        if std::mem::replace(&mut present, end) != end {
            motions.push((element, end));
        }
    }
    let count = motions.len();
    for ((element, end), number) in motions.into_iter().zip(1..) {
        let Some(element) = ground.job.rough.elements.get(element) else { continue };
        let (course, cited) = ground.job.along(element, cutting.level.feed);
        let role = ground.roles.contour(&cutting.pass, into_recess && number == count);
        tool.go(end, &course, Role { cited: role.cited.and(cited), ..role })?;
    }
    let highest = ground.contour.highest(from, to);
    if highest > cutting.highest {
        cutting.highest = highest;
    }
    Ok(())
}
