//! What a block that cuts a thread must satisfy before anything of it is carried out.

use super::is_mode;
use super::kept::has_motion_code;
use crate::fault::{Fault, Outcome, fail};
use crate::modal::{Before, Plan, Words};
use crate::state::{Modes, State};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Chamfering, Label, Setup};

/// The first word of thread cutting of a block, in written order.
fn code_of(words: &Words) -> Option<u16> {
    words.g.iter().copied().find(|code| is_mode(*code) || matches!(code, 71 | 72))
}

/// E100L-THRD-01: threads are not cut in G96. `motion`: the motion mode of a block that cuts one in
/// it.
pub fn not_in_constant_speed(words: &Words, modes: Modes, motion: Option<u16>) -> Outcome<()> {
    match code_of(words).or(motion) {
        Some(code) if modes.cutting_speed() => {
            let detail = Label::of_code(b'G', code);
            Err(Fault::about(AlarmName::ThreadInConstantSpeed, THRD_01, detail.as_str()))
        }
        _ => Ok(()),
    }
}

/// Check 3 of G71 and G72 (E100L-G71-01, E100L-G72-01, E100L-G71-04).
pub fn check_compound(code: u16, words: &Words, state: &State) -> Outcome<()> {
    let longitudinal = code == 71;
    if words.get('X').is_none() || words.get('Z').is_none() {
        return fail(AlarmName::WordMissing, if longitudinal { G71_01 } else { G72_01 });
    }
    let (Some(step), Some(height)) = (words.get('D'), words.get('H')) else {
        return fail(AlarmName::WordMissing, G71_09);
    };
    if words.get('A').is_some() && words.get(if longitudinal { 'I' } else { 'K' }).is_some() {
        return fail(AlarmName::AngleOverdetermined, G71_04);
    }
    if is_negative(words, 'L') || !longitudinal && is_negative(words, 'W') {
        return fail(AlarmName::AddressRange, ADDR_01);
    }
    whole_leads(words)?;
    data(step, height, if longitudinal { 'U' } else { 'W' }, words, state)
}

/// E100L-G71-09: the data of a compound cycle.
fn data(step: i64, height: i64, allowance: char, words: &Words, state: &State) -> Outcome<()> {
    let impossible = |detail: &str| Err(Fault::about(AlarmName::ThreadData, G71_09, detail));
    let left = height - words.get(allowance).unwrap_or(0);
    if step == 0 {
        return impossible("D");
    }
    if height == 0 {
        return impossible("H");
    }
    if words.get('B').is_some_and(|angle| !(0..180_000_000).contains(&angle)) {
        return impossible("B");
    }
    if left <= 0 {
        return impossible(&allowance.to_string());
    }
    let own = words.m.iter().copied().find(|code| matches!(code, 73..=75));
    if own.or_else(|| state.active("thread_pattern")) == Some(73) && left < step {
        return impossible("M73");
    }
    Ok(())
}

/// Check 4 of a block that cuts a thread in a motion mode. `after_angle`: the block before had an angle alone.
pub fn check_block(words: &Words, motion: u16, after_angle: bool, state: &State) -> Outcome<()> {
    if matches!(motion, 34 | 35) {
        leg(words, after_angle, state.setup)?
    } else {
        single_pass(words, motion, state)?
    }
    whole_leads(words)?;
    // E100L-THRD-07.
    if is_negative(words, 'C') { fail(AlarmName::AddressRange, THRD_07) } else { Ok(()) }
}

/// E100L-G33-01, E100L-G32-01 of the first block of a cycle; E100L-G33-03, E100L-G32-04 of the others; E100L-G33-06.
fn single_pass(words: &Words, motion: u16, state: &State) -> Outcome<()> {
    let face = motion == 32;
    let first = has_motion_code(words) || state.thread.cycle.is_none();
    if first && (words.get('X').is_none() || words.get('Z').is_none()) {
        return fail(AlarmName::WordMissing, if face { G32_01 } else { G33_01 });
    }
    if !words.has_any("XZ") {
        return fail(AlarmName::WordMissing, if face { G32_04 } else { G33_03 });
    }
    let amount = words.get(if face { 'K' } else { 'I' });
    if words.get('A').is_some() && amount.is_some() {
        return fail(AlarmName::AngleOverdetermined, G33_06);
    }
    if is_negative(words, 'L') { fail(AlarmName::AddressRange, ADDR_01) } else { Ok(()) }
}

/// E100L-G34-01, E100L-G34-02, and what an angle may stand with (E100L-DTAP-01).
fn leg(words: &Words, after_angle: bool, setup: &Setup) -> Outcome<()> {
    let (x, z) = (words.get('X').is_some(), words.get('Z').is_some());
    // E100L-ANG-06.
    let alone = setup.parameters.chamfering == Chamfering::AnyAngle;
    match words.get('A') {
        Some(_) if x && z && !after_angle => fail(AlarmName::AngleOverdetermined, DTAP_01),
        Some(_) if !x && !z && !alone => fail(AlarmName::AngleUnderdetermined, DTAP_01),
        None if !x && !z => fail(AlarmName::WordMissing, G34_01),
        _ if is_negative(words, 'E') => fail(AlarmName::AddressRange, G34_02),
        _ => Ok(()),
    }
}

fn is_negative(words: &Words, letter: char) -> bool {
    words.get(letter).is_some_and(|value| value < 0)
}

/// E100L-THRD-06: what a fraction of a lead means is not told.
fn whole_leads(words: &Words) -> Outcome<()> {
    match &words.leads {
        Some(leads) if !leads.is_int() => Err(Fault::about(AlarmName::Unspecified, THRD_06, "J")),
        _ => Ok(()),
    }
}

/// E100L-NRC-81, E100L-THRD-10: threads do not go with radius compensation.
pub fn not_in_compensation(plan: &Plan, before: Before) -> Outcome<()> {
    let own = code_of(&plan.words);
    let mode = plan.is_thread().then(|| plan.motion());
    let Some(code) = own.or(mode) else { return Ok(()) };
    let cycle = |code: &u16| !matches!(code, 34 | 35);
    let has_cycle = plan.words.g.iter().any(|code| matches!(code, 31..=33 | 71 | 72));
    let is_cycle = has_cycle || mode.as_ref().is_some_and(cycle);
    let cuts = plan.is_compound() || plan.is_thread();
    let (was, is) = (before.modes.compensating(), plan.modes.compensating());
    let name = if is_cycle && is {
        AlarmName::CompensationNotAllowed
    } else if is_cycle && was || cuts && (was || is || before.left_over) {
        AlarmName::Unspecified
    } else {
        return Ok(());
    };
    Err(Fault::about(name, NRC_81, Label::of_code(b'G', code).as_str()))
}
