//! How a program runs, at its edges: what look-ahead knows, where a definition of LAP begins and ends, what is tested while
//! it is read, which rules a call cites. All values follow by hand from the rule texts.

mod support;

use support::{holds, trace};
use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Event, Length, Limit, MachineType, PlanePosition, ProgramText, Setup};

/// A set-up with one text in its library.
fn library(file: &str, text: &str) -> Setup {
    let text = ProgramText(text.as_bytes().to_vec());
    Setup { library: [(file.to_owned(), text)].into(), ..Setup::default() }
}

/// The rules of the first event of a kind.
fn rules(program: &str, kind: &str, setup: &Setup) -> Vec<&'static str> {
    let events = trace(program, setup);
    let event = events.iter().find(|event| render(event).starts_with(kind));
    event.map(|event| event.rules.as_slice().iter().map(|rule| rule.as_str()).collect()).unwrap_or_default()
}

/// E100L-ANG-06 with the figures of its example of a chamfer: in G91, selected by the block with A alone, X40 Z-30 count
/// from its start, the corner (60, 90), and lead to (100, 60); the block behind is one of G91.
#[test]
fn look_ahead_goes_on_in_the_mode_of_the_block_that_it_has_seen() {
    holds(
        "G00 X20 Z90\nG75 G01 X60 L6 F0.2\nG91 A120\nX40 Z-30 A180\nM02\n",
        "rapid x=20 z=90
mode group=motion code=G01
linear x=48 z=90 line=2
linear x=70.392305 z=87 line=2
mode group=dimension code=G91 line=3
linear x=100 z=78.452995 line=3 rules=E100L-ANG-06
linear x=100 z=60 line=4 rules=E100L-ANG-06
...
end code=M02",
        &Setup::default(),
    );
}

/// E100L-LAP-09, E100L-ANG-05: the call names a block that is there, so that it has no fault of its own; but it is nothing
/// that a corner can have.
#[test]
fn look_ahead_finds_the_contour_of_a_call() {
    let program =
        "NAT1 G81\nG00 X20 Z2\nG01 Z-10 F0.2\nG80\nG00 X20 Z120\nG75 G01 X60 L6\nG85 NAT1 D8\nM02\n";
    holds(program, "...\nalarm name=angle_lookahead line=6 rules=E100L-ANG-05", &Setup::default());
    let program = program.replace("G85 NAT1", "G85 NAT2");
    let expected = "...\nalarm name=sequence_name_unknown detail=NAT2 line=7 rules=E100L-LAP-09";
    holds(&program, expected, &Setup::default());
}

/// E100L-PROG-03: a block that look-ahead has read belongs to its program all the same.
#[test]
fn a_block_read_ahead_belongs_to_its_program() {
    let events = trace("O1\nG00 X60 Z90\nG01 A120 F0.2\nX100 Z60 A180\nM02\n", &Setup::default());
    assert!(events.iter().any(|event| event.block.line == 4));
    assert!(events.iter().all(|event| event.block.program.as_str() == "O1"), "{events:?}");
}

/// E100L-LAP-09 (execution-lap.md, section 5): the block must have G81, G82 or G83, for G88 G81 or G82: else `start`, at the
/// place of the call. A call that names a block of the program, itself, is evaluated and checked without fault before.
#[test]
fn what_begins_no_definition() {
    let program = "NAT4 G83\nG01 X28 Z5\nX24\nG81\nG00 X20 Z5\nG34 Z-10 F1.5\nG80\nG00 X24 Z5\nG88 NAT4 D1 H1 M74\nM02\n";
    let expected = "...\nalarm name=contour_malformed detail=start line=9 rules=E100L-LAP-09";
    holds(program, expected, &Setup::default());
    let program = "G00 X36 Z4\nG85 N3 D8 F0.3\nN3 G85 N3 D8 F0.3\nM02\n";
    let expected = "rapid x=36 z=4\nalarm name=contour_malformed detail=start line=2 rules=E100L-LAP-09";
    holds(program, expected, &Setup::default());
}

/// E100L-MIRR-09: a change of the turret is forbidden in LAP; the code of the selected one is not listed (E100L-LAP-04).
#[test]
fn a_definition_selects_no_turret() {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoTurrets;
    for (code, alarm) in [
        ("G13", "contour_malformed detail=G13 line=3 rules=E100L-LAP-04"),
        ("G14", "turret_change line=3 rules=E100L-MIRR-09"),
        ("G14 G13", "g_codes_conflict line=3 rules=E100L-GCODE-04"),
    ] {
        let program =
            format!("NAT1 G81\nG00 X20 Z2\n{code}\nG01 Z-10\nG80\nG00 X36 Z4\nG85 NAT1 D8 F0.3\nM02\n");
        holds(&program, &format!("...\nalarm name={alarm}"), &setup);
    }
}

/// E100L-LAP-01 (execution-lap.md, section 5, "The end"): G80 in a program that the definition has called.
#[test]
fn a_definition_ends_in_its_own_program() {
    let setup = library("A.SUB", "O1\nG01 Z-10\nG80\nRTS\n");
    let program = "NAT1 G81\nG00 X20 Z2\nCALL O1\nX36\nG80\nG00 X36 Z4\nG85 NAT1 D8 F0.3\nM02\n";
    let expected =
        "...\ncall name=O1\nalarm name=contour_malformed detail=G80 program=O1 line=3 rules=E100L-LAP-01";
    holds(program, expected, &setup);
}

const CONTOUR: &str = "G00 X20 Z2\nG01 Z-10 F0.2\nX36\nG80\n";

/// While a definition is read limits are not tested (execution-lap.md, section 5), in the contour behind a blank neither:
/// Ø20 is beyond the limit, Ø21, where U1 leaves it, is not. Its passes are tested as ever (E100L-LIM-02).
#[test]
fn limits_are_those_of_the_passes() {
    let blank = "NAT1 G83\nG01 X20 Z2\nX36\nZ-10\n";
    for (head, rest) in [("NAT1 ", ""), (blank, "")] {
        let program = format!("{head}G81\n{CONTOUR}{rest}G00 X40 Z10\nG85 NAT1 D8 F0.3 U1\nM02\n");
        let with_limit = |negative| {
            let mut setup = Setup::default();
            setup.limits.x = Limit { positive: None, negative: Some(Length(negative)) };
            setup
        };
        holds(&program, "...\nlinear x=21 z=-10\n...\nend code=M02", &with_limit(20_500_000));
        holds(&program, "...\nalarm name=travel_limit_negative rules=E100L-LIM-02", &with_limit(21_500_000));
    }
}

/// E100L-LAP-01: the motions that a call has read, the first of which leads to the start.
#[test]
fn an_outline_holds_the_motions_of_the_contour() {
    let program = format!("NAT1 G81\n{CONTOUR}G00 X36 Z4\nG85 NAT1 D16 F0.3\nM02\n");
    let setup = Setup::default();
    let mut run = Run::new(program.as_bytes(), &setup);
    assert!(run.outline().is_none());
    while run.step(&mut |_: &Event| {}).is_none() {}
    let ends = run.outline().map(|outline| {
        assert_eq!((outline.number, outline.blank.len()), (1, 0));
        assert!(outline.contour.iter().all(|motion| motion.arc.is_none()));
        outline.contour.iter().map(|motion| motion.end).collect()
    });
    let expected: Vec<PlanePosition> = [(20, 2), (20, -10), (36, -10)]
        .map(|(x, z)| PlanePosition { x: Length(x * 1_000_000), z: Length(z * 1_000_000) })
        .into();
    assert_eq!(ends, Some(expected));
}

/// E100L-MODIN-06 is about several modes: with one the call cites E100L-MODIN-02 alone.
#[test]
fn one_mode_has_no_order() {
    let setup = library("A.SUB", "O1\nRTS\nO2\nRTS\n");
    let one = "MODIN O1\nG00 X10\nM02\n";
    assert_eq!(rules(one, "call", &setup), ["E100L-MODIN-02"]);
    let two = "MODIN O1\nMODIN O2\nG00 X10\nM02\n";
    assert_eq!(rules(two, "call", &setup), ["E100L-MODIN-02", "E100L-MODIN-06"]);
}

/// E100L-SDF-14: M02 of a selected program with a modal call in force; behind MODOUT there is none.
#[test]
fn a_mode_does_not_reach_the_next_program() {
    let schedule = "$DAY1.SDF%\nPSELECT\nEND\n";
    let setup = library("A.MIN", "MODIN O1\nG00 X1\nM02\nO1\nRTS\n");
    let expected = "select file=MD1:A.MIN
rapid x=1
call name=O1 cause=modal
return
alarm name=unspecified detail=MODIN line=3 rules=E100L-SDF-14";
    holds(schedule, expected, &setup);
    let setup = library("A.MIN", "MODIN O1\nMODOUT\nM02\nO1\nRTS\n");
    holds(schedule, "select file=MD1:A.MIN\nend code=M02\nend code=END", &setup);
}

/// E100L-SDF-09, E100L-DEC-02: M30 as a plain number, with the point or without.
#[test]
fn the_end_of_a_selected_program_may_have_a_point() {
    let setup = library("A.MIN", "G00 X1\nM30.0\n");
    let expected = "select file=MD1:A.MIN\nrapid x=1\nend code=M30\nend code=END";
    holds("$DAY1.SDF%\nPSELECT\nEND\n", expected, &setup);
}
