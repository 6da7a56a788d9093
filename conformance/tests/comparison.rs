//! The verdict on hand-made runs.

#![allow(clippy::panic)]

use std::time::Duration;

use turnspec_conformance::{Declaration, Exit, Expected, Outcome, Verdict, compare};
use turnspec_oracle::vocabulary::{Event, Setup};

const RAPID: &str =
    r#"{"kind": "rapid", "program": {"x": "50", "z": 2}, "machine": {"x": 50.0}, "block": {"line": 1}}"#;
const ALARM: &str = r#"{"kind": "alarm", "name": "no_feed", "block": {"line": 2, "sequence": "N2"}}"#;
const END: &str = r#"{"kind": "end", "code": "M02"}"#;

fn declaration(text: &str) -> Declaration {
    Declaration::from_toml(&format!("name = 'test'\n{text}")).unwrap_or_else(|error| panic!("{error}"))
}

fn outcome(exit: Exit, lines: &[&str]) -> Outcome {
    let output = lines.join("\n").into_bytes();
    Outcome { exit, output, stderr: String::new(), duration: Duration::ZERO }
}

fn verdict_of(expected: &[&str], outcome: &Outcome, declaration: &Declaration) -> Verdict {
    let lines: Vec<String> = expected.iter().map(|line| (*line).to_owned()).collect();
    compare(&Expected::parse(&lines).unwrap_or_else(|error| panic!("{error}")), outcome, declaration)
}

fn verdict(expected: &[&str], status: i32, lines: &[&str], declared: &str) -> Verdict {
    verdict_of(expected, &outcome(Exit::Status(status), lines), &declaration(declared))
}

/// The differing fields of a mismatch.
fn differing(verdict: &Verdict) -> Vec<String> {
    match verdict {
        Verdict::Mismatch(divergence) => divergence.differences.iter().map(ToString::to_string).collect(),
        other => panic!("no mismatch but {other:?}"),
    }
}

#[test]
fn a_line_names_the_fields_that_matter() {
    for line in
        ["rapid", "rapid x=50", "rapid x=50.0 z=2 mx=50 c=- line=1", "rapid block=N9 rules=E100L-ABS-01"]
    {
        assert_eq!(verdict(&[line, "end code=M02"], 0, &[RAPID, "", END], ""), Verdict::Pass, "{line}");
    }
    for (line, difference) in [
        ("rapid x=51", "x: expected 51, got 50, 1 apart"),
        ("rapid x=-", "x: expected -, got 50"),
        ("rapid mz=2", "mz: expected 2, got -"),
        ("rapid line=3", "line: expected 3, got 1, 2 apart"),
        ("linear x=50", "kind: expected linear, got rapid"),
    ] {
        assert_eq!(differing(&verdict(&[line, "end"], 0, &[RAPID, END], "")), [difference], "{line}");
    }
}

#[test]
fn the_place_of_a_divergence_is_told() {
    let Verdict::Mismatch(surplus) = verdict(&["rapid"], 0, &[RAPID, END], "") else { panic!("no mismatch") };
    assert_eq!((surplus.line, surplus.expected, surplus.ordinal), (None, None, Some(2)));
    let Verdict::Mismatch(missing) = verdict(&["rapid", "end"], 0, &[RAPID], "") else {
        panic!("no mismatch")
    };
    assert_eq!((missing.line, missing.expected.as_deref(), missing.ordinal), (Some(1), Some("end"), None));
}

#[test]
fn tolerance_and_omitted_fields_and_kinds_count() {
    assert_eq!(
        verdict(&["rapid x=50.001", "end"], 0, &[RAPID, END], "[tolerance]\nlength = '0.001'"),
        Verdict::Pass
    );
    assert_ne!(
        verdict(&["rapid x=50.0011", "end"], 0, &[RAPID, END], "[tolerance]\nlength = '0.001'"),
        Verdict::Pass
    );
    assert_eq!(verdict(&["rapid x=1 z=2", "end"], 0, &[RAPID, END], "omits = ['x']"), Verdict::Pass);
    let expected = ["mode group=motion", "rapid", "end"];
    assert_eq!(verdict(&expected, 0, &[RAPID, END], "events = ['rapid', 'end']"), Verdict::Pass);
    assert_eq!(verdict(&["end"], 0, &[RAPID, END], "events = ['end']"), Verdict::Pass);
}

#[test]
fn alarms_are_compared_as_declared() {
    let expected = ["rapid", "alarm name=other number=5"];
    assert_eq!(differing(&verdict(&expected, 1, &[RAPID, ALARM], "")).len(), 2);
    assert_eq!(verdict(&expected, 1, &[RAPID, ALARM], "alarms = 'any'"), Verdict::Pass);
    assert_eq!(verdict(&["rapid", "alarm name=no_feed block=N2"], 1, &[RAPID, ALARM], ""), Verdict::Pass);
}

#[test]
fn without_alarm_events_the_exit_status_counts() {
    let events = "events = ['rapid']";
    assert_eq!(verdict(&["rapid", "alarm name=no_feed"], 1, &[RAPID], events), Verdict::Pass);
    assert_eq!(verdict(&["rapid", "end"], 0, &[RAPID], events), Verdict::Pass);
    let missing = verdict(&["rapid", "alarm name=no_feed"], 0, &[RAPID], events);
    assert_eq!(differing(&missing), ["exit status: expected 1, got 0"]);
    assert!(matches!(verdict(&["rapid", "end"], 1, &[RAPID], events), Verdict::Mismatch(_)));
}

#[test]
fn an_undecided_end_demands_nothing_unless_declared() {
    for end in ["alarm name=unspecified", "alarm name=not_modelled detail=G71"] {
        let expected = ["rapid x=50", end];
        for (status, lines) in [(0, &[RAPID, RAPID, END][..]), (1, &[RAPID, ALARM]), (3, &[])] {
            assert_eq!(verdict(&expected, status, lines, ""), Verdict::Pass, "{end}");
        }
        assert!(matches!(verdict(&expected, 0, &[END], ""), Verdict::Mismatch(_)));
        assert!(matches!(verdict(&expected, 7, &[RAPID], ""), Verdict::Crash(_)));
        let strict = "undecided = 'alarm'";
        assert!(matches!(verdict(&expected, 1, &[RAPID, ALARM], strict), Verdict::Mismatch(_)));
        assert_eq!(verdict(&expected, 3, &[RAPID], strict), Verdict::Unsupported);
    }
}

#[test]
fn what_the_process_did_comes_before_what_it_wrote() {
    let declaration = declaration("");
    for (exit, expected) in [
        (Exit::Status(3), Verdict::Unsupported),
        (Exit::Status(101), Verdict::Crash("exit status 101".to_owned())),
        (Exit::Signal(11), Verdict::Crash("ended by signal 11".to_owned())),
        (Exit::TimeOut, Verdict::TimeOut),
        (Exit::Flood, Verdict::Flood),
    ] {
        assert_eq!(verdict_of(&["rapid", "end"], &outcome(exit, &[RAPID, END]), &declaration), expected);
    }
}

#[test]
fn what_is_no_trace_is_a_breach_of_protocol() {
    for (status, lines, reason) in [
        (0, &["rapid x=50"][..], "line 1 of the output: no JSON"),
        (0, &[RAPID, "{}"], "line 2 of the output: no `kind`"),
        (1, &[RAPID, END], "exit status 1 without an alarm"),
        (0, &[RAPID, ALARM], "exit status 0 after an alarm"),
        (1, &[ALARM, RAPID], "there are events after an alarm"),
        (1, &[ALARM, ALARM], "there are events after an alarm"),
    ] {
        match verdict(&["rapid", "end"], status, lines, "") {
            Verdict::Protocol(text) => assert!(text.starts_with(reason), "{text}"),
            other => panic!("{other:?}"),
        }
    }
    let invalid =
        Outcome { output: b"{\"kind\": \"stop\"}\n\xFF\n".to_vec(), ..outcome(Exit::Status(0), &[]) };
    let verdict = verdict_of(&["stop"], &invalid, &declaration(""));
    assert_eq!(verdict, Verdict::Protocol("line 2 of the output is not UTF-8".to_owned()));
}

/// Traces of a program by the engine, as JSON Lines and as events.
fn engine(program: &[u8]) -> (Vec<Event>, Outcome) {
    let mut trace = Vec::new();
    turnspec::engine::run(program, &Setup::default(), &mut |event: &Event| trace.push(*event));
    let lines: Vec<String> =
        trace.iter().map(|event| serde_json::to_string(event).unwrap_or_default()).collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let outcome = outcome(Exit::Status(0), &lines);
    (trace, outcome)
}

#[test]
fn in_a_campaign_every_field_counts() {
    let (trace, same) = engine(b"N1 G01 X50 Z2 F0.2\nG00 X60\nM02\n");
    let expected = Expected::complete(&trace);
    let exact = declaration("");
    assert_eq!(compare(&expected, &same, &exact), Verdict::Pass);

    let text = String::from_utf8_lossy(&same.output).into_owned();
    for (from, to, difference) in [
        (r#""kind":"rapid""#, r#""kind":"rapid","path":"5""#, "path: expected -, got 5"),
        (r#""program":{"x":"60","z":"2"}"#, r#""program":{"x":"60"}"#, "z: expected 2, got -"),
        (r#""sequence":"N1""#, r#""sequence":"N2""#, "block: expected N1, got N2"),
        (r#""line":2"#, r#""line":2,"sequence":"N3""#, "block: expected -, got N3"),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let verdict = compare(&expected, &Outcome { output: changed.into_bytes(), ..same.clone() }, &exact);
        assert_eq!(differing(&verdict), [difference], "{to}");
    }
}
