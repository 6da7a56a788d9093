//! The verdict on a run: what the process did, what it wrote, and where that leaves the expected trace.

use std::fmt;

use turnspec_oracle::vocabulary::RuleId;

use crate::alignment::{Break, align};
use crate::declaration::Undecided;
use crate::expectation::{Expected, ExpectedEvent, Line};
use crate::observation::{Observation, PLACE, printable};
use crate::process::{Exit, Outcome};
use crate::tolerance::Relation;
use crate::{Decimal, Declaration};

/// What a run comes to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Verdict {
    /// Everything that is compared agrees.
    Pass,
    /// The trace diverges from the expectation.
    Mismatch(Box<Divergence>),
    /// Exit status 3.
    Unsupported,
    /// What it wrote is no trace, or contradicts the exit status; in words.
    Protocol(String),
    /// Another exit status, or a signal; in words.
    Crash(String),
    /// It was not finished in time.
    TimeOut,
    /// It wrote more than the limit.
    Flood,
}

/// Where a trace first diverges from the expectation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Divergence {
    /// Index of the expected line; none when the expected trace has ended.
    pub line: Option<usize>,
    /// The expected line, as it was written.
    pub expected: Option<String>,
    /// Ordinal of the event among all that were reported, from 1; none when the trace has ended.
    pub ordinal: Option<usize>,
    /// The event.
    pub actual: Option<Observation>,
    /// What differs.
    pub differences: Vec<Difference>,
}

impl Divergence {
    /// Whether the expected line cites a rule.
    #[must_use]
    pub fn cites(&self, rule: RuleId) -> bool {
        let words = self.expected.iter().flat_map(|line| line.split_whitespace());
        words
            .filter_map(|word| word.strip_prefix("rules="))
            .flat_map(|ids| ids.split('+'))
            .any(|id| id == rule.as_str())
    }
}

/// A field that differs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// The field in compact notation, or `kind`.
    pub field: String,
    /// Its expected value, `-` for none.
    pub expected: String,
    /// Its value, `-` for none.
    pub actual: String,
    /// How far two numbers are apart.
    pub distance: Option<Decimal>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, expected, actual, distance } = self;
        write!(f, "{field}: expected {expected}, got {}", printable(actual, 200))?;
        match distance {
            Some(distance) => write!(f, ", {distance} apart"),
            None => Ok(()),
        }
    }
}

/// Judges a run by an expected trace, as far as the declaration lets it be judged.
#[must_use]
pub fn compare(expected: &Expected, outcome: &Outcome, declaration: &Declaration) -> Verdict {
    let free = declaration.undecided == Undecided::Free && expected.is_undecided();
    let alarm = match outcome.exit {
        Exit::Status(0) => false,
        Exit::Status(1) => true,
        Exit::Status(3) if free => return Verdict::Pass,
        Exit::Status(3) => return Verdict::Unsupported,
        Exit::Status(status) => return Verdict::Crash(format!("exit status {status}")),
        Exit::Signal(signal) => return Verdict::Crash(format!("ended by signal {signal}")),
        Exit::TimeOut => return Verdict::TimeOut,
        Exit::Flood => return Verdict::Flood,
    };
    let trace = match read_trace(&outcome.output) {
        Ok(trace) => trace,
        Err(reason) => return Verdict::Protocol(reason),
    };
    if let Some(contradiction) = contradiction(&trace, alarm, declaration) {
        return Verdict::Protocol(contradiction);
    }
    let shortened;
    let expected = if free {
        shortened = expected.up_to_the_undecided_end();
        &shortened
    } else {
        expected
    };
    match compare_traces(expected, &trace, declaration) {
        Err(divergence) => Verdict::Mismatch(divergence),
        Ok(_) => status_verdict(expected, alarm),
    }
}

/// Reads JSON Lines.
///
/// # Errors
/// The first line that is no event, in words.
pub fn read_trace(output: &[u8]) -> Result<Vec<Observation>, String> {
    let text = str::from_utf8(output).map_err(|error| {
        let before = output.get(..error.valid_up_to()).unwrap_or_default();
        format!("line {} of the output is not UTF-8", before.split(|byte| *byte == b'\n').count())
    })?;
    let lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    lines
        .map(|(number, line)| {
            Observation::from_json(line)
                .map_err(|reason| format!("line {number} of the output: {reason}: {}", printable(line, 120)))
        })
        .collect()
}

/// How exit status and trace contradict each other.
fn contradiction(trace: &[Observation], alarm: bool, declaration: &Declaration) -> Option<String> {
    if !declaration.reports("alarm") {
        return None;
    }
    match trace.iter().position(|event| event.kind == "alarm") {
        Some(place) if place + 1 < trace.len() => Some("there are events after an alarm".to_owned()),
        Some(_) if !alarm => Some("exit status 0 after an alarm".to_owned()),
        None if alarm => Some("exit status 1 without an alarm".to_owned()),
        _ => None,
    }
}

/// The traces agree; the exit status counts where alarms are not reported.
fn status_verdict(expected: &Expected, alarm: bool) -> Verdict {
    let Some(last) = expected.last() else { return Verdict::Pass };
    if (last.kind == "alarm") == alarm {
        return Verdict::Pass;
    }
    let (expected_status, status) = if alarm { ("0", "1") } else { ("1", "0") };
    Verdict::Mismatch(Box::new(Divergence {
        line: Some(expected.lines().len() - 1),
        expected: Some(last.to_string()),
        ordinal: None,
        actual: None,
        differences: vec![Difference {
            field: "exit status".to_owned(),
            expected: expected_status.to_owned(),
            actual: status.to_owned(),
            distance: None,
        }],
    }))
}

/// Compares a reported trace with an expected one: for each expected event the indices of its line and of
/// the event that satisfies it. Kinds that the declaration leaves out are left out on both sides.
///
/// # Errors
/// The first divergence.
pub fn compare_traces(
    expected: &Expected,
    trace: &[Observation],
    declaration: &Declaration,
) -> Result<Vec<(usize, usize)>, Box<Divergence>> {
    let events: Vec<(usize, &Observation)> =
        trace.iter().enumerate().filter(|(_, event)| declaration.reports(&event.kind)).collect();
    let (indices, lines): (Vec<usize>, Vec<Option<&ExpectedEvent>>) = expected
        .lines()
        .iter()
        .enumerate()
        .filter_map(|(index, line)| match line {
            Line::Gap => Some((index, None)),
            Line::Event(event) => declaration.reports(&event.kind).then_some((index, Some(event))),
        })
        .unzip();
    let fits = |line: &&ExpectedEvent, event: usize| {
        events.get(event).is_some_and(|(_, event)| differences(line, event, declaration).is_empty())
    };
    match align(&lines, events.len(), fits) {
        Ok(pairs) => Ok(pairs
            .into_iter()
            .filter_map(|(line, event)| Some((*indices.get(line)?, events.get(event)?.0)))
            .collect()),
        Err(Break { line, event }) => {
            let wanted = line.and_then(|line| lines.get(line).copied().flatten());
            let found = event.and_then(|event| events.get(event));
            let differences = match (wanted, found) {
                (Some(wanted), Some((_, found))) => differences(wanted, found, declaration),
                _ => Vec::new(),
            };
            Err(Box::new(Divergence {
                line: line.and_then(|line| indices.get(line).copied()),
                expected: wanted.map(ToString::to_string),
                ordinal: found.map(|(index, _)| index + 1),
                actual: found.map(|(_, event)| (*event).clone()),
                differences,
            }))
        }
    }
}

/// What differs between a line and an event; nothing when the event satisfies the line.
#[must_use]
pub fn differences(
    expected: &ExpectedEvent,
    actual: &Observation,
    declaration: &Declaration,
) -> Vec<Difference> {
    let difference = |field: &str, expected: &str, actual: &str, distance| Difference {
        field: field.to_owned(),
        expected: expected.to_owned(),
        actual: actual.to_owned(),
        distance,
    };
    let kind = expected.kind.as_str();
    if kind != actual.kind {
        return vec![difference("kind", kind, &actual.kind, None)];
    }
    let mut found = Vec::new();
    for (field, wanted) in expected.fields.iter().filter(|(field, _)| declaration.compares(kind, field)) {
        match actual.field(field) {
            None if wanted == "-" || PLACE.contains(&field.as_str()) => {}
            None => found.push(difference(field, wanted, "-", None)),
            Some(value) => match declaration.tolerance.relation(kind, field, wanted, value) {
                Relation::Fits => {}
                Relation::Apart(distance) => found.push(difference(field, wanted, value, Some(distance))),
                Relation::Differs => found.push(difference(field, wanted, value, None)),
            },
        }
    }
    if expected.complete {
        let surplus = actual.fields.iter().filter(|(field, _)| {
            declaration.compares(kind, field) && expected.fields.iter().all(|(wanted, _)| wanted != field)
        });
        found.extend(surplus.map(|(field, value)| difference(field, "-", value, None)));
    }
    found
}
