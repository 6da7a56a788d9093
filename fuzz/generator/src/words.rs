//! Words: a wanted amount becomes a plain number or an expression, and the amount that the control will make
//! of it.

use crate::builder::Builder;
use crate::companions::has;
use crate::expression::{Expression, Operator};
use crate::number::Number;
use crate::print;
use crate::program::{Block, Item, Value, Word};
use crate::state::Axis;
use crate::unit::{Estimate, Written};

impl Builder<'_, '_, '_> {
    /// A value that is a number, or sometimes an expression that comes to about the same.
    pub(crate) fn value(&mut self, number: Number) -> (Value, Written) {
        if !self.state.is_eia()
            && self.choices.chance(self.expressions)
            && let Some((expression, estimate)) = self.expression_for(number)
        {
            return (Value::Expression(expression), Written::Estimated(estimate));
        }
        let number = if self.choices.chance(4) { number.with_point() } else { number };
        (Value::Plain(number), Written::Plain(number))
    }

    /// An expression whose value is that of a number, to within rounding errors.
    fn expression_for(&mut self, number: Number) -> Option<(Expression, Estimate)> {
        let constant = Expression::Constant(number);
        let expression = match self.choices.below(6) {
            0 => constant,
            1 => Expression::Sign(
                true,
                Box::new(Expression::Constant(Number { mantissa: -number.mantissa, ..number })),
            ),
            2 => Expression::binary(Operator::Multiply, constant, Expression::Constant(Number::whole(1))),
            3 => {
                let part = self.choices.within(-999, 999);
                let rest = Number { mantissa: number.mantissa - part, ..number };
                let part = Number { mantissa: part, ..number };
                Expression::binary(Operator::Add, Expression::Constant(rest), Expression::Constant(part))
            }
            _ => {
                let depth = 1 + self.choices.below(3);
                let start = Expression::grow(self.choices, &self.state.environment, depth);
                let value = start.estimate(&self.state.environment)?.to_f64();
                let decimals = self.state.units.length_decimals() + 1;
                let rest = ((number.to_f64() - value) * 10_f64.powi(decimals.into())).round();
                if rest.abs() > 99_999_999.0 {
                    return None;
                }
                let operator = if rest < 0.0 { Operator::Subtract } else { Operator::Add };
                let rest = Number::decimal(rest.abs() as i64, decimals);
                Expression::binary(operator, start, Expression::Constant(rest))
            }
        };
        let estimate = expression.estimate(&self.state.environment)?;
        let length = expression_length(&expression);
        if length > self.room || self.in_doubt(estimate) {
            return None;
        }
        self.room -= length;
        Some((expression, estimate))
    }

    /// Whether a value lies so near to a tie of its rounding that the estimate cannot tell the side.
    fn in_doubt(&self, estimate: Estimate) -> bool {
        let Estimate::Real(value) = estimate else { return false };
        let steps = value * self.state.units.length_unit() as f64 / 500.0;
        (steps - steps.round()).abs() < 1e-6 && steps.round() % 2.0 != 0.0
    }

    /// A word of a length, in nanometres; the length that the control reads.
    pub(crate) fn length(&mut self, address: &'static str, wanted: i64) -> (Item, i64) {
        let (value, written) = self.value(self.state.units.write_length(wanted));
        (Item::Word(Word { address, value }), self.state.units.length(written))
    }

    /// A word of a length that is an exact number and no expression.
    pub(crate) fn plain_length(&mut self, address: &'static str, wanted: i64) -> (Item, i64) {
        let number = self.state.units.write_length(wanted);
        (Item::plain(address, number), self.state.units.length(Written::Plain(number)))
    }

    /// A word of an angle, in micro-degrees; the angle that the control reads.
    pub(crate) fn angle(&mut self, address: &'static str, wanted: i64) -> (Item, i64) {
        let (value, written) = self.value(self.state.units.write_angle(wanted));
        (Item::Word(Word { address, value }), self.state.units.angle(written))
    }

    /// A word of a whole number.
    pub(crate) fn whole(&mut self, address: &'static str, number: i64) -> Item {
        if self.choices.chance(10) {
            let (value, _) = self.value(Number::whole(number));
            return Item::Word(Word { address, value });
        }
        Item::whole(address, number)
    }

    /// A coordinate word toward a program coordinate, counted from `base` in G91; the coordinate reached.
    pub(crate) fn coordinate(&mut self, axis: Axis, wanted: i64, base: i64) -> (Item, i64) {
        let origin = if self.state.incremental { base } else { 0 };
        let (item, length) = self.length(axis.address(), wanted - origin);
        (item, origin + length)
    }

    /// A coordinate word from the present point.
    pub(crate) fn target(&mut self, axis: Axis, wanted: i64) -> (Item, i64) {
        self.coordinate(axis, wanted, self.state.program(axis))
    }

    /// An F word that suits the feed mode.
    pub(crate) fn feed_word(&mut self) -> Item {
        let amount = if self.state.per_minute {
            self.choices.within(1, 3_000) * 1_000_000
        } else {
            self.choices.within(3, 2_000) * 1_000
        };
        let unit = if self.state.per_minute {
            self.state.units.minute_unit()
        } else {
            self.state.units.length_unit()
        };
        self.state.feed = true;
        self.state.threads.note_feed(!self.state.per_minute, amount as f64);
        let mantissa = (i128::from(amount) * 10_000 / i128::from(unit)).max(1);
        let mut number = Number::decimal(i64::try_from(mantissa).unwrap_or(1), 4);
        if number.mantissa <= 999_999 && self.choices.chance(10) {
            number = Number::decimal(number.mantissa * 10 + 1, number.decimals + 1);
        }
        let (value, _) = self.value(number);
        Item::Word(Word { address: "F", value })
    }

    /// Adds an F word where a cutting motion has none yet, and sometimes otherwise.
    pub(crate) fn feed_if_needed(&mut self, items: &mut Vec<Item>) {
        if !has(items, "F") && (!self.state.feed || self.choices.chance(20)) {
            items.push(self.feed_word());
        }
    }
}

/// The length of an expression in its plainest spelling.
pub(crate) fn expression_length(expression: &Expression) -> usize {
    let value = Value::Expression(expression.clone());
    let items = vec![Item::Word(Word { address: "X", value })];
    print::plain(&Block { items, ..Block::default() }).len()
}
