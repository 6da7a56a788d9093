//! What the cycles of driven tools keep from one block to the next (E100L-MCYC-09, E100L-MCYC-13, E100L-MCYC-21).

use super::block::{CycleBlock, Role, is_synchronised};
use super::data;
use crate::frame::Amounts;
use crate::modal::{Plan, Words};
use crate::vocabulary::Setup;

/// What goes on in the next block.
#[derive(Clone, Default, Debug)]
pub struct Kept {
    /// The mode, once its first block machines.
    pub mode: Option<Mode>,
    /// Whether a block with Q allows nothing but G180 (E100L-MCYC-21).
    pub spent: bool,
    /// Whether G180 has just ended a mode (E100L-MCYC-13).
    pub after_cancel: bool,
    /// At which angle of the driven tool taps begin, in micro-degrees (E100L-STAP-01).
    pub start_angle: i64,
}

/// A mode.
#[derive(Clone, Copy, Debug)]
pub struct Mode {
    /// The cycle start in machine coordinates.
    pub start: Amounts,
    /// The direction of the cut along its axis; 0 before it is known.
    pub direction: i64,
    /// The program C of the last C word, of the first block without one (E100L-CTHR-02).
    pub c: i64,
    /// The words.
    pub words: KeptWords,
}

/// Words that stay, as program coordinates and amounts in nanometres.
#[derive(Clone, Copy, Default, Debug)]
pub struct KeptWords {
    /// X.
    pub x: Option<i64>,
    /// Z.
    pub z: Option<i64>,
    /// I.
    pub i: Option<i64>,
    /// K.
    pub k: Option<i64>,
    /// D, an amount.
    pub d: Option<i64>,
    /// L.
    pub l: Option<i64>,
    /// U.
    pub u: Option<i64>,
    /// W.
    pub w: Option<i64>,
    /// R.
    pub r: Option<i64>,
    /// E: microseconds, in G190 picometres per minute.
    pub e: Option<i64>,
}

impl Kept {
    /// A block begins that has passed its checks.
    pub fn begin_block(&mut self, plan: &Plan) {
        if !plan.words.is_empty() && !plan.words.has_g(136) {
            self.after_cancel = plan.cycle.is_some_and(|block| block.role == Role::Cancel);
        }
    }

    /// The words of a block replace what is kept, and Q allows nothing but G180; the mode then. `present`: where the
    /// machine stands, `c`: its program C.
    pub fn keep(
        &mut self,
        words: &Words,
        block: CycleBlock,
        present: Amounts,
        c: i64,
        setup: &Setup,
    ) -> Mode {
        let new = Mode { start: present, direction: 0, c, words: KeptWords::default() };
        let mode = self.mode.get_or_insert(new);
        mode.c = words.get('C').unwrap_or(mode.c);
        if is_synchronised(block.code, setup) {
            self.start_angle = data::start_angle(words, setup).unwrap_or(self.start_angle);
            mode.words.replace(words, None);
        } else {
            mode.words.replace(words, words.get('D'));
        }
        mode.words.e = data::e_of(words, block.code, setup).or(mode.words.e);
        self.spent |= words.get('Q').is_some();
        *mode
    }
}

impl KeptWords {
    fn replace(&mut self, words: &Words, d: Option<i64>) {
        let own = |letter, kept: Option<i64>| words.get(letter).or(kept);
        *self = Self {
            x: own('X', self.x),
            z: own('Z', self.z),
            i: own('I', self.i),
            k: own('K', self.k),
            d: d.or(self.d),
            l: own('L', self.l),
            u: own('U', self.u),
            w: own('W', self.w),
            r: own('R', self.r),
            e: self.e,
        };
        // E100L-MCYC-22: depth and bottom replace each other.
        let bottom = if self.i.is_some() { 'X' } else { 'Z' };
        if words.get(bottom).is_some() {
            self.r = None;
        }
    }
}
