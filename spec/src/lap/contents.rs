//! What the blocks of a definition may hold (E100L-LAP-01 to -04, E100L-LAP-11, E100L-LAP-12, E100L-LAP-16).

use super::kept::{Definition, Purpose};
use crate::controls::e100l::g_codes::{GCode, GGroup, g_code};
use crate::fault::{Fault, Outcome};
use crate::modal::{Words, Written};
use crate::state::State;
use crate::syntax::{Address, Item, ItemKind, Variable};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId};

/// E100L-LAP-04: an assignment to a system variable.
pub fn refuse_assignments(items: &[Item]) -> Outcome<()> {
    let system = |item: &Item| match &item.kind {
        ItemKind::Assignment(Variable::System(system, _), _) => Some(system.name),
        ItemKind::Comment(..) => Some("VUACM"),
        _ => None,
    };
    match items.iter().find_map(system) {
        Some(name) => Err(Fault::about(AlarmName::Unspecified, LAP_04, name)),
        None => Ok(()),
    }
}

/// The words of a block of a definition. `moved`: its first motion has come before the block.
pub fn refuse_words(words: &Words, moved: bool, state: &State) -> Outcome<()> {
    let Some(definition) = &state.lap.definition else { return Ok(()) };
    let refused = |word: &Written| -> Fault {
        let (_, rule, blank) = g_rule(*word, definition);
        let label = word.label();
        Fault::about(AlarmName::ContourMalformed, rule, if blank { "blank" } else { label.as_str() })
    };
    // The rows in their order, in each the words in theirs.
    for row in 0..ROWS {
        let is_of_row = |word: &&Written| g_rule(**word, definition).0 == Some(row);
        if let Some(word) = words.written.iter().find(is_of_row) {
            return Err(refused(word));
        }
    }
    let thread = matches!(motion_of(words, state), 34 | 35);
    if let Some(word) = words.written.iter().find(|word| !has_place(**word, definition, thread)) {
        return Err(Fault::about(AlarmName::ContourMalformed, LAP_04, word.label().as_str()));
    }
    let dimension = words.g.iter().find(|code| matches!(code, 90 | 91));
    if let Some(code) = dimension.filter(|_| !moved && !words.has_any("XZ")) {
        let label = Written::G(*code).label();
        return Err(Fault::about(AlarmName::ContourMalformed, LAP_11, label.as_str()));
    }
    Ok(())
}

const ROWS: u8 = 5;

/// The row of the table that refuses a G word, if one does, its rule, and whether its detail is `blank`.
fn g_rule(word: Written, definition: &Definition) -> (Option<u8>, RuleId, bool) {
    let Written::G(code) = word else { return (None, LAP_04, false) };
    let blank = definition.blank;
    match code {
        64 | 65 | 94..=97 => (Some(0), LAP_12, false),
        81 | 82 if blank => (None, LAP_02, false),
        81..=83 => (Some(1), if blank { LAP_02 } else { LAP_01 }, false),
        40..=42 if blank => (Some(2), LAP_16, false),
        80 if blank => (Some(3), LAP_02, true),
        0..=3 | 90 | 91 if blank => (None, LAP_03, false),
        _ if blank => (Some(4), LAP_03, false),
        0 | 1 | 34 | 35 | 80 | 90 | 91 if definition.purpose == Purpose::Thread => (None, LAP_04, false),
        0..=3 | 40..=42 | 75 | 76 | 80 | 90 | 91 if definition.purpose != Purpose::Thread => {
            (None, LAP_04, false)
        }
        _ => (Some(4), LAP_04, false),
    }
}

/// Whether a word other than G has its place in a definition. `thread`: its block is one of G34 or G35.
fn has_place(word: Written, definition: &Definition, thread: bool) -> bool {
    let of_thread = definition.purpose == Purpose::Thread;
    match word {
        Written::M(code) => of_thread && code == 27,
        Written::Word(Address::Letter(b'C')) => of_thread && thread,
        Written::Word(Address::Letter(letter)) => letter != b'T' && letter != b'W',
        Written::Word(Address::Extended(name)) => !["SA", "SB", "QA"].contains(&name),
        Written::G(_) | Written::MajorArc => true,
    }
}

/// The motion mode of a block.
fn motion_of(words: &Words, state: &State) -> u16 {
    let own = words.g.iter().copied().find(|code| g_code(*code) == GCode::Modelled(GGroup::Motion));
    own.unwrap_or_else(|| state.modes.get(GGroup::Motion))
}
