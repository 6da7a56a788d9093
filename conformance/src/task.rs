//! What an implementation under test reads: one case as a JSON object.

use serde::{Deserialize, Serialize};
use turnspec_oracle::vocabulary::{Control, Setup};

/// Version of the rules for running (`PROTOCOL.md`).
pub const PROTOCOL: u32 = 1;

/// A program to run on a set-up.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Task {
    /// Version of the rules for running.
    pub protocol: u32,
    /// Name of the case.
    pub id: String,
    /// The control that runs the program.
    pub control: Control,
    /// The program, one character a byte.
    pub program: String,
    /// The complete set-up.
    pub setup: Setup,
}

impl Task {
    /// The task of running a program on a valid set-up.
    #[must_use]
    pub fn new(id: &str, program: &[u8], setup: &Setup) -> Self {
        Self {
            protocol: PROTOCOL,
            id: id.to_owned(),
            control: setup.control,
            program: text_of_bytes(program),
            setup: setup.clone(),
        }
    }

    /// The bytes of the program; `None` when it has a character above U+00FF.
    #[must_use]
    pub fn program_bytes(&self) -> Option<Vec<u8>> {
        bytes_of_text(&self.program)
    }
}

/// One character a byte, U+0000 to U+00FF.
#[must_use]
pub fn text_of_bytes(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

/// One byte a character; `None` when there is one above U+00FF.
#[must_use]
pub fn bytes_of_text(text: &str) -> Option<Vec<u8>> {
    text.chars().map(|each| u8::try_from(each).ok()).collect()
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::Setup;

    use super::{Task, bytes_of_text, text_of_bytes};

    #[test]
    fn every_byte_survives() {
        let bytes: Vec<u8> = (0..=255).collect();
        assert_eq!(bytes_of_text(&text_of_bytes(&bytes)), Some(bytes));
        assert_eq!(bytes_of_text("€"), None);
    }

    #[test]
    fn a_task_reads_back() -> Result<(), serde_json::Error> {
        let task = Task::new("e100l/a", b"G00 X1\xFF\n", &Setup::default());
        let text = serde_json::to_string(&task)?;
        assert_eq!(serde_json::from_str::<Task>(&text)?, task);
        assert_eq!(task.program_bytes().as_deref(), Some(&b"G00 X1\xFF\n"[..]));
        Ok(())
    }
}
