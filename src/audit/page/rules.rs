//! The rule table: a line a rule, which opens to its text, its places in the sources and its evidence.

use std::collections::BTreeSet;

use maud::{Markup, html};
use turnspec_oracle::book::{Example, RuleText};

use super::markdown;
use crate::audit::citations::Place;
use crate::audit::gather::Gathered;
use crate::audit::matrix::{Matrix, MutantCounts, Row, area, passed};
use crate::audit::measure::Outcome;
use crate::audit::statements::Statement;

/// The section.
pub fn section(gathered: &Gathered, matrix: &Matrix) -> Markup {
    html! {
        section id="rules" {
            h2 { "Rules" }
            p.note {
                "Ex. and Cases: how many passed in this audit, of how many. Prop. and Proofs: how many support the \
                 rule. Mutants: killed of those that compile, in the functions that cite the rule. \
                 A line opens to the text and the evidence; what is filtered out is not printed."
            }
            @if let Some(mutants) = &matrix.mutants {
                @if !mutants.untried.is_empty() {
                    p.note { "The mutants of " (mutants.untried.len()) " sources have not been tried in their present state." }
                }
                @if mutants.left > 0 {
                    p.note { (mutants.left) " mutants of the other sources are left to be tried." }
                }
            }
            (toolbar(gathered))
            div.head aria-hidden="true" {
                span { "Rule" } span { "Title" } span { "Level" } span { "Basis" } span.n { "Ex." }
                span.n { "Cases" } span.n { "Prop." } span.n { "Proofs" } span.n { "Mutants" }
            }
            div #table {
                @for ((rule, outcomes), row) in gathered.rules.iter().zip(&matrix.rules) {
                    (line(gathered, rule, outcomes, row))
                }
            }
        }
    }
}

fn toolbar(gathered: &Gathered) -> Markup {
    let mut areas: Vec<&str> = Vec::new();
    for (rule, _) in &gathered.rules {
        if !areas.contains(&area(rule)) {
            areas.push(area(rule));
        }
    }
    let values = |get: fn(&RuleText) -> &str| -> BTreeSet<&str> {
        gathered.rules.iter().map(|(rule, _)| get(rule)).collect()
    };
    html! {
        form.toolbar #filter hidden {
            label { "Search " input type="search" name="text" placeholder="G50, chamfer, frame/mod.rs …"; }
            (select("area", &areas))
            (select("level", &values(|rule| &rule.level).into_iter().collect::<Vec<_>>()))
            (select("basis", &values(|rule| &rule.basis).into_iter().collect::<Vec<_>>()))
            label.check { input type="checkbox" name="open"; " open all" }
            output #count {}
        }
    }
}

fn select(name: &str, values: &[&str]) -> Markup {
    html! {
        label {
            (name) " "
            select name=(name) {
                option value="" { "any" }
                @for value in values { option { (value) } }
            }
        }
    }
}

fn line(gathered: &Gathered, rule: &RuleText, outcomes: &[Outcome], row: &Row) -> Markup {
    html! {
        details.rule id=(row.id) data-area=(row.area) data-level=(row.level) data-basis=(row.basis) {
            summary {
                span.id { (row.id) }
                span.title { (row.title) }
                span.level { (row.level) }
                span.basis { (row.basis) }
                (share("ex.", passed(&row.examples), row.examples.len()))
                (share("cases", passed(&row.cases), row.cases.len()))
                (count("prop.", row.properties.len()))
                (count("proofs", row.proofs.len()))
                (mutants(row.mutants.as_ref()))
            }
            div.body {
                div.text {
                    (markdown::render(&rule.statement))
                    @for (example, outcome) in rule.examples.iter().zip(outcomes) { (shown(rule, example, outcome)) }
                }
                (dossier(gathered, rule, row))
            }
        }
    }
}

fn share(name: &str, reached: usize, all: usize) -> Markup {
    let class = match (reached, all) {
        (_, 0) => "none",
        (reached, all) if reached == all => "good",
        _ => "bad",
    };
    html! {
        span.n.(class) data-name=(name) { @if all == 0 { "–" } @else { (reached) "/" (all) } }
    }
}

fn count(name: &str, count: usize) -> Markup {
    html! {
        @if count == 0 { span.n.none data-name=(name) { "–" } } @else { span.n data-name=(name) { (count) } }
    }
}

fn mutants(counts: Option<&MutantCounts>) -> Markup {
    let Some(counts) = counts else { return share("mutants", 0, 0) };
    let killed = counts.caught + counts.timeout;
    let all = killed + counts.missed + counts.explained;
    let class = match counts.missed {
        _ if all == 0 => "none",
        0 => "good",
        _ => "bad",
    };
    html! {
        span.n.(class) data-name="mutants" { @if all == 0 { "–" } @else { (killed) "/" (all) } }
    }
}

fn shown(rule: &RuleText, example: &Example, outcome: &Outcome) -> Markup {
    html! {
        figure.example {
            figcaption {
                (verdict(outcome))
                @if !example.introduction.is_empty() { (markdown::render(&example.introduction)) }
            }
            div.columns {
                pre.nc aria-label="program" { (String::from_utf8_lossy(&example.program)) }
                @if !example.setup.is_empty() { pre.setup aria-label="set-up" { (example.setup) } }
                pre.trace aria-label="trace" { (example.trace) }
            }
            p.place { "spec/rules/" (rule.file) ":" (example.line) }
        }
    }
}

/// What both implementations made of a program.
fn verdict(outcome: &Outcome) -> Markup {
    let parts = [("oracle", &outcome.oracle), ("engine", &outcome.engine), ("agreement", &outcome.agreement)];
    html! {
        p.verdict {
            @for (name, result) in parts {
                @match result {
                    Ok(()) => span.good { "✓ " (name) },
                    Err(reason) => span.bad { "✗ " (name) ": " (reason) },
                }
            }
        }
    }
}

/// Everything about a rule but its text.
fn dossier(gathered: &Gathered, rule: &RuleText, row: &Row) -> Markup {
    let supports = |statement: &&Statement| statement.rules.contains(&rule.id);
    let properties: Vec<&Statement> = gathered.properties.iter().filter(supports).collect();
    let proofs: Vec<&Statement> = gathered.proofs.iter().filter(supports).collect();
    html! {
        dl.dossier {
            dt { "Source" } dd { (row.source) }
            @if !row.alarms.is_empty() {
                dt { "Alarms" } dd { @for alarm in &row.alarms { code { (alarm) } " " } }
            }
            dt { "Text" } dd.place { (row.text) }
            dt { "Oracle" } (places(&row.oracle))
            dt { "Engine" } (places(&row.engine))
            dt { "Traces" }
            dd { @if row.exercised { "cited by a trace" } @else { "cited by no trace of an example or case" } }
            @if !row.cases.is_empty() {
                dt { "Cases" }
                dd {
                    ul {
                        @for case in gathered.cases.iter().filter(|case| case.case.rules.contains(&rule.id)) {
                            li { (case.case.title) " " span.place { (case.file) } (verdict(&case.outcome)) }
                        }
                    }
                }
            }
            @if !properties.is_empty() { dt { "Properties" } (statements(&properties)) }
            @if !proofs.is_empty() { dt { "Proofs" } (statements(&proofs)) }
            (survivors(gathered, rule, row))
            @if !row.planted.is_empty() {
                dt { "Planted bugs" }
                dd {
                    ul {
                        @for bug in &row.planted {
                            li { code { (bug.bug) } @if bug.found { span.good { " ✓ found" } } @else { span.bad { " ✗ not found" } } }
                        }
                    }
                }
            }
        }
    }
}

fn places(places: &[Place]) -> Markup {
    html! {
        dd.place {
            @if places.is_empty() { "cited nowhere" }
            ul {
                @for place in places {
                    li { @if place.item.is_empty() { "head of " } @else { b { (place.item) } " " } (place.file) ":" (place.line) }
                }
            }
        }
    }
}

fn statements(statements: &[&Statement]) -> Markup {
    html! {
        dd { ul { @for each in statements { li { (each.statement) " " span.place { (each.file) ":" (each.line) } } } } }
    }
}

/// The mutants of a rule's functions: how many were killed, and which were not.
fn survivors(gathered: &Gathered, rule: &RuleText, row: &Row) -> Markup {
    let (Some(judged), Some(counts)) = (&gathered.mutants, &row.mutants) else { return html! {} };
    if *counts == MutantCounts::default() {
        return html! {};
    }
    let mutants = gathered.mutants_of(rule.id);
    let missed = mutants.iter().filter(|mutant| mutant.outcome == crate::audit::mutants::Outcome::Missed);
    html! {
        dt { "Mutants" }
        dd {
            (counts.caught) " caught, " (counts.timeout) " timed out, " (counts.missed + counts.explained) " survived"
            ul {
                @for mutant in missed {
                    li {
                        code { (mutant.name) }
                        @if let Some(reason) = judged.reasons.get(&mutant.name) { " " (reason) }
                    }
                }
            }
        }
    }
}
