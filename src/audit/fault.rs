//! Why there is no bundle.

use std::fmt;

/// Why there is no bundle, in words for the person who asked for it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fault(String);

impl Fault {
    /// A fault of a file or another named thing.
    pub fn about(subject: impl fmt::Display, reason: impl fmt::Display) -> Self {
        Self(format!("{subject}: {reason}"))
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Fault {}
