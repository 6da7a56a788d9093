//! Changes of a program that change nothing, or translate and do nothing else.

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_generator::{Case, Remarked};
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, Length, Motion, Place, Position, Setup};

use crate::differential::show;
use crate::path::{Path, Point, Spelling};
use crate::shape::{trace, without_place};
use crate::{Verdict, require};

/// The three laws of this file.
pub(crate) fn rewritten_programs_do_the_same(input: &[u8]) -> Verdict {
    let mut bytes = Unstructured::new(input);
    if let Ok((path, spellings)) = spelled_path(&mut bytes) {
        let fail = |message: String| format!("{message}\n{}", path.program(|_| Spelling::default()));
        absolute_and_incremental_agree(&path, &spellings).map_err(fail)?;
        a_shift_only_translates(&path, &spellings).map_err(fail)?;
    }
    match Remarked::arbitrary(&mut Unstructured::new(input)) {
        Ok(pair) => names_and_remarks_do_not_matter(&pair),
        Err(_) => Ok(()),
    }
}

/// A path, and a spelling for each of its blocks; no shift changes inside a corner.
fn spelled_path(bytes: &mut Unstructured<'_>) -> Result<(Path, Vec<Spelling>)> {
    let path = Path::grow(bytes)?;
    let mut spellings: Vec<Spelling> = Vec::new();
    let mut shift = Point::default();
    let mut inside = false;
    for element in &path.elements {
        if !inside && bytes.ratio(1, 4)? {
            shift =
                Point { x: bytes.int_in_range(-9_000..=9_000)?, z: bytes.int_in_range(-900_000..=900_000)? };
        }
        inside = element.is_corner;
        spellings.push(Spelling { incremental: bytes.arbitrary()?, shift });
    }
    Ok((path, spellings))
}

fn run(program: String) -> Vec<Event> {
    trace(&Case { setup: Setup::default(), program: program.into_bytes() })
}

/// A path of lines, corners and arcs that is written in G90, in G91, or in either from block to block does
/// the same: the same events with the same coordinates, corners and alarms, but for the `mode` events of G90
/// and G91 and the rules that name the mode.
///
/// Rules: E100L-ABS-01, E100L-ABS-02, E100L-CIRC-03, E100L-CIRC-19, E100L-ANG-03, E100L-ANG-04
fn absolute_and_incremental_agree(path: &Path, spellings: &[Spelling]) -> Verdict {
    let at = |index: usize| spellings.get(index).is_some_and(|spelling| spelling.incremental);
    let unshifted = |incremental| Spelling { incremental, shift: Point::default() };
    let actions = |program: String| -> Vec<Action> {
        run(program).iter().map(|event| event.action).filter(|action| !is_dimension(action)).collect()
    };
    let absolute = actions(path.program(|_| unshifted(false)));
    for other in [path.program(|_| unshifted(true)), path.program(|index| unshifted(at(index)))] {
        equal(&absolute, &actions(other.clone())).map_err(|message| format!("{message}\n{other}"))?;
    }
    Ok(())
}

fn is_dimension(action: &Action) -> bool {
    matches!(action, Action::Mode { group, .. } if group.as_str() == "dimension")
}

/// A G50 anywhere between the blocks of a path (not inside a corner) translates the program coordinates of
/// what follows, centres of arcs included, and does nothing else: machine coordinates, feeds, path lengths,
/// senses, rules, readings and alarms stay, when the words in G90 are translated with it. Only the events of
/// G50 itself and of the reset of its shift are added.
///
/// Rules: E100L-COORD-03, E100L-G50-01, E100L-G50-02, E100L-G50-05, E100L-SVAR-02
fn a_shift_only_translates(path: &Path, spellings: &[Spelling]) -> Verdict {
    let shifted = |index: usize| spellings.get(index).copied().unwrap_or_default();
    let plain = |index: usize| Spelling { shift: Point::default(), ..shifted(index) };
    let program = path.program(shifted);
    let there = run(program.clone());
    let here: Vec<Event> = run(path.program(plain)).iter().map(bare).collect();
    let mut shift = (0, 0);
    let mut back = Vec::new();
    for event in &there {
        match event.action {
            // Shift and program coordinate move in opposite directions.
            Action::Frame { x, z, .. } => shift = (x.0, z.0),
            _ => back.push(translated(&bare(event), shift)),
        }
    }
    equal(&here, &back).map_err(|message| format!("{message}\n{program}"))
}

/// An event without place and number.
fn bare(event: &Event) -> Event {
    Event { n: 0, block: Place::default(), ..*event }
}

/// The event with its program coordinates moved.
fn translated(event: &Event, (x, z): (i64, i64)) -> Event {
    let along_x = |length: Length| Length(length.0 + x);
    let along_z = |length: Length| Length(length.0 + z);
    let of = |motion: Motion| Motion {
        program: Position { x: along_x(motion.program.x), z: along_z(motion.program.z), ..motion.program },
        ..motion
    };
    let action = match event.action {
        Action::Rapid { motion } => Action::Rapid { motion: of(motion) },
        Action::Linear { motion, feed, path } => Action::Linear { motion: of(motion), feed, path },
        Action::Arc { motion, feed, sense, centre_x, centre_z } => {
            let (centre_x, centre_z) = (along_x(centre_x), along_z(centre_z));
            Action::Arc { motion: of(motion), feed, sense, centre_x, centre_z }
        }
        other => other,
    };
    Event { action, ..*event }
}

/// A program of the generator does the same without its sequence names and with empty blocks and remarks
/// between its blocks, but for places in the text, the alarm of a sequence name used twice and the limit of steps, which
/// a remark is one of. (Names that a statement looks for are kept.)
///
/// Rules: E100L-SEQ-01, E100L-SEQ-04, E100L-CMT-01, E100L-GOTO-03
fn names_and_remarks_do_not_matter(pair: &Remarked) -> Verdict {
    let (named, remarked) = (trace(&pair.named), trace(&pair.remarked));
    let ends_with = |trace: &[Event], name: AlarmName| {
        let last = trace.last().map(|event| event.action);
        matches!(last, Some(Action::Alarm(alarm)) if alarm.name == name)
    };
    let limited = [&named, &remarked].iter().any(|trace| ends_with(trace, AlarmName::StepLimit));
    if limited || ends_with(&named, AlarmName::SequenceNameDuplicate) {
        return Ok(());
    }
    let plain = |trace: &[Event]| trace.iter().map(without_place).collect::<Vec<_>>();
    equal(&plain(&named), &plain(&remarked))
        .map_err(|message| format!("{message}\n{}\n{}", show(&pair.named), show(&pair.remarked)))
}

fn equal<T: PartialEq + std::fmt::Debug>(one: &[T], other: &[T]) -> Verdict {
    let unlike = one.iter().zip(other).find(|(a, b)| a != b);
    require(unlike.is_none(), || format!("{unlike:#?}"))?;
    require(one.len() == other.len(), || format!("{} and {} events", one.len(), other.len()))
}

#[cfg(test)]
mod tests {
    use super::{names_and_remarks_do_not_matter, translated};
    use arbitrary::Unstructured;
    use turnspec_generator::{Case, Remarked};
    use turnspec_oracle::vocabulary::{Action, Setup};

    use super::{run, spelled_path};
    use crate::bytes_of_seed;
    use crate::path::Spelling;

    #[test]
    fn another_program_is_noticed() {
        let case = |text: &str| Case { setup: Setup::default(), program: text.as_bytes().to_vec() };
        let verdict = |named: &str, remarked: &str| {
            names_and_remarks_do_not_matter(&Remarked { named: case(named), remarked: case(remarked) })
        };
        assert_eq!(verdict("N1 G00 X5\nM02", "(A)\nG00 X5\nM02"), Ok(()));
        assert!(verdict("N1 G00 X5\nM02", "G00 X4\nM02").is_err());
        assert!(verdict("G00 X5\nM02", "G00 X5\nM08\nM02").is_err());
    }

    #[test]
    fn a_translation_moves_program_coordinates_alone() {
        let event = run("G02 X10 Z5 I5 F1\nM02".to_owned())[1];
        let (Action::Arc { motion: from, centre_x, .. }, Action::Arc { motion: to, centre_x: moved, .. }) =
            (event.action, translated(&event, (7, 9)).action)
        else {
            unreachable!("{event:?}")
        };
        assert_eq!((to.program.x.0, to.program.z.0), (from.program.x.0 + 7, from.program.z.0 + 9));
        assert_eq!((to.machine, moved.0), (from.machine, centre_x.0 + 7));
    }

    /// A law of paths that alarm at once would say little.
    #[test]
    fn most_blocks_of_paths_are_carried_out() {
        let (mut events, mut blocks) = (0, 0);
        for seed in 0..200 {
            let bytes = bytes_of_seed(seed, 600);
            let (path, _) = spelled_path(&mut Unstructured::new(&bytes)).expect("enough bytes");
            blocks += path.elements.len();
            events += run(path.program(|_| Spelling::default())).len();
        }
        assert!(events * 2 > blocks, "{events} events of {blocks} blocks");
    }
}
