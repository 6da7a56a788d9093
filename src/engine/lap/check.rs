//! What is checked of the blocks of LAP before they are carried out (execution of LAP, 1 and 3).

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::Interpreter;
use crate::engine::codes::GGroup;
use crate::engine::fault::Fault;
use crate::engine::number::Number;
use crate::engine::words::{Address, Item, Parsed, Words};

use super::{Code, malformed, unspecified};

const CHANGES: u64 = Address::set(&[
    Address::XA,
    Address::XB,
    Address::ZA,
    Address::ZB,
    Address::DA,
    Address::DB,
    Address::FA,
    Address::FB,
]);

/// The place of the value of a feed of LAP in its block.
fn place_of(address: Address) -> usize {
    match address {
        Address::E => 0,
        Address::FA => 1,
        _ => 2,
    }
}

/// Whether a feed is zero or negative.
fn is_no_feed(number: Number) -> bool {
    number.compare(1, 0) != Ordering::Greater
}

#[cold]
fn data(rule: RuleId, detail: &str) -> Fault {
    Fault::about(AlarmName::LapData, rule, Label::new(detail))
}

impl Interpreter<'_> {
    /// The block about to be evaluated calls a contour.
    #[cold]
    pub(in crate::engine) fn begin_call(&mut self, words: &mut Words) {
        words.calls_contour = true;
        self.index_present();
    }

    /// Tests a code G80 to G88 when it is met.
    #[cold]
    pub(in crate::engine) fn check_lap_code(&self, words: &Words, code: u16) -> Result<(), Fault> {
        let detail = Label::of_code(b'G', code);
        let level = self.setup.options.lap;
        if level == 0 || level < 4 && code == 83 {
            return Err(Fault::about(AlarmName::LapLevel, LAP_22, detail));
        }
        let is_head = words.calls_contour && words.g_codes().is_empty();
        if matches!(code, 85..=88) && !is_head {
            return Err(Fault::about(AlarmName::StatementMisplaced, LAP_09, detail));
        }
        Ok(())
    }

    /// Keeps the value of E, FA or FB where it is a feed; whether it is one.
    pub(in crate::engine) fn is_contour_feed(
        &self,
        words: &mut Words,
        address: Address,
        number: Number,
    ) -> bool {
        let cuts_thread = || self.lap.definition().is_none_or(|definition| definition.cuts_thread());
        if address == Address::E && cuts_thread() {
            return false;
        }
        if let Some(slot) = words.contour_feeds.get_mut(place_of(address)) {
            *slot = number;
        }
        true
    }

    /// Check 1 of G81, G82 and G83.
    pub(in crate::engine) fn check_alone_in_lap(&self, parsed: &Parsed, code: Code) -> Result<(), Fault> {
        let rule = if code == Code::Blank { LAP_02 } else { LAP_01 };
        if code.begins_definition() && parsed.items.len() > 1 {
            return Fault::raise(AlarmName::NotAlone, rule);
        }
        Ok(())
    }

    /// Check 2 of a call.
    pub(in crate::engine) fn check_speed_in_lap(&self, words: &Words, code: Code) -> Result<(), Fault> {
        let constant =
            words.code_of(GGroup::CuttingSpeed).map_or(self.state.constant_speed, |code| code == 96);
        if constant && code == Code::Thread {
            return Err(Fault::about(AlarmName::ThreadInConstantSpeed, THRD_01, code.label()));
        }
        Ok(())
    }

    /// Check 3 of a block with G80, and of a block of a contour.
    #[cold]
    pub(in crate::engine) fn check_contour_block(&self, words: &Words) -> Result<(), Fault> {
        let Some(definition) = self.lap.definition() else {
            return match words.has_g(80) {
                true => Err(malformed(LAP_01, const { Label::new("G80") })),
                false => Ok(()),
            };
        };
        let [feed, ..] = words.contour_feeds;
        if words.has(Address::E) && !definition.cuts_thread() && is_no_feed(feed) {
            return Err(data(LAP_07, "E"));
        }
        Ok(())
    }

    /// Check 3 of a call.
    pub(in crate::engine) fn check_call(
        &self,
        parsed: &Parsed,
        words: &Words,
        code: Code,
        left_over: bool,
    ) -> Result<(), Fault> {
        if code.begins_definition() {
            return Ok(());
        }
        if words.code_of(GGroup::Compensation).unwrap_or(self.state.compensation) != 40 {
            return Err(Fault::about(AlarmName::CompensationNotAllowed, LAP_15, code.label()));
        }
        if left_over {
            return Err(unspecified(LAP_15, code.label()));
        }
        if self.task.modes_to_call() > 0 {
            return Err(unspecified(LAP_09, const { Label::new("MODIN") }));
        }
        if self.block_named(parsed.contour).is_none() {
            return Err(Fault::about(AlarmName::SequenceNameUnknown, LAP_09, parsed.contour));
        }
        match code {
            Code::Turn => check_cut(words, LAPC_01).and_then(|()| check_changes(words)),
            Code::Copy => check_cut(words, LAPC_05),
            Code::Thread => self.check_call_of_thread(words),
            _ => Ok(()),
        }
    }

    fn check_call_of_thread(&self, words: &Words) -> Result<(), Fault> {
        let (Some(depth), Some(height)) = (words.get(Address::D), words.get(Address::H)) else {
            return Fault::raise(AlarmName::WordMissing, LAPC_07);
        };
        let word = |address| words.get(address).unwrap_or_default();
        let (u, w) = (word(Address::U), word(Address::W));
        let halves = self.state.thread.halves_after(words.m_codes());
        let impossible = match () {
            () if depth == 0 => "D",
            () if height == 0 => "H",
            () if !(0..180_000_000).contains(&word(Address::B)) => "B",
            () if u >= height => "U",
            () if w >= height => "W",
            () if halves && height - u.max(w) < depth => "M73",
            () => return Ok(()),
        };
        Err(data(LAPC_07, impossible))
    }

    /// Check 5 of a call: every word needs a function.
    pub(in crate::engine) fn check_words_of_call(
        &self,
        parsed: &Parsed,
        words: &Words,
        code: Code,
    ) -> Result<(), Fault> {
        if code.begins_definition() {
            return Ok(());
        }
        let (mut g, mut m) = (words.g_codes().iter(), words.m_codes().iter());
        for item in &parsed.items {
            let Some(address) = item.address() else { continue };
            let (taken, detail) = match (address, item) {
                (Address::G, _) => {
                    let of = g.next().copied().unwrap_or_default();
                    let taken = Code::of(of) == Some(code) || of == 84 && code == Code::Turn;
                    (taken, Label::of_code(b'G', of))
                }
                (Address::M, _) => {
                    let of = m.next().copied().unwrap_or_default();
                    (takes_m(code, of), Label::of_code(b'M', of))
                }
                _ => (address.bit() & takes(code, words) != 0, Label::new(address.text())),
            };
            if !taken {
                let of_call = matches!(item, Item::Word(..)) && address.bit() & FORBIDDEN != 0;
                let rule = if of_call { LAP_17 } else { ADDR_01 };
                return Err(Fault::about(AlarmName::WordWithoutFunction, rule, detail));
            }
        }
        Ok(())
    }

    /// G84 belongs to G85.
    pub(in crate::engine) fn check_change_points(
        &self,
        words: &Words,
        code: Option<Code>,
    ) -> Result<(), Fault> {
        if words.has_g(84) && code != Some(Code::Turn) {
            let detail = const { Label::new("G84") };
            return Err(Fault::about(AlarmName::WordWithoutFunction, LAPC_02, detail));
        }
        Ok(())
    }
}

/// The words that the manual asks not to designate in a call (E100L-LAP-17).
const FORBIDDEN: u64 =
    Address::set(&[Address::S, Address::T, Address::M, Address::G, Address::SB, Address::SA]);

/// The words that a call takes.
fn takes(code: Code, words: &Words) -> u64 {
    const ALLOWANCES: u64 = Address::set(&[Address::U, Address::W, Address::P]);
    const CUT: u64 = ALLOWANCES | Address::set(&[Address::D, Address::F]);
    const THREAD: u64 = ALLOWANCES | Address::set(&[Address::D, Address::H, Address::B]);
    match code {
        Code::Turn if words.has_g(84) => CUT | CHANGES,
        Code::Turn | Code::Copy => CUT,
        Code::Thread => THREAD,
        _ => ALLOWANCES,
    }
}

/// Whether a call takes an M code.
fn takes_m(call: Code, code: u16) -> bool {
    match call {
        Code::Turn | Code::Copy => code == 85,
        Code::Thread => matches!(code, 32..=34 | 73..=75),
        _ => false,
    }
}

/// Depth and feed of G85 and G86.
fn check_cut(words: &Words, rule: RuleId) -> Result<(), Fault> {
    match words.get(Address::D) {
        None => Fault::raise(AlarmName::WordMissing, rule),
        Some(0) => Err(data(rule, "D")),
        _ if words.has(Address::F) && is_no_feed(words.feed) => Err(data(rule, "F")),
        _ => Ok(()),
    }
}

/// The words of G84.
fn check_changes(words: &Words) -> Result<(), Fault> {
    if !words.has_g(84) {
        return Ok(());
    }
    let impossible = |address: &&Address| match address {
        Address::DA | Address::DB => words.get(**address) == Some(0),
        Address::FA | Address::FB => {
            words.contour_feeds.get(place_of(**address)).is_some_and(|number| is_no_feed(*number))
        }
        _ => false,
    };
    match words.order().iter().find(impossible) {
        Some(address) => Err(data(LAPC_02, address.text())),
        None => Ok(()),
    }
}
