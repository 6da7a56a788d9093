//! CALL and the macro codes that call; programs that run once, again, within themselves.

use std::rc::Rc;

use turnspec_oracle::vocabulary::{Feature, Label};

use crate::builder::Builder;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::{Item, Line, Statement, Value};

use super::local::Owner;
use super::passes::compare;
use super::steady::Called;

/// Macro codes that call.
const CALLING: &[(char, i64, i64)] = &[('G', 171, 171), ('G', 205, 214), ('M', 321, 325), ('M', 341, 360)];

/// Macro codes that begin a modal call.
const MODAL: &[(char, i64, i64)] = &[('G', 161, 170)];

impl Builder<'_, '_, '_> {
    /// A call.
    pub(super) fn call(&mut self) {
        let control = &self.state.control;
        let known: Vec<_> =
            control.programs.iter().filter(|called| self.is_usable(called, false)).cloned().collect();
        let shared = control.shared;
        if !known.is_empty() && (shared || self.choices.chance(50)) {
            let called = known[self.choices.below(known.len())].clone();
            return self.call_again(&called);
        }
        let control = &self.state.control;
        let depth = control.depth + control.modes.len() + 1;
        if shared || depth > usize::from(self.state.setup.parameters.call_depth) {
            return self.harmless_block();
        }
        if control.steady || self.choices.chance(35) {
            let nature = self.nature(false);
            let called = self.shared_program(nature);
            return if self.is_usable(&called, false) {
                self.call_again(&called)
            } else {
                self.harmless_block()
            };
        }
        self.call_once();
    }

    /// A call of a program that is written for it.
    fn call_once(&mut self) {
        self.begin();
        let name = self.program_name();
        let owner = Owner::Program(self.state.control.depth + 1);
        let items = self.free_arguments(owner);
        let statement = self.calling(&name, false);
        self.statement(statement, items);
        let lines = self.write_program(|builder| {
            for _ in 0..=builder.choices.below(5) {
                builder.grow_block();
            }
        });
        self.state.control.programs.push(Rc::new(Called { name, lines, again: None }));
    }

    /// A call of a program that was written before.
    fn call_again(&mut self, called: &Called) {
        self.begin();
        let items = self.bound_arguments(called, Owner::Program(self.state.control.depth + 1));
        let statement = self.calling(&called.name, false);
        self.statement(statement, items);
        self.state.control.remove(Owner::Program(self.state.control.depth + 1));
        self.after_program(called);
    }

    /// `CALL` or `MODIN` of a program, or a macro code.
    pub(super) fn calling(&mut self, name: &str, modal: bool) -> Statement {
        let code = self.choices.chance(25) && self.allows(Feature::MacroCode);
        if code && let Some((letter, number)) = self.macro_code(name, modal) {
            return Statement::Macro(letter, number);
        }
        if modal { Statement::Modin(name.to_owned()) } else { Statement::Call(name.to_owned()) }
    }

    /// A macro code that calls this program: one that was given to it, or one that is free.
    fn macro_code(&mut self, name: &str, modal: bool) -> Option<(char, i64)> {
        let runs = if modal { MODAL } else { CALLING };
        let (letter, first, last) = self.choices.pick(runs);
        let number = self.choices.within(first, last);
        let wanted = Label::new(&format!("O{name}"));
        let given = self.state.setup.macros.entry(format!("{letter}{number}")).or_insert(wanted);
        (*given == wanted).then_some((letter, number))
    }

    /// Assignments of any known values, to local and common variables.
    pub(super) fn free_arguments(&mut self, owner: Owner) -> Vec<Item> {
        let mut items = Vec::new();
        if self.state.is_eia() || !self.allows(Feature::Expression) {
            return items;
        }
        for _ in 0..self.choices.below(4) {
            let (expression, value) = self.known_value(25);
            if self.allows(Feature::LocalVariable) && self.choices.chance(80) {
                let name = self.some_name();
                self.state.control.register(name, Some(value), owner);
                items.push(Item::Assignment(Variable::Local(name), expression));
            } else if self.allows(Feature::Variable) {
                let number = self.choices.within(1, 9) as u8;
                self.state.common.insert(number, value);
                self.state.control.now_known(number);
                items.push(Item::Assignment(Variable::Common(number), expression));
            }
            let room = self.room;
            self.state.begin_block();
            self.room = room;
        }
        items
    }

    /// The assignments that a program needs, within their bounds.
    pub(super) fn bound_arguments(&mut self, called: &Called, owner: Owner) -> Vec<Item> {
        let mut items = Vec::new();
        let Some(again) = &called.again else { return items };
        for (name, low, high) in &again.arguments {
            let number = Number::whole(self.choices.within(*low, *high));
            let (value, _) = self.value(number);
            let expression = match value {
                Value::Expression(expression) => expression,
                Value::Plain(number) => Expression::Constant(number),
            };
            items.push(Item::Assignment(Variable::Local(name), expression));
            self.state.control.register(name, None, owner);
            self.state.begin_block();
        }
        items
    }

    /// The blocks of a program that is called here, from behind its name on.
    pub(super) fn write_program(&mut self, body: impl FnOnce(&mut Self)) -> Vec<Line> {
        let lines = std::mem::take(&mut self.lines);
        let names = std::mem::take(&mut self.state.names);
        let tail = std::mem::take(&mut self.state.control.tail);
        self.state.control.depth += 1;
        let depth = self.state.control.depth;
        self.state.control.deepest = self.state.control.deepest.max(depth);
        body(self);
        self.settle_label();
        self.statement(Statement::Rts, Vec::new());
        self.state.control.remove(Owner::Program(depth));
        self.state.control.depth -= 1;
        let mut written = std::mem::replace(&mut self.lines, lines);
        written.append(&mut self.state.control.tail);
        self.state.control.tail = tail;
        self.state.names = names;
        written
    }

    /// A program that calls itself until a variable is used up, seldom more often than may be.
    pub(super) fn recursion(&mut self) {
        let Some(counter @ Variable::Common(_)) = self.counter() else { return self.call() };
        let most = i64::from(self.state.setup.parameters.call_depth);
        let times = if self.choices.chance(10) { most + 1 } else { self.choices.within(1, most.min(6)) };
        self.set(&counter, times);
        self.begin();
        let name = self.program_name();
        let statement = self.calling(&name, false);
        self.statement(statement, Vec::new());
        self.forget(&counter);
        let steady = std::mem::replace(&mut self.state.control.steady, true);
        self.forget_changing();
        let lines = self.write_program(|builder| {
            let one = Expression::Constant(Number::whole(1));
            let less = Expression::binary(Operator::Subtract, Expression::Variable(counter.clone()), one);
            builder.begin();
            builder.push(vec![Item::Assignment(counter.clone(), less)]);
            let end = builder.new_name();
            builder.statement(Statement::If(compare(Operator::Le, &counter, 0), end.clone()), Vec::new());
            builder.harmless_block();
            builder.statement(Statement::Call(name.clone()), Vec::new());
            if builder.choices.chance(50) {
                builder.harmless_block();
            }
            builder.set_label(end);
        });
        self.state.control.steady = steady;
        self.known(&counter, 0);
        self.state.control.programs.push(Rc::new(Called { name, lines, again: None }));
    }

    /// A program of these lines.
    pub(crate) fn raw_program(&mut self, lines: &[&str]) -> String {
        let name = self.program_name();
        self.named_program(name.clone(), lines);
        name
    }

    /// The name of a program that is to come.
    pub(crate) fn new_program_name(&mut self) -> String {
        self.program_name()
    }

    /// A program of this name, whether another one has it or not.
    pub(crate) fn named_program(&mut self, name: String, lines: &[&str]) {
        let lines = lines.iter().map(|line| Line::Raw(line.as_bytes().to_vec())).collect();
        self.state.control.jumps = true;
        self.state.control.programs.push(Rc::new(Called { name, lines, again: None }));
    }
}
