//! The turrets of one saddle: what each has of its own, and the block that changes them.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    AlarmName, FrameCause, Label, MachineType, NoseRadius, RuleSet, Setup, Side, Sink, ToolOffset,
};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::number::Number;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{State, TABLE, X, Z};
use crate::engine::words::{Address, Item, Parsed, Source};

use super::side_of;

/// What a turret has of its own (E100L-MIRR-18).
#[derive(Clone, Debug)]
pub struct Turret {
    zero_offset: [i64; 2],
    zero_shift: [i64; 2],
    tool_offsets: [[i64; 2]; TABLE],
    nose_radii: [[i64; 2]; TABLE],
    tool: u8,
    offset: u8,
    nose: u8,
}

/// A table of tool offsets.
pub fn tool_offsets(entries: &[ToolOffset]) -> [[i64; 2]; TABLE] {
    table(entries.iter().map(|entry| (entry.number, [entry.x.0, entry.z.0])))
}

/// A table of nose radius entries.
pub fn nose_radii(entries: &[NoseRadius]) -> [[i64; 2]; TABLE] {
    table(entries.iter().map(|entry| (entry.number, [entry.x.0, entry.z.0])))
}

fn table(entries: impl Iterator<Item = (u8, [i64; 2])>) -> [[i64; 2]; TABLE] {
    let mut table = [[0; 2]; TABLE];
    for (number, amounts) in entries {
        if let Some(slot) = table.get_mut(usize::from(number)) {
            *slot = amounts;
        }
    }
    table
}

impl Turret {
    /// Turret B at the start, on machines that have it beside turret A.
    pub fn other(setup: &Setup) -> Option<Box<Self>> {
        let b = &setup.turret_b;
        (setup.machine.r#type == MachineType::TwoTurrets).then(|| {
            Box::new(Self {
                zero_offset: [b.zero_offset.x.0, b.zero_offset.z.0],
                zero_shift: [0; 2],
                tool_offsets: tool_offsets(&b.tool_offset),
                nose_radii: nose_radii(&b.nose_radius),
                tool: 0,
                offset: 0,
                nose: 0,
            })
        })
    }
}

impl State {
    /// The other turret becomes the one that is selected; X is mirrored (E100L-MIRR-05, E100L-MIRR-18).
    fn change_turret(&mut self) {
        let Some(other) = &mut self.other_turret else { return };
        for (axis, place) in [(X, 0), (Z, 1)] {
            std::mem::swap(&mut self.zero_offset[axis], &mut other.zero_offset[place]);
            std::mem::swap(&mut self.zero_shift[axis], &mut other.zero_shift[place]);
        }
        std::mem::swap(&mut self.tool_offsets, &mut other.tool_offsets);
        std::mem::swap(&mut self.nose_radii, &mut other.nose_radii);
        std::mem::swap(&mut self.tool, &mut other.tool);
        if !planted::is(Bug::OffsetOfOtherTurret) {
            std::mem::swap(&mut self.offset, &mut other.offset);
        }
        std::mem::swap(&mut self.nose, &mut other.nose);
        self.selected = self.selected.other();
        self.machine[X] = self.machine[X].saturating_neg();
        self.mirror = -self.mirror;
    }

    /// The amounts of zero offset, zero shift and tool offset in X and Z, in the order of their events.
    fn plane_amounts(&self) -> [[i64; 2]; 3] {
        let plane = |amounts: &[i64; 4]| [amounts[X], amounts[Z]];
        [plane(&self.zero_offset), plane(&self.zero_shift), self.active_offset()]
    }
}

/// The turret codes of a block that are written as plain numbers.
fn turret_codes(parsed: &Parsed) -> impl Iterator<Item = u16> + '_ {
    parsed.items.iter().filter_map(|item| match item {
        Item::Word(Address::G, Source::Plain(Number::Decimal { digits, scale: 0, .. })) => match digits {
            13 => Some(13),
            14 => Some(14),
            _ => None,
        },
        _ => None,
    })
}

impl Interpreter<'_> {
    /// Whether a block selects a turret of a saddle with two (E100L-MIRR-03).
    #[inline]
    pub(in crate::engine) fn is_turret_block(&self, parsed: &Parsed) -> bool {
        self.state.other_turret.is_some() && turret_codes(parsed).next().is_some()
    }

    /// The code of a block that selects a turret: only one may stand there.
    pub(in crate::engine) fn turret_code(parsed: &Parsed) -> Result<u16, Fault> {
        let mut codes = turret_codes(parsed);
        let code = codes.next().unwrap_or(13);
        if codes.next().is_some() {
            return Fault::raise(AlarmName::GCodesConflict, GCODE_04);
        }
        Ok(code)
    }

    /// Whether a code selects the other turret.
    pub(in crate::engine) fn changes_turret(&self, code: u16) -> bool {
        side_of(code) != self.state.selected
    }

    /// Carries out a block that selects a turret: nothing else in it counts.
    pub(in crate::engine) fn select_turret(
        &mut self,
        parsed: &Parsed,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let code = Self::turret_code(parsed)?;
        if !self.changes_turret(code) {
            return Ok(());
        }
        let state = &self.state;
        if state.compensation != 40
            || state.incremental && !planted::is(Bug::ChangeInIncremental)
            || state.constant_speed
        {
            return Fault::raise(AlarmName::TurretChange, MIRR_09);
        }
        let open = |rule, detail| Err(Fault::about(AlarmName::Unspecified, rule, detail));
        if self.compensation.is_left_over() {
            return open(MIRR_09, const { Label::new("displacement") });
        }
        if state.c_joined {
            return open(MIRR_20, const { Label::new("c_axis") });
        }
        self.show_turret(code, sink);
        Ok(())
    }

    /// Behind a block that selects a turret; in compensation it is one without motion.
    pub(in crate::engine) fn finish_turret_block(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        if self.compensation.acts() { self.finish_block(sink) } else { Ok(()) }
    }

    /// The change, and what it does to the frame.
    fn show_turret(&mut self, code: u16, sink: &mut impl Sink) {
        let before = self.state.plane_amounts();
        self.state.change_turret();
        self.state.base = None;
        let group = const { Label::new("turret") };
        self.emit_mode(sink, group, code, 27 - code, const { RuleSet::of(&[GCODE_02, MIRR_10]) });
        let causes = [FrameCause::ZeroOffset, FrameCause::ZeroShift, FrameCause::ToolOffset];
        for ((cause, before), after) in causes.into_iter().zip(before).zip(self.state.plane_amounts()) {
            let rules = match cause {
                FrameCause::ToolOffset => const { RuleSet::of(&[MIRR_11, MIRR_18]) },
                _ => const { RuleSet::of(&[MIRR_18]) },
            };
            if before != after {
                self.emit_frame(sink, cause, rules);
            }
        }
    }

    /// The reset selects turret A (E100L-MIRR-04); its event is the last of a mode.
    pub(in crate::engine) fn reset_turret(&mut self, sink: &mut impl Sink) {
        if self.state.selected == Side::B && self.state.other_turret.is_some() {
            self.state.change_turret();
            let group = const { Label::new("turret") };
            self.emit_mode(sink, group, 13, 14, const { RuleSet::of(&[MCODE_04, MIRR_04]) });
        }
    }

    /// The reset clears the shift of turret B behind that of turret A.
    pub(in crate::engine) fn reset_shift_of_b(&mut self, rules: RuleSet, sink: &mut impl Sink) {
        let Some(other) = &mut self.state.other_turret else { return };
        if std::mem::take(&mut other.zero_shift) != [0; 2] && !planted::is(Bug::ShiftOfBKept) {
            self.state.selected = Side::B;
            self.emit_frame(sink, FrameCause::ZeroShift, rules);
            self.state.selected = Side::A;
        }
    }
}
