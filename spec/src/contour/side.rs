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

/// Cuts it.
pub fn cut(plan: &Plan, state: &mut State) -> Outcome<Emission> {
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
    let z = target('Z', present.z);
    // E100L-CGS-05, E100L-CAX-05.
    let c = target('C', present.c).unwrap_or(present.c);
    let travel = turn::travel(present.c, c, 0, state.is_active(15));
    let target = Amounts { z: z.unwrap_or(present.z), c: turn::within(c), ..present };
    let course = course(present, target.z, travel, plan, state)?;
    if state.contour.is_too_far(travel) {
        return fail(AlarmName::ProfileGeneration, CGS_06);
    }
    let axes = Axes { z: z.is_some(), ..Axes::default() };
    let feed = ready(target, axes, CGS_01, state)?;
    let step = Step { target, travel, point: None, course, rules: cited(plan, state) };
    carry_out(&step, axes, feed, plan, state)
}

/// E100L-CGS-02, E100L-CGS-04: the arc in the plane (p, q), q being Z and p the way on the cylinder, mirrored if it is seen
/// from inside.
fn course(present: Amounts, z: i64, travel: i64, plan: &Plan, state: &State) -> Outcome<Course> {
    let sense = if plan.motion() == 132 { Sense::Clockwise } else { Sense::CounterClockwise };
    let radius = plan.words.get('L').unwrap_or(0);
    let side = match state.setup.parameters.side_plane {
        SidePlane::Outer => 1,
        SidePlane::Inner => -1,
    };
    // u / π.
    let on_cylinder = whole(present.x) * whole(travel) / whole(turn::FULL_TURN);
    let exact = |precision| real::pi(precision).mul(&Interval::of(&on_cylinder, precision));
    let along = narrow(&real::nearest_whole(exact));
    let rise: Exact = whole(z - present.z);
    let rise_square = &rise * &rise;
    let chord_square = |precision| {
        let along = exact(precision);
        along.mul(&along).add(&Interval::of(&rise_square, precision))
    };
    let (start, end) = (PlanePoint { p: 0, q: present.z }, PlanePoint { p: side * along, q: z });
    let centre = Arc { start, end, radius, sense }.centre(chord_square, CGS_04)?;
    let arc = SideArc { travel: Length(along), centre: Length(side * centre.p), centre_z: Length(centre.q) };
    Ok(Course::Arc(sense, ContourPlane::SideArc(arc)))
}

fn cited(plan: &Plan, state: &State) -> RuleSet {
    let rules = RuleSet::of(&[CGS_01, CGS_02, CGS_04]);
    let rules = if plan.words.get('C').is_some() { rules.with(CGS_05).with(CAX_05) } else { rules };
    if state.setup.parameters.side_contour_mode { rules.with(CGS_07) } else { rules }
}
