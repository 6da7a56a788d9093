//! Everything that is known about a tree: what the sources say, what the audit measures, what was measured
//! earlier.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_oracle::book::{self, RuleText};
use turnspec_oracle::vocabulary::RuleId;

use super::citations::{self, Place};
use super::coverage::{self, Coverage};
use super::measure::{self, MeasuredCase, Outcome};
use super::mutants::{self, Judged, Mutant};
use super::packages::{self, Package};
use super::planted::{self, Planted};
use super::statements::{self, Statement};
use super::{Fault, Tree, evidence};

/// What in the oracle's sources only carries rule ids and decides nothing.
const ORACLE_PASSED_OVER: &[&str] = &["spec/src/vocabulary/", "spec/src/book.rs"];

/// Everything that is known about a tree.
#[derive(Debug)]
pub struct Gathered {
    /// The rules, in the order of the book, each with the outcomes of its examples.
    pub rules: Vec<(RuleText, Vec<Outcome>)>,
    /// The conformance cases.
    pub cases: Vec<MeasuredCase>,
    /// Where the oracle cites each rule.
    pub oracle: BTreeMap<RuleId, Vec<Place>>,
    /// Where the engine cites each rule.
    pub engine: BTreeMap<RuleId, Vec<Place>>,
    /// The properties.
    pub properties: Vec<Statement>,
    /// The theorems.
    pub proofs: Vec<Statement>,
    /// The mutants of the oracle and of the engine's arithmetic, if they were ever counted.
    pub mutants: Option<Judged>,
    /// The coverage, if it was ever measured.
    pub coverage: Option<Coverage>,
    /// The planted bugs, if they were ever hunted.
    pub planted: Option<Planted>,
    /// The packages of the lock file.
    pub packages: Vec<Package>,
    /// The codes that are not modelled.
    pub not_modelled: Vec<String>,
}

impl Gathered {
    /// Reads and measures everything.
    ///
    /// # Errors
    /// Names the first file that has not the form that it should have.
    pub fn from(tree: &Tree) -> Result<Self, Fault> {
        let rules = book::e100l().map_err(|error| Fault::about("rule texts", error))?;
        Ok(Self {
            oracle: citations::scan(tree, "spec/src", ORACLE_PASSED_OVER)?,
            engine: citations::scan(tree, "src/engine", &["src/engine/tests"])?,
            properties: statements::properties(tree)?,
            proofs: statements::proofs(tree)?,
            mutants: mutants::read(tree)?,
            coverage: evidence::read(tree, coverage::FILE)?,
            planted: planted::read(tree)?,
            packages: packages::read(tree)?,
            cases: measure::cases(tree)?,
            rules: rules.into_iter().map(measured).collect(),
            not_modelled: measure::not_modelled(),
        })
    }

    /// The rules that a trace of an example or of a case cites.
    #[must_use]
    pub fn exercised(&self) -> BTreeSet<RuleId> {
        let examples = self.rules.iter().flat_map(|(_, outcomes)| outcomes);
        let outcomes = examples.chain(self.cases.iter().map(|case| &case.outcome));
        outcomes.flat_map(|outcome| &outcome.cited).copied().collect()
    }

    /// The mutants in the functions that cite a rule, of the oracle and of the engine's arithmetic.
    #[must_use]
    pub fn mutants_of(&self, rule: RuleId) -> Vec<&Mutant> {
        let Some(judged) = &self.mutants else { return Vec::new() };
        let places = || [self.oracle.get(&rule), self.engine.get(&rule)].into_iter().flatten().flatten();
        let concerns = |mutant: &&Mutant| {
            !mutant.function.is_empty()
                && places().any(|place| place.file == mutant.file() && place.item == mutant.function)
        };
        judged.run.mutants.iter().filter(concerns).collect()
    }

    /// The rules that a function of the oracle cites.
    #[must_use]
    pub fn rules_in(&self, file: &str, function: &str) -> Vec<RuleId> {
        let here = |places: &[Place]| places.iter().any(|place| place.file == file && place.item == function);
        self.oracle.iter().filter(|(_, places)| here(places)).map(|(rule, _)| *rule).collect()
    }
}

fn measured(rule: RuleText) -> (RuleText, Vec<Outcome>) {
    let outcomes = measure::examples(&rule);
    (rule, outcomes)
}
