//! Nose radius compensation, thread cutting and LAP in mode I against the implementations in Python that were written from the rule
//! text alone (`conformance/reference`): examples of the rules, conformance cases, random contours and cycles. Where
//! Python 3.11 is not, the tests say so and pass.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::process::{Command, Stdio};

const TURNSPEC: &str = env!("CARGO_BIN_EXE_turnspec");
const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const COMPENSATION: &str = "compensation.py";
const THREADS: &str = "threads.py";
const LAP: &str = "lap.py";
/// The chapters whose examples are computed, with the fewest examples that have to lie within the subset.
const CHAPTERS_OF_COMPENSATION: [(&str, usize); 11] = [
    ("compensation", 38),
    ("compensation-entry", 50),
    ("compensation-corners", 26),
    ("compensation-arcs", 26),
    ("compensation-waiting", 23),
    ("cutter-compensation", 14),
    ("arcs", 40),
    ("chamfers", 34),
    ("coordinates", 20),
    ("motion", 8),
    ("c-axis", 14),
];
const CHAPTERS_OF_THREADS: [(&str, usize); 5] = [
    ("threads", 39),
    ("threads-continuous", 13),
    ("thread-common", 37),
    ("thread-cycles", 34),
    ("thread-infeed", 26),
];

const CHAPTERS_OF_LAP: [(&str, usize); 4] =
    [("lap-contours", 6), ("lap-common", 14), ("lap-calls", 7), ("lap-bar-turning", 19)];

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

/// Exit status and standard output of a reference; what it writes to standard error is a fault.
fn reference<S: AsRef<str>>(python: &str, script: &str, arguments: &[S]) -> (Option<i32>, String) {
    let mut command = Command::new(python);
    command.arg("-B").arg(format!("conformance/reference/{script}")).current_dir(ROOT);
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
fn examples_of_compensation_agree() {
    examples_agree(COMPENSATION, &CHAPTERS_OF_COMPENSATION);
}

#[test]
fn examples_of_threads_agree() {
    examples_agree(THREADS, &CHAPTERS_OF_THREADS);
}

#[test]
fn examples_of_lap_agree() {
    examples_agree(LAP, &CHAPTERS_OF_LAP);
}

fn examples_agree(script: &str, chapters: &[(&str, usize)]) {
    let Some(python) = python() else { return };
    let paths = chapters.iter().map(|(chapter, _)| format!("spec/rules/e100l/{chapter}.md"));
    let arguments: Vec<String> = ["--check".to_owned()].into_iter().chain(paths).collect();
    let (status, stdout) = reference(python, script, &arguments);
    assert_eq!(status, Some(0), "{stdout}");
    assert_eq!(stdout.lines().count(), chapters.len(), "{stdout}");
    for (line, (chapter, least)) in stdout.lines().zip(chapters) {
        assert!(agreeing(line) >= *least, "{chapter}: {line}");
    }
}

#[test]
fn cases_agree_and_those_of_compensation_are_all_computed() {
    cases_agree(COMPENSATION, &["s6-"]);
}

#[test]
fn cases_agree_and_those_of_threads_are_all_computed() {
    cases_agree(THREADS, &["s7-g3", "s7-g71", "s7-g72"]);
}

/// `sections`: the beginnings of the names of the cases that lie within the subset.
fn cases_agree(script: &str, sections: &[&str]) {
    let Some(python) = python() else { return };
    let entries = fs::read_dir(format!("{ROOT}/conformance/cases/e100l")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let (own, others): (Vec<String>, Vec<String>) = names
        .filter(|name| name.ends_with(".json"))
        .partition(|name| sections.iter().any(|section| name.starts_with(section)));
    let arguments = |names: &[String]| -> Vec<String> {
        let paths = names.iter().map(|name| format!("conformance/cases/e100l/{name}"));
        ["--cases".to_owned()].into_iter().chain(paths).collect()
    };
    let (status, stdout) = reference(python, script, &arguments(&others));
    assert_eq!(status, Some(0), "{stdout}");
    assert!(agreeing(&stdout) > 0, "{stdout}");
    let (status, stdout) = reference(python, script, &arguments(&own));
    assert_eq!((status, agreeing(&stdout)), (Some(0), own.len()), "{stdout}");
    assert!(!own.is_empty());
}

#[test]
fn random_contours_agree_with_engine_and_oracle() {
    random_programs_agree(COMPENSATION, "contour");
}

#[test]
fn random_cycles_agree_with_engine_and_oracle() {
    let Some(stdout) = random_programs_agree(THREADS, "cycle") else { return };
    // Patterns, flanks, starts, chamfers, tapers and changes of the lead are all among them.
    for rule in ["TINF-02", "TINF-03", "TINF-04", "TINF-05", "TINF-06", "TINF-07", "TMOD-03", "TMOD-04"]
        .into_iter()
        .chain(["TMUL-01", "TMUL-02", "TCHM-04", "G33-06", "G33-07", "G71-05", "G71-07", "G72-03", "G34-02"])
    {
        let count =
            stdout.split_once(&format!("{rule} ")).and_then(|(_, rest)| rest.split([',', '\n']).next());
        assert!(count.and_then(|count| count.parse::<u32>().ok()) > Some(5), "{rule}: {stdout}");
    }
}

#[test]
fn random_contours_of_lap_agree_with_engine_and_oracle() {
    let Some(stdout) = random_programs_agree(LAP, "contour") else { return };
    // Recesses, the way out of them, change points and transverse contours are among them.
    for rule in ["AP1-10", "AP1-11", "AP1-12", "AP1-14", "LAPC-03", "LAP-21"] {
        assert!(stdout.contains(&format!("{rule} ")), "{rule}: {stdout}");
    }
}

/// Runs 200 random programs; what is printed.
fn random_programs_agree(script: &str, noun: &str) -> Option<String> {
    let python = python()?;
    let engine = format!("'{TURNSPEC}' run --format jsonl --with engine --setup {{setup}} {{program}}");
    let oracle = engine.replace("engine", "oracle");
    let option = format!("--{noun}s");
    let arguments = [option.as_str(), "200", "--seed", "1", "--with", &engine, "--with", &oracle];
    let (status, stdout) = reference(python, script, &arguments);
    assert_eq!(status, Some(0), "{stdout}");
    let ends = stdout.strip_prefix(&format!("200 {noun}s, "));
    let ends = ends.and_then(|rest| rest.split(' ').next()?.parse::<u32>().ok());
    assert!(ends > Some(100), "most {noun}s should reach their end: {stdout}");
    assert_eq!(stdout.matches(&format!(": 200 of 200 {noun}s agree")).count(), 2, "{stdout}");
    Some(stdout)
}

#[test]
fn an_implementation_without_nose_radii_is_found() {
    an_implementation_without_set_up_is_found(COMPENSATION, "contour");
}

#[test]
fn an_implementation_without_readings_is_found() {
    an_implementation_without_set_up_is_found(THREADS, "cycle");
}

fn an_implementation_without_set_up_is_found(script: &str, noun: &str) {
    let Some(python) = python() else { return };
    let without_setup = format!("'{TURNSPEC}' run --format jsonl {{program}}");
    let option = format!("--{noun}s");
    let (status, stdout) = reference(python, script, &[option.as_str(), "10", "--with", &without_setup]);
    assert_eq!(status, Some(1), "{stdout}");
    for part in [" of seed 1 differs:\nN1 G00", "set-up:\n", "expected: ", "got: "] {
        assert!(stdout.contains(part), "{part:?} is missing: {stdout}");
    }
}
