//! Checks 2a and 4 to 6 of a cycle block (execution of drilling, 3; execution of contours, 3).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label};

use crate::engine::Interpreter;
use crate::engine::block::check_taken;
use crate::engine::fault::Fault;
use crate::engine::words::{Address, Words};

use super::axis::Axis;
use super::helix::lead_axis;
use super::{CycleBlock, converted, is_chain, is_helix, takes, unspecified};

impl Interpreter<'_> {
    /// Checks 2a and 4 to 6 of a cycle block.
    pub(in crate::engine) fn check_cycle_block(
        &self,
        words: &Words,
        block: CycleBlock,
        left_over: bool,
    ) -> Result<(), Fault> {
        self.check_first_point(words)?;
        let code = self.cycle_of(words);
        let is_first = block == CycleBlock::First;
        if is_helix(code) {
            self.check_helix(words, code, is_first)?;
        } else {
            self.check_hole(words, code, is_first)?;
        }
        let face = self.infeed_axis(words, is_first) == Axis::Z;
        let takes = takes(code, self.is_synchronised(code), face);
        check_taken(words, if self.state.contour.converts() { converted(takes) } else { takes })?;
        self.check_compensation_off(words, code, left_over)
    }

    /// The infeed axis of a hole cycle: that of the amount in its first block (E100L-MCYC-04).
    fn infeed_axis(&self, words: &Words, is_first: bool) -> Axis {
        match is_first {
            true if words.has(Address::K) => Axis::Z,
            true => Axis::X,
            false => self.state.cycle.axis,
        }
    }

    fn check_hole(&self, words: &Words, code: u16, is_first: bool) -> Result<(), Fault> {
        self.check_approach(words, is_first)?;
        let axis = self.infeed_axis(words, is_first);
        if code == 190 {
            return self.check_keyway(words, is_first);
        }
        let (bottom, depth) = (words.has(axis.word()), words.has(Address::R));
        if bottom && depth {
            return Fault::raise(AlarmName::CycleDepthOverdetermined, MCYC_23);
        }
        if is_first && !bottom && !depth {
            return Fault::raise(AlarmName::WordMissing, MCYC_22);
        }
        if code == 183 {
            check_deep_hole(words, is_first)?;
        }
        if self.is_synchronised(code) { self.check_tap_in_step(words) } else { self.check_dwell(words) }
    }

    /// I and K of a hole cycle.
    fn check_approach(&self, words: &Words, is_first: bool) -> Result<(), Fault> {
        for address in [Address::I, Address::K] {
            check_not_negative(words, address)?;
        }
        let (side, face) = (words.has(Address::I), words.has(Address::K));
        match (is_first, side, face) {
            (true, true, true) => Err(unspecified(MCYC_04, "I")),
            (true, false, false) => Fault::raise(AlarmName::WordMissing, MCYC_04),
            (true, ..) => Ok(()),
            (false, ..) => {
                let kept = &self.state.cycle;
                let changed = |axis: &Axis| {
                    let word = words.get(axis.amount());
                    word.is_some() && (*axis != kept.axis || word != kept.data.amount(*axis))
                };
                match [Axis::X, Axis::Z].iter().find(|axis| changed(axis)) {
                    Some(axis) => Err(unspecified(MCYC_09, axis.amount().text())),
                    None => Ok(()),
                }
            }
        }
    }

    fn check_keyway(&self, words: &Words, is_first: bool) -> Result<(), Fault> {
        const NEEDED: u64 = Address::set(&[Address::X, Address::Z, Address::D]);
        if is_first && words.present() & NEEDED != NEEDED {
            return Fault::raise(AlarmName::WordMissing, G190_01);
        }
        if words.get(Address::D) == Some(0) {
            return Err(unspecified(G190_01, "D"));
        }
        if words.get(Address::W).is_some_and(|allowance| allowance < 0) {
            return Fault::raise(AlarmName::AddressRange, G190_07);
        }
        let [least, most] = self.units.feeds;
        if words.has(Address::E) && !words.exact_e.within(self.units.feed[0], least, most) {
            return Fault::raise(AlarmName::AddressRange, G190_01);
        }
        Ok(())
    }

    fn check_tap_in_step(&self, words: &Words) -> Result<(), Fault> {
        // A J that is not whole was taken as 0.
        if words.get(Address::J) == Some(0) {
            return Err(unspecified(THRD_06, "J"));
        }
        if words.has(Address::D) && !words.exact_d.within(self.units.angle, 0, 359_999_000) {
            return Fault::raise(AlarmName::AddressRange, STAP_01);
        }
        Ok(())
    }

    /// E as a time.
    pub(super) fn check_dwell(&self, words: &Words) -> Result<(), Fault> {
        if words.has(Address::E) && !words.exact_e.within(self.units.time, 10_000, 9_999_990_000) {
            return Fault::raise(AlarmName::AddressRange, DWELL_02);
        }
        Ok(())
    }

    fn check_helix(&self, words: &Words, code: u16, is_first: bool) -> Result<(), Fault> {
        if is_first && !(words.has(Address::X) && words.has(Address::Z)) {
            return Fault::raise(AlarmName::WordMissing, CTHR_01);
        }
        let approach = lead_axis(code).amount();
        check_not_negative(words, approach)?;
        if is_chain(code) && !is_first {
            let rule = if code == 187 { CTHR_04 } else { CTHR_05 };
            if let Some(word) = [Address::C, approach].iter().find(|word| words.has(**word)) {
                return Err(unspecified(rule, word.text()));
            }
        }
        if !words.has(Address::SA) && self.state.cycle.c_speed.is_none() {
            return Fault::raise(AlarmName::WordMissing, CTHR_01);
        }
        Ok(())
    }
}

/// A negative approach amount.
fn check_not_negative(words: &Words, address: Address) -> Result<(), Fault> {
    if words.get(address).is_some_and(|amount| amount < 0) {
        let detail = Label::new(address.text());
        return Err(Fault::about(AlarmName::CycleApproachNegative, MCYC_05, detail));
    }
    Ok(())
}

/// D and L of G183.
fn check_deep_hole(words: &Words, is_first: bool) -> Result<(), Fault> {
    match (words.get(Address::D), words.get(Address::L)) {
        (None, _) if is_first => Fault::raise(AlarmName::WordMissing, G183_01),
        (Some(0), _) => Err(unspecified(G183_01, "D")),
        (_, Some(..0)) => Fault::raise(AlarmName::AddressRange, G183_02),
        (_, Some(0)) => Err(unspecified(G183_02, "L")),
        _ => Ok(()),
    }
}
