//! The items of a block: words, assignments, the mnemonic.

use super::cursor::{Cursor, is_blank_after, is_blank_before};
use super::saddles::{has_two_saddles, is_described};
use super::tree::{Address, BinaryOperator, Expression, Function, Item, ItemKind, Value, Variable};
use super::{expression, number, string};
use crate::controls::e100l::addresses::{EXTENDED, EXTENDED_LATER, LETTERS, OPERATOR_WORDS, STATEMENTS};
use crate::controls::e100l::system_variables::{self, Quantity, SystemVariable};
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId, Setup};

/// Reads items to the end of the block.
pub fn items(cursor: &mut Cursor, setup: &Setup) -> Outcome<Vec<Item>> {
    let mut items: Vec<Item> = Vec::new();
    while let Some(item) = next(cursor, setup)? {
        if item.kind == ItemKind::MajorArc && items.iter().any(|item| item.kind == ItemKind::MajorArc) {
            return Err(Fault::new(AlarmName::DuplicateAddress, FMT_06).at(item.span));
        }
        items.push(item);
    }
    Ok(items)
}

/// The next item of a block of items. E100L-PSYNC-01: P is a word of two saddles alone.
pub fn next(cursor: &mut Cursor, setup: &Setup) -> Outcome<Option<Item>> {
    let item = any(cursor, setup)?;
    if let Some(Item { kind: ItemKind::Word(Address::Letter(b'P'), _), span }) = &item
        && !has_two_saddles(setup)
    {
        return Err(Fault::about(AlarmName::NotModelled, ADDR_01, "P").at(span.clone()));
    }
    Ok(item)
}

/// The next item of any block, one that no block takes yet included.
pub fn any(cursor: &mut Cursor, setup: &Setup) -> Outcome<Option<Item>> {
    cursor.skip_blanks()?;
    if cursor.peek().is_none() {
        return Ok(None);
    }
    let start = cursor.mark();
    let kind = item(cursor, setup).map_err(|fault| {
        let span = cursor.span_from(start);
        fault.at(span.start..span.end.max(span.start + 1))
    })?;
    Ok(Some(Item { kind, span: cursor.span_from(start) }))
}

fn item(cursor: &mut Cursor, setup: &Setup) -> Outcome<ItemKind> {
    match cursor.peek() {
        Some(b'/') => fail(AlarmName::SlashMisplaced, DEL_02),
        Some(b'V') if cursor.run() != "VSET" => assignment(cursor, setup),
        Some(b'A'..=b'Z') if cursor.look(1).is_some_and(|next| next.is_ascii_uppercase()) => {
            named(cursor, setup)
        }
        Some(letter @ b'A'..=b'Z') => {
            if !LETTERS.contains(&letter) {
                return Err(no_address(letter));
            }
            cursor.advance(1);
            word(cursor, Address::Letter(letter), setup)
        }
        _ => Err(cursor.unexpected()),
    }
}

/// Letters that begin no word here.
fn no_address(letter: u8) -> Fault {
    match letter {
        b'N' => Fault::about(AlarmName::NotModelled, SEQ_01, "N"),
        b'O' => Fault::new(AlarmName::ProgramNameNotAlone, NAME_03),
        _ => Fault::new(AlarmName::AddressUnknown, ADDR_01),
    }
}

/// An item that begins with two letters.
fn named(cursor: &mut Cursor, setup: &Setup) -> Outcome<ItemKind> {
    let run = cursor.run();
    let name = run.as_str();
    cursor.advance(name.len());
    if name == "CALRG" {
        return Ok(ItemKind::MajorArc);
    }
    if let Some(address) = EXTENDED.iter().find(|address| **address == name) {
        return word(cursor, Address::Extended(address), setup);
    }
    if EXTENDED_LATER.contains(&name) {
        return Err(Fault::about(AlarmName::NotModelled, FMT_03, name));
    }
    if STATEMENTS.contains(&name) {
        return fail(AlarmName::StatementMisplaced, GCODE_03);
    }
    if name == "NOT" || OPERATOR_WORDS.contains(&name) || Function::of_name(name).is_some() {
        return fail(AlarmName::Format, FMT_01);
    }
    match name.as_bytes().first() {
        Some(letter @ (b'N' | b'O')) => Err(no_address(*letter)),
        _ => setting(cursor, local_variable(name)?, setup),
    }
}

/// E100L-LVAR-01: a run that begins with two letters and is nothing else, as the name of a local variable.
pub fn local_name(run: &str) -> Outcome<Label> {
    if run.len() > 4 || run.starts_with(['N', 'O']) {
        let detail = run.get(..8).unwrap_or(run);
        return Err(Fault::about(AlarmName::LocalNameMalformed, LVAR_01, detail));
    }
    Ok(Label::new(run))
}

/// A local variable.
pub fn local_variable(run: &str) -> Outcome<Variable> {
    local_name(run).map(Variable::Local)
}

/// E100L-FMT-01, E100L-FMT-02, E100L-FMT-03: the value of a word.
fn word(cursor: &mut Cursor, address: Address, setup: &Setup) -> Outcome<ItemKind> {
    cursor.skip_ignored();
    let value = if cursor.take(b'=') {
        value_after_equal_sign(cursor, address, setup)?
    } else {
        match (address, cursor.peek()) {
            (Address::Extended(_), _) => return fail(AlarmName::EqualSignMissing, FMT_03),
            (_, Some(b'[' | b'$')) => return fail(AlarmName::EqualSignMissing, FMT_02),
            _ => Value::Number(plain_number(cursor, address)?),
        }
    };
    Ok(ItemKind::Word(address, value))
}

fn plain_number(cursor: &mut Cursor, address: Address) -> Outcome<super::tree::Decimal> {
    let signed = matches!(cursor.peek(), Some(b'+' | b'-'));
    let written = number::plain(cursor)?;
    let count = written.count;
    let number = written.checked(address == Address::Letter(b'F'))?;
    if address == Address::Letter(b'G') && (count > 3 || number.point || signed) {
        return fail(AlarmName::NumberMalformed, GCODE_01);
    }
    Ok(number)
}

/// After `=`: a plain number, or an expression. A number that an operator follows begins an expression.
fn value_after_equal_sign(cursor: &mut Cursor, address: Address, setup: &Setup) -> Outcome<Value> {
    let start = cursor.mark();
    cursor.skip_ignored();
    let number_begins = cursor.mark();
    if matches!(cursor.peek(), Some(b'+' | b'-')) {
        cursor.advance(1);
        cursor.skip_ignored();
    }
    let is_number = matches!(cursor.peek(), Some(b'0'..=b'9' | b'.'));
    cursor.rewind(number_begins);
    if is_number {
        number::plain(cursor)?;
        // A comment without end behind the number is a fault of what follows.
        if !matches!(operator_follows(cursor), Ok(true)) {
            cursor.rewind(number_begins);
            return plain_number(cursor, address).map(Value::Number);
        }
    }
    cursor.rewind(start);
    expression::expression(cursor, setup).map(Value::Expression)
}

fn operator_follows(cursor: &mut Cursor) -> Outcome<bool> {
    cursor.skip_blanks()?;
    let sign = matches!(cursor.peek(), Some(b'+' | b'-' | b'*' | b'/'));
    Ok(sign || BinaryOperator::of_word(&cursor.run()).is_some())
}

/// E100L-AEXP-01: a variable, `=` and an expression, or a string for the comment of user alarms (E100L-VUACM-01).
fn assignment(cursor: &mut Cursor, setup: &Setup) -> Outcome<ItemKind> {
    if cursor.run() == system_variables::COMMENT {
        is_described(system_variables::COMMENT, setup)?;
        return string::comment(cursor, setup);
    }
    let target = variable(cursor, setup, Role::Written)?;
    setting(cursor, target, setup)
}

/// E100L-FMT-02: the rest of an assignment.
fn setting(cursor: &mut Cursor, target: Variable, setup: &Setup) -> Outcome<ItemKind> {
    equal_sign(cursor)?;
    may_be_written(&target)?;
    let value = expression::expression(cursor, setup)?;
    Ok(ItemKind::Assignment(target, value))
}

/// E100L-FMT-02: `=` behind a variable.
pub fn equal_sign(cursor: &mut Cursor) -> Outcome<()> {
    cursor.skip_blanks()?;
    if cursor.take(b'=') { Ok(()) } else { fail(AlarmName::EqualSignMissing, FMT_02) }
}

/// E100L-SVTAB-01, E100L-IOV-01, E100L-IORD-01: not every variable can be written.
pub fn may_be_written(variable: &Variable) -> Outcome<()> {
    match variable {
        Variable::System(system @ SystemVariable { rule: None, .. }, _) => {
            fail(AlarmName::VariableReadOnly, system.form())
        }
        _ => Ok(()),
    }
}

/// What a variable is named for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// Its value is asked for.
    Read,
    /// It is to be set.
    Written,
}

/// E100L-CVAR-01, E100L-SVAR-01: a common or a system variable, at its `V`.
pub fn variable(cursor: &mut Cursor, setup: &Setup, role: Role) -> Outcome<Variable> {
    let run = cursor.run();
    cursor.advance(run.len());
    let name = run.get(1..).unwrap_or_default();
    if name.bytes().next().is_some_and(|first| first.is_ascii_digit()) {
        return common_variable(name, setup);
    }
    if system_variables::is_known(&run) {
        is_described(&run, setup)?;
    }
    let Some(system) = system_variables::MODELLED.iter().find(|each| each.name == run) else {
        if run == system_variables::UNIT_SYSTEM {
            return Err(Fault::about(AlarmName::Unspecified, SVTAB_05, &run));
        }
        if run == system_variables::COMMENT {
            // It holds text, no number.
            return Err(Fault::about(AlarmName::Unspecified, VUACM_01, &run));
        }
        let later = system_variables::LATER.contains(&run.as_str());
        return Err(if later {
            Fault::about(AlarmName::NotModelled, SVTAB_01, &run)
        } else {
            Fault::new(AlarmName::SystemVariableUnknown, SVAR_01)
        });
    };
    if system.needs_w() && !setup.options.w_axis {
        return Err(Fault::about(AlarmName::NotModelled, SVTAB_01, &run));
    }
    if system.quantity == Quantity::Output && role == Role::Read {
        return Err(Fault::about(AlarmName::Unspecified, IOV_02, &run));
    }
    let suffix = suffix(cursor, setup, system.has_suffix(), system.form())?;
    Ok(Variable::System(system, suffix))
}

fn common_variable(digits: &str, setup: &Setup) -> Outcome<Variable> {
    if !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return fail(AlarmName::SystemVariableUnknown, SVAR_01);
    }
    match digits.parse::<u8>() {
        Ok(number) if digits.len() <= 3 && (1..=200).contains(&number) => {
            is_described(&format!("V{number}"), setup)?;
            Ok(Variable::Common(number))
        }
        _ => fail(AlarmName::VariableNumber, CVAR_01),
    }
}

/// The number in brackets behind a name, if one is wanted; `rule` is the one that says so.
fn suffix(cursor: &mut Cursor, setup: &Setup, wanted: bool, rule: RuleId) -> Outcome<Option<Expression>> {
    if wanted {
        return bracketed_number(cursor, setup, rule).map(Some);
    }
    let end = cursor.mark();
    cursor.skip_blanks()?;
    if cursor.peek() == Some(b'[') {
        return fail(AlarmName::VariableSuffix, rule);
    }
    cursor.rewind(end);
    Ok(None)
}

/// The number in brackets that a name must have.
pub fn bracketed_number(cursor: &mut Cursor, setup: &Setup, rule: RuleId) -> Outcome<Expression> {
    cursor.skip_blanks()?;
    if !cursor.take(b'[') {
        return fail(AlarmName::VariableSuffix, rule);
    }
    let number = expression::expression(cursor, setup)?;
    expression::close_bracket(cursor)?;
    Ok(number)
}

/// E100L-MATH-06, E100L-AEXP-03: a binary operator word of this length here has a blank on both sides.
pub fn has_blanks(cursor: &Cursor, length: usize) -> bool {
    is_blank_before(cursor.before()) && is_blank_after(cursor.look(length))
}

/// E100L-MATH-06: in front of `NOT` an opening bracket, a comma or an equal sign will do as well.
pub fn not_has_blanks(cursor: &Cursor) -> bool {
    let before = cursor.before();
    let opened = matches!(before, Some(b'[' | b',' | b'='));
    (opened || is_blank_before(before)) && is_blank_after(cursor.look("NOT".len()))
}
