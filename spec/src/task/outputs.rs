//! Output signals and user alarms (E100L-IOV-02, E100L-IOV-03, E100L-IOV-07, E100L-VUACM-01 to -05).

use super::evaluate;
use super::number::Number;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::quantity::round_narrow;
use crate::state::State;
use crate::syntax::{Characters, Expression, StringForm};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Label, RuleId, RuleSet, Text, UserAlarmC, Value};

/// E100L-VUACM-01: the positions of the comment, each empty until it is set.
#[derive(Clone, Debug, Default)]
pub struct Comment([Option<u8>; 16]);

impl Comment {
    /// E100L-VUACM-03: what is displayed, up to the first position that was not set.
    fn displayed(&self) -> Vec<u8> {
        self.0.iter().map_while(|position| *position).collect()
    }

    /// Writes characters from a position on, which must all have room.
    fn write(&mut self, position: usize, codes: &[u8]) -> Option<()> {
        let places = self.0.get_mut(position.checked_sub(1)?..)?.get_mut(..codes.len())?;
        places.iter_mut().zip(codes).for_each(|(place, code)| *place = Some(*code));
        Some(())
    }
}

/// E100L-VUACM-01: characters go to the comment; the event.
pub fn comment(position: &Expression, characters: &Characters, state: &mut State) -> Outcome<Emission> {
    let number = round_narrow(&evaluate(position, state)?.exact());
    let Some(position) = usize::try_from(number).ok().filter(|number| (1..=16).contains(number)) else {
        return fail(AlarmName::VariableSuffix, VUACM_01);
    };
    if state.memory.comment.write(position, &characters.codes).is_none() {
        return fail(AlarmName::StringTooLong, VUACM_01);
    }
    let name = Label::new(&format!("VUACM[{position}]"));
    let value = Value::Text(Text::new(&characters.codes));
    let rules = RuleSet::of(&[VUACM_01]);
    Ok(Emission::new(Action::Variable { name, value }, rules)
        .rule_if(characters.form == StringForm::Codes, VUACM_04)
        .rule_if(characters.form == StringForm::LowerCase, VUACM_05))
}

/// E100L-IOV-02: an output is set; what shows of it, and the alarm of an alarm output.
pub fn output(number: usize, value: Number, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    // E100L-TYPE-06.
    let value = round_narrow(&value.exact());
    let (highest, rules): (i64, &[RuleId]) = match number {
        991..=993 => (9999, &[IOV_07, TYPE_06]),
        9 | 19 | 39 | 49 => (255, &[IOV_02, IOV_03, TYPE_06]),
        _ => (1, &[IOV_02, TYPE_06]),
    };
    let lowest = i64::from(highest == 9999);
    if !(lowest..=highest).contains(&value) {
        return fail(
            AlarmName::VariableRange,
            match highest {
                9999 => IOV_07,
                255 => IOV_03,
                _ => IOV_02,
            },
        );
    }
    let code = u16::try_from(value).unwrap_or_default();
    let name = Label::new(&format!("VDOUT[{number}]"));
    let variable = Action::Variable { name, value: Value::Integer(i32::from(code)) };
    emissions.push(Emission::new(variable, RuleSet::of(rules)));
    match number {
        991 => {
            let reading = state.setup.readings.user_alarm_c;
            if reading == UserAlarmC::Stops {
                return Err(user_alarm(AlarmName::UserAlarmC, code, state).reading(reading));
            }
            emissions.push(message(code, state).reading(reading));
            Ok(())
        }
        992 => Err(user_alarm(AlarmName::UserAlarmB, code, state)),
        993 => Err(user_alarm(AlarmName::UserAlarmA, code, state)),
        _ => Ok(()),
    }
}

/// E100L-VUACM-02: code and comment as the detail of an alarm.
fn user_alarm(name: AlarmName, code: u16, state: &State) -> Fault {
    let comment = state.memory.comment.displayed();
    let detail =
        if comment.is_empty() { code.to_string() } else { format!("{code}:{}", Text::new(&comment)) };
    Fault::about(name, VUACM_02, &detail)
}

/// E100L-VUACM-02: user alarm C is displayed, and the program goes on.
fn message(code: u16, state: &State) -> Emission {
    let text = Text::new(&state.memory.comment.displayed());
    let number = AlarmName::UserAlarmC.number().unwrap_or_default();
    Emission::new(Action::Message { number, code, text }, RuleSet::of(&[VUACM_02, VUACM_03, IOV_07]))
}
