//! The trace of the oracle, and what of an event is its shape and what its coordinates.

use turnspec_generator::{Case, decode};
use turnspec_oracle::vocabulary::{Action, Event, Motion, Place, RuleId};

/// The trace of a case.
pub(crate) fn trace(case: &Case) -> Vec<Event> {
    let mut trace = Vec::new();
    turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| trace.push(*event));
    trace
}

/// Whether no statement can lead elsewhere than to the next block, as far as its letters tell.
pub(crate) fn is_straight(case: &Case) -> bool {
    const STATEMENTS: [&[u8]; 5] = [b"GOTO", b"IF", b"CALL", b"MODIN", b"PSELECT"];
    let text = decode(&case.program, case.setup.tape.code);
    let has = |keyword: &[u8]| text.windows(keyword.len()).any(|window| window == keyword);
    case.setup.macros.is_empty() && !case.setup.schedule && !STATEMENTS.iter().any(|keyword| has(keyword))
}

/// Its motion, if it is one.
pub(crate) fn motion(event: &Event) -> Option<Motion> {
    match event.action {
        Action::Rapid { motion }
        | Action::Linear { motion, .. }
        | Action::Arc { motion, .. }
        | Action::Thread { motion, .. }
        | Action::ContourArc { motion, .. } => Some(motion),
        _ => None,
    }
}

/// Whether an event cites a rule of thread cutting with the main spindle.
pub(crate) fn is_of_thread(event: &Event) -> bool {
    const AREAS: &[&str] = &["G31", "G32", "G33", "G34", "G71", "G72"];
    let area = |rule: &RuleId| AREAS.contains(&rule.as_str().split('-').nth(1).unwrap_or_default());
    event.rules.as_slice().iter().any(area)
}

/// Whether it is a motion of a grooving, drilling or tapping cycle.
pub(crate) fn is_of_cycle(event: &Event) -> bool {
    const AREAS: &[&str] = &["CTHR", "G181", "G182", "G183", "G184", "G189", "G190", "GRV", "STAP", "TAP"];
    let area = |rule: &RuleId| AREAS.contains(&rule.as_str().split('-').nth(1).unwrap_or_default());
    motion(event).is_some_and(|motion| motion.part.is_some()) && event.rules.as_slice().iter().any(area)
}

/// Whether it is an alarm.
pub(crate) fn is_alarm(event: &Event) -> bool {
    matches!(event.action, Action::Alarm(_))
}

/// The event without its place: what it is whatever the spelling of its block. The name of its program stays.
pub(crate) fn without_place(event: &Event) -> Event {
    Event { block: Place { program: event.block.program, ..Place::default() }, ..*event }
}
