//! The texts of a run: the main text and the files of the library, and which of them an event comes from.

use std::cell::Cell;
use std::collections::BTreeMap;

use turnspec_oracle::syntax::{self, Heading};
use turnspec_oracle::vocabulary::{Action, Event, Label, Place, ProgramText, Setup, TapeCode};

use super::input::Program;

/// The texts of a run.
pub struct Sources<'a> {
    main: Source<'a>,
    /// The file of the library that has a program, by the program's name; those of the main text are left out.
    library: BTreeMap<Label, Source<'a>>,
    /// The files of the library.
    files: &'a BTreeMap<String, ProgramText>,
    /// The file of the program that a schedule program is running, with its device.
    selected: Cell<Option<Label>>,
    code: TapeCode,
}

/// A text with its name.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// The path as given, `standard input`, or the name of a file of the library.
    pub name: &'a str,
    /// The text.
    pub text: &'a [u8],
}

impl<'a> Sources<'a> {
    /// The texts that a program runs with.
    pub fn new(program: &'a Program, setup: &'a Setup) -> Self {
        let main = Source { name: &program.name, text: &program.text };
        let mut library = BTreeMap::new();
        for (name, text) in &setup.library {
            let source = Source { name, text: &text.0 };
            library.extend(programs(source.text, setup).into_iter().map(|program| (program, source)));
        }
        if !library.is_empty() {
            for name in programs(main.text, setup) {
                library.remove(&name);
            }
        }
        Self { main, library, files: &setup.library, selected: Cell::new(None), code: setup.tape.code }
    }

    /// How the texts are coded.
    pub fn code(&self) -> TapeCode {
        self.code
    }

    /// Takes note of an event, when all has been said about it: behind `select` blocks stand in another file.
    pub fn follow(&self, event: &Event) {
        match event.action {
            Action::Select { file, .. } => self.selected.set(Some(file)),
            Action::End { .. } => self.selected.set(None),
            _ => {}
        }
    }

    /// The text of the file that was selected.
    fn selected(&self) -> Option<Source<'a>> {
        let file = self.selected.get()?;
        let name = file.as_str().rsplit_once(':').map_or(file.as_str(), |(_, name)| name);
        self.files.get_key_value(name).map(|(name, text)| Source { name, text: &text.0 })
    }

    /// The text that a block stands in: the main text or that of a selected program, unless a file of the library has
    /// the program of the block and the main text has not.
    pub fn of(&self, block: &Place) -> Source<'a> {
        self.library.get(&block.program).copied().or_else(|| self.selected()).unwrap_or(self.main)
    }
}

/// The names of the programs of a text, with `O`, as the reference reads them.
fn programs(text: &[u8], setup: &Setup) -> Vec<Label> {
    let mut lines = syntax::Source::new(text, setup.tape.code);
    let mut names = Vec::new();
    loop {
        match lines.next_line() {
            Ok(Some(line)) => {
                if let Heading::Program(name) = syntax::heading(&line, setup) {
                    names.extend(name);
                }
            }
            Ok(None) => return names,
            // A faulty header; what follows is read all the same.
            Err(_) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{Label, Setup};

    use super::programs;

    #[test]
    fn a_name_block_begins_with_its_name() {
        for (text, expected) in [
            ("O10", Some("O10")),
            (" (A)(B) :10 (C)", Some("O10")),
            ("N1 O10", None),
            ("", None),
            ("$A.SUB%\nO7\nRTS", Some("O7")),
        ] {
            let names = programs(text.as_bytes(), &Setup::default());
            assert_eq!(names.first().map(Label::as_str), expected, "{text}");
        }
    }
}
