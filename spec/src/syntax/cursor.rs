//! A place in the text of a block, and what stands there.

use std::ops::Range;

use super::source::{Character, is_ignored};
use crate::fault::{Fault, Outcome};
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// Reads the characters of a block one after the other.
pub struct Cursor<'a> {
    characters: &'a [Character],
    index: usize,
    end: u32,
}

impl<'a> Cursor<'a> {
    /// At the first character of a block that ends at `end`.
    pub fn new(characters: &'a [Character], end: u32) -> Self {
        Self { characters, index: 0, end }
    }

    /// The character here.
    pub fn peek(&self) -> Option<u8> {
        self.look(0)
    }

    /// The character `ahead` places further.
    pub fn look(&self, ahead: usize) -> Option<u8> {
        self.characters.get(self.index + ahead).map(|character| character.code)
    }

    /// The character before this one.
    pub fn before(&self) -> Option<u8> {
        self.index.checked_sub(1).and_then(|index| self.characters.get(index)).map(|character| character.code)
    }

    /// Whether the character here is the mark of a continuation.
    pub fn at_continuation(&self) -> bool {
        self.characters.get(self.index).is_some_and(|character| character.continues)
    }

    /// Goes on by a number of characters.
    pub fn advance(&mut self, count: usize) {
        self.index += count;
    }

    /// Takes the character here if it is this one.
    pub fn take(&mut self, code: u8) -> bool {
        let here = self.peek() == Some(code);
        if here {
            self.advance(1);
        }
        here
    }

    /// The place, to come back to with [`Cursor::rewind`].
    pub fn mark(&self) -> usize {
        self.index
    }

    /// Goes back to a mark.
    pub fn rewind(&mut self, mark: usize) {
        self.index = mark;
    }

    /// Byte offset of this place.
    pub fn offset(&self) -> u32 {
        self.characters.get(self.index).map_or(self.end, |character| character.offset)
    }

    /// Byte span of the characters taken since a mark.
    pub fn span_from(&self, mark: usize) -> Range<u32> {
        let start = self.characters.get(mark).map_or(self.end, |character| character.offset);
        let last = self.index.checked_sub(1).and_then(|index| self.characters.get(index));
        start..last.map_or(start, |character| character.offset + 1).max(start)
    }

    /// The longest run of letters and digits from here, not taken.
    pub fn run(&self) -> String {
        let rest = self.characters.get(self.index..).unwrap_or_default();
        let run = rest.iter().take_while(|character| is_alphanumeric(character.code));
        run.map(|character| char::from(character.code)).collect()
    }

    /// Skips ignored characters (E100L-FMT-07).
    pub fn skip_ignored(&mut self) {
        while self.peek().is_some_and(is_ignored) {
            self.advance(1);
        }
    }

    /// Skips ignored characters and tabs.
    pub fn skip_plain_blanks(&mut self) {
        while self.peek().is_some_and(|code| is_ignored(code) || code == b'\t') {
            self.advance(1);
        }
    }

    /// Skips ignored characters, tabs and comments (E100L-CMT-01).
    ///
    /// # Errors
    /// A comment that does not end in its block.
    pub fn skip_blanks(&mut self) -> Outcome<()> {
        loop {
            self.skip_plain_blanks();
            if self.peek() != Some(b'(') {
                return Ok(());
            }
            self.skip_comment()?;
        }
    }

    fn skip_comment(&mut self) -> Outcome<()> {
        let start = self.mark();
        while let Some(code) = self.peek() {
            self.advance(1);
            if code == b')' {
                return Ok(());
            }
        }
        Err(Fault::new(AlarmName::CommentUnclosed, CMT_01).at(self.span_from(start)))
    }

    /// The fault of a character that may not stand here, ignored ones aside: one without any function is illegal,
    /// another makes the format wrong.
    pub fn unexpected(&self) -> Fault {
        let fault = match self.peek() {
            Some(b')') => Fault::new(AlarmName::IllegalCharacter, CMT_01),
            None
            | Some(
                b'A'..=b'Z'
                | b'0'..=b'9'
                | b'+'
                | b'-'
                | b'*'
                | b'/'
                | b'='
                | b'['
                | b']'
                | b'.'
                | b','
                | b':'
                | b'\t'
                | b'(',
            ) => Fault::new(AlarmName::Format, FMT_01),
            Some(_) => Fault::new(AlarmName::IllegalCharacter, FMT_08),
        };
        fault.at(self.offset()..self.offset() + 1)
    }
}

/// Upper-case letters and digits: the characters of names.
pub fn is_alphanumeric(code: u8) -> bool {
    code.is_ascii_uppercase() || code.is_ascii_digit()
}

/// Whether a character in front separates a word from what stands there: a blank, or the end of a comment.
pub fn is_blank_before(code: Option<u8>) -> bool {
    code.is_some_and(|code| is_ignored(code) || matches!(code, b'\t' | b')'))
}

/// Whether a character behind separates a word from what follows: a blank, a comment, or the end of the block.
pub fn is_blank_after(code: Option<u8>) -> bool {
    code.is_none_or(|code| is_ignored(code) || matches!(code, b'\t' | b'('))
}
