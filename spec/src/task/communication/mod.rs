//! Data communication: READ and WRITE exchange characters with devices, GET and PUT take them from and put them into
//! two areas (E100L-RDWR-01 to -05, E100L-GPUT-01 to -13).

mod areas;
mod form;
mod received;

pub use areas::Areas;

use super::assign::{set, target};
use super::locals::Registration;
use super::read;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::state::State;
use crate::syntax::{Communication, Variable};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Label, RuleId, RuleSet, Text};

/// Carries a statement out.
pub fn communicate(
    statement: &Communication,
    registration: Registration,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    let setup = state.setup;
    if setup.options.user_task < 2 {
        return Err(Fault::about(AlarmName::UserTaskLevel, UT_03, statement.keyword()));
    }
    match statement {
        Communication::Read(channel) => state.memory.areas.read(*channel, setup),
        Communication::Write(channel) => {
            emissions.push(write(*channel, state));
            Ok(())
        }
        Communication::Skip(length) => {
            let length = state.memory.areas.field(Some(*length))?.len();
            state.memory.areas.pass(length);
            Ok(())
        }
        Communication::Get(variable, length) => get(variable, *length, registration, state, emissions),
        Communication::Put(variable, length) => {
            let amount = read::amount(variable, state)?;
            let number = form::number(amount, setup.unit_system, setup.readings.put_real);
            let dimensional = !matches!(amount, read::Amount::Number(_));
            state.memory.areas.append(&form::field(&number, *length)?, dimensional)
        }
        Communication::Append(codes) => state.memory.areas.append(codes, false),
    }
}

/// E100L-RDWR-02, E100L-RDWR-04: what was put goes to the device, with the end code behind it.
fn write(channel: u8, state: &mut State) -> Emission {
    let (codes, dimensional) = state.memory.areas.send();
    let setup = state.setup;
    let device = Label::new(&format!("CN{channel}"));
    let output = Action::Output { device, text: Text::new(&codes), end_code: setup.parameters.end_code };
    let event = Emission::new(output, RuleSet::of(&[RDWR_02, RDWR_04]));
    if dimensional { event.reading(setup.readings.put_real) } else { event }
}

/// E100L-GPUT-01, E100L-GPUT-03: a number of the READ area goes to a variable.
fn get(
    variable: &Variable,
    length: Option<usize>,
    registration: Registration,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    let target = target(variable, state)?;
    let field = state.memory.areas.field(length)?;
    let (number, passed) = (received::number(field)?, field.len());
    state.memory.areas.pass(passed);
    let before = emissions.len();
    let result = set(target, number, registration, state, emissions);
    let rules: &[RuleId] = if length.is_some() { &[GPUT_01] } else { &[GPUT_01, GPUT_03] };
    for event in emissions.iter_mut().skip(before) {
        event.set_variable_by(RuleSet::of(rules));
    }
    result
}
