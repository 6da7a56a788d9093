//! The text of control statements, with the blanks that must or may stand in them.

use crate::print::Printer;
use crate::print_expression;
use crate::program::{Condition, Statement};

impl Printer<'_, '_, '_> {
    /// A statement without the assignments that follow it.
    pub(crate) fn statement(&mut self, statement: &Statement) -> String {
        match statement {
            Statement::Goto(name) => format!("GOTO{}N{name}", self.separator()),
            Statement::If(condition, name) => {
                let mut text = self.condition(condition);
                if self.choices.chance(50) {
                    text.push_str("GOTO");
                    text.push_str(self.separator());
                }
                text + "N" + name
            }
            Statement::Call(name) => format!("CALL{}O{name}", self.separator()),
            Statement::Modin(name) => format!("MODIN{}O{name}", self.separator()),
            Statement::Rts => "RTS".to_owned(),
            Statement::Modout => "MODOUT".to_owned(),
            Statement::Noex => "NOEX".to_owned(),
            Statement::Macro(letter, code) => {
                let equal = self.style.all_characters
                    && self.style.profile.allows(turnspec_oracle::vocabulary::Feature::Expression)
                    && self.vary();
                format!("{letter}{}{code}", if equal { "=" } else { "" })
            }
        }
    }

    /// `IF` with its condition and what must stand behind it.
    fn condition(&mut self, condition: &Condition) -> String {
        match condition {
            Condition::Holds(expression) => {
                let expression = print_expression::text(self, expression);
                let before = if self.vary() { self.separator() } else { "" };
                let behind = if self.choices.chance(self.style.glue) { "" } else { self.separator() };
                format!("IF{before}[{expression}]{behind}")
            }
            Condition::Defined(name) => {
                let (before, behind) = (self.separator(), self.separator());
                format!("IF{before}{name}{behind}")
            }
        }
    }
}
