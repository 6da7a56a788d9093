//! The theorems are documented, none is empty, and the table of `README.md` lists exactly those that exist.

#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};

use turnspec_oracle::vocabulary::RuleId;

/// A statement as its source says it.
#[derive(Default)]
struct Statement {
    family: String,
    name: String,
    refuted: bool,
    sentence: String,
    functions: String,
    assumes: String,
    rules: String,
    body: String,
}

#[test]
fn every_theorem_is_documented() {
    for theorem in statements().iter().filter(|statement| !statement.refuted) {
        let Statement { family, name, sentence, functions, assumes, rules, .. } = theorem;
        for (part, text) in
            [("sentence", sentence), ("Of", functions), ("Assumes", assumes), ("Rules", rules)]
        {
            assert!(!text.is_empty(), "{family}::{name} has no {part}");
        }
        assert!(sentence.ends_with('.') && assumes.ends_with('.'), "{family}::{name}: {sentence} {assumes}");
    }
}

#[test]
fn every_rule_exists() {
    for Statement { family, name, rules, refuted, .. } in statements() {
        if refuted || rules.starts_with("none (") {
            continue;
        }
        for rule in rules.split(", ") {
            assert!(RuleId::parse(rule).is_some(), "{family}::{name} names {rule}");
        }
    }
}

#[test]
fn no_theorem_is_vacuous() {
    for Statement { family, name, body, .. } in statements() {
        assert!(body.contains("assert!"), "{family}::{name} asserts nothing");
    }
    for Statement { family, name, body, refuted, assumes, .. } in statements() {
        let covered = body.contains("kani::cover!");
        assert!(refuted || covered || assumes == "nothing.", "{family}::{name} covers nothing");
    }
}

#[test]
fn every_family_has_a_refuted_twin() {
    let all = statements();
    for theorem in &all {
        let twin = all.iter().any(|other| other.refuted && other.family == theorem.family);
        assert!(twin, "{} has no refuted twin", theorem.family);
    }
    for twin in all.iter().filter(|statement| statement.refuted) {
        assert!(twin.sentence.starts_with("False: "), "{}::{}", twin.family, twin.name);
    }
}

#[test]
fn the_readme_lists_the_theorems() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let listed: Vec<_> = readme.lines().filter(|line| line.starts_with("| `")).collect();
    let expected: Vec<_> = statements().iter().map(row).collect();
    for (listed, expected) in listed.iter().zip(&expected) {
        assert_eq!(listed, expected);
    }
    assert!(listed == expected, "expected:\n{}", expected.join("\n"));
}

#[test]
fn there_are_as_many_theorems_as_the_readme_says() {
    let (theorems, twins): (Vec<_>, Vec<_>) = statements().into_iter().partition(|each| !each.refuted);
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let count = format!("{} theorems and {} refuted twins", theorems.len(), twins.len());
    assert!(readme.contains(&count), "README.md should say: {count}");
}

/// The line of the table for a statement.
fn row(statement: &Statement) -> String {
    let Statement { family, name, refuted, sentence, functions, assumes, rules, .. } = statement;
    if *refuted {
        return format!("| `{family}::{name}` | {sentence} |");
    }
    format!("| `{family}::{name}` | {sentence} | {functions} | {assumes} | {rules} |")
}

/// The statements of all families, theorems first.
fn statements() -> Vec<Statement> {
    let mut statements = Vec::new();
    for path in sources() {
        let family = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        for (opening, refuted) in [("\ntheorems! {\n", false), ("\nrefutations! {\n", true)] {
            let Some((_, rest)) = text.split_once(opening) else { continue };
            let (block, _) = rest.split_once("\n}\n").unwrap();
            statements.extend(in_block(block).map(|each| Statement {
                family: family.clone(),
                refuted,
                ..each
            }));
        }
    }
    statements.sort_by_key(|statement| statement.refuted);
    assert!(statements.len() > 40, "only {} statements found", statements.len());
    statements
}

/// The statements of one block: doc lines, `#[unwind]`, the function down to its closing brace.
fn in_block(block: &str) -> impl Iterator<Item = Statement> {
    let mut statements = Vec::new();
    let (mut current, mut part) = (Statement::default(), String::new());
    for line in block.lines() {
        if let Some(doc) = line.strip_prefix("    /// ") {
            let labelled = ["Of: ", "Assumes: ", "Rules: "]
                .iter()
                .find_map(|label| doc.strip_prefix(label).map(|text| ((*label).to_owned(), text)));
            let (label, text) = labelled.unwrap_or_else(|| (part.clone(), doc));
            let slot = match label.as_str() {
                "Of: " => &mut current.functions,
                "Assumes: " => &mut current.assumes,
                "Rules: " => &mut current.rules,
                _ => &mut current.sentence,
            };
            if !slot.is_empty() {
                slot.push(' ');
            }
            slot.push_str(text);
            part = label;
        } else if let Some(function) = line.strip_prefix("    fn ") {
            current.name = function.split('(').next().unwrap_or_default().to_owned();
        } else if line == "    }" {
            statements.push(std::mem::take(&mut current));
            part.clear();
        } else {
            current.body.push_str(line);
            current.body.push('\n');
        }
    }
    statements.into_iter()
}

/// The sources of the families, by name.
fn sources() -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join("src")).unwrap();
    let mut sources: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    sources.sort();
    sources
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}
