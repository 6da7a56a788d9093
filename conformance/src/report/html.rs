//! The report as one page to read.

use maud::{Markup, html as markup};

use super::{CaseReport, Explanation, Report, Ruling};
use crate::page::{page, prose};

/// The report as a self-contained HTML page.
#[must_use]
pub fn html(report: &Report) -> String {
    let name = match &report.version {
        Some(version) => format!("{} {version}", report.implementation),
        None => report.implementation.clone(),
    };
    let title = format!("Conformance of {name}");
    let failures: Vec<&CaseReport> = report.failures().collect();
    let body = markup! {
        h1 { (title) }
        (verdict(report))
        (counts(report))
        @if !report.unused_waivers.is_empty() {
            p.warn { "Waivers that apply to no case that was run: " (report.unused_waivers.join(", ")) "." }
        }
        h2 { "Failures" }
        @if failures.is_empty() { p { "None." } }
        @for case in &failures { (failure(case)) }
        h2 { "By rule" }
        (rules(report))
        h2 { "Every case" }
        (cases(report))
    };
    page(&title, &body)
}

fn verdict(report: &Report) -> Markup {
    let ran = report.cases.len() - report.count(Ruling::Skipped);
    markup! {
        p {
            @if !report.success { strong.bad { "Does not conform." } }
            @else if ran == 0 { strong.warn { "Nothing was run." } }
            @else { strong.good { "Conforms." } }
            " " (ran) " of " (report.cases.len()) " cases were run with "
            code { (report.command) }
            ", rules for running version " (report.protocol) "."
        }
    }
}

fn counts(report: &Report) -> Markup {
    markup! {
        div.scroll { table.narrow {
            tr { th { "verdict" } th.number { "cases" } }
            @for (verdict, count) in &report.verdicts {
                tr { td { (tag(*verdict)) } td.number { (count) } }
            }
        } }
    }
}

fn failure(case: &CaseReport) -> Markup {
    markup! {
        details open[case.explanation.is_some()] id=(case.id) {
            summary { (tag(case.verdict)) " " code { (case.id) } " " (case.title) }
            p { (case.reason) }
            @if let Some(explanation) = &case.explanation { (divergence(explanation)) }
            @if !case.stderr.is_empty() { p.faint { "Standard error" } pre { (case.stderr) } }
            p.faint { "Source: " (case.source) }
        }
    }
}

fn divergence(explanation: &Explanation) -> Markup {
    let expected = explanation.expected.as_deref().unwrap_or("the end of the trace");
    let actual = explanation.actual.as_deref().unwrap_or("no such event in the rest of the trace");
    markup! {
        dl {
            @if let Some(line) = explanation.line {
                dt { "line " (line) } dd { code { (explanation.block.as_deref().unwrap_or_default()) } }
            }
            dt { "expected" } dd { code { (expected) } }
            @if explanation.actual.is_some() || explanation.differences.is_empty() {
                dt { "got" @if let Some(ordinal) = explanation.ordinal { " (event " (ordinal) ")" } }
                dd { code { (actual) } }
            }
            @for each in &explanation.differences {
                dt { "differs" }
                dd {
                    code { (each.field) } ": expected " code { (each.expected) } ", got " code { (each.actual) }
                    @if let Some(distance) = &each.distance { ", " (distance) " apart" }
                }
            }
            @if let Some(reference) = &explanation.reference {
                dt { "reference" } dd { code { (reference) } }
            }
        }
        @for rule in &explanation.rules {
            h3 { (rule.id) " · " (rule.title) }
            (prose(&rule.statement))
        }
    }
}

fn rules(report: &Report) -> Markup {
    markup! {
        div.scroll { table {
            tr {
                th { "rule" } th.number { "passed" } th.number { "failed" } th.number { "waived" }
                th.number { "skipped" }
            }
            @for rule in &report.rules {
                tr {
                    td { code { (rule.rule) } } td.number { (rule.passed) }
                    td.number.bad[rule.failed > 0] { (rule.failed) }
                    td.number { (rule.waived) } td.number { (rule.skipped) }
                }
            }
        } }
    }
}

fn cases(report: &Report) -> Markup {
    markup! {
        div.scroll { table {
            tr { th { "case" } th { "verdict" } th { "what it shows" } }
            @for case in &report.cases {
                tr {
                    td {
                        @if case.verdict.is_failure() { a href={ "#" (case.id) } { code { (case.id) } } }
                        @else { code { (case.id) } }
                    }
                    td { (tag(case.verdict)) }
                    td {
                        (case.title)
                        @if !case.reason.is_empty() && !case.verdict.is_failure() {
                            " " span.faint { "(" (case.reason) ")" }
                        }
                    }
                }
            }
        } }
    }
}

fn tag(verdict: Ruling) -> Markup {
    let class = match verdict {
        Ruling::Pass => "tag good",
        Ruling::Skipped => "tag faint",
        Ruling::Waived => "tag warn",
        _ => "tag bad",
    };
    markup! { span class=(class) { (verdict.as_str()) } }
}
