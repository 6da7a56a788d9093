//! Character strings of PUT and VUACM (E100L-GPUT-09, E100L-GPUT-13, E100L-VUACM-01, E100L-VUACM-04, E100L-VUACM-05).

use super::cursor::Cursor;
use super::items::{bracketed_number, equal_sign};
use super::source::is_ignored;
use super::tree::{Characters, ItemKind, StringForm};
use crate::controls::e100l::system_variables::COMMENT;
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId, Setup};

/// A string in quotation marks: the codes 20 to 5F but `'` and `%`, all of them plain characters. `rule` is the one
/// that says what a string is here.
pub fn string(cursor: &mut Cursor, rule: RuleId) -> Outcome<Characters> {
    let in_front = cursor.take(b'^');
    if !cursor.take(b'\'') {
        return fail(AlarmName::Format, rule);
    }
    let lower = in_front || cursor.take(b'^');
    let mut codes = Vec::new();
    loop {
        match cursor.peek() {
            // A string does not go on in the next line.
            None => return fail(AlarmName::Format, rule),
            Some(_) if cursor.at_continuation() => return fail(AlarmName::Format, rule),
            Some(b'\'') => break,
            Some(code @ b' '..=b'_') if code != b'%' => {
                codes.push(if lower { code.to_ascii_lowercase() } else { code });
            }
            Some(code) if is_ignored(code) => {}
            Some(_) => {
                let fault = Fault::new(AlarmName::IllegalCharacter, FMT_08);
                return Err(fault.at(cursor.offset()..cursor.offset() + 1));
            }
        }
        cursor.advance(1);
    }
    cursor.advance(1);
    if codes.is_empty() {
        return fail(AlarmName::Format, rule);
    }
    Ok(Characters { codes, form: if lower { StringForm::LowerCase } else { StringForm::Plain } })
}

/// E100L-VUACM-01: the comment of user alarms at its name, a position, `=` and a string.
pub fn comment(cursor: &mut Cursor, setup: &Setup) -> Outcome<ItemKind> {
    cursor.advance(COMMENT.len());
    let position = bracketed_number(cursor, setup, VUACM_01)?;
    equal_sign(cursor)?;
    cursor.skip_blanks()?;
    let written = string(cursor, VUACM_01)?;
    Ok(ItemKind::Comment(position, meant(written)?))
}

/// E100L-VUACM-04, E100L-VUACM-05: the characters that a string of the comment stands for.
fn meant(written: Characters) -> Outcome<Characters> {
    match written.codes.split_first() {
        Some((b'-', _)) if written.form == StringForm::Plain => {
            Err(Fault::about(AlarmName::Unspecified, VUACM_05, "kana"))
        }
        Some((b'$', digits)) if written.form == StringForm::Plain => match codes(digits) {
            Some(codes) if (1..=4).contains(&codes.len()) => {
                Ok(Characters { codes, form: StringForm::Codes })
            }
            _ => fail(AlarmName::NumberMalformed, VUACM_04),
        },
        _ => Ok(written),
    }
}

/// The codes that pairs of hexadecimal digits stand for; none if the digits are no pairs.
pub fn codes(digits: &[u8]) -> Option<Vec<u8>> {
    let value = |digit: &u8| match digit {
        b'0'..=b'9' => Some(digit - b'0'),
        b'A'..=b'F' => Some(digit - b'A' + 10),
        _ => None,
    };
    let pairs = digits.chunks(2).map(|pair| match pair {
        [high, low] => Some(value(high)? << 4 | value(low)?),
        _ => None,
    });
    pairs.collect()
}
