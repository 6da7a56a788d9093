//! What a block is in the mode of the cycles of driven tools (E100L-MCYC-01, E100L-MCYC-02, E100L-MCYC-09), and which
//! codes are which.

use crate::controls::e100l::g_codes::GGroup;
use crate::modal::Words;
use crate::state::Modes;
use crate::vocabulary::{G184Tapping, Setup};

/// The code that ends the mode.
pub const CANCEL: u16 = 180;

/// A block of the mode, or the one that ends it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CycleBlock {
    /// The cycle code in force, of G180 the one that it ends.
    pub code: u16,
    /// What it does.
    pub role: Role,
}

/// What a block does in the mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// It begins it.
    First,
    /// It goes on in it.
    FollowUp,
    /// It ends it.
    Cancel,
}

impl CycleBlock {
    /// A block with these words, with the modes before and after its own G codes; none outside the mode, and without a word.
    pub fn of(words: &Words, before: Modes, after: Modes) -> Option<Self> {
        let (was, is) = (before.get(GGroup::Cycle), after.get(GGroup::Cycle));
        let (code, role) = match (was, is) {
            _ if words.is_empty() => return None,
            (CANCEL, CANCEL) => return None,
            (was, CANCEL) => (was, Role::Cancel),
            (CANCEL, is) => (is, Role::First),
            (_, is) => (is, Role::FollowUp),
        };
        Some(Self { code, role })
    }

    /// E100L-MCYC-09: whether it machines; a follow-up block without these words changes what is kept.
    pub fn machines(self, words: &Words) -> bool {
        match self.role {
            Role::First => true,
            // E100L-CSC-09: Y is a word of coordinate conversion alone.
            Role::FollowUp => words.has_any("XYZCRQ"),
            Role::Cancel => false,
        }
    }
}

/// Whether a cycle cuts a thread with the C axis, G185 to G188.
pub fn is_thread(code: u16) -> bool {
    matches!(code, 185..=188)
}

/// Whether the pieces of a thread follow each other, G187 and G188.
pub fn is_chain(code: u16) -> bool {
    matches!(code, 187 | 188)
}

/// Whether the driven tool and the feed turn together (E100L-STAP-01, E100L-G184-02).
pub fn is_synchronised(code: u16, setup: &Setup) -> bool {
    matches!(code, 178 | 179) || code == 184 && setup.parameters.g184_tapping == G184Tapping::Synchronised
}

/// Whether a one-shot code cuts grooves, G73 and G74.
pub fn is_groove(one_shot: Option<u16>) -> bool {
    matches!(one_shot, Some(73 | 74))
}

/// Whether a one-shot code taps, G77 and G78.
pub fn is_tapping(one_shot: Option<u16>) -> bool {
    matches!(one_shot, Some(77 | 78))
}

/// The words of a block as they count in its cycle: D of a synchronised one is an angle (E100L-STAP-01), no length in
/// inches.
pub fn synchronised_words(words: Words, block: Option<CycleBlock>, setup: &Setup) -> Words {
    let synchronised = block.is_some_and(|block| is_synchronised(block.code, setup));
    let inch = words.inch && (!synchronised || words.has_any("XYZRIK"));
    Words { inch, ..words }
}
