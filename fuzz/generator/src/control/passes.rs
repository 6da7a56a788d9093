//! Loops with a counting variable, and loops without end.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::{Condition, Item, Statement};
use crate::state::{Axis, Mode};

use super::local;
use super::steady::Bounded;

/// How a loop counts and where it asks.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// Up, asking at the end.
    Until,
    /// Up, asking at the beginning.
    While,
    /// Down to zero.
    Down,
}

impl Builder<'_, '_, '_> {
    /// A loop whose body runs a few times.
    pub(super) fn passes(&mut self) {
        let Some(counter) = self.counter() else { return self.anchor() };
        let form = self.choices.pick(&[Form::Until, Form::While, Form::Down]);
        let count = self.choices.within(1, 5);
        self.set(&counter, if form == Form::Down { count } else { 0 });
        let before = self.state.control.clone();
        self.state.control.steady = true;
        self.state.control.loops += 1;
        self.state.threads.forget();
        self.forget_changing();
        self.forget(&counter);
        let bounded = Bounded { variable: counter.clone(), low: 0, high: count };
        self.state.control.bounded.push(bounded);
        let (first, behind) = (self.new_name(), self.new_name());
        self.set_label(first.clone());
        if form == Form::While {
            let asked = compare(Operator::Ge, &counter, count);
            self.statement(Statement::If(asked, behind.clone()), Vec::new());
        }
        self.body();
        self.count(&counter, if form == Form::Down { Operator::Subtract } else { Operator::Add });
        match form {
            Form::Until => {
                self.statement(Statement::If(compare(Operator::Lt, &counter, count), first), Vec::new());
            }
            Form::While => self.statement(Statement::Goto(first), Vec::new()),
            Form::Down => {
                let above = compare(Operator::Gt, &counter, 0);
                let bare = Condition::Holds(Expression::Variable(counter.clone()));
                let asked = if self.choices.chance(50) { above } else { bare };
                self.statement(Statement::If(asked, first), Vec::new());
            }
        }
        let control = &mut self.state.control;
        (control.steady, control.loops, control.bounded) = (before.steady, before.loops, before.bounded);
        self.known(&counter, if form == Form::Down { 0 } else { count });
        if form == Form::While {
            self.labelled(behind);
        }
    }

    /// What a loop repeats.
    fn body(&mut self) {
        self.anchor();
        let noses = self.allows(Feature::RadiusCompensation) && self.state.control.modes.is_empty();
        if noses && !self.state.barriers.is_watched() && self.choices.chance(12) {
            return self.contour_in_passing();
        }
        for _ in 0..self.choices.below(4) {
            self.grow_block();
        }
        if self.choices.chance(30) {
            self.varied();
        }
    }

    /// A loop of travels in G91.
    pub(super) fn steps(&mut self) {
        let Some(counter) = self.counter() else { return self.anchor() };
        let count = self.choices.within(2, 6);
        self.set(&counter, 0);
        self.begin();
        let linear = self.allows(Feature::Linear) && self.allows(Feature::Feed);
        let mode = if linear && self.choices.chance(70) { Mode::Linear } else { Mode::Rapid };
        let mut items = vec![self.incremental_word(true), Item::g(mode as i64)];
        if mode == Mode::Linear {
            items.push(self.feed_word());
        }
        let mut travels = [0; 2];
        let from = self.present();
        for axis in [Axis::X, Axis::Z] {
            let start = self.state.program(axis);
            let end = self.state.somewhere(axis, self.choices);
            let (item, travel) = self.plain_length(axis.address(), (end - start) / count);
            travels[axis as usize] = travel;
            items.push(item);
        }
        let name = self.new_name();
        self.set_label(name.clone());
        self.state.mode = mode;
        for axis in [Axis::X, Axis::Z] {
            let end = self.state.program(axis) + count * travels[axis as usize];
            self.state.move_to(axis, end);
        }
        self.travelled(from, self.present(), None);
        self.state.after_cutting = mode == Mode::Linear;
        self.push(items);
        let before = self.state.control.steady;
        self.forget(&counter);
        self.state.control.steady = true;
        if self.choices.chance(40) {
            self.harmless_block();
        }
        self.count(&counter, Operator::Add);
        self.statement(Statement::If(compare(Operator::Lt, &counter, count), name), Vec::new());
        self.state.control.steady = before;
        self.known(&counter, count);
    }

    /// A loop without end.
    pub(super) fn endless(&mut self) {
        let name = self.new_name();
        self.set_label(name.clone());
        if self.choices.chance(50) {
            self.harmless_block();
        }
        let one = Condition::Holds(Expression::Constant(Number::whole(1)));
        let conditional = self.choices.chance(40) && self.allows(Feature::Expression) && !self.state.is_eia();
        let statement = if conditional { Statement::If(one, name) } else { Statement::Goto(name) };
        self.statement(statement, Vec::new());
        self.state.setup.limits.steps = self.choices.within(20, 300).unsigned_abs();
        self.nothing_more();
    }

    /// A variable to count with that no loop around counts with.
    pub(crate) fn counter(&mut self) -> Option<Variable> {
        let local = self.allows(Feature::LocalVariable) && self.state.control.entries.len() < 100;
        let common = self.allows(Feature::Variable);
        let variable = if local && (!common || self.choices.chance(50)) {
            Variable::Local(self.choices.pick(&local::NAMES))
        } else {
            Variable::Common(self.choices.within(121, 200) as u8)
        };
        let taken = self.state.control.bounded.iter().any(|bounded| bounded.variable == variable);
        (!taken && (local || common)).then_some(variable)
    }

    /// A block that assigns a whole number.
    pub(crate) fn set(&mut self, variable: &Variable, value: i64) {
        self.begin();
        let constant = Expression::Constant(Number::whole(value));
        self.push(vec![Item::Assignment(variable.clone(), constant)]);
        self.known(variable, value);
    }

    /// A block that counts one pass.
    pub(crate) fn count(&mut self, variable: &Variable, operator: Operator) {
        self.begin();
        let one = Expression::Constant(Number::whole(1));
        let next = Expression::binary(operator, Expression::Variable(variable.clone()), one);
        let items = vec![Item::Assignment(variable.clone(), next)];
        if self.choices.chance(15) {
            self.statement(Statement::Noex, items);
        } else {
            self.push(items);
        }
    }

    /// Notes the value of a variable.
    pub(crate) fn known(&mut self, variable: &Variable, value: i64) {
        match variable {
            Variable::Common(number) => {
                self.state.common.insert(*number, value as f64);
                self.state.control.now_known(*number);
            }
            Variable::Local(name) => self.state.control.assign(name, Some(value as f64)),
            _ => {}
        }
    }

    /// Notes that the value of a variable is not known.
    pub(crate) fn forget(&mut self, variable: &Variable) {
        match variable {
            Variable::Common(number) => {
                self.state.common.remove(number);
                self.state.control.unknown.insert(*number);
            }
            Variable::Local(name) => self.state.control.assign(name, None),
            _ => {}
        }
    }
}

/// A comparison of a variable with a whole number.
pub(crate) fn compare(operator: Operator, variable: &Variable, value: i64) -> Condition {
    let border = Expression::Constant(Number::whole(value));
    Condition::Holds(Expression::binary(operator, Expression::Variable(variable.clone()), border))
}
