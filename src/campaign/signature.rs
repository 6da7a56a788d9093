//! When two disagreements count as one.

use std::fmt;

use serde::{Deserialize, Serialize};
use turnspec_conformance::{Divergence, Observation, Verdict, printable};
use turnspec_oracle::vocabulary::{Action, Event, RuleId};

/// The most characters of a foreign kind of event that are shown.
const KIND_SHOWN: usize = 60;

/// What a disagreement looks like, whatever its program.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Signature {
    /// The kind of the expected event, with the name of an alarm, and the field that differs first, or the kind
    /// of event that came in its place; or how the implementation failed altogether.
    pub class: String,
    /// The rules of the expected event.
    pub rules: Vec<RuleId>,
}

impl Signature {
    /// The signature of a run that failed altogether: its rules are unknown.
    pub(super) fn of_failure(verdict: &Verdict) -> Self {
        let class = match verdict {
            Verdict::Crash(how) => format!("crash, {how}"),
            Verdict::Protocol(_) => "protocol".to_owned(),
            Verdict::TimeOut => "time-out".to_owned(),
            Verdict::Flood => "flood".to_owned(),
            Verdict::Pass | Verdict::Unsupported | Verdict::Mismatch(_) => "mismatch".to_owned(),
        };
        Self { class, rules: Vec::new() }
    }

    /// The signature of a trace that diverges, and the expected event, the last one when the trace goes on
    /// behind it.
    pub(super) fn of_divergence(divergence: &Divergence, expected: Option<&Event>) -> Self {
        let wanted = match (divergence.line, expected) {
            (None, _) | (_, None) => "end of the trace".to_owned(),
            (Some(_), Some(event)) => match &event.action {
                Action::Alarm(alarm) => format!("alarm {}", alarm.name),
                _ => kind(event),
            },
        };
        let found = match (&divergence.actual, divergence.differences.first()) {
            (None, None) => "nothing more".to_owned(),
            (Some(actual), None) => shown(actual),
            (Some(actual), Some(difference)) if difference.field == "kind" => shown(actual),
            (_, Some(difference)) => format!("other {}", difference.field),
        };
        let rules = expected.map_or_else(Vec::new, |event| event.rules.as_slice().to_vec());
        Self { class: format!("{wanted}: {found}"), rules }
    }
}

impl fmt::Display for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.class)
    }
}

/// The kind of an event of the implementation, which may be any text.
fn shown(actual: &Observation) -> String {
    printable(&actual.kind, KIND_SHOWN)
}

fn kind(event: &Event) -> String {
    turnspec_oracle::vocabulary::notation::fields(event)
        .into_iter()
        .find_map(|(key, value)| key.is_empty().then_some(value))
        .unwrap_or_default()
}
