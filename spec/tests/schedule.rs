//! Schedule programs seen from outside: which blocks there are, and what goes from one program to the next.

use turnspec_oracle::check;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Event, ProgramText, Setup};

fn setup(library: &[(&str, &str)]) -> Setup {
    let texts =
        library.iter().map(|(file, text)| ((*file).to_owned(), ProgramText(text.as_bytes().to_vec())));
    Setup { library: texts.collect(), schedule: true, ..Setup::default() }
}

/// The trace without rules, one line an event, with the program name at its end.
fn trace(program: &str, setup: &Setup) -> Vec<String> {
    let mut trace = Vec::new();
    turnspec_oracle::run(program.as_bytes(), setup, &mut |event: &Event| {
        let text = render(event);
        let words = text.split(' ').filter(|word| !word.starts_with("rules="));
        let words: Vec<_> = words.chain([event.block.program.as_str()]).collect();
        trace.push(words.join(" ").trim_end().to_owned());
    });
    trace
}

fn last(program: &str, setup: &Setup) -> String {
    trace(program, setup).pop().unwrap_or_default()
}

/// E100L-SDF-01: a header says what a text is, whatever its file is called.
#[test]
fn a_header_decides_before_the_file() {
    let setup = setup(&[]);
    assert_eq!(last("END\n", &setup), "end code=END line=1");
    assert_eq!(last("$DAY1.SDF%\nEND\n", &Setup::default()), "end code=END line=2");
    assert_eq!(last("$A.MIN%\nM02\n", &setup), "end code=M02 line=2");
    assert_eq!(last("$A.SDF\nEND\n", &setup), "alarm name=header_malformed line=1");
}

/// E100L-SDF-02, E100L-SDF-04, E100L-SDF-17 to -20.
#[test]
fn a_block_is_a_statement_and_nothing_else() {
    for (block, alarm) in [
        ("/", "alarm name=schedule_end_missing line=2"),
        ("/END", "alarm name=schedule_block line=1"),
        ("N1 /(A) END", "alarm name=schedule_block line=1"),
        ("O100", "alarm name=schedule_block line=1"),
        ("N1 :100", "alarm name=schedule_block line=1"),
        ("GOTON1", "alarm name=statement_delimiter_missing detail=GOTO line=1"),
        ("READ0", "alarm name=schedule_block line=1"),
        ("VSETV1=1", "alarm name=schedule_block line=1"),
        ("VSET[1]", "alarm name=statement_delimiter_missing detail=VSET line=1"),
        ("END(LAST)", "end code=END line=1"),
        ("END?", "alarm name=format line=1"),
        ("VSET SB=1", "alarm name=schedule_left_side line=1"),
        ("VSET XA=1", "alarm name=schedule_left_side line=1"),
        ("VSET P=1", "alarm name=schedule_left_side line=1"),
        ("VSET VDIN", "alarm name=schedule_left_side line=1"),
        ("VSET R=1", "alarm name=schedule_left_side line=1"),
        ("VSET N1=1", "alarm name=not_modelled detail=N line=1"),
        ("VSET ABCDE=1", "alarm name=local_name_malformed detail=ABCDE line=1"),
        ("VSET CALRG", "alarm name=format line=1"),
        ("VSET V1=1 END", "alarm name=statement_misplaced line=1"),
        ("VSET VTOFX[VDOUT[1]]=1", "alarm name=schedule_right_side line=1"),
        ("VSET V1=VUACM[1]", "alarm name=unspecified detail=VUACM line=1"),
        ("VSET VIRD[1]=1", "alarm name=variable_read_only line=1"),
    ] {
        assert_eq!(last(&format!("{block}\n"), &setup(&[])), alarm, "{block}");
    }
}

/// E100L-SDF-06 to -10, E100L-SDF-13.
#[test]
fn a_selection_has_a_form() {
    let setup = setup(&[("A.MIN", "M02\n")]);
    for (items, alarm) in [
        ("A.", "file_name_malformed"),
        ("MD:A", "file_name_malformed"),
        ("A.MIN.B", "file_name_malformed"),
        ("A:*", "file_wildcard"),
        ("A B", "format"),
        ("A,100", "format"),
        ("A,O1.", "format"),
        ("A,OO1", "program_name_reserved"),
        ("A,,MD1:", "file_name_malformed"),
        ("A,,?", "file_name_malformed"),
        ("A,,,1", "format"),
        ("A,,,Q", "equal_sign_missing"),
        ("A,,,Q-1", "equal_sign_missing"),
        ("A,,,Q=-1", "repetitions_range"),
        ("A,,,Q0.4", "repetitions_range"),
        ("A,,,Q1.2.3", "number_malformed"),
        ("A,,,Q=VDOUT[1]", "unspecified"),
    ] {
        let line = last(&format!("PSELECT {items}\nEND\n"), &setup);
        assert!(line.starts_with(&format!("alarm name={alarm} ")), "{items}: {line}");
    }
    for items in ["A.MIN(X),(Y),,Q(Z)1", ",,,Q.5", "(X)", "MD1:,,A.MIN"] {
        let trace = trace(&format!("PSELECT {items}\nEND\n"), &setup);
        assert_eq!(trace.len(), 3, "{items}: {trace:?}");
    }
}

/// E100L-SDF-20: END ends the text, and has a name itself.
#[test]
fn names_reach_to_the_end_block() {
    let setup = setup(&[]);
    assert_eq!(
        last("GOTO N2\nN1 END\nN2 END\n", &setup),
        "alarm name=sequence_name_unknown detail=N2 line=1"
    );
    assert_eq!(last("GOTO N1\nN1 END\n", &setup), "end code=END line=2");
    assert_eq!(
        last("N1 GOTO N2\nN1 END\nN2 END\n", &setup),
        "alarm name=sequence_name_unknown detail=N2 line=1"
    );
    assert_eq!(last("N1 VSET V1=1\nN1 END\n", &setup), "alarm name=sequence_name_duplicate line=2");
}

/// E100L-SDF-08, E100L-SDF-14: a selected program begins anew each time, and ends where the next one begins.
#[test]
fn a_selected_program_runs_within_its_bounds() {
    let file = "(A)\nO1\nN1 GOTO N2\nN2 M02\nO2\nGOTO N3\nM02\nN3 V1=1\nO3\n";
    let setup = setup(&[("A.MIN", file)]);
    assert_eq!(
        trace("PSELECT A,,,Q2\nPSELECT A,O2\nEND\n", &setup),
        [
            "select file=MD1:A.MIN name=O1 repetition=1 line=1",
            "end code=M02 line=4 O1",
            "select file=MD1:A.MIN name=O1 repetition=2 line=1",
            "end code=M02 line=4 O1",
            "select file=MD1:A.MIN name=O2 repetition=1 line=2",
            "variable name=V1 value=1 line=8 O2",
            "alarm name=no_program_end line=9 O2",
        ]
    );
}

/// E100L-SDF-14: local variables of a subprogram that M02 has ended belong to no later call.
#[test]
fn local_variables_outlive_the_program() {
    let setup = setup(&[
        ("A.MIN", "CALL O1\nM02\n"),
        ("B.MIN", "CALL O2\nX=ABC\nM02\n"),
        ("T.SSB", "O1\nABC=5\nM02\nRTS\nO2\nABC=ABC+1\nRTS\n"),
    ]);
    let program = "PSELECT A\nPSELECT B\nEND\n";
    let trace = trace(program, &setup);
    assert!(trace.contains(&"variable name=ABC value=6 line=6 O2".to_owned()), "{trace:?}");
    assert_eq!(trace.last().map(String::as_str), Some("end code=END line=3"), "{trace:?}");
}

/// E100L-SDF-10: what the schedule itself and files without a part in the selection hold is not called.
#[test]
fn subprograms_are_those_of_the_selection() {
    let mut setup = setup(&[("A.MIN", "CALL O1\nM02\n"), ("B.MIN", "O1\nRTS\n")]);
    assert_eq!(last("PSELECT\nEND\n", &setup), "alarm name=program_unknown detail=O1 line=1");
    assert_eq!(last("PSELECT ,,B.MIN\nEND\n", &setup), "end code=END line=2");
    setup.library.insert("C.SSB".to_owned(), ProgramText(b"O1\nRTS\n".to_vec()));
    assert_eq!(last("PSELECT ,,B.MIN\nEND\n", &setup), "alarm name=program_duplicate detail=O1 line=1");
}

/// E100L-GOTO-03: blocks of the schedule are steps, too.
#[test]
fn blocks_of_a_schedule_are_steps() {
    let mut setup = setup(&[("A.MIN", "M02\n")]);
    setup.limits.steps = 3;
    assert_eq!(last("\nPSELECT\nEND\n", &setup), "alarm name=step_limit line=3");
    assert_eq!(last("PSELECT\nEND\n", &setup), "end code=END line=2");
    assert_eq!(last("N1 GOTO N1\nEND\n", &setup), "alarm name=step_limit line=1");
}

/// Every fault of a schedule up to its END block.
#[test]
fn all_faults_of_a_schedule_are_found() {
    let found = check(b"$A.SDF%\nX10\nVSET ABC=1\nEND\nX10\n", &Setup::default());
    let names: Vec<_> = found.iter().map(|fault| (fault.block.line, fault.alarm.name.as_str())).collect();
    assert_eq!(names, [(2, "schedule_block"), (3, "schedule_left_side")]);
}
