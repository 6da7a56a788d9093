//! Two saddles, each with a program of its own in one text ("How two turrets and two saddles run", section 4;
//! E100L-AX4-01 to E100L-AX4-12, E100L-PSYNC-01 to E100L-PSYNC-09, E100L-M100-01 to E100L-M100-06).
//!
//! The interpreter runs one side at a time. What the other one has for itself waits in [`Lane`] meanwhile; the main
//! spindle and the count of steps go along.

mod common;
mod division;
mod end;
mod order;
mod side;

use turnspec_oracle::vocabulary::{Length, MachineType, Place, Setup, Side};

use super::Interpreter;
use super::block::Plan;
use super::compensation::Compensation;
use super::names::Names;
use super::slot::Slot;
use super::state::{State, X};
use super::task::Task;
use super::text::Reader;
use common::CommonWords;
use division::Division;
use end::End;

/// What each side has for itself.
#[derive(Debug)]
pub struct Lane<'a> {
    reader: Reader<'a>,
    names: Names,
    begun: bool,
    ahead: [Slot; 2],
    ahead_count: usize,
    current: Option<Box<Slot>>,
    place: Place,
    inch_block: bool,
    state: State,
    task: Task<'a>,
    compensation: Compensation,
}

/// Where a side stands.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
enum Standing {
    #[default]
    Ready,
    /// It waits at a P word.
    AtP(u16),
    /// It waits at M100.
    AtM100,
    Ended,
}

/// With what a side goes on.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
enum Resume {
    #[default]
    NextBlock,
    /// With the checks of the block that waited at its P.
    Checks,
    /// With what comes behind the motion of the block that waited at its M100.
    Conclusion(Plan),
}

/// What is known of a side.
#[derive(Clone, Copy, Default, Debug)]
struct Record {
    standing: Standing,
    resume: Resume,
    /// Whether there is no other side to wait for (E100L-PSYNC-04, E100L-M100-03).
    alone: bool,
    /// The common words of the block that waits.
    common: CommonWords,
    /// The last block that counts.
    last_block: Place,
}

/// One of each side.
#[derive(Clone, Copy, Default, Debug)]
struct Both<T> {
    a: T,
    b: T,
}

impl<T> Both<T> {
    fn of(&self, side: Side) -> &T {
        match side {
            Side::A => &self.a,
            Side::B => &self.b,
        }
    }

    fn of_mut(&mut self, side: Side) -> &mut T {
        match side {
            Side::A => &mut self.a,
            Side::B => &mut self.b,
        }
    }
}

/// How the common words of a block are carried out (E100L-AX4-06).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Shared {
    /// For the block alone.
    #[default]
    No,
    /// For the block and that of the other side.
    ForBoth,
    /// The block of the other side has done it.
    Done,
}

/// How far a run is.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
enum Stage {
    /// The text is not divided yet.
    #[default]
    Text,
    /// In front of the first selection.
    Head,
    /// In the side programs.
    Sides,
}

/// What a machine of two saddles remembers; nothing on others.
#[derive(Debug, Default)]
pub struct Saddles<'a> {
    stage: Stage,
    division: Division,
    records: Both<Record>,
    /// The side that does not run.
    idle: Option<Box<Lane<'a>>>,
    pub shared: Shared,
    /// The side that ended last.
    last_ended: Option<Side>,
    /// The M02 or M30 that was carried out last.
    end: Option<End>,
}

/// The side that runs first, where there are two saddles.
pub fn first(setup: &Setup) -> Option<Side> {
    (setup.machine.r#type == MachineType::TwoSaddles).then_some(Side::A)
}

impl<'a> Interpreter<'a> {
    /// The side that runs.
    fn side(&self) -> Side {
        self.saddle.unwrap_or(Side::A)
    }

    fn record(&self) -> &Record {
        self.saddles.records.of(self.side())
    }

    fn record_mut(&mut self) -> &mut Record {
        let side = self.side();
        self.saddles.records.of_mut(side)
    }

    /// A side runs from now on.
    fn turn_to(&mut self, side: Side) {
        if self.saddle == Some(side) {
            return;
        }
        let Some(idle) = self.saddles.idle.as_deref_mut() else { return };
        std::mem::swap(&mut self.reader, &mut idle.reader);
        std::mem::swap(&mut self.names, &mut idle.names);
        std::mem::swap(&mut self.begun, &mut idle.begun);
        std::mem::swap(&mut self.ahead, &mut idle.ahead);
        std::mem::swap(&mut self.ahead_count, &mut idle.ahead_count);
        std::mem::swap(&mut self.current, &mut idle.current);
        std::mem::swap(&mut self.place, &mut idle.place);
        std::mem::swap(&mut self.inch_block, &mut idle.inch_block);
        std::mem::swap(&mut self.state, &mut idle.state);
        std::mem::swap(&mut self.task, &mut idle.task);
        std::mem::swap(&mut self.compensation, &mut idle.compensation);
        self.state.take_spindle(&idle.state);
        self.task.take_steps(&idle.task);
        self.saddle = Some(side);
    }

    /// Whether the cutting speed is that of the side that runs (E100L-AX4-08); so it is where there is one saddle.
    #[inline]
    pub(super) fn is_speed_reference(&self) -> bool {
        match self.saddle {
            None => true,
            Some(side) => self.state.speed_by_b == (side == Side::B),
        }
    }

    /// The program diameter that the cutting speed follows.
    pub(super) fn speed_diameter(&self) -> i64 {
        match &self.saddles.idle {
            Some(idle) if !self.is_speed_reference() => idle.state.program(X),
            _ => self.state.program(X),
        }
    }

    /// The torque stops of the saddle that runs.
    pub(super) fn torque_stops(&self) -> &'a [Length] {
        match self.saddle {
            Some(Side::B) => &self.setup.turret_b.torque_stops,
            _ => &self.setup.inputs.torque_stops,
        }
    }
}
