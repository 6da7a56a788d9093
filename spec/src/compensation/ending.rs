//! The end of a motion in compensation: where the tip goes, and the event that tells it (E100L-NRC-07).

use super::reach::Reach;
use crate::controls::e100l::units;
use crate::emission::{AtRest, Emission};
use crate::fault::{Outcome, fail};
use crate::frame::{Amounts, TravelLimit};
use crate::integer::{Limited, mirror, nose};
use crate::path::{Point, feed_path};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Length, Motion, Place, PlanePosition, RuleSet, Setup};

/// P, and what was in force when the programmed motion ended there.
#[derive(Clone, Debug)]
pub struct Spot {
    /// The block.
    pub place: Place,
    /// X (as a diameter) and Z in program coordinates.
    program: Point,
    /// The same in machine coordinates.
    machine: Point,
    /// Whether X of the machine runs against X of the program.
    mirrored: bool,
    limits: (TravelLimit, TravelLimit),
}

impl Spot {
    /// The present point.
    pub fn present(place: Place, state: &State) -> Self {
        let (program, machine) = (state.frame.program(), state.frame.machine);
        Self {
            place,
            program: (program.x, program.z),
            machine: (machine.x, machine.z),
            mirrored: state.frame.mirrored,
            limits: (state.limits.x, state.limits.z),
        }
    }

    /// The end at which the nose centre is this far from P. `to_centre` leads from the tip to the nose centre.
    pub fn reached(&self, reach: &Reach, to_centre: Point) -> Ending {
        let centre = reach.from(self.program);
        self.ending(nose::tip(centre, to_centre), to_centre)
    }

    /// The end without a motion: the tip stays where the axes are.
    pub fn kept(&self, axes: Point, to_centre: Point) -> Ending {
        self.ending(tip_at(axes, self.program, self.machine, self.mirrored), to_centre)
    }

    fn ending(&self, tip: Point, to_centre: Point) -> Ending {
        // E100L-MIRR-05: in X against the sense of turret B.
        let in_sense_of_turret = mirror::x(self.machine.0, self.mirrored);
        let x = nose::machine(tip.0, self.program.0, in_sense_of_turret);
        let z = nose::machine(tip.1, self.program.1, self.machine.1);
        Ending { tip, to_centre, machine: (mirror::x(x, self.mirrored), z) }
    }

    /// E100L-NRC-29, then E100L-NRC-80: the range of the address and the travel limits, for the tip.
    fn check(&self, ending: &Ending, setup: &Setup) -> Outcome<()> {
        let largest = units::largest_length(setup.unit_system).unsigned_abs();
        if ending.tip.0.unsigned_abs() > largest || ending.tip.1.unsigned_abs() > largest {
            return fail(AlarmName::CoordinateRange, ADDR_01);
        }
        within_limit(self.limits.0, ending.machine.0)?;
        within_limit(self.limits.1, ending.machine.1)
    }
}

/// E100L-NRC-80: a place within a travel limit.
pub fn within_limit(limit: TravelLimit, place: i64) -> Outcome<()> {
    match limit.of(place) {
        Limited::Allowed => Ok(()),
        Limited::Positive(_) => fail(AlarmName::TravelLimitPositive, NRC_80),
        Limited::Negative => fail(AlarmName::TravelLimitNegative, NRC_80),
    }
}

/// Where tip and nose are at the end of a motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ending {
    /// T in program coordinates.
    tip: Point,
    /// v.
    to_centre: Point,
    /// T in machine coordinates.
    pub machine: Point,
}

impl Ending {
    /// Writes tip, nose and machine position into a motion.
    fn show(&self, motion: &mut Motion) {
        let position = |point: Point| PlanePosition { x: Length(point.0), z: Length(point.1) };
        motion.tip = Some(position(self.tip));
        motion.nose = Some(position(nose::centre(self.tip, self.to_centre)));
        motion.machine.x = Length(self.machine.0);
        motion.machine.z = Length(self.machine.1);
    }
}

/// A motion whose end is not known yet.
#[derive(Clone, Debug)]
pub struct Pending {
    /// Where it ends on the programmed path.
    pub spot: Spot,
    event: Emission,
    /// Travel of W.
    w_travel: i64,
}

impl Pending {
    /// The motion that brought P here, as it would be without compensation.
    pub fn new(event: Emission, w_travel: i64, place: Place, state: &State) -> Self {
        Self { spot: Spot::present(place, state), event, w_travel }
    }

    /// The event of its end there. `axes` is where the axes were before.
    pub fn told(
        self,
        ending: Ending,
        rules: RuleSet,
        axes: Point,
        setup: &Setup,
    ) -> Outcome<(Place, Emission)> {
        let place = self.spot.place;
        self.spot.check(&ending, setup).map_err(|fault| fault.of_block(place))?;
        let mut event = self.event.rules(rules);
        if let Some(motion) = motion_of(&mut event.action) {
            ending.show(motion);
        }
        if let Action::Linear { motion, path, .. } = &mut event.action {
            // E100L-NRC-42: F is the speed of the tip.
            let at = |point: Point, w| Amounts { x: point.0, z: point.1, c: 0, w };
            let c_travel = motion.c_travel.map(|travel| travel.0);
            *path = feed_path(at(axes, 0), at(ending.machine, self.w_travel), c_travel, setup).0;
        }
        Ok((place, event))
    }
}

/// The motion of an event.
pub fn motion_of(action: &mut Action) -> Option<&mut Motion> {
    match action {
        Action::Rapid { motion }
        | Action::Linear { motion, .. }
        | Action::Arc { motion, .. }
        | Action::ContourArc { motion, .. } => Some(motion),
        _ => None,
    }
}

/// The tip where the axes are, from the programmed point in both coordinates.
fn tip_at(axes: Point, program: Point, machine: Point, mirrored: bool) -> Point {
    let in_sense_of_turret = |x| mirror::x(x, mirrored);
    let x = nose::tip_at(in_sense_of_turret(axes.0), program.0, in_sense_of_turret(machine.0));
    (x, nose::tip_at(axes.1, program.1, machine.1))
}

/// A motion of C or W alone in compensation: tip and nose as they are when its turn comes.
pub fn at_rest(mut event: Emission, axes: Point) -> Emission {
    if let (Some(AtRest::Tip { to_centre, mirrored }), Some(motion)) =
        (event.at_rest, motion_of(&mut event.action))
    {
        let of = |x: Length, z: Length| (x.0, z.0);
        let program = of(motion.program.x, motion.program.z);
        let machine = of(motion.machine.x, motion.machine.z);
        let tip = tip_at(axes, program, machine, mirrored);
        Ending { tip, to_centre, machine: axes }.show(motion);
    }
    event
}

/// A motion of C or W alone after compensation: X and Z stay where the tip is (E100L-NRC-71).
pub fn left_behind(mut event: Emission, axes: Point) -> Emission {
    if let Some(motion) = motion_of(&mut event.action) {
        motion.machine.x = Length(axes.0);
        motion.machine.z = Length(axes.1);
    }
    event
}
