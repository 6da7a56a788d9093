//! The plain text of a syntax tree: no superfluous brackets, one blank between items.

use turnspec_oracle::syntax::{
    Address, BinaryOperator, Body, Callee, Characters, Communication, Condition, Decimal, Expression,
    Function, Item, ItemKind, Statement, StringForm, Value, Variable,
};

/// The text of a block of this sequence name and body, without end of block.
pub(crate) fn block(sequence: &str, body: &Body) -> String {
    let name = if sequence.is_empty() { String::new() } else { format!("{sequence} ") };
    match body {
        Body::Empty => String::new(),
        Body::ProgramName(name) => name.to_string(),
        Body::Skipped => format!("{name}/"),
        Body::Items(items) => name + &joined(items),
        Body::Noex(items) => format!("{name}NOEX {}", joined(items)),
        Body::Statement(each) => name + &statement(each),
        Body::ContourCall(contour, items) => {
            let (head, others) = items.split_at(items.len().min(1));
            format!("{name}{} {contour} {}", joined(head), joined(others))
        }
        Body::Communication(each) => format!("{name}{} {}", each.keyword(), communication(each)),
    }
}

fn joined(items: &[Item]) -> String {
    items.iter().map(item).collect::<Vec<_>>().join(" ")
}

fn communication(statement: &Communication) -> String {
    match statement {
        Communication::Read(channel) | Communication::Write(channel) => channel.to_string(),
        Communication::Get(target, None) => variable(target),
        Communication::Get(target, Some(length)) => format!("{},{length}", variable(target)),
        Communication::Put(source, length) => format!("{},{length}", variable(source)),
        Communication::Skip(length) => format!(",{length}"),
        Communication::Append(codes) if codes.iter().all(|code| *code == b' ') => format!(",{}", codes.len()),
        Communication::Append(codes) => format!("${}", hexadecimal(codes)),
    }
}

fn hexadecimal(codes: &[u8]) -> String {
    codes.iter().map(|code| format!("{code:02X}")).collect()
}

fn characters(characters: &Characters) -> String {
    let plain = || characters.codes.iter().map(|code| char::from(*code)).collect::<String>();
    match characters.form {
        StringForm::Plain => format!("'{}'", plain()),
        StringForm::LowerCase => format!("^'{}'", plain().to_ascii_uppercase()),
        StringForm::Codes => format!("'${}'", hexadecimal(&characters.codes)),
    }
}

fn statement(statement: &Statement) -> String {
    let keyword = statement.label();
    match statement {
        Statement::Goto(name) => format!("{keyword} {name}"),
        Statement::If(Condition::Value(value), name) => {
            format!("{keyword}[{}]{name}", expression(value, Level::Or))
        }
        Statement::If(Condition::Registered(local), name) => format!("{keyword} {local} {name}"),
        Statement::Call(Callee::Program(name), items) | Statement::Modin(Callee::Program(name), items) => {
            format!("{keyword} {name} {}", joined(items))
        }
        Statement::Call(Callee::Code(_), items) | Statement::Modin(Callee::Code(_), items) => {
            format!("{keyword} {}", joined(items))
        }
        Statement::Return | Statement::Modout => keyword.to_string(),
    }
}

fn item(item: &Item) -> String {
    match &item.kind {
        ItemKind::Word(address, value) => word(*address, value),
        ItemKind::Assignment(target, value) => {
            format!("{}={}", variable(target), expression(value, Level::Or))
        }
        ItemKind::Comment(position, text) => {
            format!("VUACM[{}]={}", expression(position, Level::Or), characters(text))
        }
        ItemKind::MajorArc => "CALRG".to_owned(),
    }
}

fn word(address: Address, word: &Value) -> String {
    match (address, word) {
        (Address::Letter(_), Value::Number(number)) => format!("{}{}", address.label(), decimal(*number)),
        (Address::Extended(_), Value::Number(number)) => format!("{}={}", address.label(), decimal(*number)),
        // The bracket keeps a constant from being a plain number.
        (_, Value::Expression(value)) => format!("{}=[{}]", address.label(), expression(value, Level::Or)),
    }
}

fn decimal(number: Decimal) -> String {
    let scale = number.scale as usize;
    let digits = format!("{:0>width$}", number.digits.unsigned_abs(), width = scale);
    let (whole, fraction) = digits.split_at(digits.len() - scale);
    let sign = if number.digits < 0 { "-" } else { "" };
    let point = if number.point { "." } else { "" };
    format!("{sign}{whole}{point}{fraction}")
}

fn variable(variable: &Variable) -> String {
    match variable {
        Variable::Common(number) => format!("V{number}"),
        Variable::Local(name) => name.to_string(),
        Variable::System(system, None) => system.name.to_owned(),
        Variable::System(system, Some(suffix)) => {
            format!("{}[{}]", system.name, expression(suffix, Level::Or))
        }
    }
}

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

/// The text of an expression where nothing weaker than this may stand without brackets.
fn expression(value: &Expression, weakest: Level) -> String {
    let text = bare(value);
    if level(value) < weakest { format!("[{text}]") } else { text }
}

fn level(value: &Expression) -> Level {
    match value {
        Expression::Sign { .. } => Level::Sign,
        Expression::Not(_) => Level::Not,
        Expression::Binary(operator, _) => levels(*operator).0,
        _ => Level::Primary,
    }
}

/// The level of an operator, and the weakest of its left and right operand.
fn levels(operator: BinaryOperator) -> (Level, Level, Level) {
    use BinaryOperator::*;
    match operator {
        Or | ExclusiveOr => (Level::Or, Level::Or, Level::And),
        And => (Level::And, Level::And, Level::Not),
        Add | Subtract => (Level::Sum, Level::Sum, Level::Product),
        Multiply | Divide => (Level::Product, Level::Product, Level::Sign),
        _ => (Level::Comparison, Level::Sum, Level::Sum),
    }
}

fn bare(value: &Expression) -> String {
    match value {
        Expression::Integer(integer @ 0..=99_999_999) => integer.to_string(),
        Expression::Integer(pattern) => format!("${pattern:X}"),
        Expression::Real(number) => decimal(*number),
        Expression::Variable(name) => variable(name),
        Expression::Sign { minus, operand } => {
            format!("{}{}", if *minus { "-" } else { "+" }, expression(operand, Level::Sign))
        }
        Expression::Not(operand) => format!("NOT {}", expression(operand, Level::Not)),
        Expression::Binary(operator, operands) => {
            let [left, right] = operands.as_ref();
            let (_, of_left, of_right) = levels(*operator);
            format!(
                "{}{}{}",
                expression(left, of_left),
                operator_text(*operator),
                expression(right, of_right)
            )
        }
        Expression::Call(function, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(|each| expression(each, Level::Or)).collect();
            format!("{}[{}]", function_text(*function), arguments.join(","))
        }
    }
}

fn operator_text(operator: BinaryOperator) -> &'static str {
    use BinaryOperator::*;
    match operator {
        Add => "+",
        Subtract => "-",
        Multiply => "*",
        Divide => "/",
        Less => " LT ",
        LessOrEqual => " LE ",
        Equal => " EQ ",
        NotEqual => " NE ",
        Greater => " GT ",
        GreaterOrEqual => " GE ",
        And => " AND ",
        Or => " OR ",
        ExclusiveOr => " EOR ",
    }
}

fn function_text(function: Function) -> &'static str {
    match function {
        Function::Sin => "SIN",
        Function::Cos => "COS",
        Function::Tan => "TAN",
        Function::Atan => "ATAN",
        Function::Atan2 => "ATAN2",
        Function::Sqrt => "SQRT",
        Function::Abs => "ABS",
        Function::Bin => "BIN",
        Function::Bcd => "BCD",
        Function::Round => "ROUND",
        Function::Fix => "FIX",
        Function::Fup => "FUP",
        Function::UnitRound => "DROUND",
        Function::UnitFix => "DFIX",
        Function::UnitFup => "DFUP",
        Function::Mod => "MOD",
    }
}
