//! The first section: figures, and what holds, what does not, what was not measured.

use maud::{Markup, html};

use crate::audit::gather::Gathered;
use crate::audit::matrix::Matrix;
use crate::audit::summary::{Finding, Verdict};

/// The section.
pub fn section(gathered: &Gathered, matrix: &Matrix) -> Markup {
    let groups = [
        (Verdict::Fails, "What does not hold", "bad"),
        (Verdict::NotMeasured, "What was not measured", "open"),
        (Verdict::Holds, "What holds", "good"),
        (Verdict::Measured, "Measured, without a bound", "plain"),
    ];
    html! {
        section id="summary" {
            h2 { "Summary" }
            (figures(gathered))
            @for (verdict, title, class) in groups {
                @let findings: Vec<&Finding> =
                    matrix.findings.iter().filter(|finding| finding.verdict == verdict).collect();
                @if !findings.is_empty() {
                    h3 { span.mark.(class) {} (title) }
                    table.findings { tbody { @for each in findings { (finding(each)) } } }
                } @else if verdict == Verdict::Fails {
                    h3 { span.mark.good {} "Nothing that was measured fails" }
                }
            }
        }
    }
}

fn figures(gathered: &Gathered) -> Markup {
    let core = gathered.rules.iter().filter(|(rule, _)| rule.level == "core").count();
    let examples: usize = gathered.rules.iter().map(|(rule, _)| rule.examples.len()).sum();
    let figures = [
        (gathered.rules.len(), "rules"),
        (core, "of them core"),
        (examples, "examples"),
        (gathered.cases.len(), "conformance cases"),
        (gathered.properties.len(), "properties"),
        (gathered.proofs.iter().filter(|proof| !proof.refuted).count(), "theorems"),
        (gathered.mutants.as_ref().map_or(0, |judged| judged.run.mutants.len()), "mutants"),
        (gathered.planted.as_ref().map_or(0, |planted| planted.bugs.len()), "planted bugs"),
    ];
    html! {
        ul.figures { @for (count, name) in figures.into_iter().filter(|(count, _)| *count > 0) { li { b { (count) } " " (name) } } }
    }
}

fn finding(finding: &Finding) -> Markup {
    html! {
        tr {
            th scope="row" { (finding.subject) }
            td {
                (finding.text) "."
                @if finding.subject == "mutants" {
                    " " a href="#mutants" { "The survivors" }
                } @else if !finding.concerns.is_empty() {
                    details.concerns {
                        summary { "which (" (finding.concerns.len()) ")" }
                        ul { @for concern in &finding.concerns { li { (named(concern)) } } }
                    }
                }
            }
        }
    }
}

/// A rule as a link, anything else as it is.
fn named(concern: &str) -> Markup {
    let id = concern.split(',').next().unwrap_or_default();
    html! {
        @if turnspec_oracle::vocabulary::RuleId::parse(id).is_some() { a href={ "#" (id) } { code { (concern) } } }
        @else { code { (concern) } }
    }
}
