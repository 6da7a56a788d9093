//! The text of a program inside a set-up.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// Bytes of a program; in a set-up file one character a byte (U+0000 to U+00FF).
#[derive(Clone, PartialEq, Eq, Default)]
pub struct ProgramText(pub Vec<u8>);

impl fmt::Debug for ProgramText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.0.escape_ascii())
    }
}

impl Serialize for ProgramText {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0.iter().copied().map(char::from).collect::<String>())
    }
}

impl<'de> Deserialize<'de> for ProgramText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let bytes: Result<Vec<u8>, _> = text.chars().map(u8::try_from).collect();
        bytes.map(Self).map_err(|_| de::Error::custom("a program text has a character above U+00FF"))
    }
}

#[cfg(test)]
mod tests {
    use super::ProgramText;

    #[test]
    fn every_byte_survives() {
        let text = ProgramText((0..=255).collect());
        let json = serde_json::to_string(&text).unwrap_or_default();
        assert_eq!(serde_json::from_str::<ProgramText>(&json).ok(), Some(text));
        assert!(serde_json::from_str::<ProgramText>("\"€\"").is_err());
    }
}
