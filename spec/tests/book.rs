//! The rule table: every rule has its text, its function and its examples, and every example holds.

#![allow(clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use turnspec_oracle::book::{self, RuleText};
use turnspec_oracle::vocabulary::notation::Expectation;
use turnspec_oracle::vocabulary::{Event, RuleId};

fn rules() -> Vec<RuleText> {
    book::e100l().unwrap_or_else(|fault| panic!("{fault}"))
}

/// What is wrong with this many examples is wrong with the oracle: the others need not run.
const ENOUGH: usize = 20;

fn faults(faults: Vec<String>) {
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn examples_hold() {
    let mut found = Vec::new();
    for rule in rules() {
        for example in &rule.examples {
            if found.len() == ENOUGH {
                break;
            }
            let place = format!("spec/rules/{}:{} ({})", rule.file, example.line, rule.id);
            let setup = match example.setup() {
                Ok(setup) => setup,
                Err(fault) => {
                    found.push(format!("{place}: {fault}"));
                    continue;
                }
            };
            let mut trace = Vec::new();
            turnspec_oracle::run(&example.program, &setup, &mut |event: &Event| trace.push(*event));
            if let Some((ordinal, event)) = (1..).zip(&trace).find(|(ordinal, event)| event.n != *ordinal) {
                found.push(format!("{place}: event {ordinal} is numbered {}", event.n));
            }
            if let Err(divergence) = Expectation::parse(&example.trace).matches(&trace) {
                found.push(format!("{place}: {divergence}"));
            }
        }
    }
    faults(found);
}

#[test]
fn every_rule_has_one_text() {
    let texts: Vec<RuleId> = rules().iter().map(|rule| rule.id).collect();
    let unique: BTreeSet<RuleId> = texts.iter().copied().collect();
    assert_eq!(unique.len(), texts.len(), "a rule has two texts");
    faults(RuleId::all().filter(|id| !unique.contains(id)).map(|id| format!("{id} has no text")).collect());
}

#[test]
fn rules_have_examples() {
    let mut found = Vec::new();
    for rule in rules() {
        let accepting = rule.examples.iter().any(|example| !example.trace.contains("alarm name="));
        let only_alarms = !rule.alarms.is_empty() && !rule.examples.is_empty();
        if !accepting && !only_alarms && rule.level != "listed" {
            found.push(format!("{} has no accepting example", rule.id));
        }
        for alarm in &rule.alarms {
            let wanted = format!("alarm name={alarm}");
            let rejecting = rule.examples.iter().flat_map(|example| example.trace.lines()).any(|line| {
                line.starts_with(&wanted) && line.split_whitespace().any(|word| word == wanted.split_at(6).1)
            });
            if !rejecting {
                found.push(format!("{} has no example of {alarm}", rule.id));
            }
        }
    }
    faults(found);
}

/// Rule ids in the oracle's source: in full in comments, as constants in code.
fn cited() -> BTreeSet<String> {
    fn walk(folder: &Path, cited: &mut BTreeSet<String>) {
        for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{error}")).flatten() {
            let path = entry.path();
            if path.is_dir() {
                if !path.ends_with("vocabulary") {
                    walk(&path, cited);
                }
            } else {
                let text = fs::read_to_string(&path).unwrap_or_default();
                collect(&text, cited);
            }
        }
    }
    fn collect(text: &str, cited: &mut BTreeSet<String>) {
        let constants: BTreeSet<String> =
            RuleId::all().map(|id| id.as_str().trim_start_matches("E100L-").replace('-', "_")).collect();
        for word in text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')) {
            if constants.contains(word) {
                cited.insert(format!("E100L-{}", word.replace('_', "-")));
            }
        }
        // In comments: `E100L-CIRC-04`, and ranges `E100L-TOOL-01 to -06` or lists `E100L-CAX-02, -05`.
        for line in text.lines().filter(|line| line.trim_start().starts_with("//")) {
            let mut area = String::new();
            let mut last = 0;
            let mut range = false;
            for token in line.split([' ', ',', ';', '(', ')', ':', '.']).filter(|token| !token.is_empty()) {
                if let Some((name, number)) = token.strip_prefix("E100L-").and_then(|id| id.rsplit_once('-'))
                {
                    name.clone_into(&mut area);
                    last = number.parse().unwrap_or(0);
                    cited.insert(format!("E100L-{area}-{last:02}"));
                    range = false;
                } else if token == "to" {
                    range = true;
                } else if let Some(number) = continued(token, &area) {
                    let first = if range { last + 1 } else { number };
                    cited.extend((first..=number).map(|each| format!("E100L-{area}-{each:02}")));
                    last = number;
                    range = false;
                } else if token != "and" {
                    range = false;
                }
            }
        }
    }
    /// The number of `-04` after an id of the same area.
    fn continued(token: &str, area: &str) -> Option<u32> {
        let digits = token.strip_prefix('-').filter(|digits| digits.len() == 2 && !area.is_empty())?;
        digits.parse().ok()
    }
    let mut found = BTreeSet::new();
    walk(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut found);
    found
}

#[test]
fn core_rules_have_functions() {
    let cited = cited();
    let rules = rules();
    let core = rules.iter().filter(|rule| rule.level == "core");
    faults(
        core.filter(|rule| !cited.contains(rule.id.as_str()))
            .map(|rule| format!("{} is cited nowhere", rule.id))
            .collect(),
    );
}

#[test]
fn cited_rules_exist() {
    faults(
        cited()
            .iter()
            .filter(|id| RuleId::parse(id).is_none())
            .map(|id| format!("{id} is cited and has no text"))
            .collect(),
    );
}
