//! Carrying out assignments (execution, chapter 4, step 4), wherever they stand.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Label, RuleSet, Sink, Value};

use super::Interpreter;
use super::evaluate::push_number;
use super::fault::Fault;
use super::planted::{self, Bug};
use super::system::SystemVariable;
use super::words::{Code, Item, Operand, Parsed};

/// What an assignment stands in. Of local variables it decides how they are registered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Origin {
    /// A block of items or NOEX: a local variable is registered if its name has no entry.
    Item,
    /// CALL or a macro code that calls: it is always registered, for the program that is about to begin.
    Call,
    /// MODIN or one of its macro codes: it is always registered, for the mode that is about to begin.
    Mode,
    /// VSET, which assigns no local variable.
    Schedule,
    /// GET with a length; as an item.
    Field,
    /// GET of all that is left; as an item.
    Rest,
}

impl Origin {
    /// The rules of an assignment, and those of what it stands in.
    #[inline]
    pub fn rules(self, rules: RuleSet) -> RuleSet {
        match self {
            Self::Item | Self::Call | Self::Mode => rules,
            Self::Schedule => rules.with(SDF_17),
            Self::Field => rules.with(GPUT_01),
            Self::Rest => rules.with(GPUT_01).with(GPUT_03),
        }
    }
}

impl Interpreter<'_> {
    /// Carries out one assignment; nothing else has an effect here.
    #[inline]
    pub(super) fn assignment(
        &mut self,
        parsed: &Parsed,
        item: Item,
        origin: Origin,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        match item {
            Item::Word(..) | Item::Mnemonic => {}
            Item::Common { number, value } => {
                let value = self.compute(parsed, value)?;
                self.assign_common(number, value, origin, sink);
            }
            Item::System { variable, suffix, value } => {
                let suffix = self.left_suffix(parsed, variable, suffix)?;
                let value = self.compute(parsed, value)?;
                self.assign(variable, suffix, value, origin, sink)?;
            }
            Item::Comment { suffix, text } => self.assign_comment(parsed, suffix, text, origin, sink)?,
            Item::Local { name, value } => {
                let value = self.compute(parsed, value)?.real() + 0.0;
                self.assign_local(name, value, origin, sink)?;
            }
        }
        Ok(())
    }

    /// Assigns a common variable (E100L-CVAR-04).
    /// There is one set of them for all programs (E100L-CVAR-02).
    #[inline]
    pub(super) fn assign_common(&mut self, number: u8, value: Operand, origin: Origin, sink: &mut impl Sink) {
        const RULES: RuleSet = RuleSet::of(&[CVAR_04, TYPE_04]);
        let zero = if planted::is(Bug::NegativeZero) { -0.0 } else { 0.0 };
        let value = value.real() + zero;
        if let Some(slot) = self.state.common.get_mut(usize::from(number)) {
            *slot = value;
        }
        let mut name = Label::new("V");
        push_number(&mut name, number.into());
        self.emit(sink, origin.rules(RULES), Action::Variable { name, value: Value::Real(value) });
    }

    /// The suffix of a variable that is to be written, before the right side is evaluated.
    pub(super) fn left_suffix(
        &mut self,
        parsed: &Parsed,
        variable: SystemVariable,
        suffix: Option<Code>,
    ) -> Result<Option<usize>, Fault> {
        let Some(code) = suffix else { return Ok(None) };
        if let Some(rule) = variable.level_rule().filter(|_| self.options.level_one) {
            return Fault::raise(AlarmName::UserTaskLevel, rule);
        }
        let number = self.compute(parsed, code)?.number();
        self.suffix(variable, number).map(Some)
    }
}
