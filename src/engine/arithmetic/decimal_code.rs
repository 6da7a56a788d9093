//! Binary-coded decimals: eight decimal digits, one a nibble (E100L-FUNC-10, E100L-FUNC-11).

/// Largest number of eight digits.
pub const MOST: u32 = 99_999_999;

/// The number that a pattern spells; none when a nibble is no decimal digit. At most [`MOST`].
#[must_use]
pub fn number(pattern: u32) -> Option<u32> {
    let mut value = 0;
    for place in (0..8).rev() {
        let nibble = pattern >> (4 * place) & 15;
        if nibble > 9 {
            return None;
        }
        value = value * 10 + nibble;
    }
    Some(value)
}

/// The pattern that spells a number of at most eight digits; of a longer one, its last eight.
#[must_use]
pub fn pattern(number: u32) -> u32 {
    let (mut pattern, mut rest) = (0, number);
    for place in 0..8 {
        pattern |= (rest % 10) << (4 * place);
        rest /= 10;
    }
    pattern
}
