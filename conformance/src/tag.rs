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
    /// The case is an example of a rule's text.
    RuleExample,
    /// The program was generated, and the expected trace is that of the reference semantics.
    Generated,
}

impl Flag {
    /// The name, such as `rule-example`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::ManualExample => "manual-example",
            Self::Repaired => "repaired",
            Self::Constructed => "constructed",
            Self::Completed => "completed",
            Self::Reading => "reading",
            Self::RuleExample => "rule-example",
            Self::Generated => "generated",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Flag;

    #[test]
    fn the_name_is_the_one_of_the_files() -> Result<(), serde_json::Error> {
        for flag in [
            Flag::ManualExample,
            Flag::Repaired,
            Flag::Constructed,
            Flag::Completed,
            Flag::Reading,
            Flag::RuleExample,
            Flag::Generated,
        ] {
            assert_eq!(serde_json::to_string(&flag)?, format!("\"{}\"", flag.as_str()));
        }
        Ok(())
    }
}
