//! Local variables: names, entries, assignments.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::{Item, Statement};
use crate::unit::Estimate;
use crate::words::expression_length;

/// Names, some of which begin as keywords, functions, operators and addresses do.
pub(super) const NAMES: [&str; 20] = [
    "XP1", "ZP1", "DIA1", "LC", "ABC", "ITH5", "PCH", "DEF", "IFX", "RTS1", "GOT", "CALR", "SIN1", "EQ3",
    "SB1", "LAB2", "TANK", "MODE", "XS", "GOTX",
];

/// Names of variables that change with every pass.
pub(super) const CHANGING: [&str; 4] = ["CNT", "PASS", "DX", "AA1"];

/// Names of what a program gets when it is called.
pub(super) const ARGUMENTS: [&str; 4] = ["ARG1", "ARG2", "WID", "DP"];

/// How often local variables are assigned until nearly as many are registered as may be.
const MANY: usize = 60;

/// To whom an entry belongs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Owner {
    /// The program at this depth of calls.
    Program(usize),
    /// The modal call of this number.
    Mode(usize),
}

/// A registered local variable.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub name: &'static str,
    /// Its value, where it is known.
    pub value: Option<f64>,
    pub owner: Owner,
}

impl super::Control {
    /// Whether a name has an entry.
    pub(super) fn is_defined(&self, name: &str) -> bool {
        self.entries.iter().any(|entry| entry.name == name)
    }

    /// Registers a name anew.
    pub(super) fn register(&mut self, name: &'static str, value: Option<f64>, owner: Owner) {
        self.entries.push(Entry { name, value, owner });
    }

    /// Assigns a value as a block of items does.
    pub(super) fn assign(&mut self, name: &'static str, value: Option<f64>) {
        match self.entries.iter_mut().rev().find(|entry| entry.name == name) {
            Some(entry) => entry.value = value,
            None => self.register(name, value, Owner::Program(self.depth)),
        }
    }

    /// Removes the entries of an owner.
    pub(super) fn remove(&mut self, owner: Owner) {
        self.entries.retain(|entry| entry.owner != owner);
    }
}

impl Builder<'_, '_, '_> {
    /// Any name, or one that has an entry.
    pub(super) fn some_name(&mut self) -> &'static str {
        let known: Vec<_> = self.state.control.entries.iter().map(|entry| entry.name).collect();
        if known.is_empty() || self.choices.chance(50) {
            self.choices.pick(&NAMES)
        } else {
            self.choices.pick(&known)
        }
    }

    /// A block of assignments with local variables, with or without NOEX and words.
    pub(super) fn local_block(&mut self) {
        let noex = self.choices.chance(20) && self.allows(Feature::ControlStatement);
        let mut items = Vec::new();
        for _ in 0..=self.choices.below(3) {
            let item = self.local_assignment();
            items.push(item);
            self.state.begin_block();
        }
        if noex {
            let items = if self.choices.chance(10) { Vec::new() } else { items };
            return self.statement(Statement::Noex, items);
        }
        if self.choices.chance(15) {
            self.companions(&mut items);
        }
        self.push(items);
    }

    /// An assignment to a local variable of the program.
    fn local_assignment(&mut self) -> Item {
        if self.state.control.steady {
            return self.changing_assignment();
        }
        let name = self.choices.pick(&NAMES);
        let (expression, value) = self.known_value(40);
        if self.state.control.entries.len() < MANY || self.state.control.is_defined(name) {
            self.state.control.assign(name, Some(value));
        }
        Item::Assignment(Variable::Local(name), expression)
    }

    /// A local variable of the program with this value in it; none when too many are registered.
    pub(crate) fn local_target(&mut self, value: f64) -> Option<&'static str> {
        let name = self.choices.pick(&NAMES);
        let room = self.state.control.entries.len() < MANY || self.state.control.is_defined(name);
        if room {
            self.state.control.assign(name, Some(value));
        }
        room.then_some(name)
    }

    /// An expression of a known value, and the value.
    pub(super) fn known_value(&mut self, most: usize) -> (Expression, f64) {
        let depth = self.choices.below(4);
        let expression = Expression::grow(self.choices, &self.state.environment, depth);
        let value = expression.estimate(&self.state.environment).map(Estimate::to_f64);
        match value.filter(|value| value.abs() < 1e12) {
            Some(value) if expression_length(&expression) <= most.min(self.room) => {
                self.room -= expression_length(&expression);
                (expression, value)
            }
            _ => {
                let number = Number::decimal(self.choices.within(-9_999, 9_999), 2).with_point();
                (Expression::Constant(number), number.to_f64())
            }
        }
    }

    /// An assignment in what runs more than once: to a variable that changes, by itself or another one.
    pub(crate) fn changing_assignment(&mut self) -> Item {
        let number = Number::whole(self.choices.within(1, 20));
        let constant = Expression::Constant(number);
        let name = self.choices.pick(&CHANGING);
        let local = self.choices.chance(50) && self.allows(Feature::LocalVariable);
        if local || !self.allows(Feature::Variable) {
            let operand = Expression::Variable(Variable::Local(name));
            let known =
                self.state.control.entries.iter().any(|entry| {
                    entry.name == name && entry.owner == Owner::Program(self.state.control.depth)
                });
            let expression = if known { self.step_of(operand, constant) } else { constant };
            self.state.control.assign(name, None);
            return Item::Assignment(Variable::Local(name), expression);
        }
        let common = self.choices.within(101, 120) as u8;
        self.state.control.unknown.insert(common);
        let other = self.choices.within(101, 120) as u8;
        let operand =
            Expression::Variable(Variable::Common(if self.choices.chance(70) { common } else { other }));
        let expression = self.step_of(operand, constant);
        Item::Assignment(Variable::Common(common), expression)
    }

    /// An expression that stays small with every pass.
    fn step_of(&mut self, operand: Expression, constant: Expression) -> Expression {
        let operator =
            self.choices.pick(&[Operator::Add, Operator::Subtract, Operator::Divide, Operator::Add]);
        Expression::binary(operator, operand, constant)
    }
}
