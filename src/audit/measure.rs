//! What the audit measures itself: every example and every conformance case on the oracle and on the engine.

use std::collections::BTreeSet;

use turnspec_conformance::Case;
use turnspec_oracle::book::{Example, RuleText};
use turnspec_oracle::vocabulary::notation::Expectation;
use turnspec_oracle::vocabulary::{Event, RuleId, Setup};

use super::{Fault, Tree};
use crate::{differential, engine};

/// A conformance case and what both implementations made of it.
#[derive(Clone, Debug)]
pub struct MeasuredCase {
    /// The case.
    pub case: Case,
    /// The file, relative to the tree.
    pub file: String,
    /// What came out.
    pub outcome: Outcome,
}

/// What both implementations made of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Outcome {
    /// Where the oracle diverges from the expectation.
    pub oracle: Result<(), String>,
    /// Where the engine diverges from the expectation.
    pub engine: Result<(), String>,
    /// Where the two differ from each other.
    pub agreement: Result<(), String>,
    /// The rules that the oracle's events cite.
    pub cited: BTreeSet<RuleId>,
}

impl Outcome {
    /// Whether both are as expected and agree.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.oracle.is_ok() && self.engine.is_ok() && self.agreement.is_ok()
    }

    fn of(program: &[u8], setup: &Setup, expected: impl Fn(&[Event]) -> Result<(), String>) -> Self {
        let (mut reference, mut fast) = (Vec::new(), Vec::new());
        turnspec_oracle::run(program, setup, &mut |event: &Event| reference.push(*event));
        engine::run(program, setup, &mut |event: &Event| fast.push(*event));
        let agreement = differential::compare(program, setup);
        Self {
            oracle: expected(&reference),
            engine: expected(&fast),
            agreement: agreement.map(|_| ()).map_err(|disagreement| disagreement.to_string()),
            cited: reference.iter().flat_map(|event| event.rules.as_slice()).copied().collect(),
        }
    }

    /// A program that cannot run fails everywhere.
    fn unable(reason: &str) -> Self {
        let failed = || Err(reason.to_owned());
        Self { oracle: failed(), engine: failed(), agreement: failed(), cited: BTreeSet::new() }
    }
}

/// Runs the examples of a rule.
#[must_use]
pub fn examples(rule: &RuleText) -> Vec<Outcome> {
    rule.examples.iter().map(example).collect()
}

fn example(example: &Example) -> Outcome {
    match example.setup() {
        Ok(setup) => {
            Outcome::of(&example.program, &setup, |trace| Expectation::parse(&example.trace).matches(trace))
        }
        Err(error) => Outcome::unable(&error.to_string()),
    }
}

/// Reads and runs every conformance case of the tree.
///
/// # Errors
/// Names the file that is no case.
pub fn cases(tree: &Tree) -> Result<Vec<MeasuredCase>, Fault> {
    let files = tree.below("conformance/cases", "json")?;
    files.into_iter().map(|file| case(tree, file)).collect()
}

fn case(tree: &Tree, file: String) -> Result<MeasuredCase, Fault> {
    let case: Case = serde_json::from_str(&tree.read(&file)?).map_err(|error| Fault::about(&file, error))?;
    let outcome = match case.setup() {
        Ok(setup) => Outcome::of(case.program.as_bytes(), &setup, |trace| case.check(trace)),
        Err(error) => Outcome::unable(&error.to_string()),
    };
    Ok(MeasuredCase { case, file, outcome })
}

/// The G and M codes of up to three digits that end a program in `not_modelled`.
#[must_use]
pub fn not_modelled() -> Vec<String> {
    let codes =
        ['G', 'M'].into_iter().flat_map(|letter| (0..1000).map(move |code| format!("{letter}{code:02}")));
    codes.filter(|code| is_not_modelled(code)).collect()
}

fn is_not_modelled(code: &str) -> bool {
    let mut found = false;
    turnspec_oracle::run(format!("{code}\n").as_bytes(), &Setup::default(), &mut |event: &Event| {
        found |= matches!(event.action, turnspec_oracle::vocabulary::Action::Alarm(alarm)
            if alarm.name == turnspec_oracle::vocabulary::AlarmName::NotModelled);
    });
    found
}
