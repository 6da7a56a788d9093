//! Reading system variables (E100L-TYPE-13, E100L-SVAR-13, E100L-SVTAB-02 to -05).

use super::evaluate;
use super::memory::{barrier_datum, droop_index, of_pair};
use super::number::Number;
use crate::controls::e100l::system_variables::{Axis, Quantity, SystemVariable};
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::quantity::{nearest_real, ratio, round_narrow, whole};
use crate::state::State;
use crate::syntax::Expression;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Setup, UnitSystem};

/// The value of a system variable.
pub fn system_variable(
    variable: &SystemVariable,
    suffix: Option<&Expression>,
    state: &State,
) -> Outcome<Number> {
    let number = suffix_value(variable, suffix, state)?;
    let system = state.setup.unit_system;
    let frame = &state.frame;
    Ok(match variable.quantity {
        Quantity::ZeroOffset(axis) => of_axis(frame.zero_offset, axis, system),
        Quantity::ZeroShift(axis) => of_axis(frame.zero_shift, axis, system),
        Quantity::ToolOffset(axis) => of_axis(entry(&frame.tool_offsets, number), axis, system),
        Quantity::NoseRadius(axis) => length(of_pair(entry(&state.memory.nose_radii, number), axis), system),
        Quantity::PositiveLimit(axis) => {
            length(state.travel_limit(axis).positive.unwrap_or(Setup::COORDINATE), system)
        }
        Quantity::NegativeLimit(axis) => {
            length(state.travel_limit(axis).negative.unwrap_or(-Setup::COORDINATE), system)
        }
        Quantity::Droop(axis) => {
            Number::Integer(i32::from(state.memory.droop.get(droop_index(axis)).copied().unwrap_or_default()))
        }
        Quantity::Barrier(datum) => length(barrier_datum(&state.memory.barriers, datum), system),
        Quantity::PitchError(axis) => {
            length(of_pair(entry(&state.memory.pitch_errors, number), axis), system)
        }
        Quantity::Pitch(axis) => length(of_pair(state.memory.pitch, axis), system),
        Quantity::Target(axis) => of_axis(frame.program(), axis, system),
        Quantity::Actual(axis) => of_axis(frame.machine, axis, system),
        Quantity::ActiveOffset(axis) => of_axis(frame.active_offset(), axis, system),
        Quantity::ActiveOffsetNumber => Number::Integer(i32::from(frame.offset_number)),
        Quantity::ActiveTool => Number::Integer(i32::from(state.tool)),
        // E100L-SVAR-11: $80 while a sequence restart is in progress.
        Quantity::Restart => Number::Integer(if state.setup.inputs.restart { 0x80 } else { 0 }),
        // E100L-SVAR-12.
        Quantity::Pi => Number::Real(std::f64::consts::PI),
        Quantity::FullTurn => Number::Real(full_turn(system)),
    })
}

/// The suffix of a variable, 0 for one without (E100L-TYPE-07: rounded).
pub fn suffix_value(variable: &SystemVariable, suffix: Option<&Expression>, state: &State) -> Outcome<usize> {
    let (Some(suffix), Some((lowest, highest))) = (suffix, variable.suffix(state.setup.options.offset_sets))
    else {
        return Ok(0);
    };
    let value = round_narrow(&evaluate(suffix, state)?.exact());
    if !(lowest..=highest).contains(&value) {
        return fail(AlarmName::VariableSuffix, SVTAB_01);
    }
    Ok(usize::try_from(value).unwrap_or_default())
}

fn entry<T: Copy + Default>(table: &[T], index: usize) -> T {
    table.get(index).copied().unwrap_or_default()
}

fn of_axis(amounts: Amounts, axis: Axis, system: UnitSystem) -> Number {
    match axis {
        Axis::X => length(amounts.x, system),
        Axis::Z => length(amounts.z, system),
        Axis::C => angle(amounts.c, system),
        Axis::W => length(amounts.w, system),
    }
}

/// Nanometres in the unit of lengths; whole increments in the 1 µm system.
fn length(nanometres: i64, system: UnitSystem) -> Number {
    match system {
        UnitSystem::Micrometre => increments(nanometres),
        UnitSystem::TenMicrometre => Number::Real(nearest_real(&ratio(nanometres, 10_000))),
        UnitSystem::Millimetre => Number::Real(nearest_real(&ratio(nanometres, 1_000_000))),
        UnitSystem::TenThousandthInch => Number::Real(nearest_real(&ratio(nanometres, 2_540))),
        UnitSystem::Inch => Number::Real(nearest_real(&ratio(nanometres, 25_400_000))),
    }
}

/// Micro-degrees in the unit of angles.
fn angle(microdegrees: i64, system: UnitSystem) -> Number {
    match system {
        UnitSystem::Micrometre | UnitSystem::TenThousandthInch => increments(microdegrees),
        UnitSystem::TenMicrometre => Number::Real(nearest_real(&ratio(microdegrees, 10_000))),
        UnitSystem::Millimetre | UnitSystem::Inch => {
            Number::Real(nearest_real(&ratio(microdegrees, 1_000_000)))
        }
    }
}

fn increments(amount: i64) -> Number {
    let count = round_narrow(&(whole(amount) / whole(1_000)));
    Number::Integer(i32::try_from(count).unwrap_or(if count < 0 { i32::MIN } else { i32::MAX }))
}

/// E100L-SVTAB-05: 360 degrees in the unit of angle addresses.
fn full_turn(system: UnitSystem) -> f64 {
    match system {
        UnitSystem::Millimetre | UnitSystem::Inch => 360.0,
        UnitSystem::TenMicrometre => 36_000.0,
        UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 360_000.0,
    }
}
