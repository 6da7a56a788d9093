//! Numbers as they are written.

use super::cursor::Cursor;
use super::source::is_ignored;
use super::tree::Decimal;
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// E100L-DEC-04, E100L-TYPE-02, E100L-TYPE-03: digits of a number.
const DIGITS: u32 = 8;

/// A number and how many digits were written.
pub struct Written {
    /// The number.
    pub number: Decimal,
    /// Digits written, leading and trailing zeros included.
    pub count: u32,
}

impl Written {
    /// The number, if it has no more than eight digits. `of_feed`: it is the number of an F word.
    pub fn checked(self, of_feed: bool) -> Outcome<Decimal> {
        if self.count <= DIGITS {
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
    let mut number = Decimal { digits: 0, scale: 0, point: false };
    let mut count = 0;
    loop {
        match cursor.peek() {
            Some(digit @ b'0'..=b'9') => {
                count += 1;
                // Beyond the digits that are allowed the value does not matter.
                if count <= DIGITS {
                    number.digits = number.digits * 10 + i64::from(digit - b'0');
                    number.scale += u32::from(number.point);
                }
            }
            Some(b'.') if !number.point => number.point = true,
            Some(b'.') => return fail(AlarmName::NumberMalformed, FMT_01),
            Some(code) if spaced && is_ignored(code) => {}
            _ => break,
        }
        cursor.advance(1);
    }
    if count == 0 {
        return fail(AlarmName::NumberMalformed, FMT_01);
    }
    if negative {
        number.digits = -number.digits;
    }
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
