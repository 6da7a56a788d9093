//! The programs of the main text and of the library, by name (E100L-CALL-03, E100L-NAME-05).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, Setup};

use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::text::{Mark, Reader};

use super::head::Head;

/// A place in [`Programs`].
pub type ProgramId = usize;

/// A program that can be called.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    pub name: Label,
    /// Number of its text: 0 is the main text.
    pub text: usize,
    /// Its name block.
    pub start: Mark,
    /// Offset of the next name block, or of the end of the text.
    pub end: usize,
}

/// Every program with a name.
#[derive(Debug)]
pub struct Programs<'a> {
    texts: Vec<&'a [u8]>,
    /// In the order of their names.
    programs: Vec<Program>,
}

impl<'a> Programs<'a> {
    /// The programs of the main text and of the library of a set-up.
    pub fn new(main: &'a [u8], setup: &'a Setup) -> Self {
        let library = setup.library.values().map(|text| text.0.as_slice());
        let texts: Vec<&[u8]> = std::iter::once(main).chain(library).collect();
        let mut programs = Vec::new();
        for (number, text) in texts.iter().enumerate().skip(usize::from(planted::is(Bug::MainTextPassed))) {
            collect(number, Reader::new(text, setup.tape.code), setup.switches.block_delete, &mut programs);
        }
        programs.sort_by_key(|program| program.name);
        Self { texts, programs }
    }

    /// The one program with a name.
    pub fn find(&self, name: Label) -> Result<ProgramId, Fault> {
        let first = self.programs.partition_point(|program| program.name < name);
        let has_name = |place: usize| self.programs.get(place).is_some_and(|program| program.name == name);
        match (has_name(first), has_name(first + 1)) {
            (true, false) => Ok(first),
            (true, true) if planted::is(Bug::FirstOfEqualPrograms) => Ok(first),
            (true, true) => Err(Fault::about(AlarmName::ProgramDuplicate, NAME_05, name)),
            (false, _) => Err(Fault::about(AlarmName::ProgramUnknown, CALL_03, name)),
        }
    }

    /// A program by its place.
    pub fn get(&self, program: ProgramId) -> Option<Program> {
        self.programs.get(program).copied()
    }

    /// A text by its number.
    pub fn text(&self, number: usize) -> &'a [u8] {
        self.texts.get(number).copied().unwrap_or_default()
    }
}

/// Appends the programs of a text.
fn collect(text: usize, mut reader: Reader, block_delete: bool, programs: &mut Vec<Program>) {
    let mut begun: Option<(Label, Mark)> = None;
    let mut end_program = |begun: Option<(Label, Mark)>, end: usize| {
        if let Some((name, start)) = begun {
            programs.push(Program { name, text, start, end });
        }
    };
    while let Some(lines) = reader.next_lines() {
        if reader.is_no_block(lines) {
            continue;
        }
        if let Head::Program(name) = Head::of(reader.lenient(lines), block_delete) {
            let start = Mark { at: lines.start, line: lines.line, closed: false };
            end_program(std::mem::replace(&mut begun, name.map(|name| (name, start))), lines.start);
        }
    }
    end_program(begun, reader.length());
}
