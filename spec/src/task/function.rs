//! Functions (E100L-FUNC-01 to -19, E100L-MATH-09 to -16).

use super::number::{Number, finite, integer};
use crate::controls::e100l::units;
use crate::fault::{Outcome, fail};
use crate::integer::decimal_code;
use crate::quantity::{self, Exact, whole};
use crate::real;
use crate::syntax::Function;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId, UnitSystem};

/// The value of a function; its arguments are as many as it takes.
pub fn value(function: Function, arguments: &[Number], system: UnitSystem) -> Outcome<Number> {
    let first = arguments.first().copied().unwrap_or(Number::Integer(0));
    let second = arguments.get(1).copied().unwrap_or(Number::Integer(0));
    match function {
        Function::Sin => Ok(Number::Real(sin(&degrees(first, system)))),
        Function::Cos => Ok(Number::Real(sin(&(degrees(first, system) + whole(90))))),
        Function::Tan => tan(&degrees(first, system)),
        Function::Atan => finite(atan(&first.exact()) * units::function_angle_factor(system), FUNC_06),
        Function::Atan2 => atan2(first, second, system),
        Function::Sqrt if first.real() < 0.0 => fail(AlarmName::FunctionDomain, FUNC_08),
        Function::Sqrt => Ok(Number::Real(first.real().sqrt())),
        Function::Abs => Ok(Number::Real(first.real().abs())),
        Function::Bin => from_bcd(first.cut(FUNC_19)?),
        Function::Bcd => to_bcd(first),
        Function::Round => whole_number(first, quantity::round),
        Function::Fix => whole_number(first, quantity::cut),
        Function::Fup => whole_number(first, quantity::raise),
        Function::UnitRound => Ok(at_unit(first, system, quantity::round)),
        Function::UnitFix => Ok(at_unit(first, system, quantity::cut)),
        Function::UnitFup => Ok(at_unit(first, system, quantity::raise)),
        Function::Mod => remainder(first.real(), second.real()),
    }
}

/// E100L-FUNC-02: the argument in degrees.
fn degrees(argument: Number, system: UnitSystem) -> Exact {
    quantity::of_real(argument.real() / units::function_angle_factor(system))
}

fn is_multiple(value: &Exact, of: i32) -> bool {
    (value / whole(of)).is_int()
}

/// Bits that a number so small has behind the point before its first digit.
fn leading_zeros(value: &Exact) -> usize {
    let exponent = |part: &dashu_int::UBig| dashu_int::ops::BitTest::bit_len(part);
    exponent(value.denominator()).saturating_sub(exponent(&value.numerator().clone().into_parts().1))
}

/// E100L-FUNC-03, E100L-FUNC-04.
fn sin(degrees: &Exact) -> f64 {
    if is_multiple(degrees, 180) {
        return 0.0;
    }
    real::nearest_real(leading_zeros(degrees), |precision| real::sin_degrees(degrees, precision))
}

/// E100L-FUNC-05.
fn tan(degrees: &Exact) -> Outcome<Number> {
    if is_multiple(degrees, 180) {
        return Ok(Number::Real(0.0));
    }
    if is_multiple(degrees, 90) {
        return fail(AlarmName::FunctionDomain, FUNC_05);
    }
    Ok(Number::Real(real::nearest_real(leading_zeros(degrees), |precision| {
        real::tan_degrees(degrees, precision)
    })))
}

/// E100L-FUNC-06.
fn atan(argument: &Exact) -> f64 {
    if argument.is_zero() {
        return 0.0;
    }
    real::nearest_real(leading_zeros(argument), |precision| real::atan_degrees(argument, precision))
}

/// E100L-FUNC-07: the ordinate comes first.
fn atan2(ordinate: Number, abscissa: Number, system: UnitSystem) -> Outcome<Number> {
    let (y, x) = (ordinate.exact(), abscissa.exact());
    let angle = match (y.is_zero(), x.is_zero()) {
        (true, true) => return fail(AlarmName::FunctionDomain, FUNC_07),
        (true, false) if x > Exact::ZERO => 0.0,
        (false, false) if x > Exact::ZERO => atan(&(y / x)),
        _ => real::nearest_real(0, |precision| real::atan2_degrees(&y, &x, precision)),
    };
    finite(angle * units::function_angle_factor(system), FUNC_07)
}

/// E100L-FUNC-10: the nibbles as decimal digits.
fn from_bcd(pattern: i32) -> Outcome<Number> {
    match decimal_code::from_nibbles(pattern.cast_unsigned()) {
        Some(value) => Ok(Number::Integer(value.cast_signed())),
        None => fail(AlarmName::FunctionDomain, FUNC_10),
    }
}

/// E100L-FUNC-11: the decimal digits as nibbles.
fn to_bcd(argument: Number) -> Outcome<Number> {
    let value = quantity::cut(&argument.exact());
    match u32::try_from(value) {
        Ok(value @ 0..=decimal_code::LARGEST) => {
            Ok(Number::Integer(decimal_code::to_nibbles(value).cast_signed()))
        }
        _ => fail(AlarmName::FunctionDomain, FUNC_11),
    }
}

/// E100L-FUNC-12, E100L-FUNC-13, E100L-FUNC-14.
fn whole_number(argument: Number, rounded: fn(&Exact) -> dashu_int::IBig) -> Outcome<Number> {
    integer(&rounded(&argument.exact()), FUNC_19).map(Number::Integer)
}

/// E100L-FUNC-15, E100L-FUNC-16, E100L-FUNC-17: at the setting unit.
fn at_unit(argument: Number, system: UnitSystem, rounded: fn(&Exact) -> dashu_int::IBig) -> Number {
    let scale = units::unit_scale(system);
    let count = rounded(&(argument.exact() * whole(scale)));
    let largest = dashu_int::IBig::ONE << 53;
    if count > largest || count < -largest {
        return Number::Real(argument.real());
    }
    Number::Real(quantity::nearest_real(&whole(count)) / f64::from(scale))
}

/// E100L-FUNC-18: a - FIX[a/b] * b.
fn remainder(dividend: f64, divisor: f64) -> Outcome<Number> {
    const RULE: RuleId = FUNC_18;
    if divisor == 0.0 {
        return fail(AlarmName::DivisionByZero, RULE);
    }
    finite(dividend - (dividend / divisor).trunc() * divisor, RULE)
}

#[cfg(test)]
mod tests {
    use super::leading_zeros;
    use crate::quantity::ratio;

    #[test]
    fn small_numbers_need_more_bits() {
        assert_eq!(leading_zeros(&ratio(1, 1 << 20)), 20);
        assert_eq!(leading_zeros(&ratio(5, 1)), 0);
    }
}
