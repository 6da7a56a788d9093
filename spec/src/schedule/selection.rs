//! What PSELECT finds, and what it demands of it (E100L-SDF-07 to -10, E100L-SDF-12).

use std::collections::{BTreeSet, VecDeque};

use crate::fault::{Fault, Outcome};
use crate::run::{Program, Programs, Read, Spot, Texts};
use crate::syntax::{
    Address, Body, Callee, FileName, Heading, Item, ItemKind, Selection, Statement, Value, heading,
    parse_whole,
};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId, Setup};

/// A main program that was found.
#[derive(Clone, Debug)]
pub struct Selected {
    /// Its file with the device.
    pub file: Label,
    /// Its name with its `O`; empty without one.
    pub name: Label,
    /// Its first block.
    pub start: Spot,
    /// The texts that its subprograms are found in.
    pub texts: BTreeSet<usize>,
}

/// Finds what is selected; the first thing that is missing is the fault.
pub fn find(selection: &Selection, programs: &mut Programs, setup: &Setup) -> Outcome<Selected> {
    let file = selection.file.full();
    let text = text_of(&selection.file, programs.texts(), SDF_07)?;
    if selection.file.extension() == "SDF" {
        return Err(Fault::about(AlarmName::Unspecified, SDF_07, "SDF"));
    }
    let Program { name, start } = match selection.program {
        Some(name) => match programs.only(name, |searched| searched == text)? {
            Some(program) => program,
            None => return Err(Fault::about(AlarmName::ProgramMissing, SDF_08, name.as_str())),
        },
        None => match first(text, programs.texts(), setup) {
            Some(program) => program,
            None => return Err(Fault::about(AlarmName::ProgramMissing, SDF_08, &file)),
        },
    };
    if !bodies(start, programs.texts(), setup).iter().any(ends_program) {
        return Err(Fault::about(AlarmName::MainEndMissing, SDF_09, &file));
    }
    let mut texts: BTreeSet<usize> = programs.texts().of_system().collect();
    texts.insert(text);
    if let Some(file) = &selection.subprograms {
        texts.insert(text_of(file, programs.texts(), SDF_10)?);
    }
    check_subprograms(start, &texts, programs, setup)?;
    Ok(Selected { file: Label::new(&file), name, start, texts })
}

/// E100L-SDF-07, E100L-SDF-10: the files of the library are on MD1.
fn text_of(file: &FileName, texts: &Texts, rule: RuleId) -> Outcome<usize> {
    match texts.of_file(&file.file).filter(|_| file.is_on_md1()) {
        Some(text) => Ok(text),
        None => Err(Fault::about(AlarmName::FileMissing, rule, &file.full())),
    }
}

/// The program that a text begins with; none in a text without any block.
fn first(text: usize, texts: &Texts, setup: &Setup) -> Option<Program> {
    let start = texts.start(text);
    let mut next = start;
    while let Ok(Some(Read { line, behind, .. })) = texts.read(next) {
        if !matches!(parse_whole(&line, setup), Ok(Body::Empty)) {
            let name = match heading(&line, setup) {
                Heading::Program(name) => name.unwrap_or_default(),
                _ => Label::default(),
            };
            return Some(Program { name, start });
        }
        next = behind;
    }
    None
}

/// What the blocks of a program hold that are read without fault, those with a slash too.
fn bodies(start: Spot, texts: &Texts, setup: &Setup) -> Vec<Body> {
    let mut bodies = Vec::new();
    let (mut next, mut began) = (start, false);
    while let Ok(Some(Read { line, behind, .. })) = texts.read(next) {
        if began && matches!(heading(&line, setup), Heading::Program(_)) {
            break;
        }
        let body = parse_whole(&line, setup);
        began |= !matches!(body, Ok(Body::Empty));
        bodies.extend(body);
        next = behind;
    }
    bodies
}

/// E100L-SDF-09: M02 or M30 as a plain number.
fn ends_program(body: &Body) -> bool {
    let ends = |item: &Item| match &item.kind {
        ItemKind::Word(Address::Letter(b'M'), Value::Number(number)) => {
            matches!(number.whole(), Some(2 | 30))
        }
        _ => false,
    };
    matches!(body, Body::Items(items) if items.iter().any(ends))
}

/// E100L-SDF-12: every subprogram that may be needed has RTS. Those that are not found are missed by their call.
fn check_subprograms(
    main: Spot,
    texts: &BTreeSet<usize>,
    programs: &mut Programs,
    setup: &Setup,
) -> Outcome<()> {
    let mut collected = BTreeSet::new();
    let mut pending = VecDeque::from([bodies(main, programs.texts(), setup)]);
    while let Some(program) = pending.pop_front() {
        for name in program.iter().filter_map(called) {
            if !collected.insert(name) {
                continue;
            }
            let found = programs.only(name, |searched| texts.contains(&searched))?;
            let Some(Program { start, .. }) = found else { continue };
            let subprogram = bodies(start, programs.texts(), setup);
            if !subprogram.contains(&Body::Statement(Statement::Return)) {
                return Err(Fault::about(AlarmName::SubprogramRtsMissing, SDF_12, name.as_str()));
            }
            pending.push_back(subprogram);
        }
    }
    Ok(())
}

/// The program that a block calls by its name.
fn called(body: &Body) -> Option<Label> {
    match body {
        Body::Statement(
            Statement::Call(Callee::Program(name), _) | Statement::Modin(Callee::Program(name), _),
        ) => Some(*name),
        _ => None,
    }
}
