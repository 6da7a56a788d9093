//! Motions of other axes alone in compensation: the cutter stays where it is in the plane (E100L-CRC-14).

use super::super::ending::within_limit;
use super::super::stream::Stream;
use super::cited;
use super::motion::{OnFace, line};
use crate::contour::{self, Step};
use crate::emission::{AtRest, Emission};
use crate::fault::{Fault, Outcome};
use crate::frame::Amounts;
use crate::modal::{CutterPlane, Plan, active_feed};
use crate::path::{self, Axes, Tested, Way};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, RuleSet};

/// Carries it out; where the cutter is becomes known when its turn comes.
pub fn carry_out(plane: CutterPlane, plan: &Plan, stream: &mut Stream, state: &mut State) -> Outcome<()> {
    let event = match plan.motion() {
        101 => along_z(plan, state)?,
        // An arc without travel is refused.
        _ if plan.is_contour() => return contour::carry_out(plan, state, &mut stream.emissions),
        _ => by_axes(plane, plan, state)?,
    };
    let is_line = matches!(event.action, Action::Linear { .. });
    let event = event.rules(cited(plane)).rule_if(is_line, NRC_42);
    stream.emissions.push(Emission { at_rest: Some(AtRest::Cutter(plane)), ..event });
    Ok(())
}

fn by_axes(plane: CutterPlane, plan: &Plan, state: &mut State) -> Outcome<Emission> {
    let element = line(plan, state)?;
    element.feed(state)?;
    if plane == CutterPlane::Face && element.axes.z {
        let target = state.frame.to_machine(Amounts { z: element.target.z, ..Amounts::default() });
        within_limit(state.limits.z, target.z)?;
    }
    let from = (state.frame.machine.x, state.frame.machine.z);
    path::carry_out(&element, Way { from, limits: Tested::OutsidePlane, barriers: true }, plan, state)
}

/// Z alone in G101: a line on the same ray, without travel of C.
fn along_z(plan: &Plan, state: &mut State) -> Outcome<Emission> {
    state.base = None;
    contour::needs_c_axis(CGF_07, CGF_07, state)?;
    let OnFace { way, target, .. } = OnFace::find(plan, state)?;
    let steps = contour::line_steps(&way, true)?;
    let feed = active_feed(state)?;
    if state.watch.chuck || state.watch.tailstock {
        return Err(Fault::about(AlarmName::NotModelled, CGF_01, "barrier"));
    }
    within_limit(state.limits.z, state.frame.to_machine(target).z)?;
    let cited = contour::face_cited(plan, state);
    let (course, own) = match steps.first() {
        Some(step) => (step.course, step.rules),
        None => (contour::Course::Line { path: 0, part: None }, RuleSet::EMPTY),
    };
    let step = Step { target, travel: 0, point: Some(way.end.point), course, rules: cited.union(own) };
    contour::carry_out_step(&step, Axes::default(), feed, plan, state)
}
