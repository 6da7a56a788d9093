//! What the cycle mode allows: check 1a, of blocks while a cycle code is in force or has just ended (execution of
//! drilling, 3; E100L-MCYC-01, E100L-MCYC-03, E100L-MCYC-13, E100L-MCYC-14, E100L-MCYC-21, E100L-CSC-09).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label};

use crate::engine::Interpreter;
use crate::engine::block::OneShot;
use crate::engine::codes::GGroup;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Address, Item, Parsed, Words};

use super::{CycleBlock, END_CONVERSION, NO_CYCLE, is_helix, unspecified};

impl Interpreter<'_> {
    /// Check 1a, and what the block is to the cycles.
    pub(in crate::engine) fn check_cycle_mode(
        &self,
        parsed: &Parsed,
        words: &Words,
    ) -> Result<CycleBlock, Fault> {
        let kept = &self.state.cycle;
        let block = kept.block(words);
        if words.has_g(NO_CYCLE) || !words.any() {
            return Ok(block);
        }
        if kept.spent {
            return Fault::raise(AlarmName::CycleCancelMissing, MCYC_21);
        }
        let both = words.has(Address::X) && (words.has(Address::Z) || planted::is(Bug::XAloneBehindCancel));
        if kept.after_cancel && !both && !words.has_g(END_CONVERSION) {
            return Fault::raise(AlarmName::WordMissing, MCYC_13);
        }
        if block.in_mode() {
            self.check_words_of_mode(parsed, words, block)?;
        }
        Ok(block)
    }

    /// The last rows of check 1a: in coordinate conversion there are holes of driven tools along Z alone.
    pub(in crate::engine) fn check_cycle_in_conversion(
        &self,
        words: &Words,
        one_shot: OneShot,
        block: CycleBlock,
    ) -> Result<(), Fault> {
        let refuse = |code| Err(Fault::about(AlarmName::Unspecified, CSC_09, Label::of_code(b'G', code)));
        if !block.in_mode() {
            let bores = one_shot.is_groove() || one_shot.is_tap();
            return words.code_of(GGroup::OneShot).filter(|_| bores).map_or(Ok(()), refuse);
        }
        match self.cycle_of(words) {
            code if is_helix(code) || code == 190 => refuse(code),
            _ if words.has(Address::I) => Err(unspecified(CSC_09, "I")),
            _ => Ok(()),
        }
    }

    /// The same, of a cycle block.
    fn check_words_of_mode(&self, parsed: &Parsed, words: &Words, block: CycleBlock) -> Result<(), Fault> {
        let code = self.cycle_of(words);
        let about = |name, rule, code| Err(Fault::about(name, rule, Label::of_code(b'G', code)));
        if block != CycleBlock::First && code != self.state.cycle.code {
            return about(AlarmName::Unspecified, MCYC_01, code);
        }
        if words.code_of(GGroup::Dimension).map_or(self.state.incremental, |code| code == 91) {
            return Fault::raise(AlarmName::CycleIncremental, MCYC_14);
        }
        let other = |other: &&u16| !matches!(**other, 90 | 94 | 95) && **other != code;
        if let Some(other) = words.g_codes().iter().find(other) {
            return about(AlarmName::Unspecified, MCYC_14, *other);
        }
        if let Some(detail) = foreign_word(parsed, words) {
            return Err(Fault::about(AlarmName::CycleWord, MCYC_14, detail));
        }
        let per_minute = words.code_of(GGroup::FeedUnit).map_or(self.state.per_minute, |code| code == 94);
        if block.machines() && !self.is_synchronised(code) && per_minute == is_helix(code) {
            return about(AlarmName::CycleFeedMode, MCYC_03, code);
        }
        Ok(())
    }
}

/// The first S, T or M word that the mode does not allow.
fn foreign_word(parsed: &Parsed, words: &Words) -> Option<Label> {
    let mut codes = words.m_codes().iter().copied();
    parsed.items.iter().filter_map(Item::address).find_map(|address| match address {
        Address::S | Address::T => Some(Label::new(address.text())),
        Address::M => codes
            .next()
            .filter(|code| !matches!(code, 136 | 140 | 141 | 169 | 211..=214))
            .map(|code| Label::of_code(b'M', code)),
        _ => None,
    })
}
