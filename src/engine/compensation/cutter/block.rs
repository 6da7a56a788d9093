//! Step 7 of a block in which a cutter was or is compensated: its own tests, in their order, and its part in
//! compensation (execution of contours, 9; E100L-CRC-06 to E100L-CRC-08, E100L-CRC-14, E100L-CRC-18).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, Feed, Label, ReadingSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::plane::Point;
use crate::engine::arithmetic::root::narrow;
use crate::engine::arithmetic::turn;
use crate::engine::block::Plan;
use crate::engine::cite::{self, Cites};
use crate::engine::compensation::Phase;
use crate::engine::compensation::contour::{Contour, Shape};
use crate::engine::compensation::waiting::{Next, Role, undefined};
use crate::engine::contour::{self, Station, sense};
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::planted::{self, Bug};
use crate::engine::slot::Slot;
use crate::engine::state::{Amounts, C, W, X, Z};

use super::course::{Block, Programs, Targets, element};
use super::motion::Return;
use super::{Place, Plane, Programmed, ProgrammedArc};

impl Interpreter<'_> {
    /// The motion of a block in which a cutter was or is compensated.
    #[cold]
    pub(in crate::engine) fn move_cutter(
        &mut self,
        slot: &Slot,
        plan: Plan,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let Some(plane) = self.compensation.cutter.as_deref().map(|cutter| cutter.plane) else {
            return Ok(());
        };
        let (words, motion, converted) = (&slot.words, plan.motion, self.state.contour.converts());
        let targets = self.targets_of(slot, plan, converted, sink)?;
        if plane != Plane::Face && targets.x.is_some_and(|x| x != self.state.program(X)) {
            return Fault::raise(AlarmName::ContourXChanged, rules::CRC_18);
        }
        let block = Block { words, motion, plane, converted };
        if !plane.is_moved_by(words, converted) {
            return self.move_beside(words, motion, &targets, sink);
        }
        self.check_plane_motion()?;
        let course = self.cutter_course(&block, &targets)?;
        self.check_cutter_course(&block, &course)?;
        self.follow_cutter(&block, &targets, course, sink)
    }

    /// The tests that every motion of the plane passes first.
    fn check_plane_motion(&self) -> Result<(), Fault> {
        let frame = self.compensation.cutter.as_deref().map(|cutter| cutter.frame);
        if frame != Some(self.cutter_frame()) && !planted::is(Bug::CutterFrameFree) {
            return Err(undefined(rules::CRC_14, "frame"));
        }
        if self.state.watch.acts() {
            return Err(Fault::about(AlarmName::NotModelled, rules::CRC_14, const { Label::new("barrier") }));
        }
        if self.state.c_clamped && !planted::is(Bug::CutterClampLost) {
            return Fault::raise(AlarmName::CAxisClamped, rules::CAX_07);
        }
        Ok(())
    }

    /// The tests that need the points of a block.
    fn check_cutter_course(&self, block: &Block, course: &Programs) -> Result<(), Fault> {
        let stands = course.start.is_some_and(|start| start.point == course.end.point);
        if self.compensation.phase == Phase::On && stands {
            return Err(undefined(rules::CRC_14, "repetition"));
        }
        let present = self.state.program(X);
        match block.plane {
            _ if block.converted => Ok(()),
            Plane::Face if present < 0 || course.end.x < 0 => {
                Fault::raise(AlarmName::ContourXNotPositive, rules::CGF_08)
            }
            Plane::Side { .. } if present <= 0 => Fault::raise(AlarmName::ContourXNotPositive, rules::CGS_01),
            _ => Ok(()),
        }
    }

    /// The other tests of a motion of the plane, and its part in compensation.
    fn follow_cutter(
        &mut self,
        block: &Block,
        targets: &Targets,
        course: Programs,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let Block { words, motion, plane, converted } = *block;
        let in_contour = contour::is_mode(motion);
        let arc = self.cutter_arc(block, &course)?;
        let to_x = match plane {
            Plane::Face if in_contour || converted => Some(course.end.x),
            Plane::Side { .. } if in_contour => None,
            _ => targets.x,
        };
        for target in [to_x, targets.z, targets.w].into_iter().flatten() {
            self.check_coordinate(target)?;
        }
        let (kind, feed) = match motion {
            0 => (Kind::Rapid, None),
            _ => (Kind::Linear, Some(self.feed()?)),
        };
        let mut cites = targets.cites.and(self.cites_of_mode(block));
        let mut end = self.state.machine;
        if let Some(target) = targets.w {
            end[W] = to_machine(target, self.state.frame(W));
            if self.limit(W, &mut end[W], false)? {
                cites = cites.and(cite::LIM_01);
            }
        }
        for (axis, target) in [(X, course.end.x), (Z, course.end.z), (C, course.end.c)] {
            end[axis] = to_machine(target, self.state.frame(axis));
        }
        end[C] = turn::within(end[C]);
        let from_u = course.start.map_or(0, |start| plane.seen(start.point.p));
        let programmed = Programmed {
            motion,
            place: course.end,
            from_u: if planted::is(Bug::CutterCentreFromOrigin) { 0 } else { from_u },
            z: self.state.program(Z),
            z_target: targets.z,
            axis: self.conversion_axis(),
            negative: self.state.c_negative,
            arc: None,
            rules: self.rules_of_words(block),
        };
        let face = contour::is_face_mode(motion) || converted;
        let ways = (kind, feed, end);
        let readings = targets.readings;
        match self.compensation.phase {
            Phase::Starting => self.start_cutter(&course, programmed, ways, (face, cites, readings)),
            Phase::On => {
                let shape = element(&course, arc.map(|(centre, _)| centre), motion);
                let contour = self.contour_of_cutter(shape);
                let programmed = self.with_arc(programmed, arc, motion, &contour)?;
                self.follow_with_cutter(contour, programmed, ways, (face, cites, readings), sink)?;
            }
            _ => {
                self.cancel(true, sink)?;
                self.state.last_motion_cut = feed.is_some();
                let start = self.state.machine;
                let motion = Return { kind, feed, programmed, start, end, face, cites, readings };
                self.return_to_program(motion, sink)?;
            }
        }
        if words.has_any(contour::POINT) && plane == Plane::Face {
            let Place { point, x, c, .. } = course.end;
            self.keep_point(Station { point, x, c });
        }
        if let Some(cutter) = &mut self.compensation.cutter
            && !planted::is(Bug::CutterTurnsForgotten)
        {
            cutter.turned = cutter.turned.saturating_add(course.travel);
        }
        Ok(())
    }

    /// The motion of the block that begins compensation waits.
    fn start_cutter(
        &mut self,
        course: &Programs,
        programmed: Programmed,
        (kind, feed, end): (Kind, Option<Feed>, Amounts),
        (face, cites, readings): (bool, Cites, ReadingSet),
    ) {
        let [x, z, c] = [X, Z, C].map(|axis| self.state.program(axis));
        let known = course.start.unwrap_or(Place { point: Spot::default(), x, z, c, unwrapped: c });
        let stands = match course.start {
            Some(start) => start.point == course.end.point,
            None => (x, c) == (course.end.x, course.end.c),
        };
        if let Some(cutter) = &mut self.compensation.cutter {
            cutter.at = known;
        }
        let cites = cites.and(cite::NRC_14).and_if(stands, cite::NRC_20);
        self.compensation.last = self.contour_of_cutter(Shape::Line((1, 0)));
        let role = Role::StartUp { imaginary: false };
        self.let_cutter_wait(role, programmed, (kind, feed, end), (face, cites, readings));
        self.compensation.phase = Phase::On;
    }

    /// An element: what waits ends in the corner with it, and it waits.
    fn follow_with_cutter(
        &mut self,
        contour: Contour,
        programmed: Programmed,
        (kind, feed, end): (Kind, Option<Feed>, Amounts),
        (face, cites, readings): (bool, Cites, ReadingSet),
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let of_kind = match kind {
            Kind::Rapid => cite::NRC_41,
            _ if programmed.arc.is_some() => cite::NRC_48.and(cite::NRC_60),
            _ => Cites::default(),
        };
        self.end_waiting(Next::Element(&contour), sink)?;
        self.release(sink);
        self.compensation.last = contour;
        let cites = cites.and(of_kind);
        self.let_cutter_wait(Role::Element, programmed, (kind, feed, end), (face, cites, readings));
        Ok(())
    }

    /// The programmed point moves, and the motion waits.
    fn let_cutter_wait(
        &mut self,
        role: Role,
        programmed: Programmed,
        (kind, feed, end): (Kind, Option<Feed>, Amounts),
        (face, cites, readings): (bool, Cites, ReadingSet),
    ) {
        self.state.last_motion_cut = feed.is_some();
        let start = std::mem::replace(&mut self.state.machine, end);
        let mut waiting = self.waiting_motion(role, (kind, feed), (&start, &end, None), cites, readings);
        waiting.motion.face = face.then(|| contour::face_point(programmed.place.point));
        if let Some(cutter) = &mut self.compensation.cutter {
            cutter.programmed = Some(programmed);
        }
        self.begin_to_wait(waiting);
    }

    /// What an arc programs: the circle of the cutter centre has to exist (E100L-NRC-48).
    fn with_arc(
        &self,
        programmed: Programmed,
        arc: Option<(Spot, i64)>,
        motion: u16,
        contour: &Contour,
    ) -> Result<Programmed, Fault> {
        let Some((centre, radius)) = arc else { return Ok(programmed) };
        let of_centre = narrow(i128::from(radius) - contour.inward() / 2);
        if of_centre < 0 || contour.is_too_small() {
            return Fault::raise(AlarmName::CompensationArcTooSmall, rules::NRC_48);
        }
        let arc = ProgrammedArc { centre, radius: of_centre, sense: sense(motion) };
        Ok(Programmed { arc: Some(arc), ..programmed })
    }

    /// An element with the side and the cutter of its block.
    fn contour_of_cutter(&self, shape: Shape) -> Contour {
        Contour { to_centre: Point::default(), ..self.contour(shape) }
    }
}
