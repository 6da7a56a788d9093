//! Carrying a block out: what comes after what (execution, chapter 5).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Duration, Ending, FeedUnit, FrameCause, Label, RuleSet, Side, Sink,
};

use super::Interpreter;
use super::arithmetic::speed::thousandths;
use super::arithmetic::{frame, turn};
use super::block::{Before, OneShot, Plan};
use super::codes::g_label;
use super::compensation::Change;
use super::contour;
use super::cycle;
use super::fault::Fault;
use super::planted::{self, Bug};
use super::sides::{self, Common};
use super::slot::Slot;
use super::state::{Amounts, C, StoredFeed, W, X, Z};
use super::words::{Address, Words};

impl Interpreter<'_> {
    /// Carries out an evaluated block.
    /// Its words act in this order, wherever they stand (E100L-FMT-09); its assignments have acted before.
    pub(super) fn carry_out(&mut self, slot: &Slot, sink: &mut impl Sink) -> Result<Option<Ending>, Fault> {
        let Slot { parsed, words, .. } = slot;
        let before = Before {
            motion: self.state.motion,
            after_angle: self.state.angle_target.is_some(),
            left_over: self.compensation.is_left_over(),
        };
        let from = planted::is(Bug::IdleNoTrigger).then_some(self.state.machine);
        let plan = self.check(parsed, words, before)?;
        self.state.cycle.begin_block(words);
        for code in words.g_codes() {
            match *code {
                136 | 137 => self.change_conversion(*code, words, sink)?,
                code => self.change_mode(code, sink),
            }
        }
        self.take_feed(words, plan)?;
        if self.lap.is_active() || matches!(plan.one_shot, OneShot::Lap(_)) {
            self.begin_contour_block(words, plan)?;
        }
        self.act_at_once(words, plan, sink)?;
        self.speeds(words, plan, sink)?;
        if let Some(tool) = words.get(Address::T).filter(|_| !plan.one_shot.is_groove()) {
            self.change_tool(tool, plan.moves, sink)?;
        }
        // So a block starts or clamps with its M codes before it drills (E100L-CAX-09).
        self.m_codes(words, plan, sink)?;
        if plan.one_shot == OneShot::ZeroShift || words.has(Address::T) || parsed.has_assignment {
            self.state.base = None;
        }
        if plan.compensation != Change::None {
            self.change_compensation(plan.compensation, words);
        }
        if self.lap.is_active() && Self::makes_motion(plan) {
            self.admit_motion(plan)?;
        }
        self.move_axes(slot, plan, sink)?;
        if plan.compensation != Change::None {
            self.complete_change(sink)?;
        }
        if self.side.is_some() && self.stop_at_m100(words, plan, sink) {
            return Ok(None);
        }
        self.carry_out_last(slot, plan, from, sink)
    }

    /// Step 7 of a block: its motions, its dwell.
    #[inline]
    pub(super) fn move_axes(&mut self, slot: &Slot, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        let words = &slot.words;
        match plan.one_shot {
            OneShot::Dwell => self.dwell(words, sink)?,
            OneShot::Lap(code) => self.carry_out_lap(slot, code, sink)?,
            OneShot::TorqueSkip => {
                self.torque_skip(words, sink)?;
                self.state.thread.end_chain();
            }
            OneShot::ThreadAlong | OneShot::ThreadAcross => {
                self.compound_thread(words, plan.one_shot, sink)?
            }
            OneShot::Chamfer | OneShot::Rounding => self.chamfer(slot, plan, sink)?,
            OneShot::GrooveAcross | OneShot::GrooveAlong => self.groove(words, plan.one_shot, sink)?,
            OneShot::TapRight | OneShot::TapLeft => self.tap(words, plan.one_shot, sink)?,
            _ if plan.cycle.acts() => self.carry_out_cycle(words, plan.cycle, sink)?,
            _ if plan.cuts_thread() => self.thread(slot, plan.motion, sink)?,
            _ if plan.moves && self.compensation.is_of_cutter() => self.move_cutter(slot, plan, sink)?,
            _ if plan.moves && contour::is_mode(plan.motion) => self.cut_contour(words, plan.motion, sink)?,
            _ if plan.moves && plan.motion >= 2 => self.arc(words, plan.motion, sink)?,
            _ if plan.moves && self.state.contour.converts() && words.has_any(contour::POINT) => {
                self.position_by_point(words, sink)?;
            }
            _ if plan.moves => self.line(slot, plan, sink)?,
            _ => {}
        }
        Ok(())
    }

    /// Step 8 of a block, and what comes behind it.
    pub(super) fn carry_out_last(
        &mut self,
        slot: &Slot,
        plan: Plan,
        from: Option<Amounts>,
        sink: &mut impl Sink,
    ) -> Result<Option<Ending>, Fault> {
        let Slot { parsed, words, .. } = slot;
        let ending = self.stop(words, sink)?;
        if ending.is_some() || self.has_ended() {
            return Ok(ending);
        }
        if self.compensation.acts() && !parsed.is_only_name() {
            self.finish_block(sink)?;
        }
        if self.task.has_modes() && plan.is_axis_motion(words) && from != Some(self.state.machine) {
            self.call_modes(sink)?;
        }
        if self.lap.defines() && words.has_g(80) {
            self.finish_contour(sink)?;
        }
        Ok(None)
    }

    /// A G code that changes its modal group.
    pub(super) fn change_mode(&mut self, code: u16, sink: &mut impl Sink) {
        macro_rules! with {
            ($rule:ident) => {
                const { RuleSet::of(&[GCODE_02, $rule]) }
            };
        }
        let state = &mut self.state;
        let flag = |flag: &mut bool, on: bool| std::mem::replace(flag, on) != on;
        let (group, previous, changed, rules) = match code {
            0..=3 | 31..=35 | 101..=103 | 132 | 133 => {
                let previous = std::mem::replace(&mut state.motion, code);
                state.thread.select_motion(code);
                let rules = match code {
                    0 => with!(G00_01),
                    1 => with!(G01_01),
                    31 => with!(G33_02),
                    32 => with!(G32_01),
                    33 => with!(G33_01),
                    34 | 35 => with!(G34_01),
                    101 => with!(CGF_02),
                    102 | 103 => with!(CGF_04),
                    132 | 133 => with!(CGS_01),
                    _ => with!(CIRC_01),
                };
                let rules = if previous == contour::NO_CODE { rules.with(CSC_05) } else { rules };
                (const { Label::new("motion") }, previous, previous != code, rules)
            }
            17 | 18 | 119 => {
                let previous = std::mem::replace(&mut state.plane, code);
                if code == 119 && self.setup.parameters.side_contour_mode {
                    state.contour.unwind();
                }
                (const { Label::new("plane") }, previous, previous != code, with!(CRC_01))
            }
            40..=42 => {
                let previous = std::mem::replace(&mut state.compensation, code);
                let sides = previous != 40 && code != 40;
                let rules = if sides { with!(NRC_01).with(NRC_61) } else { with!(NRC_01) };
                (const { Label::new("compensation") }, previous, previous != code, rules)
            }
            64 => (const { Label::new("droop") }, 65, flag(&mut state.droop_control, false), with!(DROOP_02)),
            65 => (const { Label::new("droop") }, 64, flag(&mut state.droop_control, true), with!(DROOP_01)),
            90 => (const { Label::new("dimension") }, 91, flag(&mut state.incremental, false), with!(ABS_01)),
            91 => (const { Label::new("dimension") }, 90, flag(&mut state.incremental, true), with!(ABS_02)),
            94 => (const { Label::new("feed_unit") }, 95, flag(&mut state.per_minute, true), with!(FEED_02)),
            95 => (const { Label::new("feed_unit") }, 94, flag(&mut state.per_minute, false), with!(FEED_01)),
            96 => (
                const { Label::new("cutting_speed") },
                97,
                flag(&mut state.constant_speed, true),
                with!(CSS_01),
            ),
            97 => (
                const { Label::new("cutting_speed") },
                96,
                flag(&mut state.constant_speed, false),
                with!(CSS_02),
            ),
            110 | 111 => {
                let side = sides::side_of(code);
                let changed = std::mem::replace(&mut state.speed_side, side) != side;
                let rules = if state.other_turret.is_some() { with!(MIRR_19) } else { with!(AX4_08) };
                (const { Label::new("css_turret") }, 221 - code, changed, rules)
            }
            178..=190 => {
                let previous = std::mem::replace(&mut state.cycle.code, code);
                (const { Label::new("cycle") }, previous, previous != code, cycle::mode_rules(code))
            }
            _ => return,
        };
        if changed {
            let for_both = matches!(code, 96 | 97 | 110 | 111) && self.common() == Common::ForBoth;
            let rules = if for_both { rules.with(AX4_06) } else { rules };
            self.emit_mode(sink, group, code, previous, rules);
        }
    }

    pub(super) fn emit_mode(
        &mut self,
        sink: &mut impl Sink,
        group: Label,
        code: u16,
        previous: u16,
        rules: RuleSet,
    ) {
        let known = previous != contour::NO_CODE;
        let action = Action::Mode {
            group,
            code: g_label(code),
            previous: if known { g_label(previous) } else { Label::default() },
            angle: None,
        };
        self.emit(sink, rules, action);
    }

    /// F and J.
    #[inline]
    pub(super) fn take_feed(&mut self, words: &Words, plan: Plan) -> Result<(), Fault> {
        if words.has(Address::F) && plan.one_shot != OneShot::Dwell {
            self.store_feed(words, plan)?;
        }
        self.state.thread.store_divisor(words, plan);
        Ok(())
    }

    /// F: both readings are kept, the one in force is checked; that of a thread is a lead (E100L-THRD-04).
    fn store_feed(&mut self, words: &Words, plan: Plan) -> Result<(), Fault> {
        let given = if plan.feeds_by_lead() { FeedUnit::PerRevolution } else { self.state.feed_unit() };
        let unit = self.units.feed[usize::from(given == FeedUnit::PerRevolution)];
        let [least, most] = self.units.feeds;
        if !words.feed.within(unit, least, most) {
            return Fault::raise(AlarmName::AddressRange, ADDR_01);
        }
        let values = self.units.feed.map(|unit| words.feed.rounded(unit, 1));
        self.state.feed = Some(StoredFeed { values, given });
        Ok(())
    }

    /// G50, G28 and G29.
    fn act_at_once(&mut self, words: &Words, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        match plan.one_shot {
            OneShot::ZeroShift => {
                let axes = [(Address::X, X), (Address::Z, Z), (Address::C, C), (Address::W, W)];
                let mut shifted = false;
                for (address, axis) in axes {
                    if let Some(word) = words.get(address) {
                        let program = self.state.program(axis);
                        let replaced = planted::is(Bug::ShiftReplaced);
                        let before = if replaced { 0 } else { self.state.zero_shift[axis] };
                        let shift = frame::shift_to(before, program, word);
                        self.state.zero_shift[axis] = if axis == C { turn::shift(shift) } else { shift };
                        shifted = true;
                    }
                }
                if shifted {
                    const RULES: RuleSet = RuleSet::of(&[G50_01, G50_02, G50_03, G50_04]);
                    self.emit_word_frame(sink, FrameCause::ZeroShift, RULES);
                }
                if let Some(speed) = words.get(Address::S).filter(|_| self.common() != Common::Done) {
                    self.state.clamp = Some(thousandths(speed));
                    self.emit_main_spindle(sink, const { RuleSet::of(&[SMAX_02]) }, false, self.state.clamp);
                }
            }
            OneShot::TorqueOff => {
                self.emit(sink, const { RuleSet::of(&[TRQ_02]) }, Action::Torque { z: None, w: None });
                self.state.torque = [None; 2];
            }
            OneShot::TorqueLimit => {
                let percent = |address| words.get(address).and_then(|value| u8::try_from(value).ok());
                for (slot, address) in self.state.torque.iter_mut().zip([Address::PZ, Address::PW]) {
                    *slot = percent(address).or(slot.filter(|_| !planted::is(Bug::TorqueLimitLost)));
                }
                let [z, w] = self.state.torque;
                self.emit(sink, const { RuleSet::of(&[TRQ_01, TRQ_08]) }, Action::Torque { z, w });
            }
            _ => {}
        }
        Ok(())
    }

    /// G04: F is a time here.
    fn dwell(&mut self, words: &Words, sink: &mut impl Sink) -> Result<(), Fault> {
        let hundredths = planted::is(Bug::DwellUnit) && self.units.time == 100_000;
        let unit = if hundredths { 10_000 } else { self.units.time };
        if !words.feed.within(unit, 10_000, 9_999_990_000) {
            return Fault::raise(AlarmName::AddressRange, DWELL_02);
        }
        self.cancel_before_dwell(sink)?;
        let time = Duration(words.feed.rounded(unit, 1));
        self.emit(sink, const { RuleSet::of(&[DWELL_01, DWELL_02]) }, Action::Dwell { time });
        Ok(())
    }

    /// M00, M01, M02 and M30.
    fn stop(&mut self, words: &Words, sink: &mut impl Sink) -> Result<Option<Ending>, Fault> {
        let Some(code) = words.m_codes().iter().copied().find(|code| matches!(code, 0 | 1 | 2 | 30)) else {
            return Ok(None);
        };
        match code {
            0 => self.emit(sink, const { RuleSet::of(&[MCODE_02]) }, Action::Stop),
            1 if self.setup.switches.optional_stop => {
                self.emit(sink, const { RuleSet::of(&[MCODE_03]) }, Action::OptionalStop);
            }
            1 => {}
            _ => {
                if self.compensation.acts() {
                    self.complete_compensation(sink)?;
                }
                if self.side.is_some() {
                    self.end_side(code, sink);
                    return Ok(None);
                }
                if self.schedule.is_running() {
                    return self.end_selected(code, sink).map(|()| None);
                }
                let late = planted::is(Bug::ResetAfterEnd);
                if !late {
                    self.reset(sink);
                }
                let code = Label::of_code(b'M', code);
                self.emit(sink, const { RuleSet::of(&[MCODE_04]) }, Action::End { code });
                if late {
                    self.reset(sink);
                }
                return Ok(Some(Ending::End));
            }
        }
        Ok(None)
    }

    /// Reset at the end of the program.
    /// Common variables keep their values (E100L-CVAR-03).
    pub(super) fn reset(&mut self, sink: &mut impl Sink) {
        let state = &self.state;
        // The reset of saddle A shows what both have in common.
        let common = self.side.is_none() || state.selected == Side::A;
        let droop = state.droop_control && !planted::is(Bug::ResetForgetsDroop);
        let changes = [
            (state.motion != 0, "motion", 0, state.motion, const { RuleSet::of(&[MCODE_04]) }),
            (state.incremental, "dimension", 90, 91, const { RuleSet::of(&[MCODE_04, ABS_01]) }),
            (state.per_minute, "feed_unit", 95, 94, const { RuleSet::of(&[MCODE_04, FEED_01]) }),
            (common && state.constant_speed, "cutting_speed", 97, 96, const { RuleSet::of(&[MCODE_04]) }),
            (
                common && state.speed_side == Side::B,
                "css_turret",
                110,
                111,
                const { RuleSet::of(&[MCODE_04]) },
            ),
            (droop, "droop", 64, 65, const { RuleSet::of(&[MCODE_04]) }),
            (
                state.compensation != 40,
                "compensation",
                40,
                state.compensation,
                const { RuleSet::of(&[MCODE_04, NRC_01]) },
            ),
            (state.plane != 18, "plane", 18, state.plane, const { RuleSet::of(&[MCODE_04, CRC_04]) }),
            (state.contour.converts(), "conversion", 136, 137, const { RuleSet::of(&[MCODE_04, CSC_01]) }),
        ];
        for (changed, group, code, previous, rules) in changes {
            if changed {
                self.emit_mode(sink, Label::new(group), code, previous, rules);
            }
        }
        self.lap.reset();
        self.reset_turret(sink);
        const SHIFT: RuleSet = RuleSet::of(&[G50_05, SVAR_02]);
        if std::mem::take(&mut self.state.zero_shift) != [0; 4] {
            self.emit_frame(sink, FrameCause::ZeroShift, SHIFT);
        }
        self.reset_shift_of_b(SHIFT, sink);
    }
}
