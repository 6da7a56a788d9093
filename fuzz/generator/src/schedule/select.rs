//! PSELECT: which program, how often, and how the statement is spelled.

use std::rc::Rc;

use turnspec_oracle::vocabulary::Feature;

use super::main_program::{Effect, Main};
use crate::builder::Builder;
use crate::number::Number;
use crate::program::{Repetitions, Selection, Statement, Value};

impl Builder<'_, '_, '_> {
    /// PSELECT of a program that was selected before, or of a new one.
    pub(super) fn select_program(&mut self) {
        let label = self.state.control.take_label();
        let fits: Vec<Rc<Main>> =
            self.state.schedule.mains.iter().filter(|main| self.may_run(main, 3)).cloned().collect();
        let main = if !fits.is_empty() && self.choices.chance(40) {
            fits[self.choices.below(fits.len())].clone()
        } else {
            self.new_main()
        };
        self.begin();
        let times = match main.effect {
            Effect::Grown => 1,
            _ => self.choices.pick(&[1, 1, 2, 3]),
        };
        let times = if self.may_run(&main, times) { times } else { 1 };
        let selection = self.selection_of(&main, times);
        if let Some(label) = label {
            self.set_label(label);
        }
        self.schedule_line(Statement::Select(selection), Vec::new());
        self.after_main(&main, times);
    }

    /// Whether a program may run so often from here.
    fn may_run(&self, main: &Main, times: i64) -> bool {
        match &main.effect {
            Effect::Grown => times == 1,
            Effect::Again(called) => self.is_usable(called, false),
            Effect::Short(short) => !self.state.control.steady && self.bears(*short, times),
        }
    }

    /// The state after a program.
    fn after_main(&mut self, main: &Main, times: i64) {
        match &main.effect {
            Effect::Grown => {}
            Effect::Again(called) => self.after_program(called),
            Effect::Short(short) => self.after_short(*short, times),
        }
    }

    fn selection_of(&mut self, main: &Main, times: i64) -> Selection {
        let omitted = main.first && self.choices.chance(50);
        let file = self.file_text(main.file, "A", "MIN");
        let subprograms = main.subprograms.map(|file| self.file_text(file, "", "SUB")).unwrap_or_default();
        Selection {
            file,
            program: main.name.clone().filter(|_| !omitted),
            subprograms,
            repetitions: self.repetitions(times),
        }
    }

    /// A file name with its parts that are not the usual ones, and some of the others.
    fn file_text(&mut self, file: &str, stem: &str, extension: &str) -> String {
        let (name, kind) = file.split_once('.').unwrap_or((file, extension));
        let usual = self.choices.chance(65);
        let mut text = String::new();
        if !self.state.is_eia() && self.choices.chance(20) {
            text.push_str("MD1:");
        }
        if name != stem || !usual {
            text.push_str(name);
        }
        if kind != extension || self.choices.chance(50) {
            text.push('.');
            text.push_str(kind);
        }
        text
    }

    /// Q in one of its forms.
    fn repetitions(&mut self, times: i64) -> Repetitions {
        if times == 1 && self.choices.chance(60) {
            return Repetitions::Once;
        }
        let text = !self.state.is_eia() && self.allows(Feature::Expression);
        let number = Number::whole(times);
        match self.choices.below(4) {
            0 if text => Repetitions::Equal(match self.value(number).0 {
                Value::Expression(expression) => expression,
                Value::Plain(number) => crate::expression::Expression::Constant(number),
            }),
            1 if text => {
                let variables = std::mem::replace(&mut self.expressions, 70);
                let value = self.value(number).0;
                self.expressions = variables;
                match value {
                    Value::Expression(expression) => Repetitions::Blank(expression),
                    Value::Plain(number) => Repetitions::Plain(number),
                }
            }
            2 => Repetitions::Plain(Number::decimal(times * 10 - 4, 1)),
            _ => Repetitions::Plain(number),
        }
    }
}
