//! Every fault of a program at once: for people who mend programs, not for controls.

use std::ops::Range;

use crate::fault::Fault;
use crate::run::{Progress, Run};
use crate::syntax::{Address, Body, Item, ItemKind, ScheduleBlock, Source, Value, parse, parse_schedule};
use crate::turret::selected_by;
use crate::vocabulary::{Alarm, Label, MachineType, Place, RuleSet, Setup, Side};

/// One fault that [`check`] found.
#[derive(Clone, PartialEq, Debug)]
pub struct Diagnostic {
    /// The alarm that the control would raise.
    pub alarm: Alarm,
    /// Its rules.
    pub rules: RuleSet,
    /// The block.
    pub block: Place,
    /// Byte span of the word that is at fault, or of the block.
    pub span: Range<u32>,
}

impl Diagnostic {
    fn new(fault: &Fault, block: Place) -> Self {
        let block = fault.block.unwrap_or(block);
        let span = fault.span.clone().unwrap_or(block.start..block.end);
        Self { alarm: fault.alarm, rules: fault.rules, block, span }
    }
}

/// Every fault of a program: the grammar faults of each block as far as the program reaches, in the order of the
/// text (jumps and calls are not followed), and the alarm of the run if it is none of them. A program that runs to its end has none.
#[must_use]
pub fn check(program: &[u8], setup: &Setup) -> Vec<Diagnostic> {
    let Some(found) = alarm_of_run(program, setup) else { return Vec::new() };
    let mut diagnostics = grammar_faults(program, setup);
    // A block of the library may begin at the same byte as one of the program.
    let stands_at = |block: &Place| (block.line, block.start, block.end);
    let same = |known: &Diagnostic| stands_at(&known.block) == stands_at(&found.block);
    if !diagnostics.iter().any(|known| same(known) && known.alarm == found.alarm) {
        diagnostics.push(found);
    }
    diagnostics
}

fn alarm_of_run(program: &[u8], setup: &Setup) -> Option<Diagnostic> {
    let mut run = Run::new(program, setup);
    let mut place = Place::default();
    loop {
        match run.block(&mut place, &mut Vec::new()) {
            Ok(Progress::Going) => {}
            Ok(Progress::Ended) => return None,
            Err(fault) => return Some(Diagnostic::new(&fault, place)),
        }
    }
}

fn grammar_faults(program: &[u8], setup: &Setup) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    let mut source = Source::new(program, setup.tape.code);
    let schedule = source.header_of_schedule().unwrap_or(setup.schedule);
    let mut program_name = Label::default();
    let mut sides = Sides::of(setup);
    if schedule && sides.is_some() {
        // E100L-AX4-12: nothing of it is read.
        return diagnostics;
    }
    loop {
        let line = match source.next_line() {
            Ok(Some(line)) => line,
            Ok(None) => return diagnostics,
            Err(fault) => {
                diagnostics.push(Diagnostic::new(&fault, Place::default()));
                continue;
            }
        };
        let mut place = Place { program: program_name, ..line.place };
        if schedule {
            match parse_schedule(&line, setup, &mut place.sequence) {
                Ok(ScheduleBlock::End) => return diagnostics,
                Ok(_) => {}
                Err(fault) => diagnostics.push(Diagnostic::new(&fault, place)),
            }
            continue;
        }
        let body = parse(&line, setup, &mut place.sequence).map(|block| block.body);
        if let Some(sides) = &mut sides
            && !sides.reach(body.as_ref().ok())
        {
            continue;
        }
        match body {
            Ok(Body::ProgramName(name)) => program_name = name,
            Ok(Body::Items(items)) if sides.is_none() && ends(&items, setup) => {
                return diagnostics;
            }
            Ok(_) => {}
            Err(fault) => diagnostics.push(Diagnostic::new(&fault, place)),
        }
    }
}

/// E100L-MIRR-03: what stands with a turret code does nothing.
fn ends(items: &[Item], setup: &Setup) -> bool {
    let ignored = setup.machine.r#type == MachineType::TwoTurrets && !selected_by(items).is_empty();
    !ignored && items.iter().any(ends_program)
}

/// How far the programs of two saddles reach: what stands behind the end of a side is no part of its program.
#[derive(Default)]
struct Sides {
    side: Option<Side>,
    ended: Vec<Side>,
}

impl Sides {
    /// Those of a machine that has them.
    fn of(setup: &Setup) -> Option<Self> {
        (setup.machine.r#type == MachineType::TwoSaddles).then(Self::default)
    }

    /// Whether a block is part of the program of a side.
    fn reach(&mut self, body: Option<&Body>) -> bool {
        let items: &[Item] = match body {
            Some(Body::Items(items)) => items,
            _ => &[],
        };
        if let ([_], [side]) = (items, selected_by(items).as_slice()) {
            self.side = Some(*side);
            return true;
        }
        let reached = self.side.is_none_or(|side| !self.ended.contains(&side));
        if items.iter().any(ends_program) {
            self.ended.extend(self.side);
        }
        reached
    }
}

/// M02 or M30 as it is usually written: what stands behind it is no part of the program.
fn ends_program(item: &Item) -> bool {
    match &item.kind {
        ItemKind::Word(Address::Letter(b'M'), Value::Number(number)) => [2, 30].contains(&number.digits),
        _ => false,
    }
}
