//! Definitions that the run meets in its order, and blanks before a contour that G87 carries out (execution of LAP, 4
//! and 6; E100L-LAP-10, E100L-LAP-02).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Label, Place};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::slot::Slot;
use crate::engine::task::Turn;
use crate::engine::words::Parsed;

use super::admit::plain_code;
use super::{Progress, malformed};

/// The codes of a block that are written as plain numbers.
pub fn codes(parsed: &Parsed) -> impl Iterator<Item = u16> + '_ {
    parsed.items.iter().filter_map(plain_code)
}

impl Interpreter<'_> {
    /// The block in progress begins a definition, which is passed over.
    pub(super) fn begin_to_pass_over(&mut self) {
        self.lap.progress = Progress::PassedOver(self.place);
    }

    /// The next block of a definition that is passed over, which begins at a place.
    pub(super) fn pass_block(&mut self, slot: &mut Slot, begin: Place) -> Result<(), Fault> {
        let found = self.read(slot, Turn::Within);
        self.place = slot.place;
        if !found? {
            self.place = begin;
            return Err(malformed(LAP_10, const { Label::new("end") }));
        }
        self.note_block(slot);
        if codes(&slot.parsed).any(|code| code == 80) {
            self.lap.progress = Progress::None;
        }
        Ok(())
    }

    /// Passes over a blank, up to the block with which its contour begins.
    pub(super) fn pass_blank(&mut self, slot: &mut Slot) -> Result<(), Fault> {
        let call = self.place;
        loop {
            let found = self.read(slot, Turn::Within);
            self.place = slot.place;
            let end = if found? {
                self.note_block(slot);
                codes(&slot.parsed).find(|code| matches!(code, 80..=82))
            } else {
                Some(80)
            };
            match end {
                None => {}
                Some(80) => {
                    self.place = call;
                    return Err(malformed(LAP_02, const { Label::new("blank") }));
                }
                Some(_) => {
                    self.place = call;
                    return Ok(());
                }
            }
        }
    }
}
