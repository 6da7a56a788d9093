//! From bytes to blocks of characters: tape codes, lines, continuation lines, the file header
//! (E100L-TAPE-01, E100L-TAPE-04, E100L-FMT-05).

use std::sync::Arc;

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, TapeCode};

use super::fault::Fault;
use super::planted::{self, Bug};
use super::sides::Section;

/// Longest block, in characters without LF and CR.
const LONGEST: usize = 158;

/// What stands in a block for the mark of a continuation line, which acts as a blank.
pub const CONTINUATION: u8 = b'\n';

/// What a character is to the grammar.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Class {
    /// Space, CR, DEL, BS, the mark of a continuation line: nothing inside a number.
    Ignored,
    /// TAB, which ends a number.
    Tab,
    /// `(`.
    Open,
    /// `)`, which is illegal outside a comment.
    Close,
    /// `A` to `Z`.
    Letter,
    /// `0` to `9`.
    Digit,
    /// A character with a function: `+ - * / = [ ] . , $ :`.
    Sign,
    /// Anything else.
    Illegal,
}

const CLASSES: [Class; 256] = {
    let mut table = [Class::Illegal; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = match byte as u8 {
            // Nothing in machining data, even inside a number; TAB and NUL are not among them (E100L-FMT-07).
            b' ' | b'\r' | 0x7f | 0x08 | CONTINUATION => Class::Ignored,
            b'\t' => Class::Tab,
            b'(' => Class::Open,
            b')' => Class::Close,
            b'A'..=b'Z' => Class::Letter,
            b'0'..=b'9' => Class::Digit,
            b'+' | b'-' | b'*' | b'/' | b'=' | b'[' | b']' | b'.' | b',' | b'$' | b':' => Class::Sign,
            _ => Class::Illegal,
        };
        byte += 1;
    }
    table
};

/// The class of a character.
/// By now it is ASCII, so that the same ones are ignored in every tape code (E100L-TAPE-02).
#[inline]
pub fn class(byte: u8) -> Class {
    CLASSES[usize::from(byte)]
}

/// Marks a byte that the tape code does not know.
const BAD: u8 = 0xff;

/// RS-244 to ASCII. Blank tape reads as DEL, 80 as LF.
const EIA: [u8; 256] = {
    let mut table = [BAD; 256];
    let pairs: [(&[u8], &[u8]); 5] = [
        (b"0123456789", &[0x20, 0x01, 0x02, 0x13, 0x04, 0x15, 0x16, 0x07, 0x08, 0x19]),
        (
            b"ABCDEFGHIJKLMNOPQR",
            &[
                0x61, 0x62, 0x73, 0x64, 0x75, 0x76, 0x67, 0x68, 0x79, 0x51, 0x52, 0x43, 0x54, 0x45, 0x46,
                0x57, 0x58, 0x49,
            ],
        ),
        (b"STUVWXYZ", &[0x32, 0x23, 0x34, 0x25, 0x26, 0x37, 0x38, 0x29]),
        (b"+-/.,&%()", &[0x70, 0x40, 0x31, 0x6b, 0x3b, 0x0e, 0x0b, 0x1a, 0x4a]),
        (b" \t\x08\x7f\x7f\n", &[0x10, 0x3e, 0x2a, 0x7f, 0x00, 0x80]),
    ];
    let mut group = 0;
    while group < pairs.len() {
        let (characters, codes) = pairs[group];
        let mut next = 0;
        while next < characters.len() {
            table[codes[next] as usize] = characters[next];
            next += 1;
        }
        group += 1;
    }
    table
};

/// ISO to ASCII: seven bits and even parity.
const ISO: [u8; 256] = {
    let mut table = [BAD; 256];
    let mut byte = 0;
    while byte < 256 {
        if (byte as u8).count_ones().is_multiple_of(2) {
            table[byte] = byte as u8 & 0x7f;
        }
        byte += 1;
    }
    table
};

/// A run of lines that may be a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Lines {
    /// Number of the first line, from 1.
    pub line: u32,
    /// Offset of the first byte.
    pub start: usize,
    /// Offset after the last byte, without the end of block.
    pub end: usize,
    /// Whether there is more than one line.
    pub continued: bool,
    /// Whether the first line continues a line that cannot be continued.
    pub stray: bool,
}

/// A place between two blocks of a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Mark {
    /// Offset of the next byte.
    pub at: usize,
    /// Number of its line, from 1.
    pub line: u32,
    /// Whether the line before is one that cannot be continued.
    pub closed: bool,
}

/// What lines are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// They may be a block.
    Block,
    /// A program start, or a file header.
    Other,
    /// The header of a schedule program.
    ScheduleHeader,
}

/// Cuts the text into lines and joins continuation lines.
#[derive(Clone, Debug)]
pub struct Reader<'a> {
    bytes: &'a [u8],
    code: TapeCode,
    at: usize,
    line: u32,
    /// Whether the line before is one that cannot be continued.
    closed: bool,
    /// The parts of the text that are read, all of it without any, and the offset behind the present one.
    sections: Arc<[Section]>,
    limit: usize,
}

impl<'a> Reader<'a> {
    /// A reader at the beginning of a text.
    pub fn new(bytes: &'a [u8], code: TapeCode) -> Self {
        Self { bytes, code, at: 0, line: 1, closed: false, sections: Arc::default(), limit: usize::MAX }
    }

    /// Where the next block begins.
    #[inline]
    pub fn at(&self) -> usize {
        self.at
    }

    /// Where reading goes on.
    pub fn mark(&self) -> Mark {
        Mark { at: self.at, line: self.line, closed: self.closed }
    }

    /// Goes on elsewhere in the same text.
    pub fn seek(&mut self, mark: Mark) {
        Mark { at: self.at, line: self.line, closed: self.closed } = mark;
        if self.sections.is_empty() {
            return;
        }
        // Outside of the sections reading goes on with the next one.
        let section = self.sections.iter().find(|section| mark.at < section.end);
        let within = section.filter(|section| section.start.at <= mark.at);
        self.limit = within.map_or(mark.at, |section| section.end);
    }

    /// Reads nothing but some sections of the text, from the beginning of the first one.
    pub fn keep_to(&mut self, sections: &[Section]) {
        self.sections = sections.iter().copied().filter(|section| section.start.at < section.end).collect();
        self.limit = 0;
        match self.sections.first().copied() {
            Some(first) => self.seek(first.start),
            None => self.at = usize::MAX,
        }
    }

    /// Goes on with the next section; false behind the last one.
    #[cold]
    fn next_section(&mut self) -> bool {
        let next = self.sections.iter().find(|section| section.start.at >= self.limit).copied();
        if let Some(section) = next {
            self.seek(section.start);
        }
        next.is_some()
    }

    /// Goes on in another text of the same code.
    pub fn turn_to(&mut self, bytes: &'a [u8], mark: Mark) {
        self.bytes = bytes;
        self.seek(mark);
    }

    /// Whether a byte is the end of block, parity aside.
    /// LF; in EIA code CR, which is 80 (E100L-FMT-04).
    fn is_end_of_block(&self, byte: u8) -> bool {
        match self.code {
            TapeCode::Ascii => byte == b'\n',
            TapeCode::Iso => byte & 0x7f == b'\n',
            TapeCode::Eia => byte == 0x80,
        }
    }

    /// The offset after the line that begins at an offset.
    #[inline]
    fn end_of_line(&self, start: usize) -> usize {
        let rest = self.bytes.get(start..).unwrap_or_default();
        let length = match self.code {
            TapeCode::Ascii => memchr::memchr(b'\n', rest),
            TapeCode::Iso => memchr::memchr2(b'\n', b'\n' | 0x80, rest),
            TapeCode::Eia => memchr::memchr(0x80, rest),
        };
        length.map_or(self.bytes.len(), |length| start + length)
    }

    /// Whether a line begins with `$`, which continues a block (E100L-TAPE-03).
    fn begins_with_dollar(&self, start: usize) -> bool {
        match (self.code, self.bytes.get(start)) {
            (TapeCode::Ascii, Some(byte)) => *byte == b'$',
            (TapeCode::Iso, Some(byte)) => byte & 0x7f == b'$',
            _ => false,
        }
    }

    /// The next line with its continuation lines; none at the end of the text.
    #[inline(always)]
    pub fn next_lines(&mut self) -> Option<Lines> {
        while self.at >= self.limit {
            if !self.next_section() {
                return None;
            }
        }
        if self.at >= self.bytes.len() {
            return None;
        }
        let (line, start) = (self.line, self.at);
        let stray = self.closed && self.begins_with_dollar(start);
        let mut end = self.end_of_line(start);
        self.line = self.line.saturating_add(u32::from(end < self.bytes.len()));
        let mut continued = false;
        let single = line == 1 && self.begins_with_dollar(0) || self.is_program_start(start, end);
        if !single && end < self.bytes.len() && self.begins_with_dollar(end + 1) {
            continued = true;
            end = self.end_of_continuation(end);
        }
        self.at = end + 1;
        self.closed = single;
        // One block with its continuation lines (E100L-AEXP-12), on the line of its first character (E100L-FMT-04).
        Some(Lines { line, start, end, continued, stray })
    }

    /// The offset after the continuation lines behind a line.
    #[cold]
    fn end_of_continuation(&mut self, mut end: usize) -> usize {
        while end < self.bytes.len() && self.begins_with_dollar(end + 1) {
            end = self.end_of_line(end + 1);
            let counted = end < self.bytes.len() && !planted::is(Bug::ContinuationNotCounted);
            self.line = self.line.saturating_add(u32::from(counted));
        }
        end
    }

    /// The line after the last one: 1 and the number of ends of block in the text.
    pub fn last_line(&self) -> u32 {
        self.line
    }

    /// Length of the text in bytes.
    pub fn length(&self) -> usize {
        self.bytes.len()
    }

    /// A character of a byte, if the tape code knows it.
    fn character(&self, byte: u8) -> Option<u8> {
        match self.code {
            TapeCode::Ascii => Some(byte),
            TapeCode::Iso if planted::is(Bug::ParityIgnored) => Some(byte & 0x7f),
            TapeCode::Iso => Some(ISO[usize::from(byte)]).filter(|character| *character != BAD),
            TapeCode::Eia => Some(EIA[usize::from(byte)]).filter(|character| *character != BAD),
        }
    }

    /// Whether a line holds nothing but `%` and ignored characters, `%` once at least.
    fn is_program_start(&self, start: usize, end: usize) -> bool {
        let mut found = false;
        for &byte in self.bytes.get(start..end).unwrap_or_default() {
            match self.character(byte) {
                Some(b'%') => found = true,
                Some(character) if class(character) == Class::Ignored => {}
                _ => return false,
            }
        }
        found
    }

    /// What the lines read last are, with the test of the file header.
    #[inline(always)]
    pub fn kind(&self, lines: Lines) -> Result<Kind, Fault> {
        // Only the first line is a header, and only program starts cannot be continued.
        if lines.line != 1 && !self.closed { Ok(Kind::Block) } else { self.kind_apart(lines) }
    }

    #[cold]
    fn kind_apart(&self, lines: Lines) -> Result<Kind, Fault> {
        if self.is_header(lines) {
            return self.check_header(lines);
        }
        Ok(if self.is_tape_mark(lines) { Kind::Other } else { Kind::Block })
    }

    /// Whether the file header says that the text is a schedule program, whatever is wrong with it; nothing without a
    /// header.
    pub fn is_schedule(&self) -> Option<bool> {
        let first = self.has_header().then(|| Self::new(self.bytes, self.code).next_lines())??;
        let text: Vec<u8> = self.lenient(first).collect();
        let extension = text.rsplit(|byte| *byte == b'.').next().unwrap_or_default();
        Some(
            text.contains(&b'.') && extension.split(|byte| !byte.is_ascii_uppercase()).next() == Some(b"SDF"),
        )
    }

    /// Whether the text begins with a file header.
    pub fn has_header(&self) -> bool {
        self.begins_with_dollar(0)
    }

    /// Whether the lines read last are no block, without any test of them.
    pub fn is_no_block(&self, lines: Lines) -> bool {
        self.is_header(lines) || self.is_tape_mark(lines)
    }

    fn is_header(&self, lines: Lines) -> bool {
        lines.line == 1 && self.begins_with_dollar(0)
    }

    fn is_tape_mark(&self, lines: Lines) -> bool {
        self.closed && !lines.stray && self.is_program_start(lines.start, lines.end)
    }

    /// The characters of a block whatever is wrong with them.
    pub fn lenient(&self, lines: Lines) -> Lenient<'_> {
        Lenient { reader: self, at: lines.start, end: lines.end, after_end: false }
    }

    /// The file header: it ends in `%`; a subprogram is no beginning.
    fn check_header(&self, lines: Lines) -> Result<Kind, Fault> {
        let raw = self.bytes.get(lines.start..lines.end).unwrap_or_default();
        let text: Option<Vec<u8>> = raw.iter().map(|byte| self.character(*byte)).collect();
        let end_is_bad = self.bytes.get(lines.end).is_some_and(|end| self.character(*end).is_none());
        let text = text.filter(|_| !end_is_bad).ok_or_else(|| Fault::new(AlarmName::ParityError, CMT_02))?;
        let is_blank = |byte: &u8| class(*byte) == Class::Ignored;
        let length = text.len() - text.iter().rev().take_while(|byte| is_blank(byte)).count();
        let Some(name) = text.get(..length).and_then(|text| text.strip_suffix(b"%")) else {
            return Err(Fault::new(AlarmName::HeaderMalformed, PROG_05));
        };
        let mut parts = name.rsplitn(2, |byte| *byte == b'.');
        if let (Some(extension), Some(_)) = (parts.next(), parts.next()) {
            let letters = extension.iter().take_while(|byte| byte.is_ascii_uppercase()).count();
            let extension = extension.get(..letters).unwrap_or_default();
            return match extension {
                b"SDF" => Ok(Kind::ScheduleHeader),
                b"SUB" | b"SSB" | b"MSB" => {
                    Err(Fault::about(AlarmName::ProgramKind, PROG_01, Label::from_bytes(extension)))
                }
                _ => Ok(Kind::Other),
            };
        }
        Ok(Kind::Other)
    }

    /// The characters of a block, either in the text itself or in the buffer.
    ///
    /// # Errors
    /// A block that is too long, or holds a byte that the tape code does not know.
    #[inline(always)]
    pub fn characters<'b>(&self, lines: Lines, buffer: &'b mut Vec<u8>) -> Result<&'b [u8], Fault>
    where
        'a: 'b,
    {
        let raw = self.bytes.get(lines.start..lines.end).unwrap_or_default();
        if raw.len() > LONGEST {
            self.check_length(raw)?;
        }
        if self.code == TapeCode::Ascii && !lines.continued {
            return Ok(raw);
        }
        self.decoded(raw, lines, buffer)
    }

    /// The characters of a block in another tape code, or of several lines, in the buffer.
    fn decoded<'b>(&self, raw: &[u8], lines: Lines, buffer: &'b mut Vec<u8>) -> Result<&'b [u8], Fault> {
        buffer.clear();
        let bad = || Fault::new(AlarmName::ParityError, CMT_02);
        let mut after_end = false;
        for &byte in raw {
            let character = self.character(byte).ok_or_else(bad)?;
            if character == b'\n' {
                after_end = true;
                continue;
            }
            // The `$` of a continuation line acts as a blank (E100L-AEXP-12).
            buffer.push(if after_end { CONTINUATION } else { character });
            after_end = false;
        }
        if let Some(byte) = self.bytes.get(lines.end) {
            self.character(*byte).ok_or_else(bad)?;
        }
        Ok(buffer)
    }

    fn check_length(&self, raw: &[u8]) -> Result<(), Fault> {
        let is_return = |byte: u8| match self.code {
            TapeCode::Ascii => byte == b'\r',
            TapeCode::Iso => byte & 0x7f == b'\r',
            TapeCode::Eia => false,
        };
        let counts = |byte: &&u8| !self.is_end_of_block(**byte) && !is_return(**byte);
        if raw.iter().filter(counts).count() > LONGEST + usize::from(planted::is(Bug::LongestBlock)) {
            return Err(Fault::new(AlarmName::BlockTooLong, FMT_05));
        }
        Ok(())
    }
}

/// Characters of a block one by one; a byte that the tape code does not know is one without function.
pub struct Lenient<'r> {
    reader: &'r Reader<'r>,
    at: usize,
    end: usize,
    /// Whether the mark of a continuation line comes next, which acts as a blank.
    after_end: bool,
}

impl Iterator for Lenient<'_> {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        while self.at < self.end {
            let byte = *self.reader.bytes.get(self.at)?;
            self.at += 1;
            if self.reader.is_end_of_block(byte) {
                self.after_end = true;
            } else if std::mem::take(&mut self.after_end) {
                return Some(CONTINUATION);
            } else {
                return Some(self.reader.character(byte).unwrap_or(0));
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Lines, Reader};
    use turnspec_oracle::vocabulary::TapeCode;

    fn lines(text: &[u8]) -> Vec<Lines> {
        let mut reader = Reader::new(text, TapeCode::Ascii);
        std::iter::from_fn(|| reader.next_lines()).collect()
    }

    #[test]
    fn continuation_lines_join() {
        let found = lines(b"G00\n$X1\n$Z2\nX3\n");
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].line, found[0].start, found[0].end, found[0].continued), (1, 0, 11, true));
        assert_eq!((found[1].line, found[1].start, found[1].end), (4, 12, 14));
    }

    #[test]
    fn headers_and_program_starts_are_not_continued() {
        let found = lines(b"$A.MIN%\n$X1\n%\n$X2");
        assert_eq!(found.iter().map(|lines| lines.stray).collect::<Vec<_>>(), [false, true, false, true]);
        assert_eq!(found.iter().map(|lines| lines.line).collect::<Vec<_>>(), [1, 2, 3, 4]);
    }

    #[test]
    fn an_eia_text_reads_as_its_characters() {
        // G 0 1, space, X 5, end of block.
        let text = [0x67, 0x20, 0x01, 0x10, 0x37, 0x15, 0x80];
        let mut reader = Reader::new(&text, TapeCode::Eia);
        let block = reader.next_lines().unwrap_or_default();
        let mut buffer = Vec::new();
        assert_eq!(reader.characters(block, &mut buffer).ok(), Some(b"G01 X5".as_slice()));
        assert!(reader.next_lines().is_none());
    }
}
