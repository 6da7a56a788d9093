//! The report for a terminal.

use std::fmt::Write;

use super::{CaseReport, Explanation, Report, RuleSummary, Ruling};

/// Columns of the widest line.
const WIDTH: usize = 100;
/// The most failures that are explained unless everything is wanted.
const EXPLAINED: usize = 20;

/// How much is shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Detail {
    /// The first failures, the rules with failures, the counts.
    Brief,
    /// Every case, every failure, every rule.
    Full,
}

/// The report as text: failures first, the verdict last.
#[must_use]
pub fn summary(report: &Report, detail: Detail, color: bool) -> String {
    let mut text = String::new();
    let full = detail == Detail::Full;
    if full {
        for case in report.cases.iter().filter(|case| !case.verdict.is_failure()) {
            let reason = if case.reason.is_empty() { String::new() } else { format!(": {}", case.reason) };
            let _ = writeln!(text, "{:<12} {}{reason}", case.verdict.as_str(), case.id);
        }
    }
    let most = if full { usize::MAX } else { EXPLAINED };
    for case in report.failures().take(most) {
        write_failure(&mut text, case, color);
    }
    let more = report.failures().count().saturating_sub(most);
    if more > 0 {
        let _ =
            writeln!(text, "{more} more failures; --verbose explains them here, --html FILE on a page.\n");
    }
    write_rules(&mut text, report, full);
    for waiver in &report.unused_waivers {
        let _ = writeln!(text, "The waiver of {waiver} applies to no case that was run.");
    }
    write_counts(&mut text, report, color);
    text
}

fn write_failure(text: &mut String, case: &CaseReport, color: bool) {
    let verdict = if color {
        format!("\x1b[1;31m{}\x1b[0m", case.verdict.as_str())
    } else {
        case.verdict.as_str().to_owned()
    };
    let _ = writeln!(text, "{verdict} {} · {}", case.id, case.title);
    write_indented(text, "  ", &case.reason);
    if let Some(explanation) = &case.explanation {
        text.push_str(&explained(explanation));
    }
    if !case.stderr.is_empty() {
        text.push_str("  standard error:\n");
        write_indented(text, "    ", &case.stderr);
    }
    text.push('\n');
}

/// A divergence in words: the block, what was expected, what came, what differs, the rules.
#[must_use]
pub(super) fn explained(explanation: &Explanation) -> String {
    let mut text = String::new();
    let mut row = |name: &str, value: &str| {
        let _ = writeln!(text, "  {name:<10} {value}");
    };
    if let Some(line) = explanation.line {
        row("block", &format!("line {line}: {}", explanation.block.as_deref().unwrap_or_default()));
    }
    row("expected", explanation.expected.as_deref().unwrap_or("the end of the trace"));
    match (&explanation.actual, explanation.ordinal) {
        (Some(actual), Some(ordinal)) => row("got", &format!("{actual} (event {ordinal})")),
        _ if explanation.differences.is_empty() => row("got", "no such event in the rest of the trace"),
        _ => {}
    }
    for each in &explanation.differences {
        let apart = each.distance.as_ref().map(|distance| format!(", {distance} apart")).unwrap_or_default();
        row("differs", &format!("{}: expected {}, got {}{apart}", each.field, each.expected, each.actual));
    }
    if let Some(reference) = &explanation.reference {
        row("reference", reference);
    }
    for rule in &explanation.rules {
        let _ = writeln!(text, "  {} · {}", rule.id, rule.title);
        write_indented(&mut text, "      ", &rule.statement);
    }
    text
}

/// Text wrapped behind an indent; rows of a table stay whole.
fn write_indented(text: &mut String, indent: &str, content: &str) {
    for line in content.lines() {
        if line.starts_with('|') {
            let _ = writeln!(text, "{indent}{line}");
        } else {
            let options = textwrap::Options::new(WIDTH).initial_indent(indent).subsequent_indent(indent);
            let options = options.break_words(false);
            let _ = writeln!(text, "{}", textwrap::fill(line, options).trim_end());
        }
    }
}

fn write_rules(text: &mut String, report: &Report, full: bool) {
    let shown: Vec<&RuleSummary> = report.rules.iter().filter(|rule| full || rule.failed > 0).collect();
    if shown.is_empty() {
        return;
    }
    let _ = writeln!(text, "{:<16} {:>7} {:>7} {:>7} {:>7}", "rule", "passed", "failed", "waived", "skipped");
    for RuleSummary { rule, passed, failed, waived, skipped } in shown {
        let _ = writeln!(text, "{rule:<16} {passed:>7} {failed:>7} {waived:>7} {skipped:>7}");
    }
    text.push('\n');
}

fn write_counts(text: &mut String, report: &Report, color: bool) {
    let count = |(verdict, count): (&Ruling, &usize)| format!("{count} {}", verdict.as_str());
    let counts: Vec<String> = report.verdicts.iter().map(count).collect();
    let ran = report.cases.len() - report.count(Ruling::Skipped);
    let version = report.version.as_ref().map(|version| format!(" {version}")).unwrap_or_default();
    let (word, code) = match (report.success, ran) {
        (true, 0) => ("nothing was run", "33"),
        (true, _) => ("conforms", "32"),
        (false, _) => ("does not conform", "31"),
    };
    let word = if color { format!("\x1b[1;{code}m{word}\x1b[0m") } else { word.to_owned() };
    let _ = writeln!(
        text,
        "{}{version}: {word}; {} cases: {}",
        report.implementation,
        report.cases.len(),
        counts.join(", ")
    );
}
