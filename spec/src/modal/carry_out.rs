//! Everything of a block but its motion, in order (E100L-FMT-09, E100L-CAX-09): modes, feed, G50, S, T, M, and after the
//! motion the codes that stop or end the program.

use super::check::Plan;
use super::miscellaneous::{self, Timed, check_time};
use super::reset::mode;
use super::{feed, spindle, tool};
use crate::barrier::Watch;
use crate::contour;
use crate::controls::e100l::g_codes::{GCode, GGroup, g_code};
use crate::cycle;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::integer::turn;
use crate::lap;
use crate::saddle::{Commands, is_common_g, is_common_m};
use crate::state::{Modes, State};
use crate::thread;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, FrameCause, InchConversion, Label, RuleId, RuleSet};

/// Carries out what comes before the motion.
pub fn before_motion(plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    let words = &plan.words;
    let (by_other, for_both) = common_commands(plan);
    for code in words.g.iter().filter(|code| !(by_other && is_common_g(**code))) {
        if matches!(code, 136 | 137) {
            contour::convert(*code, plan, state, emissions)?;
            continue;
        }
        let event = select(*code, state);
        emissions.extend(event.map(|event| event.rule_if(for_both && is_common_g(*code), AX4_06)));
    }
    state.thread.select(words, state.modes.get(GGroup::Motion));
    state.cycle.begin_block(plan);
    if let Some(number) = words.feed.as_ref().filter(|_| plan.one_shot != Some(4)) {
        feed::store(number, thread::feed_is_lead(plan), words.get('J'), state)?;
    } else if let (Some(leads), Some(feed)) = (words.get('J'), &mut state.feed) {
        // E100L-THRD-06: J alone divides the F in force.
        feed.leads = leads;
    }
    lap::store_feeds(words, state)?;
    match plan.one_shot {
        Some(50) => zero_shift(plan, state, emissions),
        Some(28) => emissions.push(torque_limits(None, None, &[TRQ_02], state)),
        Some(29) => {
            let percent = |name| words.extended(name).and_then(|value| u8::try_from(value).ok());
            let (z, w) = (percent("PZ").or(state.torque.0), percent("PW").or(state.torque.1));
            emissions.push(torque_limits(z, w, &[TRQ_01, TRQ_08], state));
        }
        _ => {}
    }
    spindle_words(plan, state, emissions)?;
    // E100L-GRV-08: T of a groove selects nothing.
    if let Some(number) = words.get('T').filter(|_| !cycle::is_groove(plan.one_shot)) {
        let (event, frame) = tool::command(number, plan.moves, state);
        emissions.push(event);
        check_time(&Timed::T, state.is_active(124), state)?;
        emissions.extend(frame.map(|frame| of_inch_block(frame, plan, state)));
    }
    let watch = Watch::in_force(state);
    let waits = state.waits();
    for code in words.m.iter().filter(|code| acts_before_motion(**code, plan, waits)) {
        // M124 itself is not checked, M125 still is.
        let in_force = state.is_active(124) && *code != 124;
        if *code == 109 && plan.cutter.is_some() {
            return Err(Fault::about(AlarmName::Unspecified, CRC_14, "M109"));
        }
        let event = miscellaneous::command(*code, plan, state)?;
        emissions.push(event.rule_if(for_both && is_common_m(*code), AX4_06));
        check_time(&Timed::M, in_force, state)?;
        if *code == 109 {
            emissions.extend(turning_plane(state));
        }
        state.contour.command(*code);
    }
    state.watch = watch.or(Watch::in_force(state));
    Ok(())
}

/// E100L-AX4-06: whether the block of the other saddle carries the common words out, and whether this one does it for
/// both.
fn common_commands(plan: &Plan) -> (bool, bool) {
    let commands = plan.words.commands;
    (commands == Commands::ByOther, commands == Commands::ForBoth)
}

/// The code with which the program ends: M02 or M30.
pub fn end_code(plan: &Plan) -> Option<u16> {
    plan.words.m.iter().copied().find(|code| matches!(code, 2 | 30))
}

/// Whether an M code is carried out before the motion, by this block. E100L-M100-01: M100 that `waits` for the other side
/// does so behind the motion.
fn acts_before_motion(code: u16, plan: &Plan, waits: bool) -> bool {
    let (by_other, _) = common_commands(plan);
    let later = is_program_code(code) || waits && code == 100;
    let elsewhere = by_other && is_common_m(code);
    !later && !elsewhere
}

/// M00, M01, M02 and M30 act after the motion.
fn is_program_code(code: u16) -> bool {
    matches!(code, 0 | 1 | 2 | 30)
}

/// E100L-GCODE-02: a code of another mode; the rule that says what the mode means.
fn select(code: u16, state: &mut State) -> Option<Emission> {
    let GCode::Modelled(group) = g_code(code) else { return None };
    state.contour.select(code, state.setup);
    let previous = state.modes.get(group);
    if matches!(group, GGroup::OneShot | GGroup::ChangePoints) || previous == code {
        return None;
    }
    state.modes.set(group, code);
    let rule: RuleId = match code {
        17 | 18 | 119 => CRC_01,
        40..=42 => NRC_01,
        0 => G00_01,
        1 => G01_01,
        2 | 3 => CIRC_01,
        31 => G33_02,
        32 => G32_01,
        33 => G33_01,
        34 | 35 => G34_01,
        101 => CGF_02,
        102 | 103 => CGF_04,
        132 | 133 => CGS_01,
        64 => DROOP_02,
        65 => DROOP_01,
        90 => ABS_01,
        91 => ABS_02,
        94 => FEED_02,
        95 => FEED_01,
        96 => CSS_01,
        97 => CSS_02,
        110 | 111 if state.saddle.is_some() => AX4_08,
        110 | 111 => MIRR_19,
        _ => GCODE_02,
    };
    // E100L-NRC-61: from one side to the other without G40 between.
    let other_side = group == GGroup::Compensation && previous != 40 && code != 40;
    let event = Emission::new(mode(group, code, previous), RuleSet::of(&[GCODE_02, rule]));
    let event = event.rule_if(other_side, NRC_61).rule_if(previous == Modes::NO_CODE, CSC_05);
    Some(event.rules(cycle::mode_rules(code)))
}

/// E100L-CRC-03: M109 selects G18.
fn turning_plane(state: &mut State) -> Option<Emission> {
    let previous = state.modes.get(GGroup::Plane);
    state.modes.set(GGroup::Plane, 18);
    (previous != 18).then(|| Emission::new(mode(GGroup::Plane, 18, previous), RuleSet::of(&[CRC_03])))
}

/// E100L-INCH-02: a frame event of a block with a length in inches depends on the conversion.
fn of_inch_block(event: Emission, plan: &Plan, state: &State) -> Emission {
    if !plan.words.inch {
        return event;
    }
    let reading: InchConversion = state.setup.readings.inch_conversion;
    event.rule_if(true, INCH_02).reading(reading)
}

/// E100L-G50-01 to -04: the shift by which the present point gets the written coordinates.
fn zero_shift(plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) {
    let words = &plan.words;
    if words.has_any("XZCW") {
        let present = state.frame.program();
        let shift = &mut state.frame.zero_shift;
        shift.x += words.get('X').map_or(0, |value| present.x - value);
        shift.z += words.get('Z').map_or(0, |value| present.z - value);
        if let Some(value) = words.get('C') {
            shift.c = turn::shift(shift.c + present.c - value);
        }
        shift.w += words.get('W').map_or(0, |value| present.w - value);
        let rules = RuleSet::of(&[G50_01, G50_02, G50_03, G50_04]);
        let event = Emission::new(state.frame.event(FrameCause::ZeroShift), rules);
        emissions.push(of_inch_block(event, plan, state));
    }
    let (by_other, for_both) = common_commands(plan);
    if let Some(speed) = words.get('S').filter(|_| !by_other) {
        state.spindle.clamp = Some(speed * 1_000);
        let event = spindle::clamp_event(RuleSet::of(&[SMAX_02]), state);
        emissions.push(event.rule_if(for_both, AX4_06));
    }
}

fn torque_limits(z: Option<u8>, w: Option<u8>, rules: &[RuleId], state: &mut State) -> Emission {
    state.torque = (z, w);
    Emission::new(Action::Torque { z, w }, RuleSet::of(rules))
}

fn spindle_words(plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    let words = &plan.words;
    let (by_other, for_both) = common_commands(plan);
    if let Some(value) = words.get('S').filter(|_| plan.one_shot != Some(50) && !by_other) {
        spindle::store_s(value, state);
        let (with_motion, order) = miscellaneous::timing(plan);
        let event = spindle::main_event(RuleSet::of(&[SPD_01]).union(order), with_motion, state);
        let event = event.rule_if(plan.moves, SPD_02).rule_if(!state.modes.cutting_speed(), CSS_02);
        emissions.push(event.rule_if(for_both, AX4_06));
        check_time(&Timed::S, state.is_active(124), state)?;
    }
    if let Some(speed) = words.extended("SA") {
        state.spindle.c_axis_speed = Some(speed);
        emissions.push(spindle::c_axis_event(speed));
    }
    if let Some(speed) = words.extended("SB") {
        state.spindle.tool_speed = speed * 1_000;
        emissions.push(spindle::tool_event(RuleSet::of(&[SB_01, SB_02]), state));
    }
    Ok(())
}

/// M00 and M01, after the motion.
pub fn stop(plan: &Plan, state: &State) -> Option<Emission> {
    let has = |code| plan.words.m.contains(&code);
    if has(0) {
        return Some(Emission::new(Action::Stop, RuleSet::of(&[MCODE_02])));
    }
    let stops = has(1) && state.setup.switches.optional_stop;
    stops.then(|| Emission::new(Action::OptionalStop, RuleSet::of(&[MCODE_03])))
}

/// The event of M02 and M30, behind the reset if there is one.
pub fn end(code: u16, state: &State) -> Emission {
    let end = Action::End { code: Label::of_code(b'M', code) };
    // The reset has changed the turret.
    Emission::new(end, RuleSet::of(&[MCODE_04])).of(state.side())
}
