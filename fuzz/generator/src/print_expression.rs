//! The text of expressions: brackets where the levels of E100L-AEXP-05 to -07 need them, and sometimes where
//! they do not.

use crate::expression::{Expression, Operator, Variable};
use crate::print::Printer;

/// How strongly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Or,
    And,
    Not,
    Comparison,
    Sum,
    Product,
    Sign,
    Primary,
}

/// The text of an expression.
pub(crate) fn text(printer: &mut Printer<'_, '_, '_>, expression: &Expression) -> String {
    let mut text = String::new();
    write(printer, expression, Level::Or, &mut text);
    text
}

/// The text of a variable with its suffix.
pub(crate) fn variable(printer: &mut Printer<'_, '_, '_>, variable: &Variable) -> String {
    match variable {
        Variable::Common(number) if printer.vary() => format!("V{number:03}"),
        Variable::Common(number) => format!("V{number}"),
        Variable::System(name) | Variable::Local(name) => (*name).to_owned(),
        Variable::Indexed(name, suffix) => {
            let blank = if printer.vary() { " " } else { "" };
            format!("{name}{blank}[{}]", text(printer, suffix))
        }
    }
}

fn level(expression: &Expression) -> Level {
    match expression {
        Expression::Constant(number) if number.mantissa < 0 => Level::Sign,
        Expression::Sign(..) => Level::Sign,
        Expression::Not(_) => Level::Not,
        Expression::Binary(operator, ..) => operator_level(*operator),
        _ => Level::Primary,
    }
}

fn operator_level(operator: Operator) -> Level {
    match operator {
        Operator::Or | Operator::Eor => Level::Or,
        Operator::And => Level::And,
        Operator::Add | Operator::Subtract => Level::Sum,
        Operator::Multiply | Operator::Divide => Level::Product,
        _ => Level::Comparison,
    }
}

/// The weakest level that the left and the right operand may have without brackets.
fn operand_levels(operator: Operator) -> (Level, Level) {
    match operator_level(operator) {
        Level::Or => (Level::Or, Level::And),
        Level::And => (Level::And, Level::Not),
        Level::Comparison => (Level::Sum, Level::Sum),
        Level::Sum => (Level::Sum, Level::Product),
        _ => (Level::Product, Level::Sign),
    }
}

fn write(printer: &mut Printer<'_, '_, '_>, expression: &Expression, weakest: Level, out: &mut String) {
    if level(expression) < weakest || printer.vary() {
        out.push('[');
        write_bare(printer, expression, out);
        out.push(']');
    } else {
        write_bare(printer, expression, out);
    }
}

fn write_bare(printer: &mut Printer<'_, '_, '_>, expression: &Expression, out: &mut String) {
    match expression {
        Expression::Constant(number) => out.push_str(&number.text()),
        Expression::Hex(bits) if printer.vary() => out.push_str(&format!("${bits:08X}")),
        Expression::Hex(bits) => out.push_str(&format!("${bits:X}")),
        Expression::Variable(name) => out.push_str(&variable(printer, name)),
        Expression::Sign(negative, operand) => {
            out.push(if *negative { '-' } else { '+' });
            write(printer, operand, Level::Sign, out);
        }
        Expression::Not(operand) => {
            if !out.is_empty() && !out.ends_with(['[', ',', ' ']) {
                out.push(' ');
            }
            out.push_str("NOT ");
            write(printer, operand, Level::Not, out);
        }
        Expression::Binary(operator, left, right) => {
            let (left_level, right_level) = operand_levels(*operator);
            write(printer, left, left_level, out);
            let word = operator_level(*operator) <= Level::Comparison;
            let blank = if word || printer.vary() { " " } else { "" };
            out.push_str(&format!("{blank}{}{blank}", operator.text()));
            write(printer, right, right_level, out);
        }
        Expression::Call(function, arguments) => {
            let blank = if printer.vary() { " " } else { "" };
            out.push_str(&format!("{}{blank}[", function.text()));
            for (place, argument) in arguments.iter().enumerate() {
                if place > 0 {
                    out.push(',');
                }
                write(printer, argument, Level::Or, out);
            }
            out.push(']');
        }
    }
}
