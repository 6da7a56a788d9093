//! Two saddles: which side goes on, and how the program ends (E100L-AX4-01, E100L-AX4-02, E100L-AX4-05, E100L-AX4-12).
//!
//! Side A runs until it waits or has ended, then side B; then they meet, and one or both go on (`meeting`). The order
//! depends on the words of the sides alone, never on how long something takes.

use std::collections::VecDeque;

use super::channel::Channel;
use super::portions::{Portion, has_blocks};
use super::reading::{self, Block, Content};
use super::side::{SideProgram, Status};
use super::{Progress, Texts};
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::modal;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Place, Setup, Side};

/// The programs of two saddles.
pub struct Saddles<'a> {
    /// What stands in front of the first selection, until it was read.
    front: Option<Channel<'a>>,
    /// Whether there is a selection.
    divided: bool,
    pub(super) a: SideProgram<'a>,
    pub(super) b: SideProgram<'a>,
    /// The side that has moved last: its state tells what is common.
    active: Side,
    /// The sides whose waiting block comes next, alone (E100L-PSYNC-03).
    pub(super) together: VecDeque<Side>,
    /// The side that ended last, and the last one that ended with M02 or M30.
    ended: (Side, Option<Side>),
}

impl<'a> Saddles<'a> {
    /// Before the first block.
    pub fn new(texts: &Texts<'a>, setup: &'a Setup) -> Self {
        let front = Portion::front(texts, setup);
        let of_side = |side| texts.of_portion(front.of_side(side));
        let (has_a, has_b) = (has_blocks(&of_side(Side::A), setup), has_blocks(&of_side(Side::B), setup));
        let program = |side, own, other: bool| {
            let mut channel = Channel::new(of_side(side), State::of_saddle(setup, side));
            channel.state.set_alone(!other);
            SideProgram::new(channel, own)
        };
        Self {
            divided: front.is_divided(),
            a: program(Side::A, has_a, has_b),
            b: program(Side::B, has_b, has_a),
            front: Some(Channel::new(texts.of_portion(front), State::of_saddle(setup, Side::A))),
            active: Side::A,
            together: VecDeque::new(),
            ended: (Side::A, None),
        }
    }

    /// Carries out the next block of a side, or lets the sides meet.
    pub fn step(&mut self, place: &mut Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<Progress> {
        if let Some(front) = &mut self.front {
            if let Some(Begun) = read_front(front, self.divided, place)? {
                self.begin();
            }
            return Ok(Progress::Going);
        }
        match self.together.pop_front().or_else(|| self.ready()) {
            Some(side) => self.go_on(side, place, decided).map(|()| Progress::Going),
            None if self.a.waits_at().is_none() && self.b.waits_at().is_none() => {
                self.end(place, decided).map(|()| Progress::Ended)
            }
            None => self.meet(place, decided).map(|()| Progress::Going),
        }
    }

    /// The side that moves, or has moved last.
    pub fn active(&self) -> &Channel<'a> {
        match self.active {
            Side::A => &self.a.channel,
            Side::B => &self.b.channel,
        }
    }

    fn begin(&mut self) {
        let Some(front) = self.front.take() else { return };
        let name = front.calls.running().name;
        self.a.begin(name, front.reader.steps);
        self.b.begin(name, front.reader.steps);
    }

    fn ready(&self) -> Option<Side> {
        [(Side::A, &self.a), (Side::B, &self.b)]
            .into_iter()
            .find(|(_, program)| program.is_ready())
            .map(|(side, _)| side)
    }

    fn go_on(&mut self, side: Side, place: &mut Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<()> {
        let program = self.enter(side);
        program.go_on(place, decided)?;
        let in_cycle = program.is_in_cycle();
        if matches!(program.status, Status::Ended) {
            let by_code = program.ended_with.map(|_| side);
            self.ended = (side, by_code.or(self.ended.1));
        }
        if in_cycle {
            // The passes of a block follow each other.
            self.together.push_front(side);
        }
        Ok(())
    }

    /// A side moves: what is common is as the other one has left it (E100L-AX4-11).
    pub(super) fn enter(&mut self, side: Side) -> &mut SideProgram<'a> {
        let (program, other) = match side {
            Side::A => (&mut self.a, &self.b.channel),
            Side::B => (&mut self.b, &self.a.channel),
        };
        let channel = &mut program.channel;
        if self.active != side {
            channel.state.take_common(&other.state);
            channel.reader.steps = other.reader.steps;
        }
        channel.state.see_other_at(other.state.frame.program().x);
        self.active = side;
        program
    }

    /// E100L-AX4-05: the reset of side A, that of side B without what is common, and the end, where M02 or M30 was carried
    /// out last.
    fn end(&mut self, place: &mut Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<()> {
        let (last, by_code) = self.ended;
        let Some((side, (block, code))) =
            by_code.and_then(|side| self.enter(side).ended_with.map(|ended_with| (side, ended_with)))
        else {
            let channel = &self.enter(last).channel;
            let texts = channel.reader.programs.texts();
            *place = Place { program: channel.calls.running().name, ..texts.end(texts.start(0)) };
            return fail(AlarmName::NoProgramEnd, PROG_02);
        };
        for each in [Side::A, Side::B] {
            let state = &mut self.enter(each).channel.state;
            decided.extend(modal::reset(state).into_iter().map(|event| (block, event.of(Some(each)))));
        }
        let end = modal::end(code, &self.enter(side).channel.state);
        decided.push((block, end.rule_if(true, AX4_05)));
        Ok(())
    }
}

/// What stands in front of the first selection was read.
struct Begun;

/// E100L-AX4-02: reads the next block in front of the first selection, on side A.
fn read_front(front: &mut Channel, divided: bool, place: &mut Place) -> Outcome<Option<Begun>> {
    if front.schedule.is_some() {
        // E100L-AX4-12.
        let texts = front.reader.programs.texts();
        *place = texts.end(texts.start(0));
        return Err(Fault::about(AlarmName::Unspecified, AX4_12, "schedule"));
    }
    match front.reader.arrive(front.calls.running_mut(), place)? {
        Some(Block { content: Content::Nothing | Content::Name, .. }) => Ok(None),
        Some(_) => Err(Fault::about(AlarmName::Unspecified, AX4_02, "turret")),
        None if divided => Ok(Some(Begun)),
        None => Err(reading::end(front.calls.running())),
    }
}
