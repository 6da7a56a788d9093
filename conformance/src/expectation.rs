//! An expected trace: lines in compact notation, each naming the fields that matter, or complete events.

use std::fmt;

use turnspec_oracle::vocabulary::{Event, notation};

use crate::Observation;

/// An expected trace.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Expected {
    lines: Vec<Line>,
}

/// One line of an expected trace.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Line {
    /// `...`: any number of events.
    Gap,
    /// One event.
    Event(ExpectedEvent),
}

/// What is expected of one event.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ExpectedEvent {
    /// Its kind.
    pub kind: String,
    /// Fields and their values; `-` for a field that must be missing. `rules` and `readings` are not among
    /// them, they are nothing that an implementation reports.
    pub fields: Vec<(String, String)>,
    /// Whether every other field must be missing.
    pub complete: bool,
    text: String,
}

impl Expected {
    /// Reads lines in compact notation.
    ///
    /// # Errors
    /// Names a word that is not `key=value`.
    pub fn parse(lines: &[String]) -> Result<Self, String> {
        let mut expected = Self::default();
        for line in lines {
            expected.lines.push(if line == "..." { Line::Gap } else { Line::Event(event(line)?) });
        }
        Ok(expected)
    }

    /// A complete trace: every field of every event is expected, and no other.
    #[must_use]
    pub fn complete(trace: &[Event]) -> Self {
        let line = |event: &Event| {
            let Observation { kind, fields } = Observation::of(event);
            let fields = fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
            Line::Event(ExpectedEvent { kind, fields, complete: true, text: notation::render(event) })
        };
        Self { lines: trace.iter().map(line).collect() }
    }

    /// The lines.
    #[must_use]
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// The last event, when the trace ends with one.
    #[must_use]
    pub fn last(&self) -> Option<&ExpectedEvent> {
        match self.lines.last() {
            Some(Line::Event(event)) => Some(event),
            _ => None,
        }
    }

    /// Whether it ends in an alarm that says that nobody knows what the control does.
    #[must_use]
    pub fn is_undecided(&self) -> bool {
        self.last().is_some_and(|event| {
            let name = event.fields.iter().find(|(field, _)| field == "name");
            event.kind == "alarm"
                && name.is_some_and(|(_, name)| ["unspecified", "not_modelled"].contains(&name.as_str()))
        })
    }

    /// What is left of it when an undecided end demands nothing.
    #[must_use]
    pub fn up_to_the_undecided_end(&self) -> Self {
        let mut lines = self.lines.clone();
        lines.pop();
        lines.push(Line::Gap);
        Self { lines }
    }
}

/// As it was written.
impl fmt::Display for ExpectedEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

fn event(line: &str) -> Result<ExpectedEvent, String> {
    let mut words = line.split_whitespace();
    let kind = words.next().unwrap_or_default().to_owned();
    let mut fields = Vec::new();
    for word in words {
        let (key, value) = word.split_once('=').ok_or_else(|| format!("`{word}` is not key=value"))?;
        if !["rules", "readings"].contains(&key) {
            fields.push((key.to_owned(), value.to_owned()));
        }
    }
    Ok(ExpectedEvent { kind, fields, complete: false, text: line.to_owned() })
}
