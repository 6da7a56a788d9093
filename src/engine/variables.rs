//! System variables: their values in expressions (E100L-TYPE-13) and assignments to them (E100L-TYPE-05).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Angle, FrameCause, Label, Length, ReadingSet, RuleSet, Setup, Sink, UnitSystem, Value,
};

use super::Interpreter;
use super::arithmetic::round::Rounding;
use super::assignment::Origin;
use super::evaluate::push_number;
use super::fault::Fault;
use super::number::{Number, quotient};
use super::planted::{self, Bug};
use super::state::{X, Z};
use super::system::{Axis, SystemVariable};
use super::words::Operand;

impl Interpreter<'_> {
    /// The suffix of a variable, rounded and within its range.
    pub(super) fn suffix(&self, variable: SystemVariable, number: Number) -> Result<usize, Fault> {
        let (first, last) = match variable {
            SystemVariable::PitchError(_) => (1, 120),
            SystemVariable::ToolData(data) => (1, data.last(self.setup).into()),
            SystemVariable::Comment => (1, 16),
            SystemVariable::Input | SystemVariable::Output => (1, 1250),
            SystemVariable::InputBit | SystemVariable::OutputBit => (0, 9999),
            _ => (0, i64::from(self.setup.options.offset_sets)),
        };
        // A value that rounds into the range lies within half a unit of it.
        let value = if number.within(2, -1, 2 * last + 1) { number.whole(1, Rounding::HalfAway) } else { -1 };
        match usize::try_from(value) {
            Ok(index) if (first..=last).contains(&value) && variable.has_number(index) => Ok(index),
            _ => Fault::raise(AlarmName::VariableSuffix, variable.suffix_rule()),
        }
    }

    /// The value of a system variable in an expression.
    pub(super) fn read_variable(
        &mut self,
        variable: SystemVariable,
        suffix: Option<usize>,
    ) -> Result<Operand, Fault> {
        let plain = |value: i64| Ok(Operand::Integer(i32::try_from(value).unwrap_or(i32::MAX)));
        match variable {
            // Those in use, both integers (E100L-SVTAB-04).
            SystemVariable::OffsetNumber => plain(self.state.offset.into()),
            SystemVariable::ToolNumber => plain(self.state.tool.into()),
            // 128 while a sequence restart is in progress (E100L-SVAR-11).
            SystemVariable::Restart => plain(if self.setup.inputs.restart { 128 } else { 0 }),
            // The binary64 number nearest to π (E100L-SVAR-12).
            SystemVariable::Pi => Ok(Operand::Real(std::f64::consts::PI)),
            SystemVariable::FullTurn => Ok(Operand::Real(self.scales.full_turn)),
            SystemVariable::Input | SystemVariable::InputBit | SystemVariable::OutputBit => {
                Ok(Operand::Integer(self.read_input(variable, suffix.unwrap_or_default())))
            }
            _ if variable.is_plain() => plain(self.amount(variable, suffix)),
            _ => self.dimension(self.amount(variable, suffix), variable.is_angle()),
        }
    }

    /// The amount that a variable stands for, in nanometres, micro-degrees or plain.
    pub(super) fn amount(&self, variable: SystemVariable, suffix: Option<usize>) -> i64 {
        let state = &self.state;
        let index = suffix.unwrap_or_default();
        let entry = |table: &[[i64; 2]], axis: Axis| {
            table.get(index).map_or(0, |entry| entry[usize::from(axis == Axis::Z)])
        };
        match variable {
            SystemVariable::ZeroOffset(axis) => state.zero_offset[axis as usize],
            SystemVariable::ZeroShift(axis) => state.zero_shift[axis as usize],
            SystemVariable::ToolOffset(axis) => entry(&state.tool_offsets, axis),
            SystemVariable::NoseRadius(axis) => entry(&state.nose_radii, axis),
            SystemVariable::PositiveLimit(axis) => {
                state.positive_limits[axis as usize].unwrap_or(Setup::COORDINATE)
            }
            SystemVariable::NegativeLimit(axis) => {
                state.negative_limits[axis as usize].unwrap_or(-Setup::COORDINATE)
            }
            SystemVariable::Droop(axis) => state.droop.get(axis as usize).copied().unwrap_or_default(),
            SystemVariable::Barrier(number) => {
                state.barriers.get(usize::from(number)).copied().unwrap_or_default()
            }
            SystemVariable::PitchError(axis) => entry(&state.pitch_errors, axis),
            SystemVariable::Pitch(axis) => state.pitches[usize::from(axis == Axis::Z)],
            // Where the last motion carried out has ended, in the frame now in force (E100L-SVTAB-02).
            SystemVariable::Commanded(axis) => state.program(axis as usize),
            // The commanded position in machine coordinates (E100L-SVTAB-03).
            SystemVariable::Actual(Axis::X) => state.machine_x(state.machine[X]),
            SystemVariable::Actual(axis) => state.machine[axis as usize],
            // The amounts of the offset in use (E100L-SVTAB-04).
            SystemVariable::ActiveOffset(axis) => state.active_offset()[usize::from(axis == Axis::Z)],
            SystemVariable::ToolData(data) => {
                state.tool_data.get(&(data, index)).copied().unwrap_or_default()
            }
            _ => 0,
        }
    }

    /// A dimension as the unit system reads it.
    fn dimension(&self, value: i64, angle: bool) -> Result<Operand, Fault> {
        let divisor = match (self.setup.unit_system, angle) {
            (UnitSystem::Millimetre, _) | (UnitSystem::Inch, true) => 1_000_000,
            (UnitSystem::TenMicrometre, _) => 10_000,
            (UnitSystem::TenThousandthInch, false) => 2540,
            (UnitSystem::Inch, false) => 25_400_000,
            (UnitSystem::Micrometre, _) | (UnitSystem::TenThousandthInch, true) => {
                let increments = Rounding::HalfAway.divide(value.into(), 1000);
                return i32::try_from(increments)
                    .map(Operand::Integer)
                    .map_err(|_| Fault::new(AlarmName::IntegerOverflow, TYPE_13));
            }
        };
        Ok(Operand::Real(quotient(value, divisor)))
    }

    /// Assigns a system variable.
    pub(super) fn assign(
        &mut self,
        variable: SystemVariable,
        suffix: Option<usize>,
        value: Operand,
        origin: Origin,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        if variable == SystemVariable::Output {
            return self.assign_output(suffix.unwrap_or_default(), value, origin, sink);
        }
        let number = value.number();
        let plain = variable.is_plain();
        // Units of a written 1, and the increment that is stored.
        let unit = match (plain, variable.is_angle()) {
            (true, _) => 1,
            (false, true) => self.units.angle,
            (false, false) => self.units.length,
        };
        // Dimensions are held in whole increments of 0.001 mm or 0.001 degree (E100L-SVAR-13).
        let increment = if plain { 1 } else { 1000 };
        let (low, high) = variable.range(self.units.inch);
        // The range holds after conversion: a value that rounds into it lies within half an increment.
        let near = number.within(unit, low - increment, high + increment);
        let amount = match value {
            _ if !near => i64::MAX,
            Operand::Integer(_) => number.cut(unit, increment),
            Operand::Real(_) => number.rounded(unit, increment),
        };
        if !(low..=high).contains(&amount) {
            return Fault::raise(AlarmName::VariableRange, SVTAB_01);
        }
        let entry = matches!(variable, SystemVariable::ToolOffset(_) | SystemVariable::NoseRadius(_));
        if entry && suffix == Some(0) && amount != 0 {
            return Fault::raise(AlarmName::VariableRange, TOOL_03);
        }
        let before = self.amount(variable, suffix);
        self.store(variable, suffix, amount);
        let shown = match (plain, variable.is_angle()) {
            (true, _) => Value::Integer(i32::try_from(amount).unwrap_or(i32::MAX)),
            (false, true) => Value::Angle(Angle(amount)),
            (false, false) => Value::Length(Length(amount)),
        };
        let action = Action::Variable { name: variable_label(variable, suffix), value: shown };
        self.emit(sink, origin.rules(assignment_rules(variable)), action);
        if before != amount {
            self.changed_frame(variable, suffix, sink);
        }
        Ok(())
    }

    fn store(&mut self, variable: SystemVariable, suffix: Option<usize>, amount: i64) {
        let state = &mut self.state;
        let index = suffix.unwrap_or_default();
        let set = |table: &mut [[i64; 2]], axis: Axis| {
            if let Some(entry) = table.get_mut(index) {
                entry[usize::from(axis == Axis::Z)] = amount;
            }
        };
        match variable {
            SystemVariable::ZeroOffset(axis) => state.zero_offset[axis as usize] = amount,
            SystemVariable::ZeroShift(axis) => state.zero_shift[axis as usize] = amount,
            SystemVariable::ToolOffset(axis) => set(&mut state.tool_offsets, axis),
            SystemVariable::NoseRadius(axis) => set(&mut state.nose_radii, axis),
            SystemVariable::PositiveLimit(axis) => state.positive_limits[axis as usize] = Some(amount),
            SystemVariable::NegativeLimit(axis) => state.negative_limits[axis as usize] = Some(amount),
            SystemVariable::Droop(axis) => {
                if let Some(slot) = state.droop.get_mut(axis as usize) {
                    *slot = amount;
                }
            }
            SystemVariable::Barrier(number) => {
                if let Some(slot) = state.barriers.get_mut(usize::from(number)) {
                    *slot = amount;
                }
            }
            SystemVariable::PitchError(axis) => set(&mut state.pitch_errors, axis),
            SystemVariable::Pitch(axis) => state.pitches[usize::from(axis == Axis::Z)] = amount,
            SystemVariable::ToolData(data) => {
                state.tool_data.insert((data, index), amount);
            }
            _ => {}
        }
    }

    /// The frame event of an assignment that moved the program coordinates.
    fn changed_frame(&mut self, variable: SystemVariable, suffix: Option<usize>, sink: &mut impl Sink) {
        const OFFSET: RuleSet = RuleSet::of(&[SVAR_03, COORD_03]);
        match variable {
            SystemVariable::ZeroOffset(_) => self.emit_frame(sink, FrameCause::ZeroOffset, OFFSET),
            SystemVariable::ZeroShift(_) => {
                self.emit_frame(sink, FrameCause::ZeroShift, const { RuleSet::of(&[SVAR_04]) });
            }
            SystemVariable::ToolOffset(_)
                if suffix == Some(self.state.offset.into()) && !planted::is(Bug::ActiveOffsetSilent) =>
            {
                self.emit_frame(sink, FrameCause::ToolOffset, const { RuleSet::of(&[SVAR_05]) });
            }
            _ => {}
        }
    }

    /// The frame event of a G50 or T word, which inch words of the block take part in.
    pub(super) fn emit_word_frame(&mut self, sink: &mut impl Sink, cause: FrameCause, rules: RuleSet) {
        if self.inch_block {
            self.emit_frame_with(sink, cause, rules.with(INCH_02), self.known.inch);
        } else {
            self.emit_frame(sink, cause, rules);
        }
    }

    /// A frame event with the new amounts.
    pub(super) fn emit_frame(&mut self, sink: &mut impl Sink, cause: FrameCause, rules: RuleSet) {
        self.emit_frame_with(sink, cause, rules, ReadingSet::default());
    }

    fn emit_frame_with(
        &mut self,
        sink: &mut impl Sink,
        cause: FrameCause,
        rules: RuleSet,
        mut readings: ReadingSet,
    ) {
        let state = &self.state;
        let offset = state.active_offset();
        let [x, z, c, w] = match cause {
            FrameCause::ZeroOffset => state.zero_offset,
            FrameCause::ZeroShift => state.zero_shift,
            FrameCause::ToolOffset => [offset[X], offset[Z], 0, 0],
        };
        if cause == FrameCause::ToolOffset {
            readings = readings.union(self.known.tool_offset);
        }
        let action = Action::Frame { cause, x: Length(x), z: Length(z), c: Angle(c), w: Length(w) };
        self.emit_with(sink, rules, readings, action);
    }
}

/// The rules of an assignment event.
fn assignment_rules(variable: SystemVariable) -> RuleSet {
    let (rule, conversion) = match variable {
        SystemVariable::ZeroOffset(_) => (SVAR_03, TYPE_05),
        SystemVariable::ZeroShift(_) => (SVAR_04, TYPE_05),
        SystemVariable::ToolOffset(_) => (SVAR_05, TYPE_05),
        SystemVariable::NoseRadius(_) => (SVAR_06, TYPE_05),
        SystemVariable::PositiveLimit(_) | SystemVariable::NegativeLimit(_) => (SVAR_07, TYPE_05),
        SystemVariable::Barrier(_) => (SVAR_08, TYPE_05),
        SystemVariable::Droop(_) => (SVAR_09, TYPE_07),
        SystemVariable::ToolData(_) if variable.is_plain() => (SVAR_14, TYPE_07),
        SystemVariable::ToolData(_) => (SVAR_14, TYPE_05),
        _ => (SVAR_10, TYPE_05),
    };
    RuleSet::of(&[rule, conversion])
}

/// The name of a variable with its suffix.
pub fn variable_label(variable: SystemVariable, suffix: Option<usize>) -> Label {
    let (name, length) = variable.name();
    let mut label = Label::from_bytes(name.get(..length).unwrap_or_default());
    if let Some(suffix) = suffix {
        label.push(b'[');
        push_number(&mut label, u32::try_from(suffix).unwrap_or(u32::MAX));
        label.push(b']');
    }
    label
}
