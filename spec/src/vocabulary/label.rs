//! Short names held in place: sequence names, program names, codes, variable names.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// At most 24 ASCII characters, without a heap. Longer text is cut; other characters become `?`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct Label {
    bytes: [u8; 24],
    length: u8,
}

impl Label {
    /// The label of some text.
    #[must_use]
    pub const fn new(text: &str) -> Self {
        Self::from_bytes(text.as_bytes())
    }

    /// The label of ASCII bytes.
    #[must_use]
    pub const fn from_bytes(text: &[u8]) -> Self {
        let mut bytes = [0; 24];
        let mut length = 0;
        while length < bytes.len() && length < text.len() {
            bytes[length] = if text[length].is_ascii_graphic() { text[length] } else { b'?' };
            length += 1;
        }
        Self { bytes, length: length as u8 }
    }

    /// The label of a code: its letter and at least two digits, such as `G01` or `M110`.
    #[inline]
    #[must_use]
    pub const fn of_code(letter: u8, code: u16) -> Self {
        let mut bytes = [0; 24];
        bytes[0] = letter;
        let digits = if code >= 1000 { 999 } else { code };
        let mut length = 1;
        if digits >= 100 {
            bytes[length] = b'0' + (digits / 100) as u8;
            length += 1;
        }
        bytes[length] = b'0' + (digits / 10 % 10) as u8;
        bytes[length + 1] = b'0' + (digits % 10) as u8;
        Self { bytes, length: length as u8 + 2 }
    }

    /// Appends one character if there is room.
    #[inline]
    pub fn push(&mut self, byte: u8) {
        if let Some(slot) = self.bytes.get_mut(usize::from(self.length)) {
            *slot = if byte.is_ascii_graphic() { byte } else { b'?' };
            self.length += 1;
        }
    }

    /// The text.
    #[inline]
    #[must_use]
    pub fn as_str(&self) -> &str {
        let text = self.bytes.get(..usize::from(self.length)).unwrap_or_default();
        std::str::from_utf8(text).unwrap_or_default()
    }

    /// Whether there is no text.
    #[inline]
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl fmt::Debug for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.as_str())
    }
}

impl Serialize for Label {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.as_str())
    }
}

impl<'de> Deserialize<'de> for Label {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let label = Self::new(&text);
        if label.as_str() == text {
            Ok(label)
        } else {
            Err(de::Error::custom("a name has at most 24 ASCII characters"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Label;

    #[test]
    fn codes_have_at_least_two_digits() {
        for (code, text) in [(0, "G00"), (7, "G07"), (50, "G50"), (110, "G110"), (313, "G313"), (999, "G999")]
        {
            assert_eq!(Label::of_code(b'G', code).as_str(), text);
            assert_eq!(Label::of_code(b'G', code), Label::new(text));
        }
    }

    #[test]
    fn characters_are_appended_while_there_is_room() {
        let mut label = Label::default();
        label.push(b'A');
        label.push(b'\n');
        assert_eq!(label.as_str(), "A?");
        for _ in 0..30 {
            label.push(b'B');
        }
        assert_eq!(label.as_str(), format!("A?{}", "B".repeat(22)));
    }

    #[test]
    fn a_label_shows_its_text() {
        assert!(format!("{:?}", Label::new("M110")).contains("M110"));
    }
}
