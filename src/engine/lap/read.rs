//! Reading a definition (execution of LAP, 5): its blocks are carried out on a copy of the state, and their motions are
//! recorded.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Label, Sink};

use crate::engine::Interpreter;
use crate::engine::barriers::Watch;
use crate::engine::block::{Before, OneShot};
use crate::engine::compensation::{Change, Compensation};
use crate::engine::fault::Fault;
use crate::engine::slot::Slot;
use crate::engine::state::State;
use crate::engine::words::Address;

use super::definition::{BlockMark, Definition, Purpose};
use super::{Code, Progress, malformed};

/// A definition that was read.
#[derive(Debug)]
pub struct Reading {
    /// Whether it begins with G81.
    pub along: bool,
    /// Whether it has a blank.
    pub blank: bool,
    pub definition: Box<Definition>,
}

impl Interpreter<'_> {
    /// Reads the definition that a call names.
    pub(super) fn read_definition(
        &mut self,
        call: &Slot,
        code: Code,
        sink: &mut impl Sink,
    ) -> Result<Reading, Fault> {
        let inch = self.inch_block;
        let purpose = if code == Code::Thread { Purpose::Thread } else { Purpose::Rough };
        let mut slot = Slot::default();
        let kept = Box::new(self.state.clone());
        let mut definition = self.definition(purpose, Code::Along);
        let place = self.place;
        self.lap.observes = true;
        self.copy_state(&kept);
        // Where the block with the contour name stands, nothing is recorded.
        let found = self.begin_definition(call.parsed.contour, &mut slot, sink)?;
        if found == Code::Blank && code == Code::Thread {
            return Err(malformed(LAP_09, const { Label::new("start") }));
        }
        let blank = found == Code::Blank;
        definition.blank = blank;
        self.lap.progress = Progress::Defining(Box::new(definition));
        let mut along = found == Code::Along;
        while self.lap.definition().is_some_and(|definition| !definition.ended) {
            if !self.read_contour_block(&mut slot, sink)? {
                continue;
            }
            if let Some(begins) = self.record_block(&slot, sink)? {
                along = begins == Code::Along;
                self.copy_state(&kept);
            }
        }
        self.compensation = Compensation::default();
        let common = self.state.common.clone();
        self.state = State { common, ..*kept };
        self.lap.observes = false;
        (self.place, self.inch_block) = (place, inch);
        match std::mem::take(&mut self.lap.progress) {
            Progress::Defining(definition) => {
                self.reader.seek(definition.back);
                Ok(Reading { along, blank, definition })
            }
            _ => Err(malformed(LAP_01, const { Label::new("end") })),
        }
    }

    /// Makes the copy of the state anew on which a definition is read: the variables stay, nothing is tested or cut
    /// back.
    fn copy_state(&mut self, kept: &State) {
        let common = self.state.common.clone();
        self.state = State {
            common,
            base: None,
            angle_target: None,
            positive_limits: [None; 4],
            negative_limits: [None; 4],
            watch: Watch::default(),
            ..kept.clone()
        };
        self.compensation = Compensation::default();
    }

    /// Carries out a block on the copy of the state. The code with which the contour begins, if it ends a blank.
    fn record_block(&mut self, slot: &Slot, sink: &mut impl Sink) -> Result<Option<Code>, Fault> {
        let Slot { parsed, words, .. } = slot;
        let before = Before {
            motion: self.state.motion,
            after_angle: self.state.angle_target.is_some(),
            left_over: self.compensation.is_left_over(),
        };
        let plan = self.check(parsed, words, before)?;
        if let OneShot::Lap(code) = plan.one_shot {
            self.check_end_of_definition()?;
            if let Some(definition) = self.lap.definition_mut() {
                definition.begin_contour();
            }
            return Ok(Some(code));
        }
        for code in words.g_codes() {
            self.change_mode(*code, sink);
        }
        if self.lap.definition().is_some_and(Definition::cuts_thread) {
            self.take_feed(words, plan)?;
        } else {
            self.take_contour_feeds(words, plan)?;
        }
        if parsed.has_assignment {
            self.state.base = None;
        }
        self.change_compensation(plan.compensation, words);
        let mark = self.block_mark(words.has(Address::E));
        if let Some(definition) = self.lap.definition_mut() {
            definition.marks.enter(mark);
        }
        if Self::makes_motion(plan) {
            self.admit_motion(plan)?;
        }
        self.move_axes(slot, plan, sink)?;
        if plan.compensation != Change::None {
            self.complete_change(sink)?;
        }
        if self.compensation.acts() && !parsed.is_only_name() {
            self.finish_block(sink)?;
        }
        if words.has_g(80) {
            self.check_end_of_definition()?;
            if let Some(definition) = self.lap.definition_mut() {
                definition.ended = true;
            }
        }
        Ok(None)
    }

    /// The mark of a block, with an E word of its own or not.
    fn block_mark(&self, has_feed: bool) -> BlockMark {
        let compensated = self.state.compensation != 40;
        match self.lap.definition() {
            Some(definition) if definition.cuts_thread() => BlockMark { feed: self.state.feed, compensated },
            Some(definition) if !has_feed => BlockMark { feed: definition.marks.present().feed, compensated },
            _ => BlockMark { feed: self.lap.feed, compensated },
        }
    }
}
