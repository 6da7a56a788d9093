//! GOTO, IF and loops of a schedule.

use crate::builder::Builder;
use crate::control::compare;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::{Item, Statement};

impl Builder<'_, '_, '_> {
    /// GOTO forward.
    pub(super) fn schedule_over(&mut self) {
        let name = self.new_name();
        self.schedule_line(Statement::Goto(name.clone()), Vec::new());
        self.dead_text(&name);
        self.named_block(name);
    }

    /// IF with a condition whose value is known.
    pub(super) fn schedule_condition(&mut self) {
        self.begin();
        let (condition, holds) =
            if self.state.control.steady { self.plain_condition() } else { self.condition() };
        if !holds && self.choices.chance(30) {
            return self.schedule_line(Statement::If(condition, "NOWH".to_owned()), Vec::new());
        }
        let name = self.new_name();
        self.schedule_line(Statement::If(condition, name.clone()), Vec::new());
        if holds {
            self.dead_text(&name);
        } else {
            self.select_program();
        }
        self.named_block(name);
    }

    /// A block of this name.
    fn named_block(&mut self, name: String) {
        self.set_label(name);
        self.select_program();
    }

    /// A loop that counts with VSET.
    pub(super) fn schedule_loop(&mut self) {
        let number = self.choices.within(121, 200) as u8;
        let counter = Variable::Common(number);
        let count = self.choices.within(1, 4);
        self.vset_of(&counter, Expression::Constant(Number::whole(0)));
        let steady = std::mem::replace(&mut self.state.control.steady, true);
        self.forget_changing();
        self.forget(&counter);
        let name = self.new_name();
        self.set_label(name.clone());
        self.select_program();
        for _ in 0..self.choices.below(2) {
            let item = self.changing_common();
            self.schedule_line(Statement::Vset, vec![item]);
        }
        let one = Expression::Constant(Number::whole(1));
        let next = Expression::binary(Operator::Add, Expression::Variable(counter.clone()), one);
        self.vset_of(&counter, next);
        self.schedule_line(Statement::If(compare(Operator::Lt, &counter, count), name), Vec::new());
        self.state.control.steady = steady;
        self.known(&counter, count);
    }

    fn vset_of(&mut self, variable: &Variable, expression: Expression) {
        self.begin();
        self.schedule_line(Statement::Vset, vec![Item::Assignment(variable.clone(), expression)]);
    }

    /// An assignment to a variable that changes with every pass.
    pub(super) fn changing_common(&mut self) -> Item {
        let number = self.choices.within(101, 120) as u8;
        self.forget(&Variable::Common(number));
        let step = Expression::Constant(Number::whole(self.choices.within(1, 9)));
        let next = Expression::binary(Operator::Add, Expression::Variable(Variable::Common(number)), step);
        Item::Assignment(Variable::Common(number), next)
    }
}
