//! Output variables VDOUT (E100L-IOV-02, E100L-IOV-03) and the user alarms that three of them raise
//! (E100L-IOV-07, E100L-VUACM-02).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Label, RuleId, RuleSet, Sink, Text, UserAlarmC, Value};

use crate::engine::Interpreter;
use crate::engine::arithmetic::round::Rounding;
use crate::engine::assignment::Origin;
use crate::engine::fault::Fault;
use crate::engine::system::SystemVariable;
use crate::engine::variables::variable_label;
use crate::engine::words::Operand;

/// Whether VDOUT has a number.
pub fn output_exists(number: usize) -> bool {
    matches!(number, 1..=9 | 11..=19 | 21..=24 | 31..=39 | 41..=49 | 991..=993)
}

/// The range of an output, and the rule that gives it.
fn range(number: usize) -> (i64, i64, RuleId) {
    match number {
        9 | 19 | 39 | 49 => (0, 255, IOV_03),
        991..=993 => (1, 9999, IOV_07),
        _ => (0, 1, IOV_02),
    }
}

impl Interpreter<'_> {
    /// Assigns an output.
    pub(in crate::engine) fn assign_output(
        &mut self,
        number: usize,
        value: Operand,
        origin: Origin,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let (low, high, rule) = range(number);
        let value = value.number();
        // A value that rounds into the range lies within half a unit of it.
        let near = value.within(2, 2 * low - 1, 2 * high + 1);
        let value = Some(value.whole(1, Rounding::HalfAway)).filter(|_| near);
        let Some(value) = value.filter(|value| (low..=high).contains(value)) else {
            return Fault::raise(AlarmName::VariableRange, rule);
        };
        let code = u16::try_from(value).unwrap_or_default();
        let rules = match rule {
            IOV_03 => const { RuleSet::of(&[IOV_02, IOV_03, TYPE_06]) },
            IOV_07 => const { RuleSet::of(&[IOV_07, TYPE_06]) },
            _ => const { RuleSet::of(&[IOV_02, TYPE_06]) },
        };
        let name = variable_label(SystemVariable::Output, Some(number));
        let action = Action::Variable { name, value: Value::Integer(code.into()) };
        self.emit(sink, origin.rules(rules), action);
        match number {
            991 if self.setup.readings.user_alarm_c == UserAlarmC::Continues => {
                self.display(code, sink);
                Ok(())
            }
            991 => Err(self.user_alarm(AlarmName::UserAlarmC, code)),
            992 => Err(self.user_alarm(AlarmName::UserAlarmB, code)),
            993 => Err(self.user_alarm(AlarmName::UserAlarmA, code)),
            _ => Ok(()),
        }
    }

    /// A user alarm C that does not stop the program.
    fn display(&mut self, code: u16, sink: &mut impl Sink) {
        const RULES: RuleSet = RuleSet::of(&[VUACM_02, VUACM_03, IOV_07]);
        let number = AlarmName::UserAlarmC.number().unwrap_or_default();
        let text = Text::new(self.communication.comment.shown());
        self.emit_with(sink, RULES, self.known.user_alarm_c, Action::Message { number, code, text });
    }

    /// A user alarm with its code, and the comment if there is one.
    #[cold]
    fn user_alarm(&self, name: AlarmName, code: u16) -> Fault {
        let detail = match self.communication.comment.shown() {
            [] => code.to_string(),
            comment => format!("{code}:{}", Text::new(comment)),
        };
        Fault::about(name, VUACM_02, Label::new(&detail))
    }
}
