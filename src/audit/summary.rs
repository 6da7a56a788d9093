//! What holds, what does not, and what nobody measured.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;
use turnspec_oracle::book::RuleText;
use turnspec_oracle::vocabulary::RuleId;

use super::citations::Place;
use super::coverage::MEASURED;
use super::files::SOURCES;
use super::gather::Gathered;
use super::measure::Outcome;
use super::mutants::{self, Judged};
use super::{Revision, Tree};

/// A finding of the audit.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, JsonSchema)]
pub struct Finding {
    /// What it comes to.
    pub verdict: Verdict,
    /// What it is about.
    pub subject: &'static str,
    /// The finding, in a sentence.
    pub text: String,
    /// The things that it concerns, where they are few enough to be named.
    pub concerns: Vec<String>,
}

/// What a finding comes to.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It was measured and it is as it should be.
    Holds,
    /// It was measured and it is not as it should be.
    Fails,
    /// It was measured, and no bound says what it should be.
    Measured,
    /// It was not measured, or on another state of the sources.
    NotMeasured,
}

/// Every finding, in a fixed order.
#[must_use]
pub fn findings(tree: &Tree, gathered: &Gathered) -> Vec<Finding> {
    let mut findings = vec![state(&tree.revision), built(), examples(gathered), cases(gathered)];
    findings.push(citations(gathered, "citations in the oracle", &gathered.oracle, Verdict::Fails));
    findings.push(citations(gathered, "citations in the engine", &gathered.engine, Verdict::Measured));
    findings.extend([rules_with_examples(gathered), exercised(gathered)]);
    findings.extend(coverage(tree, gathered));
    findings.extend(mutants(gathered));
    findings.push(planted(tree, gathered));
    findings.extend([properties(gathered), proofs(gathered), licences(gathered)]);
    findings
}

fn state(revision: &Revision) -> Finding {
    let (verdict, text, concerns) = match revision {
        Revision::Commit { id, changed } if changed.is_empty() => {
            (Verdict::Holds, format!("the tree is commit {id}, unchanged"), Vec::new())
        }
        Revision::Commit { id, changed } => (
            Verdict::Fails,
            format!("the tree is dirty: {} file(s) differ from commit {id}", changed.len()),
            changed.clone(),
        ),
        Revision::Unknown { reason } => {
            (Verdict::NotMeasured, format!("the commit is unknown: {reason}"), Vec::new())
        }
    };
    Finding { verdict, subject: "state of the tree", text, concerns }
}

fn built() -> Finding {
    let text = format!("this program was built from the sources of the tree: {}", SOURCES.join(", "));
    finding(Verdict::Holds, "program", text)
}

fn examples(gathered: &Gathered) -> Finding {
    let outcomes = gathered.rules.iter().flat_map(|(rule, outcomes)| {
        rule.examples.iter().zip(outcomes).map(|(example, outcome)| {
            (format!("{}, spec/rules/{}:{}", rule.id, rule.file, example.line), outcome)
        })
    });
    runs("rule examples", outcomes.collect())
}

fn cases(gathered: &Gathered) -> Finding {
    let outcomes = gathered.cases.iter().map(|case| (case.case.id.clone(), &case.outcome));
    runs("conformance cases", outcomes.collect())
}

/// The outcomes of programs that were run during the audit.
fn runs(subject: &'static str, outcomes: Vec<(String, &Outcome)>) -> Finding {
    let count = |passes: fn(&Outcome) -> bool| outcomes.iter().filter(|(_, outcome)| passes(outcome)).count();
    let (oracle, engine) = (count(|outcome| outcome.oracle.is_ok()), count(|outcome| outcome.engine.is_ok()));
    let agreed = count(|outcome| outcome.agreement.is_ok());
    let text = format!(
        "of {} run in this audit, {oracle} pass on the oracle, {engine} on the engine, {agreed} agree event by event",
        outcomes.len()
    );
    let failing = outcomes.iter().filter(|(_, outcome)| !outcome.holds()).map(|(name, _)| name.clone());
    let concerns: Vec<String> = failing.collect();
    Finding { verdict: holds_if(concerns.is_empty() && !outcomes.is_empty()), subject, text, concerns }
}

/// How precisely an implementation cites the core rules: the oracle must, the engine may.
fn citations(
    gathered: &Gathered,
    subject: &'static str,
    cited: &BTreeMap<RuleId, Vec<Place>>,
    nowhere_is: Verdict,
) -> Finding {
    let (mut functions, mut tables, mut heads, mut nowhere) = (0, 0, Vec::new(), Vec::new());
    for (rule, _) in gathered.rules.iter().filter(|(rule, _)| rule.level == "core") {
        match cited.get(&rule.id).and_then(|places| places.first()) {
            Some(place) if place.function => functions += 1,
            Some(place) if !place.item.is_empty() => tables += 1,
            Some(_) => heads.push(format!("{}, head of a file", rule.id)),
            None => nowhere.push(format!("{}, nowhere", rule.id)),
        }
    }
    let text = format!(
        "of {} core rules, {functions} are cited by a function, {tables} by a table or type, {} only in the head of a \
         file, {} nowhere",
        functions + tables + heads.len() + nowhere.len(),
        heads.len(),
        nowhere.len(),
    );
    let verdict = if nowhere.is_empty() { Verdict::Holds } else { nowhere_is };
    Finding { verdict, subject, text, concerns: nowhere.into_iter().chain(heads).collect() }
}

fn rules_with_examples(gathered: &Gathered) -> Finding {
    let core = gathered.rules.iter().map(|(rule, _)| rule).filter(|rule| rule.level == "core");
    let (with, without): (Vec<&RuleText>, Vec<&RuleText>) = core.partition(|rule| !rule.examples.is_empty());
    let text = format!("of {} core rules, {} have an example", with.len() + without.len(), with.len());
    let concerns: Vec<String> = without.iter().map(|rule| rule.id.to_string()).collect();
    Finding { verdict: holds_if(concerns.is_empty()), subject: "examples of rules", text, concerns }
}

fn exercised(gathered: &Gathered) -> Finding {
    let exercised = gathered.exercised();
    let silent = gathered.rules.iter().map(|(rule, _)| rule.id).filter(|id| !exercised.contains(id));
    let concerns: Vec<String> = silent.map(|id| id.to_string()).collect();
    let all = gathered.rules.len();
    let text = format!(
        "of {all} rules, {} are named by an event of an example or case, {} by none",
        all - concerns.len(),
        concerns.len()
    );
    let verdict = if concerns.is_empty() { Verdict::Holds } else { Verdict::Measured };
    Finding { verdict, subject: "rule coverage", text, concerns }
}

fn coverage(tree: &Tree, gathered: &Gathered) -> Vec<Finding> {
    let Some(coverage) = &gathered.coverage else {
        return vec![finding(Verdict::NotMeasured, "code coverage", "no evidence/coverage.json".to_owned())];
    };
    let remark = coverage.state.freshness(tree).remark();
    let of = |folder: &&str| {
        let figures = coverage.of(folder);
        let branches = figures.branches.map_or("not measured".to_owned(), |share| share.percent());
        let text = format!(
            "{folder}: lines {}, regions {}, branches {branches}",
            figures.lines.percent(),
            figures.regions.percent()
        );
        remarked(Verdict::Measured, "code coverage", text, remark.as_deref())
    };
    MEASURED.iter().map(of).collect()
}

fn mutants(gathered: &Gathered) -> Vec<Finding> {
    let Some(judged) = &gathered.mutants else {
        return vec![finding(Verdict::NotMeasured, "mutants", "no evidence/mutants.json".to_owned())];
    };
    let unexplained: Vec<String> = judged.unexplained().map(|mutant| mutant.name.clone()).collect();
    let verdict = match (unexplained.is_empty(), judged.untried.is_empty() && judged.left() == 0) {
        (false, _) => Verdict::Fails,
        (true, false) => Verdict::NotMeasured,
        (true, true) => Verdict::Holds,
    };
    let mut text = score(judged, unexplained.len());
    if !judged.untried.is_empty() {
        text += &format!("; not tried in their present state: {} sources", judged.untried.len());
    }
    if judged.left() > 0 {
        text += &format!("; left to be tried in the other ones: {}", judged.left());
    }
    let mut findings = vec![Finding { concerns: unexplained, ..finding(verdict, "mutants", text) }];
    if !judged.idle_reasons.is_empty() {
        findings.push(Finding {
            verdict: Verdict::Fails,
            subject: "reasons of survivors",
            text: "reasons are given for mutants that did not survive or are not there".to_owned(),
            concerns: judged.idle_reasons.clone(),
        });
    }
    findings
}

/// The mutation score: caught and timed out, of those that compile.
fn score(judged: &Judged, unexplained: usize) -> String {
    let count = |outcome| judged.count(outcome);
    let killed = count(mutants::Outcome::Caught) + count(mutants::Outcome::Timeout);
    let missed = count(mutants::Outcome::Missed);
    let percent = (killed * 1000).checked_div(killed + missed).unwrap_or(0);
    format!(
        "of {} mutants of the oracle and of the engine's arithmetic that compile, {killed} are killed ({}.{} %; {} of them by a time-out), {missed} \
         survive: {} for a stated reason, {unexplained} without one",
        killed + missed,
        percent / 10,
        percent % 10,
        count(mutants::Outcome::Timeout),
        missed - unexplained,
    )
}

fn planted(tree: &Tree, gathered: &Gathered) -> Finding {
    let Some(planted) = &gathered.planted else {
        return finding(Verdict::NotMeasured, "planted bugs", "no evidence/planted.json".to_owned());
    };
    let concerns: Vec<String> =
        planted.bugs.iter().filter(|bug| !bug.found()).map(|bug| bug.bug.clone()).collect();
    let all = planted.bugs.len();
    let text = format!(
        "of {all} bugs planted in the engine, {} were found within their bounds",
        all - concerns.len()
    );
    let remark = planted.state.freshness(tree).remark();
    Finding {
        concerns: concerns.clone(),
        ..remarked(holds_if(concerns.is_empty()), "planted bugs", text, remark.as_deref())
    }
}

fn properties(gathered: &Gathered) -> Finding {
    let text = format!(
        "{} properties are stated; cargo test samples them, this audit does not run them",
        gathered.properties.len()
    );
    finding(Verdict::NotMeasured, "properties", text)
}

fn proofs(gathered: &Gathered) -> Finding {
    let refuted = gathered.proofs.iter().filter(|proof| proof.refuted).count();
    let text = format!(
        "{} theorems and {refuted} false statements to be refuted; cargo test samples them, cargo kani decides them, \
         this audit runs neither",
        gathered.proofs.len() - refuted
    );
    finding(Verdict::NotMeasured, "proofs", text)
}

fn licences(gathered: &Gathered) -> Finding {
    let missing = gathered.packages.iter().filter(|package| package.licence.is_none());
    let concerns: Vec<String> = missing.map(super::packages::Package::key).collect();
    let all = gathered.packages.len();
    let text = format!("of {all} packages of Cargo.lock, {} have a recorded licence", all - concerns.len());
    let verdict = if concerns.is_empty() { Verdict::Holds } else { Verdict::NotMeasured };
    Finding { verdict, subject: "licences", text, concerns }
}

fn finding(verdict: Verdict, subject: &'static str, text: String) -> Finding {
    Finding { verdict, subject, text, concerns: Vec::new() }
}

/// A finding from evidence: with a remark on its state it says nothing of the present sources.
fn remarked(verdict: Verdict, subject: &'static str, text: String, remark: Option<&str>) -> Finding {
    match remark {
        None => finding(verdict, subject, text),
        Some(remark) => finding(Verdict::NotMeasured, subject, format!("{text}; {remark}")),
    }
}

fn holds_if(condition: bool) -> Verdict {
    if condition { Verdict::Holds } else { Verdict::Fails }
}
