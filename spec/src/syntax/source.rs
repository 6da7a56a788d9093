//! Bytes to lines of characters: the code of the tape, continuation lines, the file header.

use crate::controls::e100l::tape_codes;
use crate::fault::{Fault, Outcome};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Place, TapeCode};

/// E100L-FMT-05: characters of a block, without end of block and carriage return.
const BLOCK_LENGTH: usize = 158;

/// A character of the program and where it stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Character {
    /// Its seven-bit code.
    pub code: u8,
    /// Offset of its byte.
    pub offset: u32,
    /// Whether its byte breaks the parity, or is no character of the code.
    pub faulty: bool,
    /// Whether it is the mark of a continuation, which reads as a blank.
    pub continues: bool,
}

/// The text of one block: a line and its continuations.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Line {
    /// Its characters; a continuation mark reads as a blank.
    pub characters: Vec<Character>,
    /// How many there are, without carriage returns.
    pub length: usize,
    /// Whether it holds nothing but `%`.
    is_tape_mark: bool,
    /// Line number and byte span.
    pub place: Place,
}

/// Cuts a program text into the texts of its blocks.
pub struct Source<'a> {
    bytes: &'a [u8],
    code: TapeCode,
    position: usize,
    line: u32,
}

impl<'a> Source<'a> {
    /// The source of a program text.
    pub fn new(bytes: &'a [u8], code: TapeCode) -> Self {
        Self::at(bytes, code, (0, 1))
    }

    /// The source of the rest of a text, from the byte and the line on at which a block begins.
    pub fn at(bytes: &'a [u8], code: TapeCode, (position, line): (usize, u32)) -> Self {
        Self { bytes, code, position, line }
    }

    /// Byte and line of this place.
    pub fn here(&self) -> (usize, u32) {
        (self.position, self.line)
    }

    /// Passes the file header over, whatever it says.
    pub fn skip_header(&mut self) {
        if self.position == 0 && self.at_dollar() {
            self.physical_line();
        }
    }

    /// E100L-PROG-01, E100L-SDF-01: whether the file header says that the text is a schedule program; none without a
    /// header.
    pub fn header_of_schedule(&self) -> Option<bool> {
        if self.position > 0 || !self.at_dollar() {
            return None;
        }
        let line = self.bytes.split(|byte| self.character(*byte) == Some(b'\n')).next();
        Some(extension(&self.header_text(line.unwrap_or_default())) == Some("SDF"))
    }

    /// The next block's text, its continuation lines joined (E100L-AEXP-12); lines of `%` alone are no blocks (E100L-TAPE-04). At the end `None`.
    ///
    /// # Errors
    /// A malformed file header.
    pub fn next_line(&mut self) -> Outcome<Option<Line>> {
        if self.position == 0 && self.at_dollar() {
            let start = self.position;
            let header = self.physical_line();
            let bytes = self.bytes.get(start..self.position).unwrap_or_default();
            self.read_header(bytes).map_err(|fault| fault.of_block(header.place))?;
        }
        loop {
            if self.position >= self.bytes.len() {
                return Ok(None);
            }
            let mut line = self.physical_line();
            if line.is_tape_mark {
                continue;
            }
            while self.at_dollar() {
                let continuation = self.physical_line();
                line.place.end = continuation.place.end;
                let mut characters = continuation.characters;
                if let Some(mark) = characters.first_mut() {
                    mark.code = b' ';
                    mark.continues = true;
                }
                line.length += continuation.length;
                line.characters.append(&mut characters);
            }
            return Ok(Some(line));
        }
    }

    /// The place behind the last block.
    pub fn end(&self) -> Place {
        let length = offset(self.bytes.len());
        let line = if self.bytes.last().is_some_and(|last| self.character(*last) == Some(b'\n'))
            || self.bytes.is_empty()
        {
            self.line
        } else {
            self.line - 1
        };
        Place { line, start: length, end: length, ..Place::default() }
    }

    fn character(&self, byte: u8) -> Option<u8> {
        match self.code {
            TapeCode::Ascii => Some(byte),
            TapeCode::Iso => Some(tape_codes::from_iso(byte)),
            TapeCode::Eia => tape_codes::from_eia(byte),
        }
    }

    fn at_dollar(&self) -> bool {
        self.bytes.get(self.position).is_some_and(|byte| self.character(*byte) == Some(b'$'))
    }

    /// E100L-TAPE-04, E100L-PROG-05: `$`, file name, `.`, extension, `%`.
    fn read_header(&self, bytes: &[u8]) -> Outcome<()> {
        if bytes.iter().any(|byte| self.is_faulty(*byte)) {
            return Err(Fault::new(AlarmName::ParityError, CMT_02));
        }
        let text = self.header_text(bytes);
        if text.last() != Some(&b'%') {
            return Err(Fault::new(AlarmName::HeaderMalformed, PROG_05));
        }
        // E100L-PROG-01: subprograms are only called.
        match extension(&text) {
            Some(kind @ ("SUB" | "SSB" | "MSB")) => Err(Fault::about(AlarmName::ProgramKind, PROG_01, kind)),
            _ => Ok(()),
        }
    }

    /// The characters of a header, without those that are ignored at its end.
    fn header_text(&self, bytes: &[u8]) -> Vec<u8> {
        let characters = bytes.iter().filter_map(|byte| self.character(*byte));
        let mut text: Vec<u8> = characters.filter(|code| *code != b'\n').collect();
        while text.last().is_some_and(|last| is_ignored(*last)) {
            text.pop();
        }
        text
    }

    fn is_faulty(&self, byte: u8) -> bool {
        match self.code {
            TapeCode::Ascii => false,
            TapeCode::Iso => !tape_codes::iso_parity_holds(byte),
            TapeCode::Eia => self.character(byte).is_none(),
        }
    }

    /// Takes one physical line with its end of block (E100L-FMT-04).
    fn physical_line(&mut self) -> Line {
        let start = offset(self.position);
        let mut characters = Vec::new();
        let mut end = start;
        let mut length = 0;
        // Characters that are not ignored, and whether they are all `%`.
        let (mut visible, mut marks) = (0_u64, true);
        while let Some(&byte) = self.bytes.get(self.position) {
            let code = self.character(byte);
            let faulty = self.is_faulty(byte);
            let (code, offset_here) = (code.unwrap_or(0), offset(self.position));
            let character = Character { code, offset: offset_here, faulty, continues: false };
            self.position += 1;
            if character.code == b'\n' {
                if faulty {
                    characters.push(Character { code: b'\r', ..character });
                }
                break;
            }
            end = offset(self.position);
            length += usize::from(character.code != b'\r');
            if faulty || !is_ignored(character.code) {
                visible += 1;
                marks &= character.code == b'%' && !faulty;
            }
            // A run of carriage returns is one blank.
            let repeated = |before: &Character| character.code == b'\r' && before.code == b'\r' && !faulty;
            if !characters.last().is_some_and(repeated) {
                characters.push(character);
            }
        }
        let place = Place { line: self.line, start, end, ..Place::default() };
        self.line += 1;
        Line { characters, length, is_tape_mark: visible > 0 && marks, place }
    }
}

impl Line {
    /// Length and parity (E100L-FMT-05, E100L-CMT-02).
    ///
    /// # Errors
    /// The block is too long, or a byte has wrong parity.
    pub fn check(&self) -> Outcome<()> {
        if self.length > BLOCK_LENGTH {
            return Err(Fault::new(AlarmName::BlockTooLong, FMT_05));
        }
        match self.characters.iter().find(|character| character.faulty) {
            Some(bad) => Err(Fault::new(AlarmName::ParityError, CMT_02).at(bad.offset..bad.offset + 1)),
            None => Ok(()),
        }
    }
}

/// The letters behind the last point of a header.
fn extension(header: &[u8]) -> Option<&str> {
    let point = header.iter().rposition(|code| *code == b'.')?;
    let behind = header.get(point + 1..)?;
    let letters = behind.iter().take_while(|code| code.is_ascii_uppercase()).count();
    behind.get(..letters).and_then(|letters| std::str::from_utf8(letters).ok())
}

/// E100L-FMT-07, E100L-TAPE-02: space, CR, DEL and BS.
pub(super) fn is_ignored(code: u8) -> bool {
    matches!(code, b' ' | b'\r' | 0x7F | 0x08)
}

fn offset(position: usize) -> u32 {
    u32::try_from(position).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::Source;
    use crate::vocabulary::TapeCode;

    /// However long a run of carriage returns is, it takes the room of one blank.
    #[test]
    fn carriage_returns_in_a_row_are_one_character() {
        let text = [b"X1".as_slice(), &[b'\r'; 1000], b"Z2\n"].concat();
        let mut source = Source::new(&text, TapeCode::Ascii);
        let Ok(Some(line)) = source.next_line() else { panic!("a line") };
        let codes: Vec<u8> = line.characters.iter().map(|character| character.code).collect();
        assert_eq!(codes, b"X1\rZ2");
    }

    #[test]
    fn the_end_lies_behind_the_last_byte() {
        for (text, line) in [("G00 X1\n", 2), ("G00 X1", 1), ("", 1)] {
            let mut source = Source::new(text.as_bytes(), TapeCode::Ascii);
            while let Ok(Some(_)) = source.next_line() {}
            let end = source.end();
            assert_eq!((end.line, end.start as usize, end.end as usize), (line, text.len(), text.len()));
        }
    }
}
