//! Mutants of the oracle and of the engine's arithmetic: the outcomes of cargo-mutants and of `mutation/`, condensed into `evidence/mutants.json`, and the
//! reasons why survivors are no missing examples, in `evidence/survivors.toml`.
//!
//! The outcomes of a file stand as long as the file does: examples and tests are only ever added, so that what one of
//! them caught stays caught. A run therefore tries the files that have changed since, and adds to what is kept.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::evidence::{self, State};
use super::{Fault, Tree, files};

/// What is mutated (`.cargo/mutants.toml`).
const SOURCES: [&str; 2] = ["spec/src", "src/engine/arithmetic"];
/// The source that is not mutated: JSON Schemas (`.cargo/mutants.toml`).
const EXCLUDED: &str = "spec/src/vocabulary/schema.rs";
const FILE: &str = "evidence/mutants.json";
const REASONS: &str = "evidence/survivors.toml";

/// A run of cargo-mutants.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The files of which mutants have been tried, as they were then.
    pub state: State,
    /// How many mutants of such a file are left to be tried, where any are.
    #[serde(default)]
    pub left: BTreeMap<String, usize>,
    /// Name and version of the tool.
    pub tool: String,
    /// The mutants, in the order of their names.
    pub mutants: Vec<Mutant>,
}

/// A changed place of a source and what the tests said about it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mutant {
    /// The name that cargo-mutants gives it: file, line, column, change, function.
    pub name: String,
    /// The function, with its type and without parameters, such as `Frame::new`; empty outside of functions.
    pub function: String,
    /// What the tests said.
    pub outcome: Outcome,
}

/// What the tests said about a mutant.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// A test failed.
    Caught,
    /// Every test passed.
    Missed,
    /// The tests did not come to an end in time.
    Timeout,
    /// It does not compile.
    Unviable,
}

impl Mutant {
    /// The file that it changes.
    #[must_use]
    pub fn file(&self) -> &str {
        file_of(&self.name)
    }
}

/// The file in the name of a mutant.
fn file_of(name: &str) -> &str {
    name.split(':').next().unwrap_or_default()
}

impl Run {
    /// The sources of which no mutant has been tried in their present state.
    ///
    /// # Errors
    /// When a source cannot be read.
    pub fn untried(&self, tree: &Tree) -> Result<Vec<String>, Fault> {
        let current = State::of(tree, &sources(tree)?)?;
        let changed = |(file, digest): &(String, String)| self.state.sources.get(file) != Some(digest);
        Ok(current.sources.into_iter().filter(changed).map(|(file, _)| file).collect())
    }

    /// The sources of which not every mutant has been tried in their present state.
    ///
    /// # Errors
    /// When a source cannot be read.
    pub fn unfinished(&self, tree: &Tree) -> Result<Vec<String>, Fault> {
        let mut sources = self.untried(tree)?;
        sources.extend(self.left.keys().cloned());
        sources.sort();
        sources.dedup();
        Ok(sources)
    }

    /// As JSON, a line a mutant.
    ///
    /// # Errors
    /// When something cannot be written as JSON.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        let mutants = self.mutants.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>()?;
        Ok(format!(
            "{{\n\"state\": {},\n\"left\": {},\n\"tool\": {},\n\"mutants\": [\n{}\n]\n}}",
            serde_json::to_string_pretty(&self.state)?,
            serde_json::to_string_pretty(&self.left)?,
            serde_json::to_string(&self.tool)?,
            mutants.join(",\n")
        ))
    }
}

/// What a run says of the present sources, and what is said about its survivors.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Judged {
    /// The run, without the mutants of files that have changed since.
    pub run: Run,
    /// The sources of which no mutant has been tried in their present state.
    pub untried: Vec<String>,
    /// Why a survivor changes nothing that a program could observe, by its name.
    pub reasons: BTreeMap<String, String>,
    /// Reasons for mutants of tried sources that did not survive, or are not there.
    pub idle_reasons: Vec<String>,
}

impl Judged {
    /// The survivors without a reason.
    pub fn unexplained(&self) -> impl Iterator<Item = &Mutant> {
        self.survivors().filter(|mutant| !self.reasons.contains_key(&mutant.name))
    }

    /// The mutants that no test caught.
    pub fn survivors(&self) -> impl Iterator<Item = &Mutant> {
        self.run.mutants.iter().filter(|mutant| mutant.outcome == Outcome::Missed)
    }

    /// How many mutants of the sources that were tried are left.
    #[must_use]
    pub fn left(&self) -> usize {
        self.run.left.values().sum()
    }

    /// How many had this outcome.
    #[must_use]
    pub fn count(&self, outcome: Outcome) -> usize {
        self.run.mutants.iter().filter(|mutant| mutant.outcome == outcome).count()
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Reasons {
    #[serde(default)]
    survivor: Vec<Reason>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Reason {
    mutant: String,
    reason: String,
}

/// The condensed run as it is kept, whatever sources it speaks of.
///
/// # Errors
/// Names the file when it has not the form that it should have.
pub fn kept(tree: &Tree) -> Result<Option<Run>, Fault> {
    evidence::read(tree, FILE)
}

/// Reads the condensed run and the reasons; nothing if no run is kept.
///
/// # Errors
/// Names the file that has not the form that it should have.
pub fn read(tree: &Tree) -> Result<Option<Judged>, Fault> {
    let Some(mut run) = kept(tree)? else { return Ok(None) };
    let untried = run.untried(tree)?;
    run.mutants.retain(|mutant| !untried.iter().any(|file| file == mutant.file()));
    run.left.retain(|file, _| !untried.contains(file));
    let text = tree.read_if_there(REASONS)?.unwrap_or_default();
    let reasons: Reasons = toml::from_str(&text).map_err(|error| Fault::about(REASONS, error))?;
    let survived = |name: &str| {
        run.mutants.iter().any(|mutant| mutant.name == name && mutant.outcome == Outcome::Missed)
    };
    // Of a source with mutants left a reason may be that of one of them.
    let unjudged = |name: &str| {
        let file = file_of(name);
        let tried = run.mutants.iter().any(|mutant| mutant.name == name);
        untried.iter().any(|other| other == file) || (run.left.contains_key(file) && !tried)
    };
    let judged = reasons.survivor.into_iter().filter(|reason| !unjudged(&reason.mutant));
    let (reasons, idle): (Vec<_>, Vec<_>) = judged.partition(|reason| survived(&reason.mutant));
    Ok(Some(Judged {
        run,
        untried,
        reasons: reasons.into_iter().map(|each| (each.mutant, each.reason)).collect(),
        idle_reasons: idle.into_iter().map(|each| each.mutant).collect(),
    }))
}

/// The sources that are mutated.
///
/// # Errors
/// When a folder cannot be read.
pub fn sources(tree: &Tree) -> Result<Vec<String>, Fault> {
    let mut sources = Vec::new();
    for folder in SOURCES {
        sources.extend(files::below(&tree.root, folder).map_err(|error| Fault::about(folder, error))?);
    }
    sources.retain(|file| file.ends_with(".rs") && file != EXCLUDED);
    Ok(sources)
}

/// Adds the outcomes of one or several runs of cargo-mutants on the present sources, such as the shards of one, to what
/// is kept. `state` is that of [`sources`], `lists` what `cargo mutants --list --json` says of each package. Kept is what belongs to the mutants
/// of the list, of files that have not changed since.
///
/// # Errors
/// Names the first thing that is not as cargo-mutants writes it.
pub fn condense(
    kept: Option<Run>,
    outcomes: &[String],
    lists: &[String],
    mut state: State,
) -> Result<Run, Fault> {
    let (mut known, mut version) = (BTreeMap::new(), String::new());
    if let Some(kept) = kept {
        let fresh = |mutant: &Mutant| {
            let then = kept.state.sources.get(mutant.file());
            then.is_some() && then == state.sources.get(mutant.file())
        };
        known.extend(
            kept.mutants.iter().filter(|mutant| fresh(mutant)).map(|each| (each.name.clone(), each.clone())),
        );
        version = kept.tool;
    }
    for text in outcomes {
        let fault = |reason: String| Fault::about("outcomes.json", reason);
        let value: Value = serde_json::from_str(text).map_err(|error| fault(error.to_string()))?;
        if let Some(of) = value["cargo_mutants_version"].as_str() {
            version = format!("cargo-mutants {of}");
        }
        let list = value["outcomes"].as_array().ok_or_else(|| fault("no `outcomes`".to_owned()))?;
        for outcome in list.iter().filter(|outcome| outcome["scenario"].is_object()) {
            let read =
                mutant(outcome).ok_or_else(|| fault(format!("not a mutant: {}", outcome["scenario"])))?;
            known.insert(read.name.clone(), read);
        }
    }
    let mut listed: Vec<Listed> = Vec::new();
    for list in lists {
        let of: Vec<Listed> = serde_json::from_str(list).map_err(|error| Fault::about("list", error))?;
        listed.extend(of);
    }
    let mut names: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for each in &listed {
        names.entry(&each.file).or_default().insert(&each.name);
    }
    let mut left = BTreeMap::new();
    for (file, names) in &names {
        match names.iter().filter(|name| !known.contains_key(**name)).count() {
            0 => {}
            count if count == names.len() => _ = state.sources.remove(*file),
            count => _ = left.insert((*file).to_owned(), count),
        }
    }
    let listed: BTreeSet<&str> = names.values().flatten().copied().collect();
    let mutants = known.into_values().filter(|mutant| listed.contains(mutant.name.as_str())).collect();
    Ok(Run { state, left, tool: version, mutants })
}

/// A mutant as cargo-mutants lists it.
#[derive(Deserialize)]
struct Listed {
    name: String,
    file: String,
}

fn mutant(outcome: &Value) -> Option<Mutant> {
    let mutant = &outcome["scenario"]["Mutant"];
    let text = |value: &Value| value.as_str().map(str::to_owned);
    Some(Mutant {
        name: text(&mutant["name"])?,
        function: plain(mutant["function"]["function_name"].as_str().unwrap_or_default()),
        outcome: match outcome["summary"].as_str()? {
            "CaughtMutant" => Outcome::Caught,
            "MissedMutant" => Outcome::Missed,
            "Timeout" => Outcome::Timeout,
            "Unviable" => Outcome::Unviable,
            _ => return None,
        },
    })
}

/// `Frame::new` of `Frame<'a>::new`, `Label::fmt` of `<impl fmt::Display for Label>::fmt`.
fn plain(function: &str) -> String {
    let (of, name) = function.rsplit_once("::").unwrap_or(("", function));
    let of = of.strip_prefix("<impl ").and_then(|of| of.strip_suffix('>')).unwrap_or(of);
    let of = of.rsplit_once(" for ").map_or(of, |(_, of)| of);
    let of = of.split('<').next().unwrap_or_default();
    let of = of.rsplit("::").next().unwrap_or_default();
    if of.is_empty() { name.to_owned() } else { format!("{of}::{name}") }
}

#[cfg(test)]
mod tests {
    use super::{Mutant, Outcome, Run, State, condense, plain};

    #[test]
    fn functions_lose_their_parameters() {
        for (full, short) in [
            ("Reader<'a>::fault", "Reader::fault"),
            ("<impl fmt::Display for RuleId>::fmt", "RuleId::fmt"),
            ("<impl From<u8> for a::B<'_>>::from", "B::from"),
            ("check", "check"),
            ("", ""),
        ] {
            assert_eq!(plain(full), short);
        }
    }

    /// Outcomes as cargo-mutants writes them: name and summary.
    fn outcomes(each: &[(&str, &str)]) -> String {
        let outcome = |(name, summary): &(&str, &str)| {
            format!(
                "{{\"scenario\":{{\"Mutant\":{{\"name\":\"{name}\",\"function\":null}}}},\"summary\":\"{summary}\"}}"
            )
        };
        format!(
            "{{\"outcomes\":[{{\"scenario\":\"Baseline\",\"summary\":\"Success\"}},{}],\"cargo_mutants_version\":\"27\"}}",
            each.iter().map(outcome).collect::<Vec<_>>().join(",")
        )
    }

    /// A list as cargo-mutants writes it.
    fn list(names: &[&str]) -> String {
        let each = |name: &&str| format!("{{\"name\":\"{name}\",\"file\":\"{}\"}}", &name[..4]);
        format!("[{}]", names.iter().map(each).collect::<Vec<_>>().join(","))
    }

    fn state(sources: &[(&str, &str)]) -> State {
        let pairs = sources.iter().map(|(file, digest)| ((*file).to_owned(), (*digest).to_owned()));
        State { commit: None, sources: pairs.collect() }
    }

    fn names(run: &Run) -> Vec<(&str, Outcome)> {
        run.mutants.iter().map(|mutant| (mutant.name.as_str(), mutant.outcome)).collect()
    }

    #[test]
    fn outcomes_are_condensed_in_order() {
        let text = outcomes(&[("b.rs:1:2: c", "MissedMutant"), ("a.rs:1:2: c", "Timeout")]);
        let sources = state(&[("a.rs", "1"), ("b.rs", "1")]);
        let run = condense(None, &[text], &[list(&["a.rs:1:2: c"]), list(&["b.rs:1:2: c"])], sources)
            .expect("outcomes");
        assert_eq!(names(&run), [("a.rs:1:2: c", Outcome::Timeout), ("b.rs:1:2: c", Outcome::Missed)]);
        assert_eq!(run.mutants[0].file(), "a.rs");
        let read: Run = serde_json::from_str(&run.json().expect("JSON")).expect("the same shape");
        assert_eq!(read, run);
        for broken in ["{}", "["] {
            assert!(condense(None, &[broken.to_owned()], &[], State::default()).is_err());
        }
    }

    #[test]
    fn outcomes_are_added_to_those_of_unchanged_files() {
        let kept = Run {
            state: state(&[("a.rs", "1"), ("b.rs", "1"), ("c.rs", "1")]),
            left: [("c.rs".to_owned(), 2)].into(),
            tool: "cargo-mutants 27".to_owned(),
            mutants: ["a.rs:1", "a.rs:2", "b.rs:1", "c.rs:1"]
                .map(|name| mutant(name, Outcome::Missed))
                .to_vec(),
        };
        // b.rs has changed; c.rs has a mutant that was never tried; the second mutant of a.rs is tried again;
        // d.rs has no mutants, none of e.rs was tried.
        let text = outcomes(&[("a.rs:2", "CaughtMutant"), ("b.rs:1", "CaughtMutant")]);
        let all = list(&["a.rs:1", "a.rs:2", "b.rs:1", "c.rs:1", "c.rs:2", "e.rs:1"]);
        let now = state(&[("a.rs", "1"), ("b.rs", "2"), ("c.rs", "1"), ("d.rs", "1"), ("e.rs", "1")]);
        let run = condense(Some(kept), &[text], &[all], now).expect("outcomes");
        assert_eq!(
            names(&run),
            [
                ("a.rs:1", Outcome::Missed),
                ("a.rs:2", Outcome::Caught),
                ("b.rs:1", Outcome::Caught),
                ("c.rs:1", Outcome::Missed),
            ]
        );
        assert_eq!(run.state, state(&[("a.rs", "1"), ("b.rs", "2"), ("c.rs", "1"), ("d.rs", "1")]));
        assert_eq!(run.left, [("c.rs".to_owned(), 1)].into());
    }

    fn mutant(name: &str, outcome: Outcome) -> Mutant {
        Mutant { name: name.to_owned(), function: String::new(), outcome }
    }
}
