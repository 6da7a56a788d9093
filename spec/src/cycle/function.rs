//! Which words a block of the cycles takes (E100L-ADDR-01, E100L-G183-03).

use super::block::{CycleBlock, Role, is_synchronised};
use crate::modal::Words;
use crate::state::State;

/// Check 5: the letters and the extended addresses that a block takes; none for blocks that are no matter of the cycles.
pub fn words_taken(
    words: &Words,
    one_shot: Option<u16>,
    block: Option<CycleBlock>,
    converts: bool,
    state: &State,
) -> Option<(&'static [u8], &'static [&'static str])> {
    match one_shot {
        Some(73 | 74) => return Some((b"XZIKDLE", &["DA"])),
        Some(77 | 78) => return Some((b"XZK", &[])),
        _ => {}
    }
    let block = block.filter(|block| block.role != Role::Cancel)?;
    let letters: &[u8] = match block.code {
        // E100L-CSC-09.
        code if converts && is_synchronised(code, state.setup) => b"XYZRKDJQ",
        183 if converts => b"XYZRKDLEQ",
        _ if converts => b"XYZRKEQ",
        code if is_synchronised(code, state.setup) => b"XZCRIKDJQ",
        183 => b"XZCRIKDLEQ",
        185..=188 => b"XZCIK",
        190 if is_on_side(words, state) => b"XZCIDUEQ",
        190 => b"XZCKDWEQ",
        _ => b"XZCRIKEQ",
    };
    Some((letters, &[]))
}

/// E100L-MCYC-04: I says that X is the direction of the cut; the first block of a mode does.
pub fn is_on_side(words: &Words, state: &State) -> bool {
    match &state.cycle.mode {
        Some(mode) => mode.words.i.is_some(),
        None => words.get('I').is_some(),
    }
}
