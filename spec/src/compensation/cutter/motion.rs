//! P of a block with a motion in the plane, and what the motion is as an element (E100L-CRC-14).

use super::super::leg::{Course as Curve, Leg};
use super::super::nose::Nose;
use super::cited;
use super::course::Course;
use super::pending::Pending;
use super::plane::Spot;
use super::programmed::{Destination, Programmed};
use crate::contour::{self, Cylinder, FaceArc, Step, Way as FaceWay};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::modal::{Plan, active_feed};
use crate::path::{self, Axes, Element, Tested, Vector, Way, check_range};
use crate::quantity::whole;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Place, RuleSet, Sense};

/// A motion in the plane, which P has made.
pub struct Motion {
    pending: Pending,
    /// P before it.
    from: contour::PlanePoint,
    /// Whether P has moved.
    travels: bool,
}

impl Motion {
    /// Moves P: the own tests of the motion behind those of section 9.
    pub fn find(
        programmed: &mut Programmed,
        nose: Nose,
        plan: &Plan,
        place: Place,
        state: &mut State,
    ) -> Outcome<Self> {
        let (before, start) = (state.frame.machine, programmed.point);
        let destination = programmed.destination(plan, state)?;
        let (event, course) = match plan.motion() {
            101..=103 => on_face(nose, plan, state)?,
            132 | 133 => on_side(programmed, plan, state)?,
            _ => by_axes(&destination, plan, state)?,
        };
        programmed.go(&destination);
        let rules = cited(programmed.plane);
        let after = state.frame.machine;
        let is_line = matches!(event.action, Action::Linear { .. });
        let pending = Pending {
            spot: Spot::present(programmed, plan.converts, place, state),
            event: event.rules(rules).rule_if(is_line, NRC_42),
            course,
            z_travel: after.z - before.z,
            w_travel: after.w - before.w,
        };
        let travels = match start {
            Some(start) => start != pending.spot.point,
            None => (before.x, before.c) != (after.x, after.c),
        };
        Ok(Self { pending, from: start.unwrap_or_default(), travels })
    }

    /// E100L-CRC-14: whether the cutter centre has no circle to go on.
    pub fn has_no_radius(&self) -> bool {
        matches!(self.pending.course, Course::FaceArc(FaceArc { radius, .. }) if radius < 0)
    }

    /// The element at its start and at its end.
    pub fn legs(&self, nose: Nose) -> (Leg, Leg) {
        let to = self.pending.spot.point;
        let arc = match self.pending.course {
            Course::Axes { .. } | Course::Line { .. } => None,
            Course::FaceArc(arc) => Some((arc.centre, arc.sense)),
            Course::SideArc { centre, sense, .. } => Some((centre, sense)),
        };
        match arc {
            None => {
                let direction = between(self.from, to);
                (Leg::line(direction.clone(), nose), Leg::line(direction, nose))
            }
            Some((centre, sense)) => {
                let leg = |point| Leg { course: Curve::Arc(between(centre, point), sense), nose };
                (leg(self.from), leg(to))
            }
        }
    }

    /// As the start-up (E100L-CRC-08, E100L-CRC-10).
    pub fn start_up(self) -> Pending {
        let event = self.pending.event.rules(RuleSet::of(&[NRC_14, CRC_08, CRC_10]));
        Pending { event: event.rule_if(!self.travels, NRC_20), ..self.pending }
    }

    /// As an element.
    pub fn element(self) -> Pending {
        let rules = match self.pending.event.action {
            Action::Rapid { .. } => RuleSet::of(&[NRC_41]),
            Action::ContourArc { .. } => RuleSet::of(&[NRC_48, NRC_60]),
            _ => RuleSet::EMPTY,
        };
        Pending { event: self.pending.event.rules(rules), ..self.pending }
    }
}

/// From one point to another: p for z, q for x.
fn between(from: contour::PlanePoint, to: contour::PlanePoint) -> Vector {
    Vector { z: whole(to.p - from.p), x: whole(to.q - from.q) }
}

/// G00 and G01.
fn by_axes(destination: &Destination, plan: &Plan, state: &mut State) -> Outcome<(Emission, Course)> {
    let course = Course::Axes { positive: state.is_active(15) };
    let from = (state.frame.machine.x, state.frame.machine.z);
    // No barrier is on.
    let way = Way { from, limits: Tested::OutsidePlane, barriers: false };
    if plan.converts {
        state.base = None;
        let (mut element, point) = contour::positioning(plan, state)?;
        turns_with(&mut element, destination, 0);
        return Ok((contour::go_to(&element, point, way, plan, state)?, course));
    }
    let mut element = line(plan, state)?;
    turns_with(&mut element, destination, 0);
    Ok((path::carry_out(&element, way, plan, state)?, course))
}

/// The line of a block with G00 or G01, tested for ranges and C.
pub fn line(plan: &Plan, state: &mut State) -> Outcome<Element> {
    let elements = path::elements(plan, &[], state)?;
    match elements.into_iter().next() {
        Some(element) => Ok(element),
        None => fail(AlarmName::NotModelled, CRC_14),
    }
}

/// C goes with it, whether it has a word or not.
pub fn turns_with(element: &mut Element, destination: &Destination, travel: i64) {
    element.target.c = destination.c;
    element.axes.c = Some(travel);
}

/// Where a block of G101, G102 or G103 leads P, and its tests up to those of the feed.
pub struct OnFace {
    /// The way of P.
    pub way: FaceWay,
    /// The arc.
    pub arc: Option<FaceArc>,
    /// The end in program coordinates.
    pub target: Amounts,
}

impl OnFace {
    /// Finds it.
    pub fn find(plan: &Plan, state: &State) -> Outcome<Self> {
        let way = FaceWay::of(plan, state)?;
        contour::is_positive(&way, plan)?;
        let arc = if plan.motion() == 101 { None } else { Some(FaceArc::of(&way, plan)?) };
        let target = Amounts { x: way.end.x, z: way.z.1, c: way.end.c, w: state.frame.program().w };
        let axes = Axes { x: true, z: plan.words.get('Z').is_some(), ..Axes::default() };
        check_range(target, axes, state.setup)?;
        Ok(Self { way, arc, target })
    }

    /// The point of a block in conversion mode is kept.
    pub fn keep(&self, plan: &Plan, state: &mut State) {
        let end = self.way.end;
        if plan.converts && plan.words.has_any("XY") {
            state.contour.keep(end.point, end.x, end.c, &state.frame);
        }
    }
}

fn on_face(nose: Nose, plan: &Plan, state: &mut State) -> Outcome<(Emission, Course)> {
    state.base = None;
    let found = OnFace::find(plan, state)?;
    let feed = active_feed(state)?;
    let rules = contour::face_cited(plan, state);
    let (own, course, rules) = match found.arc {
        None => {
            let has_z = plan.words.get('Z').is_some();
            (contour::Course::Line { path: 0, part: None }, Course::Line { has_z }, rules)
        }
        Some(arc) => {
            // L' = L - s·σ·R.
            let inward = if arc.sense == Sense::CounterClockwise { nose.offset() } else { -nose.offset() };
            let of_centre = FaceArc { radius: arc.radius - inward, ..arc };
            (arc.course(), Course::FaceArc(of_centre), rules.with(CGF_04))
        }
    };
    let point = Some(found.way.end.point);
    let step = Step { target: found.target, travel: 0, point, course: own, rules };
    let event = contour::carry_out_step(&step, Axes::default(), feed, plan, state)?;
    found.keep(plan, state);
    Ok((event, course))
}

fn on_side(programmed: &Programmed, plan: &Plan, state: &mut State) -> Outcome<(Emission, Course)> {
    state.base = None;
    let (target, travel) = contour::side_target(plan, state)?;
    let cylinder = Cylinder::present(state);
    let from = programmed.point.unwrap_or_default();
    let to = programmed.destination(plan, state)?.point.unwrap_or_default();
    let centre = cylinder.centre((from, to), travel, plan)?;
    let axes = Axes { z: plan.words.get('Z').is_some(), ..Axes::default() };
    check_range(target, axes, state.setup)?;
    let feed = active_feed(state)?;
    let sense = contour::side_sense(plan);
    let course = cylinder.course(from, to, centre, sense);
    let step = Step { target, travel: 0, point: None, course, rules: contour::side_cited(plan, state) };
    let event = contour::carry_out_step(&step, Axes::default(), feed, plan, state)?;
    Ok((event, Course::SideArc { centre, sense, cylinder, from }))
}
