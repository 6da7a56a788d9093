//! A block of G132 or G133: an arc on the developed cylinder (E100L-CGS-01 to -08), in the order of its tests.

use super::arc::Arc;
use super::motion::{Course, Step, carry_out, ready};
use super::needs_c_axis;
use super::plane::PlanePoint;
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::integer::turn;
use crate::modal::Plan;
use crate::path::Axes;
use crate::quantity::{Exact, narrow, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, ContourPlane, Length, RuleSet, Sense, SideArc, SidePlane};

/// The developed cylinder of a program diameter: p along it, q along Z.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    diameter: i64,
    /// 1, or -1 if it is seen from inside.
    view: i64,
}

impl Cylinder {
    /// That of the present diameter.
    pub fn present(state: &State) -> Self {
        let view = match state.setup.parameters.side_plane {
            SidePlane::Outer => 1,
            SidePlane::Inner => -1,
        };
        Self { diameter: state.frame.program().x, view }
    }

    /// u, the length of a turn, exact; any turn.
    fn exact_length(self, turn: i64, precision: usize) -> Interval {
        let over_pi = whole(self.diameter) * whole(turn) / whole(turn::FULL_TURN);
        real::pi(precision).mul(&Interval::of(&over_pi, precision))
    }

    /// The point at the end of a turn, u latched, and at this Z.
    pub fn point(self, turn: i64, z: i64) -> PlanePoint {
        let length = narrow(&real::nearest_whole(|precision| self.exact_length(turn, precision)));
        PlanePoint { p: self.view * PlanePoint::within(length), q: z }
    }

    /// How far one point is from another in the direction of C+.
    pub fn along(self, from: PlanePoint, to: PlanePoint) -> i64 {
        self.view * (to.p - from.p)
    }

    /// The turn of C from one point to another, latched, in micro-degrees. The diameter is not 0.
    pub fn turn(self, from: PlanePoint, to: PlanePoint) -> i64 {
        let over_diameter = whole(self.along(from, to)) * whole(turn::FULL_TURN) / whole(self.diameter);
        narrow(&real::nearest_whole(|precision| {
            Interval::of(&over_diameter, precision).div(&real::pi(precision))
        }))
    }

    /// E100L-CGS-04: the centre of the arc of a block between two points, `travel` of C apart.
    pub fn centre(self, ends: (PlanePoint, PlanePoint), travel: i64, plan: &Plan) -> Outcome<PlanePoint> {
        let (start, end) = ends;
        let rise: Exact = whole(end.q - start.q);
        let rise_square = &rise * &rise;
        let chord_square = |precision| {
            let along = self.exact_length(travel, precision);
            along.mul(&along).add(&Interval::of(&rise_square, precision))
        };
        let radius = plan.words.get('L').unwrap_or(0);
        Arc { start, end, radius, sense: sense(plan) }.centre(chord_square, CGS_04)
    }

    /// The course of an arc from a start to an end about a centre.
    pub fn course(self, start: PlanePoint, end: PlanePoint, centre: PlanePoint, sense: Sense) -> Course {
        let arc = SideArc {
            travel: Length(self.along(start, end)),
            centre: Length(self.along(start, centre)),
            centre_z: Length(centre.q),
        };
        Course::Arc(sense, ContourPlane::SideArc(arc))
    }
}

/// The way round of a block.
pub fn sense(plan: &Plan) -> Sense {
    if plan.motion() == 132 { Sense::Clockwise } else { Sense::CounterClockwise }
}

/// Where a block leads, in program coordinates, and the travel of C.
pub fn target(plan: &Plan, state: &State) -> Outcome<(Amounts, i64)> {
    needs_c_axis(CAX_02, CAX_07, state)?;
    let words = &plan.words;
    let present = state.frame.program();
    let target = |letter, present: i64| {
        words.get(letter).map(|word| if plan.modes.incremental() { present + word } else { word })
    };
    if target('X', present.x).is_some_and(|x| x != present.x) {
        return fail(AlarmName::ContourXChanged, CGS_03);
    }
    if present.x <= 0 {
        return fail(AlarmName::ContourXNotPositive, CGS_01);
    }
    // E100L-CGS-05, E100L-CAX-05.
    let c = target('C', present.c).unwrap_or(present.c);
    let travel = turn::travel(present.c, c, 0, state.is_active(15));
    let z = target('Z', present.z).unwrap_or(present.z);
    Ok((Amounts { z, c: turn::within(c), ..present }, travel))
}

/// Cuts it.
pub fn cut(plan: &Plan, state: &mut State) -> Outcome<Emission> {
    let (target, travel) = target(plan, state)?;
    let cylinder = Cylinder::present(state);
    let (start, end) = (cylinder.point(0, state.frame.program().z), cylinder.point(travel, target.z));
    let centre = cylinder.centre((start, end), travel, plan)?;
    if state.contour.is_too_far(travel) {
        return fail(AlarmName::ProfileGeneration, CGS_06);
    }
    let axes = Axes { z: plan.words.get('Z').is_some(), ..Axes::default() };
    let feed = ready(target, axes, CGS_01, state)?;
    let course = cylinder.course(start, end, centre, sense(plan));
    let step = Step { target, travel, point: None, course, rules: cited(plan, state) };
    carry_out(&step, axes, feed, plan, state)
}

/// The rules that the motion of a block cites.
pub fn cited(plan: &Plan, state: &State) -> RuleSet {
    let rules = RuleSet::of(&[CGS_01, CGS_02, CGS_04]);
    let rules = if plan.words.get('C').is_some() { rules.with(CGS_05).with(CAX_05) } else { rules };
    if state.setup.parameters.side_contour_mode { rules.with(CGS_07) } else { rules }
}
