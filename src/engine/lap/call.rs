//! Step 2 and step 7 of the blocks of LAP (execution of LAP, 1, 5 and 6): feeds, and what a call begins with.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, Sink};

use crate::engine::Interpreter;
use crate::engine::block::{Before, OneShot, Plan};
use crate::engine::compensation::Change;
use crate::engine::fault::Fault;
use crate::engine::number::Number;
use crate::engine::slot::Slot;
use crate::engine::state::StoredFeed;
use crate::engine::task::Turn;
use crate::engine::words::{Address, Words};

use super::definition::{Definition, Purpose};
use super::{Code, malformed};

impl Interpreter<'_> {
    /// Step 2 of a call and of a block of a definition: FA and FB, or E.
    #[cold]
    pub(in crate::engine) fn take_contour_feeds(&mut self, words: &Words, plan: Plan) -> Result<(), Fault> {
        let [feed, first, second] = words.contour_feeds;
        if matches!(plan.one_shot, OneShot::Lap(_)) {
            for (address, number) in [(Address::FA, first), (Address::FB, second)] {
                if words.has(address) {
                    self.stored(number)?;
                }
            }
        } else if words.has(Address::E) && !self.lap.definition().is_some_and(Definition::cuts_thread) {
            let feed = self.stored(feed)?;
            self.lap.feed = Some(feed);
        }
        Ok(())
    }

    /// A feed in both of its readings; the one in force is tested.
    pub(super) fn stored(&self, number: Number) -> Result<StoredFeed, Fault> {
        let given = self.state.feed_unit();
        let unit = self.units.feed[usize::from(!self.state.per_minute)];
        let [least, most] = self.units.feeds;
        if !number.within(unit, least, most) {
            return Fault::raise(AlarmName::AddressRange, ADDR_01);
        }
        Ok(StoredFeed { values: self.units.feed.map(|unit| number.rounded(unit, 1)), given })
    }

    /// Step 7 of a block that begins a definition or calls one.
    #[cold]
    pub(in crate::engine) fn carry_out_lap(
        &mut self,
        slot: &Slot,
        code: Code,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        match code {
            Code::Along | Code::Across | Code::Blank => {
                self.begin_to_pass_over();
                Ok(())
            }
            Code::Finish => self.begin_to_finish(slot, sink),
            Code::Turn | Code::Copy | Code::Thread => {
                self.state.base = None;
                let kept_feed = self.lap.feed;
                let reading = self.read_definition(slot, code, sink)?;
                let job = self.job(&slot.words, code, &reading, kept_feed)?;
                match (code, &job.blank) {
                    (Code::Turn, _) => self.turn_bar(&job, sink),
                    (Code::Copy, Some(blank)) => self.copy_bar(&job, blank, sink),
                    (Code::Copy, None) => self.copy_contour(&job, sink),
                    _ => self.cut_legs(&job, &slot.words, &reading.definition.contour_motions, sink),
                }
            }
        }
    }

    /// Goes to the block with the contour name, which is carried out as far as it is looked at; the code that it has.
    pub(super) fn begin_definition(
        &mut self,
        contour: Label,
        slot: &mut Slot,
        sink: &mut impl Sink,
    ) -> Result<Code, Fault> {
        let call = self.place;
        if let Some(mark) = self.block_named(contour) {
            self.go_to(mark);
        }
        let found = self.read(slot, Turn::Named);
        self.place = slot.place;
        let mut code = None;
        if found?
            && !slot.parsed.skipped
            && slot.parsed.control.is_none()
            && !self.is_turret_block(&slot.parsed)
        {
            self.inch_block = slot.parsed.has_length && self.units.inch;
            self.evaluate(slot, sink)?;
            let before = Before { motion: self.state.motion, after_angle: false, left_over: false };
            let plan = self.check(&slot.parsed, &slot.words, before)?;
            code = match plan.one_shot {
                OneShot::Lap(code @ (Code::Along | Code::Across | Code::Blank)) => Some(code),
                _ => None,
            };
        }
        self.place = call;
        code.ok_or_else(|| malformed(LAP_09, const { Label::new("start") }))
    }

    /// What the run was in when the call came to its step 7, to go on behind it.
    pub(super) fn definition(&self, purpose: Purpose, code: Code) -> Definition {
        let from = (self.place, self.reader.mark(), self.task.depth());
        Definition::new(purpose, code == Code::Blank, from)
    }

    /// The next block of a definition that is read or carried out.
    pub(super) fn read_contour_block(
        &mut self,
        slot: &mut Slot,
        sink: &mut impl Sink,
    ) -> Result<bool, Fault> {
        if self.compensation.acts() {
            self.compensation.begin_block();
        }
        if self.ahead_count > 0 {
            std::mem::swap(slot, &mut *self.ahead[0]);
            self.ahead.swap(0, 1);
            self.ahead_count -= 1;
            self.place = slot.place;
            self.note_block(slot);
            self.count_passed(slot)?;
            if !self.lap.reads() {
                self.check_common(&slot.words)?;
            }
            self.inch_block = slot.parsed.has_length && self.units.inch;
            return Ok(true);
        }
        let found = self.read(slot, Turn::Within);
        self.place = slot.place;
        if !found? {
            return Err(self.definition_unended());
        }
        self.note_block(slot);
        self.admit_parsed(&slot.parsed)?;
        if let Some(control) = slot.parsed.control {
            self.carry_out_statement(&slot.parsed, control, sink)?;
            return Ok(false);
        }
        self.inch_block = slot.parsed.has_length && self.units.inch;
        self.evaluate(slot, sink)?;
        self.admit_words(&slot.parsed, &slot.words)?;
        Ok(true)
    }

    /// The program ends in a definition.
    #[cold]
    fn definition_unended(&mut self) -> Fault {
        match self.lap.definition() {
            Some(definition) if self.task.depth() <= definition.depth => {
                self.place = definition.call;
                malformed(LAP_01, const { Label::new("end") })
            }
            _ => self.end_missing(),
        }
    }

    /// The tests behind the last block of a contour, or of a blank, at its place.
    pub(super) fn check_end_of_definition(&self) -> Result<(), Fault> {
        let Some(definition) = self.lap.definition() else { return Ok(()) };
        if self.state.compensation != 40 {
            return Err(malformed(LAP_16, const { Label::new("G40") }));
        }
        if !definition.blank && self.task.depth() > definition.depth {
            return Err(malformed(LAP_01, const { Label::new("G80") }));
        }
        let (least, rule) = if definition.blank { (1, LAP_02) } else { (2, LAP_01) };
        if definition.count < least {
            return Err(malformed(rule, const { Label::new("empty") }));
        }
        if definition.cuts_thread() && !definition.has_leg {
            return Err(malformed(AP3_01, const { Label::new("thread") }));
        }
        Ok(())
    }

    /// Whether a block of a definition makes a motion of its own, or begins compensation with one.
    pub(in crate::engine) fn makes_motion(plan: Plan) -> bool {
        plan.moves || plan.compensation == Change::Begins
    }
}
