//! What a call, and a block of a definition, must satisfy before anything of it is carried out (execution-lap.md,
//! section 3).

use crate::fault::{Fault, Outcome, fail};
use crate::modal::{Before, Words, Written};
use crate::quantity::Exact;
use crate::state::{Modes, State};
use crate::syntax::Address;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId, Setup};

/// E100L-LAP-22, E100L-LAP-09: codes that the machine does not have, and a call that is none.
pub fn has_g(code: u16, words: &Words, setup: &Setup) -> Outcome<()> {
    let level = setup.options.lap;
    let refuse = |name, rule| Err(Fault::about(name, rule, Label::of_code(b'G', code).as_str()));
    if (80..=88).contains(&code) && level == 0 || code == 83 && level == 3 {
        return refuse(AlarmName::LapLevel, LAP_22);
    }
    let is_head = words.contour.is_some() && words.g.is_empty();
    if (85..=88).contains(&code) && !is_head {
        return refuse(AlarmName::StatementMisplaced, LAP_09);
    }
    Ok(())
}

/// E100L-LAP-01, E100L-LAP-02, for a block with more than one word, or with an assignment.
pub fn stands_alone(words: &Words) -> Outcome<()> {
    let rule: RuleId = match words.one_shot() {
        Some(81 | 82) => LAP_01,
        Some(83) => LAP_02,
        _ => return Ok(()),
    };
    fail(AlarmName::NotAlone, rule)
}

/// E100L-THRD-01.
pub fn not_in_constant_speed(words: &Words, modes: Modes) -> Outcome<()> {
    if words.one_shot() == Some(88) && modes.cutting_speed() {
        return Err(Fault::about(AlarmName::ThreadInConstantSpeed, THRD_01, "G88"));
    }
    Ok(())
}

/// E100L-LAP-01, E100L-LAP-07: G80 where no definition is, and E.
pub fn check_contour_block(words: &Words, state: &State) -> Outcome<()> {
    if words.has_g(80) && state.lap.definition.is_none() {
        return Err(Fault::about(AlarmName::ContourMalformed, LAP_01, "G80"));
    }
    match words.feed_of(Address::Letter(b'E')) {
        Some(feed) if *feed <= Exact::ZERO => Err(Fault::about(AlarmName::LapData, LAP_07, "E")),
        _ => Ok(()),
    }
}

/// E100L-LAPC-02: G84 in a block that is no call with G85.
pub fn change_points_belong_to_call(words: &Words) -> Outcome<()> {
    if words.has_g(84) && words.one_shot() != Some(85) {
        return Err(Fault::about(AlarmName::WordWithoutFunction, LAPC_02, "G84"));
    }
    Ok(())
}

/// Check 3 of a call.
pub fn check_call(code: u16, words: &Words, modes: Modes, before: Before, state: &State) -> Outcome<()> {
    check_place(code, words, modes, before)?;
    match code {
        85 => {
            depth(words, LAPC_01)?;
            feed(words, LAPC_01)?;
            if words.has_g(84) { change_points(words) } else { Ok(()) }
        }
        86 => {
            depth(words, LAPC_05)?;
            feed(words, LAPC_05)
        }
        88 => thread(words, state),
        _ => Ok(()),
    }
}

/// E100L-LAP-15, E100L-LAP-09: where a call stands, and what it names.
fn check_place(code: u16, words: &Words, modes: Modes, before: Before) -> Outcome<()> {
    let detail = Label::of_code(b'G', code);
    if modes.compensating() {
        return Err(Fault::about(AlarmName::CompensationNotAllowed, LAP_15, detail.as_str()));
    }
    if before.left_over {
        return Err(Fault::about(AlarmName::Unspecified, LAP_15, detail.as_str()));
    }
    if before.modal {
        return Err(Fault::about(AlarmName::Unspecified, LAP_09, "MODIN"));
    }
    if !before.has_contour {
        let name = words.contour.unwrap_or_default();
        return Err(Fault::about(AlarmName::SequenceNameUnknown, LAP_09, name.as_str()));
    }
    Ok(())
}

fn impossible(rule: RuleId, detail: &str) -> Outcome<()> {
    Err(Fault::about(AlarmName::LapData, rule, detail))
}

fn depth(words: &Words, rule: RuleId) -> Outcome<()> {
    match words.get('D') {
        None => fail(AlarmName::WordMissing, rule),
        Some(0) => impossible(rule, "D"),
        Some(_) => Ok(()),
    }
}

fn feed(words: &Words, rule: RuleId) -> Outcome<()> {
    match &words.feed {
        Some(feed) if *feed <= Exact::ZERO => impossible(rule, "F"),
        _ => Ok(()),
    }
}

/// E100L-LAPC-02: the words behind G84.
fn change_points(words: &Words) -> Outcome<()> {
    for word in &words.written {
        let Written::Word(address @ Address::Extended(name)) = *word else { continue };
        let is_zero_depth = ["DA", "DB"].contains(&name) && words.extended(name) == Some(0);
        if is_zero_depth || words.feed_of(address).is_some_and(|feed| *feed <= Exact::ZERO) {
            return impossible(LAPC_02, name);
        }
    }
    Ok(())
}

/// E100L-LAPC-07.
fn thread(words: &Words, state: &State) -> Outcome<()> {
    let (Some(step), Some(height)) = (words.get('D'), words.get('H')) else {
        return fail(AlarmName::WordMissing, LAPC_07);
    };
    if step == 0 {
        return impossible(LAPC_07, "D");
    }
    if height == 0 {
        return impossible(LAPC_07, "H");
    }
    if words.get('B').is_some_and(|angle| !(0..180_000_000).contains(&angle)) {
        return impossible(LAPC_07, "B");
    }
    let left = |allowance| height - words.get(allowance).unwrap_or(0);
    for (letter, name) in [('U', "U"), ('W', "W")] {
        if left(letter) <= 0 {
            return impossible(LAPC_07, name);
        }
    }
    let own = words.m.iter().copied().find(|code| matches!(code, 73..=75));
    let halving = own.or_else(|| state.active("thread_pattern")) == Some(73);
    if halving && (left('U') < step || left('W') < step) {
        return impossible(LAPC_07, "M73");
    }
    Ok(())
}

/// Check 5 of a call: the words that it takes (E100L-LAP-17).
pub fn every_word_has_a_function(code: u16, words: &Words) -> Outcome<()> {
    let points = words.has_g(84);
    let (letters, m): (&[u8], &[u16]) = match code {
        85 | 86 => (b"DFUW", &[85]),
        88 => (b"DHBUW", &[32, 33, 34, 73, 74, 75]),
        _ => (b"UW", &[]),
    };
    let taken = |word: &Written| match *word {
        Written::G(other) => other == code || other == 84,
        Written::M(code) => m.contains(&code),
        Written::MajorArc => false,
        Written::Word(Address::Letter(letter)) => letters.contains(&letter),
        Written::Word(Address::Extended(name)) => {
            points && ["XA", "XB", "ZA", "ZB", "DA", "DB", "FA", "FB"].contains(&name)
        }
    };
    let Some(word) = words.written.iter().find(|word| !taken(word)) else { return Ok(()) };
    let before = match word {
        Written::G(_) | Written::M(_) => true,
        Written::Word(address) => {
            [Address::Letter(b'S'), Address::Letter(b'T'), Address::Extended("SB"), Address::Extended("SA")]
                .contains(address)
        }
        Written::MajorArc => false,
    };
    let rule: RuleId = if before { LAP_17 } else { ADDR_01 };
    Err(Fault::about(AlarmName::WordWithoutFunction, rule, word.label().as_str()))
}
