//! How a motion of the plane of a cutter ends: the motion that waited, and the one that goes back to the programmed point
//! (execution of contours, 9; E100L-CRC-05, E100L-CRC-14 to E100L-CRC-16, E100L-NRC-66, E100L-NRC-80).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{Action, Angle, Event, Feed, Length, Motion, ReadingSet, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::plane::Point;
use crate::engine::cite::{self, Cites};
use crate::engine::compensation::corner::Corner;
use crate::engine::compensation::waiting::{Waiting, check_limit, position};
use crate::engine::contour::face_point;
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{Amounts, C, X, Z};

use super::legs::{Cut, Leg};
use super::{Cutter, Place, Plane, Programmed};

/// A motion of the block that ends compensation: its kind and feed, what it programs, the programmed machine positions
/// before and at its end.
pub struct Return {
    pub kind: Kind,
    pub feed: Option<Feed>,
    pub(super) programmed: Programmed,
    pub start: Amounts,
    pub end: Amounts,
    pub face: bool,
    pub cites: Cites,
    pub readings: ReadingSet,
}

impl Interpreter<'_> {
    /// The motion that waited ends in a corner: its tests, its events.
    pub(in crate::engine::compensation) fn conclude_cutter(
        &mut self,
        waiting: &Waiting,
        corner: &Corner,
        cites: Cites,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let Some(Cutter { plane, at, programmed: Some(programmed), .. }) =
            self.compensation.cutter.as_deref()
        else {
            return Ok(());
        };
        let (plane, from, programmed) = (*plane, *at, *programmed);
        let point = corner.latch_in_plane(programmed.place.point, &mut self.slow);
        let to = self.cutter_place(plane, point, &programmed)?;
        let legs = self.cutter_legs(plane, (&from, &to), &programmed, waiting.feed)?;
        self.check_coordinate(to.x)?;
        self.check_coordinate(to.z)?;
        let linear = waiting.kind == Kind::Linear && programmed.arc.is_none();
        let cites = waiting.cites.and(cites).and(cite::NRC_07).and_if(linear, cite::NRC_42);
        let rules = programmed.rules.union(plane.rules_of(waiting.role));
        let mut start = waiting.start;
        let before = Self::machine_of(&waiting.end, &programmed.place, &from);
        for axis in plane.axes() {
            start[axis] = before[axis];
        }
        for leg in legs.iter().flatten() {
            let mut end = Self::machine_of(&waiting.end, &programmed.place, &leg.place);
            self.check_cutter_limits(plane, &end, waiting)?;
            let mut motion = waiting.motion;
            self.show_axes(&mut motion, leg, &mut end);
            motion.tip = Some(position(leg.place.tip()));
            motion.tip_c = Some(Angle(leg.place.c));
            motion.face_tip = (plane == Plane::Face).then(|| face_point(leg.place.point));
            let turns =
                leg.travel != 0 && matches!(leg.cut, Cut::Axes) && !planted::is(Bug::CutterTurnUncited);
            let rules = if turns { rules.with(rules::CRC_16) } else { rules };
            let travel = (waiting.kind, waiting.feed);
            let (cites, readings) = (cites, waiting.readings);
            let event = self.event_of_leg(leg, travel, (motion, &start, &end), (cites, rules, readings));
            let mut event = Event { block: waiting.place, ..event };
            self.name_side(&mut event);
            self.state.contour.wind(leg.travel);
            self.emit_at_once(sink, &mut event);
            start = end;
        }
        if let Some(cutter) = &mut self.compensation.cutter {
            cutter.displacement = to.minus(&programmed.place);
            cutter.at = to;
        }
        Ok(())
    }

    /// The motion of the block that ends compensation: to the programmed point.
    pub(super) fn return_to_program(&mut self, motion: Return, sink: &mut impl Sink) -> Result<(), Fault> {
        let Some(Cutter { plane, at, .. }) = self.compensation.cutter.as_deref() else { return Ok(()) };
        let (plane, from) = (*plane, *at);
        let Return { kind, feed, programmed, mut start, end: target, face, cites, readings } = motion;
        let to = programmed.place;
        let legs = self.cutter_legs(plane, (&from, &to), &programmed, feed)?;
        let before = Self::machine_of(&target, &to, &from);
        for axis in plane.axes() {
            start[axis] = before[axis];
        }
        for leg in legs.iter().flatten() {
            let mut cites = cites.and(cite::NRC_66);
            let mut readings = readings;
            let mut end = Self::machine_of(&target, &to, &leg.place);
            for axis in plane.limited() {
                if self.limit(*axis, &mut end[*axis], programmed.motion == 101)? {
                    cites = cites.and(cite::LIM_01);
                }
            }
            self.state.machine = end;
            let mut motion = Motion {
                face: face.then(|| face_point(leg.place.point)),
                ..self.motion_to_here(feed.is_some(), &mut cites, &mut readings)
            };
            self.show_axes(&mut motion, leg, &mut end);
            let rules = programmed.rules;
            let event =
                self.event_of_leg(leg, (kind, feed), (motion, &start, &end), (cites, rules, readings));
            self.state.contour.wind(leg.travel);
            self.emit_with(sink, event.rules, event.readings, event.action);
            start = end;
        }
        self.compensation.cutter = None;
        Ok(())
    }

    /// Shows where the axes go in a motion of the programmed point.
    fn show_axes(&self, motion: &mut Motion, leg: &Leg, end: &mut Amounts) {
        motion.machine = self.position(self.state.machine_x(end[X]), end[Z], |axis| end[axis]);
        motion.c_travel = Some(Angle(leg.travel));
        motion.part = leg.part;
    }

    /// The event of a motion between two machine positions of the axes, with the rules of its way.
    fn event_of_leg(
        &mut self,
        leg: &Leg,
        (kind, feed): (Kind, Option<Feed>),
        (motion, start, end): (Motion, &Amounts, &Amounts),
        (mut cites, rules, mut readings): (Cites, RuleSet, ReadingSet),
    ) -> Event {
        let action = match (leg.cut, leg.feed.or(feed)) {
            (Cut::Line(path), Some(feed)) => Action::Linear { motion, feed, path: Length(path) },
            (Cut::Arc(sense, plane), Some(feed)) => Action::ContourArc { motion, feed, sense, plane },
            _ => {
                let way = (start, end, Some(leg.travel));
                self.action((kind, feed), motion, way, &mut cites, &mut readings)
            }
        };
        let rules = self.cites.rules(cites).union(rules).union(leg.rules);
        Event::new(0, self.place, rules, readings, action)
    }

    /// Where the axes go, against the limits in force in the block of the motion (E100L-NRC-80).
    fn check_cutter_limits(&self, plane: Plane, end: &Amounts, waiting: &Waiting) -> Result<(), Fault> {
        let end = if planted::is(Bug::CutterLimitOfProgram) { &waiting.end } else { end };
        let [of_x, of_z] = waiting.limits;
        if plane == Plane::Face {
            check_limit(self.state.mirror * end[X], of_x)?;
        }
        check_limit(end[Z], of_z)
    }
}

impl Place {
    /// The cutter centre as X and Z.
    fn tip(&self) -> Point {
        Point { x: self.x, z: self.z }
    }

    /// From another place to this one.
    fn minus(&self, other: &Self) -> Self {
        Self {
            point: Spot::default(),
            x: self.x.saturating_sub(other.x),
            z: self.z.saturating_sub(other.z),
            c: self.c.saturating_sub(other.c),
            unwrapped: 0,
        }
    }
}

impl Plane {
    /// The axes of the plane.
    fn axes(self) -> [usize; 2] {
        match self {
            Self::Face => [X, C],
            Self::Side { .. } => [Z, C],
        }
    }

    /// The axes whose limits are tested.
    fn limited(self) -> &'static [usize] {
        match self {
            Self::Face => &[X, Z],
            Self::Side { .. } => &[Z],
        }
    }
}
