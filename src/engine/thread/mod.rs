//! Thread cutting, G31 to G35, G71 and G72 (execution of threads): what it remembers from block to block, and which
//! words belong to it.

mod axis;
mod check;
mod compound;
mod cut;
mod depths;
mod exit;
mod infeed;
mod lead;
mod leg;
mod motion;
mod pass;
mod single;

use turnspec_oracle::vocabulary::{AlarmName, Label, LeadAxis, RuleId, Sink};

use super::Interpreter;
use super::block::{OneShot, Plan};
use super::fault::Fault;
use super::planted::{self, Bug};
use super::slot::Slot;
use super::words::{Address, Words};
use axis::Axes;
pub use depths::{Depth, Depths, Heights};
use infeed::{Infeed, Pattern};
pub use motion::Cited;
use single::Cycle;

/// Whether a motion mode cuts threads.
pub fn is_mode(motion: u16) -> bool {
    matches!(motion, 31..=35)
}

/// Whether a motion mode is that of legs.
pub fn is_leg_mode(motion: u16) -> bool {
    matches!(motion, 34 | 35)
}

/// Whether a motion mode is that of single passes.
fn is_pass_mode(motion: u16) -> bool {
    matches!(motion, 31..=33)
}

const PASS_TAKES: u64 = Address::set(&[
    Address::X,
    Address::Z,
    Address::I,
    Address::K,
    Address::A,
    Address::E,
    Address::L,
    Address::J,
    Address::C,
]);
const LEG_TAKES: u64 =
    Address::set(&[Address::X, Address::Z, Address::A, Address::E, Address::J, Address::C]);
/// The words that a block in a leg mode may have besides those of lines when it is read ahead.
pub const LEG_WORDS: u64 = Address::set(&[Address::E, Address::J, Address::C]);
const COMPOUND_TAKES: u64 = Address::set(&[
    Address::X,
    Address::Z,
    Address::A,
    Address::B,
    Address::D,
    Address::H,
    Address::L,
    Address::E,
    Address::J,
    Address::Q,
]);

/// The words, other than those of the axes, that make a thread block of a block in a thread mode.
pub const WORDS: u64 = PASS_TAKES;
/// The words that G71 takes.
pub const ALONG_TAKES: u64 = COMPOUND_TAKES | Address::set(&[Address::I, Address::U]);
/// The words that G72 takes.
pub const ACROSS_TAKES: u64 = COMPOUND_TAKES | Address::set(&[Address::K, Address::W]);

/// The words that a block in a thread mode takes.
pub fn takes(motion: u16) -> u64 {
    if is_pass_mode(motion) { PASS_TAKES } else { LEG_TAKES }
}

/// What thread cutting remembers.
#[derive(Clone, Copy, Debug)]
pub struct Kept {
    /// J, by which the stored F is divided.
    divisor: i64,
    /// The cycle of G31, G32 or G33 in progress.
    cycle: Option<Cycle>,
    /// Whether the next leg goes on from one before.
    chain: bool,
    /// M23.
    chamfer: bool,
    infeed: Infeed,
    pattern: Pattern,
    /// M194.
    phase_matching: bool,
}

impl Default for Kept {
    fn default() -> Self {
        Self {
            divisor: 1,
            cycle: None,
            chain: false,
            chamfer: false,
            infeed: Infeed::Left,
            pattern: Pattern::Halving,
            phase_matching: false,
        }
    }
}

impl Kept {
    /// A code of the motion group is carried out: it ends the cycle, and the chain unless it goes on with it.
    #[inline]
    pub fn select_motion(&mut self, code: u16) {
        let stays = planted::is(Bug::SameCodeGoesOn) && matches!(code, 31..=33);
        self.cycle = self.cycle.filter(|_| stays);
        self.chain &= is_leg_mode(code);
    }

    /// J.
    pub fn divisor(&self) -> i64 {
        self.divisor
    }

    /// A block that moves between the legs ends their chain (E100L-G34-05).
    pub fn end_chain(&mut self) {
        self.chain = false;
    }

    /// An M code that thread cutting looks at.
    pub fn switch(&mut self, code: u16) {
        match code {
            22 | 23 => self.chamfer = code == 23,
            193 | 194 => self.phase_matching = code == 194,
            _ => {
                self.infeed = Infeed::of(code).unwrap_or(self.infeed);
                self.pattern = Pattern::of(code).unwrap_or(self.pattern);
            }
        }
    }

    /// Whether the pattern is that of M73 behind the M codes of a block.
    pub fn halves_after(&self, codes: &[u16]) -> bool {
        let own = codes.iter().find_map(|code| Pattern::of(*code));
        own.unwrap_or(self.pattern) == Pattern::Halving
    }

    /// J belongs to F: an F word sets it to the J word or to 1, a J word alone changes it (E100L-THRD-06).
    #[inline]
    pub fn store_divisor(&mut self, words: &Words, plan: Plan) {
        const WORDS: u64 = Address::set(&[Address::F, Address::J]);
        if words.has_any(WORDS) && plan.one_shot != OneShot::Dwell {
            let without = if planted::is(Bug::DivisorKept) { self.divisor } else { 1 };
            self.divisor = words.get(Address::J).unwrap_or(without);
        }
    }
}

impl Interpreter<'_> {
    /// A block in a thread mode that has a word of the thread.
    pub(super) fn thread(&mut self, slot: &Slot, motion: u16, sink: &mut impl Sink) -> Result<(), Fault> {
        if is_pass_mode(motion) {
            self.thread_pass(&slot.words, motion, sink)
        } else {
            self.thread_leg(slot, motion, sink)
        }
    }

    /// The lead of a thread that begins: it counts from the present point, not from the corner of a chamfer.
    fn begin_thread(&mut self) -> Result<i64, Fault> {
        self.state.base = None;
        self.lead()
    }

    /// The axes of a thread with this lead axis.
    fn thread_axes(&self, lead: LeadAxis) -> Axes {
        Axes { lead, reading: self.setup.readings.feed_length }
    }
}

#[cold]
fn unspecified(rule: RuleId, what: &str) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, Label::new(what))
}

#[cfg(test)]
mod tests;
