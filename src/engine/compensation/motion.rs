//! Motions where compensation acts: those that begin to wait, those of C or W alone, and the first ones in
//! G40 again (E100L-NRC-13, E100L-NRC-19, E100L-NRC-45, E100L-NRC-48, E100L-NRC-66, E100L-NRC-71).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, Angle, Feed, Length, Motion, ReadingSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::idle::IdleBlocks;
use crate::engine::arithmetic::nose::nose;
use crate::engine::arithmetic::plane::Point;
use crate::engine::cite::{self, Cites};
use crate::engine::fault::Fault;
use crate::engine::motion::{Element, Kind};
use crate::engine::planted::{self, Bug};
use crate::engine::state::{Amounts, C, W, X, Z};

use super::Phase;
use super::contour::{Contour, Shape};
use super::waiting::{Next, Role, Waiting, displace, position, undefined};

/// Where a motion begins and ends in machine coordinates of the programmed points, and the travel of C.
type Way<'w> = (&'w Amounts, &'w Amounts, Option<i64>);

impl Interpreter<'_> {
    /// Carries out one element where compensation acts.
    #[cold]
    pub(in crate::engine) fn perform_compensated(
        &mut self,
        element: Element,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        for target in [element.x, element.z, element.w].into_iter().flatten() {
            self.check_coordinate(target)?;
        }
        if matches!(element.kind, Kind::Arc { .. }) {
            self.check_arc_start()?;
        }
        let turn = element.c.map(|(target, turns)| self.turn(target, turns)).transpose()?;
        let feed = self.feed_of(element.kind)?;
        let mut cites = element.cites;
        let mut end = self.state.machine;
        for (axis, target) in [(X, element.x), (Z, element.z), (W, element.w)] {
            if let Some(target) = target {
                end[axis] = to_machine(target, self.state.frame(axis));
            }
        }
        if element.w.is_some() && self.limit(W, &mut end[W], false)? {
            cites = cites.and(cite::LIM_01);
        }
        if let Some(turn) = turn {
            end[C] = turn.machine;
        }
        let mut element = Element { cites, ..element };
        self.check_barriers_first(&mut element, end)?;
        let travel = (feed, turn.map(|turn| turn.travel));
        match self.compensation.phase {
            Phase::Starting => self.start_up(&element, travel, end),
            Phase::On if element.moves_plane() => self.follow(&element, travel, end, sink),
            Phase::On => self.pass(&element, travel, end, sink),
            _ => self.perform_uncompensated(&element, travel, end, sink),
        }
    }

    /// An arc neither begins nor ends compensation, and does not start beside its circle.
    fn check_arc_start(&self) -> Result<(), Fault> {
        match self.compensation.phase {
            Phase::Starting => Fault::raise(AlarmName::CompensationNotLinear, rules::NRC_19),
            Phase::Ending => Fault::raise(AlarmName::CompensationNotLinear, rules::NRC_72),
            Phase::LeftOver if self.compensation.displacement != (Point { x: 0, z: 0 }) => {
                Err(undefined(rules::NRC_71, "arc"))
            }
            _ => Ok(()),
        }
    }

    /// The start-up (E100L-NRC-14).
    fn start_up(
        &mut self,
        element: &Element,
        (feed, turn): (Option<Feed>, Option<i64>),
        end: Amounts,
    ) -> Result<(), Fault> {
        let start = self.arrive(element, feed, end);
        let stands = (start[X], start[Z]) == (end[X], end[Z]);
        let cites = element.cites.and(cite::NRC_14).and_if(stands, cite::NRC_20);
        let imaginary = self.compensation.imaginary;
        // The imaginary line leads to the point, not from it.
        let (z, x) = imaginary.unwrap_or((-1, 0));
        let onward = if planted::is(Bug::ImaginaryStart) { 1 } else { -1 };
        self.compensation.last = self.contour(Shape::Line((onward * z, onward * x)));
        let role = Role::StartUp { imaginary: imaginary.is_some() };
        let way = (&start, &end, turn);
        let waiting = self.waiting_motion(role, (element.kind, feed), way, cites, self.readings_of(element));
        self.compensation.phase = Phase::On;
        self.begin_to_wait(waiting);
        Ok(())
    }

    /// An element, or a repetition of the present point.
    fn follow(
        &mut self,
        element: &Element,
        (feed, turn): (Option<Feed>, Option<i64>),
        end: Amounts,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let from = self.present();
        let start = self.arrive(element, feed, end);
        let way = (&start, &end, turn);
        let travel = (element.kind, feed);
        if (start[X], start[Z]) == (end[X], end[Z]) {
            let cites = element.cites.and(cite::NRC_46);
            let waiting = self.waiting_motion(Role::Return, travel, way, cites, self.readings_of(element));
            self.end_waiting(Next::Repetition, sink)?;
            self.release(sink);
            self.begin_to_wait(waiting);
            return Ok(());
        }
        let to = self.present();
        let (shape, of_kind) = match element.kind {
            Kind::Arc { sense, centre_x, centre_z } => {
                let shape = Shape::arc(from, to, Point { x: centre_x, z: centre_z }, sense);
                (shape, cite::NRC_48.and(cite::NRC_60))
            }
            Kind::Rapid => (Shape::line(from, to), cite::NRC_41),
            _ => (Shape::line(from, to), Cites::default()),
        };
        let contour = self.contour(shape);
        if contour.is_too_small() {
            return Fault::raise(AlarmName::CompensationArcTooSmall, rules::NRC_48);
        }
        let cites = element.cites.and(of_kind);
        let waiting = self.waiting_motion(Role::Element, travel, way, cites, self.readings_of(element));
        if self.compensation.waiting.is_some() {
            self.end_waiting(Next::Element(&contour), sink)?;
        } else {
            self.return_to_corner(&contour, sink)?;
        }
        self.release(sink);
        self.compensation.last = contour;
        self.begin_to_wait(waiting);
        Ok(())
    }

    /// A motion of C or W alone: X and Z stay where the tip is when its turn comes.
    fn pass(
        &mut self,
        element: &Element,
        (feed, turn): (Option<Feed>, Option<i64>),
        end: Amounts,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let start = self.arrive(element, feed, end);
        let linear = feed.is_some();
        let mut cites = element.cites.and(cite::NRC_07).and_if(linear, cite::NRC_42);
        let mut readings = self.readings_of(element);
        let mut motion = self.motion_here(turn);
        motion.speed = self.motion_speed(motion.program.x.0, linear, &mut cites, &mut readings);
        let tip = Point { x: motion.program.x.0, z: motion.program.z.0 };
        motion.tip = Some(position(tip));
        motion.nose = Some(position(tip.plus(self.nose().1)));
        let way = (&start, &end, turn);
        let action = self.action((element.kind, feed), motion, way, &mut cites, &mut readings);
        let rules = self.cites.rules(cites);
        self.emit_with(sink, rules, readings, action);
        Ok(())
    }

    /// A motion in G40 while a displacement is there, or of the block that ends compensation.
    fn perform_uncompensated(
        &mut self,
        element: &Element,
        (feed, turn): (Option<Feed>, Option<i64>),
        mut end: Amounts,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let moves = element.moves_plane();
        let tested = self.compensation.barriers_come_first();
        if self.compensation.phase == Phase::Ending {
            self.cancel(moves, sink)?;
        }
        let (mut cites, mut readings) = (element.cites, self.readings_of(element));
        let before = self.compensation.displacement;
        if moves {
            let is_arc = matches!(element.kind, Kind::Arc { .. });
            for axis in [X, Z] {
                if self.limit(axis, &mut end[axis], is_arc)? {
                    cites = cites.and(cite::LIM_01);
                }
            }
            if self.state.watch.acts() && !tested {
                self.check_barriers(element.kind, &end, &mut cites, &mut readings)?;
            }
            let kept = planted::is(Bug::LeftOverAxis) && element.x.is_none();
            self.compensation.displacement = Point { x: if kept { before.x } else { 0 }, z: 0 };
            if self.compensation.phase == Phase::LeftOver {
                self.compensation.phase = Phase::Off;
                cites = cites.and(cite::NRC_71);
            } else {
                cites = cites.and(cite::NRC_66);
            }
        }
        let mut start = self.arrive(element, feed, end);
        displace(&mut start, before);
        displace(&mut end, self.compensation.displacement);
        let mut motion = self.motion_here(turn);
        motion.machine.x = Length(self.state.machine_x(end[X]));
        motion.machine.z = Length(end[Z]);
        motion.speed = self.motion_speed(motion.program.x.0, feed.is_some(), &mut cites, &mut readings);
        let way = (&start, &end, turn);
        let action = self.action((element.kind, feed), motion, way, &mut cites, &mut readings);
        let rules = self.cites.rules(cites);
        self.emit_with(sink, rules, readings, action);
        Ok(())
    }

    /// The programmed point moves; where it was. A motion that the block has no words for is not the last
    /// one of E100L-TUNC-02.
    fn arrive(&mut self, element: &Element, feed: Option<Feed>, end: Amounts) -> Amounts {
        if element.moves_plane() || element.w.is_some() || element.c.is_some() {
            self.state.last_motion_cut = feed.is_some();
        }
        std::mem::replace(&mut self.state.machine, end)
    }

    /// A motion to where the programmed point is now, with the values in force.
    pub(super) fn waiting_motion(
        &mut self,
        role: Role,
        (kind, feed): (Kind, Option<Feed>),
        (start, end, turn): Way,
        mut cites: Cites,
        mut readings: ReadingSet,
    ) -> Waiting {
        let mut motion = self.motion_here(turn);
        motion.speed = self.motion_speed(motion.program.x.0, kind != Kind::Rapid, &mut cites, &mut readings);
        let limits = [X, Z].map(|axis| (self.state.negative_limits[axis], self.state.positive_limits[axis]));
        let (start, end, place, mark) = (*start, *end, self.place, self.lap.mark_number());
        let refusal = None;
        Waiting { role, kind, feed, motion, start, end, turn, limits, place, mark, cites, readings, refusal }
    }

    pub(super) fn begin_to_wait(&mut self, waiting: Waiting) {
        let compensation = &mut self.compensation;
        let counted = planted::is(Bug::RepetitionCounted) && waiting.role == Role::Return;
        compensation.idle_blocks = if counted { IdleBlocks::One } else { IdleBlocks::None };
        compensation.statements = 0;
        compensation.waiting = Some(waiting);
        compensation.moved = true;
        compensation.holding = true;
        compensation.extra = None;
    }

    /// The motion to the present programmed point.
    fn motion_here(&self, turn: Option<i64>) -> Motion {
        let machine = self.state.machine;
        let Point { x, z } = self.present();
        Motion {
            program: self.position(x, z, |axis| self.state.program(axis)),
            machine: self.position(self.state.machine_x(machine[X]), machine[Z], |axis| machine[axis]),
            c_travel: turn.map(Angle),
            ..Motion::default()
        }
    }

    /// The readings of an element's own, and that of the length words of its block.
    fn readings_of(&self, element: &Element) -> ReadingSet {
        if self.inch_block { element.readings.union(self.known.inch) } else { element.readings }
    }

    pub(super) fn contour(&self, shape: Shape) -> Contour {
        let (radius, to_centre) = self.nose();
        let flipped = planted::is(Bug::SideOfNoseThree) && self.state.nose == 3;
        let side = if (self.state.compensation == 41) != flipped { 1 } else { -1 };
        Contour { shape, side, radius, to_centre }
    }

    /// The nose radius in force, and the way from the tip to the nose centre (E100L-NRC-04, E100L-NRC-05).
    pub(super) fn nose(&self) -> (i64, Point) {
        let misread = planted::is(Bug::CutterEntryOfOffset) && self.compensation.is_of_cutter();
        let entry = if misread { self.state.offset } else { self.state.nose };
        let [x, z] = self.state.nose_radii.get(usize::from(entry)).copied().unwrap_or_default();
        let (radius, to_centre) = nose([if planted::is(Bug::BoringTip) { x.abs() } else { x }, z]);
        (if planted::is(Bug::SmallerRadius) { x.abs().min(z.abs()) } else { radius }, to_centre)
    }
}
