//! The numbers in a T word (E100L-TOOL-02, E100L-TOOL-03).

/// The parts of a T word, two digits each.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ToolWord {
    /// Nose radius number.
    pub nose: u8,
    /// Tool number.
    pub tool: u8,
    /// Offset number.
    pub offset: u8,
}

impl ToolWord {
    /// Takes a word of at most six digits apart.
    #[must_use]
    pub fn new(word: i64) -> Self {
        let field = |value: i64| u8::try_from(value % 100).unwrap_or(0);
        Self { nose: field(word / 10_000), tool: field(word / 100), offset: field(word) }
    }

    /// Whether its offset and nose radius numbers are at most this one.
    #[must_use]
    pub fn exists(self, sets: u8) -> bool {
        self.nose <= sets && self.offset <= sets
    }
}
