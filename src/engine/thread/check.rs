//! What is checked of a thread before its block is carried out (execution of threads, 3).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, Chamfering, Label};

use crate::engine::Interpreter;
use crate::engine::block::OneShot;
use crate::engine::codes::GGroup;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Address, Words};

use super::{is_mode, is_pass_mode, unspecified};

/// The first word G31 to G35, G71 or G72 of a block.
fn code_of(words: &Words) -> Option<u16> {
    words.g_codes().iter().copied().find(|code| is_mode(*code) || is_compound(*code))
}

fn is_compound(code: u16) -> bool {
    matches!(code, 71 | 72)
}

impl Interpreter<'_> {
    /// Check 2 of a block in a thread mode or with a compound cycle; `cuts` tells whether it cuts a thread.
    pub(in crate::engine) fn check_thread_speed(
        &self,
        words: &Words,
        motion: u16,
        cuts: bool,
    ) -> Result<(), Fault> {
        let constant =
            words.code_of(GGroup::CuttingSpeed).map_or(self.state.constant_speed, |code| code == 96);
        let code = code_of(words);
        let later = cuts && !planted::is(Bug::ConstantSpeedLater);
        if constant && (later || code.is_some()) {
            let detail = Label::of_code(b'G', code.unwrap_or(motion));
            return Err(Fault::about(AlarmName::ThreadInConstantSpeed, rules::THRD_01, detail));
        }
        Ok(())
    }

    /// Check 3 of G71 and G72.
    pub(in crate::engine) fn check_compound_thread(
        &self,
        words: &Words,
        one_shot: OneShot,
    ) -> Result<(), Fault> {
        let along = one_shot == OneShot::ThreadAlong;
        if !(words.has(Address::X) && words.has(Address::Z)) {
            let rule = if along { rules::G71_01 } else { rules::G72_01 };
            return Fault::raise(AlarmName::WordMissing, rule);
        }
        let (Some(depth), Some(height)) = (words.get(Address::D), words.get(Address::H)) else {
            return Fault::raise(AlarmName::WordMissing, rules::G71_09);
        };
        let taper = if along { Address::I } else { Address::K };
        if words.has(Address::A) && words.has(taper) {
            return Fault::raise(AlarmName::AngleOverdetermined, rules::G71_04);
        }
        let allowance_word = if along { Address::U } else { Address::W };
        let negative = |address| words.get(address).unwrap_or_default() < 0;
        if negative(Address::L) || !along && negative(Address::W) {
            return Fault::raise(AlarmName::AddressRange, rules::ADDR_01);
        }
        check_divisor(words)?;
        let allowance = words.get(allowance_word).unwrap_or_default();
        let angle = words.get(Address::B).unwrap_or_default();
        let codes: &[u16] = if planted::is(Bug::PatternStale) { &[] } else { words.m_codes() };
        let halving = self.state.thread.halves_after(codes);
        let impossible = match () {
            () if depth == 0 => "D",
            () if height == 0 => "H",
            () if !(0..180_000_000).contains(&angle) => "B",
            () if allowance >= height => allowance_word.text(),
            () if halving && height - allowance < depth => "M73",
            () => return Ok(()),
        };
        Err(Fault::about(AlarmName::ThreadData, rules::G71_09, Label::new(impossible)))
    }

    /// Check 4 of a thread block.
    pub(in crate::engine) fn check_thread(
        &self,
        words: &Words,
        motion: u16,
        after_angle: bool,
    ) -> Result<(), Fault> {
        if is_pass_mode(motion) {
            self.check_pass(words, motion)?;
        } else {
            self.check_leg(words, after_angle)?;
        }
        check_divisor(words)?;
        if words.get(Address::C).unwrap_or_default() < 0 {
            return Fault::raise(AlarmName::AddressRange, rules::THRD_07);
        }
        Ok(())
    }

    fn check_pass(&self, words: &Words, motion: u16) -> Result<(), Fault> {
        let face = motion == 32;
        let (x, z) = (words.has(Address::X), words.has(Address::Z));
        let first = words.code_of(GGroup::Motion).is_some() || self.state.thread.cycle.is_none();
        if first && !(x && z) {
            let rule = if face { rules::G32_01 } else { rules::G33_01 };
            return Fault::raise(AlarmName::WordMissing, rule);
        }
        if !x && !z {
            let rule = if face { rules::G32_04 } else { rules::G33_03 };
            return Fault::raise(AlarmName::WordMissing, rule);
        }
        let taper = if face { Address::K } else { Address::I };
        if words.has(Address::A) && words.has(taper) {
            return Fault::raise(AlarmName::AngleOverdetermined, rules::G33_06);
        }
        if words.get(Address::L).unwrap_or_default() < 0 {
            return Fault::raise(AlarmName::AddressRange, rules::ADDR_01);
        }
        Ok(())
    }

    fn check_leg(&self, words: &Words, after_angle: bool) -> Result<(), Fault> {
        let (x, z, angle) = (words.has(Address::X), words.has(Address::Z), words.has(Address::A));
        if angle && x && z && !after_angle {
            return Fault::raise(AlarmName::AngleOverdetermined, rules::DTAP_01);
        }
        if angle && !x && !z && self.setup.parameters.chamfering != Chamfering::AnyAngle {
            return Fault::raise(AlarmName::AngleUnderdetermined, rules::DTAP_01);
        }
        if !x && !z && !angle {
            return Fault::raise(AlarmName::WordMissing, rules::G34_01);
        }
        if words.get(Address::E).unwrap_or_default() < 0 {
            return Fault::raise(AlarmName::AddressRange, rules::G34_02);
        }
        Ok(())
    }

    /// Check 6 of a block in a thread mode or with a compound cycle; `cuts` tells whether it cuts a thread.
    pub(in crate::engine) fn check_thread_compensation(
        &self,
        words: &Words,
        motion: u16,
        cuts: bool,
        left_over: bool,
    ) -> Result<(), Fault> {
        let before = self.state.compensation != 40;
        let after = words.code_of(GGroup::Compensation).map_or(before, |code| code != 40);
        if !before && !after && !left_over {
            return Ok(());
        }
        let code = code_of(words).unwrap_or(motion);
        let detail = Label::of_code(b'G', code);
        let undefined = Err(Fault::about(AlarmName::Unspecified, rules::NRC_81, detail));
        let cycle = |code: &u16| is_pass_mode(*code) || is_compound(*code);
        if words.g_codes().iter().any(cycle) || cuts && is_pass_mode(motion) {
            if after {
                return Err(Fault::about(AlarmName::CompensationNotAllowed, rules::NRC_81, detail));
            }
            return if before || left_over && cuts { undefined } else { Ok(()) };
        }
        if cuts { undefined } else { Ok(()) }
    }
}

/// J is a whole number (E100L-THRD-06); one that is not was taken as 0.
fn check_divisor(words: &Words) -> Result<(), Fault> {
    if words.get(Address::J) == Some(0) {
        return Err(unspecified(rules::THRD_06, "J"));
    }
    Ok(())
}
