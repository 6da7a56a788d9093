//! Step 7 of a block in which a cutter was or is compensated: its own tests, in their order, and what it programs in the
//! plane (execution of contours, 9; E100L-CRC-06 to E100L-CRC-08, E100L-CRC-14, E100L-CRC-18).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, Feed, Label, ReadingSet, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::{coordinate, to_machine};
use crate::engine::arithmetic::plane::Point;
use crate::engine::arithmetic::root::narrow;
use crate::engine::arithmetic::turn;
use crate::engine::block::Plan;
use crate::engine::cite::{self, Cites};
use crate::engine::compensation::Phase;
use crate::engine::compensation::contour::{Contour, Shape};
use crate::engine::compensation::waiting::{Next, Role, undefined};
use crate::engine::contour::{self, Course, Station, check_diameters, sense, unspecified, word_cites};
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::planted::{self, Bug};
use crate::engine::slot::Slot;
use crate::engine::state::{Amounts, C, W, X, Z};
use crate::engine::words::{Address, Words};

use super::motion::Return;
use super::{Place, Plane, Programmed, ProgrammedArc};

/// The targets of the words of a block, in program coordinates, with the rules and readings of its words.
#[derive(Clone, Copy, Default)]
pub struct Targets {
    pub x: Option<i64>,
    pub z: Option<i64>,
    pub w: Option<i64>,
    pub c: Option<i64>,
    pub cites: Cites,
    pub readings: ReadingSet,
}

/// What a block programs, with the plane point at which it starts, if that is known.
struct Programs {
    start: Option<Place>,
    end: Place,
    /// In G119: the programmed travel of C.
    travel: i64,
    /// Of G101 to G103.
    of_face: Option<Course>,
}

/// A block that moves where a cutter was or is compensated.
struct Block<'b> {
    words: &'b Words,
    motion: u16,
    plane: Plane,
    converted: bool,
}

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

    /// The targets of the words, and the rules of the words out of conversion mode.
    fn targets_of(
        &mut self,
        slot: &Slot,
        plan: Plan,
        converted: bool,
        sink: &mut impl Sink,
    ) -> Result<Targets, Fault> {
        let words = &slot.words;
        let incremental = self.state.incremental;
        let along = |address, axis| {
            words.get(address).map(|word| coordinate(self.state.program(axis), word, incremental))
        };
        let (w, c) = (along(Address::W, W), along(Address::C, C).map(turn::within));
        if contour::is_mode(plan.motion) || converted && words.has_any(contour::POINT) {
            let (x, z) = (along(Address::X, X).filter(|_| !converted), along(Address::Z, Z));
            self.state.base = None;
            let cites = word_cites(&self.state, self.inch_block, words.has(Address::X) && !converted);
            let readings = if self.inch_block { self.known.inch } else { ReadingSet::default() };
            return Ok(Targets { x, z, w, c, cites, readings });
        }
        let mut targets = Targets { w, c, cites: self.coordinate_cites(words), ..Targets::default() };
        let angle_target = self.state.angle_target.take();
        if words.has_any(Address::set(&[Address::X, Address::Z])) {
            let base = self.state.base.take();
            let end = self.line_end(slot, plan, base, angle_target, sink)?;
            targets.x = end.x.then_some(end.point.x);
            targets.z = end.z.then_some(end.point.z);
            targets.cites = targets.cites.and(end.cites);
            targets.readings = end.readings;
        }
        if self.inch_block {
            targets.readings = targets.readings.union(self.known.inch);
        }
        Ok(targets)
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

    /// What a block programs.
    fn cutter_course(&mut self, block: &Block, targets: &Targets) -> Result<Programs, Fault> {
        match block.plane {
            Plane::Face => self.course_on_face(block, targets),
            Plane::Side { .. } => Ok(self.course_on_side(block, targets)),
        }
    }

    fn course_on_face(&mut self, block: &Block, targets: &Targets) -> Result<Programs, Fault> {
        let z = self.state.program(Z);
        let place = |station: Station, z| {
            let Station { point, x, c } = station;
            Place { point, x, z, c, wound: 0 }
        };
        let (start, end, of_face) = if contour::is_mode(block.motion) {
            let course = self.course(block.words)?;
            (Some(course.start), course.end, Some(course))
        } else if block.converted {
            let held = self.held_point();
            let target = self.target_point(block.words, held);
            // A start-up and the way back need no point to start from.
            let needs = self.compensation.phase == Phase::On;
            let Some(target) = target.filter(|_| held.is_some() || !needs) else {
                return Err(unspecified(rules::CSC_06, "start"));
            };
            (held, self.converted(target), None)
        } else {
            let (x, c) = (self.state.program(X), self.state.program(C));
            let (to_x, to_c) = (targets.x.unwrap_or(x), targets.c.unwrap_or(c));
            let start = Station { point: self.point_of(x, c), x, c };
            (Some(start), Station { point: self.point_of(to_x, to_c), x: to_x, c: to_c }, None)
        };
        let start = start.map(|start| place(start, z));
        Ok(Programs { start, end: place(end, targets.z.unwrap_or(z)), travel: 0, of_face })
    }

    fn course_on_side(&mut self, block: &Block, targets: &Targets) -> Programs {
        let [x, z, c] = [X, Z, C].map(|axis| self.state.program(axis));
        let (from_c, turned) =
            self.compensation.cutter.as_deref().map_or((c, 0), |cutter| (cutter.from_c, cutter.turned));
        let to_c = targets.c.unwrap_or(c);
        let travel = turn::travel(c, to_c, 0, self.state.c_negative);
        let mut at = |turned: i64, z: i64, c: i64| {
            let around = self.length_around(x, turned);
            let point = Spot { p: block.plane.seen(around), q: z };
            Place { point, x, z, c, wound: from_c.saturating_add(turned) }
        };
        let start = at(turned, z, c);
        let end = at(turned.saturating_add(travel), targets.z.unwrap_or(z), to_c);
        Programs { start: Some(start), end, travel, of_face: None }
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
        let known = course.start.unwrap_or(Place { point: Spot::default(), x, z, c, wound: c });
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

    /// The centre of an arc, and its radius.
    fn cutter_arc(&mut self, block: &Block, course: &Programs) -> Result<Option<(Spot, i64)>, Fault> {
        let Block { words, motion, .. } = *block;
        let radius = words.get(Address::L).unwrap_or_default();
        if let Some(of_face) = &course.of_face {
            let is_arc = motion != 101;
            check_diameters(of_face, is_arc)?;
            if !is_arc {
                return Ok(None);
            }
            return Ok(Some((self.face_centre(of_face, radius, sense(motion))?, radius)));
        }
        match course.start {
            Some(start) if matches!(motion, 132 | 133) => {
                let ends = (start.point, course.end.point);
                let way = (course.end.x, course.travel);
                Ok(Some((self.side_centre(ends, way, radius, sense(motion))?, radius)))
            }
            _ => Ok(None),
        }
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
        let radius = if planted::is(Bug::CutterRadiusOfProgram) { radius } else { of_centre };
        Ok(Programmed { arc: Some(ProgrammedArc { centre, radius, sense: sense(motion) }), ..programmed })
    }

    /// An element with the side and the cutter of its block.
    fn contour_of_cutter(&self, shape: Shape) -> Contour {
        Contour { to_centre: Point::default(), ..self.contour(shape) }
    }

    /// The rules of a motion code, of a line or the feed.
    fn cites_of_mode(&self, block: &Block) -> Cites {
        let point = block.converted && block.words.has_any(contour::POINT);
        match block.motion {
            0 => cite::G00_01.and_if(point, cite::CAX_05),
            1 => self.feed_cites().and(cite::G01_01).and(cite::G01_02),
            132 | 133 => self.feed_cites().and_if(block.words.has(Address::C), cite::CAX_05),
            _ => self.feed_cites(),
        }
    }

    /// The rules of a contour block, and of conversion mode.
    fn rules_of_words(&self, block: &Block) -> RuleSet {
        let mut set = match block.motion {
            101..=103 => const { RuleSet::of(&[rules::CGF_01, rules::CGF_06]) },
            132 | 133 => self.side_rules(block.words),
            _ => RuleSet::EMPTY,
        };
        if block.converted {
            set = set.union(self.conversion_rules(block.words));
            if contour::is_face_mode(block.motion) {
                set = set.with(rules::CGF_14);
            }
        }
        set
    }
}

/// A block as an element of its plane.
fn element(course: &Programs, centre: Option<Spot>, motion: u16) -> Shape {
    let from = course.start.unwrap_or(course.end).point;
    let to = course.end.point;
    match centre {
        Some(centre) => Shape::arc_between(from, to, centre, sense(motion)),
        None => Shape::line_between(from, to),
    }
}
