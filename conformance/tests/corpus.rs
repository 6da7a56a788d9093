//! The checked-in corpus is current and whole, both implementations satisfy it, and a corpus that is not
//! whole is told from one that is.

#![allow(clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use turnspec_conformance::{Flag, cases, corpus, corpus_files};
use turnspec_oracle::book;
use turnspec_oracle::vocabulary::Event;
use turnspec_oracle::vocabulary::notation::Expectation;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus")
}

#[test]
fn the_checked_in_corpus_is_current() {
    for (path, text) in corpus_files().unwrap_or_else(|error| panic!("{error}")) {
        let checked_in = fs::read_to_string(root().join(&path)).unwrap_or_default();
        assert!(
            checked_in == text,
            "{path} is out of date: cargo run -p turnspec-conformance --example export"
        );
    }
}

#[test]
fn the_program_carries_the_whole_corpus() {
    let files = corpus_files().unwrap_or_else(|error| panic!("{error}"));
    let carried: BTreeSet<&str> = corpus::embedded_paths().chain([corpus::INDEX]).collect();
    assert_eq!(files.iter().map(|(path, _)| path.as_str()).collect::<BTreeSet<&str>>(), carried);

    let ids = |exercises: Vec<turnspec_conformance::Exercise>| -> BTreeSet<String> {
        exercises.into_iter().map(|each| each.case.id).collect()
    };
    let embedded = corpus::embedded().unwrap_or_else(|error| panic!("{error}"));
    let read = corpus::read(&root()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(ids(embedded), ids(read));
}

#[test]
fn every_example_is_a_case() {
    let rules = book::e100l().unwrap_or_else(|error| panic!("{error}"));
    let examples: usize = rules.iter().map(|rule| rule.examples.len()).sum();
    let embedded = corpus::embedded().unwrap_or_else(|error| panic!("{error}"));
    let cases = embedded.iter().filter(|each| each.case.flags.contains(&Flag::RuleExample));
    assert_eq!(cases.clone().count(), examples);
    for exercise in cases {
        let (_, rule) = exercise.case.id.split_once("/rules/").unwrap_or_default();
        let (rule, number) = rule.rsplit_once('/').unwrap_or_default();
        let text = rules.iter().find(|text| text.id.as_str() == rule);
        let number: usize = number.parse().unwrap_or(0);
        let example = text.and_then(|text| text.examples.get(number.wrapping_sub(1)));
        let example = example.unwrap_or_else(|| panic!("{}: no such example", exercise.case.id));
        assert_eq!(exercise.program, example.program, "{}", exercise.case.id);
        assert_eq!(example.setup().ok().as_ref(), Some(&exercise.setup), "{}", exercise.case.id);
        assert_eq!(Expectation::parse(&example.trace).lines(), exercise.case.expect, "{}", exercise.case.id);
    }
}

#[test]
fn both_implementations_satisfy_the_corpus() {
    for exercise in corpus::embedded().unwrap_or_else(|error| panic!("{error}")) {
        let (mut oracle, mut engine) = (Vec::new(), Vec::new());
        turnspec_oracle::run(&exercise.program, &exercise.setup, &mut |event: &Event| oracle.push(*event));
        turnspec::engine::run(&exercise.program, &exercise.setup, &mut |event: &Event| engine.push(*event));
        for trace in [oracle, engine] {
            assert_eq!(exercise.case.check(&trace), Ok(()), "{}", exercise.case.id);
        }
    }
}

/// A copy of a small corpus that a test may damage.
struct Copy(PathBuf);

impl Copy {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("turnspec-{}-corpus-{name}", std::process::id()));
        let copy = Self(folder);
        let case =
            fs::read_to_string(root().join("e100l/motion.json")).unwrap_or_else(|error| panic!("{error}"));
        copy.write("e100l/motion.json", &case);
        let count = case.matches("\n{\"id\"").count();
        copy.write(
            "index.json",
            &format!(
                r#"{{"format": "0.2.0", "files": [{{"path": "e100l/motion.json", "cases": {count}}}]}}"#
            ),
        );
        copy
    }

    fn write(&self, path: &str, text: &str) {
        let file = self.0.join(path);
        let folder = file.parent().unwrap_or(Path::new("/"));
        fs::create_dir_all(folder)
            .and_then(|()| fs::write(&file, text))
            .unwrap_or_else(|error| panic!("{error}"));
    }

    fn text(&self, path: &str) -> String {
        fs::read_to_string(self.0.join(path)).unwrap_or_else(|error| panic!("{error}"))
    }

    fn error(&self) -> String {
        match corpus::read(&self.0) {
            Ok(_) => panic!("the corpus is accepted"),
            Err(error) => error.to_string(),
        }
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn assert_says(error: &str, parts: &[&str]) {
    assert!(parts.iter().all(|part| error.contains(part)), "{error}");
}

#[test]
fn a_whole_copy_is_read() {
    let copy = Copy::new("whole");
    assert!(corpus::read(&copy.0).is_ok());
    assert!(corpus::read(&copy.0.join("e100l")).is_ok(), "a folder without index");
    assert!(corpus::read(&copy.0.join("e100l/motion.json")).is_ok(), "a file");
    let hand_written = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    let count = cases().unwrap_or_else(|error| panic!("{error}")).len();
    assert_eq!(corpus::read(&hand_written).map(|cases| cases.len()).ok(), Some(count), "single cases");
}

#[test]
fn a_truncated_file_is_told_with_its_place() {
    let copy = Copy::new("truncated");
    let text = copy.text("e100l/motion.json");
    copy.write("e100l/motion.json", &text[..text.len() / 2]);
    assert_says(&copy.error(), &["motion.json:", "cut off"]);
    let lines: Vec<&str> = text.lines().collect();
    copy.write(
        "e100l/motion.json",
        &[&lines[..3], &[lines[3].trim_end_matches(',')], &["]}"]].concat().join("\n"),
    );
    assert_says(&copy.error(), &["motion.json", "1 cases, but the index says"]);
    copy.write("e100l/motion.json", "");
    assert_says(&copy.error(), &["motion.json:1:0", "cut off"]);
}

#[test]
fn missing_and_surplus_files_are_told() {
    let copy = Copy::new("missing");
    copy.write("e100l/motion.json.tmp", "{");
    assert_says(&copy.error(), &["motion.json.tmp"]);
    let _ = fs::remove_file(copy.0.join("e100l/motion.json.tmp"));
    copy.write("e100l/more.json", r#"{"format": "0.2.0", "cases": []}"#);
    assert_says(&copy.error(), &["more.json", "not in the index"]);
    let _ = fs::remove_file(copy.0.join("e100l/motion.json"));
    assert_says(&copy.error(), &["motion.json", "missing"]);
    let _ = fs::remove_dir_all(&copy.0);
    assert_says(&copy.error(), &["corpus-missing"]);
}

#[test]
fn formats_and_fields_are_checked() {
    let copy = Copy::new("format");
    let text = copy.text("e100l/motion.json");
    for (from, to, parts) in [
        ("\"0.2.0\"", "\"0.3.0\"", &["motion.json", "format 0.3.0 is newer"][..]),
        ("\"0.2.0\"", "\"0.1.0\"", &["motion.json", "format 0.1.0 is no longer read"]),
        ("\"0.2.0\"", "\"two\"", &["motion.json", "\"two\" is no version"]),
        ("\"format\": \"0.2.0\",", "", &["motion.json", "no `format`"]),
        ("\"title\":", "\"tittle\":", &["motion.json:4:", "tittle"]),
        ("\"setup\":{}", "\"setup\":{\"colour\":1}", &["motion.json", "case e100l/rules/", "colour"]),
        ("\"program\":\"", "\"program\":\"€", &["motion.json", "case e100l/rules/", "U+00FF"]),
        ("\"expect\":[\"", "\"expect\":[\"rapid x ", &["motion.json", "case e100l/rules/", "key=value"]),
        ("G01-03/2\"", "G01-03/1\"", &["motion.json: two cases with the id e100l/rules/E100L-G01-03/1"]),
        ("\"rules\":[\"", "\"rules\":[\"E100L-NO-99\",\"", &["motion.json:4:", "E100L-NO-99"]),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        copy.write("e100l/motion.json", &changed);
        assert_says(&copy.error(), parts);
    }
    copy.write("e100l/motion.json", &text);
    copy.write("index.json", r#"{"format": "1.0.0", "files": []}"#);
    assert_says(&copy.error(), &["index.json", "newer"]);
    copy.write("index.json", r#"{"format": "0.2.0", "files": [], "more": 1}"#);
    assert_says(&copy.error(), &["index.json", "more"]);
}

#[test]
fn an_id_of_two_files_is_told_with_both() {
    let copy = Copy::new("twice");
    let _ = fs::remove_file(copy.0.join("index.json"));
    copy.write("e100l/other.json", &copy.text("e100l/motion.json"));
    assert_says(&copy.error(), &["other.json: case e100l/", "motion.json has a case with this id"]);
}

#[test]
fn what_is_no_object_is_told_in_plain_words() {
    let copy = Copy::new("object");
    for text in ["null", "[]", " [null, null]", "rubbish", "1"] {
        copy.write("e100l/motion.json", text);
        assert_says(&copy.error(), &["motion.json: this is not a case"]);
    }
    copy.write("e100l/motion.json", r#"{"format": "0.2.0", "cases": [null]}"#);
    assert_says(&copy.error(), &["motion.json:1:", "expected a case: a JSON object"]);
    copy.write("index.json", "[]");
    assert_says(&copy.error(), &["index.json: this is not an index"]);
}
