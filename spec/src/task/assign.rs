//! Setting variables (E100L-CVAR-04, E100L-LVAR-13, E100L-TYPE-04, E100L-TYPE-05, E100L-TYPE-07, E100L-SVAR-02 to -10).

use super::evaluate;
use super::locals::Registration;
use super::memory::{barrier_datum_mut, droop_index, of_pair_mut};
use super::number::Number;
use super::read::suffix_value;
use crate::controls::e100l::system_variables::{Axis, Quantity, SystemVariable};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::quantity::{self, Exact, ratio, whole};
use crate::state::State;
use crate::syntax::{Expression, Variable};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Angle, FrameCause, Label, Length, RuleSet, UnitSystem, Value};

/// Carries an assignment out; its events.
pub fn assign(
    target: &Variable,
    value: &Expression,
    registration: Registration,
    state: &mut State,
) -> Outcome<Vec<Emission>> {
    match target {
        Variable::Local(name) => {
            // E100L-LVAR-13: a real, without negative zero.
            let value = evaluate(value, state)?.real() + 0.0;
            let rules = state.memory.locals.set(*name, value, registration)?;
            let event = variable_event(name.as_str(), Value::Real(value), &[LVAR_13, TYPE_04]);
            Ok(vec![event.rules(RuleSet::of(rules))])
        }
        Variable::Common(number) => {
            let value = state.memory.set_common(*number, evaluate(value, state)?.real());
            Ok(vec![variable_event(&format!("V{number}"), Value::Real(value), &[CVAR_04, TYPE_04])])
        }
        Variable::System(variable, suffix) => {
            let number = suffix_value(variable, suffix.as_ref(), state)?;
            let value = evaluate(value, state)?;
            system_variable(variable, number, value, state)
        }
    }
}

fn variable_event(name: &str, value: Value, rules: &[crate::vocabulary::RuleId]) -> Emission {
    Emission::new(Action::Variable { name: Label::new(name), value }, RuleSet::of(rules))
}

fn system_variable(
    variable: &SystemVariable,
    number: usize,
    value: Number,
    state: &mut State,
) -> Outcome<Vec<Emission>> {
    let increments = increments(variable, value, state.setup.unit_system);
    let (lowest, highest) = range(variable, state.setup.unit_system);
    if !(lowest..=highest).contains(&increments) {
        return fail(AlarmName::VariableRange, SVTAB_01);
    }
    let numbered = variable.suffix(state.setup.options.offset_sets).is_some();
    let offset_zero = numbered && number == 0;
    if offset_zero && increments != 0 {
        // E100L-TOOL-03: number 00 is no offset.
        return fail(AlarmName::VariableRange, TOOL_03);
    }
    let name = if numbered { format!("{}[{number}]", variable.name) } else { variable.name.to_owned() };
    let rule = variable.rule.unwrap_or(SVTAB_01);
    let before = (state.frame.zero_offset, state.frame.zero_shift, state.frame.active_offset());
    let stored = store(variable.quantity, number, increments, state);
    let conversion = if matches!(variable.quantity, Quantity::Droop(_)) { TYPE_07 } else { TYPE_05 };
    let mut emissions = vec![variable_event(&name, stored, &[rule, conversion])];
    let frame = &state.frame;
    if frame.zero_offset != before.0 {
        emissions.push(Emission::new(frame.event(FrameCause::ZeroOffset), RuleSet::of(&[SVAR_03, COORD_03])));
    } else if frame.zero_shift != before.1 {
        emissions.push(Emission::new(frame.event(FrameCause::ZeroShift), RuleSet::of(&[SVAR_04])));
    } else if frame.active_offset() != before.2 {
        let event = Emission::new(frame.event(FrameCause::ToolOffset), RuleSet::of(&[SVAR_05]));
        emissions.push(event.reading(state.setup.readings.tool_offset));
    }
    Ok(emissions)
}

/// E100L-TYPE-05, E100L-TYPE-07: the value in increments, cut for an integer, rounded for a real.
fn increments(variable: &SystemVariable, value: Number, system: UnitSystem) -> i64 {
    let factor = match variable.quantity {
        Quantity::Droop(_) => whole(1),
        Quantity::ZeroOffset(Axis::C) | Quantity::ZeroShift(Axis::C) => angle_factor(system),
        _ => length_factor(system),
    };
    let exact = value.exact() * factor;
    match value {
        Number::Integer(_) => quantity::narrow(&quantity::cut(&exact)),
        Number::Real(_) => quantity::round_narrow(&exact),
    }
}

fn length_factor(system: UnitSystem) -> Exact {
    match system {
        UnitSystem::Micrometre => whole(1),
        UnitSystem::TenMicrometre => whole(10),
        UnitSystem::Millimetre => whole(1_000),
        UnitSystem::TenThousandthInch => ratio(254, 100),
        UnitSystem::Inch => whole(25_400),
    }
}

fn angle_factor(system: UnitSystem) -> Exact {
    whole(match system {
        UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 1,
        UnitSystem::TenMicrometre => 10,
        UnitSystem::Millimetre | UnitSystem::Inch => 1_000,
    })
}

fn range(variable: &SystemVariable, system: UnitSystem) -> (i64, i64) {
    match variable.quantity {
        Quantity::Droop(_) if system.is_inch() => (0, 10_000),
        _ => variable.range,
    }
}

fn store(quantity: Quantity, number: usize, increments: i64, state: &mut State) -> Value {
    let amount = increments * 1_000;
    match quantity {
        Quantity::ZeroOffset(axis) => return of_frame(&mut state.frame.zero_offset, axis, amount),
        Quantity::ZeroShift(axis) => return of_frame(&mut state.frame.zero_shift, axis, amount),
        Quantity::ToolOffset(axis) => {
            if let Some(entry) = state.frame.tool_offsets.get_mut(number) {
                return of_frame(entry, axis, amount);
            }
        }
        Quantity::NoseRadius(axis) => {
            if let Some(entry) = state.memory.nose_radii.get_mut(number) {
                *of_pair_mut(entry, axis) = amount;
            }
        }
        Quantity::PositiveLimit(axis) => state.travel_limit_mut(axis).positive = Some(amount),
        Quantity::NegativeLimit(axis) => state.travel_limit_mut(axis).negative = Some(amount),
        Quantity::Droop(axis) => {
            if let Some(entry) = state.memory.droop.get_mut(droop_index(axis)) {
                *entry = u16::try_from(increments).unwrap_or_default();
            }
            return Value::Integer(i32::try_from(increments).unwrap_or_default());
        }
        Quantity::Barrier(datum) => *barrier_datum_mut(&mut state.memory.barriers, datum) = Length(amount),
        Quantity::PitchError(axis) => {
            if let Some(entry) = state.memory.pitch_errors.get_mut(number) {
                *of_pair_mut(entry, axis) = amount;
            }
        }
        Quantity::Pitch(axis) => *of_pair_mut(&mut state.memory.pitch, axis) = amount,
        // Read-only variables were refused by the grammar.
        Quantity::Target(_)
        | Quantity::Actual(_)
        | Quantity::ActiveOffset(_)
        | Quantity::ActiveOffsetNumber
        | Quantity::ActiveTool
        | Quantity::Restart
        | Quantity::Pi
        | Quantity::FullTurn => {}
    }
    Value::Length(Length(amount))
}

fn of_frame(amounts: &mut Amounts, axis: Axis, amount: i64) -> Value {
    match axis {
        Axis::X => amounts.x = amount,
        Axis::Z => amounts.z = amount,
        Axis::W => amounts.w = amount,
        Axis::C => {
            amounts.c = amount;
            return Value::Angle(Angle(amount));
        }
    }
    Value::Length(Length(amount))
}
