//! The number in the characters that GET takes (E100L-GPUT-05).

use crate::fault::{Outcome, fail};
use crate::integer::Digits;
use crate::quantity::{nearest_real, ratio};
use crate::task::Number;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// Blanks, a sign, digits with a point: an integer without a point, a real with one.
pub fn number(field: &[u8]) -> Outcome<Number> {
    match read(field) {
        Some(number) => Ok(number),
        None => fail(AlarmName::ReceivedNumber, GPUT_05),
    }
}

fn read(field: &[u8]) -> Option<Number> {
    let blanks = field.iter().take_while(|code| **code == b' ').count();
    let written = field.get(blanks..)?;
    let (negative, written) = match written.split_first() {
        Some((b'-', rest)) => (true, rest),
        Some((b'+', rest)) => (false, rest),
        _ => (false, written),
    };
    let mut digits = Digits::default();
    for code in written {
        match code {
            b'0'..=b'9' => digits = digits.digit(code - b'0'),
            b'.' if !digits.point => digits.point = true,
            _ => return None,
        }
    }
    let Digits { number, scale, point, count } = digits;
    if !(1..=Digits::MOST).contains(&count) {
        return None;
    }
    let number = if negative { -number } else { number };
    if point {
        return Some(Number::Real(nearest_real(&ratio(number, 10_u64.pow(scale)))));
    }
    i32::try_from(number).ok().map(Number::Integer)
}
