//! The items of a block: words, assignments, mnemonics (execution, chapter 3, Items).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label};

use super::arithmetic::digits::Digits;
use super::evaluate::push_number;
use super::fault::Fault;
use super::number::Number;
use super::parse::{KEYWORDS, Parser, check_digits};
use super::planted::{self, Bug};
use super::system::{Lookup, SystemVariable, lookup};
use super::task::LocalName;
use super::text::{Class, class};
use super::words::{Address, Item, Source};

/// Two-letter addresses that are not modelled.
const OTHER_EXTENDED: [&[u8]; 17] = [
    b"AA", b"AB", b"BC", b"IA", b"IB", b"KA", b"KB", b"LA", b"LB", b"RA", b"RB", b"TA", b"TB", b"UA", b"UB",
    b"WA", b"WB",
];

/// The modelled two-letter address of a name.
fn extended(name: &[u8]) -> Option<Address> {
    match name {
        b"SB" => Some(Address::SB),
        b"SA" => Some(Address::SA),
        b"QA" => Some(Address::QA),
        b"PZ" => Some(Address::PZ),
        b"PW" => Some(Address::PW),
        b"DA" => Some(Address::DA),
        b"DB" => Some(Address::DB),
        b"FA" => Some(Address::FA),
        b"FB" => Some(Address::FB),
        b"XA" => Some(Address::XA),
        b"XB" => Some(Address::XB),
        b"ZA" => Some(Address::ZA),
        b"ZB" => Some(Address::ZB),
        _ => None,
    }
}

/// Whether a name is a two-letter address, modelled or not.
pub fn is_extended(name: &[u8]) -> bool {
    extended(name).is_some() || is_other_extended(name)
}

fn is_other_extended(name: &[u8]) -> bool {
    OTHER_EXTENDED.contains(&name)
}

/// A plain number with what the G word needs to know of its writing.
struct Plain {
    number: Number,
    written: u32,
    signed: bool,
}

impl Parser<'_> {
    /// An item that begins with a letter.
    /// Another letter behind it makes it a name, else it is an address; V is neither (E100L-CTL-07).
    #[inline]
    pub(super) fn item(&mut self, letter: u8) -> Result<(), Fault> {
        let next = self.text.get(self.at + 1).map_or(Class::Illegal, |byte| class(*byte));
        if next == Class::Letter || letter == b'V' {
            return self.named_item();
        }
        self.at += 1;
        let address = match letter {
            b'A' => Address::A,
            b'B' => Address::B,
            b'C' => Address::C,
            b'D' => Address::D,
            b'E' => Address::E,
            b'F' => Address::F,
            b'G' => Address::G,
            b'H' => Address::H,
            b'I' => Address::I,
            b'J' => Address::J,
            b'K' => Address::K,
            b'L' => Address::L,
            b'M' => Address::M,
            b'P' => Address::P,
            b'Q' => Address::Q,
            b'R' => Address::R,
            b'S' => Address::S,
            b'T' => Address::T,
            b'U' => Address::U,
            b'W' => Address::W,
            b'X' => Address::X,
            b'Y' => Address::Y,
            b'Z' => Address::Z,
            b'N' => return Err(Fault::about(AlarmName::NotModelled, SEQ_01, Label::new("N"))),
            b'O' => return Fault::raise(AlarmName::ProgramNameNotAlone, NAME_03),
            _ => return Fault::raise(AlarmName::AddressUnknown, ADDR_01),
        };
        self.skip_ignored();
        let source = match self.peek() {
            Some(b'=') => {
                self.at += 1;
                self.value_after_equals(address)?
            }
            Some(b'0'..=b'9' | b'+' | b'-' | b'.') => {
                let plain = self.plain_number(address)?;
                self.checked_plain(address, &plain)?
            }
            Some(b'[' | b'$') => return Fault::raise(AlarmName::EqualSignMissing, FMT_02),
            _ => return Fault::raise(AlarmName::NumberMalformed, FMT_01),
        };
        self.push_word(address, source);
        Ok(())
    }

    /// P belongs to functions that are not modelled yet (E100L-ADDR-01): refuses the item read last, which begins with
    /// this letter.
    #[inline]
    pub(super) fn refuse_later_word(&self, letter: u8) -> Result<(), Fault> {
        if letter != b'P' || self.options.two_saddles {
            return Ok(());
        }
        match self.block.items.last().and_then(Item::address) {
            Some(address @ Address::P) => {
                Err(Fault::about(AlarmName::NotModelled, ADDR_01, Label::new(address.text())))
            }
            _ => Ok(()),
        }
    }

    fn push_word(&mut self, address: Address, source: Source) {
        self.block.has_length |= address.is_length();
        self.block.items.push(Item::Word(address, source));
    }

    /// The value after an equal sign: a plain number that stays alone, or an expression.
    #[inline(never)]
    fn value_after_equals(&mut self, address: Address) -> Result<Source, Fault> {
        let start = self.at;
        self.skip_ignored();
        let mut ahead = self.at;
        if matches!(self.peek(), Some(b'+' | b'-')) {
            ahead += 1;
            while self.text.get(ahead).is_some_and(|byte| class(*byte) == Class::Ignored) {
                ahead += 1;
            }
        }
        if self.text.get(ahead).is_some_and(|byte| byte.is_ascii_digit() || *byte == b'.') {
            let plain = self.plain_number(address);
            let digits_fault = |fault: &Fault| fault.name == AlarmName::TooManyDigits;
            if plain.as_ref().is_err_and(|fault| !digits_fault(fault)) || !self.operator_follows() {
                let plain = plain?;
                return self.checked_plain(address, &plain);
            }
            self.at = start;
        }
        self.expression().map(Source::Expression)
    }

    /// Whether a binary operator comes next, blanks aside.
    fn operator_follows(&mut self) -> bool {
        let start = self.at;
        let blanks = self.skip_blanks();
        let place = std::mem::replace(&mut self.at, start);
        blanks.is_ok()
            && match self.text.get(place) {
                Some(b'+' | b'-' | b'*' | b'/') => true,
                _ => super::expression::is_binary_word(self.run(place)),
            }
    }

    /// A plain number; its first character is a sign, a digit or a point.
    #[inline(always)]
    fn plain_number(&mut self, address: Address) -> Result<Plain, Fault> {
        let negative = self.peek() == Some(b'-');
        let signed = matches!(self.peek(), Some(b'+' | b'-'));
        self.at += usize::from(signed);
        let mut digits = Digits::default();
        while let Some(byte) = self.peek() {
            match byte {
                b'0'..=b'9' => digits.push(byte - b'0'),
                b'.' if digits.push_point() => {}
                b'.' => return Fault::raise(AlarmName::NumberMalformed, FMT_01),
                // Nothing inside a number; TAB and a comment end it (E100L-FMT-07).
                _ if class(byte) == Class::Ignored => {}
                _ => break,
            }
            self.at += 1;
        }
        let Digits { value, scale, written, point } = digits;
        if written == 0 {
            return Fault::raise(AlarmName::NumberMalformed, FMT_01);
        }
        check_digits(written - u32::from(planted::is(Bug::NineDigits)), point, address == Address::F)?;
        let digits = if negative { -value } else { value };
        Ok(Plain { number: Number::Decimal { digits, scale, point }, written, signed })
    }

    /// A plain number as a value; that of a G word is short, whole and unsigned.
    fn checked_plain(&self, address: Address, plain: &Plain) -> Result<Source, Fault> {
        if address == Address::G && (plain.written > 3 || plain.number.is_real() || plain.signed) {
            return Fault::raise(AlarmName::NumberMalformed, GCODE_01);
        }
        Ok(Source::Plain(plain.number))
    }

    /// An item that begins with two letters, or with V.
    #[inline(never)]
    fn named_item(&mut self) -> Result<(), Fault> {
        let name = self.run(self.at);
        let length = name.len();
        if name == b"CALRG" {
            if self.block.has(|item| *item == Item::Mnemonic) {
                return Fault::raise(AlarmName::DuplicateAddress, FMT_06);
            }
            self.at += length;
            self.block.items.push(Item::Mnemonic);
            return Ok(());
        }
        if name.first() == Some(&b'V') && !KEYWORDS.contains(&name) {
            return self.assignment();
        }
        if let Some(address) = extended(name) {
            self.at += length;
            self.skip_ignored();
            if self.peek() != Some(b'=') {
                return Fault::raise(AlarmName::EqualSignMissing, FMT_03);
            }
            self.at += 1;
            let source = self.value_after_equals(address)?;
            self.push_word(address, source);
            return Ok(());
        }
        let name = local_item(name)?;
        self.at += length;
        self.skip_blanks()?;
        if self.peek() != Some(b'=') {
            return Fault::raise(AlarmName::EqualSignMissing, FMT_02);
        }
        self.at += 1;
        let value = self.expression()?;
        self.block.has_assignment = true;
        self.block.items.push(Item::Local { name, value });
        Ok(())
    }

    /// An assignment to a common or system variable.
    fn assignment(&mut self) -> Result<(), Fault> {
        let variable = self.variable()?;
        let suffix = match variable {
            Variable::System(variable) => self.suffix(variable)?,
            Variable::Common(_) => None,
        };
        self.skip_blanks()?;
        if self.peek() != Some(b'=') {
            return Fault::raise(AlarmName::EqualSignMissing, FMT_02);
        }
        if let Variable::System(variable) = variable
            && let Some(rule) = variable.read_only()
        {
            return Fault::raise(AlarmName::VariableReadOnly, rule);
        }
        self.at += 1;
        self.block.has_assignment = true;
        if let (Variable::System(SystemVariable::Comment), Some(suffix)) = (&variable, suffix) {
            let text = self.comment()?;
            self.block.items.push(Item::Comment { suffix, text });
            return Ok(());
        }
        let value = self.expression()?;
        self.block.items.push(match variable {
            Variable::Common(number) => Item::Common { number, value },
            Variable::System(variable) => Item::System { variable, suffix, value },
        });
        Ok(())
    }

    /// The variable whose name stands here.
    pub fn variable(&mut self) -> Result<Variable, Fault> {
        let name = self.run(self.at);
        let length = name.len();
        let rest = name.get(1..).unwrap_or_default();
        let variable = match rest.first() {
            Some(b'0'..=b'9') if rest.iter().all(u8::is_ascii_digit) => {
                let number = rest.iter().fold(0_u32, |value, byte| {
                    value.saturating_mul(10).saturating_add(u32::from(byte - b'0'))
                });
                match u8::try_from(number) {
                    Ok(number @ 1..=200) if rest.len() <= 3 => {
                        let mut label = const { Label::new("V") };
                        push_number(&mut label, number.into());
                        self.refuse_on_two_saddles(label)?;
                        Variable::Common(number)
                    }
                    _ => return Fault::raise(AlarmName::VariableNumber, CVAR_01),
                }
            }
            Some(b'A'..=b'Z') => match lookup(name, self.options.w_axis) {
                Lookup::Modelled(_) | Lookup::Unspecified | Lookup::NotModelled
                    if self.options.two_saddles =>
                {
                    return Err(Fault::about(AlarmName::Unspecified, AX4_12, Label::from_bytes(name)));
                }
                Lookup::Modelled(variable) => Variable::System(variable),
                Lookup::Unspecified => {
                    return Err(Fault::about(AlarmName::Unspecified, SVTAB_05, Label::new("VUNIT")));
                }
                Lookup::NotModelled => {
                    return Err(Fault::about(AlarmName::NotModelled, SVTAB_01, Label::from_bytes(name)));
                }
                Lookup::Unknown => return Fault::raise(AlarmName::SystemVariableUnknown, SVAR_01),
            },
            _ => return Fault::raise(AlarmName::SystemVariableUnknown, SVAR_01),
        };
        self.at += length;
        Ok(variable)
    }

    /// The suffix of a system variable, where the table has one.
    pub fn suffix(&mut self, variable: SystemVariable) -> Result<Option<super::words::Code>, Fault> {
        let start = self.at;
        self.skip_blanks()?;
        let bracket = self.peek() == Some(b'[');
        if bracket != variable.has_suffix() {
            return Fault::raise(AlarmName::VariableSuffix, variable.suffix_rule());
        }
        if !bracket {
            self.at = start;
            return Ok(None);
        }
        self.at += 1;
        let code = self.expression()?;
        self.close_bracket()?;
        Ok(Some(code))
    }

    /// A closing bracket, blanks aside.
    pub fn close_bracket(&mut self) -> Result<(), Fault> {
        self.skip_blanks()?;
        if self.peek() != Some(b']') {
            return Fault::raise(AlarmName::BracketUnbalanced, AEXP_04);
        }
        self.at += 1;
        Ok(())
    }
}

/// A variable in a program.
pub enum Variable {
    Common(u8),
    System(SystemVariable),
}

/// The local variable that a name at item position means, if it is none of the words that have a meaning of
/// their own.
/// Extended addresses, keywords, functions and operators are reserved, as whole runs (E100L-LVAR-02).
fn local_item(name: &[u8]) -> Result<LocalName, Fault> {
    if is_other_extended(name) {
        return Err(Fault::about(AlarmName::NotModelled, FMT_03, Label::from_bytes(name)));
    }
    if KEYWORDS.contains(&name) {
        return Fault::raise(AlarmName::StatementMisplaced, GCODE_03);
    }
    if super::expression::is_reserved(name) {
        return Fault::raise(AlarmName::Format, FMT_01);
    }
    match name.first() {
        Some(b'N') => Err(Fault::about(AlarmName::NotModelled, SEQ_01, Label::new("N"))),
        Some(b'O') => Fault::raise(AlarmName::ProgramNameNotAlone, NAME_03),
        _ => LocalName::of(name),
    }
}
