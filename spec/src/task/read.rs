//! Reading variables (E100L-TYPE-13, E100L-SVAR-13, E100L-SVTAB-02 to -05).

use super::evaluate;
use super::evaluate::needs_level_2;
use super::inputs::Signal;
use super::memory::{barrier_datum, droop_index, of_pair};
use super::number::Number;
use crate::controls::e100l::system_variables::{Axis, Quantity, SystemVariable};
use crate::fault::{Fault, Outcome, fail};
use crate::frame::Amounts;
use crate::quantity::{Exact, nearest_real, ratio, round, round_narrow};
use crate::state::State;
use crate::syntax::{Expression, Variable};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Setup, UnitSystem};

/// What a variable holds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Amount {
    /// A number.
    Number(Number),
    /// A length in nanometres.
    Length(i64),
    /// An angle in micro-degrees.
    Angle(i64),
}

impl Amount {
    /// E100L-TYPE-13: as a number, in the unit in which it is read; whole increments are an integer.
    pub fn number(self, system: UnitSystem) -> Outcome<Number> {
        let whole = match (self, system) {
            (Self::Number(number), _) => return Ok(number),
            (Self::Length(_), UnitSystem::Micrometre) => true,
            (Self::Angle(_), UnitSystem::Micrometre | UnitSystem::TenThousandthInch) => true,
            _ => false,
        };
        let exact = self.exact(system);
        if whole { increments(&exact) } else { Ok(Number::Real(nearest_real(&exact))) }
    }

    /// Its exact value in that unit.
    pub fn exact(self, system: UnitSystem) -> Exact {
        match self {
            Self::Number(number) => number.exact(),
            Self::Length(nanometres) => ratio(
                nanometres,
                match system {
                    UnitSystem::Micrometre => 1_000,
                    UnitSystem::TenMicrometre => 10_000,
                    UnitSystem::Millimetre => 1_000_000,
                    UnitSystem::TenThousandthInch => 2_540,
                    UnitSystem::Inch => 25_400_000,
                },
            ),
            Self::Angle(microdegrees) => ratio(
                microdegrees,
                match system {
                    UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 1_000,
                    UnitSystem::TenMicrometre => 10_000,
                    UnitSystem::Millimetre | UnitSystem::Inch => 1_000_000,
                },
            ),
        }
    }
}

fn increments(amount: &Exact) -> Outcome<Number> {
    let count = i32::try_from(&round(amount)).map_err(|_| Fault::new(AlarmName::IntegerOverflow, TYPE_13))?;
    Ok(Number::Integer(count))
}

/// What a variable holds now.
pub fn amount(variable: &Variable, state: &mut State) -> Outcome<Amount> {
    match variable {
        Variable::Common(number) => Ok(Amount::Number(Number::Real(state.memory.common(*number)))),
        Variable::Local(name) => match state.memory.locals.get(*name) {
            Some(value) => Ok(Amount::Number(Number::Real(value))),
            None => Err(Fault::about(AlarmName::LocalUndefined, LVAR_05, name.as_str())),
        },
        Variable::System(system, suffix) => {
            let number = suffix_value(system, suffix.as_ref(), state)?;
            Ok(system_variable(system, number, state))
        }
    }
}

fn system_variable(variable: &SystemVariable, number: usize, state: &mut State) -> Amount {
    let system = state.setup.unit_system;
    let frame = &state.frame;
    let integer = |integer: i32| Amount::Number(Number::Integer(integer));
    match variable.quantity {
        Quantity::ZeroOffset(axis) => of_axis(frame.zero_offset, axis),
        Quantity::ZeroShift(axis) => of_axis(frame.zero_shift, axis),
        Quantity::ToolOffset(axis) => of_axis(entry(&frame.tool_offsets, number), axis),
        Quantity::NoseRadius(axis) => Amount::Length(of_pair(entry(&state.memory.nose_radii, number), axis)),
        Quantity::PositiveLimit(axis) => {
            Amount::Length(state.travel_limit(axis).positive.unwrap_or(Setup::COORDINATE))
        }
        Quantity::NegativeLimit(axis) => {
            Amount::Length(state.travel_limit(axis).negative.unwrap_or(-Setup::COORDINATE))
        }
        Quantity::Droop(axis) => {
            integer(i32::from(state.memory.droop.get(droop_index(axis)).copied().unwrap_or_default()))
        }
        Quantity::Barrier(datum) => Amount::Length(barrier_datum(&state.memory.barriers, datum)),
        Quantity::PitchError(axis) => {
            Amount::Length(of_pair(entry(&state.memory.pitch_errors, number), axis))
        }
        Quantity::Pitch(axis) => Amount::Length(of_pair(state.memory.pitch, axis)),
        Quantity::Interference(_, measure) => state.memory.interference.get(variable.name, number, measure),
        Quantity::Target(axis) => of_axis(frame.program(), axis),
        Quantity::Actual(axis) => of_axis(frame.machine, axis),
        Quantity::ActiveOffset(axis) => of_axis(frame.active_offset(), axis),
        Quantity::ActiveOffsetNumber => integer(i32::from(frame.offset_number)),
        Quantity::ActiveTool => integer(i32::from(state.tool)),
        // E100L-SVAR-11: $80 while a sequence restart is in progress.
        Quantity::Restart => integer(if state.setup.inputs.restart { 0x80 } else { 0 }),
        Quantity::Input => integer(state.memory.inputs.input(number, &state.setup.inputs)),
        Quantity::InputBit => {
            integer(state.memory.inputs.next(Signal::InputBit, number, &state.setup.inputs))
        }
        Quantity::OutputBit => {
            integer(state.memory.inputs.next(Signal::OutputBit, number, &state.setup.inputs))
        }
        // Reading an output was refused by the grammar.
        Quantity::Output => integer(0),
        // E100L-SVAR-12.
        Quantity::Pi => Amount::Number(Number::Real(std::f64::consts::PI)),
        Quantity::FullTurn => Amount::Number(Number::Real(full_turn(system))),
    }
}

/// The suffix of a variable, 0 for one without (E100L-TYPE-07: rounded).
pub fn suffix_value(
    variable: &SystemVariable,
    suffix: Option<&Expression>,
    state: &mut State,
) -> Outcome<usize> {
    if matches!(variable.quantity, Quantity::Input | Quantity::Output) {
        needs_level_2(state, variable.form())?;
    }
    let Some(suffix) = suffix else { return Ok(0) };
    let value = round_narrow(&evaluate(suffix, state)?.exact());
    if !variable.has_number(value, &state.setup.options) {
        return fail(AlarmName::VariableSuffix, variable.form());
    }
    Ok(usize::try_from(value).unwrap_or_default())
}

fn entry<T: Copy + Default>(table: &[T], index: usize) -> T {
    table.get(index).copied().unwrap_or_default()
}

fn of_axis(amounts: Amounts, axis: Axis) -> Amount {
    match axis {
        Axis::X => Amount::Length(amounts.x),
        Axis::Z => Amount::Length(amounts.z),
        Axis::C => Amount::Angle(amounts.c),
        Axis::W => Amount::Length(amounts.w),
    }
}

/// E100L-SVTAB-05: 360 degrees in the unit of angle addresses.
fn full_turn(system: UnitSystem) -> f64 {
    match system {
        UnitSystem::Millimetre | UnitSystem::Inch => 360.0,
        UnitSystem::TenMicrometre => 36_000.0,
        UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 360_000.0,
    }
}
