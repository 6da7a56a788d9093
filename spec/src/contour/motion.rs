//! One motion of a contour: its limits and its event (E100L-CGF-01, E100L-CGS-01).

use super::plane::PlanePoint;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::frame::Amounts;
use crate::modal::{Plan, active_feed};
use crate::path::{Axes, check_range, coordinate_readings, coordinate_rules, standing, with_speed};
use crate::quantity::{ratio, round_narrow};
use crate::state::State;
use crate::vocabulary::{
    Action, AlarmName, ContourPlane, FacePoint, Feed, FeedRate, Length, Motion, Part, RuleId, RuleSet, Sense,
    Setup,
};

/// A motion of a contour.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Where it ends, in program coordinates.
    pub target: Amounts,
    /// The travel of C, in micro-degrees.
    pub travel: i64,
    /// Its end as a point of the face.
    pub point: Option<PlanePoint>,
    /// Which way.
    pub course: Course,
    /// The rules that led there.
    pub rules: RuleSet,
}

/// The course of a motion.
#[derive(Clone, Copy, Debug)]
pub enum Course {
    /// Straight.
    Line {
        /// The length on which F is measured.
        path: i64,
        /// What it does at the centre of the face.
        part: Option<Part>,
    },
    /// Along an arc.
    Arc(Sense, ContourPlane),
}

/// A point of the face as it stands in the trace.
pub fn face_point(point: PlanePoint) -> FacePoint {
    FacePoint { x: Length(point.p), y: Length(point.q) }
}

/// What is tested before the first motion of a block: the range of its target, the feed, and barriers. `axes`: those with a
/// limit; `rule`: that of the barriers.
pub fn ready(target: Amounts, axes: Axes, rule: RuleId, state: &State) -> Outcome<(Feed, RuleSet)> {
    check_range(target, axes, state.setup)?;
    let feed = active_feed(state)?;
    if state.watch.chuck || state.watch.tailstock {
        return Err(Fault::about(AlarmName::NotModelled, rule, "barrier"));
    }
    Ok(feed)
}

/// Carries a motion out: the limits of these axes at its end, then the event. Nothing is cut back.
pub fn carry_out(
    step: &Step,
    axes: Axes,
    (feed, feed_rules): (Feed, RuleSet),
    plan: &Plan,
    state: &mut State,
) -> Outcome<Emission> {
    let machine = state.frame.to_machine(step.target);
    if axes.x {
        state.limits.x.check(machine.x)?;
    }
    if axes.z {
        state.limits.z.check(machine.z)?;
    }
    state.frame.machine = machine;
    state.contour.wind(Some(step.travel));
    state.cut_last = true;
    let motion = Motion { face: step.point.map(face_point), ..standing(Some(step.travel), state) };
    let action = match step.course {
        Course::Line { path, part } => {
            let feed = if part == Some(Part::Turn) { of_turn(feed, state.setup) } else { feed };
            Action::Linear { motion: Motion { part, ..motion }, feed, path: Length(path) }
        }
        Course::Arc(sense, plane) => Action::ContourArc { motion, feed, sense, plane },
    };
    let rules = step.rules.union(coordinate_rules(plan)).union(feed_rules);
    let event = Emission::new(action, rules).readings(coordinate_readings(plan, state.setup));
    Ok(with_speed(event, false, state))
}

/// E100L-CGF-12: the feed of C alone at the centre of the face. A feed is below 2^57, the percentage at most 1000.
pub fn of_turn(feed: Feed, setup: &Setup) -> Feed {
    let percent = ratio(setup.parameters.centre_override, 100);
    Feed { value: FeedRate(round_narrow(&(ratio(feed.value.0, 1) * percent))), ..feed }
}
