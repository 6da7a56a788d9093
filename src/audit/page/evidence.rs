//! The evidence that is not about one rule: properties and proofs, coverage, mutants, planted bugs, tools and
//! packages.

use maud::{Markup, html};
use turnspec_oracle::vocabulary::RuleId;

use super::markdown;
use crate::audit::Tree;
use crate::audit::coverage::{Figures, MEASURED, Share};
use crate::audit::evidence::State;
use crate::audit::gather::Gathered;
use crate::audit::mutants::Outcome;
use crate::audit::statements::Statement;
use crate::audit::tools::Tool;

/// The sections.
pub fn sections(tree: &Tree, gathered: &Gathered) -> Markup {
    html! {
        (statements(gathered))
        (coverage(tree, gathered))
        (mutants(gathered))
        (planted(tree, gathered))
    }
}

fn statements(gathered: &Gathered) -> Markup {
    let (theorems, refuted): (Vec<&Statement>, Vec<&Statement>) =
        gathered.proofs.iter().partition(|proof| !proof.refuted);
    html! {
        section id="statements" {
            h2 { "Properties and proofs" }
            p { "A property is a law that tests sample with random programs. A theorem is decided by the model \
                 checker Kani for all inputs within its bound, and sampled by tests where Kani is not installed. \
                 This audit lists them; it does not run them." }
            h3 { "Properties" }
            (listed(&gathered.properties.iter().collect::<Vec<_>>()))
            h3 { "Theorems" }
            (listed(&theorems))
            h3 { "False statements, of which a counterexample must be found" }
            (listed(&refuted))
        }
    }
}

fn listed(statements: &[&Statement]) -> Markup {
    let assuming = statements.iter().any(|each| !each.assumes.is_empty());
    html! {
        @if statements.is_empty() { p { "None." } } @else {
            div.scroll {
                table.statements {
                    thead { tr { th { "Statement" } @if assuming { th { "Assumptions" } } th { "Rules" } th { "Place" } } }
                    tbody {
                        @for each in statements {
                            tr {
                                td {
                                    (markdown::render(&each.statement))
                                    @for functions in &each.of { div.note { (markdown::render(&format!("Of {functions}"))) } }
                                }
                                @if assuming { td { @for assumption in &each.assumes { (markdown::render(assumption)) } } }
                                td { (rule_links(&each.rules)) }
                                td.place { b { (each.name) } br; (each.file) ":" (each.line) }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn rule_links(rules: &[RuleId]) -> Markup {
    html! { @for rule in rules { a href={ "#" (rule) } { (rule) } " " } }
}

fn coverage(tree: &Tree, gathered: &Gathered) -> Markup {
    html! {
        section id="coverage" {
            h2 { "Coverage" }
            @if let Some(coverage) = &gathered.coverage {
                p { "Of the sources by the tests, as LLVM counts it (" code { "scripts/coverage.sh" } "). A branch is one \
                     outcome of a condition. Unit tests inside a file count as its code." }
                (stated(&coverage.state, tree))
                div.scroll {
                    table.numbers {
                        thead { tr { th { "File" } th { "Lines" } th { "" } th { "Regions" } th { "" } th { "Branches" } th { "" } } }
                        @for folder in MEASURED {
                            tbody {
                                (figures(folder, &coverage.of(folder), true))
                                @for (file, each) in coverage.files.iter().filter(|(file, _)| file.starts_with(folder)) {
                                    (figures(file, each, false))
                                }
                            }
                        }
                    }
                }
            } @else { p { "Not measured: there is no evidence/coverage.json." } }
        }
    }
}

fn figures(name: &str, figures: &Figures, sum: bool) -> Markup {
    html! {
        tr.sum[sum] {
            td.place { (name) }
            (cell(Some(figures.lines))) (cell(Some(figures.regions))) (cell(figures.branches))
        }
    }
}

fn cell(share: Option<Share>) -> Markup {
    html! {
        @if let Some(share) = share {
            @if share.all > 0 { td.n { (share.percent()) } td.n.dim { (share.reached) "/" (share.all) } }
            @else { td.n.dim { "–" } td {} }
        } @else { td.n { "not measured" } td {} }
    }
}

fn stated(state: &State, tree: &Tree) -> Markup {
    html! {
        @if let Some(remark) = state.freshness(tree).remark() {
            p.warning { strong { "Not of the present sources:" } " " (remark) "." }
        }
        @if let Some(commit) = &state.commit { p.note { "Measured on commit " code { (commit) } "." } }
    }
}

fn mutants(gathered: &Gathered) -> Markup {
    html! {
        section id="mutants" {
            h2 { "Mutants" }
            @if let Some(judged) = &gathered.mutants {
                p { (judged.run.tool) " changed one place of the oracle or of the engine's arithmetic at a time; a test has to fail ("
                    code { "scripts/mutants.sh" } "). A survivor is a missing example, unless a reason says why nothing \
                    observable changed." }
                @if !judged.untried.is_empty() {
                    p.warning { strong { "Not tried in their present state:" } " " (judged.untried.join(", ")) "." }
                }
                @if judged.left() > 0 {
                    p.warning { strong { "Left to be tried in the other sources:" } " " (judged.left()) " mutants." }
                }
                ul.figures {
                    @for (outcome, name) in [(Outcome::Caught, "caught"), (Outcome::Timeout, "timed out"),
                        (Outcome::Missed, "survived"), (Outcome::Unviable, "do not compile")] {
                        li { b { (judged.count(outcome)) } " " (name) }
                    }
                }
                @if judged.survivors().next().is_some() {
                    h3 { "Survivors" }
                    div.scroll {
                        table.statements {
                            thead { tr { th { "Mutant" } th { "Reason" } th { "Rules of the function" } } }
                            tbody {
                                @for mutant in judged.survivors() {
                                    tr {
                                        td.place { (mutant.name) }
                                        td {
                                            @if let Some(reason) = judged.reasons.get(&mutant.name) { (reason) }
                                            @else { span.bad { "none given" } }
                                        }
                                        td { (rule_links(&gathered.rules_in(mutant.file(), &mutant.function))) }
                                    }
                                }
                            }
                        }
                    }
                }
            } @else { p { "Not measured: there is no evidence/mutants.json." } }
        }
    }
}

fn planted(tree: &Tree, gathered: &Gathered) -> Markup {
    html! {
        section id="planted" {
            h2 { "Planted bugs" }
            @if let Some(planted) = &gathered.planted {
                p { "Known-wrong variants of the engine; generated programs have to tell each of them from the oracle." }
                (stated(&planted.state, tree))
                div.scroll {
                    table.statements {
                        thead { tr { th { "Bug" } th { "What is wrong" } th { "Rules" } th.n { "Programs" } th.n { "Bound" } } }
                        tbody {
                            @for bug in &planted.bugs {
                                tr {
                                    td { @if bug.found() { span.good { "✓ " } } @else { span.bad { "✗ " } } code { (bug.bug) } }
                                    td { (bug.description) }
                                    td { (rule_links(&bug.rules)) }
                                    td.n { (number(bug.programs)) }
                                    td.n { (number(bug.bound)) }
                                }
                            }
                        }
                    }
                }
            } @else { p { "Not measured: there is no evidence/planted.json." } }
        }
    }
}

fn number(number: Option<u64>) -> String {
    number.map_or_else(|| "–".to_owned(), |number| number.to_string())
}

/// The section about tools and packages.
pub fn tools(gathered: &Gathered, tools: &[Tool]) -> Markup {
    html! {
        section id="tools" {
            h2 { "Tools and packages" }
            div.scroll {
                table {
                    thead { tr { th { "Tool" } th { "Version" } th { "Said by" } } }
                    tbody { @for tool in tools { tr { td { (tool.name) } td { (tool.version) } td { (tool.said_by) } } } }
                }
            }
            h3 { "Packages" }
            p { "Everything in Cargo.lock, for all platforms and for tests too; with hashes and dependencies in "
                a href="sbom.cdx.json" { "sbom.cdx.json" } "." }
            details.packages {
                summary { (gathered.packages.len()) " packages" }
                div.scroll {
                    table {
                        thead { tr { th { "Package" } th { "Version" } th { "Licence" } } }
                        tbody {
                            @for package in &gathered.packages {
                                tr {
                                    td { (package.name) }
                                    td { (package.version) }
                                    td { (package.licence.as_deref().unwrap_or("not recorded")) }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}
