//! The grammar of PSELECT (E100L-SDF-06, E100L-SDF-07, E100L-SDF-10, E100L-SDF-13).

use turnspec_oracle::vocabulary::AlarmName;
use turnspec_oracle::vocabulary::rule_ids::*;

use crate::engine::fault::Fault;
use crate::engine::parse::Parser;
use crate::engine::text::{Class, class};
use crate::engine::words::Code;

use super::Selecting;

/// Most characters of the name of a file.
const LONGEST: usize = 16;

impl Parser<'_> {
    /// What follows PSELECT.
    pub(super) fn selecting(&mut self) -> Result<Selecting, Fault> {
        let file = self.main_file()?;
        let mut selecting = Selecting { file, program: None, subprograms: None, repetitions: None };
        if self.comma()? {
            if self.peek() == Some(b'O') {
                selecting.program = Some(self.name_of_program()?);
            }
            if self.comma()? {
                selecting.subprograms = self.subprogram_file()?;
                if self.comma()? && self.peek() == Some(b'Q') {
                    self.at += 1;
                    selecting.repetitions = Some(self.repetitions()?);
                }
            }
        }
        self.nothing_more(SDF_06)?;
        Ok(selecting)
    }

    /// A comma with the blanks beside it.
    fn comma(&mut self) -> Result<bool, Fault> {
        self.skip_blanks()?;
        if self.peek() != Some(b',') {
            return Ok(false);
        }
        self.at += 1;
        self.skip_blanks()?;
        Ok(true)
    }

    /// The characters up to the next blank or comma.
    fn file(&mut self) -> &[u8] {
        let rest = self.text.get(self.at..).unwrap_or_default();
        let ends =
            |byte: &u8| *byte == b',' || matches!(class(*byte), Class::Ignored | Class::Tab | Class::Open);
        let length = rest.iter().position(ends).unwrap_or(rest.len());
        self.at += length;
        rest.get(..length).unwrap_or_default()
    }

    /// The main program file in full, whether it is written or not.
    fn main_file(&mut self) -> Result<Code, Fault> {
        let file = self.file();
        if file.iter().any(|byte| matches!(byte, b'*' | b'?')) {
            return Fault::raise(AlarmName::FileWildcard, SDF_07);
        }
        let parts = File::of(file).ok_or_else(|| Fault::new(AlarmName::FileNameMalformed, SDF_07))?;
        let full = parts.full(b"A", b"MIN");
        Ok(self.keep(&full))
    }

    /// The subprogram file in full, if one is written; it must have a name.
    fn subprogram_file(&mut self) -> Result<Option<Code>, Fault> {
        let file = self.file();
        if file.is_empty() {
            return Ok(None);
        }
        let parts = File::of(file).filter(|parts| parts.name.is_some());
        let full = parts.ok_or_else(|| Fault::new(AlarmName::FileNameMalformed, SDF_10))?.full(b"", b"SUB");
        Ok(Some(self.keep(&full)))
    }

    /// What stands behind Q.
    fn repetitions(&mut self) -> Result<Code, Fault> {
        match self.peek() {
            Some(b'=') => {
                self.at += 1;
                self.expression()
            }
            Some(b'0'..=b'9' | b'.') => self.lone_constant(),
            Some(byte) if matches!(class(byte), Class::Ignored | Class::Tab | Class::Open) => {
                self.expression()
            }
            _ => Fault::raise(AlarmName::EqualSignMissing, SDF_13),
        }
    }
}

/// The parts of a file name that are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct File<'f> {
    device: Option<&'f [u8]>,
    name: Option<&'f [u8]>,
    extension: Option<&'f [u8]>,
}

impl<'f> File<'f> {
    /// The parts, if each has its form.
    fn of(text: &'f [u8]) -> Option<Self> {
        let (device, rest) = match text.iter().position(|byte| *byte == b':') {
            Some(place) => (Some(text.get(..place)?), text.get(place + 1..)?),
            None => (None, text),
        };
        let (name, extension) = match rest.iter().position(|byte| *byte == b'.') {
            Some(place) => (rest.get(..place)?, Some(rest.get(place + 1..)?)),
            None => (rest, None),
        };
        let name = Some(name).filter(|name| !name.is_empty());
        let fits = device.is_none_or(is_short) && extension.is_none_or(is_short) && name.is_none_or(is_name);
        fits.then_some(Self { device, name, extension })
    }

    /// The name in full, with what is taken for parts that are not written.
    fn full(self, name: &[u8], extension: &[u8]) -> Vec<u8> {
        let device = self.device.unwrap_or(b"MD1");
        let parts = [device, b":", self.name.unwrap_or(name), b".", self.extension.unwrap_or(extension)];
        parts.concat()
    }
}

fn is_letter_or_digit(byte: u8) -> bool {
    byte.is_ascii_uppercase() || byte.is_ascii_digit()
}

/// Whether a text can be a device or an extension.
fn is_short(text: &[u8]) -> bool {
    text.len() == 3 && text.iter().all(|byte| is_letter_or_digit(*byte))
}

/// Whether a text can be the name of a file.
fn is_name(text: &[u8]) -> bool {
    let fits = |byte: &u8| *byte == b'-' || is_letter_or_digit(*byte);
    text.len() <= LONGEST && text.first().is_some_and(u8::is_ascii_uppercase) && text.iter().all(fits)
}

#[cfg(test)]
mod tests {
    use super::File;

    #[test]
    fn every_part_can_be_left_out() {
        for (text, full) in [
            (b"".as_slice(), b"MD1:A.MIN".as_slice()),
            (b"FD0:", b"FD0:A.MIN"),
            (b".XYZ", b"MD1:A.XYZ"),
            (b"SHAFT-1", b"MD1:SHAFT-1.MIN"),
            (b"FD0:ABCDEFGHIJKLMNOP.M1N", b"FD0:ABCDEFGHIJKLMNOP.M1N"),
        ] {
            assert_eq!(File::of(text).map(|parts| parts.full(b"A", b"MIN")), Some(full.to_vec()));
        }
    }

    #[test]
    fn forms_are_refused() {
        for text in
            [":A", "A:B", "MD1:A:B", "A.", "A.MI", "A.MINI", "A.B.C", "1A", "-A", "A=B", "ABCDEFGHIJKLMNOPQ"]
        {
            assert_eq!(File::of(text.as_bytes()), None, "{text}");
        }
    }
}
