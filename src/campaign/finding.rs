//! A finding: a disagreement that is not permitted, with the smallest program that shows it, as a case.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use turnspec_conformance::{features_of, text_of_bytes};
use turnspec_generator::Case;
use turnspec_oracle::book;
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, RuleId, Setup, notation};

use super::Signature;
use super::judgement::Disagreement;

/// A disagreement and how often it was met.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Finding {
    /// What it looks like in its smallest program.
    pub signature: Signature,
    /// What it looked like where it was met, each with its count.
    pub met_as: Vec<(Signature, u64)>,
    /// The run that it was met in first.
    pub run: u64,
    /// What is expected.
    pub expected: String,
    /// What the implementation does instead.
    pub actual: String,
    /// The differences field by field, in words.
    pub differences: Vec<String>,
    /// The conformance case, of the shape of `conformance/schemas/case.schema.json`.
    pub case: Value,
}

impl Finding {
    /// The finding of a run: the disagreement as it was met, and its smallest case with what it shows there.
    pub(super) fn new(seed: u64, run: u64, met: &Disagreement, case: &Case, smallest: &Disagreement) -> Self {
        Self {
            signature: smallest.signature.clone(),
            met_as: vec![(met.signature.clone(), 0)],
            run,
            expected: smallest.expected.clone(),
            actual: smallest.actual.clone(),
            differences: smallest.differences.clone(),
            case: conformance_case(seed, run, case, smallest),
        }
    }

    /// How often it was met.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.met_as.iter().map(|(_, count)| count).sum()
    }

    /// The program of the case, one character a byte.
    #[must_use]
    pub fn program(&self) -> &str {
        self.case.get("program").and_then(Value::as_str).unwrap_or_default()
    }

    /// The name of the file of its case.
    #[must_use]
    pub fn file_name(&self) -> String {
        let id = self.case.get("id").and_then(Value::as_str).unwrap_or_default();
        format!("{}.json", id.rsplit('/').next().unwrap_or_default())
    }
}

/// The case as the corpus writes cases; its expected trace is that of the oracle, which the flag says.
fn conformance_case(seed: u64, run: u64, case: &Case, disagreement: &Disagreement) -> Value {
    let mut trace: Vec<Event> = Vec::new();
    turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| trace.push(*event));
    let expect: Vec<String> = trace.iter().map(notation::render).collect();
    let control = json!(case.setup.control);
    json!({
        "id": format!("{}/seed-{seed}-run-{run}", control.as_str().unwrap_or_default()),
        "title": format!("Generated: {}", disagreement.signature),
        "rules": disagreement.signature.rules,
        "control": control,
        "features": features_of(&case.program, &case.setup, &trace),
        "flags": ["generated"],
        "source": format!("campaign of seed {seed}, run {run}"),
        "basis": basis(&trace),
        "repairs": "",
        "program": text_of_bytes(&case.program),
        "setup": changed(&case.setup),
        "expect": expect,
        "stated": [],
        "derivation": "The expected trace is that of the reference semantics; another implementation disagreed.",
    })
}

/// Whether the manual settles the trace: the weakest basis of its rules.
fn basis(trace: &[Event]) -> &'static str {
    if let Some(Event { action: Action::Alarm(alarm), .. }) = trace.last()
        && matches!(alarm.name, AlarmName::Unspecified | AlarmName::NotModelled)
    {
        return "unspecified";
    }
    let texts = book::e100l().unwrap_or_default();
    let is_settled = |rule: &RuleId| texts.iter().any(|text| text.id == *rule && text.basis == "manual");
    let mut rules = trace.iter().flat_map(|event| event.rules.as_slice());
    if rules.all(is_settled) { "manual" } else { "interpretation" }
}

/// The parts of a set-up that are not as by default.
fn changed(setup: &Setup) -> Map<String, Value> {
    let object = |setup: &Setup| match serde_json::to_value(setup) {
        Ok(Value::Object(object)) => object,
        _ => Map::new(),
    };
    let plain = object(&Setup::default());
    object(setup).into_iter().filter(|(key, value)| plain.get(key) != Some(value)).collect()
}
