//! The words of a block and its amounts: checks 3 and 4 of the cycles (E100L-GRV-01 to -10, E100L-TAP-01, E100L-TAP-04,
//! E100L-MCYC-04, E100L-MCYC-05, E100L-MCYC-09, E100L-MCYC-22, E100L-MCYC-23, and the rules of each cycle).

use super::block::{CycleBlock, Role, is_chain, is_synchronised, is_thread};
use super::function::is_on_side;
use super::kept::KeptWords;
use crate::controls::e100l::units;
use crate::fault::{Fault, Outcome, fail};
use crate::integer::tool::parts;
use crate::modal::{Words, dwell_time, is_feed};
use crate::quantity::{Exact, ratio, round_narrow, whole};
use crate::state::{Modes, State};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId, Setup};

/// Check 3 of G73 and G74.
pub fn check_groove(code: u16, words: &Words, modes: Modes, state: &State) -> Outcome<()> {
    let (bottom, lateral, rule) = if code == 73 { ('X', 'Z', GRV_01) } else { ('Z', 'X', GRV_02) };
    has(words, bottom, rule)?;
    has(words, 'D', GRV_10)?;
    not_zero(words, 'D', GRV_10)?;
    // E100L-GRV-03: the approach; E100L-GRV-06: the step.
    let (i, k): (RuleId, RuleId) = if code == 73 { (GRV_03, GRV_06) } else { (GRV_06, GRV_03) };
    for (letter, rule) in [('I', i), ('K', k)] {
        if is_negative(words, letter) {
            return unspecified(rule, letter);
        }
    }
    if is_negative(words, 'L') {
        return fail(AlarmName::AddressRange, GRV_05);
    }
    if words.extended("DA").is_some_and(|retract| retract < 0) {
        return fail(AlarmName::AddressRange, GRV_04);
    }
    not_zero(words, 'L', GRV_05)?;
    if let Some(tool) = words.get('T') {
        let (_, tool, _) = parts(tool);
        let other = tool != 0 && tool != state.tool;
        if modes.incremental() || words.get(lateral).is_none() || other {
            return unspecified(GRV_08, 'T');
        }
    }
    is_dwell(words, state.setup)
}

/// Check 3 of G77 and G78.
pub fn check_tapping(words: &Words, modes: Modes) -> Outcome<()> {
    for letter in ['X', 'Z', 'K'] {
        has(words, letter, TAP_01)?;
    }
    if is_negative(words, 'K') {
        return unspecified(TAP_01, 'K');
    }
    if modes.cutting_speed() {
        return Err(Fault::about(AlarmName::Unspecified, TAP_04, "G96"));
    }
    Ok(())
}

/// Check 4 of a block of a cycle mode.
pub fn check_block(words: &Words, block: CycleBlock, state: &State) -> Outcome<()> {
    let CycleBlock { code, role } = block;
    if role == Role::Cancel {
        return Ok(());
    }
    if is_thread(code) {
        return thread(words, block, state);
    }
    let first = role == Role::First;
    let kept = state.cycle.mode.map(|mode| mode.words).unwrap_or_default();
    side_or_face(words, first, &kept)?;
    if code == 190 {
        return key_way(words, first, state.setup);
    }
    depth(words, first, is_on_side(words, state))?;
    if is_synchronised(code, state.setup) {
        return tap(words, state.setup);
    }
    if code == 183 {
        deep_hole(words, first)?;
    }
    is_dwell(words, state.setup)
}

/// E100L-MCYC-04, E100L-MCYC-05, E100L-MCYC-09: the first block says by I or K where the cut goes, and how far the
/// approach.
fn side_or_face(words: &Words, first: bool, kept: &KeptWords) -> Outcome<()> {
    for letter in ['I', 'K'] {
        not_negative_approach(words, letter)?;
    }
    let given = [('I', words.get('I'), kept.i), ('K', words.get('K'), kept.k)];
    if first {
        return match given {
            [(_, Some(_), _), (_, Some(_), _)] => unspecified(MCYC_04, 'I'),
            [(_, None, _), (_, None, _)] => fail(AlarmName::WordMissing, MCYC_04),
            _ => Ok(()),
        };
    }
    match given.iter().find(|(_, word, kept)| word.is_some() && word != kept) {
        Some((letter, ..)) => unspecified(MCYC_09, *letter),
        None => Ok(()),
    }
}

/// E100L-MCYC-22, E100L-MCYC-23.
fn depth(words: &Words, first: bool, side: bool) -> Outcome<()> {
    match (words.get('R'), words.get(if side { 'X' } else { 'Z' })) {
        (Some(_), Some(_)) => fail(AlarmName::CycleDepthOverdetermined, MCYC_23),
        (None, None) if first => fail(AlarmName::WordMissing, MCYC_22),
        _ => Ok(()),
    }
}

/// E100L-G183-01, E100L-G183-02.
fn deep_hole(words: &Words, first: bool) -> Outcome<()> {
    if first {
        has(words, 'D', G183_01)?;
    }
    not_zero(words, 'D', G183_01)?;
    if is_negative(words, 'L') {
        return fail(AlarmName::AddressRange, G183_02);
    }
    not_zero(words, 'L', G183_02)
}

/// E100L-G190-01, E100L-G190-07.
fn key_way(words: &Words, first: bool, setup: &Setup) -> Outcome<()> {
    if first {
        for letter in ['X', 'Z', 'D'] {
            has(words, letter, G190_01)?;
        }
    }
    not_zero(words, 'D', G190_01)?;
    if is_negative(words, 'W') {
        return fail(AlarmName::AddressRange, G190_07);
    }
    match &words.e {
        Some(number) if !is_feed(&per_minute(number, setup), setup.unit_system) => {
            fail(AlarmName::AddressRange, G190_01)
        }
        _ => Ok(()),
    }
}

/// E100L-THRD-06, E100L-STAP-01.
fn tap(words: &Words, setup: &Setup) -> Outcome<()> {
    if words.leads.as_ref().is_some_and(|leads| !leads.is_int()) {
        return unspecified(THRD_06, 'J');
    }
    match &words.d {
        Some(number) if number * units::angle(setup.unit_system) > whole(359_999_000) => {
            fail(AlarmName::AddressRange, STAP_01)
        }
        _ => Ok(()),
    }
}

/// E100L-CTHR-01, E100L-CTHR-04, E100L-CTHR-05, E100L-MCYC-05.
fn thread(words: &Words, block: CycleBlock, state: &State) -> Outcome<()> {
    let CycleBlock { code, role } = block;
    if role == Role::First {
        has(words, 'X', CTHR_01)?;
        has(words, 'Z', CTHR_01)?;
    }
    let approach = if matches!(code, 185 | 187) { 'K' } else { 'I' };
    not_negative_approach(words, approach)?;
    if is_chain(code) && role == Role::FollowUp {
        let rule = if code == 187 { CTHR_04 } else { CTHR_05 };
        if let Some(letter) = ['C', approach].into_iter().find(|letter| words.get(*letter).is_some()) {
            return unspecified(rule, letter);
        }
    }
    if words.extended("SA").or(state.spindle.c_axis_speed).is_none() {
        return fail(AlarmName::WordMissing, CTHR_01);
    }
    Ok(())
}

fn has(words: &Words, letter: char, rule: RuleId) -> Outcome<()> {
    if words.get(letter).is_none() { fail(AlarmName::WordMissing, rule) } else { Ok(()) }
}

fn not_zero(words: &Words, letter: char, rule: RuleId) -> Outcome<()> {
    if words.get(letter) == Some(0) { unspecified(rule, letter) } else { Ok(()) }
}

/// E100L-MCYC-05.
fn not_negative_approach(words: &Words, letter: char) -> Outcome<()> {
    if is_negative(words, letter) {
        return Err(Fault::about(AlarmName::CycleApproachNegative, MCYC_05, &letter.to_string()));
    }
    Ok(())
}

fn is_negative(words: &Words, letter: char) -> bool {
    words.get(letter).is_some_and(|value| value < 0)
}

fn unspecified(rule: RuleId, letter: char) -> Outcome<()> {
    Err(Fault::about(AlarmName::Unspecified, rule, &letter.to_string()))
}

/// E100L-DWELL-02: the range of an E that is a time.
fn is_dwell(words: &Words, setup: &Setup) -> Outcome<()> {
    words.e.as_ref().map_or(Ok(()), |number| dwell_time(number, setup).map(|_| ()))
}

/// E100L-STAP-01: D as an angle, in micro-degrees.
pub fn start_angle(words: &Words, setup: &Setup) -> Option<i64> {
    let number = words.d.as_ref()?;
    Some(round_narrow(&(number * units::angle(setup.unit_system) * ratio(1, 1_000))) * 1_000)
}

/// E of a block of a cycle: a time in microseconds (E100L-G181-01), of G190 a feed in picometres per minute
/// (E100L-G190-01).
pub fn e_of(words: &Words, code: u16, setup: &Setup) -> Option<i64> {
    let number = words.e.as_ref()?;
    if code == 190 {
        return Some(round_narrow(&(per_minute(number, setup) * whole(1_000))));
    }
    dwell_time(number, setup).ok().map(|time| time.0)
}

/// A feed per minute in nanometres.
fn per_minute(number: &Exact, setup: &Setup) -> Exact {
    number * units::feed_per_minute(setup.unit_system)
}
