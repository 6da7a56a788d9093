//! Operators (E100L-MATH-01 to -07, E100L-AEXP-02, E100L-AEXP-10, E100L-TYPE-08 to -12, E100L-BOOL-01, E100L-BOOL-02).

use super::function;
use super::number::{Number, finite};
use super::read;
use crate::fault::{Outcome, fail};
use crate::quantity;
use crate::state::State;
use crate::syntax::{BinaryOperator, Decimal, Expression};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId};

/// The value of an expression; operands from left to right. Inputs that it reads go on to their next value.
pub fn evaluate(expression: &Expression, state: &mut State) -> Outcome<Number> {
    match expression {
        Expression::Integer(integer) => Ok(Number::Integer(*integer)),
        Expression::Real(decimal) => Ok(Number::Real(quantity::nearest_real(&decimal.exact()))),
        Expression::Variable(variable) => read::amount(variable, state)?.number(state.setup.unit_system),
        Expression::Sign { minus, operand } => {
            let value = evaluate(operand, state)?;
            if *minus { negative(value) } else { Ok(value) }
        }
        Expression::Not(operand) => {
            needs_level_2(state, BOOL_01)?;
            Ok(Number::Integer(!evaluate(operand, state)?.cut(TYPE_12)?))
        }
        Expression::Binary(operator, operands) => {
            if matches!(operator, BinaryOperator::And | BinaryOperator::Or | BinaryOperator::ExclusiveOr) {
                needs_level_2(state, BOOL_01)?;
            }
            let [left, right] = operands.as_ref();
            let (left, right) = (evaluate(left, state)?, evaluate(right, state)?);
            binary(*operator, left, right)
        }
        Expression::Call(function, arguments) => {
            needs_level_2(state, FUNC_20)?;
            let values =
                arguments.iter().map(|argument| evaluate(argument, state)).collect::<Outcome<Vec<_>>>()?;
            function::value(*function, &values, state.setup.unit_system)
        }
    }
}

impl Decimal {
    /// Its exact value.
    pub fn exact(self) -> quantity::Exact {
        quantity::ratio(self.digits, 10_u64.pow(self.scale))
    }
}

/// Functions, boolean operators and the variables VDIN and VDOUT are User Task 2.
pub(super) fn needs_level_2(state: &State, rule: RuleId) -> Outcome<()> {
    if state.setup.options.user_task < 2 { fail(AlarmName::UserTaskLevel, rule) } else { Ok(()) }
}

/// E100L-TYPE-09: the type is kept.
fn negative(value: Number) -> Outcome<Number> {
    match value {
        Number::Real(real) => Ok(Number::Real(-real)),
        Number::Integer(integer) => match integer.checked_neg() {
            Some(negative) => Ok(Number::Integer(negative)),
            None => fail(AlarmName::IntegerOverflow, TYPE_09),
        },
    }
}

fn binary(operator: BinaryOperator, left: Number, right: Number) -> Outcome<Number> {
    match operator {
        BinaryOperator::Add => sum(left, right, i32::checked_add, |a, b| a + b),
        BinaryOperator::Subtract => sum(left, right, i32::checked_sub, |a, b| a - b),
        // E100L-TYPE-10: products and quotients are real.
        BinaryOperator::Multiply => finite(left.real() * right.real(), TYPE_10),
        BinaryOperator::Divide if right.real() == 0.0 => fail(AlarmName::DivisionByZero, AEXP_09),
        BinaryOperator::Divide => finite(left.real() / right.real(), TYPE_10),
        BinaryOperator::Less => Ok(compare(left, right, |a, b| a < b)),
        BinaryOperator::LessOrEqual => Ok(compare(left, right, |a, b| a <= b)),
        BinaryOperator::Equal => Ok(compare(left, right, |a, b| a == b)),
        BinaryOperator::NotEqual => Ok(compare(left, right, |a, b| a != b)),
        BinaryOperator::Greater => Ok(compare(left, right, |a, b| a > b)),
        BinaryOperator::GreaterOrEqual => Ok(compare(left, right, |a, b| a >= b)),
        BinaryOperator::And => bitwise(left, right, |a, b| a & b),
        BinaryOperator::Or => bitwise(left, right, |a, b| a | b),
        BinaryOperator::ExclusiveOr => bitwise(left, right, |a, b| a ^ b),
    }
}

/// E100L-TYPE-08: two integers give an integer, else the operation is one of reals.
fn sum(
    left: Number,
    right: Number,
    integers: fn(i32, i32) -> Option<i32>,
    reals: fn(f64, f64) -> f64,
) -> Outcome<Number> {
    if let (Number::Integer(a), Number::Integer(b)) = (left, right) {
        return match integers(a, b) {
            Some(result) => Ok(Number::Integer(result)),
            None => fail(AlarmName::IntegerOverflow, TYPE_08),
        };
    }
    finite(reals(left.real(), right.real()), TYPE_08)
}

/// E100L-TYPE-11: an integer converts to a real exactly, so that the two comparisons are one.
fn compare(left: Number, right: Number, holds: fn(f64, f64) -> bool) -> Number {
    Number::logical(holds(left.real(), right.real()))
}

/// E100L-TYPE-12: reals are cut to integers.
fn bitwise(left: Number, right: Number, bits: fn(i32, i32) -> i32) -> Outcome<Number> {
    Ok(Number::Integer(bits(left.cut(TYPE_12)?, right.cut(TYPE_12)?)))
}
