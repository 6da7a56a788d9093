//! A case, read and checked: ready to be run.

use turnspec_oracle::vocabulary::Setup;

use crate::{Case, Expected, Task};

/// A case with its parts parsed.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// The case.
    pub case: Case,
    /// The bytes of its program.
    pub program: Vec<u8>,
    /// Its complete set-up.
    pub setup: Setup,
    /// Its expected trace.
    pub expected: Expected,
}

impl Exercise {
    /// Parses the parts of a case.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    pub fn new(case: Case) -> Result<Self, String> {
        let program = case.program_bytes().ok_or("`program` has a character above U+00FF")?;
        let setup = case.setup().map_err(|error| format!("`setup`: {error}"))?;
        let expected = Expected::parse(&case.expect).map_err(|error| format!("`expect`: {error}"))?;
        Ok(Self { case, program, setup, expected })
    }

    /// What an implementation reads.
    #[must_use]
    pub fn task(&self) -> Task {
        Task::new(&self.case.id, &self.program, &self.setup)
    }
}
