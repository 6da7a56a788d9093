//! What comes of one program: the implementation's trace against that of the oracle.

use std::collections::BTreeMap;

use turnspec_conformance::{
    Declaration, Divergence, Expected, Implementation, RunError, Subject, Task, Verdict, Waiver, compare,
    printable,
};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{Event, RuleId};

use super::Signature;

/// The most characters of a line of standard error that are shown.
const LINE_SHOWN: usize = 400;

/// How many events cited each rule.
pub(super) type RuleCounts = BTreeMap<RuleId, u64>;

/// What comes of one program.
#[derive(Debug)]
pub(super) enum Judgement {
    /// The traces agree.
    Agreed(RuleCounts),
    /// The implementation says that it does not have what the program needs.
    Unsupported,
    /// They diverge as a waiver permits; its reason.
    Waived(String),
    /// They disagree.
    Disagreed(Box<Disagreement>),
}

/// A disagreement.
#[derive(Clone, Debug)]
pub(super) struct Disagreement {
    /// What it looks like.
    pub signature: Signature,
    /// The expected event, or why there is none.
    pub expected: String,
    /// What the implementation did instead.
    pub actual: String,
    /// The field by field differences, in words.
    pub differences: Vec<String>,
    /// The rules of the events before it, which agree.
    pub agreeing: RuleCounts,
}

/// Runs a program with the implementation and with the oracle.
pub(super) fn judge(
    implementation: &Implementation,
    declaration: &Declaration,
    case: &Case,
) -> Result<Judgement, RunError> {
    let mut trace: Vec<Event> = Vec::new();
    turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| trace.push(*event));
    let outcome = implementation.run(&Task::new("campaign", &case.program, &case.setup))?;
    let verdict = compare(&Expected::complete(&trace), &outcome, declaration);
    Ok(match &verdict {
        Verdict::Pass => Judgement::Agreed(counts(&trace)),
        Verdict::Unsupported => Judgement::Unsupported,
        Verdict::Mismatch(divergence) => judge_divergence(divergence, &trace, declaration),
        Verdict::Protocol(text) | Verdict::Crash(text) => {
            failed(&verdict, printable(text, LINE_SHOWN), &outcome.stderr)
        }
        Verdict::TimeOut => failed(&verdict, "not finished in time".to_owned(), &outcome.stderr),
        Verdict::Flood => failed(&verdict, "too much output".to_owned(), &outcome.stderr),
    })
}

fn judge_divergence(divergence: &Divergence, trace: &[Event], declaration: &Declaration) -> Judgement {
    let place = divergence.line.unwrap_or(trace.len());
    let expected = trace.get(place).or(trace.last());
    let signature = Signature::of_divergence(divergence, expected);
    if let Some(waiver) = declaration.waivers.iter().find(|waiver| permits(waiver, &signature, divergence)) {
        return Judgement::Waived(waiver.reason.clone());
    }
    let expected = match divergence.line {
        Some(_) => divergence.expected.clone().unwrap_or_default(),
        None => "the end of the trace".to_owned(),
    };
    Judgement::Disagreed(Box::new(Disagreement {
        signature,
        expected,
        actual: divergence.actual.as_ref().map_or("the end of the trace".to_owned(), ToString::to_string),
        differences: divergence.differences.iter().map(ToString::to_string).collect(),
        agreeing: counts(trace.get(..place).unwrap_or(trace)),
    }))
}

/// Whether a waiver permits a divergence: by a rule of the expected event, and by the field that differs first.
fn permits(waiver: &Waiver, signature: &Signature, divergence: &Divergence) -> bool {
    let Subject::Rule(rule) = waiver.subject else { return false };
    signature.rules.contains(&rule) && waiver.covers(divergence)
}

fn failed(verdict: &Verdict, how: String, stderr: &str) -> Judgement {
    let last_lines: Vec<&str> = stderr.lines().rev().take(3).collect();
    let shown = |line: &str| format!("standard error: {}", printable(line, LINE_SHOWN));
    let differences = last_lines.into_iter().rev().map(shown).collect();
    Judgement::Disagreed(Box::new(Disagreement {
        signature: Signature::of_failure(verdict),
        expected: "a trace".to_owned(),
        actual: how,
        differences,
        agreeing: RuleCounts::new(),
    }))
}

fn counts(events: &[Event]) -> RuleCounts {
    let mut counts = RuleCounts::new();
    for rule in events.iter().flat_map(|event| event.rules.as_slice()) {
        *counts.entry(*rule).or_default() += 1;
    }
    counts
}
