//! Which words the functions of a block take.

use super::words::Words;
use crate::cycle::{self, CycleBlock};
use crate::fault::{Fault, Outcome};
use crate::state::{Modes, State};
use crate::syntax::Address;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// E100L-ADDR-01: a word that no function of the block takes. `imaginary`: it may have the point of I and K.
pub fn every_word_has_a_function(
    words: &Words,
    one_shot: Option<u16>,
    motion: u16,
    imaginary: bool,
    block: Option<CycleBlock>,
    converts: bool,
    state: &State,
) -> Outcome<()> {
    let of_cycle = cycle::words_taken(words, one_shot, block, converts, state);
    let (letters, extended, calrg): (&[u8], &[&str], bool) = match (one_shot, motion) {
        _ if let Some((letters, extended)) = of_cycle => (letters, extended, false),
        (Some(4 | 28), _) => (b"", &[], false),
        (Some(22), _) => (b"ZWDL", &["PZ", "PW"], false),
        (Some(29), _) => (b"", &["PZ", "PW"], false),
        (Some(50), _) => (b"XZCW", &[], false),
        (Some(71), _) => (b"XZIABDUHLEJQ", &[], false),
        (Some(72), _) => (b"XZKABDWHLEJQ", &[], false),
        (Some(136 | 137), _) => (b"C", &[], false),
        (Some(81..=83), _) => (b"", &[], false),
        (Some(_), _) => (b"XZAL", &[], false),
        // E100L-CSC-02, E100L-CSC-05.
        (None, Modes::NO_CODE) => (b"", &[], false),
        (None, 0 | 1) if converts => (b"XYZW", &[], false),
        (None, 101) => (if converts { b"XYZ" } else { b"XZC" }, &[], false),
        (None, 102 | 103) => (if converts { b"XYL" } else { b"XCL" }, &[], false),
        (None, 132 | 133) => (b"XZCL", &[], false),
        // E100L-NRC-23, E100L-NRC-69: the imaginary point.
        (None, 0 | 1) if imaginary => (b"XZCWAIK", &["QA"], false),
        (None, 0 | 1) => (b"XZCWA", &["QA"], false),
        (None, 31..=33) => (b"XZIAKELJC", &[], false),
        (None, 34 | 35) => (b"XZAEJC", &[], false),
        (None, _) => (b"XZIKL", &[], true),
    };
    for other in &words.others {
        if state.lap.definition.is_some() && other.address == Some(Address::Letter(b'E')) {
            // E100L-LAP-07.
            continue;
        }
        let taken = match other.address {
            None => calrg,
            Some(Address::Letter(letter)) => b"PST".contains(&letter) || letters.contains(&letter),
            Some(Address::Extended(name)) => ["SA", "SB"].contains(&name) || extended.contains(&name),
        };
        if !taken {
            let label = other.address.map(|address| address.label());
            let detail = label.as_ref().map_or("CALRG", |label| label.as_str());
            let fault = Fault::about(AlarmName::WordWithoutFunction, ADDR_01, detail);
            return Err(fault.at(other.span.clone()));
        }
    }
    Ok(())
}
