//! Why a divergence is one: the block, the reference's own event, and the rules.
//!
//! The reference runs the case again; the event that satisfies the expected line there tells the block and
//! the rules.

use turnspec_oracle::book::RuleText;
use turnspec_oracle::vocabulary::{Event, Place, RuleId, TapeCode, notation};

use crate::comparison::compare_traces;
use crate::declaration::Undecided;
use crate::report::{Explanation, FieldDifference, RuleExcerpt};
use crate::{Declaration, Divergence, Exercise, Observation, printable};

/// The most rules that are quoted.
const RULES_QUOTED: usize = 3;
/// The most characters of a block that are shown.
const BLOCK_SHOWN: usize = 160;

/// Explains a divergence with the rule texts.
#[must_use]
pub fn explain(exercise: &Exercise, divergence: &Divergence, book: &[RuleText]) -> Explanation {
    let mut trace = Vec::new();
    turnspec_oracle::run(&exercise.program, &exercise.setup, &mut |event: &Event| trace.push(*event));
    let reference = reference_event(exercise, divergence, &trace);
    let line = reference.map(|event| event.block.line).or_else(|| {
        divergence.actual.as_ref().and_then(|actual| actual.field("line")).and_then(|line| line.parse().ok())
    });
    let block = reference.map(|event| block_text(&exercise.program, exercise.setup.tape.code, &event.block));
    Explanation {
        ordinal: divergence.ordinal,
        expected: divergence.expected.clone(),
        actual: divergence.actual.as_ref().map(ToString::to_string),
        differences: divergence
            .differences
            .iter()
            .map(|each| FieldDifference {
                field: each.field.clone(),
                expected: each.expected.clone(),
                actual: printable(&each.actual, 200),
                distance: each.distance.as_ref().map(ToString::to_string),
            })
            .collect(),
        line,
        block: block.or_else(|| line.and_then(|line| line_text(exercise, line))),
        reference: reference.map(notation::render),
        rules: rules(exercise, reference, book),
    }
}

/// The event of the reference that satisfies the line where the trace diverges.
fn reference_event<'t>(
    exercise: &Exercise,
    divergence: &Divergence,
    trace: &'t [Event],
) -> Option<&'t Event> {
    let line = divergence.line?;
    let exact = Declaration { undecided: Undecided::Alarm, ..Declaration::of_everything("reference") };
    let observations: Vec<Observation> = trace.iter().map(Observation::of).collect();
    let pairs = compare_traces(&exercise.expected, &observations, &exact).ok()?;
    let (_, event) = pairs.into_iter().find(|(index, _)| *index == line)?;
    trace.get(event)
}

/// The rules that the case is about, those that the event cites first.
fn rules(exercise: &Exercise, reference: Option<&Event>, book: &[RuleText]) -> Vec<RuleExcerpt> {
    let cited = |rule: &RuleId| reference.is_some_and(|event| event.rules.as_slice().contains(rule));
    let mut rules = exercise.case.rules.clone();
    rules.sort_by_key(|rule| !cited(rule));
    if rules.iter().any(cited) {
        rules.retain(cited);
    }
    let text = |rule: RuleId| book.iter().find(|text| text.id == rule);
    rules
        .into_iter()
        .take(RULES_QUOTED)
        .map(|rule| RuleExcerpt {
            id: rule.to_string(),
            title: text(rule).map(|text| text.title.clone()).unwrap_or_default(),
            statement: text(rule).map(|text| text.statement.clone()).unwrap_or_default(),
        })
        .collect()
}

/// A line of the program, when its lines are characters.
fn line_text(exercise: &Exercise, line: u32) -> Option<String> {
    let index = usize::try_from(line).ok()?.checked_sub(1)?;
    let text = exercise.program.split(|byte| *byte == b'\n').nth(index)?;
    Some(bytes_text(text, exercise.setup.tape.code))
}

fn block_text(program: &[u8], code: TapeCode, block: &Place) -> String {
    bytes_text(program.get(block.start as usize..block.end as usize).unwrap_or_default(), code)
}

/// Bytes for people: ISO without parity, EIA in hexadecimal.
fn bytes_text(bytes: &[u8], code: TapeCode) -> String {
    let text: String = match code {
        TapeCode::Ascii => bytes.iter().copied().map(char::from).collect(),
        TapeCode::Iso => bytes.iter().map(|byte| char::from(byte & 0x7F)).collect(),
        TapeCode::Eia => bytes.iter().map(|byte| format!("{byte:02X} ")).collect(),
    };
    printable(text.trim_end(), BLOCK_SHOWN)
}
