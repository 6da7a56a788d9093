//! The beginning of a block: program name, sequence name, block delete mark; and which kind of block it is.

use super::cursor::{Cursor, is_blank_after};
use super::items;
use super::source::Line;
use super::statement;
use super::tree::{Block, Body};
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, Setup};

/// Reads the text of a block. The sequence name is handed out even if the rest is faulty.
pub fn parse(line: &Line, setup: &Setup, sequence: &mut Label) -> Outcome<Block> {
    line.check()?;
    let mut cursor = Cursor::new(&line.characters, line.place.end);
    let body = body(&mut cursor, setup, setup.switches.block_delete, sequence)?;
    Ok(Block { sequence: *sequence, body })
}

/// Reads what a block holds, whether the block delete switch would skip it or not.
pub fn parse_whole(line: &Line, setup: &Setup) -> Outcome<Body> {
    line.check()?;
    let mut cursor = Cursor::new(&line.characters, line.place.end);
    body(&mut cursor, setup, false, &mut Label::default())
}

fn body(cursor: &mut Cursor, setup: &Setup, skips: bool, sequence: &mut Label) -> Outcome<Body> {
    let Beginning { is_name, in_front, name } = beginning(cursor, skips)?;
    if is_name {
        return program_name(cursor);
    }
    *sequence = name.unwrap_or_default();
    if in_front && skips {
        return Ok(Body::Skipped);
    }
    cursor.skip_blanks()?;
    let deleted = if name.is_some() { delete_mark(cursor, in_front)? } else { in_front };
    if deleted && skips {
        return Ok(Body::Skipped);
    }
    cursor.skip_blanks()?;
    if matches!(cursor.peek(), Some(b'O' | b':')) {
        // E100L-DEL-03, E100L-NAME-03: neither a slash nor anything else stands with a program name.
        return fail(AlarmName::ProgramNameNotAlone, if deleted { DEL_03 } else { NAME_03 });
    }
    if let Some(body) = statement::statement(cursor, setup)? {
        return Ok(body);
    }
    let items = items::items(cursor, setup)?;
    let empty = items.is_empty() && sequence.is_empty();
    Ok(if empty { Body::Empty } else { Body::Items(items) })
}

/// What stands first in a block.
pub(super) struct Beginning {
    /// Whether it is a name block; the cursor is at its `O` or `:`.
    pub is_name: bool,
    /// Whether a slash stands in front of the sequence name, or of all else.
    pub in_front: bool,
    /// The sequence name; the cursor is behind it.
    pub name: Option<Label>,
}

/// Reads to the end of the sequence name.
pub(super) fn beginning(cursor: &mut Cursor, skips: bool) -> Outcome<Beginning> {
    cursor.skip_blanks()?;
    if matches!(cursor.peek(), Some(b'O' | b':')) {
        return Ok(Beginning { is_name: true, in_front: false, name: None });
    }
    let in_front = delete_mark(cursor, false)?;
    if in_front {
        if skips { cursor.skip_plain_blanks() } else { cursor.skip_blanks()? }
    }
    let named = cursor.peek() == Some(b'N') && cursor.run() != "NOEX";
    let name = if named { Some(sequence_name(cursor, true)?) } else { None };
    Ok(Beginning { is_name: false, in_front, name })
}

/// What the beginning of a block tells, whatever follows (execution.md, chapter 9).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Heading {
    /// A name block, with the name of its program unless that is malformed (E100L-NAME-01).
    Program(Option<Label>),
    /// The block has this sequence name.
    Sequence(Label),
    /// Neither.
    Nothing,
}

/// Reads the beginning of a block.
pub fn heading(line: &Line, setup: &Setup) -> Heading {
    let mut cursor = Cursor::new(&line.characters, line.place.end);
    let Ok(beginning) = beginning(&mut cursor, setup.switches.block_delete) else { return Heading::Nothing };
    if beginning.is_name {
        return Heading::Program(run_of_program_name(&mut cursor).ok());
    }
    beginning.name.map_or(Heading::Nothing, Heading::Sequence)
}

/// E100L-NAME-01, E100L-NAME-02, E100L-NAME-03: `O`, or `:` for it (E100L-TAPE-03), and a name, alone in its block.
fn program_name(cursor: &mut Cursor) -> Outcome<Body> {
    let name = called_name(cursor)?;
    cursor.skip_blanks()?;
    if cursor.peek().is_some() {
        return fail(AlarmName::ProgramNameNotAlone, NAME_03);
    }
    Ok(Body::ProgramName(name))
}

/// E100L-NAME-01, E100L-NAME-02: `O` and a name that does not begin with another `O`.
pub(super) fn called_name(cursor: &mut Cursor) -> Outcome<Label> {
    let name = run_of_program_name(cursor)?;
    if name.as_str().starts_with("OO") {
        return fail(AlarmName::ProgramNameReserved, NAME_02);
    }
    Ok(name)
}

/// E100L-NAME-01: the run behind `O` or `:`, with `O`.
fn run_of_program_name(cursor: &mut Cursor) -> Outcome<Label> {
    cursor.advance(1);
    let name = cursor.run();
    cursor.advance(name.len());
    if !is_name(name.as_bytes(), 4) {
        return fail(AlarmName::ProgramNameMalformed, NAME_01);
    }
    Ok(Label::new(&format!("O{name}")))
}

/// A letter and letters or digits, or digits alone; 1 to `most` characters.
fn is_name(name: &[u8], most: usize) -> bool {
    let Some(first) = name.first() else { return false };
    name.len() <= most && (first.is_ascii_uppercase() || name.iter().all(u8::is_ascii_digit))
}

/// E100L-DEL-01, E100L-DEL-02: a slash in front of the sequence name or directly behind it, not both.
fn delete_mark(cursor: &mut Cursor, already: bool) -> Outcome<bool> {
    if cursor.peek() != Some(b'/') {
        return Ok(already);
    }
    if already {
        return Err(Fault::new(AlarmName::SlashMisplaced, DEL_02).at(cursor.offset()..cursor.offset() + 1));
    }
    cursor.advance(1);
    Ok(true)
}

/// E100L-SEQ-01, E100L-SEQ-02, E100L-CTL-05: `N`, a name of 1 to 5 characters, and a delimiter; whether a slash is one.
pub(super) fn sequence_name(cursor: &mut Cursor, or_slash: bool) -> Outcome<Label> {
    let start = cursor.mark();
    cursor.advance(1);
    let run = cursor.run();
    let longest = (1..=run.len().min(5))
        .rev()
        .find(|length| is_name(run.as_bytes().get(..*length).unwrap_or_default(), 5));
    let Some(length) = longest else {
        return Err(Fault::new(AlarmName::SequenceNameMalformed, SEQ_01).at(cursor.span_from(start)));
    };
    cursor.advance(length);
    let delimited = is_blank_after(cursor.peek()) || or_slash && cursor.peek() == Some(b'/');
    if !delimited {
        return Err(Fault::new(AlarmName::SequenceDelimiterMissing, SEQ_02).at(cursor.span_from(start)));
    }
    let name = run.get(..length).unwrap_or_default();
    Ok(Label::new(&format!("N{name}")))
}
