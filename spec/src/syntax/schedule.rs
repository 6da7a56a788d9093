//! The blocks of a schedule program (E100L-SDF-01 to -04, E100L-SDF-06, E100L-SDF-13, E100L-SDF-15 to -20).

use super::cursor::{Cursor, is_blank_after};
use super::expression::{constant, expression, is_reserved};
use super::file_name::{self, FileName};
use super::grammar::{Beginning, beginning, called_name};
use super::items::{self, local_name};
use super::source::Line;
use super::statement::{branch, delimited, destination, nothing_more, undelimited};
use super::tree::{Condition, Expression, Function, Item};
use crate::controls::e100l::addresses::{EXTENDED, EXTENDED_LATER, LETTERS};
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleSet, Setup};

/// What a block of a schedule program holds.
#[derive(Clone, PartialEq, Debug)]
pub enum ScheduleBlock {
    /// Nothing: it is no block.
    Empty,
    /// `PSELECT` (E100L-SDF-06).
    Select(Selection),
    /// `GOTO` and a sequence name (E100L-SDF-15).
    Goto(Label),
    /// `IF`, what decides, and a sequence name (E100L-SDF-16).
    If(Condition, Label),
    /// `VSET` and assignments (E100L-SDF-17).
    Set(Vec<Item>),
    /// `END` (E100L-SDF-20).
    End,
}

/// What PSELECT selects.
#[derive(Clone, PartialEq, Debug)]
pub struct Selection {
    /// The main program file.
    pub file: FileName,
    /// The name of the program in it, with its `O`.
    pub program: Option<Label>,
    /// The subprogram file.
    pub subprograms: Option<FileName>,
    /// How often it runs.
    pub repetitions: Option<Expression>,
}

/// Reads the text of a block. The sequence name is handed out even if the rest is faulty.
pub fn parse_schedule(line: &Line, setup: &Setup, sequence: &mut Label) -> Outcome<ScheduleBlock> {
    line.check()?;
    let mut cursor = Cursor::new(&line.characters, line.place.end);
    // Neither a header nor a tape mark is continued.
    if cursor.peek() == Some(b'$') {
        return fail(AlarmName::IllegalCharacter, FMT_08);
    }
    let Beginning { is_name, in_front, name } = beginning(&mut cursor, false)?;
    *sequence = name.unwrap_or_default();
    cursor.skip_blanks()?;
    let start = cursor.mark();
    if cursor.peek().is_none() && !is_name && name.is_none() {
        return Ok(ScheduleBlock::Empty);
    }
    let block = if is_name {
        fail(AlarmName::ScheduleBlock, SDF_02)
    } else if in_front || cursor.peek() == Some(b'/') {
        fail(AlarmName::ScheduleBlock, SDF_04)
    } else {
        statement(&mut cursor, setup)
    };
    block.map_err(|fault| {
        let span = cursor.span_from(start);
        fault.at(span.start..span.end.max(span.start + 1))
    })
}

/// What the beginning of a block tells, whatever follows.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ScheduleHeading {
    /// Its sequence name.
    pub name: Option<Label>,
    /// Whether it is the END block.
    pub is_end: bool,
}

/// Reads the beginning of a block.
pub fn schedule_heading(line: &Line) -> ScheduleHeading {
    let mut cursor = Cursor::new(&line.characters, line.place.end);
    match beginning(&mut cursor, false) {
        Ok(Beginning { is_name: false, name, .. }) => {
            let reached = cursor.skip_blanks().is_ok();
            if cursor.take(b'/') && cursor.skip_blanks().is_err() {
                return ScheduleHeading { name, is_end: false };
            }
            ScheduleHeading { name, is_end: reached && cursor.run() == "END" }
        }
        _ => ScheduleHeading::default(),
    }
}

fn statement(cursor: &mut Cursor, setup: &Setup) -> Outcome<ScheduleBlock> {
    let run = cursor.run();
    let keyword = run.as_str();
    if !matches!(keyword, "PSELECT" | "GOTO" | "IF" | "VSET" | "END") {
        // E100L-CTL-03: the blank is missing.
        return match ["GOTO", "IF"].iter().find(|keyword| run.len() > 4 && run.starts_with(**keyword)) {
            Some(keyword) => Err(undelimited(keyword)),
            None => fail(AlarmName::ScheduleBlock, SDF_02),
        };
    }
    cursor.advance(keyword.len());
    if matches!(keyword, "PSELECT" | "GOTO" | "VSET") {
        delimited(keyword, cursor)?;
    }
    Ok(match keyword {
        "PSELECT" => ScheduleBlock::Select(selection(cursor, setup)?),
        "GOTO" => ScheduleBlock::Goto(destination(cursor, GOTO_01)?),
        "IF" => {
            let (condition, name) = branch(cursor, setup)?;
            ScheduleBlock::If(condition, name)
        }
        "VSET" => ScheduleBlock::Set(settings(cursor, setup)?),
        _ => {
            nothing_more(cursor, SDF_20)?;
            ScheduleBlock::End
        }
    })
}

/// E100L-SDF-06: four items, each of which may be left out.
fn selection(cursor: &mut Cursor, setup: &Setup) -> Outcome<Selection> {
    cursor.skip_blanks()?;
    let file = main_file(file_name::written(cursor).unwrap_or_default().as_str())?;
    let mut selection = Selection { file, program: None, subprograms: None, repetitions: None };
    if next_item(cursor)? {
        if cursor.peek() == Some(b'O') {
            // E100L-SDF-08.
            selection.program = Some(called_name(cursor)?);
        }
        if next_item(cursor)? {
            selection.subprograms = subprogram_file(cursor)?;
            if next_item(cursor)? {
                selection.repetitions = repetitions(cursor, setup)?;
            }
        }
    }
    nothing_more(cursor, SDF_06)?;
    Ok(selection)
}

/// Takes the comma in front of the next item, if there is one.
fn next_item(cursor: &mut Cursor) -> Outcome<bool> {
    cursor.skip_blanks()?;
    let comma = cursor.take(b',');
    cursor.skip_blanks()?;
    Ok(comma)
}

/// E100L-SDF-07.
fn main_file(written: &str) -> Outcome<FileName> {
    if written.contains(['*', '?']) {
        return fail(AlarmName::FileWildcard, SDF_07);
    }
    match FileName::read(written, Some("A"), "MIN") {
        Some(file) => Ok(file),
        None => fail(AlarmName::FileNameMalformed, SDF_07),
    }
}

/// E100L-SDF-10: a file whose name has no default.
fn subprogram_file(cursor: &mut Cursor) -> Outcome<Option<FileName>> {
    let Some(written) = file_name::written(cursor) else { return Ok(None) };
    match FileName::read(&written, None, "SUB") {
        Some(file) => Ok(Some(file)),
        None => fail(AlarmName::FileNameMalformed, SDF_10),
    }
}

/// E100L-SDF-13: `Q`, and an expression behind `=` or a blank, or a constant.
fn repetitions(cursor: &mut Cursor, setup: &Setup) -> Outcome<Option<Expression>> {
    if !cursor.take(b'Q') {
        return Ok(None);
    }
    match cursor.peek() {
        Some(b'=') => {
            cursor.advance(1);
            expression(cursor, setup).map(Some)
        }
        Some(b'0'..=b'9' | b'.') => constant(cursor).map(Some),
        Some(code) if is_blank_after(Some(code)) => expression(cursor, setup).map(Some),
        _ => fail(AlarmName::EqualSignMissing, SDF_13),
    }
}

/// E100L-SDF-17: assignments, one at least, to the end of the block.
fn settings(cursor: &mut Cursor, setup: &Setup) -> Outcome<Vec<Item>> {
    let mut settings = Vec::new();
    loop {
        cursor.skip_blanks()?;
        left_side(cursor)?;
        match items::any(cursor, setup).map_err(right_side)? {
            Some(item) if item.kind.is_assignment() => settings.push(item),
            // CALRG.
            Some(_) => return fail(AlarmName::Format, SDF_17),
            None if settings.is_empty() => return fail(AlarmName::Format, SDF_17),
            None => return Ok(settings),
        }
    }
}

/// E100L-SDF-18: VSET sets no address, no local variable and no input.
fn left_side(cursor: &Cursor) -> Outcome<()> {
    let run = cursor.run();
    let name = run.as_str();
    let Some(first) = name.bytes().next().filter(u8::is_ascii_uppercase) else { return Ok(()) };
    let is_one = !name.as_bytes().get(1).is_some_and(u8::is_ascii_uppercase);
    let refused = if name.starts_with('V') {
        name == "VDIN"
    } else if is_one {
        LETTERS.contains(&first)
    } else if EXTENDED.contains(&name) || EXTENDED_LATER.contains(&name) {
        true
    } else {
        let is_other = is_reserved(name) || Function::of_name(name).is_some();
        !is_other && !name.starts_with(['N', 'O']) && local_name(name).is_ok()
    };
    if refused { fail(AlarmName::ScheduleLeftSide, SDF_18) } else { Ok(()) }
}

/// E100L-SDF-19: an output in an expression of VSET has an alarm of its own.
fn right_side(fault: Fault) -> Fault {
    if fault.alarm.name == AlarmName::Unspecified && fault.rules == RuleSet::of(&[IOV_02]) {
        let own = Fault::new(AlarmName::ScheduleRightSide, SDF_19);
        return Fault { span: fault.span, ..own };
    }
    fault
}
