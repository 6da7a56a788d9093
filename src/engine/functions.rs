//! Operators and functions of expressions on their operands (execution, chapter 6).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, RuleId, Setup, UnitSystem};

use super::arithmetic::decimal_code;
use super::arithmetic::round::Rounding;
use super::exact::{self, SlowPaths};
use super::fault::Fault;
use super::number::Number;
use super::planted::{self, Bug};
use super::words::{Comparison, Function, Operand};

/// The dependence of the functions on the unit system.
#[derive(Clone, Copy, Debug)]
pub struct Scales {
    /// Function angles in a degree (E100L-FUNC-02).
    angle: f64,
    /// Steps of DROUND, DFIX, DFUP in a written 1.
    step: i64,
    /// A full turn in the angle unit of the addresses (VRUND).
    pub full_turn: f64,
}

impl Scales {
    /// The scales of a set-up.
    /// Steps in a written 1: 1000 in the 1 mm system, 10000 in 1 inch, 1 in the others (E100L-FUNC-15).
    pub fn new(setup: &Setup) -> Self {
        let (angle, step, full_turn) = match setup.unit_system {
            UnitSystem::Micrometre => (1000.0, 1, 360_000.0),
            UnitSystem::TenMicrometre => (100.0, 1, 36_000.0),
            UnitSystem::Millimetre => (1.0, 1000, 360.0),
            UnitSystem::TenThousandthInch => (10_000.0, 1, 360_000.0),
            UnitSystem::Inch => (1.0, 10_000, 360.0),
        };
        Self { angle, step, full_turn }
    }
}

/// A real result, which must be finite.
/// Reals are binary64 (E100L-TYPE-01).
fn real(value: f64, rule: RuleId) -> Result<Operand, Fault> {
    if value.is_finite() { Ok(Operand::Real(value)) } else { Fault::raise(AlarmName::RealOverflow, rule) }
}

/// An integer result, which must fit 32 bits.
/// Those of two's complement (E100L-TYPE-01).
fn integer(value: i64, rule: RuleId) -> Result<Operand, Fault> {
    i32::try_from(value).map(Operand::Integer).map_err(|_| Fault::new(AlarmName::IntegerOverflow, rule))
}

/// Sum (E100L-TYPE-08).
pub fn add(a: Operand, b: Operand) -> Result<Operand, Fault> {
    match (a, b) {
        (Operand::Integer(a), Operand::Integer(b)) => integer(i64::from(a) + i64::from(b), TYPE_08),
        _ => real(a.real() + b.real(), TYPE_08),
    }
}

/// Difference (E100L-TYPE-08).
pub fn subtract(a: Operand, b: Operand) -> Result<Operand, Fault> {
    match (a, b) {
        (Operand::Integer(a), Operand::Integer(b)) => integer(i64::from(a) - i64::from(b), TYPE_08),
        _ => real(a.real() - b.real(), TYPE_08),
    }
}

/// Product (E100L-TYPE-10).
pub fn multiply(a: Operand, b: Operand) -> Result<Operand, Fault> {
    real(a.real() * b.real(), TYPE_10)
}

/// Quotient (E100L-TYPE-10, E100L-AEXP-09).
pub fn divide(a: Operand, b: Operand) -> Result<Operand, Fault> {
    if b.real() == 0.0 {
        return Fault::raise(AlarmName::DivisionByZero, AEXP_09);
    }
    let quotient = a.real() / b.real();
    let whole =
        planted::is(Bug::IntegerQuotient) && matches!((a, b), (Operand::Integer(_), Operand::Integer(_)));
    real(if whole { quotient.trunc() } else { quotient }, TYPE_10)
}

/// Unary minus (E100L-TYPE-09).
pub fn negate(a: Operand) -> Result<Operand, Fault> {
    match a {
        Operand::Integer(a) => integer(-i64::from(a), TYPE_09),
        Operand::Real(a) => Ok(Operand::Real(-a)),
    }
}

/// Comparison (E100L-TYPE-11).
/// What is true counts as the integer 1, what is false as 0 (E100L-TYPE-01).
pub fn compare(comparison: Comparison, a: Operand, b: Operand) -> Operand {
    fn holds<T: PartialOrd>(comparison: Comparison, a: T, b: T) -> bool {
        match comparison {
            Comparison::Less => a < b,
            Comparison::LessEqual if planted::is(Bug::LessEqualStrict) => a < b,
            Comparison::LessEqual => a <= b,
            Comparison::Equal => a == b,
            Comparison::NotEqual => a != b,
            Comparison::Greater => a > b,
            Comparison::GreaterEqual => a >= b,
        }
    }
    let truth = match (a, b) {
        (Operand::Integer(a), Operand::Integer(b)) => holds(comparison, a, b),
        _ => holds(comparison, a.real(), b.real()),
    };
    Operand::Integer(truth.into())
}

/// The operand of a boolean operator (E100L-TYPE-12).
pub fn bits(a: Operand) -> Result<i32, Fault> {
    match cut(a, TYPE_12)? {
        Operand::Integer(value) => Ok(value),
        Operand::Real(_) => Fault::raise(AlarmName::IntegerOverflow, TYPE_12),
    }
}

fn cut(a: Operand, rule: RuleId) -> Result<Operand, Fault> {
    match a {
        Operand::Integer(_) => Ok(a),
        Operand::Real(value) => whole(value, Rounding::Cut, rule),
    }
}

/// A real number made an integer.
fn whole(value: f64, rounding: Rounding, rule: RuleId) -> Result<Operand, Fault> {
    if value.abs() >= 4.0e9 {
        return Fault::raise(AlarmName::IntegerOverflow, rule);
    }
    integer(Number::Real(value).whole(1, rounding), rule)
}

/// A function of one argument.
pub fn call(function: Function, a: Operand, scales: &Scales, slow: &mut SlowPaths) -> Result<Operand, Fault> {
    let domain = |rule| Fault::raise(AlarmName::FunctionDomain, rule);
    match function {
        // Of an angle in the unit of functions, degrees in the 1 mm system (E100L-MATH-09).
        Function::Sin => real(exact::sine_cosine(a.real() / scales.angle, slow).0, FUNC_03),
        Function::Cos if planted::is(Bug::CosineBySine) => {
            real(exact::sine_cosine(a.real() / scales.angle + 90.0, slow).0, FUNC_04)
        }
        Function::Cos => real(exact::sine_cosine(a.real() / scales.angle, slow).1, FUNC_04),
        Function::Tan => match exact::tangent(a.real() / scales.angle, slow) {
            Some(value) => real(value, FUNC_05),
            None => domain(FUNC_05),
        },
        // Over an abscissa of 1 it lies between −90 and 90 degrees (E100L-MATH-10).
        Function::Atan => real(exact::arc_tangent(a.real(), 1.0, slow) * scales.angle, FUNC_06),
        Function::Sqrt if a.real() < 0.0 => domain(FUNC_08),
        // Square root and absolute value (E100L-MATH-12).
        Function::Sqrt => real(a.real().sqrt(), FUNC_08),
        Function::Abs => real(a.real().abs(), FUNC_09),
        Function::Bin => from_decimal_code(a),
        Function::Bcd => to_decimal_code(a),
        // A whole number: the nearest one, cut off, raised (E100L-MATH-14).
        Function::Round if planted::is(Bug::RoundTiesToEven) => {
            to_integer(Operand::Real(a.real().round_ties_even()), Rounding::HalfAway)
        }
        Function::Round => to_integer(a, Rounding::HalfAway),
        Function::Fix => to_integer(a, Rounding::Cut),
        Function::Fup => to_integer(a, Rounding::Up),
        // The same at the place of the least increment (E100L-MATH-15).
        Function::Dround => to_step(a, Rounding::HalfAway, scales),
        Function::Dfix => to_step(a, Rounding::Cut, scales),
        Function::Dfup => to_step(a, Rounding::Up, scales),
        Function::Atan2 | Function::Mod => call_two(function, a, Operand::Integer(1), scales, slow),
    }
}

/// A function of two arguments.
pub fn call_two(
    function: Function,
    a: Operand,
    b: Operand,
    scales: &Scales,
    slow: &mut SlowPaths,
) -> Result<Operand, Fault> {
    let (a, b) = (a.real(), b.real());
    if function == Function::Mod {
        if b == 0.0 {
            return Fault::raise(AlarmName::DivisionByZero, FUNC_18);
        }
        // The remainder a − FIX(a/b)·b (E100L-MATH-16).
        let quotient = a / b;
        let quotient = if planted::is(Bug::ModSign) { quotient.floor() } else { quotient.trunc() };
        return real(a - quotient * b, FUNC_18);
    }
    if a == 0.0 && b == 0.0 {
        return Fault::raise(AlarmName::FunctionDomain, FUNC_07);
    }
    // The ordinate is written first (E100L-MATH-11).
    let angle = exact::arc_tangent(a, b, slow) * scales.angle;
    real(if planted::is(Bug::ArcTangentUlp) { angle.next_up() } else { angle }, FUNC_07)
}

/// ROUND, FIX, FUP: an integer stays as it is.
fn to_integer(a: Operand, rounding: Rounding) -> Result<Operand, Fault> {
    match a {
        Operand::Integer(_) => Ok(a),
        Operand::Real(value) => whole(value, rounding, FUNC_19),
    }
}

/// DROUND, DFIX, DFUP: a whole number of steps.
/// The nearest one (E100L-FUNC-15), cut toward zero (E100L-FUNC-16), raised away from it (E100L-FUNC-17).
#[allow(clippy::cast_precision_loss)]
fn to_step(a: Operand, rounding: Rounding, scales: &Scales) -> Result<Operand, Fault> {
    const MOST: i64 = 1 << 53;
    let value = a.real();
    if value.abs() > MOST as f64 {
        return Ok(Operand::Real(value));
    }
    let steps = Number::Real(value).whole(scales.step, rounding);
    if steps.unsigned_abs() > MOST.unsigned_abs() {
        return Ok(Operand::Real(value));
    }
    Ok(Operand::Real(steps as f64 / scales.step as f64))
}

/// BIN: eight decimal digits, one a nibble, as a number.
/// So it reads packed digits, whatever its title in the manual says (E100L-MATH-13).
fn from_decimal_code(a: Operand) -> Result<Operand, Fault> {
    let Operand::Integer(pattern) = cut(a, FUNC_19)? else {
        return Fault::raise(AlarmName::IntegerOverflow, FUNC_19);
    };
    match decimal_code::number(pattern.cast_unsigned()) {
        Some(value) => integer(value.into(), FUNC_19),
        None => Fault::raise(AlarmName::FunctionDomain, FUNC_10),
    }
}

/// BCD: a number of at most eight digits, one a nibble.
/// So it packs the digits of a whole number (E100L-MATH-13).
fn to_decimal_code(a: Operand) -> Result<Operand, Fault> {
    match u32::try_from(a.number().whole(1, Rounding::Cut)) {
        Ok(value @ 0..=decimal_code::MOST) => {
            Ok(Operand::Integer(decimal_code::pattern(value).cast_signed()))
        }
        _ => Fault::raise(AlarmName::FunctionDomain, FUNC_11),
    }
}

#[cfg(test)]
mod tests {
    use super::{Function, Operand, Scales, call, call_two};
    use crate::engine::exact::SlowPaths;
    use turnspec_oracle::vocabulary::Setup;

    fn of(function: Function, value: Operand) -> Option<Operand> {
        call(function, value, &Scales::new(&Setup::default()), &mut SlowPaths::default()).ok()
    }

    #[test]
    fn examples_of_the_manual() {
        use Operand::{Integer, Real};
        assert_eq!(of(Function::Bin, Integer(0x25)), Some(Integer(25)));
        assert_eq!(of(Function::Bcd, Integer(25)), Some(Integer(0x25)));
        assert_eq!(of(Function::Round, Real(127.63)), Some(Integer(128)));
        assert_eq!(of(Function::Fix, Real(127.63)), Some(Integer(127)));
        assert_eq!(of(Function::Fup, Real(127.63)), Some(Integer(128)));
        assert_eq!(of(Function::Dround, Real(13.26462)), Some(Real(13.265)));
        assert_eq!(of(Function::Dfix, Real(13.26462)), Some(Real(13.264)));
        assert_eq!(of(Function::Dfup, Real(13.26462)), Some(Real(13.265)));
        let scales = Scales::new(&Setup::default());
        let slow = &mut SlowPaths::default();
        let remainder = call_two(Function::Mod, Integer(17), Integer(5), &scales, slow);
        assert_eq!(remainder.ok(), Some(Real(2.0)));
    }

    #[test]
    fn domains() {
        use Operand::{Integer, Real};
        assert_eq!(of(Function::Bin, Integer(0x2a)), None);
        assert_eq!(of(Function::Bcd, Integer(-1)), None);
        assert_eq!(of(Function::Bcd, Real(99_999_999.9)), Some(Integer(0x9999_9999_u32.cast_signed())));
        assert_eq!(of(Function::Round, Real(2_147_483_647.5)), None);
        assert_eq!(of(Function::Fix, Real(-2_147_483_648.9)), Some(Integer(i32::MIN)));
        assert_eq!(of(Function::Sqrt, Real(-1.0)), None);
        assert_eq!(of(Function::Tan, Integer(90)), None);
    }
}
