//! A call of LAP carried out: its definition block by block, then its passes (execution-lap.md, sections 4 to 7).

use super::Progress;
use super::channel::Channel;
use super::reading::{self, Block, Content};
use super::statement::Carried;
use crate::barrier::Watch;
use crate::compensation::{Compensation, Stream};
use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::frame::{Limits, TravelLimit};
use crate::lap::{self, Cycle, Definition, Mark, Purpose, Recording};
use crate::modal::{self, Before, Plan, Words};
use crate::state::{Modes, State, StoredFeed};
use crate::syntax::Statement;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Label, Place, RuleId, RuleSet, Side};

/// A call that is carried out.
pub struct Lap<'a> {
    call: Plan,
    block: Carried,
    /// How many called programs are active where it stands.
    depth: usize,
    stage: Stage,
    /// The state of the call, while its contour is read.
    kept: Option<State<'a>>,
    /// The modes of the call (E100L-LAP-13).
    modes: Modes,
    /// The contour feed commanded last before the call (E100L-LAP-08).
    feed: Option<StoredFeed>,
    recording: Recording,
}

/// How far a call has come.
enum Stage {
    /// The block that it names is next.
    Start,
    /// The blank in front of the contour of G87 is passed over.
    Blank,
    /// The blocks of the blank or of the contour.
    Definition,
    /// The passes.
    Passes(Cycle),
}

/// Which code of a definition has ended its part.
enum Closed {
    /// G81 or G82 has ended the blank.
    Blank(u16),
    /// G80 has ended the contour.
    Contour,
}

impl Lap<'_> {
    fn code(&self) -> u16 {
        self.call.one_shot.unwrap_or_default()
    }

    fn purpose(&self) -> Purpose {
        match self.code() {
            87 => Purpose::Finish,
            88 => Purpose::Thread,
            _ => Purpose::Rough,
        }
    }

    fn malformed(&self, rule: RuleId, detail: &str) -> Fault {
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

    /// E100L-LAP-09: the block that the call names begins a definition.
    fn first_block(
        &mut self,
        lap: &mut Lap<'a>,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<()> {
        let Some(block) = self.reader.arrive(self.calls.running_mut(), place)? else {
            return Err(reading::end(self.calls.running()));
        };
        let mut stream = self.compensation.stream(block.place, self.state.side(), decided);
        let behind = block.behind_at();
        let code = self.code_of_definition(block.content, behind, &mut stream);
        stream.close();
        match code? {
            Some(83) if lap.purpose() == Purpose::Finish => lap.stage = Stage::Blank,
            Some(code) if code != 83 || lap.purpose() != Purpose::Thread => self.begin_definition(code, lap),
            _ => return Err(lap.malformed(LAP_09, "start")),
        }
        Ok(())
    }

    /// The code with which a block begins a definition, if it does; evaluated and checked like any other.
    fn code_of_definition(
        &mut self,
        content: Content,
        block: Carried,
        stream: &mut Stream,
    ) -> Outcome<Option<u16>> {
        if !matches!(content, Content::Items(_) | Content::ContourCall(..)) {
            return Ok(None);
        }
        let Some(words) = self.words(content, block, stream)? else { return Ok(None) };
        let before = Before { has_contour: self.has_contour(&words), ..self.before() };
        let plan = modal::check(words, before, &self.state)?;
        Ok(plan.one_shot.filter(|_| plan.begins_definition()))
    }

    /// G87: the blank is passed over (E100L-LAPC-06, E100L-LAP-02).
    fn pass_over_blank(&mut self, lap: &mut Lap<'a>, place: &mut Place) -> Outcome<()> {
        let ended = self.reader.at_end(self.calls.running())?;
        let block = if ended { None } else { self.reader.arrive(self.calls.running_mut(), place)? };
        let codes = block.map_or_else(|| vec![80], |block| block.definition);
        if codes.contains(&80) {
            return Err(lap.malformed(LAP_02, "blank"));
        }
        if let Some(code) = codes.into_iter().find(|code| matches!(code, 81 | 82)) {
            self.begin_definition(code, lap);
        }
        Ok(())
    }

    /// A blank or a contour begins.
    fn begin_definition(&mut self, code: u16, lap: &mut Lap<'a>) {
        let present = self.state.frame.program();
        let allowance = |letter| lap.call.words.get(letter).unwrap_or(0);
        let finishing = lap.purpose() == Purpose::Finish;
        self.state.lap.definition = Some(Definition {
            purpose: lap.purpose(),
            depth: lap.depth,
            blank: code == 83,
            feed: None,
            moved: false,
            allowance: if finishing { (allowance('U'), allowance('W')) } else { (0, 0) },
            from: (present.x, present.z),
            shift: (0, 0),
            mark: Mark::NONE,
        });
        lap.recording.begin(code);
        lap.stage = Stage::Definition;
    }

    /// One block of a definition; whether the call is at its end.
    fn block_of_definition(
        &mut self,
        lap: &mut Lap<'a>,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<bool> {
        let called = self.calls.depth() > lap.depth;
        if !called && self.reader.at_end(self.calls.running())? {
            return Err(lap.malformed(LAP_01, "end"));
        }
        let Some(block) = self.reader.arrive(self.calls.running_mut(), place)? else {
            return Err(reading::end(self.calls.running()));
        };
        refuse_content(&block.content, called)?;
        let here = block.place;
        let mut events = Vec::new();
        let mut stream = self.compensation.stream(here, self.state.side(), &mut events);
        let behind = block.behind_at();
        let closed = self.carry_out_in_definition(block.content, behind, &mut stream);
        stream.close();
        self.emit_or_record(events, lap, decided);
        match closed? {
            None => Ok(false),
            Some(Closed::Blank(code)) => {
                lap.recording.check_blank()?;
                self.forget_reading(lap, false);
                self.begin_definition(code, lap);
                Ok(false)
            }
            Some(Closed::Contour) => {
                self.check_end(lap)?;
                self.end_of_definition(lap, here, place, decided)
            }
        }
    }

    /// What is emitted while a contour is read, and what is recorded of it.
    fn emit_or_record(
        &self,
        events: Vec<(Place, Emission)>,
        lap: &mut Lap<'a>,
        decided: &mut Vec<(Place, Emission)>,
    ) {
        let reading = self.state.lap.is_reading();
        for (place, event) in events {
            lap.recording.record(&event);
            if !reading
                || matches!(event.action, Action::Variable { .. } | Action::Call { .. } | Action::Return)
            {
                decided.push((place, event));
            }
        }
    }

    fn carry_out_in_definition(
        &mut self,
        content: Content,
        block: Carried,
        stream: &mut Stream,
    ) -> Outcome<Option<Closed>> {
        let Some(words) = self.words(content, block, stream)? else { return Ok(None) };
        let moved = self.state.lap.definition.is_some_and(|definition| definition.moved);
        lap::refuse_words(&words, moved, &self.state)?;
        let moved = self.up_to_motion(words, stream)?;
        self.end_of_block(&moved, stream)?;
        Ok(match moved.plan.one_shot {
            Some(code @ (81 | 82)) => Some(Closed::Blank(code)),
            _ if moved.plan.words.has_g(80) => Some(Closed::Contour),
            _ => None,
        })
    }

    /// What must hold behind the block with G80 (E100L-LAP-16, E100L-LAP-01, E100L-AP3-01).
    fn check_end(&self, lap: &Lap<'a>) -> Outcome<()> {
        let malformed = |rule, detail| Err(Fault::about(AlarmName::ContourMalformed, rule, detail));
        if self.state.modes.compensating() {
            return malformed(LAP_16, "G40");
        }
        if self.calls.depth() > lap.depth {
            return malformed(LAP_01, "G80");
        }
        lap.recording.check_contour(lap.purpose() == Purpose::Thread)
    }

    /// The state is again that of the call, but for variables, local variables and E. `all`: the reading has ended.
    fn forget_reading(&mut self, lap: &mut Lap<'a>, all: bool) {
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
    fn end_of_definition(
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

impl Block {
    fn behind_at(&self) -> Carried {
        Carried { place: self.place, behind: self.behind }
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

/// E100L-LAP-04, E100L-LAP-14: what a block of a definition may not hold, as it is written. `called`: it stands in a
/// program that the definition has called.
pub(super) fn refuse_content(content: &Content, called: bool) -> Outcome<()> {
    let unspecified = |detail: &str| Err(Fault::about(AlarmName::Unspecified, LAP_04, detail));
    match content {
        Content::Statement(Statement::Call(_, settings)) => lap::refuse_assignments(settings),
        Content::Statement(Statement::Goto(_) | Statement::If(..)) => Ok(()),
        Content::Statement(Statement::Return) if called => Ok(()),
        Content::Statement(statement) => unspecified(statement.label().as_str()),
        Content::Communication(statement) => unspecified(statement.keyword()),
        Content::Items(items) => lap::refuse_assignments(items),
        Content::ContourCall(_, items) => {
            lap::refuse_assignments(items)?;
            let code = items.first().and_then(|item| item.kind.plain_g()).unwrap_or_default();
            let label = Label::of_code(b'G', code);
            Err(Fault::about(AlarmName::ContourMalformed, LAP_14, label.as_str()))
        }
        Content::Turret(sides) => {
            let code = if sides.first() == Some(&Side::B) { "G14" } else { "G13" };
            Err(Fault::about(AlarmName::ContourMalformed, LAP_04, code))
        }
        Content::Nothing | Content::Name | Content::Words(_) => Ok(()),
    }
}
