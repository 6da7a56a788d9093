//! Reset processing of M02 and M30 (E100L-MCODE-04).

use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::frame::Amounts;
use crate::state::State;
use crate::thread;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, FrameCause, Label, RuleSet};

/// The groups that a reset changes, in its order, and the rules that say so.
const RESET: [(GGroup, RuleSet); 7] = [
    (GGroup::Motion, RuleSet::of(&[MCODE_04])),
    (GGroup::Dimension, RuleSet::of(&[MCODE_04, ABS_01])),
    (GGroup::FeedUnit, RuleSet::of(&[MCODE_04, FEED_01])),
    (GGroup::CuttingSpeed, RuleSet::of(&[MCODE_04])),
    (GGroup::Droop, RuleSet::of(&[MCODE_04])),
    (GGroup::Compensation, RuleSet::of(&[MCODE_04, NRC_01])),
    (GGroup::Plane, RuleSet::of(&[MCODE_04, CRC_04])),
];

/// Resets the modes and the zero shift, and without an event the areas and the comment of the user task and what a
/// thread keeps; the events of what changes.
pub fn reset(state: &mut State) -> Vec<Emission> {
    state.memory.reset();
    state.thread = thread::Kept::default();
    let mut emissions = Vec::new();
    for (group, rules) in RESET {
        let (active, initial) = (state.modes.get(group), group.initial());
        if active != initial {
            state.modes.set(group, initial);
            emissions.push(Emission::new(mode(group, initial, active), rules));
        }
    }
    if state.frame.zero_shift != Amounts::default() {
        // E100L-G50-05, E100L-SVAR-02.
        state.frame.zero_shift = Amounts::default();
        let event = state.frame.event(FrameCause::ZeroShift);
        emissions.push(Emission::new(event, RuleSet::of(&[G50_05, SVAR_02])));
    }
    emissions
}

/// The event of a changed mode.
pub fn mode(group: GGroup, code: u16, previous: u16) -> Action {
    Action::Mode {
        group: Label::new(group.name()),
        code: Label::of_code(b'G', code),
        previous: Label::of_code(b'G', previous),
    }
}
