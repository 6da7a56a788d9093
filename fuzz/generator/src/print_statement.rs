//! The text of control statements, with the blanks that must or may stand in them.

use crate::print::Printer;
use crate::print_expression::{self, variable};
use crate::program::{Caret, Condition, Repetitions, Selection, Sent, Statement, Text};

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
            Statement::Lap(code, name) => format!("G{code}{}N{name}", self.separator()),
            Statement::Rts => "RTS".to_owned(),
            Statement::Modout => "MODOUT".to_owned(),
            Statement::Noex => "NOEX".to_owned(),
            Statement::Macro(letter, code) => {
                let equal = self.style.all_characters
                    && self.style.profile.allows(turnspec_oracle::vocabulary::Feature::Expression)
                    && self.vary();
                format!("{letter}{}{code}", if equal { "=" } else { "" })
            }
            Statement::Read(channel) => format!("READ{}{}", self.separator(), self.count(*channel)),
            Statement::Write(channel) => format!("WRITE{}{}", self.separator(), self.count(*channel)),
            Statement::Get(target, length) => {
                let mut text = format!("GET{}", self.separator());
                if let Some(target) = target {
                    text.push_str(&variable(self, target));
                }
                if let Some(length) = length {
                    text.push_str(&self.comma());
                    text.push_str(&self.count(*length));
                }
                text
            }
            Statement::Put(sent) => format!("PUT{}{}", self.separator(), self.sent(sent)),
            Statement::Vset => "VSET".to_owned(),
            Statement::Select(selection) => self.selection(selection),
            Statement::End => "END".to_owned(),
        }
    }

    /// A number of digits alone.
    fn count(&mut self, number: i64) -> String {
        let zeros = if self.vary() { "00" } else { "" };
        format!("{zeros}{number}")
    }

    /// A comma, with what may stand beside it.
    fn comma(&mut self) -> String {
        let before = if self.vary() { self.separator() } else { "" };
        let behind = if self.vary() { self.separator() } else { "" };
        format!("{before},{behind}")
    }

    fn sent(&mut self, sent: &Sent) -> String {
        match sent {
            Sent::Field(value, length) => {
                let value = variable(self, value);
                value + &self.comma() + &self.count(*length)
            }
            Sent::Blanks(length) => self.comma() + &self.count(*length),
            Sent::Text(text) => self.string(text),
            Sent::Codes(codes) => {
                codes.iter().fold("$".to_owned(), |text, code| text + &format!("{code:02X}"))
            }
        }
    }

    /// A string; CR, DEL and BS in it are no characters of it.
    pub(crate) fn string(&mut self, text: &Text) -> String {
        let (before, behind) = match text.caret {
            Caret::None => ("", ""),
            Caret::Before => ("^", ""),
            Caret::Behind => ("", "^"),
        };
        let tape = self.style.profile.allows(turnspec_oracle::vocabulary::Feature::TapeCode);
        let ignored = if tape && self.vary() { self.choices.pick(&["\u{7F}", "\u{8}", "\r"]) } else { "" };
        format!("{before}'{behind}{}{ignored}'", text.characters)
    }

    /// `PSELECT` with its items; commas behind the last one may be left out.
    fn selection(&mut self, selection: &Selection) -> String {
        let program = selection.program.as_ref().map(|name| format!("O{name}")).unwrap_or_default();
        let repetitions = match &selection.repetitions {
            Repetitions::Once => String::new(),
            Repetitions::Plain(number) => format!("Q{}", number.text()),
            Repetitions::Equal(expression) => format!("Q={}", print_expression::text(self, expression)),
            Repetitions::Blank(expression) => format!("Q {}", print_expression::text(self, expression)),
        };
        let mut items = vec![selection.file.clone(), program, selection.subprograms.clone(), repetitions];
        while items.last().is_some_and(String::is_empty) && !self.vary() {
            items.pop();
        }
        let mut text = "PSELECT".to_owned();
        for (place, item) in items.iter().enumerate() {
            let before = if place == 0 { self.separator().to_owned() } else { self.comma() };
            text.push_str(&before);
            text.push_str(item);
        }
        text
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
