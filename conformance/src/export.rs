//! Writes the corpus: the hand-written cases and the examples of the rule texts, a file a chapter, and the
//! index.

use std::fmt::Write;

use serde_json::{Map, Value};
use turnspec_oracle::book::{self, Example, RuleText};
use turnspec_oracle::vocabulary::notation::Expectation;
use turnspec_oracle::vocabulary::{Control, Event, ProgramText, RuleId};

use crate::corpus::{CorpusIndex, FORMAT, INDEX, IndexEntry};
use crate::{Basis, Case, Flag, cases, features_of, text_of_bytes};

/// Path and text of each file of the corpus.
///
/// # Errors
/// The first case or example that cannot be exported, in words.
pub fn corpus_files() -> Result<Vec<(String, String)>, String> {
    let mut chapters = vec![("e100l/manual.json".to_owned(), cases()?)];
    for rule in book::e100l()? {
        let path = rule.file.replace(".md", ".json");
        let mut examples = examples(&rule)?;
        match chapters.iter_mut().find(|(chapter, _)| *chapter == path) {
            Some((_, cases)) => cases.append(&mut examples),
            None => chapters.push((path, examples)),
        }
    }
    let entry = |(path, cases): &(String, Vec<Case>)| IndexEntry { path: path.clone(), cases: cases.len() };
    let index = CorpusIndex { format: FORMAT.to_owned(), files: chapters.iter().map(entry).collect() };
    let mut files = vec![(INDEX.to_owned(), json(&index)? + "\n")];
    for (path, cases) in chapters {
        files.push((path, file(&cases)?));
    }
    Ok(files)
}

/// One case a line.
fn file(cases: &[Case]) -> Result<String, String> {
    let mut text = format!("{{\n\"format\": \"{FORMAT}\",\n\"cases\": [");
    for (number, case) in cases.iter().enumerate() {
        let comma = if number == 0 { "" } else { "," };
        let line = serde_json::to_string(case).map_err(|error| format!("{}: {error}", case.id))?;
        let _ = write!(text, "{comma}\n{line}");
    }
    text.push_str("\n]\n}\n");
    Ok(text)
}

fn json(index: &CorpusIndex) -> Result<String, String> {
    serde_json::to_string_pretty(index).map_err(|error| error.to_string())
}

fn examples(rule: &RuleText) -> Result<Vec<Case>, String> {
    let mut cases = Vec::new();
    // Examples that follow each other directly share the paragraph in front of the first.
    let mut introduction = "";
    for (number, example) in (1..).zip(&rule.examples) {
        if !example.introduction.is_empty() {
            introduction = &example.introduction;
        }
        let case = case(rule, number, example, one_line(introduction));
        cases.push(case.map_err(|reason| format!("spec/rules/{}:{}: {reason}", rule.file, example.line))?);
    }
    Ok(cases)
}

/// The case of an example. Its features come from the oracle's trace, what it expects from the text alone.
fn case(rule: &RuleText, number: usize, example: &Example, derivation: String) -> Result<Case, String> {
    let setup = example.setup().map_err(|error| error.to_string())?;
    let mut written: Map<String, Value> =
        toml::from_str(&example.setup).map_err(|error| error.to_string())?;
    if !example.library.is_empty() {
        let text = |(name, text): &(String, ProgramText)| (name.clone(), text_of_bytes(&text.0).into());
        written.insert("library".to_owned(), Value::Object(example.library.iter().map(text).collect()));
    }
    let mut trace = Vec::new();
    turnspec_oracle::run(&example.program, &setup, &mut |event: &Event| trace.push(*event));
    let expect = Expectation::parse(&example.trace).lines().to_vec();
    let mut flags = vec![Flag::RuleExample];
    if expect.iter().any(|line| line.contains(" readings=")) {
        flags.insert(0, Flag::Reading);
    }
    Ok(Case {
        id: format!("e100l/rules/{}/{number}", rule.id),
        title: rule.title.clone(),
        rules: vec![rule.id],
        control: Control::E100l,
        features: features_of(&example.program, &setup, &trace).into_iter().collect(),
        flags,
        source: rule.source.clone(),
        basis: basis(rule.id, &rule.basis)?,
        repairs: String::new(),
        program: text_of_bytes(&example.program),
        setup: written,
        expect,
        stated: Vec::new(),
        derivation,
    })
}

fn basis(rule: RuleId, text: &str) -> Result<Basis, String> {
    match text {
        "manual" => Ok(Basis::Manual),
        "interpretation" => Ok(Basis::Interpretation),
        "unspecified" => Ok(Basis::Unspecified),
        other => Err(format!("{rule} has the basis {other:?}")),
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
