//! Evaluating a block from left to right (execution, chapter 4): values, repetitions, ranges.

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, InchConversion, Label, RuleId, Side, Sink};

use super::Interpreter;
use super::arithmetic::round::Rounding;
use super::arithmetic::tool::ToolWord;
use super::assignment::Origin;
use super::codes::{self, GGroup, Status};
use super::fault::Fault;
use super::functions;
use super::number::Number;
use super::planted::{self, Bug};
use super::sides;
use super::slot::Slot;
use super::words::{Address, Code, Function, Item, Operand, Operation, Parsed, Source, Words};

impl Interpreter<'_> {
    /// Evaluates the items of a block; its assignments are carried out at once.
    /// From left to right: each sees what those before it have set (E100L-AEXP-11).
    #[inline]
    pub(super) fn evaluate(&mut self, slot: &mut Slot, sink: &mut impl Sink) -> Result<(), Fault> {
        let Slot { parsed, words, .. } = slot;
        let parsed: &Parsed = parsed;
        words.clear();
        if !parsed.contour.is_empty() {
            self.begin_call(words);
        }
        for item in &parsed.items {
            match *item {
                Item::Word(address, source) => {
                    let number = match source {
                        Source::Plain(number) => number,
                        Source::Expression(code) => self.compute(parsed, code)?.number(),
                    };
                    self.word(words, address, number)?;
                }
                Item::Mnemonic => {
                    words.meet(Address::Calrg);
                }
                assignment => {
                    words.note_assignment();
                    self.assignment(parsed, assignment, Origin::Item, sink)?;
                }
            }
        }
        Ok(())
    }

    /// Takes one word into the block.
    #[inline]
    fn word(&self, words: &mut Words, address: Address, number: Number) -> Result<(), Fault> {
        match address {
            Address::G => return self.g_word(words, number),
            Address::M => return self.m_word(words, number),
            _ => {}
        }
        let passed = planted::is(Bug::DuplicateFeed) && address == Address::F;
        if !words.meet(address) && !passed {
            return Fault::raise(AlarmName::DuplicateAddress, FMT_06);
        }
        let value = match address {
            Address::X | Address::Z | Address::I | Address::K | Address::L | Address::R => {
                self.length(number, true)?
            }
            Address::XA | Address::XB | Address::ZA | Address::ZB => self.length(number, true)?,
            Address::Y if !self.state.contour.converts() => {
                return Fault::raise(AlarmName::AddressUnknown, ADDR_01);
            }
            Address::Y => self.length(number, true)?,
            Address::W => self.length(number, self.setup.options.w_axis && !words.calls_contour)?,
            Address::U | Address::H | Address::DB => self.length(number, false)?,
            Address::DA => self.length(number, !words.calls_contour)?,
            Address::D => {
                words.exact_d = number;
                self.length(number, false)?
            }
            Address::C => self.angle(number, 359_999_000)?,
            Address::A | Address::B => self.angle(number, 99_999_999_000)?,
            Address::E | Address::FA | Address::FB if self.is_contour_feed(words, address, number) => 0,
            Address::E | Address::FA | Address::FB => {
                let unit = self.units.feed[1];
                let most = self.units.feeds[1];
                ranged(number, unit, -most, most, ADDR_01)?;
                words.exact_e = number;
                number.rounded(unit, 1)
            }
            Address::F => {
                words.feed = number;
                0
            }
            Address::P => whole(number, 0, 9999, PSYNC_01)?,
            Address::S => whole(number, 0, 65_535, SPD_01)?,
            Address::SB => whole(number, 0, 65_535, SB_01)?,
            Address::QA => whole(number, 1, 1999, CAX_06)?,
            Address::PZ | Address::PW => whole(number, 1, 100, TRQ_01)?,
            Address::SA => {
                ranged(number, 1000, 1, 20_000, CAX_08)?;
                number.whole(1000, Rounding::HalfAway)
            }
            Address::T => self.tool_word(number)?,
            Address::J => divisor(number)?,
            Address::Q => whole(number, 0, 9999, ADDR_01)?,
            Address::G | Address::M | Address::Calrg => 0,
        };
        words.set(address, value);
        Ok(())
    }

    /// A length in nanometres, rounded to its increment (E100L-INCH-02).
    #[inline]
    fn length(&self, number: Number, signed: bool) -> Result<i64, Fault> {
        let units = &self.units;
        if let Number::Decimal { digits, scale, .. } = number
            && let Some(unit @ 1..) = units.last_digit.get(usize::from(scale)).copied()
        {
            // Nothing to round: at most eight digits of at most 10 000 000 nm.
            let value = digits * unit;
            if value > units.longest || value < if signed { -units.longest } else { 0 } {
                return Fault::raise(AlarmName::AddressRange, ADDR_01);
            }
            return Ok(value);
        }
        ranged(number, units.length, if signed { -units.longest } else { 0 }, units.longest, ADDR_01)?;
        let inch_increments = self.setup.readings.inch_conversion == InchConversion::InchIncrement;
        let increment = if units.inch && inch_increments { 2540 } else { 1000 };
        let cut = units.inch && !number.is_real() && !planted::is(Bug::WholeInchRounded);
        if cut || planted::is(Bug::LengthCut) {
            return Ok(number.cut(units.length, increment));
        }
        Ok(number.rounded(units.length, increment))
    }

    fn angle(&self, number: Number, most: i64) -> Result<i64, Fault> {
        ranged(number, self.units.angle, -most, most, ADDR_01)?;
        Ok(number.rounded(self.units.angle, 1000))
    }

    /// A T word: nose radius number, tool number, offset number (E100L-TOOL-02).
    fn tool_word(&self, number: Number) -> Result<i64, Fault> {
        let options = &self.setup.options;
        let most = if options.nose_radius_compensation { 999_999 } else { 9999 };
        if !number.within(1, 0, most) {
            return Fault::raise(AlarmName::ToolNumber, TOOL_01);
        }
        let value = number.whole(1, Rounding::HalfAway);
        if !ToolWord::new(value).exists(options.offset_sets) {
            return Fault::raise(AlarmName::ToolNumber, TOOL_03);
        }
        Ok(value)
    }

    fn g_word(&self, words: &mut Words, number: Number) -> Result<(), Fault> {
        let code = code_number(number, 999, ADDR_01)?;
        let detail = || Label::of_code(b'G', code);
        let group = match codes::g_code(code) {
            Status::Modelled if matches!(code, 14 | 111) && !sides::is_double(self.setup) => {
                return Err(Fault::about(AlarmName::TurretMissing, MIRR_01, detail()));
            }
            // A plain number makes a block of its own.
            Status::Modelled if matches!(code, 13 | 14) && self.state.other_turret.is_some() => {
                return Err(Fault::about(AlarmName::Unspecified, MIRR_03, detail()));
            }
            Status::Modelled if matches!(code, 13 | 14) && self.side.is_some() => {
                return Err(Fault::about(AlarmName::Unspecified, AX4_03, detail()));
            }
            Status::Modelled if matches!(code, 77 | 78) && !words.begins() => {
                return Err(Fault::about(AlarmName::StatementMisplaced, TAP_01, detail()));
            }
            Status::Modelled => codes::g_group(code).unwrap_or(GGroup::OneShot),
            Status::Unspecified => return Err(Fault::about(AlarmName::Unspecified, GTAB_01, detail())),
            Status::NotModelled if codes::is_g_macro(code) => {
                return Err(Fault::about(AlarmName::StatementMisplaced, MACRO_01, detail()));
            }
            Status::NotModelled => return Err(Fault::about(AlarmName::NotModelled, GTAB_01, detail())),
            Status::Unassigned => return Fault::raise(AlarmName::GCodeUnassigned, GTAB_01),
        };
        if matches!(code, 80..=88) {
            self.check_lap_code(words, code)?;
        }
        if words.has_g(code) {
            return Fault::raise(AlarmName::GCodesConflict, GCODE_04);
        }
        if !words.add_g(code, group) {
            return if group == GGroup::Dimension {
                Fault::raise(AlarmName::AbsoluteAndIncremental, ABS_04)
            } else {
                Fault::raise(AlarmName::GCodesConflict, GCODE_04)
            };
        }
        Ok(())
    }

    fn m_word(&self, words: &mut Words, number: Number) -> Result<(), Fault> {
        if !words.has_room_for_m() {
            return Fault::raise(AlarmName::TooManyM, FMT_06);
        }
        let code = code_number(number, 511, MCODE_01)?;
        let about = |name, rule| Err(Fault::about(name, rule, Label::of_code(b'M', code)));
        match codes::m_code(code) {
            Status::Unassigned => return Fault::raise(AlarmName::MCodeUnassigned, MTAB_01),
            _ if codes::is_m_macro(code) => return about(AlarmName::StatementMisplaced, MACRO_02),
            _ => {}
        }
        match code {
            21 if sides::is_double(self.setup) => return about(AlarmName::NotModelled, MCODE_09),
            25 if sides::is_double(self.setup) => return about(AlarmName::NotModelled, MCODE_11),
            110 if self.side.is_some() => return about(AlarmName::Unspecified, AX4_12),
            110 if self.state.selected == Side::B => return about(AlarmName::Unspecified, MIRR_20),
            _ => {}
        }
        if !words.add_m(code, codes::m_group_number(code)) {
            return Fault::raise(AlarmName::MCodesConflict, MCODE_01);
        }
        Ok(())
    }

    /// The value of an expression.
    pub(super) fn compute(&mut self, parsed: &Parsed, code: Code) -> Result<Operand, Fault> {
        let mut stack = std::mem::take(&mut self.stack);
        stack.clear();
        let operations = parsed.operations.get(usize::from(code.start)..usize::from(code.end));
        let result = self.run_operations(operations.unwrap_or_default(), &mut stack);
        self.stack = stack;
        result
    }

    fn run_operations(
        &mut self,
        operations: &[Operation],
        stack: &mut Vec<Operand>,
    ) -> Result<Operand, Fault> {
        const ZERO: Operand = Operand::Integer(0);
        for operation in operations {
            let mut pop = || stack.pop().unwrap_or(ZERO);
            let result = match *operation {
                Operation::Constant(value) => value,
                Operation::Common(number) => {
                    let place = number - u8::from(planted::is(Bug::VariableIndex) && number >= 100);
                    Operand::Real(self.state.common.get(usize::from(place)).copied().unwrap_or_default())
                }
                Operation::System(variable) => {
                    let suffix = if variable.has_suffix() {
                        Some(self.suffix(variable, pop().number())?)
                    } else {
                        None
                    };
                    self.read_variable(variable, suffix)?
                }
                Operation::Local(name) => Operand::Real(self.task.read_local(name)?),
                Operation::Negate => functions::negate(pop())?,
                // NOT inverts all 32 bits (E100L-MATH-05, E100L-BOOL-02).
                Operation::Not => Operand::Integer(!functions::bits(pop())?),
                Operation::Call(function @ (Function::Atan2 | Function::Mod)) => {
                    let (b, a) = (pop(), pop());
                    functions::call_two(function, a, b, &self.scales, &mut self.slow)?
                }
                Operation::Call(function) => functions::call(function, pop(), &self.scales, &mut self.slow)?,
                Operation::NeedsBoolean => return Fault::raise(AlarmName::UserTaskLevel, BOOL_01),
                Operation::NeedsInput => return Fault::raise(AlarmName::UserTaskLevel, IOV_01),
                Operation::NeedsFunction => return Fault::raise(AlarmName::UserTaskLevel, FUNC_20),
                binary => {
                    let (b, a) = (pop(), pop());
                    match binary {
                        // + - * / add, subtract, multiply and divide (E100L-MATH-07).
                        Operation::Add => functions::add(a, b)?,
                        Operation::Subtract => functions::subtract(a, b)?,
                        Operation::Multiply => functions::multiply(a, b)?,
                        Operation::Divide => functions::divide(a, b)?,
                        Operation::Compare(comparison) => functions::compare(comparison, a, b),
                        // Bit by bit: AND (E100L-MATH-04), OR (E100L-MATH-03), EOR (E100L-MATH-02).
                        Operation::And => Operand::Integer(functions::bits(a)? & functions::bits(b)?),
                        Operation::Or => Operand::Integer(functions::bits(a)? | functions::bits(b)?),
                        _ => Operand::Integer(functions::bits(a)? ^ functions::bits(b)?),
                    }
                }
            };
            stack.push(result);
        }
        Ok(stack.pop().unwrap_or(ZERO))
    }
}

/// Appends a whole number to a name.
pub fn push_number(label: &mut Label, number: u32) {
    if number >= 10 {
        push_number(label, number / 10);
    }
    label.push(b'0' + u8::try_from(number % 10).unwrap_or(0));
}

#[inline]
fn ranged(number: Number, unit: i64, low: i64, high: i64, rule: RuleId) -> Result<(), Fault> {
    if number.within(unit, low, high) { Ok(()) } else { Fault::raise(AlarmName::AddressRange, rule) }
}

/// The value of an address that takes whole numbers.
#[inline]
fn whole(number: Number, low: i64, high: i64, rule: RuleId) -> Result<i64, Fault> {
    if let Number::Decimal { digits, scale: 0, .. } = number {
        let fits = (low..=high).contains(&digits);
        return if fits { Ok(digits) } else { Fault::raise(AlarmName::AddressRange, rule) };
    }
    ranged(number, 1, low, high, rule)?;
    Ok(number.whole(1, Rounding::HalfAway))
}

/// The number of threads in the length F, 0 for one that is not whole (E100L-THRD-06).
fn divisor(number: Number) -> Result<i64, Fault> {
    let value = whole(number, 1, 9999, ADDR_01)?;
    Ok(if number.compare(1, value) == Ordering::Equal { value } else { 0 })
}

fn code_number(number: Number, most: i64, rule: RuleId) -> Result<u16, Fault> {
    let value = whole(number, 0, most, rule)?;
    u16::try_from(value).map_err(|_| Fault::new(AlarmName::AddressRange, rule))
}
