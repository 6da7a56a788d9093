//! The definition of a call of LAP, block by block (execution-lap.md, sections 5 and 6).

use super::channel::Channel;
use super::lap::{Lap, Stage};
use super::reading::{self, Block, Content};
use super::statement::Carried;
use crate::compensation::Stream;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::lap::{self, Definition, Mark, Purpose};
use crate::modal::{self, Before};
use crate::state::State;
use crate::syntax::Statement;
use crate::turret;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Label, Place};

/// Which code of a definition has ended its part.
enum Closed {
    /// G81 or G82 has ended the blank.
    Blank(u16),
    /// G80 has ended the contour.
    Contour,
}

impl<'a> Channel<'a> {
    /// E100L-LAP-09: the block that the call names begins a definition.
    pub(super) fn first_block(
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
    pub(super) fn pass_over_blank(&mut self, lap: &mut Lap<'a>, place: &mut Place) -> Outcome<()> {
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
    pub(super) fn block_of_definition(
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
        refuse_content(&block.content, called, &self.state)?;
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
}

impl Block {
    fn behind_at(&self) -> Carried {
        Carried { place: self.place, behind: self.behind }
    }
}

/// E100L-LAP-04, E100L-LAP-14: what a block of a definition may not hold, as it is written. `called`: it stands in a
/// program that the definition has called.
pub(super) fn refuse_content(content: &Content, called: bool, state: &State) -> Outcome<()> {
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
        Content::Turret(codes) => {
            let blank = state.lap.definition.as_ref().is_some_and(|definition| definition.blank);
            Err(turret::in_definition(codes, blank, state))
        }
        Content::Nothing | Content::Name | Content::Words(_) => Ok(()),
    }
}
