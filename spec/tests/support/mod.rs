//! Runs of programs, their events as text, and what is expected of them. No test needs all of it.

#![allow(dead_code, clippy::panic)]

use turnspec_oracle::vocabulary::notation::{Expectation, render};
use turnspec_oracle::vocabulary::{Event, Setup};

/// The set-up of a TOML text.
pub fn set_up(text: &str) -> Setup {
    Setup::from_toml(text).unwrap_or_else(|fault| panic!("{text}\n{fault}"))
}

/// The trace.
pub fn trace(program: &str, setup: &Setup) -> Vec<Event> {
    let mut trace = Vec::new();
    turnspec_oracle::run(program.as_bytes(), setup, &mut |event: &Event| trace.push(*event));
    trace
}

/// The trace in compact notation.
pub fn texts(program: &str, setup: &Setup) -> Vec<String> {
    trace(program, setup).iter().map(render).collect()
}

/// The trace is as expected, in compact notation with `...`.
pub fn holds(program: &str, expected: &str, setup: &Setup) {
    let trace = trace(program, setup);
    if let Err(divergence) = Expectation::parse(expected).matches(&trace) {
        let found: Vec<String> = trace.iter().map(render).collect();
        panic!("{divergence}\n{program}\n{}", found.join("\n"));
    }
}

/// The last event has these words of the compact notation.
pub fn ends_with(program: &str, wanted: &str, setup: &Setup) {
    let found = trace(program, setup).last().map(render).unwrap_or_default();
    assert!(has_words(&found, wanted), "{program}\n{found}\n{wanted}");
}

/// Whether an event in compact notation has all these words.
pub fn has_words(event: &str, wanted: &str) -> bool {
    wanted.split(' ').all(|word| event.split(' ').any(|each| each == word))
}

/// Whether an event cites a rule.
pub fn cites(event: &Event, rule: &str) -> bool {
    event.rules.as_slice().iter().any(|each| each.as_str() == rule)
}

/// The value of a key of an event; `-` if it is not there.
pub fn value<'e>(event: &'e str, key: &str) -> &'e str {
    event.split(' ').find_map(|word| word.strip_prefix(key)?.strip_prefix('=')).unwrap_or("-")
}

/// The kind of an event.
pub fn kind(event: &str) -> &str {
    event.split(' ').next().unwrap_or_default()
}
