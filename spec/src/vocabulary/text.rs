//! Characters that a program sends, displays or stores.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// At most 160 character codes, without a heap; more are cut.
///
/// As text, in JSON too, it is *written*: the codes 21 to 7E except the backslash stand for themselves, every other code
/// is `\xHH`, and a single `-` is `\x2D`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Text {
    bytes: [u8; Self::CAPACITY],
    length: u8,
}

impl Text {
    /// The largest number of characters.
    pub const CAPACITY: usize = 160;

    /// The text with these character codes.
    #[must_use]
    pub fn new(codes: &[u8]) -> Self {
        let mut bytes = [0; Self::CAPACITY];
        bytes.iter_mut().zip(codes).for_each(|(byte, code)| *byte = *code);
        Self { bytes, length: codes.len().min(Self::CAPACITY) as u8 }
    }

    /// The character codes.
    #[must_use]
    pub fn codes(&self) -> &[u8] {
        self.bytes.get(..usize::from(self.length)).unwrap_or_default()
    }

    /// Reads a written text; `None` if it is none, or too long.
    #[must_use]
    pub fn read(written: &str) -> Option<Self> {
        let (mut codes, mut rest) = (Vec::new(), written);
        while let Some(first) = rest.chars().next() {
            let (code, behind) = match rest.strip_prefix("\\x") {
                Some(escaped) => (u8::from_str_radix(escaped.get(..2)?, 16).ok()?, escaped.get(2..)?),
                None => (u8::try_from(first).ok().filter(|code| is_plain(*code))?, rest.get(1..)?),
            };
            codes.push(code);
            rest = behind;
        }
        (codes.len() <= Self::CAPACITY).then(|| Self::new(&codes))
    }
}

fn is_plain(code: u8) -> bool {
    code.is_ascii_graphic() && code != b'\\'
}

impl Default for Text {
    fn default() -> Self {
        Self::new(&[])
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.codes() == b"-" {
            return f.write_str("\\x2D");
        }
        self.codes().iter().try_for_each(|code| match is_plain(*code) {
            true => write!(f, "{}", char::from(*code)),
            false => write!(f, "\\x{code:02X}"),
        })
    }
}

impl fmt::Debug for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{self}\"")
    }
}

impl Serialize for Text {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Text {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written = String::deserialize(deserializer)?;
        Self::read(&written).ok_or_else(|| de::Error::custom(format!("{written:?} is no written text")))
    }
}

#[cfg(test)]
mod tests {
    use super::Text;

    #[test]
    fn every_code_survives() {
        for codes in [(0..=127).collect::<Vec<u8>>(), (128..=255).collect(), b"-".to_vec(), Vec::new()] {
            let text = Text::new(&codes);
            assert_eq!(Text::read(&text.to_string()), Some(text));
            assert_eq!(text.codes(), codes);
        }
    }

    #[test]
    fn what_is_plain_stands_for_itself() {
        assert_eq!(Text::new(b"A= \\1\n").to_string(), "A=\\x20\\x5C1\\x0A");
        assert_eq!(Text::new(b"-").to_string(), "\\x2D");
        assert_eq!(Text::new(&[b'A'; 161]).codes().len(), 160);
        for faulty in ["A B", "\\", "\\x0", "\\xZZ", "€", "\\x€€"] {
            assert_eq!(Text::read(faulty), None, "{faulty}");
        }
    }
}
