//! G87 at its edges (E100L-LAPC-06; execution-lap.md, sections 5 and 6): contour coordinates and those of the program, what
//! comes before the first motion, and what look-ahead finds in a program that a definition calls. Values follow by hand.

mod support;

use support::trace;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{ProgramText, Setup};

fn holds(program: &str, expected: &str) {
    support::holds(program, expected, &Setup::default());
}

/// A contour from (20, 0) that is finished from (80, 50), with these words of the call.
fn finished(contour: &str, words: &str) -> String {
    format!("NA G81\nG00 X20 Z0\n{contour}G80\nG00 X80 Z50\nG87 NA {words}\nM02\n")
}

/// The signs of 80 − 20 and 50 − 0 are positive: everything lies (U, W) off, the centre of an arc too.
#[test]
fn the_centre_of_an_arc_is_moved_with_the_contour() {
    holds(
        &finished("G01 Z-10 F0.2\nG03 X40 Z-20 K-10\n", "U1 W0.5"),
        "rapid x=80 z=50
rapid x=21 z=0.5
mode code=G01
linear x=21 z=-9.5
mode code=G03
arc x=41 z=-19.5 sense=ccw cx=21 cz=-19.5
mode code=G00
end",
    );
}

/// Increments count from the present point in contour coordinates, here (20, 0) and (20, −10); what they lead to is moved.
#[test]
fn increments_count_from_the_present_point_of_the_contour() {
    holds(
        &finished("G91 G01 Z-10 F0.2\nX16\nX4 Z-5\n", "U1 W0.5"),
        "...
rapid x=21 z=0.5
mode code=G91
mode code=G01
linear x=21 z=-9.5
linear x=37 z=-9.5
linear x=41 z=-14.5
...",
    );
}

/// A line under 135 degrees from (20, −10) to X40 ends 10 behind its start, at Z−20; one that ends at Z−30 comes to X60.
#[test]
fn an_angle_starts_from_the_present_point_of_the_contour() {
    holds(
        &finished("G01 Z-10 F0.2\nA135 X40\nA135 Z-30\n", "U1 W0.5"),
        "...
linear x=21 z=-9.5
linear x=41 z=-19.5
linear x=61 z=-29.5
...",
    );
}

/// E100L-LAP-07 is cited when the block of a motion has F or S, one of them alone too, and else not.
#[test]
fn motions_cite_f_or_s_of_their_block() {
    let program = finished("G01 Z-10 F0.2\nX30 S500\nZ-20\nX40 F0.1 S600\n", "");
    let trace = trace(&program, &Setup::default());
    for (line, expected) in [(2, false), (3, true), (4, true), (5, false), (6, true)] {
        let motion = trace.iter().find(|event| event.block.line == line && render(event).contains(" mx="));
        let found =
            motion.map(|event| event.rules.as_slice().iter().any(|rule| rule.as_str() == "E100L-LAP-07"));
        assert_eq!(found, Some(expected), "line {line}");
    }
}

/// A block without motion is not the first motion: the shift is told by the target of the first one, which may be in G00.
#[test]
fn a_block_without_motion_before_the_first_motion_decides_nothing() {
    holds(
        "NA G81\nF0.2\nG00 X20 Z0\nG01 Z-10\nG80\nG00 X80 Z50\nG87 NA U1 W0.5\nM02\n",
        "rapid x=80 z=50\nrapid x=21 z=0.5\nmode code=G01\nlinear x=21 z=-9.5 f=0.2mm/rev\nmode code=G00\nend",
    );
    holds(
        "NA G81\nS500\nG00 X20 Z2\nG01 Z-10\nX36\nG80\nG00 X36 Z4\nG86 NA D16 F0.3\nM02\n",
        "rapid x=36 z=4\nrapid x=20 z=2\nlinear x=20 z=-10\nlinear x=36 z=-10\nrapid x=36 z=4\nend",
    );
}

/// The corner of a chamfer is computed: beyond ±99999.999 it is `coordinate_range` (E100L-ADDR-01), which tests program
/// coordinates, even if both ends of the chamfer are within. Its words are within the range of their addresses.
#[test]
fn the_corner_of_a_chamfer_is_tested_in_program_coordinates() {
    let x = |words: &str, from: &str| {
        format!(
            "NA G81\nG00 X90000 Z0\nG75 G01 X99999.9 Z-4999.95 L1 F1\nG01 X90000 Z-9999.9\nG80\nG00 X{from} Z9\n\
             G87 NA {words}\nM02\n"
        )
    };
    let z = |words: &str, from: &str| {
        format!(
            "NA G81\nG00 X20 Z90000\nG75 G01 X9999.9 Z99999.9 L1 F1\nG01 X20019.8 Z90000\nG80\nG00 X30 Z{from}\n\
             G87 NA {words}\nM02\n"
        )
    };
    let refused = "...\nmode code=G01\nalarm name=coordinate_range line=3 rules=E100L-ADDR-01";
    holds(&x("U0.5", "95000"), refused);
    holds(&z("W0.5", "95000"), refused);
    let carried_out = "...\nmode code=G01\nlinear line=3\nlinear line=3\n...\nend";
    for program in [x("U0.5", "80000"), x("", "95000"), z("W0.5", "80000"), z("", "95000")] {
        holds(&program, carried_out);
    }
}

/// In G91 the corner comes to 100000.2 as the contour counts, which no word can say: what is tested is 0.5 less.
#[test]
fn a_corner_beyond_the_range_of_a_word_may_be_within_that_of_the_machine() {
    let x = "NA G81\nG00 X90000 Z0\nG91 G75 G01 X10000.2 Z-5000.1 L1 F1\nG01 X-10000.2 Z-5000.1\nG80\nG00 X80000 Z9\n\
             G87 NA U0.5\nM02\n";
    let z = "NA G81\nG00 X20 Z90000\nG91 G75 G01 X10000.2 Z10000.2 L1 F1\nG01 X10000.2 Z-10000.2\nG80\nG00 X30 Z80000\n\
             G87 NA W0.5\nM02\n";
    for program in [x, z] {
        holds(program, "...\nmode code=G91\nmode code=G01\nlinear line=3\nlinear line=3\n...\nend");
    }
}

/// `RTS` may stand in a program that the definition has called; as the block behind an angle alone it is a statement there
/// (E100L-ANG-06). In the program of the definition it has no place at all (section 5: E100L-LAP-04).
#[test]
fn look_ahead_finds_the_end_of_a_called_program() {
    let sub = ProgramText(b"O1\nG01 A135\nRTS\n".to_vec());
    let setup = Setup { library: [("A.SUB".to_owned(), sub)].into(), ..Setup::default() };
    let program =
        |block: &str| format!("NA G81\nG00 X20 Z2\n{block}\nG80\nG00 X36 Z4\nG85 NA D8 F0.3\nM02\n");
    support::holds(&program("CALL O1"), "...\nalarm name=unspecified detail=RTS rules=E100L-ANG-06", &setup);
    support::holds(
        &program("G01 A135\nRTS"),
        "...\nalarm name=unspecified detail=RTS rules=E100L-LAP-04",
        &setup,
    );
}
