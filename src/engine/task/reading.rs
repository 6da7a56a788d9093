//! Reading the next block, wherever it stands: from the text, or from the blocks that are kept (execution,
//! chapter 2, and chapter 9, "Programs and where they end" and "Steps of a run").

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, Place};

use crate::engine::Interpreter;
use crate::engine::arithmetic::span::offset;
use crate::engine::fault::Fault;
use crate::engine::parse::Parser;
use crate::engine::planted::{self, Bug};
use crate::engine::slot::Slot;
use crate::engine::text::{Kind, Lines};

use super::Activity;
use super::head::{self, Head};
use super::kept::KeptBlock;

/// Whether a block is read in its turn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Turn {
    /// The run arrives at it.
    Now,
    /// It is looked at before its turn.
    Ahead,
    /// The run arrives at it in a definition of LAP, which no program name continues.
    Within,
    /// The run arrives at it by its name: no block is read behind it, though it is skipped.
    Named,
}

impl Interpreter<'_> {
    /// Reads the next block that is not skipped; false where the program ends. The place is set in any case.
    pub(in crate::engine) fn read(&mut self, slot: &mut Slot, turn: Turn) -> Result<bool, Fault> {
        if turn == Turn::Ahead {
            slot.from = self.reader.mark();
            slot.passed = 0;
        }
        let mut buffer = std::mem::take(&mut self.buffer);
        let result = self.read_with(slot, turn, &mut buffer);
        self.buffer = buffer;
        result
    }

    fn read_with(&mut self, slot: &mut Slot, turn: Turn, buffer: &mut Vec<u8>) -> Result<bool, Fault> {
        loop {
            if self.reader.at() < self.task.present.kept_until
                && let Some(idle) = self.take_kept(slot, turn)?
            {
                if idle && turn != Turn::Named {
                    continue;
                }
                return Ok(true);
            }
            let Some(lines) = self.reader.next_lines() else { break };
            slot.place = self.place_of(lines);
            match self.reader.kind(lines)? {
                Kind::Block => {}
                Kind::Other => continue,
                Kind::ScheduleHeader => {
                    self.begin_schedule();
                    continue;
                }
            }
            if self.ends_program(lines, turn) {
                return Ok(false);
            }
            if let Err(limit) = self.count_step(slot, turn)
                && !(self.begun && self.task.present.is_open() && self.names_program(lines))
            {
                return Err(limit);
            }
            let idle = self.parse(slot, lines, buffer)?;
            if lines.start < self.task.present.kept_until {
                let (text, after) = (self.task.present.text, self.reader.mark());
                let parsed = slot.parsed.keep();
                self.task.kept.keep(text, KeptBlock { lines, after, parsed, idle });
            }
            if !idle || turn == Turn::Named {
                return Ok(true);
            }
        }
        let end = offset(self.reader.length());
        slot.place =
            Place { line: self.reader.last_line(), start: end, end, ..self.place_of(Lines::default()) };
        Ok(false)
    }

    /// The place of a block of the present program, without its sequence name.
    #[inline]
    fn place_of(&self, lines: Lines) -> Place {
        Place {
            program: self.task.present.name,
            sequence: Label::default(),
            line: lines.line,
            start: offset(lines.start),
            end: offset(lines.end),
        }
    }

    /// A block that is kept, if one begins here, and whether nothing of it is carried out.
    #[inline]
    fn take_kept(&mut self, slot: &mut Slot, turn: Turn) -> Result<Option<bool>, Fault> {
        let (text, at) = (self.task.present.text, self.reader.at());
        let Some(kept) = self.task.kept.get(text, at) else { return Ok(None) };
        slot.place = self.place_of(kept.lines);
        slot.parsed.share(kept.parsed.clone());
        self.reader.seek(kept.after);
        let idle = kept.idle;
        self.count_step(slot, turn)?;
        slot.place.sequence = slot.parsed.sequence;
        if idle && let Some(name) = slot.parsed.program {
            self.task.present.name = name;
        }
        Ok(Some(idle))
    }

    /// One step more (E100L-GOTO-03), unless the run has yet to arrive here.
    #[inline]
    fn count_step(&mut self, slot: &mut Slot, turn: Turn) -> Result<(), Fault> {
        if turn == Turn::Ahead {
            slot.passed += 1;
            return Ok(());
        }
        if self.task.steps.take(1) { Ok(()) } else { Fault::raise(AlarmName::StepLimit, GOTO_03) }
    }

    /// The run arrives at a block that was read before its turn, by way of those that were passed then.
    pub(in crate::engine) fn count_passed(&mut self, slot: &Slot) -> Result<(), Fault> {
        let passed = if planted::is(Bug::AheadNoStep) { 0 } else { slot.passed };
        if self.task.steps.take(passed) {
            return Ok(());
        }
        let mut reader = self.reader.clone();
        reader.seek(slot.from);
        while let Some(lines) = reader.next_lines() {
            if reader.is_no_block(lines) {
                continue;
            }
            if !self.task.steps.take(1) {
                self.place = self.place_of(lines);
                break;
            }
        }
        Fault::raise(AlarmName::StepLimit, GOTO_03)
    }

    /// Whether the program ends before these lines. A name block behind the main program is checked like
    /// other blocks when the run arrives there, but is no step.
    #[inline]
    fn ends_program(&self, lines: Lines, turn: Turn) -> bool {
        lines.start >= self.task.present.end
            || turn != Turn::Now && self.is_closed_by_names(turn) && self.names_program(lines)
    }

    /// Whether the program that runs ends at a name block before the run arrives there.
    fn is_closed_by_names(&self, turn: Turn) -> bool {
        match turn {
            Turn::Ahead => true,
            Turn::Within => self.begun && self.task.present.is_open(),
            Turn::Now | Turn::Named => false,
        }
    }

    fn names_program(&self, lines: Lines) -> bool {
        matches!(Head::of(self.reader.lenient(lines), self.options.block_delete), Head::Program(_))
    }

    /// Parses a block and takes note of its name; whether nothing of it is carried out.
    /// The name of a skipped block stays taken (E100L-DEL-04).
    #[inline]
    fn parse(&mut self, slot: &mut Slot, lines: Lines, buffer: &mut Vec<u8>) -> Result<bool, Fault> {
        let text = self.reader.characters(lines, buffer)?;
        if lines.stray {
            return Fault::raise(AlarmName::IllegalCharacter, FMT_08);
        }
        let block = slot.parsed.renew();
        let mut parser = Parser { text, at: 0, options: self.options, block };
        let schedule = self.task.present.kind == Activity::Schedule;
        let parsed = if schedule { parser.schedule_block() } else { parser.parse() };
        slot.place.sequence = slot.parsed.sequence;
        parsed?;
        if let Some(name) = slot.parsed.program {
            self.begin_named(name, lines.start)?;
            return Ok(true);
        }
        if !slot.parsed.sequence.is_empty() {
            let name = slot.parsed.sequence.as_str().as_bytes().get(1..).unwrap_or_default();
            let forgotten = planted::is(Bug::SkippedNameForgotten) && slot.parsed.skipped;
            if !name.is_empty() && !forgotten && !self.is_first_with(name, lines.start) {
                return Fault::raise(AlarmName::SequenceNameDuplicate, SEQ_03);
            }
        }
        let (empty, skipped) = (slot.parsed.is_empty(), slot.parsed.skipped);
        self.begun |= !empty || skipped;
        Ok(empty || skipped)
    }

    /// A block with a program name: the own one of the program that runs, or one behind the main program.
    fn begin_named(&mut self, name: Label, start: usize) -> Result<(), Fault> {
        if !self.task.present.is_open() {
            self.task.present.name = name;
            return Ok(());
        }
        if self.begun {
            return Fault::raise(AlarmName::ProgramNameMisplaced, PROG_02);
        }
        self.begun = true;
        self.task.present.name = name;
        self.task.own_name = Some(start);
        Ok(())
    }

    /// Where the program that runs has ended without saying so (E100L-RTS-01, E100L-PROG-02).
    pub(in crate::engine) fn end_missing(&self) -> Fault {
        match self.task.present.kind {
            Activity::Main | Activity::Selected => Fault::new(AlarmName::NoProgramEnd, PROG_02),
            Activity::Schedule => Fault::new(AlarmName::ScheduleEndMissing, SDF_20),
            Activity::Called => Fault::new(AlarmName::NoReturn, RTS_01),
        }
    }

    /// The main text is a schedule program: it ends with its first END block, if it has one.
    pub(in crate::engine) fn begin_schedule(&mut self) {
        let present = &mut self.task.present;
        present.kind = Activity::Schedule;
        let mut reader = self.reader.clone();
        while let Some(lines) = reader.next_lines() {
            if !reader.is_no_block(lines) && head::is_end(reader.lenient(lines)) {
                present.end = reader.at();
                break;
            }
        }
    }
}
