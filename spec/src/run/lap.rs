//! A call of LAP carried out: its definition block by block, then its passes (execution-lap.md, sections 4 to 7).

use super::Progress;
use super::channel::Channel;
use super::outline::Outline;
use super::reading::{Block, Content};
use super::statement::Carried;
use crate::barrier::Watch;
use crate::compensation::Compensation;
use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::frame::{Limits, TravelLimit};
use crate::lap::{Cycle, Purpose, Recording};
use crate::modal::{self, Plan, Words};
use crate::state::{Modes, State, StoredFeed};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Place, RuleId, RuleSet};

/// A call that is carried out.
pub struct Lap<'a> {
    pub(super) call: Plan,
    pub(super) block: Carried,
    /// How many called programs are active where it stands.
    pub(super) depth: usize,
    pub(super) stage: Stage,
    /// The state of the call, while its contour is read.
    kept: Option<State<'a>>,
    /// The modes of the call (E100L-LAP-13).
    modes: Modes,
    /// The contour feed commanded last before the call (E100L-LAP-08).
    feed: Option<StoredFeed>,
    pub(super) recording: Recording,
}

/// How far a call has come.
pub(super) enum Stage {
    /// The block that it names is next.
    Start,
    /// The blank in front of the contour of G87 is passed over.
    Blank,
    /// The blocks of the blank or of the contour.
    Definition,
    /// The passes.
    Passes(Cycle),
}

impl Lap<'_> {
    fn code(&self) -> u16 {
        self.call.one_shot.unwrap_or_default()
    }

    pub(super) fn purpose(&self) -> Purpose {
        match self.code() {
            87 => Purpose::Finish,
            88 => Purpose::Thread,
            _ => Purpose::Rough,
        }
    }

    pub(super) fn malformed(&self, rule: RuleId, detail: &str) -> Fault {
        Fault::about(AlarmName::ContourMalformed, rule, detail).of_block(self.block.place)
    }
}

impl<'a> Channel<'a> {
    /// E100L-LAP-09: whether the program that runs has the block that a call names.
    pub(super) fn has_contour(&mut self, words: &Words) -> bool {
        let start = self.calls.running().start;
        words.contour.is_some_and(|name| self.reader.programs.block(name, start).is_some())
    }

    /// The next block. E100L-LAP-10: a definition that is passed over ends before its program does.
    pub(super) fn arrive(&mut self, place: &mut Place) -> Outcome<Option<Block>> {
        let Some(begun) = self.passing else {
            return self.reader.arrive(self.calls.running_mut(), place);
        };
        if self.reader.at_end(self.calls.running())? {
            let fault = Fault::about(AlarmName::ContourMalformed, LAP_10, "end");
            return Err(fault.of_block(begun));
        }
        let block = self.reader.arrive(self.calls.running_mut(), place)?;
        Ok(block.map(|block| {
            if block.definition.contains(&80) {
                self.passing = None;
            }
            // Nothing of it is evaluated.
            Block { content: Content::Nothing, ..block }
        }))
    }

    /// The run goes on with the block that a call names.
    pub(super) fn begin_call(&mut self, call: Plan, block: Carried) {
        self.state.base = None;
        let (modes, feed) = (self.state.modes, self.state.lap.feed);
        let start = self.calls.running().start;
        if let Some(contour) = call.words.contour.and_then(|name| self.reader.programs.block(name, start)) {
            self.reader.go_to(contour);
        }
        let depth = self.calls.depth();
        let recording = Recording::default();
        let mut lap = Lap { call, block, depth, stage: Stage::Start, kept: None, modes, feed, recording };
        if lap.purpose() != Purpose::Finish {
            lap.kept = Some(self.state.clone());
            self.state.only_read();
        }
        self.lap = Some(Box::new(lap));
    }

    /// The next block of the definition, or the next pass.
    pub(super) fn go_on_in_call(
        &mut self,
        mut lap: Box<Lap<'a>>,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<Progress> {
        let ended = match &mut lap.stage {
            Stage::Start => self.first_block(&mut lap, place, decided).map(|()| false),
            Stage::Blank => self.pass_over_blank(&mut lap, place).map(|()| false),
            Stage::Definition => self.block_of_definition(&mut lap, place, decided),
            Stage::Passes(cycle) => {
                let block = lap.block.place;
                self.reader.step(block, place)?;
                let mut stream = self.compensation.stream(block, self.state.side(), decided);
                let left = cycle.pass(&mut self.state, &mut stream.emissions);
                stream.close();
                left.map(|left| !left)
            }
        };
        if !ended? {
            self.lap = Some(lap);
        }
        Ok(Progress::Going)
    }

    /// The state is again that of the call, but for variables, local variables and E. `all`: the reading has ended.
    pub(super) fn forget_reading(&mut self, lap: &mut Lap<'a>, all: bool) {
        let state = if all { lap.kept.take() } else { lap.kept.clone() };
        let Some(state) = state else { return };
        let before = std::mem::replace(&mut self.state, state);
        self.compensation = Compensation::Off;
        self.state.memory = before.memory;
        self.state.lap.feed = before.lap.feed;
        if !all {
            self.state.only_read();
        }
    }

    /// The definition has ended: of G87 with the modes of the call (E100L-LAP-13), else with the first pass.
    pub(super) fn end_of_definition(
        &mut self,
        lap: &mut Lap<'a>,
        here: Place,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<bool> {
        self.reader.go_to(lap.block.behind);
        if lap.purpose() == Purpose::Finish {
            self.state.lap.definition = None;
            self.state.base = None;
            let side = self.state.side();
            decided.extend(self.modes_of_call(lap).into_iter().map(|event| (here, event.of(side))));
            return Ok(true);
        }
        self.forget_reading(lap, true);
        *place = lap.block.place;
        let recording = std::mem::take(&mut lap.recording);
        let number = self.outline.as_ref().map_or(1, |last| last.number.saturating_add(1));
        self.outline = Some(Box::new(Outline::of(number, &recording)));
        let mut cycle = Cycle::begin(&lap.call, recording, lap.feed, &self.state)?;
        let mut stream = self.compensation.stream(lap.block.place, self.state.side(), decided);
        let left = cycle.pass(&mut self.state, &mut stream.emissions);
        stream.close();
        lap.stage = Stage::Passes(cycle);
        left.map(|left| !left)
    }

    fn modes_of_call(&mut self, lap: &Lap<'a>) -> Vec<Emission> {
        let mut events = Vec::new();
        for group in [GGroup::Motion, GGroup::Dimension] {
            let (code, previous) = (lap.modes.get(group), self.state.modes.get(group));
            if code != previous {
                self.state.modes.set(group, code);
                let rules = RuleSet::of(&[GCODE_02, LAP_13]);
                events.push(Emission::new(modal::mode(group, code, previous), rules));
            }
        }
        events
    }
}

impl State<'_> {
    /// Nothing moves: no limits and no barriers are tested.
    fn only_read(&mut self) {
        let none = TravelLimit { positive: None, negative: None };
        self.limits = Limits { x: none, z: none, w: none };
        self.watch = Watch::default();
        self.activate(20);
        self.activate(24);
    }
}
