//! What a block of the cycles must not be, whatever its amounts are: checks 1a and 6 (E100L-MCYC-01, E100L-MCYC-02,
//! E100L-MCYC-03, E100L-MCYC-13, E100L-MCYC-14, E100L-MCYC-21, E100L-NRC-81), and where G77 stands (E100L-TAP-01).

use super::block::{CANCEL, CycleBlock, Role, is_groove, is_synchronised, is_tapping, is_thread};
use crate::controls::e100l::g_codes::GGroup;
use crate::fault::{Fault, Outcome, fail};
use crate::modal::{Before, Change, Plan, Words};
use crate::state::{Modes, State};
use crate::syntax::Address;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId};

/// M codes that belong to the cycles (E100L-MCYC-14).
const OWN_M: [u16; 8] = [136, 140, 141, 169, 211, 212, 213, 214];

/// E100L-TAP-01: nothing stands in front of G77 and G78; `before`: the words in front of the code.
pub fn stands_first(code: u16, before: &Words) -> Outcome<()> {
    let in_front = before.assigns || !before.is_empty();
    if is_tapping(Some(code)) && in_front {
        return Err(about(AlarmName::StatementMisplaced, TAP_01, code));
    }
    Ok(())
}

/// E100L-MCYC-02; `alone`: the block has one word and no assignment.
pub fn stands_alone(words: &Words, alone: bool) -> Outcome<()> {
    if words.has_g(CANCEL) && !alone { fail(AlarmName::NotAlone, MCYC_02) } else { Ok(()) }
}

/// Check 1a.
pub fn refuse(
    words: &Words,
    block: Option<CycleBlock>,
    before: Modes,
    modes: Modes,
    state: &State,
) -> Outcome<()> {
    if words.is_empty() || words.has_g(CANCEL) {
        return Ok(());
    }
    if state.cycle.spent {
        return fail(AlarmName::CycleCancelMissing, MCYC_21);
    }
    let both = words.get('X').is_some() && words.get('Z').is_some();
    if state.cycle.after_cancel && !both && !words.has_g(136) {
        return fail(AlarmName::WordMissing, MCYC_13);
    }
    if let Some(block) = block {
        refuse_cycle_block(words, block, before, modes, state)?;
    }
    if modes.converting() { goes_in_conversion(words, block) } else { Ok(()) }
}

/// E100L-CSC-09: of these blocks only holes along Z have a place in the plane of conversion mode.
fn goes_in_conversion(words: &Words, block: Option<CycleBlock>) -> Outcome<()> {
    let fixed = words.one_shot().filter(|code| matches!(code, 73 | 74 | 77 | 78));
    let cycle = block.map(|block| block.code);
    if let Some(code) = cycle.filter(|code| is_thread(*code) || *code == 190).or(fixed) {
        return Err(about(AlarmName::Unspecified, CSC_09, code));
    }
    if cycle.is_some() && words.get('I').is_some() {
        return Err(Fault::about(AlarmName::Unspecified, CSC_09, "I"));
    }
    Ok(())
}

fn refuse_cycle_block(
    words: &Words,
    block: CycleBlock,
    before: Modes,
    modes: Modes,
    state: &State,
) -> Outcome<()> {
    if block.role == Role::FollowUp && before.get(GGroup::Cycle) != block.code {
        return Err(about(AlarmName::Unspecified, MCYC_01, block.code));
    }
    if modes.incremental() {
        return fail(AlarmName::CycleIncremental, MCYC_14);
    }
    if let Some(code) = words.g.iter().find(|code| !matches!(code, 90 | 94 | 95) && **code != block.code) {
        return Err(about(AlarmName::Unspecified, MCYC_14, *code));
    }
    if let Some(word) = foreign_word(words) {
        return Err(Fault::about(AlarmName::CycleWord, MCYC_14, word.as_str()));
    }
    let free = !block.machines(words) || is_synchronised(block.code, state.setup);
    // Threads of the C axis are per revolution, the others per minute.
    if !free && modes.per_minute() == is_thread(block.code) {
        return Err(about(AlarmName::CycleFeedMode, MCYC_03, block.code));
    }
    Ok(())
}

/// E100L-MCYC-14: the first word, in written order, of S, T and M that a cycle does not go with.
fn foreign_word(words: &Words) -> Option<Label> {
    let of_m = words.m.iter().zip(&words.m_at).filter(|(code, _)| !OWN_M.contains(code));
    let of_m = of_m.map(|(code, at)| (*at, Label::of_code(b'M', *code)));
    let others = words.others.iter().filter_map(|other| match other.address {
        Some(address @ Address::Letter(b'S' | b'T')) => Some((other.span.start, address.label())),
        _ => None,
    });
    of_m.chain(others).min_by_key(|(at, _)| *at).map(|(_, label)| label)
}

/// E100L-NRC-81: cycles do not go with radius compensation.
pub fn not_in_compensation(plan: &Plan, before: Before) -> Outcome<()> {
    let own = plan.one_shot.filter(|_| is_groove(plan.one_shot) || is_tapping(plan.one_shot));
    let mode = plan.cycle.filter(|block| block.role != Role::Cancel).map(|block| block.code);
    let Some(code) = own.or(mode) else { return Ok(()) };
    let name = if plan.modes.compensating() {
        AlarmName::CompensationNotAllowed
    } else if plan.compensation == Change::Ends || before.left_over {
        AlarmName::Unspecified
    } else {
        return Ok(());
    };
    Err(about(name, NRC_81, code))
}

fn about(name: AlarmName, rule: RuleId, code: u16) -> Fault {
    Fault::about(name, rule, Label::of_code(b'G', code).as_str())
}
