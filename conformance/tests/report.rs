//! A run over a few cases: verdicts, waivers, and the reports as they are read by other programs.

#![allow(clippy::panic)]

use quick_xml::Reader;
use quick_xml::events::Event as Xml;
use turnspec_conformance::report::{Detail, Report, Ruling, html, json, junit, summary};
use turnspec_conformance::{Case, Declaration, Exercise, Filter, Implementation, Runner};

/// What a shell script does that answers each case in its own way.
const SCRIPT: &str = r#"
task=$(cat)
case "$task" in
*'"id":"t/pass"'*) echo '{"kind": "end", "code": "M02"}' ;;
*'"id":"t/also-pass"'*) echo '{"kind": "end", "code": "M02"}' ;;
*'"id":"t/mismatch"'*) printf '{"kind": "rapid", "program": {"x": "51"}}\n{"kind": "end", "code": "<script>&\\u0001\\u001b[2J"}\n' ;;
*'"id":"t/unsupported"'*) exit 3 ;;
*'"id":"t/protocol"'*) echo '<b>rubbish]]>'; printf 'sorry \001 & bye\n' >&2 ;;
*'"id":"t/crash"'*) echo 'panic at <line 5>' >&2; exit 101 ;;
esac
"#;

fn exercises() -> Vec<Exercise> {
    let case = |name: &str, rule: &str, features: &str| {
        let text = format!(
            r#"{{"id": "t/{name}", "title": "Case <{name}>", "rules": ["{rule}"], "control": "e100l",
            "features": [{features}], "flags": ["constructed"], "source": "here", "basis": "manual", "repairs": "",
            "program": "G00 X50\nM02\n", "setup": {{}}, "expect": ["...", "end code=M02 line=2"], "stated": [],
            "derivation": "by hand"}}"#
        );
        let case: Case = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}"));
        Exercise::new(case).unwrap_or_else(|error| panic!("{error}"))
    };
    vec![
        case("pass", "E100L-MCODE-04", ""),
        case("also-pass", "E100L-ABS-01", ""),
        case("mismatch", "E100L-MCODE-04", "\"rapid\""),
        case("unsupported", "E100L-G00-01", "\"rapid\""),
        case("protocol", "E100L-G00-02", ""),
        case("crash", "E100L-G00-04", ""),
        case("arc", "E100L-CIRC-01", "\"arc\""),
    ]
}

fn run(declared: &str, filters: &[&str], jobs: usize) -> Report {
    let declaration = Declaration::from_toml(&format!("name = 'a <b> & c'\nversion = '1'\n{declared}"));
    let declaration = declaration.unwrap_or_else(|error| panic!("{error}"));
    let command = format!("sh -c '{}'", SCRIPT.replace('\'', "'\\''"));
    let implementation = Implementation::new(&command).unwrap_or_else(|error| panic!("{error}"));
    let filters: Vec<Filter> = filters.iter().map(|text| Filter::new(text)).collect();
    let (declaration, filters) = (&declaration, filters.as_slice());
    let runner = Runner { command: "sh", implementation: &implementation, declaration, filters, jobs };
    runner.run(&exercises(), &|_| {}).unwrap_or_else(|error| panic!("{error}"))
}

const ALL_BUT_ARC: &str = "features = ['rapid']\n";

fn verdicts(report: &Report) -> Vec<&str> {
    report.cases.iter().map(|case| case.verdict.as_str()).collect()
}

#[test]
fn every_case_has_its_verdict_in_the_order_of_the_corpus() {
    for jobs in [1, 4] {
        let report = run(ALL_BUT_ARC, &[], jobs);
        let expected = ["pass", "pass", "mismatch", "unsupported", "protocol", "crash", "skipped"];
        assert_eq!(verdicts(&report), expected);
        assert!(!report.success);
        assert_eq!(report.count(Ruling::Pass), 2);
    }
}

#[test]
fn rules_are_counted() {
    let report = run(ALL_BUT_ARC, &[], 2);
    let rule = |id: &str| report.rules.iter().find(|rule| rule.rule == id).cloned();
    let counts = rule("E100L-MCODE-04").map(|rule| (rule.passed, rule.failed, rule.waived, rule.skipped));
    assert_eq!(counts, Some((1, 1, 0, 0)));
    let counts = rule("E100L-CIRC-01").map(|rule| (rule.passed, rule.failed, rule.waived, rule.skipped));
    assert_eq!(counts, Some((0, 0, 0, 1)));
}

#[test]
fn a_divergence_is_explained() {
    let report = run(ALL_BUT_ARC, &["t/mismatch"], 1);
    let case = report.failures().next().unwrap_or_else(|| panic!("no failure"));
    let explanation = case.explanation.as_ref().unwrap_or_else(|| panic!("no explanation"));
    assert_eq!((explanation.line, explanation.block.as_deref()), (Some(2), Some("M02")));
    assert_eq!(explanation.expected.as_deref(), Some("end code=M02 line=2"));
    assert_eq!(explanation.rules[0].id, "E100L-MCODE-04");
    assert!(explanation.rules[0].statement.len() > 20);
    let text = summary(&report, Detail::Brief, false);
    for part in ["mismatch t/mismatch", "line 2: M02", "E100L-MCODE-04", "1 mismatch", "does not conform"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(!text.contains('\u{1b}') && !text.contains('\u{1}'), "{text}");
}

#[test]
fn waivers_permit_mismatch_and_unsupported_only() {
    let waiver = |key: &str, value: &str| format!("[[waiver]]\n{key} = '{value}'\nreason = 'planned'\n");
    let declared = [
        ALL_BUT_ARC,
        &waiver("case", "t/mismatch"),
        &waiver("rule", "E100L-G00-01"),
        &waiver("case", "t/protocol"),
        &waiver("rule", "E100L-G00-04"),
    ]
    .concat();
    let report = run(&declared, &[], 2);
    let expected = ["pass", "pass", "waived", "waived", "protocol", "crash", "skipped"];
    assert_eq!(verdicts(&report), expected);

    let waived = run(&declared, &["t/pass", "t/mismatch", "t/unsupported"], 2);
    assert!(waived.success);
    assert_eq!(waived.unused_waivers, ["t/protocol", "E100L-G00-04"]);
}

#[test]
fn a_waiver_that_nothing_needs_is_a_failure() {
    let case = run("features = ['rapid']\n[[waiver]]\ncase = 't/pass'\nreason = 'old'", &["t/pass"], 1);
    assert_eq!(case.cases[0].verdict, Ruling::StaleWaiver);
    assert!(!case.success);
    // One of the two cases about this rule fails, so that its waiver is needed.
    let needed = run("features = ['rapid']\n[[waiver]]\nrule = 'E100L-MCODE-04'\nreason = 'old'", &[], 1);
    assert_eq!(verdicts(&needed)[..3], ["pass", "pass", "waived"]);
    let stale = run("features = ['rapid']\n[[waiver]]\nrule = 'E100L-ABS-01'\nreason = 'old'", &[], 1);
    assert_eq!(verdicts(&stale)[..2], ["pass", "stale-waiver"]);
    // With a filter only some of the cases are run: nothing is known about the rule as a whole.
    let part = "features = ['rapid']\n[[waiver]]\nrule = 'E100L-MCODE-04'\nreason = 'old'";
    assert_eq!(verdicts(&run(part, &["t/pass"], 1))[0], "pass");
}

#[test]
fn the_json_report_reads_back_as_the_type_of_its_schema() {
    let report = run(ALL_BUT_ARC, &[], 1);
    let text = json(&report).unwrap_or_else(|error| panic!("{error}"));
    let read: Report = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(read, report);
}

#[test]
fn junit_is_xml_with_an_element_a_case() {
    let text = junit(&run(ALL_BUT_ARC, &[], 1)).unwrap_or_else(|error| panic!("{error}"));
    let permitted = |each: char| matches!(each, '\n' | ' '..='\u{FFFD}' | '\u{10000}'..);
    assert!(text.chars().all(permitted), "{text}");
    let mut reader = Reader::from_str(&text);
    let mut counts = std::collections::BTreeMap::new();
    loop {
        match reader.read_event() {
            Ok(Xml::Eof) => break,
            Ok(Xml::Start(element) | Xml::Empty(element)) => {
                for attribute in element.attributes() {
                    let attribute = attribute.unwrap_or_else(|error| panic!("{error}"));
                    assert!(attribute.unescape_value().is_ok());
                }
                let name = String::from_utf8_lossy(element.name().as_ref()).into_owned();
                *counts.entry(name).or_insert(0) += 1;
            }
            Ok(Xml::Text(content)) => assert!(content.decode().is_ok()),
            Ok(_) => {}
            Err(error) => panic!("{error}: {text}"),
        }
    }
    let count = |name: &str| counts.get(name).copied().unwrap_or(0);
    assert_eq!(
        (count("testcase"), count("failure"), count("error"), count("skipped")),
        (7, 2, 2, 1),
        "{text}"
    );
    assert!(text.contains(r#"tests="7" failures="2" errors="2" skipped="1""#), "{text}");
}

#[test]
fn the_page_is_whole_and_foreign_text_is_escaped() {
    let text = html(&run(ALL_BUT_ARC, &[], 1));
    assert!(text.contains("a &lt;b&gt; &amp; c 1") && text.contains("Does not conform."));
    for foreign in ["<script", "<b>", "<line", "\u{1b}"] {
        assert!(!text.contains(foreign), "{foreign}");
    }
    assert_eq!(text.matches("<details").count(), 4);
    assert!(text.ends_with("</html>"));
}
