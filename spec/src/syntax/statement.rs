//! Statements: a keyword or a macro code at the beginning of a block, and what must follow it (E100L-CTL-01 to -07).

use super::communication::communication;
use super::cursor::{Cursor, is_blank_after};
use super::expression::{close_bracket, expression, is_reserved};
use super::grammar::{called_name, sequence_name};
use super::items::{self, local_name};
use super::saddles::is_described;
use super::tree::{Address, Body, Callee, Condition, Function, Item, ItemKind, Statement, Value};
use crate::controls::e100l::addresses::{DELIMITED, OF_SCHEDULES, STATEMENTS};
use crate::controls::e100l::macros::{self, Macro};
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId, Setup};

/// E100L-CTL-02: the statement here, behind sequence name and slash, if the block holds one.
pub fn statement(cursor: &mut Cursor, setup: &Setup) -> Outcome<Option<Body>> {
    let start = cursor.mark();
    let statement = match keyword(cursor) {
        Ok(Some(keyword)) => of_keyword(keyword, cursor, setup).map(Some),
        Ok(None) => match contour_call(cursor, setup) {
            Ok(None) => of_macro_code(cursor, setup).map(|statement| statement.map(Body::Statement)),
            call => call,
        },
        Err(fault) => Err(fault),
    };
    statement.map_err(|fault| {
        let span = cursor.span_from(start);
        fault.at(span.start..span.end.max(span.start + 1))
    })
}

/// The keyword here, which is taken.
fn keyword(cursor: &mut Cursor) -> Outcome<Option<&'static str>> {
    let run = cursor.run();
    if let Some(keyword) = STATEMENTS.iter().find(|keyword| **keyword == run) {
        cursor.advance(run.len());
        return Ok(Some(keyword));
    }
    match DELIMITED.iter().find(|keyword| run.len() > 4 && run.starts_with(**keyword)) {
        Some(keyword) => Err(undelimited(keyword)),
        None => Ok(None),
    }
}

fn of_keyword(keyword: &str, cursor: &mut Cursor, setup: &Setup) -> Outcome<Body> {
    is_described(keyword, setup)?;
    if OF_SCHEDULES.contains(&keyword) {
        return Err(Fault::about(AlarmName::ScheduleStatement, SDF_02, keyword));
    }
    if keyword == "IF" {
        let (condition, name) = branch(cursor, setup)?;
        return Ok(Body::Statement(Statement::If(condition, name)));
    }
    delimited(keyword, cursor)?;
    if let Some(communication) = communication(keyword, cursor, setup)? {
        return Ok(Body::Communication(communication));
    }
    Ok(Body::Statement(match keyword {
        "GOTO" => Statement::Goto(destination(cursor, GOTO_01)?),
        "CALL" => Statement::Call(callee(cursor, CALL_01)?, settings(cursor, setup, CALL_01)?),
        "MODIN" => Statement::Modin(callee(cursor, MODIN_01)?, settings(cursor, setup, MODIN_01)?),
        "RTS" => {
            nothing_more(cursor, RTS_01)?;
            Statement::Return
        }
        "MODOUT" => {
            nothing_more(cursor, MODIN_04)?;
            Statement::Modout
        }
        _ => return settings(cursor, setup, NOEX_01).map(Body::Noex),
    }))
}

/// E100L-CTL-03: what follows a keyword is a blank or the end of the block.
pub(super) fn delimited(keyword: &str, cursor: &Cursor) -> Outcome<()> {
    if is_blank_after(cursor.peek()) { Ok(()) } else { Err(undelimited(keyword)) }
}

pub(super) fn undelimited(keyword: &str) -> Fault {
    Fault::about(AlarmName::StatementDelimiterMissing, CTL_03, keyword)
}

/// E100L-CTL-06: so must it be behind a name.
fn delimited_name(name: Label, cursor: &Cursor) -> Outcome<Label> {
    if is_blank_after(cursor.peek()) {
        return Ok(name);
    }
    Err(Fault::about(AlarmName::StatementDelimiterMissing, CTL_06, name.as_str()))
}

/// A sequence name, and nothing behind it.
pub(super) fn destination(cursor: &mut Cursor, rule: RuleId) -> Outcome<Label> {
    let name = named_block(cursor, rule)?;
    nothing_more(cursor, rule)?;
    Ok(name)
}

/// A sequence name.
fn named_block(cursor: &mut Cursor, rule: RuleId) -> Outcome<Label> {
    cursor.skip_blanks()?;
    // E100L-NOEX-01: NOEX is a keyword here too.
    if cursor.peek() != Some(b'N') || cursor.run() == "NOEX" {
        return fail(AlarmName::Format, rule);
    }
    sequence_name(cursor, false)
}

/// Nothing but blanks to the end of the block.
pub(super) fn nothing_more(cursor: &mut Cursor, rule: RuleId) -> Outcome<()> {
    cursor.skip_blanks()?;
    if cursor.peek().is_some() { fail(AlarmName::Format, rule) } else { Ok(()) }
}

/// E100L-IFST-01, E100L-IFST-02: a condition, and a sequence name with or without `GOTO`.
pub(super) fn branch(cursor: &mut Cursor, setup: &Setup) -> Outcome<(Condition, Label)> {
    cursor.skip_blanks()?;
    let condition = if cursor.take(b'[') {
        // E100L-CTL-04: a bracket needs no blank in front.
        let condition = expression(cursor, setup)?;
        close_bracket(cursor)?;
        Condition::Value(condition)
    } else {
        Condition::Registered(tested_name(cursor)?)
    };
    cursor.skip_blanks()?;
    let run = cursor.run();
    if run.starts_with("GOTO") {
        let goto = "GOTO";
        cursor.advance(goto.len());
        delimited(goto, cursor)?;
    }
    Ok((condition, destination(cursor, IFST_01)?))
}

/// E100L-IFST-02, E100L-LVAR-02: the local name that IF asks for.
fn tested_name(cursor: &mut Cursor) -> Outcome<Label> {
    let run = cursor.run();
    let two_letters = run.bytes().take(2).filter(u8::is_ascii_uppercase).count() == 2;
    if !two_letters || run.starts_with('V') || is_reserved(&run) || Function::of_name(&run).is_some() {
        return fail(AlarmName::Format, IFST_01);
    }
    cursor.advance(run.len());
    delimited_name(local_name(&run)?, cursor)
}

/// E100L-CALL-01, E100L-MODIN-01: the name of a program, with `O`.
fn callee(cursor: &mut Cursor, rule: RuleId) -> Outcome<Callee> {
    cursor.skip_blanks()?;
    if cursor.peek() != Some(b'O') {
        return fail(AlarmName::Format, rule);
    }
    let name = called_name(cursor)?;
    delimited_name(name, cursor).map(Callee::Program)
}

/// Assignments to the end of the block.
fn settings(cursor: &mut Cursor, setup: &Setup, rule: RuleId) -> Outcome<Vec<Item>> {
    let mut settings = Vec::new();
    while let Some(item) = items::any(cursor, setup)? {
        let address = match &item.kind {
            ItemKind::Assignment(..) | ItemKind::Comment(..) => {
                settings.push(item);
                continue;
            }
            ItemKind::Word(address, _) => address.label(),
            ItemKind::MajorArc => Label::new("CALRG"),
        };
        let fault = Fault::about(AlarmName::WordWithoutFunction, rule, address.as_str());
        return Err(fault.at(item.span));
    }
    Ok(settings)
}

/// E100L-MACRO-01, E100L-MACRO-02: a macro code and assignments; if it is none, nothing is taken.
fn of_macro_code(cursor: &mut Cursor, setup: &Setup) -> Outcome<Option<Statement>> {
    let start = cursor.mark();
    let is_code = matches!(cursor.peek(), Some(b'G' | b'M'));
    let word = if is_code { items::next(cursor, setup).ok().flatten() } else { None };
    let Some((code, kind)) = word.as_ref().and_then(macro_code) else {
        cursor.rewind(start);
        return Ok(None);
    };
    is_described(code.as_str(), setup)?;
    let rule = if code.as_str().starts_with('G') { MACRO_01 } else { MACRO_02 };
    let settings = settings(cursor, setup, rule)?;
    Ok(Some(match kind {
        Macro::Modal => Statement::Modin(Callee::Code(code), settings),
        Macro::Call => Statement::Call(Callee::Code(code), settings),
    }))
}

/// E100L-LAP-09: a call of LAP, G85 to G88, the name of its contour, and items; if it is none, nothing is taken.
fn contour_call(cursor: &mut Cursor, setup: &Setup) -> Outcome<Option<Body>> {
    let start = cursor.mark();
    let word = if cursor.peek() == Some(b'G') { items::next(cursor, setup).ok().flatten() } else { None };
    let Some(head) = word.filter(|word| matches!(word.kind.plain_g(), Some(85..=88))) else {
        cursor.rewind(start);
        return Ok(None);
    };
    if let Some(code) = head.kind.plain_g() {
        is_described(Label::of_code(b'G', code).as_str(), setup)?;
    }
    let contour = named_block(cursor, LAP_09)?;
    let mut items = vec![head];
    items.append(&mut items::items(cursor, setup)?);
    Ok(Some(Body::ContourCall(contour, items)))
}

/// The code of a word that is a macro code, written as a plain number.
fn macro_code(word: &Item) -> Option<(Label, Macro)> {
    let ItemKind::Word(Address::Letter(letter), Value::Number(number)) = &word.kind else { return None };
    let code = number.whole().and_then(|value| u16::try_from(value).ok())?;
    macros::kind(*letter, code).map(|kind| (Label::of_code(*letter, code), kind))
}
