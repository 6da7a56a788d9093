//! Setting variables (E100L-CVAR-04, E100L-LVAR-13, E100L-TYPE-04, E100L-TYPE-05, E100L-TYPE-07, E100L-SVAR-02 to -10).

use super::evaluate;
use super::locals::Registration;
use super::memory::{barrier_datum_mut, droop_index, of_pair_mut};
use super::number::Number;
use super::outputs;
use super::read::suffix_value;
use crate::controls::e100l::system_variables::{Axis, Measure, Quantity, SystemVariable};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::quantity::{self, Exact, ratio, whole};
use crate::state::State;
use crate::syntax::{Expression, Variable};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Angle, FrameCause, Label, Length, RuleSet, UnitSystem, Value};

/// What an assignment sets, its suffix evaluated.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    /// A common variable.
    Common(u8),
    /// A local variable.
    Local(Label),
    /// A system or output variable, with the number in brackets, 0 for one without.
    System(&'static SystemVariable, usize),
}

/// What a variable on the left side means.
pub fn target(variable: &Variable, state: &mut State) -> Outcome<Target> {
    Ok(match variable {
        Variable::Common(number) => Target::Common(*number),
        Variable::Local(name) => Target::Local(*name),
        Variable::System(variable, suffix) => {
            Target::System(variable, suffix_value(variable, suffix.as_ref(), state)?)
        }
    })
}

/// Carries an assignment out, the left side first.
pub fn assign(
    variable: &Variable,
    value: &Expression,
    registration: Registration,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    let target = target(variable, state)?;
    let value = evaluate(value, state)?;
    set(target, value, registration, state, emissions)
}

/// Sets a variable; its events.
pub fn set(
    target: Target,
    value: Number,
    registration: Registration,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    match target {
        Target::Local(name) => {
            // E100L-LVAR-13: a real, without negative zero.
            let value = value.real() + 0.0;
            let rules = state.memory.locals.set(name, value, registration)?;
            let event = variable_event(name.as_str(), Value::Real(value), &[LVAR_13, TYPE_04]);
            emissions.push(event.rules(RuleSet::of(rules)));
        }
        Target::Common(number) => {
            let value = state.memory.set_common(number, value.real());
            emissions.push(variable_event(&format!("V{number}"), Value::Real(value), &[CVAR_04, TYPE_04]));
        }
        Target::System(SystemVariable { quantity: Quantity::Output, .. }, number) => {
            outputs::output(number, value, state, emissions)?;
        }
        Target::System(variable, number) => system_variable(variable, number, value, state, emissions)?,
    }
    Ok(())
}

fn variable_event(name: &str, value: Value, rules: &[crate::vocabulary::RuleId]) -> Emission {
    Emission::new(Action::Variable { name: Label::new(name), value }, RuleSet::of(rules))
}

fn system_variable(
    variable: &SystemVariable,
    number: usize,
    value: Number,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    let increments = increments(variable, value, state.setup.unit_system);
    let (lowest, highest) = range(variable, state.setup.unit_system);
    if !(lowest..=highest).contains(&increments) {
        return fail(AlarmName::VariableRange, SVTAB_01);
    }
    let numbered = variable.has_suffix();
    let offset_zero = numbered && number == 0;
    if offset_zero && increments != 0 {
        // E100L-TOOL-03: number 00 is no offset.
        return fail(AlarmName::VariableRange, TOOL_03);
    }
    let name = if numbered { format!("{}[{number}]", variable.name) } else { variable.name.to_owned() };
    let rule = variable.rule.unwrap_or(SVTAB_01);
    let before = (state.frame.zero_offset, state.frame.zero_shift, state.frame.active_offset());
    let stored = store(variable, number, increments, state);
    let conversion = if variable.measure() == Measure::Plain { TYPE_07 } else { TYPE_05 };
    emissions.push(variable_event(&name, stored, &[rule, conversion]));
    let frame = &state.frame;
    if frame.zero_offset != before.0 {
        emissions.push(Emission::new(frame.event(FrameCause::ZeroOffset), RuleSet::of(&[SVAR_03, COORD_03])));
    } else if frame.zero_shift != before.1 {
        emissions.push(Emission::new(frame.event(FrameCause::ZeroShift), RuleSet::of(&[SVAR_04])));
    } else if frame.active_offset() != before.2 {
        let event = Emission::new(frame.event(FrameCause::ToolOffset), RuleSet::of(&[SVAR_05]));
        emissions.push(event.reading(state.setup.readings.tool_offset));
    }
    Ok(())
}

/// E100L-TYPE-05, E100L-TYPE-07: the value in increments, cut for an integer, rounded for a real.
fn increments(variable: &SystemVariable, value: Number, system: UnitSystem) -> i64 {
    let factor = match variable.measure() {
        Measure::Plain => whole(1),
        Measure::Angle => angle_factor(system),
        Measure::Length => length_factor(system),
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

fn store(variable: &SystemVariable, number: usize, increments: i64, state: &mut State) -> Value {
    let amount = increments * 1_000;
    match variable.quantity {
        Quantity::ZeroOffset(axis) => set_axis(&mut state.frame.zero_offset, axis, amount),
        Quantity::ZeroShift(axis) => set_axis(&mut state.frame.zero_shift, axis, amount),
        Quantity::ToolOffset(axis) => {
            if let Some(entry) = state.frame.tool_offsets.get_mut(number) {
                set_axis(entry, axis, amount);
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
        }
        Quantity::Interference(_, measure) => {
            state.memory.interference.set(variable.name, number, measure, increments);
        }
        Quantity::Barrier(datum) => *barrier_datum_mut(&mut state.memory.barriers, datum) = Length(amount),
        Quantity::PitchError(axis) => {
            if let Some(entry) = state.memory.pitch_errors.get_mut(number) {
                *of_pair_mut(entry, axis) = amount;
            }
        }
        Quantity::Pitch(axis) => *of_pair_mut(&mut state.memory.pitch, axis) = amount,
        // Read-only variables were refused by the grammar, outputs are set elsewhere.
        Quantity::Target(_)
        | Quantity::Actual(_)
        | Quantity::ActiveOffset(_)
        | Quantity::ActiveOffsetNumber
        | Quantity::ActiveTool
        | Quantity::Restart
        | Quantity::Input
        | Quantity::Output
        | Quantity::InputBit
        | Quantity::OutputBit
        | Quantity::Pi
        | Quantity::FullTurn => {}
    }
    match variable.measure() {
        Measure::Plain => Value::Integer(i32::try_from(increments).unwrap_or_default()),
        Measure::Length => Value::Length(Length(amount)),
        Measure::Angle => Value::Angle(Angle(amount)),
    }
}

fn set_axis(amounts: &mut Amounts, axis: Axis, amount: i64) {
    match axis {
        Axis::X => amounts.x = amount,
        Axis::Z => amounts.z = amount,
        Axis::C => amounts.c = amount,
        Axis::W => amounts.w = amount,
    }
}
