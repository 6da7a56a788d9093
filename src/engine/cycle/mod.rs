//! Grooving, drilling and tapping, G73, G74, G77, G78 and G178 to G190 (execution of grooving, drilling and tapping):
//! which blocks belong to them, and which words they take.

mod axis;
mod block_check;
mod bottom;
mod cites;
mod groove;
mod helix;
mod hole;
mod kept;
mod keyway;
mod mode_check;
mod motion;
mod one_shot_check;
mod peck;
mod tap;
mod tool;

pub use cites::mode_rules;
pub use kept::Kept;

use turnspec_oracle::vocabulary::{AlarmName, G184Tapping, Label, RuleId, Sink};

use super::Interpreter;
use super::codes::GGroup;
use super::fault::Fault;
use super::words::{Address, Words};

/// What a block is to a cycle of driven tools (execution of drilling, "Names").
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CycleBlock {
    /// Nothing.
    None,
    /// Its cycle code begins the mode.
    First,
    /// It machines once more.
    Follow,
    /// It changes what is kept.
    Keep,
    /// It ends the mode of a code.
    Cancel(u16),
}

impl CycleBlock {
    /// Whether it is a cycle block.
    #[inline]
    pub fn in_mode(self) -> bool {
        matches!(self, Self::First | Self::Follow | Self::Keep)
    }

    /// Whether it machines.
    fn machines(self) -> bool {
        matches!(self, Self::First | Self::Follow)
    }

    /// Whether it is anything to a cycle.
    #[inline]
    pub fn acts(self) -> bool {
        self != Self::None
    }
}

/// G180.
const NO_CYCLE: u16 = 180;
/// G136, which may stand between G180 and the block that has X and Z (E100L-MCYC-13).
const END_CONVERSION: u16 = 136;

const GROOVE: u64 = Address::set(&[
    Address::X,
    Address::Z,
    Address::I,
    Address::K,
    Address::D,
    Address::L,
    Address::E,
    Address::DA,
]);
const HOLE: u64 =
    Address::set(&[Address::X, Address::Z, Address::C, Address::R, Address::I, Address::K, Address::Q]);
const HELIX: u64 = Address::set(&[Address::X, Address::Z, Address::C, Address::I, Address::K]);
const SLOT: u64 = Address::set(&[Address::X, Address::Z, Address::C, Address::D, Address::E, Address::Q]);

/// The words that G73 and G74 take.
pub const GROOVE_TAKES: u64 = GROOVE;
/// The words that G77 and G78 take.
pub const TAP_TAKES: u64 = Address::set(&[Address::X, Address::Z, Address::K]);
/// The words that make a hole block of a follow-up block.
const MACHINING: u64 =
    Address::set(&[Address::X, Address::Y, Address::Z, Address::C, Address::R, Address::Q]);
/// The words of lengths in a synchronised cycle, where D is an angle.
const TAP_LENGTHS: u64 =
    Address::set(&[Address::X, Address::Y, Address::Z, Address::I, Address::K, Address::R]);

/// The words that a block of a cycle takes (execution of drilling, check 5).
fn takes(code: u16, synchronised: bool, face: bool) -> u64 {
    const DWELL: u64 = HOLE | Address::set(&[Address::E]);
    const DEEP: u64 = DWELL | Address::set(&[Address::D, Address::L]);
    const TAPPED: u64 = HOLE | Address::set(&[Address::D, Address::J]);
    const FACE_SLOT: u64 = SLOT | Address::set(&[Address::K, Address::W]);
    const SIDE_SLOT: u64 = SLOT | Address::set(&[Address::I, Address::U]);
    match code {
        _ if synchronised => TAPPED,
        183 => DEEP,
        185..=188 => HELIX,
        190 if face => FACE_SLOT,
        190 => SIDE_SLOT,
        _ => DWELL,
    }
}

/// The words that a hole takes in conversion mode, of those that it takes out of it (E100L-CSC-09).
fn converted(takes: u64) -> u64 {
    takes & !Address::set(&[Address::C, Address::I]) | Address::Y.bit()
}

/// Whether a cycle cuts a thread with the C axis.
fn is_helix(code: u16) -> bool {
    matches!(code, 185..=188)
}

/// Whether a cycle chains its threads.
fn is_chain(code: u16) -> bool {
    matches!(code, 187 | 188)
}

impl Interpreter<'_> {
    /// Whether a cycle taps with feed and tool turning together (E100L-G184-02).
    fn is_synchronised(&self, code: u16) -> bool {
        let floating = self.setup.parameters.g184_tapping == G184Tapping::Floating;
        matches!(code, 178 | 179) || code == 184 && !floating
    }

    /// The cycle code that is in force after the words of a block.
    fn cycle_of(&self, words: &Words) -> u16 {
        words.code_of(GGroup::Cycle).unwrap_or(self.state.cycle.code)
    }

    /// Step 7 of a block that is something to a cycle.
    pub(in crate::engine) fn carry_out_cycle(
        &mut self,
        words: &Words,
        block: CycleBlock,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        match block {
            CycleBlock::None => Ok(()),
            CycleBlock::Cancel(code) => self.cancel_cycle(words, code, sink),
            CycleBlock::Keep => {
                self.keep_words(words);
                Ok(())
            }
            CycleBlock::First => self.machine(words, true, sink),
            CycleBlock::Follow => self.machine(words, false, sink),
        }
    }
}

#[cold]
fn unspecified(rule: RuleId, what: &str) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, Label::new(what))
}

#[cfg(test)]
mod tests;
