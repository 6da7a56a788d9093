//! MODIN modes (E100L-MODIN-01 to -10): programs that are called after each motion.

use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, Place};

/// E100L-MODIN-05: how many modes may be active.
const MOST: usize = 8;

/// A mode that is active.
#[derive(Clone, Copy, Debug)]
pub struct Mode {
    /// The program that it calls.
    pub program: Label,
    /// The block that began it.
    pub place: Place,
    /// The program that began it, by its depth.
    pub began_by: usize,
}

/// The active modes, in the order in which they began; the first one has number 1.
#[derive(Clone, Debug, Default)]
pub struct ModalCalls(Vec<Mode>);

impl ModalCalls {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The modes.
    pub fn all(&self) -> &[Mode] {
        &self.0
    }

    /// The program of a mode.
    pub fn program(&self, number: usize) -> Option<Label> {
        number.checked_sub(1).and_then(|index| self.0.get(index)).map(|mode| mode.program)
    }

    /// Whether a mode is active that this program has begun.
    pub fn began_by(&self, depth: usize) -> bool {
        self.0.iter().any(|mode| mode.began_by == depth)
    }

    /// E100L-MODIN-05: whether one more can begin.
    pub fn check_count(&self) -> Outcome<()> {
        if self.count() >= MOST { fail(AlarmName::ModinDepth, MODIN_05) } else { Ok(()) }
    }

    /// A mode begins.
    pub fn begin(&mut self, mode: Mode) {
        self.0.push(mode);
    }

    /// E100L-MODIN-04: the last mode ends, if this program has begun it; its number.
    pub fn end(&mut self, depth: usize) -> Outcome<usize> {
        let number = self.count();
        if number == 0 {
            return fail(AlarmName::ModoutWithoutModin, MODIN_04);
        }
        if !self.began_by(depth) {
            return Err(Fault::about(AlarmName::Unspecified, MODIN_04, "MODOUT"));
        }
        self.0.pop();
        Ok(number)
    }
}
