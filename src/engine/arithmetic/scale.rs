//! Plain decimals in small units: `digits / 10^scale * unit`, exactly (E100L-DEC-01, E100L-DEC-03).

use std::cmp::Ordering;

use super::round::Rounding;

/// Powers of ten, as far as they fit 64 bits.
pub const TEN: [i64; 19] = {
    let mut powers = [1_i64; 19];
    let mut next = 1;
    while next < 19 {
        powers[next] = powers[next - 1] * 10;
        next += 1;
    }
    powers
};

/// Compares `digits / 10^scale * unit` with a bound. Any digits, a scale of at most 18; unit and bound below
/// 2^60 in size.
#[inline]
#[must_use]
pub fn compare(digits: i64, scale: u8, unit: i64, bound: i64) -> Ordering {
    let (value, bound) = (i128::from(digits) * i128::from(unit), i128::from(bound));
    value.cmp(&(bound * i128::from(TEN[usize::from(scale)])))
}

/// `digits / 10^scale * unit / increment` made whole; none where a product leaves 64 bits, and the wide way
/// has to be gone. Any digits and unit, a scale of at most 18, a positive increment.
#[inline]
#[must_use]
pub fn increments(digits: i64, scale: u8, unit: i64, increment: i64, rule: Rounding) -> Option<i64> {
    let value = digits.checked_mul(unit)?;
    let divisor = TEN[usize::from(scale)].checked_mul(increment)?;
    Some(rule.divide_narrow(value, divisor))
}
