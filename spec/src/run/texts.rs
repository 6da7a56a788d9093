//! The texts of a run: the main text and those of the library (E100L-CALL-03, E100L-CALL-06), cut into blocks.

use super::portions::{Portion, Way};
use crate::fault::Outcome;
use crate::syntax::{Line, Source};
use crate::vocabulary::{Place, Setup, TapeCode};

/// Where a block begins.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Spot {
    /// The text; the main text is 0.
    pub text: usize,
    /// Byte.
    position: usize,
    /// Line.
    line: u32,
}

/// The texts.
pub struct Texts<'a> {
    main: &'a [u8],
    library: Vec<(&'a str, &'a [u8])>,
    code: TapeCode,
    /// What is read of the main text, if it is not the whole.
    portion: Option<Portion>,
}

impl<'a> Texts<'a> {
    /// The main text and the library of a set-up.
    pub fn new(main: &'a [u8], setup: &'a Setup) -> Self {
        let library = setup.library.iter().map(|(file, text)| (file.as_str(), text.0.as_slice())).collect();
        Self { main, library, code: setup.tape.code, portion: None }
    }

    /// The same, but of the main text only a portion (E100L-AX4-03).
    pub fn of_portion(&self, portion: Portion) -> Self {
        Self { main: self.main, library: self.library.clone(), code: self.code, portion: Some(portion) }
    }

    /// The file name of a text; the main text has none here.
    pub fn file(&self, text: usize) -> Option<&'a str> {
        let index = text.checked_sub(1)?;
        self.library.get(index).map(|(file, _)| *file)
    }

    /// E100L-SDF-07: the text with a file name.
    pub fn of_file(&self, file: &str) -> Option<usize> {
        self.library.iter().position(|(name, _)| *name == file).map(|index| index + 1)
    }

    /// E100L-SDF-10: the texts of system and manufacturer subprograms.
    pub fn of_system(&self) -> impl Iterator<Item = usize> {
        let files = self.library.iter().zip(1..);
        files.filter(|((file, _), _)| file.ends_with(".SSB") || file.ends_with(".MSB")).map(|(_, text)| text)
    }

    /// E100L-SDF-01: whether the main text is a schedule program.
    pub fn is_schedule(&self, setup: &Setup) -> bool {
        Source::new(self.main, self.code).header_of_schedule().unwrap_or(setup.schedule)
    }

    /// The beginning of the main text, its file header included.
    pub fn main_start(&self) -> Spot {
        Spot { text: 0, position: 0, line: 1 }
    }

    /// The beginning of each text, its file header passed over.
    pub fn starts(&self) -> impl Iterator<Item = Spot> {
        (0..=self.library.len()).map(|text| self.start(text))
    }

    /// The beginning of a text, its file header passed over.
    pub fn start(&self, text: usize) -> Spot {
        let mut source = Source::new(self.bytes(text), self.code);
        source.skip_header();
        spot(text, &source)
    }

    /// The block that begins at a place, or the next one of the portion; none at the end of the text.
    pub fn read(&self, mut at: Spot) -> Outcome<Option<Read>> {
        while let Some(read) = self.next(at)? {
            match self.portion.as_ref().map_or(Way::Here, |portion| portion.way(read.start)) {
                Way::Here => return Ok(Some(read)),
                Way::To(next) => at = next,
                Way::Nowhere => return Ok(None),
            }
        }
        Ok(None)
    }

    /// The block that begins at a place, and the place behind it.
    fn next(&self, at: Spot) -> Outcome<Option<Read>> {
        let mut source = self.source(at);
        let Some(line) = source.next_line()? else { return Ok(None) };
        let start = Spot { text: at.text, position: line.place.start as usize, line: line.place.line };
        Ok(Some(Read { start, behind: spot(at.text, &source), line }))
    }

    /// The place behind the last block of a text, seen from behind its last block.
    pub fn end(&self, behind: Spot) -> Place {
        let mut source = self.source(behind);
        // Tape marks may follow.
        while let Ok(Some(_)) = source.next_line() {}
        source.end()
    }

    fn source(&self, at: Spot) -> Source<'a> {
        Source::at(self.bytes(at.text), self.code, (at.position, at.line))
    }

    fn bytes(&self, text: usize) -> &'a [u8] {
        match text.checked_sub(1) {
            None => self.main,
            Some(index) => self.library.get(index).map_or(&[], |(_, bytes)| *bytes),
        }
    }
}

/// A block as it stands in its text.
pub struct Read {
    /// Where it begins.
    pub start: Spot,
    /// Its text.
    pub line: Line,
    /// Where the next one begins.
    pub behind: Spot,
}

fn spot(text: usize, source: &Source) -> Spot {
    let (position, line) = source.here();
    Spot { text, position, line }
}
