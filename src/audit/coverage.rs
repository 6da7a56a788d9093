//! Coverage of the sources: what LLVM measured, condensed into `evidence/coverage.json`, a line a file.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::Fault;
use super::evidence::State;

/// The folders on which the figures depend.
pub const DEPENDS_ON: [&str; 4] = ["spec/rules", "spec/src", "spec/tests", "src/engine"];
/// The folders whose coverage counts.
pub const MEASURED: [&str; 2] = ["spec/src", "src/engine"];
/// Where it is kept.
pub const FILE: &str = "evidence/coverage.json";

/// What was reached.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Coverage {
    /// What was measured.
    pub state: State,
    /// Names and versions of the tools.
    pub tools: Vec<String>,
    /// The files.
    pub files: BTreeMap<String, Figures>,
}

/// How much of a file or folder was reached.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    /// Lines with code.
    pub lines: Share,
    /// Pieces of code that are entered together.
    pub regions: Share,
    /// Outcomes of conditions; none when the tool did not count them.
    pub branches: Option<Share>,
}

/// A part of a whole.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Share {
    /// What was reached.
    pub reached: u64,
    /// What there is.
    pub all: u64,
}

impl Share {
    fn plus(self, other: Self) -> Self {
        Self { reached: self.reached.saturating_add(other.reached), all: self.all.saturating_add(other.all) }
    }

    /// In per cent with one decimal, rounded down.
    #[must_use]
    pub fn percent(self) -> String {
        match self.reached.saturating_mul(1000).checked_div(self.all) {
            Some(tenths) => format!("{}.{} %", tenths / 10, tenths % 10),
            None => "none".to_owned(),
        }
    }
}

impl Coverage {
    /// The sum over a folder.
    #[must_use]
    pub fn of(&self, folder: &str) -> Figures {
        let inside = self
            .files
            .iter()
            .filter(|(file, _)| file.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/')));
        inside.map(|(_, figures)| *figures).reduce(Figures::plus).unwrap_or_default()
    }
}

impl Figures {
    fn plus(self, other: Self) -> Self {
        Self {
            lines: self.lines.plus(other.lines),
            regions: self.regions.plus(other.regions),
            branches: self.branches.zip(other.branches).map(|(one, two)| one.plus(two)),
        }
    }
}

/// Condenses a report of `cargo llvm-cov --json`.
///
/// # Errors
/// Names the first thing that is not as LLVM writes it.
pub fn condense(report: &str, root: &Path, state: State, tools: Vec<String>) -> Result<Coverage, Fault> {
    let fault = |reason: String| Fault::about("coverage report", reason);
    let value: Value = serde_json::from_str(report).map_err(|error| fault(error.to_string()))?;
    let list = value["data"][0]["files"].as_array().ok_or_else(|| fault("no `data[0].files`".to_owned()))?;
    let mut files = BTreeMap::new();
    let mut branches = 0;
    for entry in list {
        let name = entry["filename"].as_str().ok_or_else(|| fault("a file without name".to_owned()))?;
        let Ok(relative) = Path::new(name).strip_prefix(root) else { continue };
        let file = relative.to_string_lossy().replace('\\', "/");
        if MEASURED.iter().any(|folder| file.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/'))) {
            let share = |what: &str| {
                let figure = &entry["summary"][what];
                let share = figure["covered"].as_u64().zip(figure["count"].as_u64());
                share
                    .map(|(reached, all)| Share { reached, all })
                    .ok_or_else(|| fault(format!("{name}: no {what}")))
            };
            let figures = Figures {
                lines: share("lines")?,
                regions: share("regions")?,
                branches: share("branches").ok(),
            };
            branches += figures.branches.map_or(0, |share| share.all);
            files.insert(file, figures);
        }
    }
    if branches == 0 {
        // LLVM writes zeros when the compiler did not instrument branches.
        files.values_mut().for_each(|figures| figures.branches = None);
    }
    if files.is_empty() {
        return Err(fault(format!("no file of {} in it", MEASURED.join(" or "))));
    }
    Ok(Coverage { state, tools, files })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Figures, Share, State, condense};

    fn report(branches: u64) -> String {
        format!(
            "{{\"data\":[{{\"files\":[{{\"filename\":\"/t/spec/src/a.rs\",\"summary\":{{\"lines\":{{\"count\":10,\
             \"covered\":9}},\"regions\":{{\"count\":4,\"covered\":3}},\"branches\":{{\"count\":{branches},\
             \"covered\":0}}}}}},{{\"filename\":\"/t/src/cli/b.rs\"}},{{\"filename\":\"/usr/c.rs\"}}]}}]}}"
        )
    }

    #[test]
    fn the_files_that_count_are_condensed() {
        let root = Path::new("/t");
        let coverage = condense(&report(2), root, State::default(), Vec::new()).expect("a report");
        let lines = Share { reached: 9, all: 10 };
        let regions = Share { reached: 3, all: 4 };
        let branches = Some(Share { reached: 0, all: 2 });
        assert_eq!(coverage.of("spec/src"), Figures { lines, regions, branches });
        assert_eq!(coverage.files.len(), 1);
        assert_eq!(lines.percent(), "90.0 %");
        let without = condense(&report(0), root, State::default(), Vec::new()).expect("a report");
        assert_eq!(without.of("spec/src").branches, None);
        assert!(condense(&report(0), Path::new("/u"), State::default(), Vec::new()).is_err());
    }
}
