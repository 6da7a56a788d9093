//! The two side programs of a text: which lines belong to which saddle (E100L-AX4-02, E100L-AX4-03).

use turnspec_oracle::vocabulary::Side;

use crate::engine::number::Number;
use crate::engine::parse::{Options, Parser};
use crate::engine::text::{Kind, Lines, Mark, Reader};
use crate::engine::words::{Address, Item, Parsed, Source};

use super::side_of;

/// Lines that belong together: where they begin, and the offset behind them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Section {
    pub start: Mark,
    pub end: usize,
}

/// The text cut at its selection blocks.
#[derive(Debug, Default)]
pub struct Sections {
    /// What stands before the first selection block.
    pub head: Option<Section>,
    /// The sections of A and of B.
    pub sides: [Vec<Section>; 2],
    /// The line behind the last one.
    pub last_line: u32,
}

impl Sections {
    /// Reads the whole text; faults of its blocks are nothing yet.
    pub fn of(mut reader: Reader, options: Options) -> Self {
        let mut sections = Self::default();
        let (mut parsed, mut buffer) = (Parsed::default(), Vec::new());
        let (mut side, mut start) = (None, reader.mark());
        while let Some(lines) = reader.next_lines() {
            if let Some(next) = selects(&reader, lines, options, &mut parsed, &mut buffer) {
                sections.add(side, Section { start, end: lines.start });
                (side, start) = (Some(next), reader.mark());
            }
        }
        sections.last_line = reader.last_line();
        sections.add(side, Section { start, end: usize::MAX });
        sections
    }

    fn add(&mut self, side: Option<Side>, section: Section) {
        match side {
            None => self.head = Some(section),
            Some(side) => self.sides[usize::from(side == Side::B)].push(section),
        }
    }
}

/// The side that a block selects, if it does nothing else.
fn selects(
    reader: &Reader,
    lines: Lines,
    options: Options,
    parsed: &mut Parsed,
    buffer: &mut Vec<u8>,
) -> Option<Side> {
    if reader.kind(lines) != Ok(Kind::Block) || lines.stray {
        return None;
    }
    let text = reader.characters(lines, buffer).ok()?;
    parsed.clear();
    Parser { text, at: 0, options, block: parsed }.parse().ok()?;
    if parsed.skipped || parsed.noex || parsed.control.is_some() || parsed.program.is_some() {
        return None;
    }
    match parsed.items.as_slice() {
        [
            Item::Word(Address::G, Source::Plain(Number::Decimal { digits: code @ (13 | 14), scale: 0, .. })),
        ] => Some(side_of(if *code == 14 { 14 } else { 13 })),
        _ => None,
    }
}
