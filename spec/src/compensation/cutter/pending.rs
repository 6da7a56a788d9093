//! A motion of the cutter whose end is not known yet, and the events that tell it then (E100L-CRC-14, E100L-NRC-07).

use std::convert::Infallible;

use super::super::ending::motion_of;
use super::super::leg::Leg;
use super::super::nose::Nose;
use super::super::on::{Held, On, Waits};
use super::super::reach::Reach;
use super::super::stream::Stream;
use super::course::{Course, Step};
use super::plane::{Spot, Standing};
use crate::contour;
use crate::emission::{AtRest, Emission};
use crate::fault::{Fault, Outcome};
use crate::frame::Amounts;
use crate::modal::CutterPlane;
use crate::path::feed_path;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Angle, Length, Part, Place, RuleSet, Setup};

/// A motion in the plane.
#[derive(Clone, Debug)]
pub struct Pending {
    /// Where it ends on the programmed path.
    pub spot: Spot,
    /// Its event as it would be without compensation, without path and travel of C.
    pub event: Emission,
    /// Which way it goes.
    pub course: Course,
    /// Travel of Z.
    pub z_travel: i64,
    /// Travel of W.
    pub w_travel: i64,
}

impl Waits for Pending {
    type Axes = Standing;
    /// No motion is without travel, and no second block comes behind an element.
    type Rest = Infallible;

    fn place(&self) -> Place {
        self.spot.place
    }

    fn end(
        self,
        reach: &Reach,
        _: Nose,
        rules: RuleSet,
        axes: Standing,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<Standing> {
        self.told(reach, rules, axes, stream, state).map_err(|fault| fault.of_block(self.spot.place))
    }

    fn at_rest(mut event: Emission, axes: Standing) -> Emission {
        if let (Some(AtRest::Cutter(plane)), Some(motion)) = (event.at_rest, motion_of(&mut event.action)) {
            axes.show(plane, motion);
        }
        event
    }

    fn go_on(_: On<Self>, _: &mut Stream, _: &mut State) -> Outcome<On<Self>> {
        Err(Fault::about(AlarmName::Unspecified, CRC_14, "waiting"))
    }

    fn rest_waits(rest: &Infallible) -> bool {
        match *rest {}
    }

    fn leave(
        rest: Infallible,
        _: (&Leg, &Leg),
        _: RuleSet,
        _: &mut Held<Self>,
        _: &mut Stream,
        _: &mut State,
    ) -> Outcome<()> {
        match rest {}
    }

    fn stay(rest: Infallible, _: &Leg, _: &mut Held<Self>, _: &mut Stream, _: &mut State) -> Outcome<()> {
        match rest {}
    }
}

impl Pending {
    /// The events of its end; where the cutter is then.
    fn told(
        &self,
        reach: &Reach,
        rules: RuleSet,
        axes: Standing,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<Standing> {
        let to = self.spot.at(reach.in_plane(self.spot.point))?;
        let steps = self.course.steps(&self.spot, &axes, &to, self.z_travel, state)?;
        self.spot.check_range(&to, state.setup)?;
        for step in steps {
            self.spot.check_limits(&step.to)?;
            state.contour.wind(Some(step.travel));
            let event = self.event_of(&step, &axes, state.setup).rules(rules);
            stream.decide((self.spot.place, event));
        }
        Ok(to)
    }

    fn event_of(&self, step: &Step, axes: &Standing, setup: &Setup) -> Emission {
        let mut event = self.event.clone().rules(step.rules);
        match (&mut event.action, step.course) {
            (Action::Linear { motion, feed, path }, Some(contour::Course::Line { path: length, part })) => {
                *path = Length(length);
                motion.part = part;
                if part == Some(Part::Turn) {
                    *feed = contour::of_turn(*feed, setup);
                }
            }
            (Action::Linear { path, .. }, _) => *path = self.path(step, axes, setup),
            (Action::ContourArc { plane, .. }, Some(contour::Course::Arc(_, of_centre))) => {
                *plane = of_centre
            }
            _ => {}
        }
        if let Some(motion) = motion_of(&mut event.action) {
            motion.c_travel = Some(Angle(step.travel));
            step.to.show(self.spot.plane(), motion);
        }
        event
    }

    /// E100L-CFEED-03: F is the speed of the axes.
    fn path(&self, step: &Step, axes: &Standing, setup: &Setup) -> Length {
        let to = Amounts { w: self.w_travel, ..step.to.machine };
        let from = match self.spot.plane() {
            CutterPlane::Face => Amounts { x: axes.machine.x, z: to.z - self.z_travel, ..Amounts::default() },
            CutterPlane::Side => Amounts { x: to.x, z: axes.machine.z, ..Amounts::default() },
        };
        feed_path(from, to, Some(step.travel), setup).0
    }
}
