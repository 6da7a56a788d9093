//! T and M words (execution, sections 5 and 8).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Duration, FrameCause, Label, RuleSet, Sink, SpindleState,
};

use super::Interpreter;
use super::arithmetic::tool::ToolWord;
use super::block::{OneShot, Plan};
use super::codes;
use super::fault::Fault;
use super::planted::{self, Bug};
use super::sides::Common;
use super::spindle::answer;
use super::words::Words;

impl Interpreter<'_> {
    /// T: turret, tool offset, nose radius.
    pub(super) fn change_tool(&mut self, word: i64, moves: bool, sink: &mut impl Sink) -> Result<(), Fault> {
        let ToolWord { nose, tool, offset } = ToolWord::new(word);
        let index = tool != 0 && (tool != self.state.tool || planted::is(Bug::AlwaysIndexes));
        let mut rules = const { RuleSet::of(&[TOOL_02]) };
        if moves {
            rules = rules.with(TOOL_04);
        }
        if word <= 99 {
            rules = rules.with(TOOL_05);
        }
        if index {
            rules = rules.with(TOOL_06);
            self.state.tool = tool;
        }
        let before = self.state.active_offset();
        self.state.offset =
            if planted::is(Bug::OffsetOfPreviousTool) && tool == 0 { self.state.offset } else { offset };
        self.state.nose = nose;
        self.emit(sink, rules, Action::Tool { tool, offset, nose, index });
        self.check_time(self.setup.stm.t)?;
        if before != self.state.active_offset() {
            self.emit_word_frame(sink, FrameCause::ToolOffset, const { RuleSet::of(&[TOOL_04]) });
        }
        Ok(())
    }

    /// The time that a function takes, against the limit (E100L-STM-01).
    pub(super) fn check_time(&self, time: Duration) -> Result<(), Fault> {
        let check = &self.setup.stm;
        if check.enabled
            && self.state.check_times
            && (time > check.limit || planted::is(Bug::TimeLimitInclusive) && time == check.limit)
        {
            return Fault::raise(AlarmName::StmOver, STM_01);
        }
        Ok(())
    }

    /// The M codes that come before the motion.
    pub(super) fn m_codes(&mut self, words: &Words, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        self.state.watch.begin_block();
        for &code in words.m_codes() {
            if matches!(code, 0 | 1 | 2 | 30) {
                continue;
            }
            if code == 109 {
                self.check_separation()?;
            }
            let checked = self.state.check_times && code != 124;
            let common = matches!(code, 3 | 4 | 5 | 19 | 40..=44);
            if common && self.common() == Common::Done || code == 100 && !self.is_alone() {
                continue;
            }
            self.m_code(code, words, plan, sink)?;
            let stm = &self.setup.stm;
            if checked && stm.enabled && stm.m > stm.limit {
                return Fault::raise(AlarmName::StmOver, STM_01);
            }
            if code == 109 {
                self.leave_plane(sink);
            }
        }
        Ok(())
    }

    /// M109 leaves the planes of the C axis.
    fn leave_plane(&mut self, sink: &mut impl Sink) {
        if self.state.plane != 18 && !planted::is(Bug::PlaneKept) {
            let previous = std::mem::replace(&mut self.state.plane, 18);
            let group = const { Label::new("plane") };
            self.emit_mode(sink, group, 18, previous, const { RuleSet::of(&[CRC_03]) });
        }
    }

    fn m_code(&mut self, code: u16, words: &Words, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        match code {
            3 | 4 | 5 | 19 => {
                let (state, rules) = match code {
                    3 | 4 => (self.start_main(code)?, const { RuleSet::of(&[MCODE_05, SPD_04]) }),
                    5 => (SpindleState::Stop, const { RuleSet::of(&[MCODE_05]) }),
                    _ => (SpindleState::Orient, const { RuleSet::of(&[MCODE_08]) }),
                };
                self.state.spindle = state;
                let mirrored = self.state.mirror < 0 && matches!(code, 3 | 4);
                let rules = if mirrored { rules.with(MIRR_06) } else { rules };
                let (rules, with_motion) = answer(words, plan, rules);
                self.emit_main_spindle(sink, rules, with_motion, None);
            }
            40..=44 => {
                self.state.gear = code;
                let (rules, with_motion) = answer(words, plan, const { RuleSet::of(&[MCODE_14, SPD_05]) });
                self.emit_main_spindle(sink, rules, with_motion, None);
            }
            12..=14 => self.start_tool(code, sink)?,
            240..=244 => {
                self.state.tool_gear = code;
                self.emit_tool_spindle(sink, const { RuleSet::of(&[MCODE_39, SB_04]) });
            }
            8 | 9 => self.emit(sink, const { RuleSet::of(&[MTAB_01]) }, Action::Coolant { on: code == 8 }),
            203 => {
                let rapid = words.has_g(0);
                if rapid && self.state.last_motion_cut && !self.setup.inputs.turret_clamp_confirmed {
                    return Fault::raise(AlarmName::TurretClamp, TUNC_02);
                }
                self.emit_aux(sink, code, RuleSet::of(&[if rapid { TUNC_01 } else { MTAB_01 }]));
            }
            _ => {
                let state = &mut self.state;
                match code {
                    15 | 16 => state.c_negative = code == 16,
                    20 | 21 | 24 | 25 => state.watch.switch(code),
                    22 | 23 | 32..=34 | 73..=75 | 193 | 194 => state.thread.switch(code),
                    109 | 110 => {
                        state.c_joined = code == 110;
                        if code == 110 {
                            state.contour.unwind();
                        }
                    }
                    124 | 125 => state.check_times = code == 124,
                    146 | 147 => state.c_clamped = code == 147,
                    211..=214 => state.cycle.switch(code),
                    152 | 153 => state.tool_interlock_released = code == 153,
                    _ => {}
                }
                let called = code == 85 && matches!(plan.one_shot, OneShot::Lap(_));
                let rules = codes::m_rules(code);
                self.emit_aux(sink, code, if called { rules.with(LAPC_08) } else { rules });
            }
        }
        Ok(())
    }

    /// The direction in which M03 and M04 let the main spindle turn: the other one with turret B of a saddle
    /// (E100L-MIRR-06, E100L-MIRR-08).
    fn start_main(&mut self, code: u16) -> Result<SpindleState, Fault> {
        let mirrored = self.state.mirror < 0 && !planted::is(Bug::DirectionNotMirrored);
        let clockwise = (code == 3) != mirrored;
        let wanted = if clockwise { SpindleState::Clockwise } else { SpindleState::CounterClockwise };
        let turns = matches!(self.state.spindle, SpindleState::Clockwise | SpindleState::CounterClockwise);
        let of_other = self.state.other_turret.is_some() && self.state.spindle_side != self.state.selected;
        if turns && self.state.spindle != wanted && of_other && !planted::is(Bug::ReversalAllowed) {
            return Fault::raise(AlarmName::TurretChange, MIRR_08);
        }
        self.state.spindle_side = self.state.selected;
        Ok(wanted)
    }

    /// M12, M13 and M14; the tool turns only while the C axis is joined, or released from that.
    fn start_tool(&mut self, code: u16, sink: &mut impl Sink) -> Result<(), Fault> {
        let joined = self.state.c_joined || self.state.tool_interlock_released;
        let (state, rules) = match code {
            12 => (SpindleState::Stop, const { RuleSet::of(&[MCODE_06]) }),
            _ if !joined => return Fault::raise(AlarmName::MToolNotJoined, CAX_04),
            13 => (SpindleState::Clockwise, const { RuleSet::of(&[MCODE_06, SB_03]) }),
            _ => (SpindleState::CounterClockwise, const { RuleSet::of(&[MCODE_06, SB_03]) }),
        };
        self.state.tool_spindle = state;
        self.emit_tool_spindle(sink, rules);
        Ok(())
    }

    pub(super) fn emit_aux(&mut self, sink: &mut impl Sink, code: u16, rules: RuleSet) {
        let group = codes::m_group(code).map(Label::new).unwrap_or_default();
        self.emit(sink, rules, Action::Aux { code: Label::of_code(b'M', code), group });
    }
}
