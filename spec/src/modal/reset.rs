//! Reset processing of M02 and M30 (E100L-MCODE-04).

use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::frame::Amounts;
use crate::lap;
use crate::state::{Modes, State};
use crate::thread;
use crate::turret::OwnData;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, FrameCause, Label, RuleSet, Side};

/// The groups that a reset changes, in its order, and the rules that say so.
const RESET: [(GGroup, RuleSet); 9] = [
    (GGroup::Motion, RuleSet::of(&[MCODE_04])),
    (GGroup::Dimension, RuleSet::of(&[MCODE_04, ABS_01])),
    (GGroup::FeedUnit, RuleSet::of(&[MCODE_04, FEED_01])),
    (GGroup::CuttingSpeed, RuleSet::of(&[MCODE_04])),
    (GGroup::CssTurret, RuleSet::of(&[MCODE_04])),
    (GGroup::Droop, RuleSet::of(&[MCODE_04])),
    (GGroup::Compensation, RuleSet::of(&[MCODE_04, NRC_01])),
    (GGroup::Plane, RuleSet::of(&[MCODE_04, CRC_04])),
    (GGroup::Conversion, RuleSet::of(&[MCODE_04, CSC_01])),
];

/// Resets the modes, the turret and the zero shift, and without an event the areas and the comment of the user task and
/// what threads and LAP keep; the events of what changes.
pub fn reset(state: &mut State) -> Vec<Emission> {
    state.memory.reset();
    state.thread = thread::Kept::default();
    state.lap = lap::Kept::default();
    let mut emissions = Vec::new();
    for (group, rules) in RESET {
        let (active, initial) = (state.modes.get(group), group.initial());
        if active != initial {
            state.modes.set(group, initial);
            emissions.push(Emission::new(mode(group, initial, active), rules));
        }
    }
    emissions.extend(turret_a(state));
    emissions.append(&mut no_shift(state));
    emissions
}

/// E100L-MIRR-04: turret A is selected.
fn turret_a(state: &mut State) -> Option<Emission> {
    if state.turret() == Side::A {
        return None;
    }
    state.select_turret(Side::A);
    let event = Emission::new(mode(GGroup::Turret, 13, 14), RuleSet::of(&[MCODE_04, MIRR_04]));
    Some(event.of(Some(Side::A)))
}

/// E100L-G50-05, E100L-SVAR-02: no zero shift, of whichever turret.
fn no_shift(state: &mut State) -> Vec<Emission> {
    let in_force = std::mem::take(&mut state.frame.zero_shift) != Amounts::default();
    let other = state.other_turret.as_mut().is_some_and(OwnData::clear_shift);
    let event = Emission::new(state.frame.event(FrameCause::ZeroShift), RuleSet::of(&[G50_05, SVAR_02]));
    let mut emissions = Vec::new();
    if in_force {
        emissions.push(event.clone().of(state.side()));
    }
    if other {
        emissions.push(event.of(Some(Side::B)));
    }
    emissions
}

/// The event of a changed mode.
pub fn mode(group: GGroup, code: u16, previous: u16) -> Action {
    Action::Mode {
        group: Label::new(group.name()),
        code: Label::of_code(b'G', code),
        // E100L-CSC-05: none was in force.
        previous: if previous == Modes::NO_CODE { Label::default() } else { Label::of_code(b'G', previous) },
        angle: None,
    }
}
