//! Expressions of the user task: their structure, and their growth from choices.

use turnspec_oracle::vocabulary::Feature;

use crate::choices::Choices;
use crate::environment::Environment;
use crate::number::Number;

/// An expression. Brackets are the printer's affair.
#[derive(Clone, PartialEq, Debug)]
pub enum Expression {
    /// A constant; a negative one is printed with a sign.
    Constant(Number),
    /// A hexadecimal constant.
    Hex(u32),
    /// The value of a variable.
    Variable(Variable),
    /// `-` or, when false, `+`.
    Sign(bool, Box<Expression>),
    /// Bitwise complement.
    Not(Box<Expression>),
    /// Two operands.
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// A function with its arguments.
    Call(Function, Vec<Expression>),
}

/// A variable.
#[derive(Clone, PartialEq, Debug)]
pub enum Variable {
    /// `V1` to `V200`.
    Common(u8),
    /// A system variable.
    System(&'static str),
    /// A local variable.
    Local(&'static str),
    /// A system variable with a suffix.
    Indexed(&'static str, Box<Expression>),
}

/// A binary operator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Lt,
    Le,
    Eq,
    Ne,
    Gt,
    Ge,
    And,
    Or,
    Eor,
}

/// A function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Atan,
    Atan2,
    Sqrt,
    Abs,
    Bin,
    Bcd,
    Round,
    Fix,
    Fup,
    Dround,
    Dfix,
    Dfup,
    Mod,
}

impl Operator {
    /// Operators of numbers.
    pub const ARITHMETIC: [Self; 4] = [Self::Add, Self::Subtract, Self::Multiply, Self::Divide];
    /// Operators that give a logical value.
    pub const COMPARISON: [Self; 6] = [Self::Lt, Self::Le, Self::Eq, Self::Ne, Self::Gt, Self::Ge];
    /// Operators of bits.
    pub const BOOLEAN: [Self; 3] = [Self::And, Self::Or, Self::Eor];

    /// Its spelling.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Lt => "LT",
            Self::Le => "LE",
            Self::Eq => "EQ",
            Self::Ne => "NE",
            Self::Gt => "GT",
            Self::Ge => "GE",
            Self::And => "AND",
            Self::Or => "OR",
            Self::Eor => "EOR",
        }
    }
}

impl Function {
    /// Every function.
    pub const ALL: [Self; 16] = [
        Self::Abs,
        Self::Sin,
        Self::Cos,
        Self::Tan,
        Self::Atan,
        Self::Atan2,
        Self::Sqrt,
        Self::Bin,
        Self::Bcd,
        Self::Round,
        Self::Fix,
        Self::Fup,
        Self::Dround,
        Self::Dfix,
        Self::Dfup,
        Self::Mod,
    ];

    /// Its spelling.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Sin => "SIN",
            Self::Cos => "COS",
            Self::Tan => "TAN",
            Self::Atan => "ATAN",
            Self::Atan2 => "ATAN2",
            Self::Sqrt => "SQRT",
            Self::Abs => "ABS",
            Self::Bin => "BIN",
            Self::Bcd => "BCD",
            Self::Round => "ROUND",
            Self::Fix => "FIX",
            Self::Fup => "FUP",
            Self::Dround => "DROUND",
            Self::Dfix => "DFIX",
            Self::Dfup => "DFUP",
            Self::Mod => "MOD",
        }
    }

    /// The number of its arguments.
    #[must_use]
    pub fn arguments(self) -> usize {
        if matches!(self, Self::Atan2 | Self::Mod) { 2 } else { 1 }
    }
}

impl Expression {
    /// A constant.
    #[must_use]
    pub fn constant(number: Number) -> Self {
        Self::Constant(number)
    }

    /// Two operands.
    #[must_use]
    pub fn binary(operator: Operator, left: Self, right: Self) -> Self {
        Self::Binary(operator, Box::new(left), Box::new(right))
    }

    /// An expression of about this depth at most; boolean operators and functions only with User Task 2.
    pub fn grow(choices: &mut Choices<'_, '_>, environment: &Environment, depth: usize) -> Self {
        if depth == 0 || choices.chance(20) {
            return Self::leaf(choices, environment);
        }
        let weight = |weight, feature| if environment.allows(feature) { weight } else { 0 };
        let below = |choices: &mut Choices<'_, '_>| Box::new(Self::grow(choices, environment, depth - 1));
        match choices.weighted(&[
            (40, 0),
            (10, 1),
            (12, 2),
            (weight(30, Feature::Function), 3),
            (weight(8, Feature::Boolean), 4),
        ]) {
            0 => Self::Binary(choices.pick(&Operator::ARITHMETIC), below(choices), below(choices)),
            1 => Self::Sign(choices.chance(70), below(choices)),
            2 => Self::Binary(choices.pick(&Operator::COMPARISON), below(choices), below(choices)),
            3 => {
                let function = choices.pick(&Function::ALL);
                if function == Function::Round && choices.chance(30) {
                    let half = Number::decimal(10 * choices.within(0, 99) + 5, 1);
                    return Self::Call(function, vec![Self::Constant(half)]);
                }
                Self::Call(function, (0..function.arguments()).map(|_| *below(choices)).collect())
            }
            _ if choices.chance(30) => Self::Not(below(choices)),
            _ if choices.chance(25) => {
                let right = Self::Binary(Operator::And, below(choices), below(choices));
                Self::Binary(choices.pick(&Operator::BOOLEAN), below(choices), Box::new(right))
            }
            _ => Self::Binary(choices.pick(&Operator::BOOLEAN), below(choices), below(choices)),
        }
    }

    fn leaf(choices: &mut Choices<'_, '_>, environment: &Environment) -> Self {
        let weight = |weight, feature| if environment.allows(feature) { weight } else { 0 };
        let variables = weight(20, Feature::Variable);
        let system = weight(15, Feature::SystemVariable);
        let local = if environment.local.is_empty() { 0 } else { weight(20, Feature::LocalVariable) };
        let inputs =
            if environment.inputs.is_empty() { 0 } else { weight(10, Feature::InputOutput).min(system) };
        let stored = if environment.stored.is_empty() || environment.shared { 0 } else { system / 2 };
        match choices.weighted(&[
            (35, 0),
            (25, 1),
            (5, 2),
            (variables, 3),
            (system, 4),
            (local, 5),
            (inputs, 6),
            (stored, 7),
        ]) {
            0 => Self::Constant(Number::whole(choices.within(0, 360))),
            1 => {
                let decimals = choices.within(1, 4) as u8;
                let number = Number { mantissa: choices.within(0, 99_999), decimals, point: true };
                Self::Constant(number)
            }
            2 => Self::Hex(choices.pick(&[0x25, 0x10, 0xFF, 0x1234, 0, 0x99, 0xFFFF_FFFF, 0x7FFF_FFFF])),
            3 => Self::Variable(environment.some_common(choices)),
            5 => Self::Variable(environment.some_local(choices)),
            6 => Self::Variable(environment.some_input(choices)),
            7 => Self::Variable(environment.some_stored(choices)),
            _ => Self::Variable(environment.some_system(choices)),
        }
    }
}
