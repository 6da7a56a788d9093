//! What a run over the corpus came to, as data: every report is another view of it.

mod html;
mod json;
mod junit;
mod summary;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use turnspec_oracle::vocabulary::RuleId;

use crate::Basis;

pub use html::html;
pub use json::json;
pub use junit::junit;
pub use summary::{Detail, summary};

/// The outcome of a run over a corpus.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Report {
    /// Version of the format of the report.
    pub format: String,
    /// Version of the rules for running.
    pub protocol: u32,
    /// Declared name of the implementation.
    pub implementation: String,
    /// Its declared version.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    /// The command that started it.
    pub command: String,
    /// How many cases have each verdict; verdicts without cases are left out.
    pub verdicts: BTreeMap<Ruling, usize>,
    /// Whether no verdict is a failure.
    pub success: bool,
    /// Waivers that no case needed, because it does not exist or was not run.
    pub unused_waivers: Vec<String>,
    /// How the cases about each rule went, in the order of the rules.
    pub rules: Vec<RuleSummary>,
    /// Every case, in the order of the corpus.
    pub cases: Vec<CaseReport>,
}

/// The verdict on a case, waivers included.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Ruling {
    /// Everything that is compared agrees.
    Pass,
    /// It was not run.
    Skipped,
    /// It fails and a waiver permits it.
    Waived,
    /// It passes although a waiver permits it to fail.
    StaleWaiver,
    /// The trace diverges from the expectation.
    Mismatch,
    /// Exit status 3, though every feature is declared.
    Unsupported,
    /// No trace, or one that contradicts the exit status.
    Protocol,
    /// Another exit status, or a signal.
    Crash,
    /// Not finished in time.
    TimeOut,
    /// More output than the limit.
    Flood,
}

impl Ruling {
    /// The name, such as `time-out`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Skipped => "skipped",
            Self::Waived => "waived",
            Self::StaleWaiver => "stale-waiver",
            Self::Mismatch => "mismatch",
            Self::Unsupported => "unsupported",
            Self::Protocol => "protocol",
            Self::Crash => "crash",
            Self::TimeOut => "time-out",
            Self::Flood => "flood",
        }
    }

    /// Whether it counts as a failure.
    #[must_use]
    pub fn is_failure(self) -> bool {
        !matches!(self, Self::Pass | Self::Skipped | Self::Waived)
    }
}

/// The outcome of one case.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CaseReport {
    /// Id of the case.
    pub id: String,
    /// What it shows.
    pub title: String,
    /// The rules that it is about.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<String>"))]
    pub rules: Vec<RuleId>,
    /// Place in the manual.
    pub source: String,
    /// Whether the manual settles the expected trace.
    pub basis: Basis,
    /// The verdict.
    pub verdict: Ruling,
    /// Why it was skipped, waived or judged so, in words; empty when it passed.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub reason: String,
    /// The first divergence.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explanation: Option<Explanation>,
    /// The end of what it wrote to standard error, when it failed.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub stderr: String,
    /// How long it took, in seconds; 0 when it was not run.
    pub seconds: f64,
}

/// The first divergence of a trace, explained.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Explanation {
    /// Ordinal of the event among those that were reported, from 1; none when the trace has ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ordinal: Option<usize>,
    /// The expected line; none when the trace should have ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
    /// The event in compact notation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub actual: Option<String>,
    /// The fields that differ.
    pub differences: Vec<FieldDifference>,
    /// Line number of the block.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// Text of the block.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub block: Option<String>,
    /// The event of the reference in compact notation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference: Option<String>,
    /// The rules that say so.
    pub rules: Vec<RuleExcerpt>,
}

/// A field that differs.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FieldDifference {
    /// The field in compact notation, `kind`, or `exit status`.
    pub field: String,
    /// Its expected value, `-` for none.
    pub expected: String,
    /// Its value, `-` for none.
    pub actual: String,
    /// How far two numbers are apart.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distance: Option<String>,
}

/// What a rule says.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RuleExcerpt {
    /// Its id.
    pub id: String,
    /// Its title.
    pub title: String,
    /// Its statement, as markdown.
    pub statement: String,
}

/// How the cases about one rule went.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RuleSummary {
    /// The rule.
    pub rule: String,
    /// Cases that passed.
    pub passed: usize,
    /// Cases that failed.
    pub failed: usize,
    /// Cases whose failure is waived.
    pub waived: usize,
    /// Cases that were not run.
    pub skipped: usize,
}

impl Report {
    /// How many cases have a verdict.
    #[must_use]
    pub fn count(&self, verdict: Ruling) -> usize {
        self.verdicts.get(&verdict).copied().unwrap_or(0)
    }

    /// The cases that failed.
    pub fn failures(&self) -> impl Iterator<Item = &CaseReport> {
        self.cases.iter().filter(|case| case.verdict.is_failure())
    }
}

/// Counts the verdicts of cases.
pub(crate) fn verdicts(cases: &[CaseReport]) -> BTreeMap<Ruling, usize> {
    let mut counts = BTreeMap::new();
    for case in cases {
        *counts.entry(case.verdict).or_insert(0) += 1;
    }
    counts
}

/// Counts the cases about each rule.
pub(crate) fn by_rule(cases: &[CaseReport]) -> Vec<RuleSummary> {
    let mut rules: BTreeMap<RuleId, RuleSummary> = BTreeMap::new();
    for case in cases {
        for rule in &case.rules {
            let summary = rules.entry(*rule).or_insert_with(|| RuleSummary {
                rule: rule.to_string(),
                passed: 0,
                failed: 0,
                waived: 0,
                skipped: 0,
            });
            match case.verdict {
                Ruling::Pass => summary.passed += 1,
                Ruling::Skipped => summary.skipped += 1,
                Ruling::Waived => summary.waived += 1,
                _ => summary.failed += 1,
            }
        }
    }
    rules.into_values().collect()
}
