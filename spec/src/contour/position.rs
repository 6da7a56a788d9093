//! Points of the face in conversion mode, and the positioning to them (E100L-CSC-02, E100L-CSC-03, E100L-CSC-06).

use super::motion::face_point;
use super::needs_c_axis;
use super::plane::PlanePoint;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::frame::Amounts;
use crate::integer::turn;
use crate::modal::Plan;
use crate::path::{Axes, Element, Shape, Tested, Way, carry_out};
use crate::quantity::{narrow, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, ConversionZeroShift, ReadingSet, RuleSet};

/// E100L-CSC-06, E100L-CSC-07: the point of a block: in G91 from the point before, which keeps a coordinate without word
/// too; none if that is not there.
pub fn target(plan: &Plan, kept: Option<PlanePoint>) -> Option<PlanePoint> {
    let incremental = plan.modes.incremental();
    let coordinate = |letter, kept: Option<i64>| match plan.words.get(letter) {
        None => kept,
        Some(word) if incremental => kept.map(|kept| kept + word),
        word => word,
    };
    let p = coordinate('X', kept.map(|point| point.p))?;
    let q = coordinate('Y', kept.map(|point| point.q))?;
    Some(PlanePoint { p, q })
}

/// How a point of the face becomes program X and C: C of its first axis, in conversion mode θ (E100L-CSC-01) less the
/// zero shift that does not belong to it (E100L-CSC-04), in micro-degrees.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Direction(i64);

impl Direction {
    /// In conversion mode.
    pub fn of_conversion(state: &State) -> Self {
        let shift = match state.setup.parameters.conversion_zero_shift {
            ConversionZeroShift::Included => 0,
            ConversionZeroShift::Excluded => state.frame.zero_shift.c,
        };
        Self(state.contour.direction - shift)
    }

    /// Out of it: the first axis is on program C0 (E100L-CGF-01).
    pub const ZERO: Self = Self(0);

    /// E100L-CSC-03: program X and program C of a point, latched.
    pub fn axes(self, point: PlanePoint) -> (i64, i64) {
        let square = whole(4) * whole(point.square());
        let x = narrow(&real::nearest_whole(|precision| Interval::of(&square, precision).sqrt()));
        let angle = if point == PlanePoint::CENTRE {
            0
        } else {
            let (p, q) = (whole(point.p), whole(point.q));
            let degrees = |precision| real::atan2_degrees(&q, &p, precision).times(1_000_000);
            narrow(&real::nearest_whole(degrees))
        };
        (x, turn::within(self.0 + angle))
    }
}

/// E100L-CSC-03: program X and program C of a point in conversion mode.
pub fn axes(point: PlanePoint, state: &State) -> (i64, i64) {
    Direction::of_conversion(state).axes(point)
}

/// The rules that the motions of a block in conversion mode cite.
pub fn cited(plan: &Plan, state: &State) -> RuleSet {
    let one = plan.words.get('X').is_some() != plan.words.get('Y').is_some();
    let also = [(one, CSC_06), (plan.modes.incremental(), CSC_07), (state.frame.zero_shift.c != 0, CSC_04)];
    let rules = also.into_iter().filter(|(holds, _)| *holds).map(|(_, rule)| rule);
    rules.fold(RuleSet::of(&[CSC_02, CSC_03]), RuleSet::with)
}

/// Where a block with X or Y leads: the point, and its program X and C.
pub fn place(plan: &Plan, state: &State) -> Outcome<(PlanePoint, (i64, i64))> {
    let Some(point) = target(plan, state.contour.point(&state.frame)) else {
        return Err(Fault::about(AlarmName::Unspecified, CSC_06, "start"));
    };
    Ok((point, axes(point, state)))
}

/// The motion to the point of a block in G00, and the point. Its C alarms come behind the range.
pub fn element(plan: &Plan, state: &State) -> Outcome<(Element, PlanePoint)> {
    let (point, (x, c)) = place(plan, state)?;
    let present = state.frame.program();
    let word = |letter, present: i64| {
        plan.words.get(letter).map(|word| if plan.modes.incremental() { present + word } else { word })
    };
    let (z, w) = (word('Z', present.z), word('W', present.w));
    let mut element = Element {
        target: Amounts { x, z: z.unwrap_or(present.z), c, w: w.unwrap_or(present.w) },
        axes: Axes { x: true, z: z.is_some(), w: w.is_some(), c: None },
        shape: Shape::Rapid,
        rules: RuleSet::of(&[G00_01, CAX_05]).union(cited(plan, state)),
        readings: ReadingSet::default(),
    };
    element.check_range(state.setup)?;
    needs_c_axis(CAX_02, CAX_07, state)?;
    element.axes.c = Some(turn::travel(present.c, c, 0, state.is_active(15)));
    Ok((element, point))
}

/// Positions to the point of a block in G00.
pub fn go(plan: &Plan, state: &mut State) -> Outcome<Emission> {
    let (element, point) = element(plan, state)?;
    let from = (state.frame.machine.x, state.frame.machine.z);
    let way = Way { from, limits: Tested::Commanded, barriers: true };
    go_to(&element, point, way, plan, state)
}

/// The event of that motion; its point is kept (E100L-CSC-06).
pub fn go_to(
    element: &Element,
    point: PlanePoint,
    way: Way,
    plan: &Plan,
    state: &mut State,
) -> Outcome<Emission> {
    let mut event = carry_out(element, way, plan, state)?;
    if let Action::Rapid { motion } = &mut event.action {
        motion.face = Some(face_point(point));
    }
    state.contour.keep(point, element.target.x, element.target.c, &state.frame);
    Ok(event)
}
