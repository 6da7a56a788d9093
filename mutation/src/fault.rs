//! What goes wrong outside of the mutants.

use std::fmt;

/// Something that cannot be read, run or understood.
#[derive(Debug)]
pub struct Fault {
    about: String,
    reason: String,
}

impl Fault {
    /// About a file or a command.
    pub fn about(what: impl fmt::Display, reason: impl fmt::Display) -> Self {
        Self { about: what.to_string(), reason: reason.to_string() }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.about, self.reason)
    }
}

impl std::error::Error for Fault {}
