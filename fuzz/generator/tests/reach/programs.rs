//! Programs of seeds, and what an event says of itself.

use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{Action, Event, Motion, RuleId};

/// The events of a program.
pub fn trace(case: &Case) -> Vec<Event> {
    let mut events = Vec::new();
    turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| events.push(*event));
    events
}

/// Whether an event cites a rule.
pub fn cites(event: &Event, rule: RuleId) -> bool {
    event.rules.as_slice().contains(&rule)
}

/// Whether the id of a rule begins like one of these.
pub fn is_in(rule: RuleId, areas: &[&str]) -> bool {
    areas.iter().any(|area| rule.as_str().starts_with(area))
}

/// The motion of an event.
pub fn motion_of(event: &Event) -> Option<Motion> {
    match event.action {
        Action::Rapid { motion }
        | Action::Linear { motion, .. }
        | Action::Arc { motion, .. }
        | Action::ContourArc { motion, .. }
        | Action::Thread { motion, .. } => Some(motion),
        _ => None,
    }
}
