//! Two turrets on one saddle: the blocks that change them, what each has for itself, and the mirror image
//! ("How two turrets and two saddles run", section 3).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    AlarmName, FrameCause, Label, MachineType, RuleSet, Setup, Side, Sink, SpindleState,
};

use super::Interpreter;
use super::codes::GGroup;
use super::fault::Fault;
use super::state::{TABLE, X, Z, nose_radii, tool_offsets};
use super::task::whole;
use super::words::{Address, Item, Parsed, Source, Words};

/// What each turret has for itself (E100L-MIRR-11, E100L-MIRR-18).
#[derive(Debug)]
pub struct Turret {
    pub zero_offset: [i64; 2],
    pub zero_shift: [i64; 2],
    pub tool_offsets: [[i64; 2]; TABLE],
    pub nose_radii: [[i64; 2]; TABLE],
    pub tool: u8,
    pub offset: u8,
    pub nose: u8,
}

impl Turret {
    /// Turret or saddle B at the start.
    pub fn b(setup: &Setup) -> Self {
        let b = &setup.turret_b;
        Self {
            zero_offset: [b.zero_offset.x.0, b.zero_offset.z.0],
            zero_shift: [0; 2],
            tool_offsets: tool_offsets(&b.tool_offset),
            nose_radii: nose_radii(&b.nose_radius),
            tool: 0,
            offset: 0,
            nose: 0,
        }
    }
}

/// The turret that is selected at the start, where there are two.
pub fn first(setup: &Setup) -> Option<Side> {
    (setup.machine.r#type == MachineType::TwoTurrets).then_some(Side::A)
}

/// The turret that is not selected at the start.
pub fn second(setup: &Setup) -> Option<Box<Turret>> {
    first(setup).map(|_| Box::new(Turret::b(setup)))
}

/// The G words 13 and 14 of a block that are plain numbers.
fn turret_codes(parsed: &Parsed) -> impl Iterator<Item = u16> {
    parsed.items.iter().filter_map(|item| match item {
        Item::Word(Address::G, Source::Plain(number)) => {
            whole(*number).filter(|code| matches!(code, 13 | 14))
        }
        _ => None,
    })
}

/// The G word 13 or 14 of a block that has nothing else, if it is a plain number.
pub fn lone_turret_code(parsed: &Parsed) -> Option<u16> {
    turret_codes(parsed).next().filter(|_| parsed.items.len() == 1)
}

/// X and Z of the amounts of a turret, by their causes.
type Frames = [(FrameCause, [i64; 2]); 3];

impl Interpreter<'_> {
    /// Whether machine X is the mirror image of program X.
    #[inline]
    pub(super) fn is_mirrored(&self) -> bool {
        self.turret == Some(Side::B)
    }

    /// Whether a block does nothing but select a turret.
    #[inline]
    pub(super) fn is_turret_block(&self, parsed: &Parsed) -> bool {
        self.turret.is_some() && turret_codes(parsed).next().is_some()
    }

    /// Carries out a turret block: everything in it but the code is ignored (E100L-MIRR-03).
    pub(super) fn turret_block(&mut self, parsed: &Parsed, sink: &mut impl Sink) -> Result<(), Fault> {
        let mut codes = turret_codes(parsed);
        let (code, more) = (codes.next(), codes.next());
        if more.is_some() {
            return Fault::raise(AlarmName::GCodesConflict, GCODE_04);
        }
        let wanted = if code == Some(14) { Side::B } else { Side::A };
        if self.turret != Some(wanted) {
            self.check_change()?;
            self.change_turret(sink);
        }
        if self.compensation.acts() {
            self.finish_block(sink)?;
        }
        Ok(())
    }

    /// What forbids a change of turret (E100L-MIRR-09, E100L-MIRR-20).
    fn check_change(&self) -> Result<(), Fault> {
        let state = &self.state;
        if state.compensation != 40 || state.incremental || state.constant_speed {
            return Fault::raise(AlarmName::TurretChange, MIRR_09);
        }
        if self.compensation.is_left_over() {
            return Err(Fault::about(AlarmName::Unspecified, MIRR_09, const { Label::new("displacement") }));
        }
        if state.c_joined {
            return Err(Fault::about(AlarmName::Unspecified, MIRR_20, const { Label::new("c_axis") }));
        }
        Ok(())
    }

    /// The change to the other turret (E100L-MIRR-10, E100L-MIRR-11, E100L-MIRR-18).
    fn change_turret(&mut self, sink: &mut impl Sink) {
        let before = self.turret_frames();
        self.select_other_turret();
        self.emit_turret(sink, const { RuleSet::of(&[GCODE_02, MIRR_10]) });
        for ((cause, before), (_, now)) in before.into_iter().zip(self.turret_frames()) {
            let rules = match cause {
                FrameCause::ToolOffset => const { RuleSet::of(&[MIRR_11, MIRR_18]) },
                _ => const { RuleSet::of(&[MIRR_18]) },
            };
            if before != now {
                self.emit_frame(sink, cause, rules);
            }
        }
        self.state.base = None;
    }

    fn turret_frames(&self) -> Frames {
        let state = &self.state;
        let plane = |amounts: &[i64; 4]| [amounts[X], amounts[Z]];
        [
            (FrameCause::ZeroOffset, plane(&state.zero_offset)),
            (FrameCause::ZeroShift, plane(&state.zero_shift)),
            (FrameCause::ToolOffset, state.active_offset()),
        ]
    }

    fn select_other_turret(&mut self) {
        if let Some(idle) = &mut self.idle_turret {
            self.state.exchange_turret(idle);
        }
        self.turret = self.turret.map(Side::other);
        self.state.x_sense = if self.is_mirrored() { -1 } else { 1 };
    }

    /// The mode event of the turret that is selected now.
    fn emit_turret(&mut self, sink: &mut impl Sink, rules: RuleSet) {
        let (code, previous) = if self.is_mirrored() { (14, 13) } else { (13, 14) };
        self.emit_mode(sink, const { Label::new("turret") }, code, previous, rules);
    }

    /// The last of the reset: turret A, and no zero shift (E100L-MIRR-04).
    pub(super) fn reset_turrets(&mut self, sink: &mut impl Sink) {
        if self.is_mirrored() {
            self.select_other_turret();
            self.emit_turret(sink, const { RuleSet::of(&[MCODE_04, MIRR_04]) });
        }
        let a = std::mem::take(&mut self.state.zero_shift) != [0; 4];
        let idle = self.idle_turret.as_mut().map(|idle| std::mem::take(&mut idle.zero_shift));
        let b = idle.is_some_and(|shift| shift != [0; 2]);
        for side in [a.then_some(Side::A), b.then_some(Side::B)].into_iter().flatten() {
            self.turret = Some(side);
            self.emit_frame(sink, FrameCause::ZeroShift, const { RuleSet::of(&[G50_05, SVAR_02]) });
        }
        self.turret = Some(Side::A);
    }

    /// The direction in which the spindle turns by M03 or M04 of the selected turret, which is given as that
    /// of turret A (E100L-MIRR-06, E100L-MIRR-08).
    pub(super) fn turning(
        &mut self,
        of_a: SpindleState,
        rules: RuleSet,
    ) -> Result<(SpindleState, RuleSet), Fault> {
        let (turning, rules) = match of_a {
            _ if !self.is_mirrored() => (of_a, rules),
            SpindleState::Clockwise => (SpindleState::CounterClockwise, rules.with(MIRR_06)),
            _ => (SpindleState::Clockwise, rules.with(MIRR_06)),
        };
        let turns = matches!(self.state.spindle, SpindleState::Clockwise | SpindleState::CounterClockwise);
        if turns && self.state.started_by != self.turret && self.state.spindle != turning {
            return Fault::raise(AlarmName::TurretChange, MIRR_08);
        }
        self.state.started_by = self.turret;
        Ok((turning, rules))
    }

    /// The cutting speed follows the selected turret, or is not described (E100L-MIRR-19).
    #[inline]
    pub(super) fn check_speed_turret(&self, words: &Words) -> Result<(), Fault> {
        if self.turret.is_none() {
            return Ok(());
        }
        let turret = words.code_of(GGroup::SpeedTurret);
        let constant =
            words.code_of(GGroup::CuttingSpeed).map_or(self.state.constant_speed, |code| code == 96);
        let by_b = turret.map_or(self.state.speed_by_b, |code| code == 111);
        if constant && (turret.is_some() || words.has_g(96)) && by_b != self.is_mirrored() {
            let code = Label::of_code(b'G', if by_b { 111 } else { 110 });
            return Err(Fault::about(AlarmName::Unspecified, MIRR_19, code));
        }
        Ok(())
    }
}
