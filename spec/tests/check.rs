//! `check` finds every fault of a program at once, and nothing in a program that runs.

use turnspec_oracle::vocabulary::{AlarmName, Length, Setup, TapeCode};
use turnspec_oracle::{Diagnostic, check};

/// Line, alarm and text at fault of each diagnostic.
fn faults(program: &str) -> Vec<(u32, AlarmName, &str)> {
    let found = check(program.as_bytes(), &Setup::default());
    let text = |fault: &Diagnostic| &program[fault.span.start as usize..fault.span.end as usize];
    found.iter().map(|fault| (fault.block.line, fault.alarm.name, text(fault))).collect()
}

#[test]
fn a_program_that_runs_has_no_fault() {
    assert_eq!(faults("G00 X1\nM02\n"), []);
}

#[test]
fn every_fault_of_the_text_is_found() {
    let program = "G00 X123456789\nG00 X1\nG00 Z987654321\nM02\n";
    let expected = [(1, AlarmName::TooManyDigits, "X123456789"), (3, AlarmName::TooManyDigits, "Z987654321")];
    assert_eq!(faults(program), expected);
}

/// The control would stop at line 1; a person wants to know of line 2, too.
#[test]
fn faults_of_the_text_before_the_one_that_stops_the_run_come_first() {
    let program = "G01 X1\nG00 X123456789\nM02\n";
    let expected = [(2, AlarmName::TooManyDigits, "X123456789"), (1, AlarmName::NoFeed, "G01 X1")];
    assert_eq!(faults(program), expected);
}

#[test]
fn a_fault_is_reported_once() {
    assert_eq!(faults("G00 X1\nG00 X123456789\nM02\n"), [(2, AlarmName::TooManyDigits, "X123456789")]);
}

/// Two different alarms of one block are two faults; the same alarm of two blocks is, too.
#[test]
fn faults_differ_by_block_and_by_alarm() {
    let program = "G00 X123456789\nG00 X123456789\nM02\n";
    let expected = [(1, AlarmName::TooManyDigits, "X123456789"), (2, AlarmName::TooManyDigits, "X123456789")];
    assert_eq!(faults(program), expected);
}

#[test]
fn what_stands_behind_the_end_is_no_part_of_the_program() {
    for end in ["M02", "M30", "G00 Z1 M2"] {
        assert_eq!(faults(&format!("G01 X1\n{end}\nG00 X123456789\n")), [(1, AlarmName::NoFeed, "G01 X1")]);
    }
    for word in ["M03", "G02", "T30"] {
        let found = faults("G01 X1\nWORD\nG00 X123456789\nM02\n".replace("WORD", word).leak());
        assert!(found.contains(&(3, AlarmName::TooManyDigits, "X123456789")), "{word}: {found:?}");
    }
}

#[test]
fn a_fault_names_the_program_and_the_sequence() {
    let found = check(b"O77\nN5 G00 X123456789\nM02\n", &Setup::default());
    let places: Vec<_> = found.iter().map(|fault| (fault.block.program, fault.block.sequence)).collect();
    assert_eq!(places.len(), 1);
    assert_eq!((places[0].0.as_str(), places[0].1.as_str()), ("O77", "N5"));
}

/// A character that cannot be read is a fault of the text, and reading goes on behind it.
#[test]
fn reading_goes_on_behind_a_character_that_is_none() {
    let mut setup = Setup::default();
    setup.tape.code = TapeCode::Ascii;
    let found = check(b"G00 ?\nG00 X123456789\nM02\n", &setup);
    let names: Vec<_> = found.iter().map(|fault| fault.alarm.name).collect();
    assert_eq!(names, [AlarmName::IllegalCharacter, AlarmName::TooManyDigits]);
}

/// In radius compensation the end of a motion is found at fault when a later block is read; the block of the motion
/// is the one to mend.
#[test]
fn a_fault_of_a_motion_that_waited_is_shown_at_its_block() {
    let program = "G42 G01 X100 Z100 F0.2\nZ80\nX150\nM02\n";
    let mut setup = Setup::default();
    setup.limits.z.negative = Some(Length(90_000_000));
    let found = check(program.as_bytes(), &setup);
    let faults: Vec<_> = found.iter().map(|fault| (fault.block.line, fault.alarm.name)).collect();
    assert_eq!(faults, [(2, AlarmName::TravelLimitNegative)]);
}

#[test]
fn a_character_that_begins_nothing_is_the_fault() {
    for (program, fault) in [("G00 * X1\nM02\n", "*"), ("V1=1+*2\nM02\n", "*")] {
        let found = faults(program);
        assert!(found.iter().any(|(line, _, text)| (*line, *text) == (1, fault)), "{found:?}");
    }
}

/// The alarm of the run is told beside a fault of the text with the same name in another block.
#[test]
fn equal_alarms_of_two_blocks_are_two_faults() {
    let program = "G00 X1 X2\nG02 X1 Z1 L5 CALRG CALRG\nM02\n";
    let found = faults(program);
    let lines: Vec<_> = found.iter().map(|(line, alarm, _)| (*line, *alarm)).collect();
    assert_eq!(lines, [(2, AlarmName::DuplicateAddress), (1, AlarmName::DuplicateAddress)]);
}

#[test]
fn a_block_lies_where_its_text_stands() {
    let found = check(b"G00 X1\nG01 X2\n", &Setup::default());
    let places: Vec<_> = found.iter().map(|fault| (fault.block.start, fault.block.end)).collect();
    assert_eq!(places, [(7, 13)]);
}
