//! READ, WRITE, GET and PUT behind their keyword (E100L-RDWR-01, E100L-RDWR-02, E100L-GPUT-01 to -03, E100L-GPUT-07 to -10).

use super::cursor::Cursor;
use super::expression::is_reserved;
use super::items::{Role, local_name, may_be_written, variable};
use super::statement::nothing_more;
use super::string::{codes, string};
use super::tree::{Function, Variable};
use crate::fault::{Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId, Setup};

/// A statement of data communication.
#[derive(Clone, PartialEq, Debug)]
pub enum Communication {
    /// `READ` and a channel (E100L-RDWR-01).
    Read(u8),
    /// `WRITE` and a channel (E100L-RDWR-02).
    Write(u8),
    /// `GET`, a variable and the number of characters; without a number all that are left (E100L-GPUT-03).
    Get(Variable, Option<usize>),
    /// `GET` of characters that are passed over (E100L-GPUT-02).
    Skip(usize),
    /// `PUT` of a variable in so many characters (E100L-GPUT-07).
    Put(Variable, usize),
    /// `PUT` of characters: blanks, a string or codes (E100L-GPUT-08 to -10).
    Append(Vec<u8>),
}

impl Communication {
    /// Its keyword.
    pub fn keyword(&self) -> &'static str {
        match self {
            Self::Read(_) => "READ",
            Self::Write(_) => "WRITE",
            Self::Get(..) | Self::Skip(_) => "GET",
            Self::Put(..) | Self::Append(_) => "PUT",
        }
    }
}

/// E100L-GPUT-09, E100L-GPUT-10: how many characters one PUT appends as a string or as codes.
const LONGEST: usize = 16;

/// What follows a keyword of data communication; none for another keyword.
pub fn communication(keyword: &str, cursor: &mut Cursor, setup: &Setup) -> Outcome<Option<Communication>> {
    let read = match keyword {
        "READ" => |cursor: &mut Cursor, _: &Setup| channel(cursor, RDWR_01).map(Communication::Read),
        "WRITE" => |cursor: &mut Cursor, _: &Setup| channel(cursor, RDWR_02).map(Communication::Write),
        "GET" => get,
        "PUT" => put,
        _ => return Ok(None),
    };
    cursor.skip_blanks()?;
    read(cursor, setup).map(Some)
}

/// A channel, and nothing behind it.
fn channel(cursor: &mut Cursor, rule: RuleId) -> Outcome<u8> {
    let Some(number) = digits(cursor) else { return fail(AlarmName::Format, rule) };
    match u8::try_from(number) {
        Ok(channel @ 0..=9) => {
            nothing_more(cursor, rule)?;
            Ok(channel)
        }
        _ => fail(AlarmName::DeviceUnknown, rule),
    }
}

/// E100L-GPUT-01 to -03.
fn get(cursor: &mut Cursor, setup: &Setup) -> Outcome<Communication> {
    if cursor.peek() == Some(b',') {
        let length = length(cursor, GPUT_01)?;
        nothing_more(cursor, GPUT_01)?;
        return Ok(Communication::Skip(length));
    }
    let variable = named(cursor, setup, Role::Written, GPUT_01)?;
    may_be_written(&variable)?;
    cursor.skip_blanks()?;
    let length = if cursor.peek() == Some(b',') { Some(length(cursor, GPUT_01)?) } else { None };
    nothing_more(cursor, GPUT_01)?;
    Ok(Communication::Get(variable, length))
}

/// E100L-GPUT-07 to -10, E100L-GPUT-13.
fn put(cursor: &mut Cursor, setup: &Setup) -> Outcome<Communication> {
    match cursor.peek() {
        Some(b',') => {
            let blanks = vec![b' '; length(cursor, GPUT_07)?];
            nothing_more(cursor, GPUT_07)?;
            Ok(Communication::Append(blanks))
        }
        Some(b'\'' | b'^') => {
            let codes = string(cursor, GPUT_09)?.codes;
            if codes.len() > LONGEST {
                return fail(AlarmName::StringTooLong, GPUT_09);
            }
            nothing_more(cursor, GPUT_09)?;
            Ok(Communication::Append(codes))
        }
        Some(b'$') => hexadecimal(cursor).map(Communication::Append),
        _ => {
            let variable = named(cursor, setup, Role::Read, GPUT_07)?;
            cursor.skip_blanks()?;
            if cursor.peek() != Some(b',') {
                return fail(AlarmName::Format, GPUT_07);
            }
            let length = length(cursor, GPUT_07)?;
            nothing_more(cursor, GPUT_07)?;
            Ok(Communication::Put(variable, length))
        }
    }
}

/// E100L-GPUT-10: codes behind `$`.
fn hexadecimal(cursor: &mut Cursor) -> Outcome<Vec<u8>> {
    cursor.advance(1);
    let mut digits = Vec::new();
    while let Some(digit @ (b'0'..=b'9' | b'A'..=b'F')) = cursor.peek() {
        digits.push(digit);
        cursor.advance(1);
    }
    let Some(codes) = codes(&digits).filter(|codes| !codes.is_empty()) else {
        return fail(AlarmName::NumberMalformed, GPUT_10);
    };
    if codes.len() > LONGEST {
        return fail(AlarmName::StringTooLong, GPUT_10);
    }
    if codes.iter().any(|code| matches!(code, 0 | b'%')) {
        return fail(AlarmName::ForbiddenCode, GPUT_10);
    }
    nothing_more(cursor, GPUT_10)?;
    Ok(codes)
}

/// A variable; anything else is `format`.
fn named(cursor: &mut Cursor, setup: &Setup, role: Role, rule: RuleId) -> Outcome<Variable> {
    let run = cursor.run();
    if run.starts_with('V') && run != "VSET" {
        return variable(cursor, setup, role);
    }
    let two_letters = run.bytes().take(2).filter(u8::is_ascii_uppercase).count() == 2;
    if !two_letters || run.starts_with(['N', 'O']) || is_reserved(&run) || Function::of_name(&run).is_some() {
        return fail(AlarmName::Format, rule);
    }
    cursor.advance(run.len());
    local_name(&run).map(Variable::Local)
}

/// The number of characters behind a comma, 1 to 160.
fn length(cursor: &mut Cursor, rule: RuleId) -> Outcome<usize> {
    cursor.advance(1);
    cursor.skip_blanks()?;
    match digits(cursor) {
        Some(length @ 1..=160) => Ok(length),
        _ => fail(AlarmName::FieldLength, rule),
    }
}

/// A number of digits alone; one that is too large for any use stays so.
fn digits(cursor: &mut Cursor) -> Option<usize> {
    let mut number = None;
    while let Some(digit @ b'0'..=b'9') = cursor.peek() {
        number = Some(number.unwrap_or(0_usize).saturating_mul(10).saturating_add(usize::from(digit - b'0')));
        cursor.advance(1);
    }
    number
}
