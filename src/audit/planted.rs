//! Planted bugs: known-wrong variants of the engine that the campaigns must find, from
//! `evidence/planted.json`.

use serde::{Deserialize, Serialize};
use turnspec_oracle::vocabulary::RuleId;

use super::evidence::{self, State};
use super::{Fault, Tree};

const FILE: &str = "evidence/planted.json";

/// The folders on which the hunt depends.
pub const DEPENDS_ON: [&str; 3] = ["fuzz/generator/src", "spec/src", "src/engine"];

/// The planted bugs and the state that they were hunted on.
#[derive(Clone, PartialEq, Eq, Debug, Default, Deserialize)]
pub struct Planted {
    /// What was measured.
    #[serde(default)]
    pub state: State,
    /// The bugs.
    pub bugs: Vec<Bug>,
}

/// A planted bug.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Bug {
    /// Its name.
    pub bug: String,
    /// What is wrong.
    #[serde(default)]
    pub description: String,
    /// The rules that it breaks.
    #[serde(default)]
    pub rules: Vec<RuleId>,
    /// How many generated programs it took to find it; none when it was not found.
    #[serde(default)]
    pub programs: Option<u64>,
    /// Within how many it must be found.
    #[serde(default)]
    pub bound: Option<u64>,
}

impl Bug {
    /// Whether it was found within its bound.
    #[must_use]
    pub fn found(&self) -> bool {
        self.programs.is_some_and(|programs| self.bound.is_none_or(|bound| programs <= bound))
    }
}

/// Reads the planted bugs; nothing if none are kept.
///
/// # Errors
/// Names the file when it has not the form that it should have.
pub fn read(tree: &Tree) -> Result<Option<Planted>, Fault> {
    evidence::read(tree, FILE)
}
