//! The rule table for machines: rule, text, functions, examples, cases, properties, proofs, mutants; as JSON,
//! with a schema.

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, SchemaGenerator};
use serde::Serialize;
use turnspec_oracle::book::RuleText;

use super::citations::Place;
use super::coverage::{Figures, MEASURED};
use super::evidence::Freshness;
use super::gather::Gathered;
use super::measure::Outcome;
use super::mutants;
use super::summary::{Finding, findings};
use super::{Revision, Tree};

/// Version of the matrix and its schema. A change that old readers do not survive raises the first number
/// (before 1.0 the second), an addition the second, a better description the third.
const VERSION: &str = "0.1.0";

/// The rule table of a tree.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Matrix {
    /// Version of this shape.
    pub version: &'static str,
    /// The commit of the tree; `null` when it is unknown.
    pub commit: Option<String>,
    /// The files that differ from the commit, with git's two letters in front.
    pub changed: Vec<String>,
    /// What holds, what does not, and what was not measured.
    pub findings: Vec<Finding>,
    /// Coverage of the sources by the tests; `null` when it was never measured.
    pub coverage: Option<CoverageRecord>,
    /// The run that the mutants were counted in; `null` when they never were.
    pub mutants: Option<MutantsRecord>,
    /// The rules, in the order of the book.
    pub rules: Vec<Row>,
}

/// The run that the mutants were counted in.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MutantsRecord {
    /// The sources of which no mutant has been tried in their present state.
    pub untried: Vec<String>,
    /// How many mutants of the other ones are left to be tried.
    pub left: usize,
}

/// Coverage of the sources by the tests.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CoverageRecord {
    /// On what it was measured.
    pub freshness: Freshness,
    /// The oracle, `spec/src`.
    pub oracle: Figures,
    /// The engine, `src/engine`.
    pub engine: Figures,
}

/// A rule and its evidence.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// Permanent id.
    pub id: String,
    /// Title.
    pub title: String,
    /// Subject, the middle of the id.
    pub area: String,
    /// `core`, `option` or `listed`.
    pub level: String,
    /// `manual`, `interpretation` or `unspecified`.
    pub basis: String,
    /// Place in the manual.
    pub source: String,
    /// The alarms that it demands.
    pub alarms: Vec<String>,
    /// Where its text stands, as `file:line`.
    pub text: String,
    /// Where the oracle cites it.
    pub oracle: Vec<Place>,
    /// Where the engine cites it.
    pub engine: Vec<Place>,
    /// Its examples.
    pub examples: Vec<Check>,
    /// The conformance cases that are about it.
    pub cases: Vec<Check>,
    /// Whether the trace of any example or case, of this rule or another, cites it.
    pub exercised: bool,
    /// Names of the properties that support it, as `file:line name`.
    pub properties: Vec<String>,
    /// Names of the theorems that support it, as `file:line name`.
    pub proofs: Vec<String>,
    /// Mutants of the functions of the oracle that cite it; `null` when they were never counted.
    pub mutants: Option<MutantCounts>,
    /// Names of the planted bugs that break it, and whether each was found within its bound.
    pub planted: Vec<PlantedRecord>,
}

/// A program that both implementations ran during the audit.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// Name of the case, or place of the example as `file:line`.
    pub name: String,
    /// Whether the oracle's trace is as expected.
    pub oracle: bool,
    /// Whether the engine's trace is as expected.
    pub engine: bool,
    /// Whether the two agree, event by event.
    pub agree: bool,
}

/// Mutants by what the tests said about them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MutantCounts {
    /// A test failed.
    pub caught: usize,
    /// Every test passed, and nothing says why that is right.
    pub missed: usize,
    /// Every test passed, and there is a reason.
    pub explained: usize,
    /// The tests did not come to an end.
    pub timeout: usize,
}

/// A planted bug.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlantedRecord {
    /// Its name.
    pub bug: String,
    /// Whether it was found within its bound.
    pub found: bool,
}

impl Matrix {
    /// The table of what was gathered.
    #[must_use]
    pub fn of(tree: &Tree, gathered: &Gathered) -> Self {
        let (commit, changed) = match &tree.revision {
            Revision::Commit { id, changed } => (Some(id.clone()), changed.clone()),
            Revision::Unknown { .. } => (None, Vec::new()),
        };
        let [oracle, engine] = MEASURED;
        Self {
            version: VERSION,
            commit,
            changed,
            findings: findings(tree, gathered),
            coverage: gathered.coverage.as_ref().map(|coverage| CoverageRecord {
                freshness: coverage.state.freshness(tree),
                oracle: coverage.of(oracle),
                engine: coverage.of(engine),
            }),
            mutants: gathered
                .mutants
                .as_ref()
                .map(|judged| MutantsRecord { untried: judged.untried.clone(), left: judged.left() }),
            rules: rows(gathered),
        }
    }
}

fn rows(gathered: &Gathered) -> Vec<Row> {
    let exercised = gathered.exercised();
    let row = |(rule, outcomes): &(RuleText, Vec<Outcome>)| Row {
        id: rule.id.to_string(),
        title: rule.title.clone(),
        area: area(rule).to_owned(),
        level: rule.level.clone(),
        basis: rule.basis.clone(),
        source: rule.source.clone(),
        alarms: rule.alarms.iter().map(ToString::to_string).collect(),
        text: format!("spec/rules/{}:{}", rule.file, rule.line),
        oracle: gathered.oracle.get(&rule.id).cloned().unwrap_or_default(),
        engine: gathered.engine.get(&rule.id).cloned().unwrap_or_default(),
        examples: rule
            .examples
            .iter()
            .zip(outcomes)
            .map(|(example, outcome)| check(format!("spec/rules/{}:{}", rule.file, example.line), outcome))
            .collect(),
        cases: gathered
            .cases
            .iter()
            .filter(|case| case.case.rules.contains(&rule.id))
            .map(|case| check(case.case.id.clone(), &case.outcome))
            .collect(),
        exercised: exercised.contains(&rule.id),
        properties: supporting(&gathered.properties, rule),
        proofs: supporting(&gathered.proofs, rule),
        mutants: counts(gathered, rule),
        planted: planted(gathered, rule),
    };
    gathered.rules.iter().map(row).collect()
}

/// `G50` of `E100L-G50-02`.
#[must_use]
pub fn area(rule: &RuleText) -> &'static str {
    rule.id.as_str().split('-').nth(1).unwrap_or_default()
}

fn check(name: String, outcome: &Outcome) -> Check {
    Check {
        name,
        oracle: outcome.oracle.is_ok(),
        engine: outcome.engine.is_ok(),
        agree: outcome.agreement.is_ok(),
    }
}

fn supporting(statements: &[super::statements::Statement], rule: &RuleText) -> Vec<String> {
    let supports = statements.iter().filter(|statement| statement.rules.contains(&rule.id));
    supports.map(|statement| format!("{}:{} {}", statement.file, statement.line, statement.name)).collect()
}

fn counts(gathered: &Gathered, rule: &RuleText) -> Option<MutantCounts> {
    let judged = gathered.mutants.as_ref()?;
    let mut counts = MutantCounts::default();
    for mutant in gathered.mutants_of(rule.id) {
        match mutant.outcome {
            mutants::Outcome::Caught => counts.caught += 1,
            mutants::Outcome::Timeout => counts.timeout += 1,
            mutants::Outcome::Missed if judged.reasons.contains_key(&mutant.name) => counts.explained += 1,
            mutants::Outcome::Missed => counts.missed += 1,
            mutants::Outcome::Unviable => {}
        }
    }
    Some(counts)
}

fn planted(gathered: &Gathered, rule: &RuleText) -> Vec<PlantedRecord> {
    let bugs = gathered.planted.iter().flat_map(|planted| &planted.bugs);
    let breaking = bugs.filter(|bug| bug.rules.contains(&rule.id));
    breaking.map(|bug| PlantedRecord { bug: bug.bug.clone(), found: bug.found() }).collect()
}

/// How many checks hold in every respect.
#[must_use]
pub fn passed(checks: &[Check]) -> usize {
    checks.iter().filter(|check| check.oracle && check.engine && check.agree).count()
}

/// The JSON Schema of the matrix.
///
/// # Errors
/// When the schema cannot be written as JSON.
pub fn schema() -> Result<String, serde_json::Error> {
    let generator = SchemaGenerator::new(SchemaSettings::draft2020_12().for_serialize());
    let mut schema = generator.into_root_schema_for::<Matrix>();
    schema.insert("$id".to_owned(), format!("urn:turnspec:audit-matrix:{VERSION}").into());
    serde_json::to_string_pretty(&schema)
}
