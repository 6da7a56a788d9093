//! The beginning of a block: program name, sequence name, block delete mark, statement.

use super::cursor::{Cursor, is_blank_after};
use super::items;
use super::source::Line;
use super::tree::{Block, Body};
use crate::controls::e100l::addresses::STATEMENTS;
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, Setup};

/// Reads the text of a block. The sequence name is handed out even if the rest is faulty.
pub fn parse(line: &Line, setup: &Setup, sequence: &mut Label) -> Outcome<Block> {
    line.check()?;
    let mut cursor = Cursor::new(&line.characters, line.place.end);
    let body = body(&mut cursor, setup, sequence)?;
    Ok(Block { sequence: *sequence, body })
}

fn body(cursor: &mut Cursor, setup: &Setup, sequence: &mut Label) -> Outcome<Body> {
    cursor.skip_blanks()?;
    if matches!(cursor.peek(), Some(b'O' | b':')) {
        return program_name(cursor);
    }
    let skips = setup.switches.block_delete;
    let mut deleted = delete_mark(cursor, false)?;
    if deleted {
        if skips { cursor.skip_plain_blanks() } else { cursor.skip_blanks()? }
    }
    if cursor.peek() == Some(b'N') && cursor.run() != "NOEX" {
        *sequence = sequence_name(cursor)?;
        if deleted && skips {
            return Ok(Body::Skipped);
        }
        cursor.skip_blanks()?;
        deleted = delete_mark(cursor, deleted)?;
    }
    if deleted && skips {
        return Ok(Body::Skipped);
    }
    cursor.skip_blanks()?;
    if matches!(cursor.peek(), Some(b'O' | b':')) {
        // E100L-DEL-03, E100L-NAME-03: neither a slash nor anything else stands with a program name.
        return fail(AlarmName::ProgramNameNotAlone, if deleted { DEL_03 } else { NAME_03 });
    }
    statement(cursor)?;
    let items = items::items(cursor, setup)?;
    let empty = items.is_empty() && sequence.is_empty();
    Ok(if empty { Body::Empty } else { Body::Items(items) })
}

/// E100L-NAME-01, E100L-NAME-02, E100L-NAME-03: `O`, or `:` for it (E100L-TAPE-03), and a name, alone in its block.
fn program_name(cursor: &mut Cursor) -> Outcome<Body> {
    cursor.advance(1);
    let name = cursor.run();
    cursor.advance(name.len());
    if !is_name(name.as_bytes(), 4) {
        return fail(AlarmName::ProgramNameMalformed, NAME_01);
    }
    if name.starts_with('O') {
        return fail(AlarmName::ProgramNameReserved, NAME_02);
    }
    cursor.skip_blanks()?;
    if cursor.peek().is_some() {
        return fail(AlarmName::ProgramNameNotAlone, NAME_03);
    }
    Ok(Body::ProgramName(Label::new(&format!("O{name}"))))
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

/// E100L-SEQ-01, E100L-SEQ-02: `N`, a name of 1 to 5 characters, and a delimiter.
fn sequence_name(cursor: &mut Cursor) -> Outcome<Label> {
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
    let delimiter = cursor.peek();
    if !is_blank_after(delimiter) && delimiter != Some(b'/') {
        return Err(Fault::new(AlarmName::SequenceDelimiterMissing, SEQ_02).at(cursor.span_from(start)));
    }
    let name = run.get(..length).unwrap_or_default();
    Ok(Label::new(&format!("N{name}")))
}

/// E100L-GCODE-03: a control statement begins its block; none is modelled yet.
fn statement(cursor: &mut Cursor) -> Outcome<()> {
    let run = cursor.run();
    if STATEMENTS.contains(&run.as_str()) {
        let start = cursor.mark();
        cursor.advance(run.len());
        return Err(Fault::about(AlarmName::NotModelled, GCODE_03, &run).at(cursor.span_from(start)));
    }
    Ok(())
}
