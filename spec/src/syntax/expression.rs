//! Expressions, one function a level of precedence (E100L-MATH-17, E100L-AEXP-05, E100L-AEXP-06, E100L-AEXP-07).

use super::cursor::Cursor;
use super::items::{Role, has_blanks, local_variable, not_has_blanks, variable};
use super::number;
use super::tree::{BinaryOperator, Expression, Function};
use crate::controls::e100l::addresses::{EXTENDED, EXTENDED_LATER, OPERATOR_WORDS, STATEMENTS};
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId, Setup};

/// An expression: `OR` and `EOR` bind least. (A block is short, so this recursion is bounded.)
pub fn expression(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    let mut left = conjunction(cursor, setup)?;
    while let Some(operator) = take_word(cursor, &["OR", "EOR"], MATH_06)? {
        left = binary(operator, left, conjunction(cursor, setup)?);
    }
    Ok(left)
}

fn conjunction(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    let mut left = negation(cursor, setup)?;
    while let Some(operator) = take_word(cursor, &["AND"], MATH_06)? {
        left = binary(operator, left, negation(cursor, setup)?);
    }
    Ok(left)
}

/// E100L-MATH-05: `NOT` in front.
fn negation(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    cursor.skip_blanks()?;
    if cursor.run() != "NOT" {
        return comparison(cursor, setup);
    }
    if !not_has_blanks(cursor) {
        return fail(AlarmName::OperatorBlankMissing, MATH_06);
    }
    cursor.advance(3);
    Ok(Expression::Not(Box::new(negation(cursor, setup)?)))
}

/// E100L-AEXP-03: at most one comparison a level.
fn comparison(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    const WORDS: &[&str] = &["LT", "LE", "EQ", "NE", "GT", "GE"];
    let left = sum(cursor, setup)?;
    let Some(operator) = take_word(cursor, WORDS, AEXP_03)? else { return Ok(left) };
    let compared = binary(operator, left, sum(cursor, setup)?);
    match take_word(cursor, WORDS, AEXP_03)? {
        Some(_) => fail(AlarmName::Format, AEXP_03),
        None => Ok(compared),
    }
}

fn sum(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    let mut left = product(cursor, setup)?;
    while let Some(operator) =
        take_sign(cursor, [(b'+', BinaryOperator::Add), (b'-', BinaryOperator::Subtract)])?
    {
        left = binary(operator, left, product(cursor, setup)?);
    }
    Ok(left)
}

fn product(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    let mut left = signed(cursor, setup)?;
    while let Some(operator) =
        take_sign(cursor, [(b'*', BinaryOperator::Multiply), (b'/', BinaryOperator::Divide)])?
    {
        left = binary(operator, left, signed(cursor, setup)?);
    }
    Ok(left)
}

/// E100L-AEXP-06: signs bind more than every operator.
fn signed(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    cursor.skip_blanks()?;
    let minus = match cursor.peek() {
        Some(b'-') => true,
        Some(b'+') => false,
        _ => return primary(cursor, setup),
    };
    cursor.advance(1);
    Ok(Expression::Sign { minus, operand: Box::new(signed(cursor, setup)?) })
}

fn primary(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    match cursor.peek() {
        Some(b'0'..=b'9' | b'.') => constant(cursor),
        Some(b'$') => number::hexadecimal(cursor).map(Expression::Integer),
        Some(b'[') => {
            cursor.advance(1);
            let inner = expression(cursor, setup)?;
            close_bracket(cursor)?;
            Ok(inner)
        }
        Some(b'V') if cursor.run() != "VSET" => {
            Ok(Expression::Variable(Box::new(variable(cursor, setup, Role::Read)?)))
        }
        Some(b'A'..=b'Z') => named(cursor, setup),
        _ => Err(cursor.unexpected()),
    }
}

/// E100L-TYPE-02, E100L-TYPE-03: a constant, at its first digit or its point.
pub fn constant(cursor: &mut Cursor) -> Outcome<Expression> {
    let constant = number::constant(cursor)?;
    // Eight digits always fit.
    let integer = i32::try_from(constant.digits).ok().filter(|_| !constant.point);
    Ok(integer.map_or(Expression::Real(constant), Expression::Integer))
}

fn named(cursor: &mut Cursor, setup: &Setup) -> Outcome<Expression> {
    let run = cursor.run();
    let name = run.as_str();
    if let Some(function) = Function::of_name(name) {
        cursor.advance(name.len());
        return call(cursor, setup, function);
    }
    let one_letter = !name.as_bytes().get(1).is_some_and(u8::is_ascii_uppercase);
    cursor.advance(name.len());
    if one_letter || is_reserved(name) {
        return fail(AlarmName::Format, AEXP_01);
    }
    Ok(Expression::Variable(Box::new(local_variable(name)?)))
}

/// E100L-LVAR-02: names that no local variable can have, besides those of functions.
pub fn is_reserved(name: &str) -> bool {
    EXTENDED.contains(&name)
        || EXTENDED_LATER.contains(&name)
        || STATEMENTS.contains(&name)
        || OPERATOR_WORDS.contains(&name)
        || matches!(name, "NOT" | "CALRG")
}

/// E100L-MATH-08, E100L-FUNC-01: arguments in square brackets.
fn call(cursor: &mut Cursor, setup: &Setup, function: Function) -> Outcome<Expression> {
    cursor.skip_blanks()?;
    if !cursor.take(b'[') {
        return fail(AlarmName::FunctionBracketMissing, MATH_08);
    }
    let mut arguments = Vec::new();
    for index in 0..function.arity() {
        if index > 0 && !cursor.take(b',') {
            return fail(AlarmName::BracketUnbalanced, AEXP_04);
        }
        cursor.skip_blanks()?;
        if matches!(cursor.peek(), Some(b']' | b',') | None) {
            return fail(AlarmName::BracketUnbalanced, AEXP_04);
        }
        arguments.push(expression(cursor, setup)?);
        cursor.skip_blanks()?;
    }
    close_bracket(cursor)?;
    Ok(Expression::Call(function, arguments))
}

/// E100L-AEXP-04.
pub fn close_bracket(cursor: &mut Cursor) -> Outcome<()> {
    cursor.skip_blanks()?;
    if cursor.take(b']') { Ok(()) } else { fail(AlarmName::BracketUnbalanced, AEXP_04) }
}

fn binary(operator: BinaryOperator, left: Expression, right: Expression) -> Expression {
    Expression::Binary(operator, Box::new([left, right]))
}

fn take_sign(cursor: &mut Cursor, signs: [(u8, BinaryOperator); 2]) -> Outcome<Option<BinaryOperator>> {
    let end = cursor.mark();
    cursor.skip_blanks()?;
    match signs.iter().find(|(sign, _)| cursor.peek() == Some(*sign)) {
        Some((_, operator)) => {
            cursor.advance(1);
            Ok(Some(*operator))
        }
        None => {
            cursor.rewind(end);
            Ok(None)
        }
    }
}

fn take_word(cursor: &mut Cursor, words: &[&str], rule: RuleId) -> Outcome<Option<BinaryOperator>> {
    let end = cursor.mark();
    cursor.skip_blanks()?;
    let run = cursor.run();
    match BinaryOperator::of_word(&run).filter(|_| words.contains(&run.as_str())) {
        Some(operator) => {
            if !has_blanks(cursor, run.len()) {
                return Err(Fault::new(AlarmName::OperatorBlankMissing, rule));
            }
            cursor.advance(run.len());
            Ok(Some(operator))
        }
        None => {
            cursor.rewind(end);
            Ok(None)
        }
    }
}
