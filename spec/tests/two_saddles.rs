//! Two saddles: what the examples of the rules do not show.

mod support;

use turnspec_oracle::vocabulary::{AlarmName, Event, Length, MachineType, NoseRadius, Setup};
use turnspec_oracle::{Run, check};

use support::{kind, texts, value};

fn setup() -> Setup {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoSaddles;
    setup
}

/// Kind, saddle and line of each event.
fn outline(program: &str, setup: &Setup) -> Vec<String> {
    let events = texts(program, setup);
    let of = |event: &String| format!("{} {} {}", kind(event), value(event, "saddle"), value(event, "line"));
    events.iter().map(of).collect()
}

/// Name, detail, saddle and line of the alarm.
fn alarm(program: &str, setup: &Setup) -> String {
    let events = texts(program, setup);
    let last = events.last().map_or("", String::as_str);
    ["name", "detail", "saddle", "line"].map(|key| value(last, key)).join(" ")
}

/// E100L-PROG-02, E100L-AX4-02: a name block behind the first selection is refused; in front of it one may stand.
#[test]
fn a_name_stands_in_front() {
    let setup = setup();
    assert_eq!(alarm("G13\nO1\nG14\nG00 X1\nM02\n", &setup), "program_name_misplaced - A 2");
    assert_eq!(alarm("O1\nO2\nG14\nM02\n", &setup), "program_name_misplaced - A 2");
    assert_eq!(alarm("$A.SUB%\nG14\nM02\n", &setup), "program_kind SUB A 1");
}

/// E100L-AX4-05: what has no end, on the side that ended last.
#[test]
fn a_program_without_end() {
    let setup = setup();
    for (program, expected) in [
        ("", "no_program_end - A 1"),
        ("O1\n(NOTHING)\n", "no_program_end - A 3"),
        ("G13\nN1\nG14\n", "no_program_end - A 4"),
        ("G13\nG00 X1\nG14\n", "no_program_end - A 4"),
        ("G14\nG00 X1\nG13\n", "no_program_end - B 4"),
    ] {
        assert_eq!(alarm(program, &setup), expected, "{program}");
    }
}

/// E100L-AX4-03: a code with a slash or a name divides the text, one that is skipped or wrong does not.
#[test]
fn what_divides_the_text() {
    let mut setup = setup();
    let program = "N1 G13 (A)\nN1 G00 X1\n/N2 G=14\nN1 G00 X2\nM02\n";
    assert_eq!(
        outline(program, &setup),
        ["rapid A 2", "side_end A 2", "rapid B 4", "side_end B 5", "end B 5"]
    );
    setup.switches.block_delete = true;
    assert_eq!(alarm(program, &setup), "sequence_name_duplicate - A 4");
}

/// E100L-AX4-06: the block of side B commands no spindle, but does all the rest.
#[test]
fn common_words_are_carried_out_once() {
    let program = "G13\nG50 X10 S1000 P10\nM41 M08 P20\nG14\nG50 X20 S1000 P10\nM08 M41 P20\nM02\n";
    let events = outline(program, &setup());
    let expected = [
        "wait A 2",
        "wait B 5",
        "release A 2",
        "release B 5",
        "frame A 2",
        "spindle A 2",
        "frame B 5",
        "wait A 3",
        "wait B 6",
        "release A 3",
        "release B 6",
        "spindle A 3",
        "coolant A 3",
        "coolant B 6",
        "side_end A 3",
        "side_end B 7",
        "frame A 7",
        "frame B 7",
        "end B 7",
    ];
    assert_eq!(events, expected);
}

/// E100L-AX4-06: a speed and a clamp are two commands.
#[test]
fn a_clamp_is_no_speed() {
    let program = "G13\nG50 S1000 P10\nG14\nS1000 P10\nM02\n";
    assert_eq!(alarm(program, &setup()), "sides_differ - A 2");
}

/// E100L-AX4-11: the clamp that both have commanded limits the speed that one commands alone.
#[test]
fn the_spindle_is_common() {
    let program = "G13\nG50 S1000 P10\nG14\nG50 S1000 P10\nP20\nS2000 M03\nM02\n";
    let events = texts(program, &setup());
    let started = events.iter().find(|event| event.contains("state=cw")).map_or("", String::as_str);
    assert_eq!(["speed", "limit", "saddle"].map(|key| value(started, key)), ["1000", "clamp", "B"]);
}

/// E100L-M100-01, E100L-PSYNC-02: a block with P and M100 waits twice.
#[test]
fn a_block_can_wait_twice() {
    let program = "G13\nG00 X1 M100 P10\nG14\nG00 X2 M100 P10\nM02\n";
    let expected = [
        "wait A 2",
        "wait B 4",
        "release A 2",
        "release B 4",
        "rapid A 2",
        "wait A 2",
        "rapid B 4",
        "wait B 4",
        "release A 2",
        "release B 4",
        "side_end A 2",
        "side_end B 5",
        "end B 5",
    ];
    assert_eq!(outline(program, &setup()), expected);
}

/// E100L-AX4-05: the end of a side without M02 releases what waits; it stands at the last block that counts.
#[test]
fn the_end_of_a_side_releases_what_waits() {
    let mut setup = setup();
    setup.nose_radius = vec![NoseRadius { number: 1, x: Length(800_000), z: Length(800_000) }];
    let program = "G13\nG42 G01 X100 Z100 F0.2 T010101\nZ60\n(END)\nN9\nG14\nM30\n";
    let expected = [
        "mode A 2",
        "mode A 2",
        "tool A 2",
        "linear A 2",
        "linear A 3",
        "side_end A 3",
        "side_end B 7",
        "mode A 7",
        "mode A 7",
        "end B 7",
    ];
    assert_eq!(outline(program, &setup), expected);
}

/// E100L-GOTO-03: the steps of both sides are those of the run; a selection is none.
#[test]
fn steps_are_counted_for_both() {
    let mut setup = setup();
    setup.limits.steps = 3;
    let program = "G13\nG00 X1\nX2\nG14\nG00 X3\nX4\nM02\n";
    assert_eq!(alarm(program, &setup), "step_limit - B 6");
}

/// E100L-AX4-12: names that are none keep their alarm, all others are refused where they are read.
#[test]
fn what_is_not_described() {
    let setup = setup();
    for (block, expected) in [
        ("V1", "unspecified V1"),
        ("V0=1", "variable_number -"),
        ("VUNIT=1", "unspecified VUNIT"),
        ("VUACM[1]='A'", "unspecified VUACM"),
        ("VZOFW=1", "unspecified VZOFW"),
        ("VNONE=1", "system_variable_unknown -"),
        ("ABCD", "equal_sign_missing"),
        ("ABCDE=1", "local_name_malformed ABCDE"),
        ("X=SIN[AX2]", "local_undefined AX2"),
        ("NOEX", "unspecified NOEX"),
        ("PSELECT", "unspecified PSELECT"),
        ("IF", "unspecified IF"),
        ("GOTON1", "statement_delimiter_missing GOTO"),
        ("G205 X", "unspecified G205"),
        ("X1 GOTO N1", "statement_misplaced -"),
        ("M21", "not_modelled M21"),
        ("M25", "not_modelled M25"),
        ("Q1", "word_without_function Q"),
        ("G=13", "no_program_end -"),
        ("G13 M08", "unspecified G13"),
    ] {
        let found = alarm(&format!("G13\n{block}\n"), &setup);
        assert!(found.starts_with(expected), "{block}: {found}");
    }
}

/// E100L-AX4-08: the speed of a motion that is not the reference's depends on no rule and no reading of speeds.
#[test]
fn the_other_side_has_no_speed() {
    let mut program = "G13\nG00 X10\nG96 S100 P10\nG01 X20 F0.2\nG14\n".to_owned();
    program += "G50 S1 P5\nG96 S100 P10\nG00 X30\nM02\n";
    let program = program.replace("G00 X10\n", "G00 X10\nG50 S1 P5\n");
    let events = texts(&program, &setup());
    let rules = |line: &str| {
        let motion = events.iter().find(|event| {
            value(event, "line") == line && (event.starts_with("linear") || event.starts_with("rapid"))
        });
        motion.map_or("", String::as_str)
    };
    assert_eq!((value(rules("5"), "speed"), value(rules("9"), "speed")), ("1", "-"));
    assert!(rules("5").contains("E100L-SMAX-01") && rules("5").contains("speed_clamp"));
    assert!(rules("9").contains("E100L-AX4-08") && !rules("9").contains("E100L-CSS"));
    assert!(!rules("9").contains("E100L-SMAX-01") && !rules("9").contains("speed_clamp"));
}

/// The faults of a text for two saddles: those of a side reach to its M02.
#[test]
fn faults_of_both_sides_are_found() {
    let program = b"G13\nG01 X1\nM02\nG00 X123456789\nG14\nG00 X123456789\nM02\n";
    let found = check(program, &setup());
    let faults: Vec<_> = found.iter().map(|fault| (fault.block.line, fault.alarm.name)).collect();
    assert_eq!(faults, [(6, AlarmName::TooManyDigits), (2, AlarmName::NoFeed)]);
    let schedule = check(b"$A.SDF%\n+\nEND\n", &setup());
    assert_eq!(schedule.iter().map(|fault| fault.alarm.name).collect::<Vec<_>>(), [AlarmName::Unspecified]);
}

/// A run tells the program of its side.
#[test]
fn the_program_of_a_side_is_seen() {
    let setup = setup();
    let mut run = Run::new(b"O7\nG14\nG00 X1\nM02\n", &setup);
    while run.step(&mut |_: &Event| ()).is_none() {}
    assert_eq!(run.call_stack().map(|program| program.name.as_str().to_owned()).collect::<Vec<_>>(), ["O7"]);
}
