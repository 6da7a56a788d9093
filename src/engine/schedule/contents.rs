//! What a program that may be run contains, found by reading it without running it (E100L-SDF-09,
//! E100L-SDF-12).

use turnspec_oracle::vocabulary::Label;

use crate::engine::parse::{Options, Parser};
use crate::engine::task::{Control, whole};
use crate::engine::text::{Lines, Reader};
use crate::engine::words::{Address, Item, Parsed, Source};

/// What the blocks of a program that are read without fault have among them.
#[derive(Debug, Default)]
pub struct Contents {
    /// Whether one has M02 or M30.
    pub ends: bool,
    /// Whether one is an RTS statement.
    pub returns: bool,
    /// The names in CALL and MODIN statements, in the order of the text.
    pub called: Vec<Label>,
}

impl Contents {
    /// The contents of a program from where a reader stands up to an offset.
    pub fn new(mut reader: Reader, end: usize, options: Options) -> Self {
        let mut contents = Self::default();
        let (mut parsed, mut buffer) = (Parsed::default(), Vec::new());
        while let Some(lines) = reader.next_lines().filter(|lines| lines.start < end) {
            if !reader.is_no_block(lines) && read(&reader, lines, options, &mut parsed, &mut buffer) {
                contents.add(&parsed);
            }
        }
        contents
    }

    fn add(&mut self, parsed: &Parsed) {
        self.ends |= parsed.has(is_end);
        match parsed.control {
            Some(Control::Call(name) | Control::BeginMode(name)) => self.called.push(name),
            Some(Control::Return) => self.returns = true,
            _ => {}
        }
    }
}

/// M02 and M30 as plain numbers.
fn is_end(item: &Item) -> bool {
    match item {
        Item::Word(Address::M, Source::Plain(number)) => matches!(whole(*number), Some(2 | 30)),
        _ => false,
    }
}

/// Reads a block; whether it has no fault. A slash before it does not matter.
fn read(reader: &Reader, lines: Lines, options: Options, parsed: &mut Parsed, buffer: &mut Vec<u8>) -> bool {
    parsed.clear();
    let options = Options { block_delete: false, ..options };
    let text = reader.characters(lines, buffer);
    let Some(text) = text.ok().filter(|_| !lines.stray) else { return false };
    Parser { text, at: 0, options, block: parsed }.parse().is_ok()
}

/// Whether nothing but blanks, comments and a slash stands in a block.
pub fn is_empty(reader: &Reader, lines: Lines, options: Options) -> bool {
    let mut parsed = Parsed::default();
    read(reader, lines, options, &mut parsed, &mut Vec::new())
        && parsed.is_empty()
        && parsed.program.is_none()
}
