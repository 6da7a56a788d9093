//! The words of a block with their values: from left to right, each against its range.

use std::ops::Range;

use super::machine;
use super::written::Written;
use crate::controls::e100l::g_codes::{GCode, GGroup, g_code};
use crate::controls::e100l::m_codes::{MCode, group_of, m_code};
use crate::controls::e100l::units;
use crate::cycle;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::lap;
use crate::quantity::{self, Exact, ratio, whole};
use crate::saddle::Commands;
use crate::state::State;
use crate::syntax::{Address, Item, ItemKind, Value};
use crate::task;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, InchConversion, Label, RuleId, Setup};

/// E100L-FMT-06.
const MOST_M_WORDS: usize = 8;

/// The words of a block.
#[derive(Clone, Debug, Default)]
pub struct Words {
    /// G codes in written order.
    pub g: Vec<u16>,
    /// M codes in written order.
    pub m: Vec<u16>,
    /// Where they stand: the first byte of each.
    pub m_at: Vec<u32>,
    /// The number of F as it is written.
    pub feed: Option<Exact>,
    /// The number of J as it is written.
    pub leads: Option<Exact>,
    /// The number of D as it is written.
    pub d: Option<Exact>,
    /// The number of E as it is written.
    pub e: Option<Exact>,
    /// The other words, and CALRG, in written order.
    pub others: Vec<Other>,
    /// Whether a length was written in inches.
    pub inch: bool,
    /// Whether the block has an assignment.
    pub assigns: bool,
    /// Who carries its common words out, on a machine with two saddles.
    pub commands: Commands,
    /// All words in written order.
    pub written: Vec<Written>,
    /// The numbers of FA and FB, and of an E that is a feed, as they are written.
    pub feeds: Vec<(Address, Exact)>,
    /// The block that a call of LAP names (E100L-LAP-09).
    pub contour: Option<Label>,
}

/// A word other than G, M and F; `address` is none for CALRG.
#[derive(Clone, Debug)]
pub struct Other {
    /// Its address.
    pub address: Option<Address>,
    /// Its value: nanometres, micro-degrees, picometres (E), thousandths of a revolution per minute (SA), or as it is.
    pub value: i64,
    /// Byte span.
    pub span: Range<u32>,
}

impl Words {
    /// The value of a one-letter address.
    pub fn get(&self, letter: char) -> Option<i64> {
        u8::try_from(letter).ok().and_then(|letter| self.of(Address::Letter(letter)))
    }

    /// The value of an extended address.
    pub fn extended(&self, name: &'static str) -> Option<i64> {
        self.of(Address::Extended(name))
    }

    fn of(&self, address: Address) -> Option<i64> {
        self.others.iter().find(|other| other.address == Some(address)).map(|other| other.value)
    }

    /// The number of FA, FB, or an E that is a feed.
    pub fn feed_of(&self, address: Address) -> Option<&Exact> {
        self.feeds.iter().find(|(known, _)| *known == address).map(|(_, number)| number)
    }

    /// Whether one of these one-letter addresses stands in the block.
    pub fn has_any(&self, letters: &str) -> bool {
        letters.chars().any(|letter| self.get(letter).is_some())
    }

    /// Whether the block has no word, nor CALRG.
    pub fn is_empty(&self) -> bool {
        self.g.is_empty() && self.m.is_empty() && self.others.is_empty() && self.feed.is_none()
    }

    /// Whether CALRG stands in the block (E100L-CIRC-18).
    pub fn major_arc(&self) -> bool {
        self.others.iter().any(|other| other.address.is_none())
    }

    /// Whether a G code stands in the block.
    pub fn has_g(&self, code: u16) -> bool {
        self.g.contains(&code)
    }

    /// The one-shot G code of the block.
    pub fn one_shot(&self) -> Option<u16> {
        let is_one = |code: &u16| matches!(g_code(*code), GCode::Modelled(group) if group.is_one_shot());
        self.g.iter().copied().find(is_one)
    }
}

/// E100L-AEXP-11: evaluates the items of a block from left to right; assignments take effect, and emit their
/// events, at once. `owner` says whose the local variables are that they register.
pub fn evaluate(
    items: &[Item],
    owner: task::Registration,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<Words> {
    evaluate_into(Words::default(), items, owner, state, emissions)
}

/// The same for a call of LAP, whose first item is its code.
pub fn evaluate_call(
    contour: Label,
    items: &[Item],
    owner: task::Registration,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<Words> {
    let words = Words { contour: Some(contour), ..Words::default() };
    evaluate_into(words, items, owner, state, emissions)
}

fn evaluate_into(
    mut words: Words,
    items: &[Item],
    owner: task::Registration,
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<Words> {
    for item in items {
        let result = match &item.kind {
            ItemKind::MajorArc => {
                words.others.push(Other { address: None, value: 0, span: item.span.clone() });
                words.written.push(Written::MajorArc);
                Ok(())
            }
            ItemKind::Assignment(target, value) => {
                words.assigns = true;
                task::assign(target, value, owner, state, emissions)
            }
            ItemKind::Comment(position, characters) => {
                words.assigns = true;
                task::comment(position, characters, state).map(|event| emissions.push(event))
            }
            ItemKind::Word(address, value) => add(*address, value, item.span.clone(), state, &mut words),
        };
        result.map_err(|fault| fault.at(item.span.clone()))?;
    }
    Ok(words)
}

/// A value as it was written or computed, and whether it is a real one (E100L-TYPE-01).
struct Given {
    value: Exact,
    real: bool,
}

fn add(
    address: Address,
    value: &Value,
    span: Range<u32>,
    state: &mut State,
    words: &mut Words,
) -> Outcome<()> {
    let given = match value {
        Value::Number(decimal) => Given { value: decimal.exact(), real: decimal.point },
        Value::Expression(expression) => {
            let number = task::evaluate(expression, state)?;
            Given { value: number.exact(), real: matches!(number, task::Number::Real(_)) }
        }
    };
    let repeated = words.of(address).is_some() || address == Address::Letter(b'F') && words.feed.is_some();
    if repeated {
        // E100L-FMT-06: only G and M may stand in a block more than once.
        return fail(AlarmName::DuplicateAddress, FMT_06);
    }
    let value = match address {
        Address::Letter(b'G') => return add_g(&given, state.setup, words),
        Address::Letter(b'M') => {
            add_m(&given, state, words)?;
            words.m_at.push(span.start);
            return Ok(());
        }
        Address::Letter(b'F') => {
            words.feed = Some(given.value);
            words.written.push(Written::Word(address));
            return Ok(());
        }
        // E100L-CSC-02.
        Address::Letter(b'Y') if !state.modes.converting() => {
            return fail(AlarmName::AddressUnknown, ADDR_01);
        }
        _ if is_feed(address, state) => {
            words.feeds.push((address, given.value.clone()));
            0
        }
        _ => amount(address, &given, words.contour.is_some(), state.setup)?,
    };
    words.written.push(Written::Word(address));
    match address {
        Address::Letter(b'J') => words.leads = Some(given.value),
        Address::Letter(b'D') => words.d = Some(given.value),
        Address::Letter(b'E') => words.e = Some(given.value),
        _ => {}
    }
    words.inch |= state.setup.unit_system.is_inch() && is_length(address);
    words.others.push(Other { address: Some(address), value, span });
    Ok(())
}

/// Whether a word other than F is a feed, whose range is tested where it is used (E100L-LAP-07, E100L-LAPC-02).
fn is_feed(address: Address, state: &State) -> bool {
    match address {
        Address::Letter(b'E') => state.lap.takes_feeds(),
        _ => matches!(address, Address::Extended("FA" | "FB")),
    }
}

fn is_length(address: Address) -> bool {
    match address {
        Address::Letter(letter) => b"XYZIKDUHLWR".contains(&letter),
        Address::Extended(name) => ["XA", "XB", "ZA", "ZB", "DA", "DB"].contains(&name),
    }
}

/// E100L-ADDR-01: the value of a word in its small unit, within the range of its address.
fn amount(address: Address, given: &Given, contour_call: bool, setup: &Setup) -> Outcome<i64> {
    let system = setup.unit_system;
    match address {
        Address::Letter(b'X' | b'Y' | b'Z' | b'I' | b'K' | b'L' | b'R') => length(given, true, setup),
        Address::Extended("XA" | "XB" | "ZA" | "ZB") => length(given, true, setup),
        // E100L-LAP-18: in a call W is an amount.
        Address::Letter(b'W') => length(given, setup.options.w_axis && !contour_call, setup),
        Address::Extended("DA") => length(given, !contour_call, setup),
        Address::Letter(b'D' | b'U' | b'H') | Address::Extended("DB") => length(given, false, setup),
        Address::Letter(b'C') => angle(given, 359_999_000, setup),
        Address::Letter(b'A' | b'B') => angle(given, Setup::COORDINATE, setup),
        Address::Letter(b'E') => {
            let limit = whole(units::largest_length(system));
            let exact = &given.value * units::length(system);
            within(&exact, &-limit.clone(), &limit, ADDR_01)?;
            Ok(quantity::round_narrow(&(exact * whole(1_000))))
        }
        Address::Letter(b'J') => whole_number(given, 1, 9_999, ADDR_01),
        Address::Letter(b'Q') => whole_number(given, 0, 9_999, ADDR_01),
        Address::Letter(b'P') => whole_number(given, 0, 9_999, PSYNC_01),
        Address::Letter(b'S') => whole_number(given, 0, 65_535, SPD_01),
        Address::Extended("SB") => whole_number(given, 0, 65_535, SB_01),
        Address::Extended("QA") => whole_number(given, 1, 1_999, CAX_06),
        Address::Extended("SA") => {
            let thousandths = &given.value * whole(1_000);
            within(&thousandths, &whole(1), &whole(20_000), CAX_08)?;
            Ok(quantity::round_narrow(&thousandths))
        }
        Address::Extended(_) => whole_number(given, 1, 100, TRQ_01),
        Address::Letter(_) => tool_number(given, setup),
    }
}

fn within(value: &Exact, lowest: &Exact, highest: &Exact, rule: RuleId) -> Outcome<()> {
    if value < lowest || value > highest { fail(AlarmName::AddressRange, rule) } else { Ok(()) }
}

fn whole_number(given: &Given, lowest: i64, highest: i64, rule: RuleId) -> Outcome<i64> {
    within(&given.value, &whole(lowest), &whole(highest), rule)?;
    Ok(quantity::round_narrow(&given.value))
}

fn length(given: &Given, signed: bool, setup: &Setup) -> Outcome<i64> {
    let exact = &given.value * units::length(setup.unit_system);
    let limit = whole(units::largest_length(setup.unit_system));
    let lowest = if signed { -limit.clone() } else { Exact::ZERO };
    within(&exact, &lowest, &limit, ADDR_01)?;
    Ok(latched_length(&exact, given.real, setup))
}

/// A written length at the control's increment. E100L-INCH-02 for inches; E100L-DEC-03 else.
fn latched_length(exact: &Exact, real: bool, setup: &Setup) -> i64 {
    let inch = setup.unit_system.is_inch();
    let increment = match setup.readings.inch_conversion {
        InchConversion::InchIncrement if inch => 2_540,
        _ => 1_000,
    };
    let count = exact / whole(increment);
    let count = if inch && !real { quantity::cut(&count) } else { quantity::round(&count) };
    quantity::narrow(&count) * increment
}

fn angle(given: &Given, limit: i64, setup: &Setup) -> Outcome<i64> {
    let exact = &given.value * units::angle(setup.unit_system);
    within(&exact, &whole(-limit), &whole(limit), ADDR_01)?;
    Ok(quantity::round_narrow(&(exact * ratio(1, 1_000))) * 1_000)
}

/// E100L-TOOL-01, E100L-TOOL-03: the range of T, and of the offset and nose radius numbers in it.
fn tool_number(given: &Given, setup: &Setup) -> Outcome<i64> {
    let largest = if setup.options.nose_radius_compensation { 999_999 } else { 9_999 };
    if given.value < Exact::ZERO || given.value > whole(largest) {
        return fail(AlarmName::ToolNumber, TOOL_01);
    }
    let number = quantity::round_narrow(&given.value);
    let sets = i64::from(setup.options.offset_sets);
    if number / 10_000 > sets || number % 100 > sets {
        return fail(AlarmName::ToolNumber, TOOL_03);
    }
    Ok(number)
}

fn code(given: &Given, highest: i64, rule: RuleId) -> Outcome<u16> {
    let code = whole_number(given, 0, highest, rule)?;
    Ok(u16::try_from(code).unwrap_or_default())
}

/// E100L-GTAB-01, E100L-ABS-04, E100L-GCODE-04.
fn add_g(given: &Given, setup: &Setup, words: &mut Words) -> Outcome<()> {
    let code = code(given, 999, ADDR_01)?;
    let detail = Label::of_code(b'G', code);
    let group = match g_code(code) {
        GCode::Modelled(group) => group,
        GCode::Macro => {
            return Err(Fault::about(AlarmName::StatementMisplaced, MACRO_01, detail.as_str()));
        }
        GCode::Later => return Err(Fault::about(AlarmName::NotModelled, GTAB_01, detail.as_str())),
        GCode::Unspecified => return Err(Fault::about(AlarmName::Unspecified, GTAB_01, detail.as_str())),
        GCode::Unassigned => return fail(AlarmName::GCodeUnassigned, GTAB_01),
    };
    machine::has_g(code, setup)?;
    cycle::stands_first(code, words)?;
    lap::has_g(code, words, setup)?;
    if code == 90 && words.has_g(91) || code == 91 && words.has_g(90) {
        return fail(AlarmName::AbsoluteAndIncremental, ABS_04);
    }
    let conflicts = |other: GGroup| other == group || other.is_one_shot() && group.is_one_shot();
    if words.g.iter().any(|other| matches!(g_code(*other), GCode::Modelled(other) if conflicts(other))) {
        return fail(AlarmName::GCodesConflict, GCODE_04);
    }
    words.g.push(code);
    words.written.push(Written::G(code));
    Ok(())
}

/// E100L-MCODE-01, E100L-MTAB-01.
fn add_m(given: &Given, state: &State, words: &mut Words) -> Outcome<()> {
    if words.m.len() == MOST_M_WORDS {
        return fail(AlarmName::TooManyM, FMT_06);
    }
    let code = code(given, 511, MCODE_01)?;
    match m_code(code) {
        MCode::Modelled => {}
        MCode::Macro => {
            let detail = Label::of_code(b'M', code);
            return Err(Fault::about(AlarmName::StatementMisplaced, MACRO_02, detail.as_str()));
        }
        MCode::Unassigned => return fail(AlarmName::MCodeUnassigned, MTAB_01),
    }
    machine::has_m(code, state)?;
    let same_group = |other: u16| group_of(code).is_some_and(|group| group.codes.contains(&other));
    if words.m.iter().any(|other| *other == code || same_group(*other)) {
        return fail(AlarmName::MCodesConflict, MCODE_01);
    }
    words.m.push(code);
    words.written.push(Written::M(code));
    Ok(())
}
