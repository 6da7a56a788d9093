//! The texts of a run: the main text and the files of the library, and which of them an event comes from.

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::{Place, Setup, TapeCode};

use super::excerpt::lines;
use super::input::Program;

/// The texts of a run.
pub struct Sources<'a> {
    main: Source<'a>,
    /// The file of the library that has a program, by the program's name; those of the main text are left out.
    library: BTreeMap<String, Source<'a>>,
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
        let (main, code) = (Source { name: &program.name, text: &program.text }, setup.tape.code);
        let mut library = BTreeMap::new();
        for (name, text) in &setup.library {
            let source = Source { name, text: &text.0 };
            library.extend(programs(source.text, code).map(|program| (program, source)));
        }
        if !library.is_empty() {
            for name in programs(main.text, code) {
                library.remove(&name);
            }
        }
        Self { main, library, code }
    }

    /// How the texts are coded.
    pub fn code(&self) -> TapeCode {
        self.code
    }

    /// The text that a block stands in: the main text, unless a file of the library has the program of the block and
    /// the main text has not.
    pub fn of(&self, block: &Place) -> Source<'a> {
        self.library.get(block.program.as_str()).copied().unwrap_or(self.main)
    }
}

/// The names of the programs of a text, with `O`.
fn programs(text: &[u8], code: TapeCode) -> impl Iterator<Item = String> {
    lines(text, code).filter_map(|line| name(&line))
}

/// The program name with which a line begins, with `O`.
fn name(line: &str) -> Option<String> {
    let mut rest = line.trim_start();
    while let Some((_, behind)) = rest.strip_prefix('(').and_then(|comment| comment.split_once(')')) {
        rest = behind.trim_start();
    }
    let run = rest.strip_prefix(['O', ':'])?;
    let end = run.find(|each: char| !each.is_ascii_alphanumeric()).unwrap_or(run.len());
    Some(format!("O{}", run.get(..end)?))
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn a_name_block_begins_with_its_name() {
        for (line, expected) in
            [("O10", Some("O10")), (" (A)(B) :10 (C)", Some("O10")), ("N1 O10", None), ("", None)]
        {
            assert_eq!(name(line).as_deref(), expected, "{line}");
        }
    }
}
