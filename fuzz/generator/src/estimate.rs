//! The estimated value of an expression.
//!
//! It follows section 6 of the execution chapter closely enough to know whether an expression raises an alarm
//! and where a word with it ends up; its last bits are nobody's reference.

use crate::environment::Environment;
use crate::expression::{Expression, Function, Operator};
use crate::unit::Estimate;

impl Expression {
    /// The estimated value; none when the expression raises an alarm.
    #[must_use]
    pub fn estimate(&self, environment: &Environment) -> Option<Estimate> {
        match self {
            Self::Constant(number) if number.point => Some(Estimate::Real(number.to_f64())),
            Self::Constant(number) => i32::try_from(number.mantissa).ok().map(Estimate::Integer),
            Self::Hex(bits) => Some(Estimate::Integer(bits.cast_signed())),
            Self::Variable(variable) => environment.value(variable),
            Self::Sign(negative, operand) => match operand.estimate(environment)? {
                value if !negative => Some(value),
                Estimate::Integer(value) => value.checked_neg().map(Estimate::Integer),
                Estimate::Real(value) => Some(Estimate::Real(-value)),
            },
            Self::Not(_) if !environment.user_task_2 => None,
            Self::Not(operand) => Some(Estimate::Integer(!cut(operand.estimate(environment)?)?)),
            Self::Binary(operator, left, right) => {
                if Operator::BOOLEAN.contains(operator) && !environment.user_task_2 {
                    return None;
                }
                combine(*operator, left.estimate(environment)?, right.estimate(environment)?)
            }
            Self::Call(_, _) if !environment.user_task_2 => None,
            Self::Call(function, arguments) => {
                let first = arguments.first()?.estimate(environment)?;
                let second = match arguments.get(1) {
                    Some(argument) => argument.estimate(environment)?,
                    None => Estimate::Integer(0),
                };
                call(*function, first, second, environment)
            }
        }
    }
}

fn finite(value: f64) -> Option<Estimate> {
    value.is_finite().then_some(Estimate::Real(value))
}

/// Cut toward zero to 32 bits.
fn cut(value: Estimate) -> Option<i32> {
    match value {
        Estimate::Integer(value) => Some(value),
        Estimate::Real(value) => to_i32(value.trunc()),
    }
}

fn to_i32(value: f64) -> Option<i32> {
    (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&value).then_some(value as i32)
}

fn combine(operator: Operator, left: Estimate, right: Estimate) -> Option<Estimate> {
    let (a, b) = (left.to_f64(), right.to_f64());
    let logical = |holds: bool| Some(Estimate::Integer(i32::from(holds)));
    match (operator, left, right) {
        (Operator::Add, Estimate::Integer(a), Estimate::Integer(b)) => {
            a.checked_add(b).map(Estimate::Integer)
        }
        (Operator::Subtract, Estimate::Integer(a), Estimate::Integer(b)) => {
            a.checked_sub(b).map(Estimate::Integer)
        }
        (Operator::Add, ..) => finite(a + b),
        (Operator::Subtract, ..) => finite(a - b),
        (Operator::Multiply, ..) => finite(a * b),
        (Operator::Divide, ..) if b == 0.0 => None,
        (Operator::Divide, ..) => finite(a / b),
        (Operator::Lt, ..) => logical(a < b),
        (Operator::Le, ..) => logical(a <= b),
        (Operator::Eq, ..) => logical(a == b),
        (Operator::Ne, ..) => logical(a != b),
        (Operator::Gt, ..) => logical(a > b),
        (Operator::Ge, ..) => logical(a >= b),
        (Operator::And, ..) => Some(Estimate::Integer(cut(left)? & cut(right)?)),
        (Operator::Or, ..) => Some(Estimate::Integer(cut(left)? | cut(right)?)),
        (Operator::Eor, ..) => Some(Estimate::Integer(cut(left)? ^ cut(right)?)),
    }
}

fn call(
    function: Function,
    first: Estimate,
    second: Estimate,
    environment: &Environment,
) -> Option<Estimate> {
    let (a, b) = (first.to_f64(), second.to_f64());
    let (factor, scale) = (environment.function_angle, environment.decimal_scale);
    let angle = (a / factor).to_radians();
    let whole = |value: f64| to_i32(value).map(Estimate::Integer);
    let at_scale = |rounded: f64| if rounded.abs() > 9e15 { finite(a) } else { finite(rounded / scale) };
    match function {
        Function::Sin => finite(angle.sin()),
        Function::Cos => finite(angle.cos()),
        Function::Tan if ((a / factor).abs() % 180.0 - 90.0).abs() < 1e-9 => None,
        Function::Tan => finite(angle.tan()),
        Function::Atan => finite(a.atan().to_degrees() * factor),
        Function::Atan2 if a == 0.0 && b == 0.0 => None,
        Function::Atan2 => finite(a.atan2(b).to_degrees() * factor),
        Function::Sqrt if a < 0.0 => None,
        Function::Sqrt => finite(a.sqrt()),
        Function::Abs => finite(a.abs()),
        Function::Bin => {
            let bits = cut(first)?.cast_unsigned();
            let digits = format!("{bits:x}").parse::<i32>().ok()?;
            Some(Estimate::Integer(digits))
        }
        Function::Bcd => {
            let value = cut(first)?;
            let bits = u32::from_str_radix(&value.to_string(), 16).ok()?;
            (0..=99_999_999).contains(&value).then_some(Estimate::Integer(bits.cast_signed()))
        }
        Function::Round => whole(a.round()),
        Function::Fix => whole(a.trunc()),
        Function::Fup => whole(if a < 0.0 { a.floor() } else { a.ceil() }),
        Function::Dround => at_scale((a * scale).round()),
        Function::Dfix => at_scale((a * scale).trunc()),
        Function::Dfup => at_scale(if a < 0.0 { (a * scale).floor() } else { (a * scale).ceil() }),
        Function::Mod if b == 0.0 => None,
        Function::Mod => finite(a - (a / b).trunc() * b),
    }
}
