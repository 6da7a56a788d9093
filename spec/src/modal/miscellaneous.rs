//! M codes (E100L-MCODE-01 to -39, E100L-MTAB-01, E100L-MTAB-02, E100L-STM-01 to -03, E100L-TUNC-01, E100L-TUNC-02).

use super::check::Plan;
use super::spindle;
use crate::controls::e100l::m_codes::{aux_rules, group_of};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Duration, Label, RuleSet, Side, SpindleState};

/// Carries an M code out that acts before the motion; its event.
pub fn command(code: u16, plan: &Plan, state: &mut State) -> Outcome<Emission> {
    if matches!(code, 13 | 14) && !state.c_joined() && !state.is_active(153) {
        // E100L-CAX-04.
        return fail(AlarmName::MToolNotJoined, CAX_04);
    }
    if code == 203 && plan.words.has_g(0) {
        return turret_unclamp(state);
    }
    if matches!(code, 3 | 4) {
        may_start(code, state)?;
    }
    state.activate(code);
    Ok(match code {
        3 | 4 => start_main_spindle(code, plan, state),
        5 => main_spindle(Some(SpindleState::Stop), &[MCODE_05], plan, state),
        19 => main_spindle(Some(SpindleState::Orient), &[MCODE_08], plan, state),
        40..=44 => main_spindle(None, &[MCODE_14, SPD_05], plan, state),
        12 => tool_spindle(SpindleState::Stop, &[MCODE_06], state),
        13 => tool_spindle(SpindleState::Clockwise, &[MCODE_06, SB_03], state),
        14 => tool_spindle(SpindleState::CounterClockwise, &[MCODE_06, SB_03], state),
        240..=244 => spindle::tool_event(RuleSet::of(&[MCODE_39, SB_04]), state),
        8 | 9 => Emission::new(Action::Coolant { on: code == 8 }, RuleSet::of(&[MTAB_01])),
        85 if plan.is_contour_call() => auxiliary(code, RuleSet::of(&[MCODE_22, LAPC_08])),
        _ => auxiliary(code, RuleSet::of(aux_rules(code))),
    })
}

/// Carries an M code out as a cycle does, without a block of its own (E100L-MCYC-10, E100L-TAP-02): neither E100L-M63-01
/// nor E100L-M63-02 is about it.
pub fn by_cycle(code: u16, state: &mut State) -> Emission {
    state.activate(code);
    let rules = match code {
        3..=5 => {
            let turret = state.turret();
            let starts = code != 5;
            if starts {
                state.spindle.started_with = Some(turret);
            }
            state.spindle.main = if starts { direction(code, state) } else { SpindleState::Stop };
            let event = spindle::main_event(RuleSet::of(&[MCODE_05]), false, state);
            return event.rule_if(starts, SPD_04).rule_if(starts && turret == Side::B, MIRR_06);
        }
        12 => return tool_spindle(SpindleState::Stop, &[MCODE_06], state),
        13 => return tool_spindle(SpindleState::Clockwise, &[MCODE_06, SB_03], state),
        14 => return tool_spindle(SpindleState::CounterClockwise, &[MCODE_06, SB_03], state),
        _ => RuleSet::of(aux_rules(code)),
    };
    auxiliary(code, rules)
}

fn auxiliary(code: u16, rules: RuleSet) -> Emission {
    let group = group_of(code).map_or(Label::default(), |group| Label::new(group.name));
    Emission::new(Action::Aux { code: Label::of_code(b'M', code), group }, rules)
}

fn main_spindle(
    command: Option<SpindleState>,
    rules: &[crate::vocabulary::RuleId],
    plan: &Plan,
    state: &mut State,
) -> Emission {
    if let Some(command) = command {
        state.spindle.main = command;
    }
    let (with_motion, order) = timing(plan);
    spindle::main_event(RuleSet::of(rules).union(order), with_motion, state)
}

/// E100L-MCODE-19, E100L-M63-01, E100L-M63-02: whether spindle commands go together with the motion of their
/// block.
pub fn timing(plan: &Plan) -> (bool, RuleSet) {
    match (plan.moves, plan.words.m.contains(&63)) {
        (true, false) => (false, RuleSet::of(&[M63_01])),
        (with_motion, true) => (with_motion, RuleSet::of(&[M63_02])),
        (false, false) => (false, RuleSet::EMPTY),
    }
}

/// E100L-MIRR-06: the direction in which the main spindle turns by M03 and M04.
fn direction(code: u16, state: &State) -> SpindleState {
    match (code, state.turret()) {
        (3, Side::A) | (4, Side::B) => SpindleState::Clockwise,
        _ => SpindleState::CounterClockwise,
    }
}

/// E100L-MIRR-08: what one turret has started the other one does not reverse; without a stop between.
fn may_start(code: u16, state: &State) -> Outcome<()> {
    let reverses = match state.spindle.main {
        SpindleState::Clockwise | SpindleState::CounterClockwise => {
            direction(code, state) != state.spindle.main
        }
        _ => false,
    };
    if reverses && state.spindle.started_with != Some(state.turret()) {
        return fail(AlarmName::TurretChange, MIRR_08);
    }
    Ok(())
}

fn start_main_spindle(code: u16, plan: &Plan, state: &mut State) -> Emission {
    let turret = state.turret();
    state.spindle.started_with = Some(turret);
    let event = main_spindle(Some(direction(code, state)), &[MCODE_05, SPD_04], plan, state);
    event.rule_if(turret == Side::B, MIRR_06)
}

fn tool_spindle(command: SpindleState, rules: &[crate::vocabulary::RuleId], state: &mut State) -> Emission {
    state.spindle.tool = command;
    spindle::tool_event(RuleSet::of(rules), state)
}

/// E100L-TUNC-01, E100L-TUNC-02: M203 in a block with G00.
fn turret_unclamp(state: &State) -> Outcome<Emission> {
    if state.cut_last && !state.setup.inputs.turret_clamp_confirmed {
        return fail(AlarmName::TurretClamp, TUNC_02);
    }
    Ok(auxiliary(203, RuleSet::of(&[TUNC_01])))
}

/// The functions whose time is checked.
pub enum Timed {
    /// S words.
    S,
    /// T words.
    T,
    /// M codes.
    M,
}

/// E100L-STM-01, E100L-STM-03: a function that takes longer than the limit, while M124 is in force.
pub fn check_time(function: &Timed, in_force: bool, state: &State) -> Outcome<()> {
    let stm = &state.setup.stm;
    let time: Duration = match function {
        Timed::S => stm.s,
        Timed::T => stm.t,
        Timed::M => stm.m,
    };
    if in_force && stm.enabled && time > stm.limit {
        return fail(AlarmName::StmOver, STM_01);
    }
    Ok(())
}
