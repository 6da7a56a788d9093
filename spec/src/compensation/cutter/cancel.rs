//! The end of compensation in a plane of rotary tools: its motion leads to P (E100L-NRC-66, E100L-CRC-14).

use super::super::on::On;
use super::super::stream::Stream;
use super::motion::{OnFace, line, turns_with};
use super::pending::Pending;
use super::plane::Standing;
use super::programmed::Destination;
use crate::contour::{self, End, PlanePoint, Step, Way as FaceWay, Whose};
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::frame::Amounts;
use crate::integer::turn;
use crate::modal::{CutterPlane, Plan, active_feed};
use crate::path::{self, Axes, Element, Tested, Way};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Feed, RuleSet};

/// A block with G40 and a motion in the plane.
pub fn cancel(
    on: On<Pending>,
    plane: CutterPlane,
    destination: &Destination,
    plan: &Plan,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<()> {
    if plan.motion() == 101 {
        state.base = None;
        let found = OnFace::find(plan, state)?;
        let feed = active_feed(state)?;
        let axes = on.conclude(NRC_66, None, stream, state)?;
        stream.holding = false;
        return along_face(&found, axes, feed, plan, &mut stream.emissions, state);
    }
    let (mut element, point) = if plan.converts {
        state.base = None;
        contour::positioning(plan, state).map(|(element, point)| (element, Some(point)))?
    } else {
        (line(plan, state)?, None)
    };
    element.feed(state)?;
    if element.axes.w {
        let target = state.frame.to_machine(Amounts { w: element.target.w, ..Amounts::default() });
        state.limits.w.clamp(target.w)?;
    }
    let axes = on.conclude(NRC_66, None, stream, state)?;
    stream.holding = false;
    let event = by_axes(&mut element, point, plane, destination, axes, plan, state)?;
    stream.emissions.push(event.rules(RuleSet::of(&[NRC_66])));
    Ok(())
}

/// G00 and G01: limits may cut it back.
fn by_axes(
    element: &mut Element,
    point: Option<PlanePoint>,
    plane: CutterPlane,
    destination: &Destination,
    axes: Standing,
    plan: &Plan,
    state: &mut State,
) -> Outcome<Emission> {
    let present = state.frame.machine;
    let to = state.frame.to_machine(Amounts { c: destination.c, ..Amounts::default() });
    turns_with(element, destination, turn::travel(axes.machine.c, to.c, 0, state.is_active(15)));
    let (from, limits) = match plane {
        CutterPlane::Face => ((axes.machine.x, present.z), Tested::Plane),
        CutterPlane::Side => {
            // Z moves to P with or without its word; without one its target is the present Z.
            element.axes.z = true;
            ((present.x, axes.machine.z), Tested::Commanded)
        }
    };
    let way = Way { from, limits, barriers: false };
    match point {
        Some(point) => contour::go_to(element, point, way, plan, state),
        None => path::carry_out(element, way, plan, state),
    }
}

/// G101: nothing is cut back.
fn along_face(
    found: &OnFace,
    axes: Standing,
    feed: (Feed, RuleSet),
    plan: &Plan,
    emissions: &mut Vec<Emission>,
    state: &mut State,
) -> Outcome<()> {
    let at = state.frame.to_program(axes.machine);
    let start = End::of_point(axes.point, (at.x, at.c));
    let end = End::of_point(found.way.end.point, (found.way.end.x, found.way.end.c));
    let way = FaceWay { start, end, z: found.way.z, of: Whose::Cutter };
    let steps = contour::line_steps(&way, plan.words.get('Z').is_some())?;
    let cited = contour::face_cited(plan, state).with(NRC_66);
    for step in steps {
        let target = Amounts { x: step.end.x, c: step.end.c, ..found.target };
        let rules = cited.union(step.rules);
        let step =
            Step { target, travel: step.travel, point: Some(step.end.point), course: step.course, rules };
        emissions.push(contour::carry_out_step(&step, Axes::PLANE, feed, plan, state)?);
    }
    found.keep(plan, state);
    Ok(())
}
