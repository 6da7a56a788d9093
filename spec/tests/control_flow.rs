//! Which block comes next, seen from outside: what a run lets be seen, and where names and programs are found.

#![allow(clippy::panic)]

use proptest::prelude::*;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Ending, Event, Label, ProgramText, Setup};
use turnspec_oracle::{ActiveMode, ActiveProgram, LocalVariable, Run};

fn setup(library: &[(&str, &str)]) -> Setup {
    let texts =
        library.iter().map(|(file, text)| ((*file).to_owned(), ProgramText(text.as_bytes().to_vec())));
    Setup { library: texts.collect(), ..Setup::default() }
}

/// The trace without rules, one line an event, with the names of program and block at its end.
fn trace(program: &str, setup: &Setup) -> Vec<String> {
    let mut trace = Vec::new();
    turnspec_oracle::run(program.as_bytes(), setup, &mut |event: &Event| {
        let text = render(event);
        let words = text.split(' ').filter(|word| !word.starts_with("rules="));
        let (program, sequence) = (event.block.program, event.block.sequence);
        let words: Vec<_> = words.chain([program.as_str(), sequence.as_str()]).collect();
        trace.push(words.join(" ").trim_end().to_owned());
    });
    trace
}

fn last(program: &str, setup: &Setup) -> String {
    trace(program, setup).pop().unwrap_or_default()
}

/// Steps until a local variable has this name.
fn until<'a>(program: &'a str, setup: &'a Setup, name: &str) -> Run<'a> {
    let mut run = Run::new(program.as_bytes(), setup);
    while run.local_variables().all(|local| local.name.as_str() != name) {
        assert_eq!(run.step(&mut |_: &Event| ()), None, "{name} was never registered");
    }
    run
}

#[test]
fn a_run_shows_programs_variables_and_modes() {
    let program = "O1\nXS=1\nMODIN O3 DIA=2\nCALL O2 XS=5\nM02\n";
    let setup = setup(&[("PULL.SUB", "O2\n ITH=3\n GOTO N1\nN1 RTS\nO3\nRTS\n")]);
    let run = until(program, &setup, "ITH");
    let stack: Vec<_> = run
        .call_stack()
        .map(|ActiveProgram { name, file, called_at }| {
            (name.to_string(), file, called_at.map(|place| place.line))
        })
        .collect();
    assert_eq!(stack, [("O1".to_owned(), None, None), ("O2".to_owned(), Some("PULL.SUB"), Some(4))]);
    let locals: Vec<_> = run
        .local_variables()
        .map(|LocalVariable { name, value, owner, mode }| {
            (name.to_string(), value, owner.to_string(), mode.is_some())
        })
        .collect();
    let local = |name: &str, value, owner: &str, mode| (name.to_owned(), value, owner.to_owned(), mode);
    let expected = [
        local("XS", 1.0, "O1", false),
        local("DIA", 2.0, "O3", true),
        local("XS", 5.0, "O2", false),
        local("ITH", 3.0, "O2", false),
    ];
    assert_eq!(locals, expected);
    let modes: Vec<_> = run
        .active_modes()
        .map(|ActiveMode { number, program, began_at }| (number, program.to_string(), began_at.line))
        .collect();
    assert_eq!(modes, [(1, "O3".to_owned(), 3)]);
}

/// E100L-GOTO-02: length, parity and an open comment of a block do not hide its name, NOEX is none, and a block that is
/// skipped keeps a name that no comment hides.
#[test]
fn a_name_is_found_whatever_stands_behind_it() {
    let mut skipping = Setup::default();
    skipping.switches.block_delete = true;
    let long = " ".repeat(200);
    for (block, alarm) in [
        ("N1(OPEN".to_owned(), "comment_unclosed"),
        (format!("N1{long}X1"), "block_too_long"),
        (format!("{long}N1 X1"), "block_too_long"),
        ("N1/?".to_owned(), "illegal_character"),
        ("(A) /(B) N1 ?".to_owned(), "illegal_character"),
        ("N1?".to_owned(), "sequence_name_unknown"),
        ("//N1 X1".to_owned(), "sequence_name_unknown"),
        ("X1 N1".to_owned(), "sequence_name_unknown"),
        ("(OPEN N1".to_owned(), "sequence_name_unknown"),
    ] {
        let alarm_of = last(&format!("GOTO N1\n{block}\nM02\n"), &Setup::default());
        assert!(alarm_of.starts_with(&format!("alarm name={alarm}")), "{block}: {alarm_of}");
    }
    assert_eq!(last("GOTO N1\nM00\n/ \tN1 ?\nM02\n", &skipping), "end code=M02 line=4");
    assert!(last("GOTO N1\n/(A)N1 X1\nM02\n", &skipping).starts_with("alarm name=sequence_name_unknown"));
}

/// E100L-SEQ-03: the second block with a name is at fault, however it was reached; the first one never.
#[test]
fn a_name_that_stands_twice_is_a_fault_of_the_second_block() {
    let program = "GOTO N2\nN1 M02\nN2 GOTO N3\nN1 X1\nN3 GOTO N1\n";
    assert_eq!(last(program, &Setup::default()), "end code=M02 line=2  N1");
    let program = "GOTO N2\nN1 M02\nN2\nN1 X1\n";
    let alarm = last(program, &Setup::default());
    assert_eq!(alarm, "alarm name=sequence_name_duplicate line=4  N1");
}

/// A block of a loop is read each time anew; some ten thousand are carried out at once.
#[test]
fn a_loop_comes_to_its_end() {
    let program = "N1 V1=V1+1\n/\nN2 IF [V1 LT 9999] N1\nM02\n";
    assert_eq!(trace(program, &Setup::default()).len(), 10_000);
    let mut setup = Setup::default();
    setup.limits.steps = 5;
    assert_eq!(last(program, &setup), "alarm name=step_limit line=3");
    setup.limits.steps = 30_000;
    assert!(last(program, &setup).starts_with("end"));
}

/// In a loop the step that is one too many may be a block that look-ahead has read before.
#[test]
fn what_look_ahead_has_read_counts_as_a_step_in_its_turn() {
    let program = "G01 X10 Z10 F1\nG75 X20 L1\n\nN3 Z30\nM02\n";
    let mut setup = Setup::default();
    for (steps, expected) in
        [(2, "alarm name=step_limit line=3"), (3, "alarm name=step_limit line=4"), (5, "end code=M02 line=5")]
    {
        setup.limits.steps = steps;
        assert_eq!(last(program, &setup), expected);
    }
}

/// E100L-CALL-06: a called program ends where the next one begins, unless RTS comes before.
#[test]
fn a_program_ends_at_the_next_name() {
    let library = |text| setup(&[("A.SUB", text)]);
    let alarm = |text| last("CALL O1\nM02\n", &library(text));
    assert_eq!(alarm("X?\nO1\nM00\n O2 X1\n"), "alarm name=no_return line=4 O1");
    assert_eq!(alarm("$A.SUB\nO1\nM00\n%\n"), "alarm name=no_return line=5 O1");
    assert_eq!(alarm("O1 X1\nRTS\n"), "alarm name=program_name_not_alone line=1 O1");
    assert_eq!(alarm("O1\nRTS\nO1\nRTS\n"), "alarm name=program_duplicate detail=O1 line=1");
    assert_eq!(alarm("O1A2B3\nRTS\n"), "alarm name=program_unknown detail=O1 line=1");
}

/// Events of statements wait behind a motion in compensation, and do not count as blocks between (E100L-CTL-01).
#[test]
fn statements_are_not_blocks_between() {
    let mut held = setup(&[("A.SUB", "O1\nGOTO N1\nN1 RTS\n")]);
    held.nose_radius = vec![turnspec_oracle::vocabulary::NoseRadius {
        number: 1,
        x: turnspec_oracle::vocabulary::Length(800_000),
        z: turnspec_oracle::vocabulary::Length(800_000),
    }];
    let program = |between: &str| {
        format!("G00 X100 Z100 T010101\nG42 G01 X80 F0.2\nZ50\n{between}X120\nZ20\nG40 X200\nM02\n")
    };
    let motions = |between: &str| -> Vec<String> {
        let text = |line: &String| line.split(" line=").next().unwrap_or_default().to_owned();
        trace(&program(between), &held).iter().map(text).filter(|line| line.starts_with("linear")).collect()
    };
    let plain = motions("");
    assert_eq!(plain, motions("CALL O1\nCALL O1 XS=1\nGOTO N5\nN5\n"));
    assert_eq!(plain, motions("NOEX\n"));
    assert_ne!(plain, motions("NOEX\nNOEX V1=1\n"));
}

/// Blocks that go well and blocks that do not, of jumps, calls, modes and what they act on.
const BLOCKS: &[&str] = &[
    "N1 G00 X10",
    "N2",
    "N3 /GOTO N1",
    "IF [V1 LT 3] N2",
    "IF XS GOTO N3",
    "V1=V1+1",
    "XS=XS+1",
    "NOEX XS=V1",
    "NOEX",
    "CALL O1",
    "CALL O2 XS=V1 DIA=XS",
    "MODIN O2 DIA=1",
    "MODIN O3",
    "MODOUT",
    "RTS",
    "G161 XS=1",
    "M321",
    "O1",
    "O2",
    ":3",
    "G01 X20 Z20 F1",
    "G42 Z10",
    "G40 Z0",
    "G75 X30 L1",
    "A30",
    "A60 X40 Z40",
    "M00",
    "",
    "(A)",
    "/",
    "GOTO N9",
    "$ Z5",
    "%",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Whatever is jumped to and called, a run ends within its steps, numbers its events, and has an alarm exactly if
    /// `check` has something to say.
    #[test]
    fn runs_end(main in prop::collection::vec(0..BLOCKS.len(), 1..20), library in prop::collection::vec(0..BLOCKS.len(), 0..20)) {
        let text = |blocks: &[usize]| -> String {
            blocks.iter().filter_map(|block| BLOCKS.get(*block)).map(|block| format!("{block}\n")).collect()
        };
        let (main, library) = (text(&main) + "M02\n", text(&library));
        let mut setup = setup(&[("A.SUB", &library)]);
        setup.limits.steps = 200;
        setup.macros = [("G161", "O1"), ("M321", "O3")].map(|(code, name)| (code.to_owned(), Label::new(name))).into();
        let mut run = Run::new(main.as_bytes(), &setup);
        let mut events: Vec<Event> = Vec::new();
        let ending = (0..202).find_map(|_| run.step(&mut |event: &Event| events.push(*event)));
        prop_assert!(ending.is_some(), "{}", main);
        prop_assert!((1..).zip(&events).all(|(ordinal, event)| event.n == ordinal));
        let diagnostics = turnspec_oracle::check(main.as_bytes(), &setup);
        prop_assert_eq!(ending == Some(Ending::Alarm), !diagnostics.is_empty());
        prop_assert!(run.call_stack().count() <= 9 && run.active_modes().count() <= 8);
    }
}
