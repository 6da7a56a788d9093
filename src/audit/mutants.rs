//! Mutants of the oracle: the outcomes of cargo-mutants, condensed into `evidence/mutants.json`, and the
//! reasons why survivors are no missing examples, in `evidence/survivors.toml`.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::evidence::{self, State};
use super::{Fault, Tree};

/// The folders on which the outcomes depend.
pub const DEPENDS_ON: [&str; 3] = ["spec/rules", "spec/src", "spec/tests"];
const FILE: &str = "evidence/mutants.json";
const REASONS: &str = "evidence/survivors.toml";

/// A run of cargo-mutants.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// What was mutated.
    pub state: State,
    /// Name and version of the tool.
    pub tool: String,
    /// Whether the run came to its end.
    pub complete: bool,
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
        self.name.split(':').next().unwrap_or_default()
    }
}

impl Run {
    /// As JSON, a line a mutant.
    ///
    /// # Errors
    /// When something cannot be written as JSON.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        let mutants = self.mutants.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>()?;
        Ok(format!(
            "{{\n\"state\": {},\n\"tool\": {},\n\"complete\": {},\n\"mutants\": [\n{}\n]\n}}",
            serde_json::to_string(&self.state)?,
            serde_json::to_string(&self.tool)?,
            self.complete,
            mutants.join(",\n")
        ))
    }
}

/// A run and what is said about its survivors.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Judged {
    /// The run.
    pub run: Run,
    /// Why a survivor changes nothing that a program could observe, by its name.
    pub reasons: BTreeMap<String, String>,
    /// Reasons for mutants that did not survive, or are not there.
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

/// Reads the condensed run and the reasons; nothing if no run is kept.
///
/// # Errors
/// Names the file that has not the form that it should have.
pub fn read(tree: &Tree) -> Result<Option<Judged>, Fault> {
    let Some(run) = evidence::read::<Run>(tree, FILE)? else { return Ok(None) };
    let text = tree.read_if_there(REASONS)?.unwrap_or_default();
    let reasons: Reasons = toml::from_str(&text).map_err(|error| Fault::about(REASONS, error))?;
    let survived = |name: &str| {
        run.mutants.iter().any(|mutant| mutant.name == name && mutant.outcome == Outcome::Missed)
    };
    let (reasons, idle): (Vec<_>, Vec<_>) =
        reasons.survivor.into_iter().partition(|reason| survived(&reason.mutant));
    Ok(Some(Judged {
        run,
        reasons: reasons.into_iter().map(|each| (each.mutant, each.reason)).collect(),
        idle_reasons: idle.into_iter().map(|each| each.mutant).collect(),
    }))
}

/// Condenses the `outcomes.json` of one or several runs of cargo-mutants, such as the shards of one.
///
/// # Errors
/// Names the first thing that is not as cargo-mutants writes it.
pub fn condense(outcomes: &[String], state: State) -> Result<Run, Fault> {
    let (mut mutants, mut complete, mut version) = (Vec::new(), true, String::new());
    for text in outcomes {
        let fault = |reason: String| Fault::about("outcomes.json", reason);
        let value: Value = serde_json::from_str(text).map_err(|error| fault(error.to_string()))?;
        complete &= !value["end_time"].is_null();
        value["cargo_mutants_version"].as_str().unwrap_or_default().clone_into(&mut version);
        let list = value["outcomes"].as_array().ok_or_else(|| fault("no `outcomes`".to_owned()))?;
        for outcome in list.iter().filter(|outcome| outcome["scenario"].is_object()) {
            let read =
                mutant(outcome).ok_or_else(|| fault(format!("not a mutant: {}", outcome["scenario"])))?;
            mutants.push(read);
        }
    }
    mutants.sort();
    mutants.dedup();
    Ok(Run { state, tool: format!("cargo-mutants {version}"), complete, mutants })
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
    use super::{Outcome, State, condense, plain};

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

    #[test]
    fn outcomes_are_condensed_in_order() {
        let each = |name: &str, summary: &str| {
            format!(
                "{{\"scenario\":{{\"Mutant\":{{\"name\":\"{name}\",\"function\":null}}}},\"summary\":\"{summary}\"}}"
            )
        };
        let text = format!(
            "{{\"outcomes\":[{{\"scenario\":\"Baseline\",\"summary\":\"Success\"}},{},{}],\"end_time\":null,\
             \"cargo_mutants_version\":\"27\"}}",
            each("spec/src/b.rs:1:2: c", "MissedMutant"),
            each("spec/src/a.rs:1:2: c", "Timeout")
        );
        let run = condense(&[text], State::default()).expect("outcomes");
        let outcomes: Vec<_> =
            run.mutants.iter().map(|mutant| (mutant.name.as_str(), mutant.outcome)).collect();
        assert_eq!(
            outcomes,
            [("spec/src/a.rs:1:2: c", Outcome::Timeout), ("spec/src/b.rs:1:2: c", Outcome::Missed)]
        );
        assert_eq!(run.mutants[0].file(), "spec/src/a.rs");
        assert!(!run.complete);
        let read: super::Run = serde_json::from_str(&run.json().expect("JSON")).expect("the same shape");
        assert_eq!(read, run);
        assert!(condense(&["{}".to_owned()], State::default()).is_err());
        assert!(condense(&["[".to_owned()], State::default()).is_err());
    }
}
