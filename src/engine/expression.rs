//! Expressions into postfix order (E100L-AEXP-03 to -07). A block of 158 characters bounds the nesting.

use turnspec_oracle::vocabulary::AlarmName;
use turnspec_oracle::vocabulary::rule_ids::*;

use super::arithmetic::digits::Digits;
use super::arithmetic::scale::TEN;
use super::fault::Fault;
use super::items::{Variable, is_extended};
use super::parse::{KEYWORDS, Parser, check_digits};
use super::planted::{self, Bug};
use super::system::SystemVariable;
use super::task::LocalName;
use super::text::{Class, class};
use super::words::{Code, Comparison, Function, Operand, Operation};

/// Binding of the operators, weakest first.
mod level {
    pub const OR: u8 = 1;
    pub const AND: u8 = 2;
    pub const NOT: u8 = 3;
    pub const COMPARISON: u8 = 4;
    pub const SUM: u8 = 5;
    pub const PRODUCT: u8 = 6;
}

/// An operator that is a word.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Word {
    Binary(Operation2),
    Not,
}

/// A binary operator: its binding and its operation.
type Operation2 = (u8, Kind);

/// What a binary operator does.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Add,
    Subtract,
    Multiply,
    Divide,
    Compare(Comparison),
    And,
    Or,
    ExclusiveOr,
}

impl Kind {
    fn operation(self) -> Operation {
        match self {
            Self::Add => Operation::Add,
            Self::Subtract => Operation::Subtract,
            Self::Multiply => Operation::Multiply,
            Self::Divide => Operation::Divide,
            Self::Compare(comparison) => Operation::Compare(comparison),
            Self::And => Operation::And,
            Self::Or => Operation::Or,
            Self::ExclusiveOr => Operation::ExclusiveOr,
        }
    }

    fn is_boolean(self) -> bool {
        matches!(self, Self::And | Self::Or | Self::ExclusiveOr)
    }
}

/// The operator that a name is: a boolean one (E100L-MATH-01) or a comparison.
fn word(name: &[u8]) -> Option<Word> {
    use Comparison as C;
    Some(match name {
        b"NOT" => Word::Not,
        b"AND" => Word::Binary((level::AND, Kind::And)),
        b"OR" => Word::Binary((level::OR, Kind::Or)),
        b"EOR" if planted::is(Bug::ExclusiveOrBinding) => Word::Binary((level::AND, Kind::ExclusiveOr)),
        b"EOR" => Word::Binary((level::OR, Kind::ExclusiveOr)),
        b"LT" => Word::Binary((level::COMPARISON, Kind::Compare(C::Less))),
        b"LE" => Word::Binary((level::COMPARISON, Kind::Compare(C::LessEqual))),
        b"EQ" => Word::Binary((level::COMPARISON, Kind::Compare(C::Equal))),
        b"NE" => Word::Binary((level::COMPARISON, Kind::Compare(C::NotEqual))),
        b"GT" => Word::Binary((level::COMPARISON, Kind::Compare(C::Greater))),
        b"GE" => Word::Binary((level::COMPARISON, Kind::Compare(C::GreaterEqual))),
        _ => return None,
    })
}

/// Whether a run is exactly a binary operator.
pub fn is_binary_word(name: &[u8]) -> bool {
    matches!(word(name), Some(Word::Binary(_)))
}

/// Whether a run is one letter, alone or before a digit.
pub fn has_one_letter(name: &[u8]) -> bool {
    name.get(1).is_none_or(u8::is_ascii_digit)
}

/// Whether a name is a function or an operator.
pub fn is_reserved(name: &[u8]) -> bool {
    word(name).is_some() || function(name).is_some()
}

/// The function that a name is (E100L-MATH-01).
fn function(name: &[u8]) -> Option<Function> {
    Some(match name {
        b"SIN" => Function::Sin,
        b"COS" => Function::Cos,
        b"TAN" => Function::Tan,
        b"ATAN" => Function::Atan,
        b"ATAN2" => Function::Atan2,
        b"SQRT" => Function::Sqrt,
        b"ABS" => Function::Abs,
        b"BIN" => Function::Bin,
        b"BCD" => Function::Bcd,
        b"ROUND" => Function::Round,
        b"FIX" => Function::Fix,
        b"FUP" => Function::Fup,
        b"DROUND" => Function::Dround,
        b"DFIX" => Function::Dfix,
        b"DFUP" => Function::Dfup,
        b"MOD" => Function::Mod,
        _ => return None,
    })
}

impl Parser<'_> {
    /// An expression; it ends where the next token cannot continue it.
    pub fn expression(&mut self) -> Result<Code, Fault> {
        let start = self.length();
        self.operators(level::OR)?;
        Ok(Code { start, end: self.length() })
    }

    fn length(&self) -> u16 {
        u16::try_from(self.block.operations.len()).unwrap_or(u16::MAX)
    }

    /// Operators that bind at least as strongly as the least one.
    fn operators(&mut self, least: u8) -> Result<(), Fault> {
        let start = self.block.operations.len();
        self.skip_blanks()?;
        if least <= level::NOT && self.run(self.at) == b"NOT" {
            self.check_blanks_around(3, false)?;
            self.at += 3;
            if self.options.level_one {
                self.operation(Operation::NeedsBoolean);
            }
            self.operators(level::NOT)?;
            self.operation(Operation::Not);
        } else {
            self.signed()?;
        }
        let mut compared = false;
        loop {
            let before = self.at;
            self.skip_blanks()?;
            let Some((binding, kind, length)) = self.binary_operator()? else {
                self.at = before;
                return Ok(());
            };
            if binding < least {
                self.at = before;
                return Ok(());
            }
            if binding == level::COMPARISON && std::mem::replace(&mut compared, true) {
                return Fault::raise(AlarmName::Format, AEXP_03);
            }
            self.at += length;
            if kind.is_boolean() && self.options.level_one {
                self.block.operations.insert(start, Operation::NeedsBoolean);
            }
            let left = !(planted::is(Bug::RightAssociative) && kind == Kind::Subtract);
            self.operators(binding + u8::from(left))?;
            self.operation(kind.operation());
        }
    }

    /// The binary operator that stands here, with its length.
    /// Between operands + - * / are sum, difference, product and quotient (E100L-MATH-07, E100L-AEXP-02).
    fn binary_operator(&mut self) -> Result<Option<(u8, Kind, usize)>, Fault> {
        Ok(match self.peek() {
            Some(b'+') => Some((level::SUM, Kind::Add, 1)),
            Some(b'-') => Some((level::SUM, Kind::Subtract, 1)),
            Some(b'*') => Some((level::PRODUCT, Kind::Multiply, 1)),
            Some(b'/') => Some((level::PRODUCT, Kind::Divide, 1)),
            Some(b'A'..=b'Z') => {
                let name = self.run(self.at);
                let length = name.len();
                match word(name) {
                    Some(Word::Binary((binding, kind))) => {
                        self.check_blanks_around(length, binding == level::COMPARISON)?;
                        Some((binding, kind, length))
                    }
                    _ => None,
                }
            }
            _ => None,
        })
    }

    /// An operator word needs blanks around it (E100L-MATH-06, E100L-AEXP-03).
    fn check_blanks_around(&self, length: usize, comparison: bool) -> Result<(), Fault> {
        let rule = if comparison { AEXP_03 } else { MATH_06 };
        let not = self.run(self.at) == b"NOT";
        let before = self.at.checked_sub(1).and_then(|place| self.text.get(place)).copied();
        let fits_before = before.is_none_or(|byte| {
            matches!(class(byte), Class::Ignored | Class::Tab | Class::Close)
                || not && matches!(byte, b'[' | b',' | b'=')
        });
        if !fits_before {
            return Fault::raise(AlarmName::OperatorBlankMissing, rule);
        }
        let after = self.text.get(self.at + length).map(|byte| class(*byte));
        match after {
            None | Some(Class::Ignored | Class::Tab | Class::Open) => Ok(()),
            Some(_) => Fault::raise(AlarmName::OperatorBlankMissing, rule),
        }
    }

    /// Signs and a primary.
    /// In front of an operand + and - are signs (E100L-AEXP-02).
    fn signed(&mut self) -> Result<(), Fault> {
        let mut minus = 0;
        loop {
            self.skip_blanks()?;
            match self.peek() {
                Some(b'-') => minus += 1,
                Some(b'+') => {}
                _ => break,
            }
            self.at += 1;
        }
        self.primary()?;
        for _ in 0..if planted::is(Bug::SignsCollapse) { minus.min(1) } else { minus } {
            self.operation(Operation::Negate);
        }
        Ok(())
    }

    fn primary(&mut self) -> Result<(), Fault> {
        match self.peek() {
            Some(b'0'..=b'9' | b'.') => self.constant(),
            Some(b'$') => self.hexadecimal(),
            // What stands in brackets is computed first (E100L-MATH-17).
            Some(b'[') => {
                self.at += 1;
                self.operators(level::OR)?;
                self.close_bracket()
            }
            Some(b'A'..=b'Z') => self.named(),
            _ => Err(self.misplaced()),
        }
    }

    /// A constant where no other expression can stand.
    pub fn lone_constant(&mut self) -> Result<Code, Fault> {
        let start = self.length();
        self.constant()?;
        Ok(Code { start, end: self.length() })
    }

    /// A decimal constant: integer without a point, real with one.
    fn constant(&mut self) -> Result<(), Fault> {
        let mut digits = Digits::default();
        while let Some(byte) = self.peek() {
            match byte {
                b'0'..=b'9' => digits.push(byte - b'0'),
                b'.' if digits.push_point() => {}
                b'.' => return Fault::raise(AlarmName::NumberMalformed, FMT_01),
                _ => break,
            }
            self.at += 1;
        }
        let Digits { value, scale, written, point } = digits;
        if written == 0 {
            return Fault::raise(AlarmName::NumberMalformed, FMT_01);
        }
        check_digits(written, point, false)?;
        #[allow(clippy::cast_precision_loss)]
        let value = if point {
            // Both are exact, so the quotient is rounded once.
            Operand::Real(value as f64 / TEN[usize::from(scale)] as f64)
        } else {
            Operand::Integer(i32::try_from(value).unwrap_or(i32::MAX))
        };
        self.operation(Operation::Constant(value));
        Ok(())
    }

    /// A hexadecimal constant of one to eight digits.
    /// It is an integer: the 32-bit pattern, in two's complement (E100L-AEXP-08).
    fn hexadecimal(&mut self) -> Result<(), Fault> {
        self.at += 1;
        let (mut pattern, mut written) = (0_u32, 0_u32);
        while let Some(digit) = self.peek().and_then(hexadecimal_digit) {
            pattern = pattern << 4 | digit;
            written += 1;
            self.at += 1;
        }
        if written == 0 {
            return Fault::raise(AlarmName::NumberMalformed, MATH_18);
        }
        if written > 8 {
            return Fault::raise(AlarmName::NumberMalformed, MATH_18);
        }
        let pattern = if planted::is(Bug::HexadecimalSaturates) { pattern.min(0x7FFF_FFFF) } else { pattern };
        self.operation(Operation::Constant(Operand::Integer(pattern.cast_signed())));
        Ok(())
    }

    /// A function or a variable.
    fn named(&mut self) -> Result<(), Fault> {
        let name = self.run(self.at);
        let length = name.len();
        if word(name).is_some() {
            return Fault::raise(AlarmName::Format, AEXP_01);
        }
        if let Some(function) = function(name) {
            self.at += length;
            return self.call(function);
        }
        if name.first() == Some(&b'V') && !KEYWORDS.contains(&name) {
            return match self.variable()? {
                Variable::Common(number) => {
                    self.operation(Operation::Common(number));
                    Ok(())
                }
                Variable::System(variable) => {
                    self.check_readable(variable)?;
                    if variable == SystemVariable::Input && self.options.level_one {
                        self.operation(Operation::NeedsInput);
                    }
                    self.suffix(variable)?;
                    self.operation(Operation::System(variable));
                    Ok(())
                }
            };
        }
        if has_one_letter(name) || is_extended(name) || KEYWORDS.contains(&name) || name == b"CALRG" {
            return Fault::raise(AlarmName::Format, AEXP_01);
        }
        let local = LocalName::of(name)?;
        self.at += length;
        self.operation(Operation::Local(local));
        Ok(())
    }

    /// The arguments of a function in brackets (E100L-MATH-08).
    /// Two for ATAN2 and MOD, one for the others; blanks may stand in front of the bracket (E100L-FUNC-01).
    fn call(&mut self, function: Function) -> Result<(), Fault> {
        self.skip_blanks()?;
        if self.peek() != Some(b'[') {
            return Fault::raise(AlarmName::FunctionBracketMissing, MATH_08);
        }
        self.at += 1;
        if self.options.level_one {
            self.operation(Operation::NeedsFunction);
        }
        self.argument()?;
        if matches!(function, Function::Atan2 | Function::Mod) {
            self.skip_blanks()?;
            if self.peek() != Some(b',') {
                return Fault::raise(AlarmName::BracketUnbalanced, AEXP_04);
            }
            self.at += 1;
            self.argument()?;
        }
        self.close_bracket()?;
        self.operation(Operation::Call(function));
        Ok(())
    }

    /// Any expression (E100L-FUNC-01), functions of functions included (E100L-AEXP-10).
    fn argument(&mut self) -> Result<(), Fault> {
        self.skip_blanks()?;
        if matches!(self.peek(), None | Some(b']' | b',')) {
            return Fault::raise(AlarmName::BracketUnbalanced, AEXP_04);
        }
        self.operators(level::OR)
    }
}

/// The value of a hexadecimal digit.
pub fn hexadecimal_digit(byte: u8) -> Option<u32> {
    match byte {
        b'0'..=b'9' => Some(u32::from(byte - b'0')),
        b'A'..=b'F' => Some(u32::from(byte - b'A') + 10),
        _ => None,
    }
}
