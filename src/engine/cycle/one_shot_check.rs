//! What is checked of G73, G74, G77 and G78 before their block is carried out, and compensation in all cycles
//! (execution of drilling, 3).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label};

use crate::engine::Interpreter;
use crate::engine::arithmetic::tool::ToolWord;
use crate::engine::block::OneShot;
use crate::engine::codes::GGroup;
use crate::engine::fault::Fault;
use crate::engine::words::{Address, Words};

use super::axis::Axis;
use super::unspecified;

impl Interpreter<'_> {
    /// Check 3 of G73 and G74.
    pub(in crate::engine) fn check_groove(&self, words: &Words, one_shot: OneShot) -> Result<(), Fault> {
        let (axis, own) = match one_shot {
            OneShot::GrooveAcross => (Axis::X, GRV_01),
            _ => (Axis::Z, GRV_02),
        };
        if !words.has(axis.word()) {
            return Fault::raise(AlarmName::WordMissing, own);
        }
        let negative = |address| words.get(address).unwrap_or_default() < 0;
        let of_axis = |address| if axis.amount() == address { GRV_03 } else { GRV_06 };
        match words.get(Address::D) {
            None => return Fault::raise(AlarmName::WordMissing, GRV_10),
            Some(0) => return Err(unspecified(GRV_10, "D")),
            Some(_) => {}
        }
        for address in [Address::I, Address::K] {
            if negative(address) {
                return Err(unspecified(of_axis(address), address.text()));
            }
        }
        for (address, rule) in [(Address::L, GRV_05), (Address::DA, GRV_04)] {
            if negative(address) {
                return Fault::raise(AlarmName::AddressRange, rule);
            }
        }
        if words.get(Address::L) == Some(0) {
            return Err(unspecified(GRV_05, "L"));
        }
        if let Some(tool) = words.get(Address::T) {
            let incremental =
                words.code_of(GGroup::Dimension).map_or(self.state.incremental, |code| code == 91);
            let number = ToolWord::new(tool).tool;
            let other = number != 0 && number != self.state.tool;
            if incremental || !words.has(axis.other().word()) || other {
                return Err(unspecified(GRV_08, "T"));
            }
        }
        self.check_dwell(words)
    }

    /// Check 3 of G77 and G78.
    pub(in crate::engine) fn check_tap(&self, words: &Words) -> Result<(), Fault> {
        if words.present() & super::TAP_TAKES != super::TAP_TAKES {
            return Fault::raise(AlarmName::WordMissing, TAP_01);
        }
        if words.get(Address::K).is_some_and(|amount| amount < 0) {
            return Err(unspecified(TAP_01, "K"));
        }
        if words.code_of(GGroup::CuttingSpeed).map_or(self.state.constant_speed, |code| code == 96) {
            return Err(unspecified(TAP_04, "G96"));
        }
        Ok(())
    }

    /// Check 6 of G73, G74, G77 and G78.
    pub(in crate::engine) fn check_bore_compensation(
        &self,
        words: &Words,
        left_over: bool,
    ) -> Result<(), Fault> {
        self.check_compensation_off(words, words.code_of(GGroup::OneShot).unwrap_or_default(), left_over)
    }

    /// Check 6 of a cycle, by its code.
    pub(super) fn check_compensation_off(
        &self,
        words: &Words,
        code: u16,
        left_over: bool,
    ) -> Result<(), Fault> {
        let before = self.state.compensation != 40;
        let after = words.code_of(GGroup::Compensation).map_or(before, |code| code != 40);
        let detail = || Label::of_code(b'G', code);
        if after {
            return Err(Fault::about(AlarmName::CompensationNotAllowed, NRC_81, detail()));
        }
        if before || left_over {
            return Err(Fault::about(AlarmName::Unspecified, NRC_81, detail()));
        }
        Ok(())
    }
}
