//! What a side does beside its blocks: it waits, and it ends (E100L-PSYNC-02, E100L-PSYNC-09, E100L-M100-01,
//! E100L-AX4-05, E100L-AX4-07).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Label, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::block::Plan;
use crate::engine::fault::Fault;
use crate::engine::slot::Slot;
use crate::engine::words::{Address, Words};

use super::common::{CommonWords, is_common_g, is_spindle_m};
use super::end::End;
use super::{Resume, Shared, Standing};

impl Standing {
    /// The P or the code at which a side waits, as events name it.
    pub(super) fn stop_point(self) -> (Option<u16>, Label) {
        match self {
            Self::AtP(p) => (Some(p), Label::default()),
            Self::AtM100 => (None, const { Label::new("M100") }),
            Self::Ready | Self::Ended => (None, Label::default()),
        }
    }
}

impl Interpreter<'_> {
    /// A side has evaluated a block; whether it waits before it.
    #[cold]
    pub(in crate::engine) fn comes_to_block(
        &mut self,
        slot: &Slot,
        sink: &mut impl Sink,
    ) -> Result<bool, Fault> {
        if !slot.parsed.is_only_name() {
            self.record_mut().last_block = self.place;
        }
        if self.record().alone {
            return Ok(false);
        }
        let common = CommonWords::of(&slot.words);
        let Some(p) = slot.words.get(Address::P) else {
            return if common.is_empty() { Ok(false) } else { Fault::raise(AlarmName::SidesDiffer, AX4_07) };
        };
        if self.state.compensation != 40 {
            let detail = const { Label::new("compensation") };
            return Err(Fault::about(AlarmName::Unspecified, PSYNC_09, detail));
        }
        self.record_mut().common = common;
        let p = u16::try_from(p).unwrap_or_default();
        self.wait(Standing::AtP(p), Resume::Checks, const { RuleSet::of(&[PSYNC_02]) }, sink);
        Ok(true)
    }

    /// Whether an M100 waits instead of being an auxiliary function (E100L-M100-06).
    pub(in crate::engine) fn waits_at_m100(&self) -> bool {
        self.saddle.is_some() && !self.record().alone
    }

    /// A block has come to its M100, which is behind its motion; whether the side waits there.
    #[cold]
    pub(in crate::engine) fn comes_to_m100(
        &mut self,
        words: &Words,
        plan: Plan,
        sink: &mut impl Sink,
    ) -> bool {
        let waits = words.has_m(100) && self.waits_at_m100();
        if waits {
            let rules = const { RuleSet::of(&[M100_01]) };
            self.wait(Standing::AtM100, Resume::Conclusion(plan), rules, sink);
        }
        waits
    }

    fn wait(&mut self, standing: Standing, resume: Resume, rules: RuleSet, sink: &mut impl Sink) {
        let record = self.record_mut();
        record.standing = standing;
        record.resume = resume;
        let (p, code) = standing.stop_point();
        self.emit(sink, rules, Action::Wait { p, code });
    }

    /// A side has come to its M02 or M30; there is no reset yet.
    #[cold]
    pub(in crate::engine) fn end_side(&mut self, code: u16, sink: &mut impl Sink) {
        let code = Label::of_code(b'M', code);
        self.saddles.end = Some(End { code, side: self.side(), place: self.place });
        self.emit_side_end(code, sink);
    }

    /// A side has no block left.
    #[cold]
    pub(in crate::engine) fn end_side_without_code(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        self.place = self.record().last_block;
        if self.compensation.acts() {
            self.complete_compensation(sink)?;
        }
        self.emit_side_end(Label::default(), sink);
        Ok(())
    }

    fn emit_side_end(&mut self, code: Label, sink: &mut impl Sink) {
        self.emit(sink, const { RuleSet::of(&[AX4_05]) }, Action::SideEnd { code });
        self.record_mut().standing = Standing::Ended;
        self.saddles.last_ended = Some(self.side());
    }

    /// The rules of what a common word does.
    #[inline]
    pub(in crate::engine) fn common_rules(&self, rules: RuleSet) -> RuleSet {
        if self.saddles.shared == Shared::ForBoth { rules.with(AX4_06) } else { rules }
    }

    /// Whether the other side has carried out the S word of the block in progress.
    #[inline]
    pub(in crate::engine) fn is_speed_done(&self) -> bool {
        self.saddles.shared == Shared::Done
    }

    /// Whether the other side has carried out a G code of the block in progress.
    #[inline]
    pub(in crate::engine) fn is_g_done(&self, code: u16) -> bool {
        self.saddles.shared == Shared::Done && is_common_g(code)
    }

    /// Whether the other side has carried out an M code of the block in progress.
    #[inline]
    pub(in crate::engine) fn is_m_done(&self, code: u16) -> bool {
        self.saddles.shared == Shared::Done && is_spindle_m(code)
    }
}
