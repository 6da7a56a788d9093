//! How far a campaign has come, and how that is kept in a file.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::Signature;
use super::finding::Finding;
use super::judgement::{Judgement, RuleCounts};

/// Version of the file.
const VERSION: u32 = 1;
/// Its name in the directory of the campaign.
const FILE: &str = "campaign.json";

/// The state of a campaign.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Campaign {
    version: u32,
    /// Version of Turnspec: another one generates other programs.
    turnspec: String,
    /// The command that runs the implementation.
    implementation: String,
    /// The text of its declaration.
    declaration: String,
    seed: u64,
    /// Programs that were run.
    pub done: u64,
    /// Programs on which both agreed.
    pub agreed: u64,
    /// Programs that the implementation refused as beyond what it has.
    pub unsupported: u64,
    /// Programs whose divergence a waiver permits, by its reason.
    pub waived: BTreeMap<String, u64>,
    /// Disagreements, in the order in which they were met first.
    pub findings: Vec<Finding>,
    /// How many agreeing events cited each rule.
    pub(super) agreeing: RuleCounts,
    /// How many disagreements have an expected event that cites each rule.
    pub(super) disagreeing: RuleCounts,
    /// Findings whose case has its file.
    #[serde(skip)]
    saved: usize,
}

/// Why a state cannot be used or kept.
#[derive(Debug)]
pub enum StateError {
    /// A file cannot be read or written.
    File(PathBuf, io::Error),
    /// It is no state of a campaign; why.
    Damaged(PathBuf, String),
    /// It belongs to another campaign; what differs.
    Another(PathBuf, String),
}

impl fmt::Display for StateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(path, error) => write!(f, "{}: {error}", path.display()),
            Self::Damaged(path, reason) => write!(
                f,
                "{}: this is no state of a campaign ({reason}); remove it to begin anew",
                path.display()
            ),
            Self::Another(path, difference) => write!(
                f,
                "{}: this campaign {difference}; remove it, or give another directory",
                path.display()
            ),
        }
    }
}

impl std::error::Error for StateError {}

impl Campaign {
    /// A campaign at its start.
    #[must_use]
    pub fn new(implementation: &str, declaration: &str, seed: u64) -> Self {
        Self {
            version: VERSION,
            turnspec: env!("CARGO_PKG_VERSION").to_owned(),
            implementation: implementation.to_owned(),
            declaration: declaration.to_owned(),
            seed,
            done: 0,
            agreed: 0,
            unsupported: 0,
            waived: BTreeMap::new(),
            findings: Vec::new(),
            agreeing: RuleCounts::new(),
            disagreeing: RuleCounts::new(),
            saved: 0,
        }
    }

    /// The same campaign as far as a directory holds it already. A case of it whose file is gone is written again.
    ///
    /// # Errors
    /// When the state in the directory is damaged, or that of another campaign, or a case cannot be written.
    pub fn resumed(self, directory: &Path) -> Result<Self, StateError> {
        let path = directory.join(FILE);
        let text = match fs::read(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(self),
            Err(error) => return Err(StateError::File(path, error)),
        };
        let mut state: Self = match serde_json::from_slice(&text) {
            Ok(state) => state,
            Err(error) => return Err(StateError::Damaged(path, error.to_string())),
        };
        if let Some(difference) = self.difference(&state) {
            return Err(StateError::Another(path, difference));
        }
        if let Some(contradiction) = state.contradiction() {
            return Err(StateError::Damaged(path, contradiction.to_owned()));
        }
        state.saved = state.findings.len();
        state.restore(directory)?;
        Ok(state)
    }

    /// Writes the cases whose files are gone.
    fn restore(&self, directory: &Path) -> Result<(), StateError> {
        let cases = self.findings.iter().map(|finding| (directory.join(finding.file_name()), finding));
        cases.filter(|(path, _)| !path.exists()).try_for_each(|(path, finding)| write(&path, &finding.case))
    }

    /// How a saved campaign differs from this one.
    fn difference(&self, saved: &Self) -> Option<String> {
        let quoted = |what: &str, text: &str| Some(format!("{what} {text:?}"));
        if saved.version != self.version {
            return Some(format!("is of version {}", saved.version));
        }
        if saved.turnspec != self.turnspec {
            return quoted("was begun by version", &saved.turnspec);
        }
        if saved.seed != self.seed {
            return Some(format!("has seed {}", saved.seed));
        }
        if saved.implementation != self.implementation {
            return quoted("is about the implementation", &saved.implementation);
        }
        (saved.declaration != self.declaration).then(|| "has another declaration".to_owned())
    }

    /// Why the numbers of a file cannot be those of a campaign.
    fn contradiction(&self) -> Option<&'static str> {
        let disagreed = self.findings.iter().map(Finding::count);
        let mut parts = self.waived.values().copied().chain(disagreed).chain([self.agreed, self.unsupported]);
        let sum = parts.try_fold(0_u64, u64::checked_add);
        (sum != Some(self.done)).then_some("its counts do not add up")
    }

    /// How many programs disagree.
    #[must_use]
    pub fn disagreed(&self) -> u64 {
        self.findings.iter().map(Finding::count).sum()
    }

    /// Whether it has as many findings as are wanted; 0 is no limit.
    #[must_use]
    pub fn is_full(&self, max_findings: usize) -> bool {
        max_findings > 0 && self.findings.len() >= max_findings
    }

    /// How many findings are wanted still.
    pub(super) fn room(&self, max_findings: usize) -> usize {
        if max_findings == 0 { usize::MAX } else { max_findings.saturating_sub(self.findings.len()) }
    }

    /// Whether a disagreement like this was met before.
    pub(super) fn has_met(&self, signature: &Signature) -> bool {
        self.findings.iter().any(|finding| finding.met_as.iter().any(|(met, _)| met == signature))
    }

    /// Takes the result of the next run; a disagreement that was not met before comes with its finding.
    pub(super) fn take(&mut self, judgement: Judgement, finding: Option<Finding>) {
        self.done += 1;
        match judgement {
            Judgement::Agreed(rules) => {
                self.agreed += 1;
                add(&mut self.agreeing, rules);
            }
            Judgement::Unsupported => self.unsupported += 1,
            Judgement::Waived(reason) => *self.waived.entry(reason).or_default() += 1,
            Judgement::Disagreed(disagreement) => {
                add(&mut self.agreeing, disagreement.agreeing);
                for rule in &disagreement.signature.rules {
                    *self.disagreeing.entry(*rule).or_default() += 1;
                }
                self.count(&disagreement.signature, finding);
            }
        }
    }

    /// Counts a disagreement with the others of its kind. A new way in which an old finding shows itself counts
    /// with that finding.
    fn count(&mut self, signature: &Signature, finding: Option<Finding>) {
        if let Some(finding) = finding {
            match self.findings.iter_mut().find(|each| each.signature == finding.signature) {
                Some(known) => known.met_as.extend(finding.met_as),
                None => self.findings.push(finding),
            }
        }
        let mut ways = self.findings.iter_mut().flat_map(|finding| &mut finding.met_as);
        if let Some((_, count)) = ways.find(|(met, _)| met == signature) {
            *count += 1;
        }
    }

    /// Saves the new findings as cases, then the state, so that it never names a case that is not there.
    ///
    /// # Errors
    /// The file that cannot be written.
    pub fn save(&mut self, directory: &Path) -> Result<(), StateError> {
        fs::create_dir_all(directory).map_err(|error| StateError::File(directory.to_owned(), error))?;
        for finding in self.findings.get(self.saved..).unwrap_or_default() {
            write(&directory.join(finding.file_name()), &finding.case)?;
        }
        self.saved = self.findings.len();
        write(&directory.join(FILE), self)
    }
}

fn add(total: &mut RuleCounts, part: RuleCounts) {
    for (rule, count) in part {
        *total.entry(rule).or_default() += count;
    }
}

/// Writes a file whole or not at all.
fn write(path: &Path, content: &impl Serialize) -> Result<(), StateError> {
    let part = path.with_extension("part");
    let written = serde_json::to_vec_pretty(content).map_err(io::Error::from).and_then(|mut text| {
        text.push(b'\n');
        let mut file = fs::File::create(&part)?;
        file.write_all(&text)?;
        file.sync_all()?;
        fs::rename(&part, path)
    });
    written.map_err(|error| StateError::File(path.to_owned(), error))
}

#[cfg(test)]
mod tests {
    use super::{Campaign, FILE, StateError};

    #[test]
    fn only_the_same_campaign_is_resumed() -> Result<(), Box<dyn std::error::Error>> {
        let directory = std::env::temp_dir().join(format!("turnspec-campaign-state-{}", std::process::id()));
        let mut campaign = Campaign::new("lathe", "name = 'a'", 1);
        assert_eq!(campaign.clone().resumed(&directory)?, campaign);
        campaign.done = 7;
        campaign.agreed = 7;
        campaign.save(&directory)?;
        assert_eq!(Campaign::new("lathe", "name = 'a'", 1).resumed(&directory)?, campaign);
        for (other, named) in [
            (Campaign::new("lathe", "name = 'a'", 2), "seed 1"),
            (Campaign::new("mill", "name = 'a'", 1), "\"lathe\""),
            (Campaign::new("lathe", "name = 'b'", 1), "another declaration"),
        ] {
            match other.resumed(&directory) {
                Err(error @ StateError::Another(..)) => assert!(error.to_string().contains(named), "{error}"),
                result => panic!("{result:?}"),
            }
        }
        let path = directory.join(FILE);
        let text = std::fs::read_to_string(&path)?;
        for damaged in [&text[..text.len() / 2], "", "{}", &text.replace("\"agreed\": 7", "\"agreed\": 6")] {
            std::fs::write(&path, damaged)?;
            let result = Campaign::new("lathe", "name = 'a'", 1).resumed(&directory);
            assert!(matches!(result, Err(StateError::Damaged(..))), "{result:?}");
        }
        std::fs::remove_dir_all(&directory)?;
        Ok(())
    }
}
