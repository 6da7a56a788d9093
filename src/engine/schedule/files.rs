//! What PSELECT finds in the files of the library (E100L-SDF-07 to E100L-SDF-12).

use std::collections::{BTreeSet, VecDeque};

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::task::{Activation, Activity, Head, Program, Scope};
use crate::engine::text::{Mark, Reader};
use crate::engine::words::Parsed;

use super::contents::{Contents, is_empty};
use super::{Selecting, Selection};

impl Interpreter<'_> {
    /// Finds what a PSELECT block selects.
    pub(super) fn find_selection(
        &mut self,
        parsed: &Parsed,
        selecting: Selecting,
    ) -> Result<Selection, Fault> {
        let file = parsed.text(selecting.file);
        let text = self.find_file(file, SDF_07)?;
        let file = Label::from_bytes(file);
        if parsed.text(selecting.file).ends_with(b".SDF") {
            return Err(Fault::about(AlarmName::Unspecified, SDF_07, const { Label::new("SDF") }));
        }
        let program = match selecting.program {
            Some(name) => self.named_program(text, name)?,
            None => {
                let first = self.first_program(text);
                first.ok_or_else(|| Fault::about(AlarmName::ProgramMissing, SDF_08, file))?
            }
        };
        let contents = self.contents(program.text, program.start, program.end);
        if !contents.ends {
            return Err(Fault::about(AlarmName::MainEndMissing, SDF_09, file));
        }
        let subprograms = selecting.subprograms.map(|file| self.find_file(parsed.text(file), SDF_10));
        let scope = Scope { main: text, subprograms: subprograms.transpose()? };
        self.check_subprograms(contents, scope)?;
        Ok(Selection { file, program, scope })
    }

    /// The number of the text of a file; all files are on MD1.
    fn find_file(&self, file: &[u8], rule: RuleId) -> Result<usize, Fault> {
        let name = file.strip_prefix(b"MD1:");
        let mut files = self.setup.library.keys();
        let place = name.and_then(|name| files.position(|file| file.as_bytes() == name));
        // The text of the schedule itself has number 0.
        let missing = || Fault::about(AlarmName::FileMissing, rule, Label::from_bytes(file));
        place.map(|place| place + 1).ok_or_else(missing)
    }

    /// The program of a file that has a name.
    fn named_program(&mut self, text: usize, name: Label) -> Result<Activation, Fault> {
        let programs = self.programs();
        let mut found = programs.in_file(name, text);
        match (found.next(), found.next()) {
            (Some((id, program)), None) => Ok(Activation::new(Activity::Selected, id + 1, program)),
            (Some(_), Some(_)) => Err(Fault::about(AlarmName::ProgramDuplicate, NAME_05, name)),
            (None, _) => Err(Fault::about(AlarmName::ProgramMissing, SDF_08, name)),
        }
    }

    /// The first program of a file; none if it has no block.
    fn first_program(&mut self, text: usize) -> Option<Activation> {
        let (options, code) = (self.options, self.setup.tape.code);
        let programs = self.programs();
        let mut reader = Reader::new(programs.text(text), code);
        let mut beginning = None;
        let (start, lines) = loop {
            let start = reader.mark();
            let lines = reader.next_lines()?;
            if reader.is_no_block(lines) {
                continue;
            }
            beginning.get_or_insert(start);
            if !is_empty(&reader, lines, options) {
                break (start, lines);
            }
        };
        let start = match Head::of(reader.lenient(lines), false) {
            Head::Program(Some(name)) => {
                let mut programs = programs.in_file(name, text);
                let (id, program) = programs.find(|(_, program)| program.start.at == start.at)?;
                let program = Program { start: beginning.unwrap_or(start), ..*program };
                return Some(Activation::new(Activity::Selected, id + 1, &program));
            }
            Head::Program(None) => beginning.unwrap_or(start),
            _ => beginning.unwrap_or(start),
        };
        let unnamed = Program { name: Label::default(), text, start, end: end_of_program(reader) };
        // Behind the labels of the programs with a name, those of one unnamed program a text.
        Some(Activation::new(Activity::Selected, programs.count() + text, &unnamed))
    }

    /// What a program contains.
    fn contents(&mut self, text: usize, start: Mark, end: usize) -> Contents {
        let (options, code) = (self.options, self.setup.tape.code);
        let mut reader = Reader::new(self.programs().text(text), code);
        reader.seek(start);
        Contents::new(reader, end, options)
    }

    /// Every subprogram that may be needed has RTS, and is there once at most (E100L-SDF-12).
    fn check_subprograms(&mut self, main: Contents, scope: Scope) -> Result<(), Fault> {
        let mut collected = BTreeSet::new();
        let mut waiting = VecDeque::from([main.called]);
        while let Some(names) = waiting.pop_front() {
            for name in names {
                if !collected.insert(name) {
                    continue;
                }
                let found = match self.programs().find(name, Some(scope)) {
                    Err(fault) if fault.name == AlarmName::ProgramUnknown => continue,
                    found => found?,
                };
                let Some(program) = self.programs().get(found) else { continue };
                let contents = self.contents(program.text, program.start, program.end);
                if !contents.returns {
                    return Err(Fault::about(AlarmName::SubprogramRtsMissing, SDF_12, name));
                }
                waiting.push_back(contents.called);
            }
        }
        Ok(())
    }
}

/// Where a program ends whose first block was read: before the next name block, or with its text.
fn end_of_program(mut reader: Reader) -> usize {
    while let Some(lines) = reader.next_lines() {
        if !reader.is_no_block(lines) && matches!(Head::of(reader.lenient(lines), false), Head::Program(_)) {
            return lines.start;
        }
    }
    reader.length()
}
