//! The grammar at its edges: which characters a fault is shown at, what a keyword is, what belongs to the header. What is
//! at fault is the word, or the character (`Diagnostic::span`); never nothing.

use turnspec_oracle::check;
use turnspec_oracle::syntax::Source;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Event, Setup, TapeCode};

fn last(program: &[u8], setup: &Setup) -> String {
    let mut last = String::new();
    turnspec_oracle::run(program, setup, &mut |event: &Event| last = render(event));
    last
}

fn schedule() -> Setup {
    Setup { schedule: true, ..Setup::default() }
}

fn iso() -> Setup {
    let mut setup = Setup::default();
    setup.tape.code = TapeCode::Iso;
    setup
}

/// Start and end of what the first fault of a program is shown at, and its first rule.
fn fault(program: &[u8], setup: &Setup) -> (u32, u32, String) {
    let found = check(program, setup);
    let rule = |fault: &turnspec_oracle::Diagnostic| fault.rules.as_slice().first().map(|rule| rule.as_str());
    found.first().map_or((0, 0, String::new()), |fault| {
        (fault.span.start, fault.span.end, rule(fault).unwrap_or_default().to_owned())
    })
}

/// E100L-DEL-02: a second slash, one among the words, one in a schedule (E100L-SDF-04). E100L-GPUT-09, E100L-FMT-08: a
/// character that no string can hold. E100L-CMT-02: of a byte with three holes (C1) and of an end of block with three.
#[test]
fn a_character_at_fault_is_shown_itself() {
    for (program, setup, at, rule) in [
        (b"/N1 /G00 X10\nM02\n".as_slice(), Setup::default(), 4, "E100L-DEL-02"),
        (b"G00 /X10\nM02\n", Setup::default(), 4, "E100L-DEL-02"),
        (b"N1 /END\n", schedule(), 3, "E100L-SDF-04"),
        (b"PUT 'Ab'\nM02\n", Setup::default(), 6, "E100L-FMT-08"),
        (b"VUACM[1]='Ab'\nM02\n", Setup::default(), 11, "E100L-FMT-08"),
        (b"M00(\xC1\xA9\nM0\xB2\n", iso(), 4, "E100L-CMT-02"),
    ] {
        let text = String::from_utf8_lossy(program);
        assert_eq!(fault(program, &setup), (at, at + 1, rule.to_owned()), "{text}");
    }
}

/// E100L-CTL-03, E100L-SDF-19: the statement is at fault where it begins, the assignment and not the ones before it.
#[test]
fn a_fault_is_shown_where_its_word_begins() {
    for (program, setup, at, rule) in [
        ("N1 GOTON2\nM02\n", Setup::default(), 3, "E100L-CTL-03"),
        ("VSET V1=1 V2=VDOUT[1]\nEND\n", schedule(), 10, "E100L-SDF-19"),
    ] {
        let (start, end, found) = fault(program.as_bytes(), &setup);
        assert_eq!((start, found.as_str()), (at, rule), "{program}");
        assert!(end > start, "{program}");
    }
}

/// E100L-AEXP-01: a control statement where an operand must stand is `format`; VSET is no system variable.
#[test]
fn vset_is_no_value() {
    for program in ["V1=VSET\nM02\n", "V1=1+VSET[1]\nM02\n", "X=VSET\nM02\n"] {
        let expected = "alarm name=format line=1 rules=E100L-AEXP-01";
        assert_eq!(last(program.as_bytes(), &Setup::default()), expected, "{program}");
    }
}

/// E100L-CTL-03: a run of four is the name of a local variable, a longer one a keyword whose blank is missing.
/// E100L-SDF-02: an assignment without VSET is no block of a schedule.
#[test]
fn a_name_of_four_letters_is_no_keyword_of_a_schedule() {
    for (block, expected) in [
        ("IFEF=1", "alarm name=schedule_block line=1 rules=E100L-SDF-02"),
        ("IFEFG=1", "alarm name=statement_delimiter_missing detail=IF line=1 rules=E100L-CTL-03"),
    ] {
        assert_eq!(last(format!("{block}\nEND\n").as_bytes(), &schedule()), expected, "{block}");
    }
}

/// E100L-SDF-20: the first block that has END as its statement ends the text, with a slash too (E100L-SDF-04 finds that when
/// the block is reached).
#[test]
fn an_end_block_with_a_slash_ends_the_text() {
    for end in ["END", "/END", "N1 /END", "/ (A) END"] {
        let program = format!("GOTO N2\n{end}\nN2 END\n");
        let expected = "alarm name=sequence_name_unknown detail=N2 line=1 rules=E100L-GOTO-02";
        assert_eq!(last(program.as_bytes(), &schedule()), expected, "{end}");
    }
}

/// E100L-PROG-01, E100L-SDF-01: the header is what a text begins with; a continuation further down is none.
#[test]
fn a_header_stands_at_the_beginning() {
    let text = b"$DAY1.SDF%\nVSET V1=1\n$ V2=2\nEND\n";
    assert_eq!(Source::new(text, TapeCode::Ascii).header_of_schedule(), Some(true));
    for place in [(11, 2), (21, 3)] {
        assert_eq!(Source::at(text, TapeCode::Ascii, place).header_of_schedule(), None);
    }
}

/// E100L-GOTO-02, E100L-CMT-02: the fault of an end of block waits until the run arrives there, and an end of block behind
/// a name delimits it. 0A has two holes; 8A, with three, is an end of block with wrong parity.
#[test]
fn a_faulty_end_of_block_delimits_a_name() {
    // GOTO N1, M02, N1, in ISO code.
    let mut program = b"GOTO\xA0\x4E\xB1\n\x4D\x30\xB2\n".to_vec();
    program = program.iter().map(|byte| even(*byte)).collect();
    program.extend([even(b'N'), even(b'1'), 0x8A]);
    let found = last(&program, &iso());
    assert_eq!(found, "alarm name=parity_error line=3 rules=E100L-CMT-02");
}

/// A character of seven bits with an even number of holes.
fn even(byte: u8) -> u8 {
    let code = byte & 0x7F;
    if code.count_ones().is_multiple_of(2) { code } else { code | 0x80 }
}

/// E100L-VUACM-04, E100L-VUACM-05 (execution-io.md, "Strings"): a first character `$` without `^` makes the rest a row of
/// codes; with it the string is one of lower case, in which `$` and digits stay what they are.
#[test]
fn a_string_of_lower_case_holds_no_codes() {
    for (string, value) in [("'$41'", "A"), ("'^$41'", "$41"), ("^'$4B'", "$4b")] {
        let mut events = Vec::new();
        let program = format!("VUACM[1]={string}\nM02\n");
        turnspec_oracle::run(program.as_bytes(), &Setup::default(), &mut |event: &Event| {
            events.push(render(event))
        });
        let expected = format!("variable name=VUACM[1] value={value} ");
        assert!(events.first().is_some_and(|event| event.starts_with(&expected)), "{string}: {events:?}");
    }
}
