//! Thread cutting: what the generator believes of it, and which blocks it writes.
//!
//! A thread begins with blocks that allow it ([`ready`]) and with a positioning. [`single`] writes passes of G31, G32
//! and G33, one or many, in loops too; [`leg`] lengths of G34 and G35, [`open`] those with A alone; [`compound`] whole threads of G71 and G72.
//! [`pass`] foresees where a pass goes and whether the control would refuse it, [`words`] writes what all have in
//! common.

mod compound;
mod leg;
mod open;
mod pass;
mod ready;
mod setup;
mod single;
mod words;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::profile::Profile;
use crate::state::Mode;

pub(crate) use setup::set_up;
use single::Cycle;

/// The codes of thread cutting.
pub(crate) const CODES: &[i64] = &[31, 32, 33, 34, 35, 71, 72];

/// What the generator believes of thread cutting.
#[derive(Clone, Default, Debug)]
pub struct Threads {
    /// The stored F as a lead, in nanometres, where it is known.
    feed: Option<f64>,
    /// The stored J.
    divisor: f64,
    /// Whether M23 is in force.
    chamfer: bool,
    /// The code of the flank that is in force, 0 for the power-on one.
    flank: i64,
    /// The code of the pattern that is in force, 0 for the power-on one.
    pattern: i64,
    /// Whether the main spindle turns, and its S and clamp.
    turning: bool,
    speed: i64,
    clamp: Option<i64>,
    /// The data of the cycle of the present mode.
    cycle: Option<Cycle>,
    /// Whether the present mode has begun a chain of lengths.
    chain: bool,
}

impl Threads {
    /// The stored F as a lead, in nanometres, where it is known.
    pub(crate) fn feed(&self) -> Option<f64> {
        self.feed
    }

    /// Notes an F word.
    pub(crate) fn note_feed(&mut self, per_revolution: bool, amount: f64) {
        self.feed = per_revolution.then_some(amount);
        self.divisor = 1.0;
    }

    /// Forgets the stored F.
    pub(crate) fn forget_feed(&mut self) {
        self.feed = None;
    }

    /// Whether M75 is in force.
    pub(crate) fn is_balanced(&self) -> bool {
        self.pattern == 75
    }

    /// Notes an S word.
    pub(crate) fn note_speed(&mut self, cutting_speed: bool, speed: i64) {
        self.speed = if cutting_speed { 0 } else { speed };
    }

    /// Notes the clamp of G50 S.
    pub(crate) fn note_clamp(&mut self, speed: i64) {
        self.clamp = Some(speed);
    }

    /// Notes an M code.
    pub(crate) fn note_m(&mut self, code: i64) {
        match code {
            3 | 4 => self.turning = true,
            5 | 19 => self.turning = false,
            22 | 23 => self.chamfer = code == 23,
            32..=34 => self.flank = code,
            73..=75 => self.pattern = code,
            _ => {}
        }
    }

    /// Ends the chain.
    pub(crate) fn end_chain(&mut self) {
        self.chain = false;
    }

    /// Forgets what is different where a program runs again.
    pub(crate) fn forget(&mut self) {
        *self = Self { clamp: self.clamp, ..Self::default() };
    }
}

impl Mode {
    /// That of a thread code.
    pub(crate) fn of_thread(code: i64) -> Self {
        match code {
            31 => Self::ThreadAlongToo,
            32 => Self::ThreadAcross,
            34 => Self::GrowingThread,
            35 => Self::ShrinkingThread,
            _ => Self::ThreadAlong,
        }
    }
}

/// Whether a profile has something for threads.
pub(crate) fn is_within(profile: &Profile) -> bool {
    [Feature::Thread, Feature::Feed, Feature::Rapid, Feature::Linear]
        .iter()
        .all(|feature| profile.allows(*feature))
}

/// How often blocks of a thread are drawn anew when the control would refuse them.
const ATTEMPTS: usize = 8;

impl Builder<'_, '_, '_> {
    /// A thread, or a positioning where none can be cut.
    pub(crate) fn thread(&mut self) {
        if !self.ready_for_threads() {
            return self.line(Mode::Rapid);
        }
        match self.choices.below(20) {
            0..=7 => self.passes_of_thread(),
            8..=10 => self.chain_of_threads(),
            _ => self.compound_thread(),
        }
    }

    /// Draws a block again until it can stand, and adds it; false when none can.
    pub(crate) fn attempt(&mut self, write: impl Fn(&mut Self) -> bool) -> bool {
        for _ in 0..ATTEMPTS {
            let (state, lines) = (self.state.clone(), self.lines.len());
            self.begin();
            if write(self) {
                return true;
            }
            self.state = state;
            self.lines.truncate(lines);
        }
        false
    }
}
