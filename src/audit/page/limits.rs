//! What the semantics leaves open or out: readings, interpretations, what is unspecified, what is not
//! modelled.

use maud::{Markup, html};
use turnspec_oracle::book::RuleText;
use turnspec_oracle::vocabulary::{AlarmName, Reading};

use super::markdown;
use crate::audit::gather::Gathered;

/// The section.
pub fn section(gathered: &Gathered) -> Markup {
    let rules = || gathered.rules.iter().map(|(rule, _)| rule);
    let demanding =
        |alarm: AlarmName| rules().filter(|rule| rule.alarms.contains(&alarm)).collect::<Vec<_>>();
    let based = |basis: &str| rules().filter(|rule| rule.basis == basis).collect::<Vec<_>>();
    html! {
        section id="limits" {
            h2 { "Limits and readings" }
            h3 { "Readings" }
            p { "Choices that the manual leaves open and that a set-up can switch; every event that depends on one \
                 names it. The default stands first." }
            (readings(gathered))
            h3 { "Interpretations" }
            p { "Here the manual is silent, damaged or contradicts itself; the rule’s text says where, what was \
                 taken, and why." }
            (list(&based("interpretation")))
            h3 { "Unspecified" }
            p { "These rules decline to say what happens in some situation: the oracle raises the alarm "
                code { "unspecified" } " and does not guess." }
            (list(&demanding(AlarmName::Unspecified)))
            @if !based("unspecified").is_empty() { (list(&based("unspecified"))) }
            h3 { "Not modelled" }
            p { "The manual tells, this version does not follow yet: the alarm " code { "not_modelled" } " names the \
                 word. These rules demand it:" }
            (list(&demanding(AlarmName::NotModelled)))
            p { "Codes that end a program in " code { "not_modelled" } ", as measured by running each G and M code of up \
                 to three digits alone on the default set-up:" }
            p.codes { @for code in &gathered.not_modelled { code { (code) } " " } }
        }
    }
}

fn readings(gathered: &Gathered) -> Markup {
    let mut names: Vec<(&str, Vec<&str>)> = Vec::new();
    for (name, value) in Reading::ALL.iter().filter_map(|reading| reading.as_str().split_once('=')) {
        match names.last_mut().filter(|(last, _)| *last == name) {
            Some((_, values)) => values.push(value),
            None => names.push((name, vec![value])),
        }
    }
    html! {
        div.scroll {
            table {
                thead { tr { th { "Reading" } th { "Values" } th { "Rule, and the reason in its text" } } }
                tbody {
                    @for (name, values) in &names {
                        tr {
                            td { code { (name) } }
                            td { @for (place, value) in values.iter().enumerate() { @if place > 0 { ", " } code { (value) } } }
                            td {
                                @for (rule, _) in gathered.rules.iter().filter(|(rule, _)| speaks_of(rule, name)) {
                                    details.reason {
                                        summary { (rule.id) " " (rule.title) }
                                        (markdown::render(&rule.statement))
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn speaks_of(rule: &RuleText, reading: &str) -> bool {
    [format!("`{reading}`"), format!("`readings.{reading}`"), format!("`{reading} =")]
        .iter()
        .any(|mention| rule.statement.contains(mention))
}

fn list(rules: &[&RuleText]) -> Markup {
    html! {
        @if rules.is_empty() { p { "None." } } @else {
            ul.rules { @for rule in rules { li { a href={ "#" (rule.id) } { (rule.id) } " " (rule.title) } } }
        }
    }
}
