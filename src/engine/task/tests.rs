//! Control flow: the examples of the manual, section 13, and what surrounds them.

use turnspec_oracle::vocabulary::{CallCause, Event, Label, Setup};

use crate::engine::tests::{expect, trace};
use crate::engine::{Holder, Interpreter, Situation};

/// A set-up with one library file.
fn library(text: &str) -> String {
    format!("[library]\n\"SHAFT-A.SUB\" = \"\"\"\n{text}\"\"\"\n")
}

#[test]
fn jumps_go_forward_and_back() {
    let program = "N1 V1=V1+1\nIF [V1 LT 3] N1\nGOTO N5\nX1\nN5 X5\nM02\n";
    expect("", program, "variable value=1 line=1\nvariable value=2\nvariable value=3\nrapid x=5 line=5\nend");
    expect("", "GOTO N3\nN3 X1\nN3 X2\nM02\n", "rapid x=1\nalarm name=sequence_name_duplicate line=3");
    let backward = "GOTO N4\nN3 GOTO N6\nN4 GOTO N5\nN3 X2\nN5 GOTO N3\nN6 X6\nN4 M02\n";
    expect("limits.steps = 100", backward, "rapid x=6\nalarm name=sequence_name_duplicate line=7");
    expect("", "GOTO N4\nO2\nN4 X1\n", "alarm name=sequence_name_unknown detail=N4 rules=E100L-GOTO-02");
    expect("", "IF [1] GOTO N04\nN4\n", "alarm name=sequence_name_unknown rules=E100L-IFST-03");
    expect(
        "",
        "IF [0] N9\nIF[-0.0]GOTO N9\nIF CD N9\nCD=0\nIF CD N1\nX1\nN1 X2\nM02\n",
        "variable\nrapid x=2\nend",
    );
    let skipped = "switches.block_delete = true";
    expect(skipped, "GOTO N4\nX1\n/ N4 X2\nN5 X3\nM02\n", "rapid x=3\nend");
    expect(skipped, "GOTO N4\nX1\n/ (A) N4 X2\nM02\n", "alarm name=sequence_name_unknown");
}

#[test]
fn statements_that_are_not_well_formed() {
    let alarms = [
        ("GOTON1", "statement_delimiter_missing", "CTL-03", "GOTO"),
        ("GOTO 1", "format", "GOTO-01", ""),
        ("GOTO N1/", "sequence_delimiter_missing", "SEQ-02", ""),
        ("GOTO N1 X1", "format", "GOTO-01", ""),
        ("X1 GOTO N1", "statement_misplaced", "GCODE-03", ""),
        ("IFABC N1", "statement_delimiter_missing", "CTL-03", "IF"),
        ("IF V1 N1", "format", "IFST-01", ""),
        ("IF X1 N1", "format", "IFST-01", ""),
        ("IF SIN N1", "format", "IFST-01", ""),
        ("IF NAB N1", "local_name_malformed", "LVAR-01", "NAB"),
        ("IF ABCDE N1", "local_name_malformed", "LVAR-01", "ABCDE"),
        ("IF CD/ N1", "statement_delimiter_missing", "CTL-06", "CD"),
        ("IF [1 N1", "bracket_unbalanced", "AEXP-04", ""),
        ("IF [1]GOTO", "format", "IFST-01", ""),
        ("CALL 1", "format", "CALL-01", ""),
        ("CALL :1", "format", "CALL-01", ""),
        ("CALL O12345", "program_name_malformed", "NAME-01", ""),
        ("MODIN OOA", "program_name_reserved", "NAME-02", ""),
        ("CALL O1=5", "statement_delimiter_missing", "CTL-06", "O1"),
        ("CALL O1 CD=1 X1", "word_without_function", "CALL-01", "X"),
        ("MODIN O1 CALRG", "word_without_function", "MODIN-01", "CALRG"),
        ("NOEX G01", "word_without_function", "NOEX-01", "G"),
        ("G205 X1", "word_without_function", "MACRO-01", "X"),
        ("RTS X1", "format", "RTS-01", ""),
        ("MODOUT/", "statement_delimiter_missing", "CTL-03", "MODOUT"),
        ("MODOUT O1", "format", "MODIN-04", ""),
        ("READ 'A", "format", "RDWR-01", ""),
        ("X1 G205", "statement_misplaced", "MACRO-01", "G205"),
        ("M=320+1", "statement_misplaced", "MACRO-02", "M321"),
        ("ABCDE=1", "local_name_malformed", "LVAR-01", "ABCDE"),
        ("CD 1", "equal_sign_missing", "FMT-02", ""),
        ("CD=CE", "local_undefined", "LVAR-05", "CE"),
        ("CD=NX", "local_name_malformed", "LVAR-01", "NX"),
        ("M321", "macro_unassigned", "MACRO-02", "M321"),
        ("RTS", "return_outside_subprogram", "RTS-04", ""),
        ("MODOUT", "modout_without_modin", "MODIN-04", ""),
        ("CALL O9", "program_unknown", "CALL-03", "O9"),
    ];
    for (block, name, rule, detail) in alarms {
        let detail = if detail.is_empty() { "-" } else { detail };
        let expected = format!("alarm name={name} rules=E100L-{rule} detail={detail}");
        expect("options.user_task = 2", &format!("{block}\n"), &expected);
    }
    expect("options.user_task = 1", "CALL O1\n", "alarm name=user_task_level detail=CALL rules=E100L-UT-03");
    let macros = "macros.G161 = \"O1\"";
    expect(macros, "G=161\n", "alarm name=program_unknown detail=O1 rules=E100L-CALL-03");
}

#[test]
fn local_variables_of_three_levels() {
    let subprograms = "O1000\nCALL O2000 ABC=500 DEF=750\nRTS\nO2000\nABC=220\nDEF=300\n\
        CALL O3000 ABC=400 DEF=350\nV2=ABC\nRTS\nO3000\nV1=ABC\nXY=1\nRTS\n";
    let program = "ABC=20 DEF=50\nCALL O1000 ABC=100 DEF=150\nV3=ABC\nIF XY N1\nM02\nN1\n";
    expect(
        &library(subprograms),
        program,
        "variable name=ABC value=20 rules=E100L-LVAR-04
        variable name=DEF
        variable name=ABC value=100 rules=E100L-LVAR-08
        variable name=DEF
        call name=O1000 cause=call line=2
        variable value=500
        variable value=750
        call name=O2000 line=2
        variable name=ABC value=220 rules=E100L-LVAR-06+E100L-LVAR-11 line=5
        variable name=DEF value=300
        variable value=400
        variable value=350
        call name=O3000
        variable name=V1 value=400
        variable name=XY rules=E100L-LVAR-04+E100L-LVAR-10
        return line=13
        variable name=V2 value=220
        return
        return
        variable name=V3 value=20
        end",
    );
    let full: String = (0..127).map(|n| format!("A{}{}=0\n", char::from(b'A' + n / 10), n % 10)).collect();
    let events = trace("", &format!("{full}AZ9=1/0\n"));
    assert_eq!(events.len(), 128);
    expect(
        "",
        &format!("{full}AA0=1\nAZ9=1\n"),
        "...\nvariable name=AA0 value=1\nalarm name=local_capacity detail=AZ9",
    );
}

#[test]
fn programs_end() {
    expect(
        &library("O1\nX1\nO2\n"),
        "CALL O1\n",
        "call\nrapid\nalarm name=no_return line=3 rules=E100L-RTS-01",
    );
    expect(&library("O1\nX1\n"), "CALL O1\n", "call\nrapid\nalarm name=no_return line=3");
    expect("", "O1\nCALL O2\nM02\nO2\nX1\nRTS\n", "call line=2\nrapid line=5\nreturn\nend");
    expect("", "O1\nX1\nO2\n", "rapid\nalarm name=program_name_misplaced");
    expect("", "O1\nX1\nO2 X\n", "rapid\nalarm name=program_name_not_alone");
    expect(&library("O1 X\n"), "CALL O1\n", "call\nalarm name=program_name_not_alone line=1");
    expect(&library("O1\nO1\n"), "CALL O1\n", "alarm name=program_duplicate detail=O1");
    expect(&library("$A.SDF\nX1\nO1\nRTS\n"), "CALL O1\nM02\n", "call\nreturn\nend");
    expect("", "O1\nV1=V1+1\nCALL O1\n", "...\nvariable value=9\nalarm name=call_depth rules=E100L-CALL-04");
    expect("", "G01 A10\nO2\nRTS\n", "mode\nalarm name=angle_lookahead line=1");
    expect("", "$A.SUB%\nM02\n", "alarm name=program_kind detail=SUB");
}

#[test]
fn steps_are_counted() {
    expect("limits.steps = 3", "N1 GOTO N1\n", "alarm name=step_limit line=1 rules=E100L-GOTO-03");
    expect("limits.steps = 4", "O1\n\n%\nX1\nX2\nM02\n", "rapid\nrapid\nalarm name=step_limit line=6");
    let angles = "G01 F1 X1 Z1\nG01 A170\n\n(A)\nN5 X10 Z-10 A100\nM02\n";
    expect("limits.steps = 3", angles, "mode\nlinear\nlinear\nalarm name=step_limit line=4");
    expect("limits.steps = 5", angles, "mode\nlinear\nlinear\nlinear\nalarm name=step_limit line=6");
}

#[test]
fn modes_call_in_their_order() {
    let subprograms = "O1000\nX1\nRTS\nO2000\nN2001 X2\nRTS\n";
    let program = "N001 MODIN O1000\nX10\nN010 MODIN O2000 CD=5\nX20\nN020 MODOUT\nC1\nZ30\nN030 MODOUT\n\
        X40\nIF CD N1\nM02\nN1\n";
    expect(
        &library(subprograms),
        &format!("M110\n{program}"),
        "aux
        rapid x=10
        call name=O1000 cause=modal line=3 rules=E100L-MODIN-02
        rapid x=1
        return
        variable name=CD rules=E100L-MODIN-09
        rapid x=20
        call name=O1000 line=5 rules=E100L-MODIN-02+E100L-MODIN-06
        rapid x=1
        return
        call name=O2000 line=5
        rapid x=2
        call name=O1000 rules=E100L-MODIN-02+E100L-MODIN-06+E100L-MODIN-07 block=N2001
        rapid x=1
        return
        return
        rapid c=1
        rapid z=30
        call name=O1000 line=8
        rapid x=1
        return
        rapid x=40
        end",
    );
    let nine = "MODIN O1000\n".repeat(9);
    expect(&library(subprograms), &nine, "alarm name=modin_depth line=9");
    let chamfer = "MODIN O1000\nG01 F1 Z1\nG75 X10 L1\n";
    expect(&library(subprograms), chamfer, "...\nalarm name=unspecified detail=G75 rules=E100L-MODIN-02");
    let within = library("O1\nMODIN O1\nRTS\nO2\nMODOUT\nRTS\nO3\nMODIN O2\nRTS\n");
    expect(
        &within,
        "MODIN O1\nX1\n",
        "rapid\ncall\nalarm name=unspecified detail=MODIN rules=E100L-MODIN-07",
    );
    expect(&within, "MODIN O1\nCALL O2\n", "call\nalarm name=unspecified detail=MODOUT");
    expect(&within, "CALL O3\n", "call\nalarm name=unspecified detail=RTS rules=E100L-MODIN-09");
}

#[test]
fn statements_do_not_count_in_compensation() {
    let setup =
        format!("[[nose_radius]]\nnumber = 1\nx = 0.8\nz = 0.8\n{}", library("O1\nM08\nRTS\nO2\nM09\nRTS\n"));
    let program = "G42 G01 X50 Z100 F0.2 T010101\nZ80\nCALL O1\nGOTO N1\nN1 X60 Z70\nG40 X70\nM02\n";
    expect(
        &setup,
        program,
        "...
        linear x=50 z=80 line=2 rules=E100L-NRC-43
        call
        coolant
        return
        linear x=60 z=70
        ...",
    );
    let looked_at = "G01 F1 X1 Z1\nA170\nGOTO N1\nN1\n";
    expect("", looked_at, "...\nalarm name=unspecified detail=GOTO line=3 rules=E100L-ANG-06");
    expect("", "G01 F1 X1 Z1\nA170\nNOEX CD=1\n", "...\nalarm name=angle_lookahead line=2");
}

#[test]
fn blocks_that_are_run_again_are_the_same() {
    let body = "N1 X=V1 (A)\n$ Z=V1*2\n\n% \n/ N7 M08\nCALL O9 CD=V1\nV1=V1+1\nIF [V1 LT 50] N1\nM02\nO9\n\
        V2=CD\n\nRTS\n";
    let events = trace("", body);
    let lines: Vec<_> = events.iter().map(|event| event.block.line).collect();
    let round = [1, 5, 6, 6, 11, 13, 7];
    assert_eq!(events.len(), 7 * 50 + 1 + 7 - 7);
    for (place, line) in lines.iter().enumerate().take(7 * 50) {
        assert_eq!(*line, round[place % 7], "event {place}");
    }
    for (place, event) in events.iter().enumerate().skip(7).take(7 * 49) {
        let first = events[place % 7].block;
        assert_eq!(event.block, first);
    }
}

#[test]
fn a_situation_tells_calls_modes_and_variables() {
    let setup = Setup::from_toml(&library("O1\nCALL O2 XP=2\nRTS\nO2\nX1\nRTS\nO3\nX2\nRTS\n"));
    let setup = setup.unwrap_or_else(|error| panic!("{error}"));
    let mut interpreter = Interpreter::new(b"O5\nCD=1\nMODIN O3 MX=3\nCALL O1\nM02\n", &setup);
    assert_eq!(interpreter.situation(), Situation { steps_left: 10_000_000, ..Situation::default() });
    let mut moved = 0;
    while moved < 2 {
        let mut sink = |event: &Event| moved += usize::from(event.block.line == 5 || event.block.line == 8);
        assert_eq!(interpreter.step(&mut sink), None);
    }
    let situation = interpreter.situation();
    let names: Vec<&str> = situation.calls.iter().map(|level| level.program.as_str()).collect();
    assert_eq!(names, ["O1", "O2", "O3"]);
    assert_eq!(situation.calls[2].cause, CallCause::Modal);
    assert_eq!((situation.calls[1].caller.program, situation.calls[1].caller.line), (Label::new("O1"), 2));
    let locals: Vec<_> =
        situation.locals.iter().map(|local| (local.name.as_str(), local.value, local.owner)).collect();
    assert_eq!(
        locals,
        [("CD", 1.0, Holder::Main), ("MX", 3.0, Holder::Mode(0)), ("XP", 2.0, Holder::Call(1))]
    );
    assert_eq!(situation.modes.len(), 1);
    assert_eq!(situation.program, Label::new("O3"));
}
