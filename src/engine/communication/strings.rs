//! Character strings (execution of input and output, chapter 3, "Strings"; E100L-GPUT-13, E100L-VUACM-04,
//! E100L-VUACM-05).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::expression::hexadecimal_digit;
use crate::engine::fault::Fault;
use crate::engine::parse::Parser;
use crate::engine::text::CONTINUATION;
use crate::engine::words::Code;

use super::CommentForm;

/// A string that was read.
pub struct Quoted {
    /// Its characters among those of the block.
    pub characters: Code,
    /// Whether a prefix makes its letters lower case.
    pub lower: bool,
}

impl Parser<'_> {
    /// A string, its prefix included; what else stands here is a fault of the rule.
    pub(super) fn string(&mut self, rule: RuleId) -> Result<Quoted, Fault> {
        let malformed = || Fault::new(AlarmName::Format, rule);
        let mut lower = self.peek() == Some(b'^');
        self.at += usize::from(lower);
        if self.peek() != Some(b'\'') {
            return Err(malformed());
        }
        self.at += 1;
        let start = self.characters();
        loop {
            let byte = self.peek().filter(|byte| *byte != CONTINUATION).ok_or_else(malformed)?;
            self.at += 1;
            match byte {
                b'\'' => break,
                b'\r' | 0x7f | 0x08 => {}
                b'^' if !lower && self.characters() == start => lower = true,
                b'%' => return Fault::raise(AlarmName::IllegalCharacter, FMT_08),
                b' '..=b'_' if lower => self.block.characters.push(byte.to_ascii_lowercase()),
                b' '..=b'_' => self.block.characters.push(byte),
                _ => return Fault::raise(AlarmName::IllegalCharacter, FMT_08),
            }
        }
        let characters = Code { start, end: self.characters() };
        if characters.length() == 0 { Err(malformed()) } else { Ok(Quoted { characters, lower }) }
    }

    /// The string behind VUACM, and how it was written.
    pub(in crate::engine) fn comment(&mut self) -> Result<(Code, CommentForm), Fault> {
        self.skip_blanks()?;
        let Quoted { characters, lower } = self.string(VUACM_01)?;
        if lower {
            return Ok((characters, CommentForm::Lower));
        }
        match self.block.text(characters).split_first() {
            Some((b'-', _)) => {
                Err(Fault::about(AlarmName::Unspecified, VUACM_05, const { Label::new("kana") }))
            }
            Some((b'$', digits)) => {
                let codes = codes(digits).filter(|codes| (1..=4).contains(&codes.len()));
                let codes = codes.ok_or_else(|| Fault::new(AlarmName::NumberMalformed, VUACM_04))?;
                self.block.characters.truncate(usize::from(characters.start));
                Ok((self.keep(&codes), CommentForm::Codes))
            }
            _ => Ok((characters, CommentForm::Plain)),
        }
    }

    /// How many characters the strings of the block have so far.
    fn characters(&self) -> u16 {
        u16::try_from(self.block.characters.len()).unwrap_or(u16::MAX)
    }

    /// Adds characters to those of the block.
    pub(in crate::engine) fn keep(&mut self, codes: &[u8]) -> Code {
        let start = self.characters();
        self.block.characters.extend_from_slice(codes);
        Code { start, end: self.characters() }
    }
}

/// The codes that pairs of hexadecimal digits give; none if that is not what they are.
pub fn codes(digits: &[u8]) -> Option<Vec<u8>> {
    let digit = |byte: u8| hexadecimal_digit(byte).and_then(|digit| u8::try_from(digit).ok());
    let pair = |pair: &[u8]| match pair {
        [high, low] => Some(digit(*high)? << 4 | digit(*low)?),
        _ => None,
    };
    digits.chunks(2).map(pair).collect()
}

#[cfg(test)]
mod tests {
    use super::codes;

    #[test]
    fn codes_are_pairs() {
        assert_eq!(codes(b"0D0AB6"), Some(vec![0x0d, 0x0a, 0xb6]));
        assert_eq!(codes(b""), Some(Vec::new()));
        for faulty in [b"0".as_slice(), b"0D0", b"0G", b"0a"] {
            assert_eq!(codes(faulty), None);
        }
    }
}
