//! What devices send: numbers in fields, with words between them, end codes, too much, nothing.

use turnspec_oracle::vocabulary::EndCode;

use super::AREA;
use crate::choices::Choices;

/// What stands before a number.
const LABELS: &[&[u8]] = &[
    b"",
    b"",
    b"",
    b" ",
    b"NO=",
    b"X",
    b" OFFS. ",
    b"\r\n",
    b"; ",
    b",",
    b"(A)",
    b"\xB6\xFF",
    b"--",
    b"1.2.3 ",
];

/// One transmission.
pub(crate) fn transmission(choices: &mut Choices<'_, '_>, code: EndCode) -> Vec<u8> {
    let mut text = match choices.below(24) {
        23 => Vec::new(),
        22 => vec![b'.'; AREA + 1 + choices.below(40)],
        21 => full(choices),
        _ => fields(choices, code),
    };
    if choices.chance(35) {
        text.push(end(code));
        if choices.chance(50) {
            text.extend_from_slice(choices.pick(&[b"34".as_slice(), b"\r\n", b"%", b"\0"]));
        }
    }
    text
}

/// The character of an end code.
fn end(code: EndCode) -> u8 {
    match code {
        EndCode::Percent => b'%',
        EndCode::Null => 0,
    }
}

/// As many characters as the area holds, digits at its end.
fn full(choices: &mut Choices<'_, '_>) -> Vec<u8> {
    let mut text = vec![b'*'; AREA];
    let number = choices.within(1, 999).to_string();
    text.truncate(AREA - number.len());
    text.extend_from_slice(number.as_bytes());
    text
}

/// Up to six numbers.
fn fields(choices: &mut Choices<'_, '_>, code: EndCode) -> Vec<u8> {
    let mut text = Vec::new();
    for _ in 0..=choices.below(6) {
        if choices.chance(6) {
            // The other end code is a character like any other.
            text.push(if code == EndCode::Null { b'%' } else { 0 });
        }
        text.extend_from_slice(choices.pick(LABELS));
        text.extend_from_slice(number(choices).as_bytes());
    }
    text
}

/// A number as GET reads it.
fn number(choices: &mut Choices<'_, '_>) -> String {
    let thousandths = choices.within(-99_999, 99_999) as f64 / 1_000.0;
    match choices.below(11) {
        0 => choices.within(0, 1).to_string(),
        1 => choices.within(0, 9).to_string(),
        2 => choices.within(0, 255).to_string(),
        3 => format!("{:4}", choices.within(-99, 999)),
        4 => format!("{thousandths:.3}"),
        5 => format!("{thousandths:9.2}"),
        6 => format!("{thousandths:+.1}"),
        7 => choices.pick(&[".5", "-.25", "+.125", "7.", "-0.", "00", "+5", "-0"]).to_owned(),
        8 => format!("{:06.2}", choices.within(0, 9_999) as f64 / 100.0),
        9 => choices.within(10_000_000, 99_999_999).to_string(),
        _ => format!("{:03}", choices.within(0, 99)),
    }
}
