//! GOTO and IF whose way is known: forward over text that never runs, over blocks, behind the end of the program.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::{Block, Condition, Item, Line, Statement};
use crate::unit::Estimate;

use super::local::CHANGING;
use super::text;

impl Builder<'_, '_, '_> {
    /// GOTO forward.
    pub(super) fn jump_over(&mut self) {
        let name = self.new_name();
        self.statement(Statement::Goto(name.clone()), Vec::new());
        self.dead_text(&name);
        self.labelled(name);
    }

    /// IF with a condition whose value is known.
    pub(super) fn known_condition(&mut self) {
        let (condition, holds) = self.condition();
        self.branch(condition, holds);
    }

    /// IF with a condition that holds or not, and what it leads over.
    pub(crate) fn branch(&mut self, condition: Condition, holds: bool) {
        if holds {
            let name = self.new_name();
            self.statement(Statement::If(condition, name.clone()), Vec::new());
            self.dead_text(&name);
            return self.labelled(name);
        }
        // The name need not exist.
        if self.choices.chance(30) {
            return self.statement(Statement::If(condition, "NOWH".to_owned()), Vec::new());
        }
        let name = self.new_name();
        self.statement(Statement::If(condition, name.clone()), Vec::new());
        for _ in 0..self.choices.below(3) {
            self.grow_block();
        }
        self.labelled(name);
    }

    /// A condition, and whether it holds.
    pub(crate) fn condition(&mut self) -> (Condition, bool) {
        let control = &self.state.control;
        let locals = self.allows(Feature::LocalVariable);
        if locals && !control.shared && self.choices.chance(25) {
            let name = self.some_name();
            return (Condition::Defined(name), self.state.control.is_defined(name));
        }
        let (left, a) = self.known_value(30);
        let (right, b) = self.known_value(30);
        // What an estimate cannot tell apart is not compared.
        let near = (a - b).abs() < 1e-6 * (1.0 + a.abs() + b.abs());
        let operator = self.choices.pick(&Operator::COMPARISON);
        let comparison = Expression::binary(operator, left, right);
        let value = comparison.estimate(&self.state.environment).map(Estimate::to_f64);
        match value {
            Some(value) if !near && self.choices.chance(80) => (Condition::Holds(comparison), value != 0.0),
            _ => self.plain_condition(),
        }
    }

    /// A condition of constants, some of which are no logical values.
    pub(crate) fn plain_condition(&mut self) -> (Condition, bool) {
        let number = self.choices.pick(&[
            Number::whole(1),
            Number::whole(0),
            Number::decimal(5, 1),
            Number::whole(-7),
            Number::whole(0).with_point(),
            Number::decimal(1, 4),
        ]);
        let holds = number.mantissa != 0;
        let constant = Expression::Constant(number);
        if self.choices.chance(50) {
            return (Condition::Holds(constant), holds);
        }
        let equal = Expression::binary(Operator::Eq, constant.clone(), constant);
        (Condition::Holds(equal), true)
    }

    /// IF with a condition whose value is not known; what it passes over changes nothing that is foreseen.
    pub(super) fn unknown_condition(&mut self) {
        let control = &self.state.control;
        let common = control.unknown.iter().map(|number| Variable::Common(*number));
        let bounded = control.bounded.iter().map(|bounded| bounded.variable.clone());
        let mut known: Vec<Variable> = bounded.collect();
        if self.allows(Feature::Variable) && (known.is_empty() || self.choices.chance(50)) {
            known.extend(common.take(4));
        }
        if known.is_empty() {
            return self.harmless_block();
        }
        let operand = Expression::Variable(known[self.choices.below(known.len())].clone());
        let local = self.choices.chance(25) && self.allows(Feature::LocalVariable);
        let condition = if local {
            Condition::Defined(self.choices.pick(&CHANGING))
        } else {
            let operator = self.choices.pick(&Operator::COMPARISON);
            let border = Expression::Constant(Number::whole(self.choices.within(-2, 9)));
            Condition::Holds(Expression::binary(operator, operand, border))
        };
        let name = self.new_name();
        self.statement(Statement::If(condition, name.clone()), Vec::new());
        for _ in 0..=self.choices.below(2) {
            self.harmless_block();
        }
        self.set_label(name);
        self.settle_label();
    }

    /// A block that changes nothing that is foreseen.
    pub(super) fn harmless_block(&mut self) {
        self.begin();
        let steady = std::mem::replace(&mut self.state.control.steady, true);
        if self.choices.chance(25) && self.allows(Feature::Dwell) {
            self.dwell();
        } else {
            self.auxiliary();
        }
        self.state.control.steady = steady;
    }

    /// GOTO to blocks behind the end of the program, and back.
    pub(super) fn excursion(&mut self) {
        let (there, back) = (self.new_name(), self.new_name());
        self.statement(Statement::Goto(there.clone()), Vec::new());
        let here = std::mem::take(&mut self.lines);
        self.labelled(there);
        for _ in 0..self.choices.below(3) {
            self.grow_block();
        }
        self.settle_label();
        self.statement(Statement::Goto(back.clone()), Vec::new());
        let away = std::mem::replace(&mut self.lines, here);
        self.state.control.tail.extend(away);
        if self.choices.chance(20) {
            self.dead_text(&back);
        }
        self.labelled(back);
    }

    /// Text that never runs, where a name is looked for; some of it looks like that name.
    pub(crate) fn dead_text(&mut self, name: &str) {
        for _ in 0..self.choices.below(4) {
            if self.choices.chance(25) {
                self.decoy(name);
                continue;
            }
            let list = if self.state.is_eia() { text::DEAD_EIA } else { text::DEAD };
            let line = self.choices.pick(list);
            if self.profile.permits_text(line, self.state.mode) {
                self.raw(line);
            }
        }
    }

    /// A block that has a longer or shorter name, or a name of an earlier block.
    fn decoy(&mut self, name: &str) {
        let known: Vec<String> = self.state.names.iter().filter(|known| *known != name).cloned().collect();
        let earlier = |known: &String| {
            let has =
                |line: &Line| matches!(line, Line::Block(block) if block.sequence.as_ref() == Some(known));
            self.lines.iter().any(has)
        };
        let again: Vec<String> = known.iter().filter(|known| earlier(known)).cloned().collect();
        let sequence = match self.choices.below(4) {
            0 if !again.is_empty() => again[self.choices.below(again.len())].clone(),
            1 if name.len() < 5 => format!("{name}0"),
            2 if name.len() > 1 => name[..name.len() - 1].to_owned(),
            _ if name.len() < 5 && name.starts_with(|first: char| first.is_ascii_digit()) => {
                format!("0{name}")
            }
            _ => return,
        };
        if again.contains(&sequence) || self.state.names.insert(sequence.clone()) {
            let items = vec![Item::m(65)];
            self.lines.push(Line::Block(Block { sequence: Some(sequence), items, ..Block::default() }));
        }
    }
}
