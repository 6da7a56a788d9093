//! Runs an implementation on the cases of a corpus, several at once, and judges every one.
//!
//! The report does not depend on how many run at once: the cases stand in the order of the corpus.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use turnspec_oracle::book::{self, RuleText};
use turnspec_oracle::vocabulary::RuleId;

use crate::comparison::compare;
use crate::corpus::FORMAT;
use crate::explanation::explain;
use crate::report::{CaseReport, Report, Ruling, by_rule, verdicts};
use crate::selection::{Filter, reason_to_skip};
use crate::{
    Declaration, Exercise, Implementation, Outcome, PROTOCOL, Refusals, RunError, Subject, Verdict, Waiver,
    printable,
};

/// The most characters of standard error that a report keeps.
const STDERR_SHOWN: usize = 2000;

/// What is run, how, and which cases.
pub struct Runner<'a> {
    /// The command, for the report.
    pub command: &'a str,
    /// The implementation.
    pub implementation: &'a Implementation,
    /// What it declares.
    pub declaration: &'a Declaration,
    /// Which cases are run.
    pub filters: &'a [Filter],
    /// How many run at once; at least one does.
    pub jobs: usize,
}

impl Runner<'_> {
    /// Runs the cases. `finished` hears of every case, in the order in which they finish.
    ///
    /// # Errors
    /// When the implementation does not start, or the run is interrupted. What the implementation does after
    /// its start is part of the report.
    pub fn run(
        &self,
        exercises: &[Exercise],
        finished: &(dyn Fn(&CaseReport) + Sync),
    ) -> Result<Report, RunError> {
        let book = book::e100l().map_err(RunError::Start)?;
        let results: Vec<Mutex<Option<CaseReport>>> = exercises.iter().map(|_| Mutex::new(None)).collect();
        let failure = Mutex::new(None);
        let next = AtomicUsize::new(0);
        let work = || {
            loop {
                let index = next.fetch_add(1, Ordering::Relaxed);
                let (Some(exercise), Some(result)) = (exercises.get(index), results.get(index)) else {
                    return;
                };
                match self.case(exercise, &book) {
                    Ok(report) => {
                        finished(&report);
                        *result.lock().unwrap_or_else(PoisonError::into_inner) = Some(report);
                    }
                    Err(error) => {
                        // Nobody takes another case.
                        next.store(exercises.len(), Ordering::Relaxed);
                        failure.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                        return;
                    }
                }
            }
        };
        thread::scope(|scope| {
            for _ in 1..self.jobs.clamp(1, exercises.len().max(1)) {
                scope.spawn(work);
            }
            work();
        });
        if let Some(error) = failure.into_inner().unwrap_or_else(PoisonError::into_inner) {
            return Err(error);
        }
        let cases =
            results.into_iter().filter_map(|each| each.into_inner().unwrap_or_else(PoisonError::into_inner));
        Ok(self.report(cases.collect()))
    }

    fn case(&self, exercise: &Exercise, book: &[RuleText]) -> Result<CaseReport, RunError> {
        let case = &exercise.case;
        let mut report = CaseReport {
            id: case.id.clone(),
            title: case.title.clone(),
            rules: case.rules.clone(),
            source: case.source.clone(),
            basis: case.basis,
            verdict: Ruling::Skipped,
            reason: String::new(),
            explanation: None,
            stderr: String::new(),
            seconds: 0.0,
        };
        if let Some(reason) = reason_to_skip(case, self.declaration, self.filters) {
            report.reason = reason;
            return Ok(report);
        }
        let outcome = self.implementation.run(&exercise.task())?;
        report.seconds = (outcome.duration.as_secs_f64() * 1000.0).round() / 1000.0;
        self.judge(exercise, &outcome, book, &mut report);
        Ok(report)
    }

    fn judge(&self, exercise: &Exercise, outcome: &Outcome, book: &[RuleText], report: &mut CaseReport) {
        let verdict = compare(&exercise.expected, outcome, self.declaration);
        (report.verdict, report.reason) = ruling(&verdict);
        if verdict == Verdict::Unsupported && self.declaration.refusals == Refusals::Skip {
            report.verdict = Ruling::Skipped;
        }
        if let Verdict::Mismatch(divergence) = &verdict {
            report.explanation = Some(explain(exercise, divergence, book));
        }
        if report.verdict.is_failure() {
            let lines: Vec<String> =
                outcome.stderr.lines().map(|line| printable(line, STDERR_SHOWN)).collect();
            report.stderr = last_characters(&lines.join("\n"), STDERR_SHOWN);
        }
        match (self.waiver(report, &verdict), report.verdict) {
            (Some(waiver), Ruling::Mismatch | Ruling::Unsupported) => {
                report.reason = format!("{}, waived: {}", report.verdict.as_str(), waiver.reason);
                report.verdict = Ruling::Waived;
            }
            (Some(waiver), Ruling::Pass) if matches!(waiver.subject, Subject::Case(_)) => {
                report.reason = format!("it passes, the waiver is out of date: {}", waiver.reason);
                report.verdict = Ruling::StaleWaiver;
            }
            _ => {}
        }
    }

    /// The waiver of the case itself, or else of a rule that it is about or that the diverging line cites.
    fn waiver(&self, report: &CaseReport, verdict: &Verdict) -> Option<&Waiver> {
        let divergence = match verdict {
            Verdict::Mismatch(divergence) => Some(&**divergence),
            _ => None,
        };
        let waivers = self.declaration.waivers.iter().filter(|waiver| match divergence {
            Some(divergence) => waiver.covers(divergence),
            None => !waiver.is_limited(),
        });
        let of_case = |waiver: &&Waiver| matches!(&waiver.subject, Subject::Case(id) if *id == report.id);
        let of_rule = |waiver: &&Waiver| match &waiver.subject {
            Subject::Rule(rule) => {
                report.rules.contains(rule) || divergence.is_some_and(|each| each.cites(*rule))
            }
            Subject::Case(_) => false,
        };
        waivers.clone().find(of_case).or_else(|| waivers.clone().find(of_rule))
    }

    fn report(&self, mut cases: Vec<CaseReport>) -> Report {
        if self.filters.is_empty() {
            self.mark_stale_rule_waivers(&mut cases);
        }
        let verdicts = verdicts(&cases);
        Report {
            format: FORMAT.to_owned(),
            protocol: PROTOCOL,
            implementation: self.declaration.name.clone(),
            version: self.declaration.version.clone(),
            command: self.command.to_owned(),
            success: !verdicts.keys().any(|verdict| verdict.is_failure()),
            verdicts,
            unused_waivers: self.unused_waivers(&cases),
            rules: by_rule(&cases),
            cases,
        }
    }

    /// A waiver of a rule is out of date when no case about the rule fails any more. One that is limited to some divergences
    /// is not judged: what it is about may show itself in campaigns only.
    fn mark_stale_rule_waivers(&self, cases: &mut [CaseReport]) {
        for waiver in &self.declaration.waivers {
            let (Subject::Rule(rule), false) = (&waiver.subject, waiver.is_limited()) else { continue };
            let about = |case: &&mut CaseReport| case.rules.contains(rule) && case.verdict != Ruling::Skipped;
            let passes = |case: &mut CaseReport| matches!(case.verdict, Ruling::Pass | Ruling::StaleWaiver);
            let needed = !cases.iter_mut().filter(about).all(passes);
            if !needed {
                for case in cases.iter_mut().filter(about) {
                    case.verdict = Ruling::StaleWaiver;
                    case.reason = format!("every case about {rule} passes, its waiver is out of date");
                }
            }
        }
    }

    fn unused_waivers(&self, cases: &[CaseReport]) -> Vec<String> {
        let run = || cases.iter().filter(|case| case.verdict != Ruling::Skipped);
        let ids: BTreeSet<&str> = run().map(|case| case.id.as_str()).collect();
        let rules: BTreeSet<RuleId> = run().flat_map(|case| case.rules.iter().copied()).collect();
        let unused = self.declaration.waivers.iter().filter_map(|waiver| match &waiver.subject {
            Subject::Case(id) => (!ids.contains(id.as_str())).then(|| id.clone()),
            Subject::Rule(rule) => (!rules.contains(rule)).then(|| rule.to_string()),
        });
        unused.collect()
    }
}

/// The verdict without waivers, and its reason.
fn ruling(verdict: &Verdict) -> (Ruling, String) {
    match verdict {
        Verdict::Pass => (Ruling::Pass, String::new()),
        Verdict::Mismatch(_) => (Ruling::Mismatch, "the trace diverges from the expectation".to_owned()),
        Verdict::Unsupported => {
            (Ruling::Unsupported, "exit status 3, though every feature of the case is declared".to_owned())
        }
        Verdict::Protocol(reason) => (Ruling::Protocol, reason.clone()),
        Verdict::Crash(reason) => (Ruling::Crash, reason.clone()),
        Verdict::TimeOut => (Ruling::TimeOut, "not finished in time".to_owned()),
        Verdict::Flood => (Ruling::Flood, "more output than the limit".to_owned()),
    }
}

fn last_characters(text: &str, most: usize) -> String {
    let surplus = text.chars().count().saturating_sub(most);
    text.chars().skip(surplus).collect()
}
