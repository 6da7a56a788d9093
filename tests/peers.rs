//! The other implementations of this repository, through `conform` and `fuzz`: two toys, and LinuxCNC's rs274
//! where it is installed. Where Python 3 or rs274 is not, the tests say so and pass.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use serde_json::Value;

const TURNSPEC: &str = env!("CARGO_BIN_EXE_turnspec");
/// Programs within which a campaign finds all three bugs of the wrong toy.
const RUNS: &str = "160";

/// The command of a Python 3, the system's own first, since a wrapper may take longer than the program.
fn python() -> Option<&'static str> {
    let found = ["/usr/bin/python3", "python3"].into_iter().find(|command| runs(command, &["--version"]));
    if found.is_none() {
        eprintln!("skipped: Python 3 is not installed");
    }
    found
}

/// The command of the adapter for rs274.
fn rs274() -> Option<String> {
    if !runs("rs274", &["-g", "/dev/null"]) {
        eprintln!("skipped: rs274 is not installed (scripts/install-rs274.sh)");
        return None;
    }
    python().map(|python| format!("{python} -s conformance/adapters/rs274/adapter.py"))
}

/// Whether a program can be started.
fn runs(command: &str, arguments: &[&str]) -> bool {
    let mut command = Command::new(command);
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok()
}

/// Exit status, standard output and standard error.
fn turnspec(arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(TURNSPEC);
    let output = command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// The report of `conform`, and its exit status.
fn conform(name: &str, command: &str, declaration: &str) -> (Option<i32>, Value) {
    let json = scratch(&format!("{name}.json"));
    let path = json.to_str().unwrap();
    let (status, _, stderr) =
        turnspec(&["conform", "--impl", command, "--declare", declaration, "--json", path]);
    assert_eq!(stderr, "");
    let report = serde_json::from_slice(&fs::read(&json).unwrap()).unwrap();
    fs::remove_file(json).unwrap();
    (status, report)
}

fn scratch(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("turnspec-{}-peers-{name}", std::process::id()))
}

/// The verdict on a case, and the ids of the rules that explain it.
fn explained(report: &Value, id: &str) -> (String, String) {
    let case = report["cases"].as_array().unwrap().iter().find(|case| case["id"] == id);
    let case = case.unwrap_or_else(|| panic!("{id} is no case"));
    (case["verdict"].as_str().unwrap().to_owned(), case["explanation"].to_string())
}

fn toy(name: &str) -> Option<(String, String)> {
    let python = python()?;
    Some((format!("{python} -s conformance/toys/{name}.py"), format!("conformance/toys/{name}.toml")))
}

#[test]
fn the_right_toy_conforms() {
    let Some((command, declaration)) = toy("right") else { return };
    let (status, report) = conform("right", &command, &declaration);
    assert_eq!(status, Some(0), "{}", report["verdicts"]);
    assert!(report["verdicts"]["pass"].as_u64() > Some(80), "{}", report["verdicts"]);
}

#[test]
fn conform_finds_each_bug_of_the_wrong_toy_and_names_its_rule() {
    let Some((command, declaration)) = toy("wrong") else { return };
    let (status, report) = conform("wrong", &command, &declaration);
    assert_eq!(status, Some(1));
    for rule in ["E100L-ABS-03", "E100L-CIRC-17", "E100L-FEED-03"] {
        let (verdict, explanation) = explained(&report, &format!("e100l/rules/{rule}/1"));
        assert_eq!(verdict, "mismatch", "{rule}");
        assert!(explanation.contains(rule), "{rule}: {explanation}");
    }
}

#[test]
fn a_campaign_finds_nothing_in_the_right_toy() {
    let Some((command, declaration)) = toy("right") else { return };
    let (status, stdout, stderr) =
        turnspec(&["fuzz", "--impl", &command, "--declare", &declaration, "--runs", RUNS]);
    assert_eq!((status, stderr.as_str()), (Some(0), ""), "{stdout}");
    assert!(stdout.starts_with("160 programs: ") && stdout.contains(" 0 disagree"), "{stdout}");
    let agreed = stdout.split([' ', ',']).nth(2).and_then(|count| count.parse::<u64>().ok());
    assert!(agreed > Some(75), "{stdout}");
}

#[test]
fn a_campaign_finds_each_bug_of_the_wrong_toy_apart() {
    let Some((command, declaration)) = toy("wrong") else { return };
    let (status, stdout, stderr) =
        turnspec(&["fuzz", "--impl", &command, "--declare", &declaration, "--runs", RUNS]);
    assert_eq!((status, stderr.as_str()), (Some(1), ""), "{stdout}");
    let headings: Vec<&str> =
        stdout.lines().filter(|line| line.starts_with("E100L-") && line.ends_with("disagreements")).collect();
    let has = |rules: &[&str]| {
        headings.iter().any(|heading| rules.iter().any(|rule| heading.starts_with(&format!("{rule} "))))
    };
    assert!(has(&["E100L-ABS-03"]), "{stdout}");
    assert!(has(&["E100L-CIRC-12", "E100L-CIRC-17", "E100L-CIRC-18"]), "{stdout}");
    assert!(has(&["E100L-FEED-03"]), "{stdout}");
}

#[test]
fn rs274_conforms_as_far_as_its_declaration_goes() {
    let Some(command) = rs274() else { return };
    let (status, report) = conform("rs274", &command, "conformance/adapters/rs274/rs274.toml");
    assert_eq!(status, Some(0), "{report}");
    assert!(report["verdicts"]["pass"].as_u64() > Some(90), "{}", report["verdicts"]);
}

#[test]
fn a_campaign_against_rs274_finds_nothing_that_the_ledger_does_not_explain() {
    let Some(command) = rs274() else { return };
    let declaration = "conformance/adapters/rs274/rs274.toml";
    let (status, stdout, stderr) =
        turnspec(&["fuzz", "--impl", &command, "--declare", declaration, "--runs", "128", "--seed", "2"]);
    assert_eq!((status, stderr.as_str()), (Some(0), ""), "{stdout}");
}

#[test]
fn compensated_contours_agree_with_rs274_or_diverge_as_the_ledger_explains() {
    let (Some(command), Some(python)) = (rs274(), python()) else { return };
    let corpus = scratch("contours.json");
    let path = corpus.to_str().unwrap();
    let mut contours = Command::new(python);
    contours.args(["conformance/adapters/rs274/contours.py", "--count", "48", "--turnspec", TURNSPEC]);
    contours.current_dir(env!("CARGO_MANIFEST_DIR"));
    fs::write(&corpus, contours.output().unwrap().stdout).unwrap();
    let declaration = "conformance/adapters/rs274/rs274.toml";
    let (status, stdout, stderr) =
        turnspec(&["conform", "--impl", &command, "--declare", declaration, "--corpus", path]);
    fs::remove_file(&corpus).unwrap();
    assert_eq!((status, stderr.as_str()), (Some(0), ""), "{stdout}");
    let last = stdout.lines().last().unwrap_or_default();
    let passed = last.split(' ').skip_while(|word| *word != "cases:").nth(1);
    assert!(passed.and_then(|count| count.parse::<u64>().ok()) > Some(30), "{last}");
}

#[test]
fn every_waiver_of_rs274_refers_to_an_entry_of_the_ledger() {
    let directory = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("conformance/adapters/rs274");
    let ledger = fs::read_to_string(directory.join("LEDGER.md")).unwrap();
    let declaration: toml::Table = fs::read_to_string(directory.join("rs274.toml")).unwrap().parse().unwrap();
    let waivers = declaration["waiver"].as_array().unwrap();
    assert!(!waivers.is_empty());
    for waiver in waivers {
        let reason = waiver["reason"].as_str().unwrap();
        let number = reason.strip_prefix("ledger ").and_then(|rest| rest.split(':').next()).unwrap();
        let heading = format!("\n### {number} · ");
        let entry = ledger.split(&heading).nth(1).unwrap_or_else(|| panic!("no entry for {reason:?}"));
        let entry = entry.split("\n### ").next().unwrap();
        let rule = match waiver.get("rule") {
            Some(rule) => rule.as_str(),
            None => waiver["case"].as_str().and_then(|case| case.split('/').nth(2)),
        };
        let rule = rule.unwrap();
        assert!(entry.contains(rule), "{rule} is not in entry {number}");
    }
}

#[test]
fn refusals_and_limited_waivers_count_as_the_declaration_says() {
    let declaration = scratch("declaration.toml");
    let conform = |command: &str, rest: &str| {
        fs::write(&declaration, format!("name = 'a'\n{rest}")).unwrap();
        let declared = declaration.to_str().unwrap();
        let filter = "e100l/rules/E100L-DWELL-01/2";
        turnspec(&["conform", "--impl", command, "--declare", declared, "--filter", filter])
    };
    let refusing = "sh -c 'cat >/dev/null; exit 3'";
    assert_eq!(conform(refusing, "").0, Some(1));
    assert_eq!(conform(refusing, "refusals = 'skip'").0, Some(0));
    // The case demands an alarm, this implementation ends the program.
    let ending = r#"sh -c 'cat >/dev/null; echo "{\"kind\": \"end\", \"code\": \"M02\"}"'"#;
    let waiver = |rest: &str| format!("[[waiver]]\nrule = 'E100L-DWELL-01'\nreason = 'known'\n{rest}");
    for (rest, status) in [
        ("", 0),
        ("field = 'kind'", 0),
        ("field = 'time'", 1),
        ("got = 'end code=M02'", 0),
        ("got = 'dwell'", 1),
    ] {
        let (found, stdout, stderr) = conform(ending, &waiver(rest));
        assert_eq!((found, stderr.as_str()), (Some(status), ""), "{rest}: {stdout}");
    }
    fs::remove_file(declaration).unwrap();
}
