//! Every program ends, within a number of steps and events that its text tells.

use std::collections::BTreeMap;

use arbitrary::{Arbitrary, Unstructured};
use turnspec::engine::Interpreter;
use turnspec_generator::{Case, decode};
use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::{Action, Ending, Event, MachineType, Part, Side, TapeCode};

use crate::differential::show;
use crate::shape::{calls_contours, is_of_cycle, is_of_thread, is_straight, motion};
use crate::{Verdict, require};

/// The most events of a block, its assignments and alarm aside, by the order of its steps:
///
/// | step | events |
/// |---|---:|
/// | `mode`: one code of a group (E100L-GCODE-04), seven groups whose code can change, G111 and either the cycle or conversion among them | 7 |
/// | G50: `frame` and `spindle`; G28 and G29, of the same group: one | 2 |
/// | S, SA, SB: each once in a block (E100L-FMT-06) | 3 |
/// | T: `tool` and `frame` | 2 |
/// | M words: eight (E100L-FMT-06), each one event | 8 |
/// | motion: two elements of a corner, two of a torque skip, or three of a contour; or a dwell; or the motions of a pass of a thread | 6 |
/// | M02, M30 (E100L-MCODE-04): besides `end` eight modes, those of the turrets and of conversion among them, and a `frame` for each turret | 10 |
const BLOCK: usize = 38;

/// What a block may have more on two saddles: `wait` and `release` at P and at M100, `side_end`, and the reset of the other
/// side, five modes and a `frame` less what stands above for the turrets.
const BLOCK_OF_A_SIDE: usize = BLOCK + 9;

/// Steps that a block takes on two saddles at most: up to its P, up to its M100, to its end, and one in which it is let go.
const STEPS_OF_A_SIDE: u64 = 4;

/// The most motions of a pass: approach, cut, two of the chamfer, retract, return (E100L-G33-04, E100L-TCHM-04).
const PASS: usize = 6;

/// The most events with a cutting pass of a cycle, which are those of a tap: position, two of the tool, approach, clamp, two
/// of the tool, cut, dwell, exit, unclamp, two of the tool, return (E100L-G184-01).
const CUT: usize = 14;

/// The fewest characters of an assignment, `V1=1`. It emits `variable` and at most one `frame`.
const ASSIGNMENT: usize = 4;
/// The most characters of a block (E100L-FMT-05).
const LONGEST: usize = 158;
/// The most programs that a motion calls (E100L-MODIN-05).
const MODAL_CALLS: usize = 8;

/// A program runs to an end. Without control flow a step reads at least one line or is the last one, so that there are
/// at most two steps more than ends of block; a block of n characters emits at most 37 + 2⌊n/4⌋ events, and one more if
/// it is an alarm; and blocks follow the order of the text. A pass of G71 or G72 but the first of its block is a step too, and has six
/// events at most; so is a cutting pass of a grooving, drilling or tapping cycle, with fourteen. On two saddles there are four times as many steps at most, a
/// block has nine events more, and the order is that of the text for each side up to the end of both. With control flow, a call of
/// LAP included, whose passes are steps too, a step takes at least one block, of which
/// a run begins no more than `limits.steps`; a block has at most 158 characters, and at most eight programs of modal calls
/// begin behind it. Events are numbered from 1 without a gap, `end` or `alarm` comes last and nowhere else but at the
/// end of a program that a schedule has selected, and a step after the end does nothing. All this of the oracle and of the engine, on a program of the generator and on the bytes
/// as they are.
///
/// Rules: E100L-GOTO-03, E100L-PROG-02, E100L-MCODE-04, E100L-FMT-04, E100L-FMT-05, E100L-FMT-06, E100L-GCODE-04
pub(crate) fn programs_end(input: &[u8]) -> Verdict {
    ends(&Case::from_raw(input))?;
    match Case::arbitrary(&mut Unstructured::new(input)) {
        Ok(case) => ends(&case),
        Err(_) => Ok(()),
    }
}

fn ends(case: &Case) -> Verdict {
    let mut oracle = Run::new(&case.program, &case.setup);
    let mut engine = Interpreter::new(&case.program, &case.setup);
    let fail = |message: String| format!("{message}\n{}", show(case));
    bounded(case, |events| oracle.step(&mut |event: &Event| events.push(*event)))
        .map_err(|message| fail(format!("oracle: {message}")))?;
    bounded(case, |events| engine.step(&mut |event: &Event| events.push(*event)))
        .map_err(|message| fail(format!("engine: {message}")))
}

fn bounded(case: &Case, mut step: impl FnMut(&mut Vec<Event>) -> Option<Ending>) -> Verdict {
    let straight = is_straight(case);
    let saddles = case.setup.machine.r#type == MachineType::TwoSaddles;
    let most = match (saddles, straight) {
        (true, _) => STEPS_OF_A_SIDE * (lines(case) + 2),
        (false, true) => lines(case) + 2,
        (false, false) => lines(case) + 2 + case.setup.limits.steps,
    };
    let calls = calls_contours(case);
    let most = if calls || may_repeat(case) { most + case.setup.limits.steps } else { most };
    let mut events = Vec::new();
    let Some(ending) = (0..most).find_map(|_| step(&mut events)) else {
        return Err(format!("no end after {most} steps"));
    };
    let count = events.len();
    let again = step(&mut events);
    require(again == Some(ending) && events.len() == count, || {
        "a step after the end does something".to_owned()
    })?;
    in_order(&events, ending)?;
    if saddles && !calls {
        return along_the_sides(&events).and_then(|()| few_a_block(&events, BLOCK_OF_A_SIDE));
    }
    if straight {
        return along_the_text(&events).and_then(|()| few_a_block(&events, BLOCK));
    }
    let most = most * (BLOCK + 2 * (LONGEST / ASSIGNMENT) + MODAL_CALLS) as u64;
    require(events.len() as u64 <= most, || format!("{} events, more than {most}", events.len()))
}

/// Whether the text has the letters of a block of a thread or cycle each pass of which is a step: D of pecks and depths, Q
/// of holes.
fn may_repeat(case: &Case) -> bool {
    let text = decode(&case.program, case.setup.tape.code);
    text.contains(&b'G') && b"DQ".iter().any(|letter| text.contains(letter))
}

/// Cutting passes of cycles in each block.
fn cuts_of_blocks(events: &[Event]) -> BTreeMap<u32, usize> {
    let mut cuts = BTreeMap::new();
    let is_cut = |event: &&Event| {
        let part = motion(event).and_then(|motion| motion.part);
        is_of_cycle(event) && matches!(part, Some(Part::Cut | Part::Finish))
    };
    for event in events.iter().filter(is_cut) {
        *cuts.entry(event.block.start).or_default() += 1;
    }
    cuts
}

/// Passes that each block began.
fn passes_of_blocks(events: &[Event]) -> BTreeMap<u32, usize> {
    let mut passes = BTreeMap::new();
    let approaches = |event: &&Event| {
        motion(event).and_then(|motion| motion.part) == Some(Part::Approach) && is_of_thread(event)
    };
    for event in events.iter().filter(approaches) {
        *passes.entry(event.block.start).or_default() += 1;
    }
    passes
}

/// Ends of block in the text.
fn lines(case: &Case) -> u64 {
    let end_of_block = |byte: &&u8| match case.setup.tape.code {
        TapeCode::Ascii => **byte == b'\n',
        TapeCode::Iso => **byte & 0x7F == b'\n',
        TapeCode::Eia => **byte == 0x80,
    };
    case.program.iter().filter(end_of_block).count() as u64
}

fn in_order(events: &[Event], ending: Ending) -> Verdict {
    for (event, ordinal) in events.iter().zip(1..) {
        require(event.n == ordinal, || format!("event {ordinal} has the number {}", event.n))?;
    }
    let ends = |event: &Event| match event.action {
        Action::End { .. } => Some(Ending::End),
        Action::Alarm(_) => Some(Ending::Alarm),
        _ => None,
    };
    let last = events.last().and_then(ends);
    require(last == Some(ending), || "the last event is not the ending".to_owned())?;
    // A schedule goes on behind the M02 or M30 of a program that it selected (E100L-SDF-14).
    let mut selected = false;
    for event in events.iter().take(events.len().saturating_sub(1)) {
        let goes_on = matches!(event.action, Action::End { code } if code.as_str() != "END") && selected;
        require(ends(event).is_none() || goes_on, || "an ending is not the last event".to_owned())?;
        selected = !goes_on && (selected || matches!(event.action, Action::Select { .. }));
    }
    Ok(())
}

fn along_the_text(events: &[Event]) -> Verdict {
    for pair in events.windows(2) {
        if let [before, after] = pair {
            require(
                before.block.start <= after.block.start && before.block.line <= after.block.line,
                || format!("event {} belongs to a block of before", after.n),
            )?;
        }
    }
    Ok(())
}

/// The events of each side up to the end of both, behind which comes the reset.
fn along_the_sides(events: &[Event]) -> Verdict {
    let is_end = |event: &Event| matches!(event.action, Action::SideEnd { .. });
    let count = events.iter().rposition(is_end).map_or(events.len(), |last| last + 1);
    for side in [Side::A, Side::B] {
        let own = events.iter().take(count).filter(|event| event.saddle == Some(side));
        along_the_text(&own.copied().collect::<Vec<_>>())?;
    }
    require(events.iter().all(|event| event.saddle.is_some()), || "an event has no saddle".to_owned())
}

fn few_a_block(events: &[Event], block: usize) -> Verdict {
    let mut blocks = BTreeMap::<u32, (usize, usize)>::new();
    for event in events.iter().filter(|event| !matches!(event.action, Action::Alarm(_))) {
        let length = event.block.end.saturating_sub(event.block.start) as usize;
        blocks.entry(event.block.start).or_insert((0, length)).0 += 1;
    }
    let (passes, cuts) = (passes_of_blocks(events), cuts_of_blocks(events));
    for (start, (count, length)) in blocks {
        let of = |map: &BTreeMap<u32, usize>| map.get(&start).copied().unwrap_or_default();
        let most = block + 2 * (length / ASSIGNMENT) + PASS * of(&passes) + CUT * of(&cuts);
        require(count <= most, || format!("the block at {start} has {count} events, more than {most}"))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, along_the_sides, bounded};
    use turnspec_generator::Case;
    use turnspec_oracle::vocabulary::{Ending, Event, MachineType, Setup, Side};

    use crate::shape::trace;

    fn case() -> Case {
        Case { setup: Setup::default(), program: b"G00 X1\nM08\nM02\n".to_vec() }
    }

    /// What is wrong with a run that hands out these events in one step, and the ending in every step.
    fn verdict(change: impl Fn(&mut Vec<Event>)) -> Result<(), String> {
        let mut events = trace(&case());
        change(&mut events);
        bounded(&case(), |out| {
            out.append(&mut events);
            Some(Ending::End)
        })
    }

    #[test]
    fn runs_that_are_wrong_are_noticed() {
        assert_eq!(verdict(|_| ()), Ok(()));
        assert!(verdict(|events| events.swap(0, 1)).is_err());
        assert!(verdict(|events| events.truncate(2)).is_err());
        assert!(verdict(|events| events[1].n = 7).is_err());
        assert!(verdict(|events| events[1].block.start = 1_000).is_err());
        assert!(bounded(&case(), |_| None).is_err());
        let many = |events: &mut Vec<Event>| {
            let (first, last) = (events[0], events[events.len() - 1]);
            *events = vec![first; BLOCK + 5];
            events.push(last);
            events.iter_mut().zip(1..).for_each(|(event, n)| event.n = n);
        };
        assert!(verdict(many).is_err_and(|message| message.contains("more than")));
    }

    #[test]
    fn sides_out_of_order_are_noticed() {
        let mut case = Case { program: b"G14\nG00 X1\nG13\nG00 X2\nX3\nG14\nM02\n".to_vec(), ..case() };
        case.setup.machine.r#type = MachineType::TwoSaddles;
        let events = trace(&case);
        assert_eq!(along_the_sides(&events), Ok(()));
        let changed = |change: fn(&mut Vec<Event>)| {
            let mut events = events.clone();
            change(&mut events);
            along_the_sides(&events)
        };
        assert!(changed(|events| events.swap(0, 1)).is_err());
        assert!(changed(|events| events[0].saddle = Some(Side::B)).is_err());
        assert!(changed(|events| events[0].saddle = None).is_err());
    }

    #[test]
    fn a_run_that_goes_on_after_its_end_is_noticed() {
        let events = trace(&case());
        assert!(
            bounded(&case(), |out| {
                out.extend(&events);
                Some(Ending::End)
            })
            .is_err()
        );
    }
}
