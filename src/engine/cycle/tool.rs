//! What a cycle does to the driven tool and to the clamp of the C axis (E100L-MCYC-10).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{RuleSet, Sink, SpindleState};

use crate::engine::Interpreter;

impl Interpreter<'_> {
    /// The driven tool turns or stops, as by M13, M14 and M12.
    pub(super) fn turn_tool(&mut self, state: SpindleState, own: RuleSet, sink: &mut impl Sink) {
        let rules = match state {
            SpindleState::Stop => const { RuleSet::of(&[MCODE_06, MCYC_10]) },
            _ => const { RuleSet::of(&[MCODE_06, MCYC_10, SB_03]) },
        };
        self.state.tool_spindle = state;
        self.emit_tool_spindle(sink, rules.union(own));
    }

    /// M147 and M146: the C axis is clamped and released.
    pub(super) fn clamp(&mut self, clamped: bool, own: RuleSet, sink: &mut impl Sink) {
        const RULES: RuleSet = RuleSet::of(&[MCODE_29, MCYC_10]);
        self.state.c_clamped = clamped;
        self.emit_aux(sink, if clamped { 147 } else { 146 }, RULES.union(own));
    }
}
