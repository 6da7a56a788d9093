//! Decimal digits as nibbles (E100L-FUNC-10, E100L-FUNC-11).

/// The largest number that eight nibbles hold.
pub const LARGEST: u32 = 99_999_999;

/// E100L-FUNC-10: the number whose decimal digits are the nibbles; none when one is above 9.
#[must_use]
pub fn from_nibbles(pattern: u32) -> Option<u32> {
    (0..8).rev().try_fold(0, |value, place| {
        let nibble = pattern >> (4 * place) & 0xF;
        (nibble <= 9).then_some(value * 10 + nibble)
    })
}

/// E100L-FUNC-11: the decimal digits of a number as nibbles; of more than eight the last eight.
#[must_use]
pub fn to_nibbles(number: u32) -> u32 {
    let digit = |place: u32| number / 10_u32.pow(place) % 10;
    (0..8).fold(0, |pattern, place| pattern | digit(place) << (4 * place))
}
