//! Nose radius compensation against the implementation in Python that was written from the rule text alone
//! (`conformance/reference`): examples of the rules, conformance cases, and random contours. Where Python 3.11 is
//! not, the tests say so and pass.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::process::{Command, Stdio};

const TURNSPEC: &str = env!("CARGO_BIN_EXE_turnspec");
const ROOT: &str = env!("CARGO_MANIFEST_DIR");
/// The chapters whose examples are computed, with the fewest examples that have to lie within the subset.
const CHAPTERS: [(&str, usize); 11] = [
    ("compensation", 38),
    ("compensation-entry", 50),
    ("compensation-corners", 26),
    ("compensation-arcs", 26),
    ("compensation-waiting", 23),
    ("cutter-compensation", 16),
    ("arcs", 40),
    ("chamfers", 34),
    ("coordinates", 20),
    ("motion", 8),
    ("c-axis", 14),
];

/// The command of a Python that knows TOML, that is 3.11 or later.
fn python() -> Option<&'static str> {
    let knows_toml = |command: &&str| {
        let mut command = Command::new(command);
        command
            .args(["-c", "import tomllib"])
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    let found = ["/usr/bin/python3", "python3"].into_iter().find(knows_toml);
    if found.is_none() {
        eprintln!("skipped: Python 3.11 or later is not installed");
    }
    found
}

/// Exit status and standard output of the reference; what it writes to standard error is a fault.
fn reference<S: AsRef<str>>(python: &str, arguments: &[S]) -> (Option<i32>, String) {
    let mut command = Command::new(python);
    command.args(["-B", "conformance/reference/compensation.py"]).current_dir(ROOT);
    let output = command.args(arguments.iter().map(AsRef::as_ref)).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), String::from_utf8(output.stdout).unwrap())
}

/// The number in front of `agree` in a line about a chapter or about cases.
fn agreeing(line: &str) -> usize {
    let count = line
        .trim_end()
        .split(": ")
        .nth(1)
        .and_then(|counts| counts.strip_suffix(" differ")?.split(' ').next());
    count.and_then(|count| count.parse().ok()).unwrap_or_else(|| panic!("no counts: {line}"))
}

#[test]
fn the_examples_of_the_rules_agree() {
    let Some(python) = python() else { return };
    let chapters = CHAPTERS.map(|(chapter, _)| format!("spec/rules/e100l/{chapter}.md"));
    let arguments: Vec<&str> = ["--check"].into_iter().chain(chapters.iter().map(String::as_str)).collect();
    let (status, stdout) = reference(python, &arguments);
    assert_eq!(status, Some(0), "{stdout}");
    assert_eq!(stdout.lines().count(), CHAPTERS.len(), "{stdout}");
    for (line, (chapter, least)) in stdout.lines().zip(CHAPTERS) {
        assert!(agreeing(line) >= least, "{chapter}: {line}");
    }
}

#[test]
fn conformance_cases_agree_and_those_of_compensation_are_all_computed() {
    let Some(python) = python() else { return };
    let entries = fs::read_dir(format!("{ROOT}/conformance/cases/e100l")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let (of_compensation, others): (Vec<String>, Vec<String>) =
        names.filter(|name| name.ends_with(".json")).partition(|name| name.starts_with("s6-"));
    let arguments = |names: &[String]| -> Vec<String> {
        let paths = names.iter().map(|name| format!("conformance/cases/e100l/{name}"));
        ["--cases".to_owned()].into_iter().chain(paths).collect()
    };
    let (status, stdout) = reference(python, &arguments(&others));
    assert_eq!(status, Some(0), "{stdout}");
    assert!(agreeing(&stdout) > 0, "{stdout}");
    if !of_compensation.is_empty() {
        let (status, stdout) = reference(python, &arguments(&of_compensation));
        assert_eq!((status, agreeing(&stdout)), (Some(0), of_compensation.len()), "{stdout}");
    }
}

#[test]
fn random_contours_agree_with_engine_and_oracle() {
    let Some(python) = python() else { return };
    let engine = format!("'{TURNSPEC}' run --format jsonl --with engine --setup {{setup}} {{program}}");
    let oracle = engine.replace("engine", "oracle");
    let (status, stdout) =
        reference(python, &["--contours", "200", "--seed", "1", "--with", &engine, "--with", &oracle]);
    assert_eq!(status, Some(0), "{stdout}");
    let ends =
        stdout.strip_prefix("200 contours, ").and_then(|rest| rest.split(' ').next()?.parse::<u32>().ok());
    assert!(ends > Some(100), "most contours should reach their end: {stdout}");
    assert_eq!(stdout.matches(": 200 of 200 contours agree").count(), 2, "{stdout}");
}

#[test]
fn an_implementation_without_nose_radii_is_found() {
    let Some(python) = python() else { return };
    let without_setup = format!("'{TURNSPEC}' run --format jsonl {{program}}");
    let (status, stdout) = reference(python, &["--contours", "10", "--with", &without_setup]);
    assert_eq!(status, Some(1), "{stdout}");
    for part in [" of seed 1 differs:\nN1 G00", "set-up:\n", "expected: ", "got: "] {
        assert!(stdout.contains(part), "{part:?} is missing: {stdout}");
    }
}
