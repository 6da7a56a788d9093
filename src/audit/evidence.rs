//! Evidence that was measured earlier and is kept in `evidence/`: the state of the sources that it speaks
//! of, and whether that is still their state.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::{Fault, Tree, digest};

/// What evidence was measured on.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize, JsonSchema)]
pub struct State {
    /// The commit; for people, the digests decide.
    #[serde(default)]
    pub commit: Option<String>,
    /// The digest of each folder or file that matters.
    #[serde(default)]
    pub sources: BTreeMap<String, String>,
}

impl State {
    /// The present state of some folders or files.
    ///
    /// # Errors
    /// Names the folder or file that cannot be read.
    pub fn of(tree: &Tree, paths: &[impl AsRef<str>]) -> Result<Self, Fault> {
        let digest = |path: &str| {
            let digest = digest::of_path(&tree.root, path).map_err(|error| Fault::about(path, error))?;
            Ok((path.to_owned(), digest))
        };
        let sources = paths.iter().map(|path| digest(path.as_ref())).collect::<Result<_, Fault>>()?;
        Ok(Self { commit: tree.revision.commit(), sources })
    }

    /// Whether the folders and files are still as they were.
    #[must_use]
    pub fn freshness(&self, tree: &Tree) -> Freshness {
        if self.sources.is_empty() {
            return Freshness::Unknown;
        }
        let changed = self
            .sources
            .iter()
            .filter(|(path, then)| digest::of_path(&tree.root, path).ok().as_ref() != Some(then));
        match changed.map(|(path, _)| path.clone()).collect::<Vec<_>>() {
            changed if changed.is_empty() => Freshness::Present,
            changed => Freshness::Past { changed },
        }
    }
}

/// Whether evidence speaks of the present sources.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, JsonSchema)]
#[serde(tag = "measured_on", rename_all = "snake_case")]
pub enum Freshness {
    /// Of the present ones.
    Present,
    /// Of an earlier state of some folders or files.
    Past {
        /// What has changed since.
        changed: Vec<String>,
    },
    /// It does not say of which.
    Unknown,
}

impl Freshness {
    /// In words; nothing when there is nothing to remark.
    #[must_use]
    pub fn remark(&self) -> Option<String> {
        match self {
            Self::Present => None,
            Self::Past { changed } => Some(format!("measured on another state of {}", changed.join(", "))),
            Self::Unknown => Some("does not say on which state of the sources it was measured".to_owned()),
        }
    }
}

/// Reads an evidence file; nothing if it is missing.
///
/// # Errors
/// Names the file when it is there and has not the form that it should have.
pub fn read<T: DeserializeOwned>(tree: &Tree, file: &str) -> Result<Option<T>, Fault> {
    let text = tree.read_if_there(file)?;
    text.map(|text| serde_json::from_str(&text).map_err(|error| Fault::about(file, error))).transpose()
}
