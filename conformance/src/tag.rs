//! Where a case comes from and what it depends on.

use serde::{Deserialize, Serialize};

/// Where a case comes from and what it depends on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Flag {
    /// The program is a worked example of the manual.
    ManualExample,
    /// Misprints of the program or of its explanation were repaired.
    Repaired,
    /// The manual prints figures or single words, from which the program was built.
    Constructed,
    /// Blocks or words were added to establish a state, to show a result or to end the program.
    Completed,
    /// The expected trace names a reading that the set-up can switch.
    Reading,
    /// The program was generated, and the expected trace is that of the reference semantics.
    Generated,
}
