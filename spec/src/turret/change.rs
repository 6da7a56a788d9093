//! Blocks that select a turret (E100L-MIRR-03, E100L-MIRR-09, E100L-MIRR-10, E100L-MIRR-18, E100L-MIRR-20).

use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::modal::mode;
use crate::state::State;
use crate::syntax::{Address, Item, ItemKind, Value};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, FrameCause, Label, RuleSet, Side};

/// E100L-MIRR-03, E100L-AX4-01: the turrets that G13 and G14 of a block name, written as plain numbers.
pub fn selected_by(items: &[Item]) -> Vec<Side> {
    items.iter().filter_map(|item| selection(&item.kind)).collect()
}

fn selection(item: &ItemKind) -> Option<Side> {
    let ItemKind::Word(Address::Letter(b'G'), Value::Number(number)) = item else { return None };
    match number.whole() {
        Some(13) => Some(Side::A),
        Some(14) => Some(Side::B),
        _ => None,
    }
}

/// Carries a block with these codes out; what else it holds is ignored (E100L-MIRR-03). `left_over`: a displacement of
/// radius compensation is.
pub fn change(
    codes: &[Side],
    left_over: bool,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    let [turret] = codes else { return fail(AlarmName::GCodesConflict, GCODE_04) };
    if *turret == state.turret() {
        return Ok(());
    }
    may_change(left_over, state)?;
    let before = CAUSES.map(|cause| in_plane(cause, state));
    let (code, previous) = (code_of(*turret), code_of(state.turret()));
    state.select_turret(*turret);
    state.base = None;
    let event = Emission::new(mode(GGroup::Turret, code, previous), RuleSet::of(&[GCODE_02, MIRR_10]));
    emissions.push(event.of(Some(*turret)));
    for (cause, before) in CAUSES.into_iter().zip(before) {
        if in_plane(cause, state) != before {
            emissions.push(frame_event(cause, state).of(Some(*turret)));
        }
    }
    Ok(())
}

/// The fault of a block with these codes in a definition of a contour or a blank: LAP is in force there, which forbids a
/// change; no other code may stand there either (E100L-MIRR-09, E100L-LAP-03, E100L-LAP-04).
pub fn in_definition(codes: &[Side], blank: bool, state: &State) -> Fault {
    let [turret] = codes else { return Fault::new(AlarmName::GCodesConflict, GCODE_04) };
    if *turret != state.turret() {
        return Fault::new(AlarmName::TurretChange, MIRR_09);
    }
    let code = Label::of_code(b'G', code_of(*turret));
    Fault::about(AlarmName::ContourMalformed, if blank { LAP_03 } else { LAP_04 }, code.as_str())
}

/// The amounts that each turret has for itself, in the order of their events (E100L-MIRR-18).
const CAUSES: [FrameCause; 3] = [FrameCause::ZeroOffset, FrameCause::ZeroShift, FrameCause::ToolOffset];

fn in_plane(cause: FrameCause, state: &State) -> (i64, i64) {
    let amounts = state.frame.amounts(cause);
    (amounts.x, amounts.z)
}

/// E100L-MIRR-11: with the offset number of its last T word.
fn frame_event(cause: FrameCause, state: &State) -> Emission {
    let event = Emission::new(state.frame.event(cause), RuleSet::of(&[MIRR_18]));
    if cause == FrameCause::ToolOffset {
        event.rule_if(true, MIRR_11).reading(state.setup.readings.tool_offset)
    } else {
        event
    }
}

/// E100L-MIRR-09, E100L-MIRR-20: modes that forbid the change, and what is not described.
fn may_change(left_over: bool, state: &State) -> Outcome<()> {
    let modes = &state.modes;
    if modes.compensating() || modes.incremental() || modes.cutting_speed() {
        return fail(AlarmName::TurretChange, MIRR_09);
    }
    if left_over {
        return Err(Fault::about(AlarmName::Unspecified, MIRR_09, "displacement"));
    }
    if state.c_joined() {
        return Err(Fault::about(AlarmName::Unspecified, MIRR_20, "c_axis"));
    }
    Ok(())
}

fn code_of(turret: Side) -> u16 {
    match turret {
        Side::A => 13,
        Side::B => 14,
    }
}
