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

/// The files in which a selected program finds its subprograms, besides those of the control itself
/// (E100L-SDF-10); by the numbers of their texts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Scope {
    pub main: usize,
    pub subprograms: Option<usize>,
}

/// Every program with a name.
#[derive(Debug)]
pub struct Programs<'a> {
    texts: Vec<&'a [u8]>,
    /// Which of the texts are files of system or manufacturer.
    own: Vec<bool>,
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
        let is_own = |file: &String| file.ends_with(".SSB") || file.ends_with(".MSB");
        let own = std::iter::once(false).chain(setup.library.keys().map(is_own)).collect();
        Self { texts, own, programs }
    }

    /// The one program with a name, of all texts or of those in which it is looked for.
    pub fn find(&self, name: Label, scope: Option<Scope>) -> Result<ProgramId, Fault> {
        let is_in = |text: usize, scope: Scope| {
            text == scope.main
                || Some(text) == scope.subprograms
                || self.own.get(text).copied().unwrap_or_default()
        };
        let mut found =
            self.named(name).filter(|(_, program)| scope.is_none_or(|scope| is_in(program.text, scope)));
        match (found.next(), found.next()) {
            (Some((program, _)), None) => Ok(program),
            (Some((program, _)), Some(_)) if planted::is(Bug::FirstOfEqualPrograms) => Ok(program),
            (Some(_), Some(_)) => Err(Fault::about(AlarmName::ProgramDuplicate, NAME_05, name)),
            (None, _) => Err(Fault::about(AlarmName::ProgramUnknown, CALL_03, name)),
        }
    }

    /// The programs of a text with a name.
    pub fn in_file(&self, name: Label, text: usize) -> impl Iterator<Item = (ProgramId, &Program)> {
        self.named(name).filter(move |(_, program)| program.text == text)
    }

    /// The programs with a name, which is compared as text (E100L-NAME-04).
    fn named(&self, name: Label) -> impl Iterator<Item = (ProgramId, &Program)> {
        let first = self.programs.partition_point(|program| program.name < name);
        let rest = self.programs.iter().enumerate().skip(first);
        rest.take_while(move |(_, program)| program.name == name)
    }

    /// How many programs there are.
    pub fn count(&self) -> usize {
        self.programs.len()
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
/// Each reaches from its name block to the next one or the end of the text (E100L-PROG-03, E100L-CALL-06). What
/// stands in front of the first one, or behind a name that is not well formed, belongs to none (E100L-NAME-06).
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
