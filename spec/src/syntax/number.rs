//! Numbers as they are written.

use super::cursor::Cursor;
use super::source::is_ignored;
use super::tree::Decimal;
use crate::fault::{Fault, Outcome, fail};
use crate::integer::Digits;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// A number and how many digits were written.
pub struct Written {
    /// The number.
    pub number: Decimal,
    /// Digits written, leading and trailing zeros included.
    pub count: u32,
}

impl Written {
    /// E100L-DEC-04, E100L-TYPE-02, E100L-TYPE-03: the number, if it has no more than eight digits. `of_feed`: it is the number of an F word.
    pub fn checked(self, of_feed: bool) -> Outcome<Decimal> {
        if self.count <= Digits::MOST {
            return Ok(self.number);
        }
        fail(
            AlarmName::TooManyDigits,
            if of_feed {
                DEC_04
            } else if self.number.point {
                TYPE_03
            } else {
                TYPE_02
            },
        )
    }
}

/// A plain number (E100L-DEC-02: its value is that of its digits, point or no point): `[+-] digits [. digits]`, ignored characters between them skipped (E100L-FMT-07).
pub fn plain(cursor: &mut Cursor) -> Outcome<Written> {
    let negative = cursor.peek() == Some(b'-');
    if negative || cursor.peek() == Some(b'+') {
        cursor.advance(1);
        cursor.skip_ignored();
    }
    digits(cursor, negative, true)
}

/// A constant of an expression: as a plain number, without sign and without blanks inside.
pub fn constant(cursor: &mut Cursor) -> Outcome<Decimal> {
    digits(cursor, false, false)?.checked(false)
}

fn digits(cursor: &mut Cursor, negative: bool, spaced: bool) -> Outcome<Written> {
    let mut digits = Digits::default();
    loop {
        match cursor.peek() {
            Some(digit @ b'0'..=b'9') => digits = digits.digit(digit - b'0'),
            Some(b'.') if !digits.point => digits.point = true,
            Some(b'.') => return fail(AlarmName::NumberMalformed, FMT_01),
            Some(code) if spaced && is_ignored(code) => {}
            _ => break,
        }
        cursor.advance(1);
    }
    let Digits { number, scale, point, count } = digits;
    if count == 0 {
        return fail(AlarmName::NumberMalformed, FMT_01);
    }
    let number = Decimal { digits: if negative { -number } else { number }, scale, point };
    Ok(Written { number, count })
}

/// E100L-MATH-18, E100L-AEXP-08: `$` and one to eight hexadecimal digits, the pattern of a 32-bit integer.
pub fn hexadecimal(cursor: &mut Cursor) -> Outcome<i32> {
    cursor.advance(1);
    let mut pattern: u32 = 0;
    let mut count = 0;
    while let Some(digit) =
        cursor.peek().filter(|code| !code.is_ascii_lowercase()).and_then(|code| char::from(code).to_digit(16))
    {
        pattern = pattern << 4 | digit;
        count += 1;
        cursor.advance(1);
    }
    if (1..=8).contains(&count) {
        Ok(pattern.cast_signed())
    } else {
        Err(Fault::new(AlarmName::NumberMalformed, MATH_18))
    }
}
