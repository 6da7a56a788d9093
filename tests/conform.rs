//! `conform` and `answer` from outside: our own implementations through the protocol, and implementations that
//! misbehave.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

const TURNSPEC: &str = env!("CARGO_BIN_EXE_turnspec");
/// One case that ends with M02, quick to run.
const ONE: &str = "e100l/s2-g90-position";

fn turnspec(arguments: &[&str]) -> Command {
    let mut command = Command::new(TURNSPEC);
    command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).stdin(Stdio::null());
    command
}

fn conform(arguments: &[&str]) -> (i32, String, String) {
    let Output { status, stdout, stderr } =
        turnspec(&[&["conform"], arguments].concat()).output().expect("turnspec starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (status.code().expect("not ended by a signal"), text(stdout), text(stderr))
}

/// The command that runs a few lines of shell, `$0` being our own program.
fn shell(script: &str) -> String {
    format!("sh -c '{}' {TURNSPEC}", script.replace('\'', "'\\''"))
}

/// The verdict that a script gets on one case, and what is printed.
fn verdict(script: &str, more: &[&str]) -> (i32, String) {
    let command = shell(script);
    let arguments = [&["--impl", &command, "--filter", ONE], more].concat();
    let (status, stdout, stderr) = conform(&arguments);
    assert_eq!(stderr, "");
    (status, stdout)
}

/// A path that is removed with the test.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        Self(std::env::temp_dir().join(format!("turnspec-{}-conform-{name}", std::process::id())))
    }

    fn with(name: &str, text: &str) -> Self {
        let scratch = Self::new(name);
        fs::write(&scratch.0, text).expect("a scratch file");
        scratch
    }

    fn path(&self) -> &str {
        self.0.to_str().expect("a path of UTF-8")
    }

    fn text(&self) -> String {
        fs::read_to_string(&self.0).unwrap_or_default()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

#[test]
fn both_implementations_pass_the_whole_corpus_through_the_protocol() {
    for with in ["engine", "oracle"] {
        let json = Scratch::new(&format!("{with}.json"));
        let command = format!("{TURNSPEC} answer --with {with}");
        let declared = ["--declare", "conformance/turnspec.toml", "--json", json.path()];
        let (status, stdout, stderr) = conform(&[&["--impl", &command], &declared[..]].concat());
        assert_eq!((status, stderr.as_str()), (0, ""), "{stdout}");
        let report: serde_json::Value = serde_json::from_str(&json.text()).expect("JSON");
        let verdicts = report["verdicts"].as_object().expect("an object");
        assert_eq!(verdicts.keys().collect::<Vec<_>>(), ["pass"]);
        assert!(report["verdicts"]["pass"].as_u64() > Some(800), "{stdout}");
        assert!(stdout.starts_with("turnspec: conforms; "), "{stdout}");
    }
}

#[test]
fn the_report_does_not_depend_on_the_number_of_jobs() {
    let command = shell("\"$0\" answer | sed 's/\"50\"/\"50.5\"/'");
    let report = |jobs: &str| {
        let json = Scratch::new(&format!("jobs-{jobs}.json"));
        let arguments = ["--impl", &command, "--filter", "E100L-G0*", "--jobs", jobs, "--json", json.path()];
        let (_, stdout, _) = conform(&arguments);
        let lines =
            json.text().lines().filter(|line| !line.contains("\"seconds\"")).map(str::to_owned).collect();
        (stdout, lines)
    };
    let (summary, lines): (String, Vec<String>) = report("1");
    assert_eq!(report("5"), (summary, lines));
}

#[test]
fn a_mismatch_is_explained() {
    let (status, text) = verdict("\"$0\" answer | sed 's/\"x\":\"50\"/\"x\":\"50.25\"/'", &[]);
    assert_eq!(status, 1);
    for part in [
        "mismatch e100l/s2-g90-position",
        "line 2: G00 X50 Z150",
        "expected   rapid x=50 z=150",
        "x: expected 50, got 50.25, 0.25 apart",
        "E100L-ABS-01 · ",
        "does not conform; ",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn misbehaviour_is_a_verdict() {
    for (script, expected) in [
        ("\"$0\" answer", "1 pass"),
        ("cat > /dev/null; exit 3", "1 unsupported"),
        ("cat > /dev/null; exit 7", "1 crash"),
        ("kill -KILL $$", "1 crash"),
        ("exec 0<&-; echo rubbish", "1 protocol"),
        ("printf '\\377\\n'", "1 protocol"),
        ("\"$0\" answer; exit 1", "1 protocol"),
        ("\"$0\" answer | head -n 1", "1 mismatch"),
        ("\"$0\" answer | head -c 50", "1 protocol"),
        (":", "1 mismatch"),
        ("i=0; while [ $i -lt 20000 ]; do printf '['; i=$((i+1)); done", "1 protocol"),
        ("\"$0\" answer; (sleep 1000 &)", "1 pass"),
    ] {
        let start = Instant::now();
        let (status, text) = verdict(script, &[]);
        assert!(text.contains(expected), "{script}: {text}");
        assert_eq!(status, i32::from(expected != "1 pass"), "{script}: {text}");
        assert!(start.elapsed() < Duration::from_secs(9), "{script}");
    }
    let (status, text) = verdict("sleep 1000", &["--timeout", "0.3"]);
    assert_eq!((status, text.contains("1 time-out")), (1, true), "{text}");
    let (status, text) = verdict("yes", &["--output-limit", "10000"]);
    assert_eq!((status, text.contains("1 flood")), (1, true), "{text}");
}

#[test]
fn an_implementation_in_another_language_may_do_anything() {
    if Command::new("python3").arg("-c").arg("").status().is_err() {
        eprintln!("skipped: there is no python3");
        return;
    }
    for (program, expected) in [
        ("import json; json.load(sys.stdin); print(json.dumps({'kind': 'end'}), end='')", "1 mismatch"),
        ("sys.stdout.write('{\"kind\": \"a\", \"x\": ' + '9' * 1000000 + '}')", "1 protocol"),
        ("sys.stdout.write('{\"kind\": \"' + 'a' * 1000000 + '\"}')", "1 mismatch"),
        ("sys.stdout.write('{\"kind\": \"dwell\", \"time\": NaN}')", "1 protocol"),
        ("sys.stdout.write('[' * 1000000)", "1 protocol"),
        ("sys.stdout.write('\\x00' * 1000)", "1 protocol"),
        ("sys.stdout.write('\\n' * 1000000)", "1 mismatch"),
        ("print('{\"kind\": \"stop\"}\\n' * 100000)", "1 mismatch"),
        ("raise RuntimeError('boom')", "exit status 1 without an alarm"),
        ("import os; os.close(0); os.close(1); os.close(2)", "1 mismatch"),
    ] {
        let script = Scratch::with(&format!("{}.py", program.len()), &format!("import sys\n{program}\n"));
        let command = format!("python3 {}", script.path());
        let (status, stdout, stderr) = conform(&["--impl", &command, "--filter", ONE]);
        assert_eq!((status, stderr.as_str()), (1, ""), "{program}: {stdout}");
        assert!(stdout.contains(expected), "{program}: {stdout:.2000}");
        assert!(stdout.len() < 10_000, "{program}: {} bytes", stdout.len());
    }
}

#[test]
fn what_the_caller_got_wrong_is_said_at_once() {
    let declaration = Scratch::with("wrong.toml", "name = 'a'\nfetures = []\n");
    let corpus = Scratch::with("wrong.json", r#"{"format": "0.2.0", "cases": [{"id": "#);
    let answer = format!("{TURNSPEC} answer");
    for (arguments, said) in [
        (&["--impl", "/nonexistent/mylathe"][..], "/nonexistent/mylathe"),
        (&["--impl", "sh -c 'x"], "quotation"),
        (&["--impl", ""], "empty"),
        (&[], "--impl"),
        (&["--impl", &answer, "--declare", "/nonexistent.toml"], "/nonexistent.toml"),
        (&["--impl", &answer, "--declare", declaration.path()], "fetures"),
        (&["--impl", &answer, "--corpus", "/nonexistent"], "/nonexistent"),
        (&["--impl", &answer, "--corpus", corpus.path()], "cut off"),
        (&["--impl", &answer, "--filter", "no-such-case"], "selects no case"),
        (&["--impl", &answer, "--timeout", "0"], "not a time"),
        (&["--impl", &answer, "--timeout", "inf"], "not a time"),
        (&["--impl", &answer, "--jobs", "0"], "--jobs"),
        (&["--impl", &answer, "--filter", ONE, "--html", "/nonexistent/a.html"], "/nonexistent/a.html"),
    ] {
        let start = Instant::now();
        let (status, _, stderr) = conform(arguments);
        assert_eq!(status, 2, "{arguments:?}: {stderr}");
        assert!(stderr.contains(said), "{arguments:?}: {stderr}");
        assert!(start.elapsed() < Duration::from_secs(9));
    }
}

#[test]
fn a_report_that_cannot_be_written_does_not_keep_others_from_it() {
    let (json, html) = (Scratch::new("kept.json"), Scratch::new("kept.html"));
    let answer = format!("{TURNSPEC} answer");
    let reports = ["--junit", "/nonexistent/a.xml", "--json", json.path(), "--html", html.path()];
    let (status, stdout, stderr) = conform(&[&["--impl", &answer, "--filter", ONE], &reports[..]].concat());
    assert_eq!(status, 2, "{stderr}");
    assert!(stderr.contains("/nonexistent/a.xml") && stdout.contains("1 pass"), "{stdout}{stderr}");
    assert!(json.text().starts_with('{') && html.text().starts_with("<!DOCTYPE html>"));
}

#[test]
fn undeclared_features_are_skipped() {
    let declaration =
        Scratch::with("little.toml", "name = 'little'\nfeatures = ['rapid']\nundecided = 'alarm'\n");
    let command = format!("{TURNSPEC} answer");
    let (status, text, _) = conform(&["--impl", &command, "--declare", declaration.path(), "--verbose"]);
    assert_eq!(status, 0, "{text}");
    assert!(
        text.contains("skipped      e100l/s3-g75-chamfer: needs what is not declared: chamfer, feed"),
        "{text:.3000}"
    );
}

/// Ctrl-C, a request to end, the end of the terminal.
#[test]
fn an_interruption_leaves_no_process_behind() {
    for signal in ["-INT", "-TERM"] {
        leaves_no_process_behind(signal);
    }
    // Below `nohup` the end of the terminal is ignored, by our child too.
    if !hang_up_is_ignored() {
        leaves_no_process_behind("-HUP");
    }
}

fn hang_up_is_ignored() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).unwrap_or("0");
    u64::from_str_radix(mask.trim(), 16).is_ok_and(|mask| mask & 1 == 1)
}

fn leaves_no_process_behind(signal: &str) {
    let note = Scratch::new("note");
    let command = shell(&format!("echo $$ >> {}; exec sleep 1000", note.path()));
    let mut child = turnspec(&["conform", "--impl", &command, "--timeout", "60", "--jobs", "2"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("turnspec starts");
    let start = Instant::now();
    while note.text().lines().count() < 2 && start.elapsed() < Duration::from_secs(20) {
        thread::sleep(Duration::from_millis(20));
    }
    let killed = Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill starts");
    assert!(killed.success());
    assert_eq!(child.wait().expect("turnspec ends").code(), Some(2));
    assert!(start.elapsed() < Duration::from_secs(40));
    for id in note.text().lines() {
        let alive =
            Command::new("kill").args(["-0", id]).stderr(Stdio::null()).status().expect("kill starts");
        assert!(!alive.success(), "{signal}: process {id} is alive");
    }
}

fn answer(input: &[u8]) -> Output {
    let mut command = turnspec(&["answer"]);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("turnspec starts");
    let _ = child.stdin.take().expect("piped").write_all(input);
    child.wait_with_output().expect("turnspec ends")
}

#[test]
fn an_answer_is_a_trace_and_its_exit_status() {
    let task = |program: &str, setup: &str| {
        format!(
            r#"{{"protocol": 1, "id": "a", "control": "e100l", "program": "{program}", "setup": {setup}, "more": 1}}"#
        )
    };
    let end = answer(task(r"M02\n", "{}").as_bytes());
    assert_eq!(end.status.code(), Some(0));
    assert!(end.stdout.ends_with(b"\"kind\":\"end\",\"code\":\"M02\"}\n"), "{end:?}");
    let alarm = answer(task(r"\u00FF\n", "{}").as_bytes());
    assert_eq!(alarm.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&alarm.stdout).contains("\"kind\":\"alarm\""));
    for wrong in [
        String::new(),
        "[]".to_owned(),
        task("€", "{}"),
        task("M02", r#"{"options": {"user_task": 3}}"#),
        task("M02", "{}").replace("\"protocol\": 1", "\"protocol\": 2"),
    ] {
        let output = answer(wrong.as_bytes());
        assert_eq!(output.status.code(), Some(2), "{wrong}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{wrong}");
    }
}
