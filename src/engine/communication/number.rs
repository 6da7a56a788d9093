//! Numbers as characters: what GET accepts (E100L-GPUT-05) and what PUT writes (E100L-GPUT-07).

use turnspec_oracle::vocabulary::UnitSystem;

use crate::engine::arithmetic::digits::Digits;
use crate::engine::arithmetic::round::Rounding;
use crate::engine::arithmetic::scale::TEN;
use crate::engine::words::Operand;

/// The number that a field holds: blanks, a sign, digits with a point among them.
pub fn received(field: &[u8]) -> Option<Operand> {
    let blanks = field.iter().take_while(|byte| **byte == b' ').count();
    let number = field.get(blanks..)?;
    let (negative, number) = match number.split_first() {
        Some((b'-', rest)) => (true, rest),
        Some((b'+', rest)) => (false, rest),
        _ => (false, number),
    };
    let mut digits = Digits::default();
    for byte in number {
        match byte {
            b'0'..=b'9' => digits.push(byte - b'0'),
            b'.' if digits.push_point() => {}
            _ => return None,
        }
    }
    let Digits { value, scale, written, point } = digits;
    if !(1..=Digits::MOST).contains(&written) {
        return None;
    }
    let value = i32::try_from(if negative { -value } else { value }).ok()?;
    if !point {
        return Some(Operand::Integer(value));
    }
    let unit = i32::try_from(*TEN.get(usize::from(scale))?).ok()?;
    Some(Operand::Real(f64::from(value) / f64::from(unit)))
}

/// A length or an angle in the unit in which it is read, with the decimals of its increment.
pub fn dimension(amount: i64, angle: bool, unit_system: UnitSystem, shortest: bool) -> String {
    let (increment, decimals) = match (unit_system, angle) {
        (UnitSystem::Micrometre, _) | (UnitSystem::TenThousandthInch, true) => (1000, 0),
        (UnitSystem::TenMicrometre, _) => (1000, 1),
        (UnitSystem::Millimetre, _) | (UnitSystem::Inch, true) => (1000, 3),
        (UnitSystem::TenThousandthInch, false) => (2540, 0),
        (UnitSystem::Inch, false) => (2540, 4),
    };
    let value = Rounding::HalfAway.divide(amount.into(), increment);
    let mut digits = format!("{:0>1$}", value.unsigned_abs(), decimals + 1);
    if decimals > 0 {
        digits.insert(digits.len() - decimals, '.');
        if shortest {
            digits.truncate(digits.trim_end_matches('0').trim_end_matches('.').len());
        }
    }
    if value < 0 { format!("-{digits}") } else { digits }
}

#[cfg(test)]
mod tests {
    use super::{dimension, received};
    use crate::engine::words::Operand;
    use turnspec_oracle::vocabulary::UnitSystem::{Inch, Micrometre, Millimetre, TenMicrometre};

    #[test]
    fn fields_hold_numbers() {
        assert_eq!(received(b"  -5"), Some(Operand::Integer(-5)));
        assert_eq!(received(b"+.5"), Some(Operand::Real(0.5)));
        assert_eq!(received(b"12345678."), Some(Operand::Real(12_345_678.0)));
        for faulty in [b"".as_slice(), b".", b" - 1", b"1 ", b"--1", b"1.2.", b"123456789", b"1E2", b"\t1"] {
            assert_eq!(received(faulty), None, "{faulty:?}");
        }
    }

    #[test]
    fn dimensions_have_the_decimals_of_their_increment() {
        assert_eq!(dimension(-500_000, false, Millimetre, false), "-0.500");
        assert_eq!(dimension(-500_000, false, Millimetre, true), "-0.5");
        assert_eq!(dimension(-400, false, Millimetre, false), "0.000");
        assert_eq!(dimension(100_000_000, false, Millimetre, true), "100");
        assert_eq!(dimension(0, true, Millimetre, true), "0");
        assert_eq!(dimension(5_400_000, false, Inch, false), "0.2126");
        assert_eq!(dimension(5_400_000, false, TenMicrometre, false), "540.0");
        assert_eq!(dimension(500, true, Micrometre, true), "1");
    }
}
