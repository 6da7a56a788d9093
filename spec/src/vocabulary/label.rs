//! Short names held in place: sequence names, program names, codes, variable names.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// At most 23 ASCII characters, without a heap. Longer text is cut; other characters become `?`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct Label {
    bytes: [u8; 23],
    length: u8,
}

impl Label {
    /// The label of some text.
    #[must_use]
    pub fn new(text: &str) -> Self {
        Self::from_bytes(text.as_bytes())
    }

    /// The label of ASCII bytes.
    #[must_use]
    pub fn from_bytes(text: &[u8]) -> Self {
        let mut label = Self::default();
        for &byte in text.iter().take(label.bytes.len()) {
            label.push(byte);
        }
        label
    }

    /// Appends one character if there is room.
    pub fn push(&mut self, byte: u8) {
        if let Some(slot) = self.bytes.get_mut(usize::from(self.length)) {
            *slot = if byte.is_ascii_graphic() { byte } else { b'?' };
            self.length += 1;
        }
    }

    /// The text.
    #[must_use]
    pub fn as_str(&self) -> &str {
        let text = self.bytes.get(..usize::from(self.length)).unwrap_or_default();
        std::str::from_utf8(text).unwrap_or_default()
    }

    /// Whether there is no text.
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
            Err(de::Error::custom("a name has at most 23 ASCII characters"))
        }
    }
}
