//! Campaigns from outside: the same findings whatever the number of jobs, interruption and resumption, states
//! that are refused, implementations that fail altogether.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

const TURNSPEC: &str = env!("CARGO_BIN_EXE_turnspec");

/// A directory that is removed with the test.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        Self(std::env::temp_dir().join(format!("turnspec-{}-campaign-{name}", std::process::id())))
    }

    fn path(&self) -> &str {
        self.0.to_str().unwrap()
    }

    fn state(&self) -> PathBuf {
        self.0.join("campaign.json")
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Our own answers, the dwells a second longer: an implementation with one bug.
fn with_a_bug() -> String {
    let script = format!(
        "out=$({TURNSPEC} answer); status=$?; printf %s \"$out\" | \
         sed \"s/\\\"kind\\\":\\\"dwell\\\",\\\"time\\\":\\\"/&1/\"; echo; exit $status"
    );
    format!("sh -c '{script}'")
}

fn fuzz(arguments: &[&str]) -> Command {
    let mut command = Command::new(TURNSPEC);
    command.arg("fuzz").args(arguments).stdin(Stdio::null());
    command
}

/// Exit status, standard output and standard error.
fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = fuzz(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn json(path: &Path) -> serde_json::Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

#[test]
fn our_own_answers_agree() {
    let command = format!("{TURNSPEC} answer --with engine");
    let (status, stdout, stderr) = run(&["--impl", &command, "--runs", "100"]);
    assert_eq!((status, stderr.as_str()), (Some(0), ""));
    assert!(stdout.contains("100 programs: 100 agree, 0 disagree"), "{stdout}");
}

#[test]
fn the_number_of_jobs_changes_nothing_and_the_finding_is_a_case() {
    let (one, many) = (Scratch::new("one"), Scratch::new("many"));
    let bug = with_a_bug();
    let common = ["--impl", &bug, "--runs", "100", "--seed", "3"];
    for (jobs, scratch) in [("1", &one), ("5", &many)] {
        let (status, stdout, stderr) =
            run(&[&common[..], &["--jobs", jobs, "--out", scratch.path()]].concat());
        assert_eq!((status, stderr.as_str()), (Some(1), ""), "{stdout}");
        assert!(stdout.contains("E100L-DWELL-0"), "{stdout}");
    }
    assert_eq!(json(&one.state()), json(&many.state()));
    let findings = json(&one.state())["findings"].as_array().unwrap().clone();
    for finding in &findings {
        assert_eq!(finding["signature"]["class"], "dwell: other time");
        let id = finding["case"]["id"].as_str().unwrap();
        let file = format!("{}.json", id.rsplit('/').next().unwrap());
        assert_eq!(json(&one.0.join(&file)), finding["case"]);
        assert_eq!(finding["case"]["flags"][0], "generated");
        let program = finding["case"]["program"].as_str().unwrap();
        assert!(program.len() < 60, "{program:?} is not small");
        let case: turnspec_conformance::Case = serde_json::from_value(finding["case"].clone()).unwrap();
        case.setup().unwrap();
    }
    assert!(!findings.is_empty());
}

#[test]
fn an_interrupted_campaign_comes_to_the_same_end() {
    let whole = Scratch::new("whole");
    let bug = with_a_bug();
    let common = ["--impl", &bug, "--runs", "256"];
    let (_, expected, _) = run(&[&common[..], &["--out", whole.path()]].concat());
    for signal in ["-KILL", "-INT"] {
        let parts = Scratch::new(&format!("parts{signal}"));
        interrupted(&[&common[..], &["--out", parts.path()]].concat(), &parts, signal);
        let (_, resumed, stderr) = run(&[&common[..], &["--out", parts.path()]].concat());
        assert_eq!(stderr, "");
        assert_eq!(fs::read(whole.state()).unwrap(), fs::read(parts.state()).unwrap());
        assert_eq!(resumed.replace(parts.path(), whole.path()), expected);
    }
}

/// Begins a campaign of 256 runs and ends it by a signal as soon as there is a state.
fn interrupted(arguments: &[&str], parts: &Scratch, signal: &str) {
    let mut child = fuzz(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let start = Instant::now();
    while !parts.state().exists() && start.elapsed() < Duration::from_secs(120) {
        thread::sleep(Duration::from_millis(5));
    }
    send(signal, child.id());
    child.wait().unwrap();
    let done = json(&parts.state())["done"].as_u64().unwrap();
    assert!((1..256).contains(&done), "{done} programs were run");
}

fn send(signal: &str, id: u32) {
    let status = Command::new("kill").args([signal, &id.to_string()]).status().unwrap();
    assert!(status.success());
}

/// An implementation that hangs at its seventh program until it is let go.
#[test]
fn an_interruption_keeps_what_was_finished_and_says_so() {
    let (scratch, files) = (Scratch::new("finished"), Scratch::new("hanging"));
    fs::create_dir_all(&files.0).unwrap();
    let script = format!(
        "cd {}; echo >> calls; [ $(wc -l < calls) -gt 6 ] && [ ! -e go ] && exec sleep 1000; exec {TURNSPEC} answer",
        files.path()
    );
    let command = format!("sh -c '{script}'");
    let campaign =
        |more: &[&str]| fuzz(&[&["--impl", &command, "--runs", "10", "--timeout", "600"], more].concat());
    let interrupt = |more: &[&str]| {
        let _ = fs::remove_file(files.0.join("calls"));
        let child = campaign(&[&["--jobs", "1"], more].concat()).stderr(Stdio::piped()).spawn().unwrap();
        let calls = || fs::read_to_string(files.0.join("calls")).unwrap_or_default().lines().count();
        let start = Instant::now();
        while calls() < 7 && start.elapsed() < Duration::from_secs(120) {
            thread::sleep(Duration::from_millis(5));
        }
        send("-INT", child.id());
        let output = child.wait_with_output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    let (status, stderr) = interrupt(&[]);
    assert_eq!(status, Some(2));
    assert!(stderr.contains("interrupted after 6 programs; without --out nothing is kept"), "{stderr}");
    let (status, stderr) = interrupt(&["--out", scratch.path()]);
    assert_eq!(status, Some(2));
    assert!(stderr.contains("interrupted; 6 programs are kept in "), "{stderr}");
    assert_eq!(json(&scratch.state())["done"], 6);
    fs::write(files.0.join("go"), "").unwrap();
    let output = campaign(&["--out", scratch.path()]).output().unwrap();
    assert!(output.stdout.starts_with(b"10 programs: "), "{output:?}");
}

/// Every program ends in one of many crashes; one reduction takes 500 runs at most.
#[test]
fn after_the_last_finding_that_is_wanted_nothing_is_reduced() {
    let files = Scratch::new("wanted");
    fs::create_dir_all(&files.0).unwrap();
    let script = format!("echo >> {}/calls; exit $((10 + $(cksum | cut -d\" \" -f1) % 90))", files.path());
    let (status, stdout, _) = run(&[
        "--impl",
        &format!("sh -c '{script}'"),
        "--runs",
        "1000",
        "--jobs",
        "1",
        "--max-findings",
        "1",
    ]);
    assert_eq!(status, Some(1));
    assert!(stdout.starts_with("1 programs: 0 agree, 1 disagree"), "{stdout}");
    let calls = fs::read_to_string(files.0.join("calls")).unwrap().lines().count();
    assert!(calls <= 504, "{calls} runs");
}

#[test]
fn control_characters_of_an_implementation_are_escaped() {
    for script in [
        r#"cat >/dev/null; printf "%s\n" "{\"kind\":\"a\\u001b[31m\"}""#,
        r#"cat >/dev/null; printf "a\033[31m\n" >&2; exit 7"#,
    ] {
        let command = format!("sh -c '{script}'");
        let (status, stdout, _) = run(&["--impl", &command, "--runs", "20", "--max-findings", "1"]);
        assert_eq!(status, Some(1));
        assert!(!stdout.contains('\u{1b}'), "{script}: {stdout:?}");
        assert!(stdout.contains("a\\u{1b}[31m"), "{script}: {stdout}");
    }
}

#[test]
fn a_case_that_is_gone_is_written_again() {
    let scratch = Scratch::new("gone");
    let command = "sh -c 'cat >/dev/null; exit 7'";
    let campaign = || run(&["--impl", command, "--runs", "2", "--out", scratch.path()]);
    let (_, first, _) = campaign();
    let case = scratch.0.join("seed-1-run-0.json");
    let text = fs::read(&case).unwrap();
    fs::remove_file(&case).unwrap();
    assert_eq!(campaign().1, first);
    assert!(fs::read(&case).unwrap() == text);
}

#[test]
fn a_state_of_another_campaign_or_half_a_state_is_refused() {
    let scratch = Scratch::new("refused");
    let command = format!("{TURNSPEC} answer");
    let campaign = |seed: &str, command: &str| {
        run(&["--impl", command, "--runs", "2", "--seed", seed, "--out", scratch.path()])
    };
    assert_eq!(campaign("1", &command).0, Some(0));
    let (status, stdout, stderr) = campaign("2", &command);
    assert_eq!((status, stdout.as_str()), (Some(2), ""));
    assert!(stderr.contains("campaign.json: this campaign has seed 1"), "{stderr}");
    let (status, _, stderr) = campaign("1", "cat");
    assert_eq!(status, Some(2));
    assert!(stderr.contains("is about the implementation"), "{stderr}");
    let text = fs::read(scratch.state()).unwrap();
    fs::write(scratch.state(), &text[..text.len() / 2]).unwrap();
    let (status, _, stderr) = campaign("1", &command);
    assert_eq!(status, Some(2));
    assert!(stderr.contains("no state of a campaign"), "{stderr}");
}

#[test]
fn failures_without_a_trace_are_findings() {
    for (command, class) in [
        ("sh -c 'cat >/dev/null; exit 7'", "crash, exit status 7"),
        ("sh -c 'cat >/dev/null; kill -9 $$'", "crash, ended by signal 9"),
        ("sh -c 'cat >/dev/null; echo hello'", "protocol"),
        ("sh -c 'sleep 5'", "time-out"),
    ] {
        let (status, stdout, stderr) =
            run(&["--impl", command, "--runs", "100", "--max-findings", "1", "--timeout", "0.05"]);
        assert_eq!((status, stderr.as_str()), (Some(1), ""), "{stdout}");
        assert!(stdout.contains(&format!("  {class} (1 times, first in run 0)")), "{command}: {stdout}");
        assert!(stdout.starts_with("1 programs: 0 agree, 1 disagree"), "{stdout}");
    }
}

#[test]
fn refusals_are_counted_and_are_no_findings() {
    let (status, stdout, _) = run(&["--impl", "sh -c 'cat >/dev/null; exit 3'", "--runs", "64"]);
    assert_eq!(status, Some(0));
    assert!(stdout.contains(" are not supported") && stdout.contains(" 0 disagree"), "{stdout}");
}

#[test]
fn wrong_usage_is_status_2() {
    for arguments in [
        &["--runs", "1"][..],
        &["--impl", "", "--runs", "1"],
        &["--impl", "/nonexistent/program", "--runs", "1"],
        &["--impl", "cat", "--runs", "1", "--declare", "/nonexistent/file"],
        &["--impl", "cat", "--runs", "1", "--jobs", "0"],
    ] {
        let (status, stdout, stderr) = run(arguments);
        assert_eq!((status, stdout.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(!stderr.is_empty());
    }
}

#[test]
fn a_waiver_by_rule_permits_a_class_of_divergences() {
    let scratch = Scratch::new("waived");
    fs::create_dir_all(&scratch.0).unwrap();
    let declaration = scratch.0.join("impl.toml");
    let bug = with_a_bug();
    let campaign = |field: &str| {
        // G04, and the dwells of grooves and holes.
        let waiver =
            |rule| format!("[[waiver]]\nrule = '{rule}'\nfield = '{field}'\nreason = 'slow clock'\n");
        let text = format!("name = 'a'\n{}{}", waiver("E100L-DWELL-01"), waiver("E100L-DWELL-02"));
        fs::write(&declaration, text).unwrap();
        run(&["--impl", &bug, "--declare", declaration.to_str().unwrap(), "--runs", "100"])
    };
    let (status, stdout, _) = campaign("time");
    assert_eq!(status, Some(0), "{stdout}");
    assert!(stdout.contains("waived: slow clock"), "{stdout}");
    let (status, stdout, _) = campaign("kind");
    assert_eq!(status, Some(1), "{stdout}");
    assert!(!stdout.contains("waived: slow clock"), "{stdout}");
}
