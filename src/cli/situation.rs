//! Where a run stands when it stops at an alarm: the programs that call each other, variables, modes; of two saddles
//! where each waits.

use std::collections::BTreeMap;
use std::fmt::Write;

use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::notation::value_text;
use turnspec_oracle::vocabulary::{Action, Event, Place, Side};

use super::words::stop_point;

/// What the events of a run tell about where it stands.
#[derive(Default)]
pub struct Told {
    /// The variables with a number that the run has set, by that number.
    common: BTreeMap<u32, String>,
    /// What each saddle does, on machines with two.
    saddles: BTreeMap<Side, String>,
}

impl Told {
    /// Takes an event into account.
    pub fn event(&mut self, event: &Event) {
        if let Action::Variable { name, value } = &event.action
            && let Some(number) = name.as_str().strip_prefix('V').and_then(|digits| digits.parse().ok())
        {
            self.common.insert(number, value_text(value));
        }
        let Some(side) = event.saddle else { return };
        let doing = match &event.action {
            Action::Wait { p, code } => {
                format!("waits at {}, {}", stop_point(*p, code), place(&event.block))
            }
            Action::SideEnd { .. } => format!("at its end, {}", place(&event.block)),
            _ => format!("at {}", place(&event.block)),
        };
        self.saddles.insert(side, doing);
    }
}

/// The situation of a run in some lines; nothing where there is nothing but the main program.
pub fn situation(run: &Run, told: &Told) -> String {
    let mut text = String::new();
    let calls: Vec<String> = run
        .call_stack()
        .filter_map(|program| {
            let file = program.file.map_or(String::new(), |file| format!(" of {file}"));
            program.called_at.map(|at| format!("{}{file}, called at {}", program.name, place(&at)))
        })
        .collect();
    line(&mut text, "calls", &calls);
    let locals: Vec<String> = run
        .local_variables()
        .map(|local| {
            let owner = match (local.mode, local.owner.is_empty()) {
                (Some(mode), _) => format!(" (mode {mode})"),
                (None, false) => format!(" ({})", local.owner),
                (None, true) => String::new(),
            };
            format!("{}={}{owner}", local.name, local.value)
        })
        .collect();
    line(&mut text, "locals", &locals);
    let common: Vec<String> =
        told.common.iter().map(|(number, value)| format!("V{number}={value}")).collect();
    line(&mut text, "variables", &common);
    let modes: Vec<String> = run
        .active_modes()
        .map(|mode| format!("{} {}, begun at {}", mode.number, mode.program, place(&mode.began_at)))
        .collect();
    line(&mut text, "modes", &modes);
    let saddles: Vec<String> =
        told.saddles.iter().map(|(side, doing)| format!("{} {doing}", side.as_str())).collect();
    line(&mut text, "saddles", &saddles);
    text
}

/// A line of the situation, if it has something to say.
fn line(text: &mut String, title: &str, parts: &[String]) {
    if !parts.is_empty() {
        let _ = writeln!(text, "  {title:<10}{}", parts.join("; "));
    }
}

fn place(block: &Place) -> String {
    let program = if block.program.is_empty() { String::new() } else { format!(" of {}", block.program) };
    let sequence = if block.sequence.is_empty() { String::new() } else { format!(" ({})", block.sequence) };
    format!("line {}{program}{sequence}", block.line)
}
