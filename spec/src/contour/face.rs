//! A block of G101, G102 or G103 (E100L-CGF-01 to -14), in the order of its tests.

use super::motion::{Course, Step, carry_out, ready};
use super::way::{End, Way};
use super::{face_arc, line, needs_c_axis, position};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::modal::Plan;
use crate::path::Axes;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Part, RuleSet};

/// A motion on the face.
#[derive(Clone, Copy, Debug)]
pub struct FaceStep {
    /// Where it ends.
    pub end: End,
    /// The travel of C.
    pub travel: i64,
    /// Which way.
    pub course: Course,
    /// The rules that led there.
    pub rules: RuleSet,
}

impl FaceStep {
    /// Whether C turns alone.
    pub fn is_turn(&self) -> bool {
        matches!(self.course, Course::Line { part: Some(Part::Turn), .. })
    }
}

/// Cuts it.
pub fn cut(plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    needs_c_axis(CGF_07, CGF_07, state)?;
    let way = Way::of(plan, state)?;
    is_positive(&way, plan)?;
    let axes = Axes { x: true, z: plan.words.get('Z').is_some(), ..Axes::default() };
    let steps = match plan.motion() {
        101 => line::steps(&way, axes.z)?,
        _ => vec![face_arc::step(&way, plan)?],
    };
    let last = Amounts { x: way.end.x, z: way.z.1, c: way.end.c, w: state.frame.program().w };
    let feed = ready(last, axes, CGF_01, state)?;
    let rules = cited(plan, state);
    for FaceStep { end, travel, course, rules: own } in steps {
        let target = Amounts { x: end.x, c: end.c, ..last };
        let step = Step { target, travel, point: Some(end.point), course, rules: rules.union(own) };
        emissions.push(carry_out(&step, axes, feed, plan, state)?);
    }
    if plan.converts && plan.words.has_any("XY") {
        state.contour.keep(way.end.point, way.end.x, way.end.c, &state.frame);
    }
    Ok(())
}

/// E100L-CGF-08: X of start and target.
pub fn is_positive(way: &Way, plan: &Plan) -> Outcome<()> {
    let lowest = if plan.motion() == 101 { 0 } else { 1 };
    if way.start.x < lowest || way.end.x < lowest {
        return fail(AlarmName::ContourXNotPositive, CGF_08);
    }
    Ok(())
}

/// The rules that the motions of a block cite.
pub fn cited(plan: &Plan, state: &State) -> RuleSet {
    let rules = RuleSet::of(&[CGF_01, CGF_06]);
    if plan.converts { rules.with(CGF_14).union(position::cited(plan, state)) } else { rules }
}
