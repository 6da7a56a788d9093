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
    let plain = case.setup.macros.is_empty() && !case.setup.schedule && !calls_contours(case);
    plain && !STATEMENTS.iter().any(|keyword| has(keyword))
}

/// Whether the text may have a call of LAP, G85 to G88, which reads or carries out blocks elsewhere and has passes.
pub(crate) fn calls_contours(case: &Case) -> bool {
    let text = decode(&case.program, case.setup.tape.code);
    let call = |code: &[u8]| {
        let number = code.iter().copied().skip_while(|byte| b" \t=0".contains(byte)).take(2);
        matches!(number.collect::<Vec<u8>>().as_slice(), [b'8', b'5'..=b'8'])
    };
    case.setup.options.lap > 0 && text.split(|byte| *byte == b'G').skip(1).any(call)
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

/// Whether an event cites a rule of one of these areas.
fn is_of(event: &Event, areas: &[&str]) -> bool {
    let area = |rule: &RuleId| areas.contains(&rule.as_str().split('-').nth(1).unwrap_or_default());
    event.rules.as_slice().iter().any(area)
}

/// Whether an event cites a rule of LAP.
pub(crate) fn is_of_lap(event: &Event) -> bool {
    is_of(event, &["LAP", "LAPC", "AP1", "AP2", "AP3", "AP4", "AP5"])
}

/// Whether an event cites a rule of thread cutting with the main spindle, and none of LAP.
pub(crate) fn is_of_thread(event: &Event) -> bool {
    is_of(event, &["G31", "G32", "G33", "G34", "G71", "G72"]) && !is_of_lap(event)
}

/// Whether it is a motion of a grooving, drilling or tapping cycle.
pub(crate) fn is_of_cycle(event: &Event) -> bool {
    const AREAS: &[&str] = &["CTHR", "G181", "G182", "G183", "G184", "G189", "G190", "GRV", "STAP", "TAP"];
    motion(event).is_some_and(|motion| motion.part.is_some()) && is_of(event, AREAS)
}

/// Whether it is an alarm.
pub(crate) fn is_alarm(event: &Event) -> bool {
    matches!(event.action, Action::Alarm(_))
}

/// The event without its place: what it is whatever the spelling of its block. The name of its program stays.
pub(crate) fn without_place(event: &Event) -> Event {
    Event { block: Place { program: event.block.program, ..Place::default() }, ..*event }
}
