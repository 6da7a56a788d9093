//! A motion that waits for its end, and how it ends (E100L-NRC-15, E100L-NRC-21 to E100L-NRC-23,
//! E100L-NRC-44 to E100L-NRC-46, E100L-NRC-66, E100L-NRC-69, E100L-NRC-71, E100L-NRC-80).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{
    AlarmName, Event, Feed, Label, Length, Motion, Place, PlanePosition, ReadingSet, RuleId, Sink,
};

use crate::engine::Interpreter;
use crate::engine::arithmetic::idle::IdleBlocks;
use crate::engine::arithmetic::limit::{Limited, limited};
use crate::engine::arithmetic::plane::{Direction, Point};
use crate::engine::cite::{self, Cites};
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{Amounts, X, Z};

use super::contour::{Contour, Shape};
use super::corner::Corner;

/// What a motion is to compensation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// The motion of the block that begins compensation.
    StartUp {
        /// Whether an imaginary line arrives at its end.
        imaginary: bool,
    },
    /// A motion along the contour.
    Element,
    /// A motion to the present point, by its block or added to it.
    Return,
}

/// Travel limits of X and Z, negative and positive.
pub type Limits = [(Option<i64>, Option<i64>); 2];

/// A motion whose end is not known yet, with what was in force in its block.
#[derive(Clone, Debug)]
pub struct Waiting {
    pub role: Role,
    pub kind: Kind,
    pub feed: Option<Feed>,
    /// Without tip and nose, and with the programmed point in machine coordinates.
    pub motion: Motion,
    /// Machine coordinates of the programmed points, C and W.
    pub start: Amounts,
    pub end: Amounts,
    /// Travel of C.
    pub turn: Option<i64>,
    pub limits: Limits,
    pub place: Place,
    /// The mark of its block, in a definition of LAP.
    pub mark: u32,
    pub cites: Cites,
    pub readings: ReadingSet,
    /// Why it cannot be made, if it has to be made at all.
    pub refusal: Option<Fault>,
}

/// What lets a motion end.
#[derive(Clone, Copy, Debug)]
pub enum Next<'e> {
    /// The next element.
    Element(&'e Contour),
    /// A block that repeats the present point.
    Repetition,
    /// The second block without X/Z motion.
    IdleBlocks,
    /// The end of compensation, by a block with or without X/Z motion, and with the imaginary line of its I
    /// and K.
    Cancel { moves: bool, imaginary: Option<Direction> },
    /// The end of the program.
    ProgramEnd,
}

/// Where a motion ends.
enum Target {
    At(Corner),
    /// Where the axes are.
    Here,
}

impl Interpreter<'_> {
    /// Ends the waiting motion, if one waits.
    pub(super) fn end_waiting(&mut self, next: Next, sink: &mut impl Sink) -> Result<(), Fault> {
        let Some(waiting) = self.compensation.waiting.take() else { return Ok(()) };
        if planted::is(Bug::HeldAhead) {
            self.release(sink);
        }
        let ended = self.target(&waiting, next).and_then(|(target, cites)| {
            if let (Target::At(corner), true) = (&target, self.compensation.is_of_cutter()) {
                return self.conclude_cutter(&waiting, corner, cites, sink);
            }
            let tip = self.tip(&waiting, &target);
            self.conclude(&waiting, tip, cites, sink)
        });
        ended.inspect_err(|_| self.fault_place = Some(waiting.place))
    }

    /// The return to the corner with the next element, if the tip is not there (E100L-NRC-46).
    pub(super) fn return_to_corner(&mut self, next: &Contour, sink: &mut impl Sink) -> Result<(), Fault> {
        let Some(extra) = self.compensation.extra.take() else { return Ok(()) };
        if planted::is(Bug::ExtraForgotten) {
            return Ok(());
        }
        let ended = self.corner_with(next).and_then(|(corner, cites)| {
            let tip = self.tip(&extra, &Target::At(corner));
            if tip == self.tip(&extra, &Target::Here) && !planted::is(Bug::ExtraAlways) {
                return Ok(());
            }
            match &extra.refusal {
                Some(fault) => Err(fault.clone()),
                None => self.conclude(&extra, tip, cites, sink),
            }
        });
        ended.inspect_err(|_| self.fault_place = Some(extra.place))
    }

    /// Where a motion ends, and the rules of its end.
    fn target(&mut self, waiting: &Waiting, next: Next) -> Result<(Target, Cites), Fault> {
        match (waiting.role, next) {
            (Role::StartUp { imaginary: false }, Next::Element(next)) => {
                let cites = cite::NRC_15.and_if(next.is_arc(), cite::NRC_18);
                let own = planted::is(Bug::StartUpRadius);
                let radius = if own { self.compensation.last.radius } else { next.radius };
                Ok((Target::At(Corner::contact_at_beginning(&Contour { radius, ..*next })), cites))
            }
            (Role::StartUp { .. }, Next::Element(next)) => {
                let (corner, cites) = self.corner_with(next)?;
                Ok((Target::At(corner), cites.and(cite::NRC_23).and(self.idle_cites())))
            }
            (Role::StartUp { .. }, next) => Err(no_element(next)),
            (_, Next::Element(next)) => {
                let (corner, cites) = self.corner_with(next)?;
                Ok((Target::At(corner), cites.and(self.idle_cites())))
            }
            (Role::Element, Next::Cancel { imaginary: Some(line), .. }) => {
                let (z, x) = line;
                let line = if planted::is(Bug::ImaginaryCancel) { (-z, -x) } else { line };
                let line = Contour { shape: Shape::Line(line), ..self.compensation.last };
                let (corner, cites) = self.corner_with(&line)?;
                Ok((Target::At(corner), cites.and(cite::NRC_69).and(self.idle_cites())))
            }
            (Role::Element, next) => {
                Ok((Target::At(Corner::contact_at_end(&self.compensation.last)), contact_cites(next)))
            }
            (Role::Return, _) => Ok((Target::Here, Cites::default())),
        }
    }

    /// The corner of the last element and the next one (E100L-NRC-53).
    fn corner_with(&mut self, next: &Contour) -> Result<(Corner, Cites), Fault> {
        Corner::between(&self.compensation.last, next, &mut self.slow)
            .ok_or_else(|| Fault::new(AlarmName::CompensationNoIntersection, rules::NRC_53))
    }

    /// One block without X/Z motion between two elements (E100L-NRC-43).
    fn idle_cites(&self) -> Cites {
        Cites::default().and_if(self.compensation.idle_blocks == IdleBlocks::One, cite::NRC_43)
    }

    /// The latched tip in program coordinates of the block of a motion.
    fn tip(&mut self, waiting: &Waiting, target: &Target) -> Point {
        let at = Point { x: waiting.motion.program.x.0, z: waiting.motion.program.z.0 };
        match target {
            Target::Here => at.plus(self.compensation.displacement),
            Target::At(corner) => {
                let nose = corner.latch(at, &mut self.slow);
                let later = planted::is(Bug::TipOfNextNose);
                nose.minus(if later { self.nose().1 } else { self.compensation.last.to_centre })
            }
        }
    }

    /// Tests the end of a motion and hands its event over.
    fn conclude(
        &mut self,
        waiting: &Waiting,
        tip: Point,
        cites: Cites,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let Waiting { mut motion, mut start, mut end, mut readings, .. } = *waiting;
        self.check_coordinate(tip.x)?;
        self.check_coordinate(tip.z)?;
        let programmed = Point { x: motion.program.x.0, z: motion.program.z.0 };
        let before = std::mem::replace(&mut self.compensation.displacement, tip.minus(programmed));
        if planted::is(Bug::LimitOfProgrammed) {
            check_limits(end, &waiting.limits, self.state.mirror)?;
        }
        if !planted::is(Bug::PathOfProgrammed) {
            displace(&mut start, before);
        }
        displace(&mut end, self.compensation.displacement);
        if !planted::is(Bug::LimitOfProgrammed) {
            check_limits(end, &waiting.limits, self.state.mirror)?;
        }
        let nose = tip.plus(self.compensation.last.to_centre);
        motion.machine.x = Length(self.state.machine_x(end[X]));
        motion.machine.z = Length(end[Z]);
        motion.tip = Some(position(tip));
        motion.nose = Some(position(nose));
        let linear = waiting.kind == Kind::Linear;
        let mut cites = waiting.cites.and(cites).and(cite::NRC_07).and_if(linear, cite::NRC_42);
        let travel = (waiting.kind, waiting.feed);
        let action = self.action(travel, motion, (&start, &end, waiting.turn), &mut cites, &mut readings);
        let rules = self.cites.rules(cites);
        let mut event = Event::new(0, waiting.place, rules, readings, action);
        self.name_side(&mut event);
        if !self.lap.observes() || !self.take_note(&event, waiting.mark) {
            self.emit_at_once(sink, &mut event);
        }
        Ok(())
    }
}

/// Moves the X and Z of a machine position by a displacement.
pub fn displace(machine: &mut Amounts, by: Point) {
    let Point { x, z } = Point { x: machine[X], z: machine[Z] }.plus(by);
    (machine[X], machine[Z]) = (x, z);
}

/// A point as an event shows it.
pub fn position(point: Point) -> PlanePosition {
    PlanePosition { x: Length(point.x), z: Length(point.z) }
}

/// A compensated position beyond a travel limit (E100L-NRC-80).
fn check_limits(end: Amounts, limits: &Limits, mirror: i64) -> Result<(), Fault> {
    for (machine, limits) in [mirror * end[X], end[Z]].into_iter().zip(limits) {
        check_limit(machine, *limits)?;
    }
    Ok(())
}

/// A compensated machine coordinate beyond a travel limit, negative or positive (E100L-NRC-80).
pub fn check_limit(machine: i64, (negative, positive): (Option<i64>, Option<i64>)) -> Result<(), Fault> {
    match limited(machine, negative, positive) {
        Limited::Within => Ok(()),
        Limited::AbovePositive(_) => Fault::raise(AlarmName::TravelLimitPositive, rules::NRC_80),
        Limited::BelowNegative => Fault::raise(AlarmName::TravelLimitNegative, rules::NRC_80),
    }
}

/// Why a start-up cannot end.
#[cold]
fn no_element(next: Next) -> Fault {
    match next {
        Next::Repetition => Fault::new(AlarmName::CompensationStartUp, rules::NRC_21),
        Next::IdleBlocks => Fault::new(AlarmName::CompensationStartUp, rules::NRC_22),
        _ => undefined(rules::NRC_15, "start_up"),
    }
}

/// What the manual does not define.
#[cold]
pub fn undefined(rule: RuleId, what: &str) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, Label::new(what))
}

/// The rule by which an element ends in contact.
fn contact_cites(next: Next) -> Cites {
    match next {
        Next::Repetition => cite::NRC_45,
        Next::Cancel { moves: true, .. } => cite::NRC_66,
        Next::Cancel { .. } => cite::NRC_71,
        _ => cite::NRC_44,
    }
}
