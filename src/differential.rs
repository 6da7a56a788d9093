//! Runs the oracle and the engine side by side and says where they first differ.
//!
//! They must agree exactly: same events, same coordinates, same rule ids, same readings, same alarm at the
//! same block. Both are stepped block by block, so that a disagreement is found at its block; how many steps
//! an implementation takes for a block that emits nothing is its own affair.

use std::collections::VecDeque;
use std::fmt;

use turnspec_oracle::vocabulary::{Action, AlarmName, Ending, Event, Setup, Value, notation};

use crate::engine::Interpreter;

/// What two agreeing runs had in common.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Agreement {
    /// Steps of the oracle: the blocks that were carried out.
    pub blocks: u64,
    /// Events.
    pub events: u64,
    /// The alarm that ended the runs; none after M02 or M30.
    pub alarm: Option<AlarmName>,
}

/// The first difference of two runs.
#[derive(Clone, Debug)]
pub struct Disagreement {
    /// The oracle's next event, if there is one.
    pub oracle: Option<Event>,
    /// The engine's next event, if there is one.
    pub engine: Option<Event>,
    /// How the oracle ended, if it did.
    pub oracle_ending: Option<Ending>,
    /// How the engine ended, if it did.
    pub engine_ending: Option<Ending>,
    /// Text of the block where the difference lies, non-ASCII bytes as escapes.
    pub block: String,
}

/// Runs a program on a valid set-up with the oracle and with the engine.
///
/// # Errors
/// The first difference: of an event, of the number of events, or of the ending.
pub fn compare(program: &[u8], setup: &Setup) -> Result<Agreement, Box<Disagreement>> {
    let mut oracle = Side::default();
    let mut engine = Side::default();
    let mut reference = turnspec_oracle::Run::new(program, setup);
    let mut interpreter = Interpreter::new(program, setup);
    let mut agreement = Agreement { blocks: 0, events: 0, alarm: None };
    // A step takes at least one block or ends the run, so that this many steps are enough for any program.
    for _ in 0..setup.limits.steps.saturating_add(program.len() as u64).saturating_add(2) {
        if oracle.ending.is_none() {
            agreement.blocks += 1;
            oracle.ending = reference.step(&mut |event: &Event| oracle.events.push_back(*event));
        }
        if engine.ending.is_none() {
            engine.ending = interpreter.step(&mut |event: &Event| engine.events.push_back(*event));
        }
        while let (Some(expected), Some(actual)) = (oracle.events.front(), engine.events.front()) {
            if !same(expected, actual) {
                return Err(oracle.against(&engine, program));
            }
            agreement.events += 1;
            if let Action::Alarm(alarm) = expected.action {
                agreement.alarm = Some(alarm.name);
            }
            oracle.events.pop_front();
            engine.events.pop_front();
        }
        let silent = |side: &Side| side.events.is_empty() && side.ending.is_some();
        match (silent(&oracle), silent(&engine)) {
            (true, true) if oracle.ending == engine.ending => return Ok(agreement),
            (true, true) => break,
            (true, false) if !engine.events.is_empty() => break,
            (false, true) if !oracle.events.is_empty() => break,
            _ => {}
        }
    }
    Err(oracle.against(&engine, program))
}

/// Whether two events are the same, signs of zero included.
fn same(a: &Event, b: &Event) -> bool {
    let bits = |event: &Event| match event.action {
        Action::Variable { value: Value::Real(real), .. } => real.to_bits(),
        _ => 0,
    };
    a == b && bits(a) == bits(b)
}

/// One of the two runs: the events that the other has not matched yet.
#[derive(Default)]
struct Side {
    events: VecDeque<Event>,
    ending: Option<Ending>,
}

impl Side {
    fn against(&self, engine: &Self, program: &[u8]) -> Box<Disagreement> {
        let (oracle_event, engine_event) = (self.events.front().copied(), engine.events.front().copied());
        let place = oracle_event.or(engine_event).map(|event| event.block);
        let span = place.map_or(0..program.len(), |place| place.start as usize..place.end as usize);
        let block = program.get(span).unwrap_or_default().escape_ascii().to_string();
        Box::new(Disagreement {
            oracle: oracle_event,
            engine: engine_event,
            oracle_ending: self.ending,
            engine_ending: engine.ending,
            block,
        })
    }
}

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "block:  {}", self.block)?;
        writeln!(f, "oracle: {}", line(self.oracle.as_ref(), self.oracle_ending))?;
        writeln!(f, "engine: {}", line(self.engine.as_ref(), self.engine_ending))?;
        if let (Some(oracle), Some(engine)) = (&self.oracle, &self.engine) {
            write_differences(f, oracle, engine)?;
        }
        Ok(())
    }
}

impl std::error::Error for Disagreement {}

/// An event in compact notation, or why there is none.
fn line(event: Option<&Event>, ending: Option<Ending>) -> String {
    match (event, ending) {
        (Some(event), _) => notation::render(event),
        (None, Some(Ending::End)) => "no further event, ended by M02 or M30".to_owned(),
        (None, Some(Ending::Alarm)) => "no further event, ended by an alarm".to_owned(),
        (None, None) => "no event yet, and the run does not end".to_owned(),
    }
}

/// Field by field, then what only one side cites.
fn write_differences(f: &mut fmt::Formatter<'_>, oracle: &Event, engine: &Event) -> fmt::Result {
    let (expected, actual) = (notation::fields(oracle), notation::fields(engine));
    let value = |list: &[(&str, String)], key: &str| {
        list.iter().find(|(name, _)| *name == key).map_or("-".to_owned(), |(_, value)| value.clone())
    };
    let mut keys: Vec<&str> = expected.iter().chain(&actual).map(|(key, _)| *key).collect();
    keys.sort_unstable();
    keys.dedup();
    for key in keys {
        let (left, right) = (value(&expected, key), value(&actual, key));
        if left != right {
            writeln!(f, "  {}: oracle {left}, engine {right}", if key.is_empty() { "kind" } else { key })?;
        }
    }
    if oracle.n != engine.n {
        writeln!(f, "  n: oracle {}, engine {}", oracle.n, engine.n)?;
    }
    if oracle.block != engine.block {
        writeln!(f, "  place: oracle {:?}, engine {:?}", oracle.block, engine.block)?;
    }
    let rules = |event: &Event| names(event.rules.as_slice().iter().map(|rule| rule.as_str()));
    let readings = |event: &Event| names(event.readings.iter().map(|reading| reading.as_str()));
    write_sets(f, "rules", &rules(oracle), &rules(engine))?;
    write_sets(f, "readings", &readings(oracle), &readings(engine))
}

fn names<'n>(list: impl Iterator<Item = &'n str>) -> Vec<&'n str> {
    list.collect()
}

/// What only one of two lists has.
fn write_sets(f: &mut fmt::Formatter<'_>, what: &str, oracle: &[&str], engine: &[&str]) -> fmt::Result {
    let only = |list: &[&str], other: &[&str]| {
        let rest: Vec<&str> = list.iter().copied().filter(|name| !other.contains(name)).collect();
        rest.join(" ")
    };
    let (missing, surplus) = (only(oracle, engine), only(engine, oracle));
    if !missing.is_empty() {
        writeln!(f, "  {what} of the oracle alone: {missing}")?;
    }
    if !surplus.is_empty() {
        writeln!(f, "  {what} of the engine alone: {surplus}")?;
    }
    Ok(())
}
