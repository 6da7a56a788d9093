//! The blocks of a schedule program (E100L-SDF-02 to E100L-SDF-04, E100L-SDF-15 to E100L-SDF-20).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::expression::{has_one_letter, is_reserved};
use crate::engine::fault::Fault;
use crate::engine::items::is_extended;
use crate::engine::parse::{KEYWORDS, Parser};
use crate::engine::task::{Control, LocalName};
use crate::engine::words::Code;

/// The parts of a PSELECT block; files are written in full.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Selecting {
    pub file: Code,
    pub program: Option<Label>,
    pub subprograms: Option<Code>,
    pub repetitions: Option<Code>,
}

impl Parser<'_> {
    /// Parses a block of a schedule program.
    /// Its statement stands at the beginning or directly behind the sequence name (E100L-SDF-03).
    pub fn schedule_block(&mut self) -> Result<(), Fault> {
        self.skip_blanks()?;
        if self.peek() == Some(b'/') {
            self.at += 1;
            self.skip_blanks()?;
            return if self.peek().is_none() { Ok(()) } else { Err(misplaced(SDF_04)) };
        }
        if self.peek() == Some(b'N') && self.run(self.at) != b"NOEX" {
            self.block.sequence = self.sequence_label(true)?;
            self.skip_blanks()?;
        } else if self.peek().is_none() {
            return Ok(());
        }
        if self.peek() == Some(b'/') {
            return Err(misplaced(SDF_04));
        }
        self.block.control = Some(self.schedule_statement()?);
        Ok(())
    }

    fn schedule_statement(&mut self) -> Result<Control, Fault> {
        let run = self.run(self.at);
        let keyword = Label::from_bytes(run);
        match run {
            b"GOTO" => {
                self.pass_keyword(keyword)?;
                Ok(Control::Goto(self.target(GOTO_01)?))
            }
            // IF as in a main program, in every form (E100L-SDF-16).
            b"IF" => {
                self.at += run.len();
                self.branch()
            }
            b"PSELECT" => {
                self.pass_keyword(keyword)?;
                Ok(Control::Select(self.selecting()?))
            }
            b"VSET" => {
                self.pass_keyword(keyword)?;
                self.set()
            }
            b"END" => {
                self.at += run.len();
                self.nothing_more(SDF_20)?;
                Ok(Control::End)
            }
            _ => match [b"GOTO".as_slice(), b"IF"].iter().find(|keyword| run.starts_with(keyword)) {
                Some(keyword) if run.len() > 4 => {
                    let keyword = Label::from_bytes(keyword);
                    Err(Fault::about(AlarmName::StatementDelimiterMissing, CTL_03, keyword))
                }
                // A program name among others: a schedule program must not have one (E100L-NAME-06).
                _ => Err(misplaced(SDF_02)),
            },
        }
    }

    /// What follows VSET (E100L-SDF-17).
    fn set(&mut self) -> Result<Control, Fault> {
        self.options.setting = true;
        self.each_item(|parser, letter| {
            parser.check_left_side()?;
            parser.item(letter)
        })?;
        if self.block.items.is_empty() {
            return Fault::raise(AlarmName::Format, SDF_17);
        }
        Ok(Control::Set)
    }

    /// Refuses what VSET cannot set (E100L-SDF-18). What cannot stand in any block is left to the item.
    fn check_left_side(&self) -> Result<(), Fault> {
        let run = self.run(self.at);
        let refused = match run.first() {
            Some(b'V') => run == b"VDIN",
            _ if run == b"CALRG" => return Fault::raise(AlarmName::Format, SDF_17),
            Some(b'J' | b'N' | b'O' | b'R' | b'Y') if has_one_letter(run) => false,
            _ if has_one_letter(run) || is_extended(run) => true,
            Some(b'N' | b'O') => false,
            _ if KEYWORDS.contains(&run) || is_reserved(run) => false,
            _ => LocalName::of(run).map(|_| true)?,
        };
        if refused { Fault::raise(AlarmName::ScheduleLeftSide, SDF_18) } else { Ok(()) }
    }
}

#[cold]
fn misplaced(rule: RuleId) -> Fault {
    Fault::new(AlarmName::ScheduleBlock, rule)
}
