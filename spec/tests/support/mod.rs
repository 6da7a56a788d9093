//! Events of a run as text.

use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Event, Setup};

/// The trace in compact notation.
pub fn trace(program: &str, setup: &Setup) -> Vec<String> {
    let mut trace = Vec::new();
    turnspec_oracle::run(program.as_bytes(), setup, &mut |event: &Event| trace.push(render(event)));
    trace
}

/// The value of a key of an event; `-` if it is not there.
pub fn value<'e>(event: &'e str, key: &str) -> &'e str {
    event.split(' ').find_map(|word| word.strip_prefix(key)?.strip_prefix('=')).unwrap_or("-")
}

/// The kind of an event.
pub fn kind(event: &str) -> &str {
    event.split(' ').next().unwrap_or_default()
}
