//! LAP: what calls and definitions may hold, at the edges of the tables of execution-lap.md, sections 3 and 5.

mod support;

use support::holds;
use turnspec_oracle::vocabulary::{Length, NoseRadius, Setup};

/// The program ends with these words of the compact notation.
fn ends_with(program: &str, wanted: &str) {
    support::ends_with(program, wanted, &Setup::default());
}

/// E100L-LAPC-02: DA or FA without XA and ZA, DB or FB without XB and ZB, or no point at all, are no fault: the call goes on
/// to its contour, which is empty.
#[test]
fn words_of_a_change_point_need_no_point() {
    for words in
        ["XB=20 DA=2", "XB=20 FA=0.2", "ZB=20 DA=2", "XA=20 DB=2", "XA=20 FB=0.2", "ZA=20 FB=0.2", ""]
    {
        let program = format!("N9 G81\nG80\nG85 N9 D1 F0.3 G84 {words}\nM02\n");
        ends_with(&program, "name=contour_malformed detail=empty line=2 rules=E100L-LAP-01");
    }
}

/// Section 3, check 5: G85 takes XA to FB with G84 alone, and no other address of several letters with it.
#[test]
fn change_points_have_no_function_without_g84() {
    for name in ["XA", "XB", "ZA", "ZB", "DA", "DB", "FA", "FB"] {
        let program = format!("N9 G81\nG80\nG85 N9 D1 F0.3 {name}=20\nM02\n");
        ends_with(&program, &format!("name=word_without_function detail={name} line=3 rules=E100L-ADDR-01"));
    }
    let program = "N9 G81\nG80\nG85 N9 D1 F0.3 G84 XA=20 SB=100\nM02\n";
    ends_with(program, "name=word_without_function detail=SB line=3 rules=E100L-LAP-17");
}

/// E100L-LAPC-04: equality is out of order too, in outside work and in inside work, where the points become larger.
#[test]
fn change_points_are_beyond_the_start_and_each_other() {
    let call = |contour: &str, start: &str, words: &str| {
        format!("NAT1 G81\nG00 X20 Z2\n{contour}\nG80\nG00 {start}\nG85 NAT1 D4 F0.3 G84 {words}\nM02\n")
    };
    let refused = |address: &str| format!("name=lap_data detail={address} line=7 rules=E100L-LAPC-04");
    for (words, address) in [("XA=36", "XA"), ("XA=37", "XA"), ("XA=28 XB=28", "XB"), ("XB=36", "XB")] {
        ends_with(&call("G01 Z-10\nX36", "X36 Z4", words), &refused(address));
    }
    for (words, address) in [("XA=12", "XA"), ("XA=11", "XA"), ("XA=16 XB=16", "XB")] {
        ends_with(&call("G01 Z-10\nX12", "X12 Z4", words), &refused(address));
    }
    // From Ø12 by 4 to Ø16, where A is reached, by 2 to Ø18 and Ø20, the start of the contour; Z on the line from (12, 4) to (20, 2).
    holds(
        &call("G01 Z-10\nX12", "X12 Z4", "XA=16 DA=2"),
        "rapid x=12 z=4\nrapid x=16 z=3 pass=1 part=infeed\n...\nrapid x=18 z=2.5 pass=2 part=infeed\n...
rapid x=20 z=2 pass=3 part=infeed\n...\nend code=M02",
        &Setup::default(),
    );
}

const THREAD: &str = "NAT4 G81\nG00 X20 Z5\nG34 Z-10 F1.5\nG80\n";

/// E100L-LAPC-07: in M73, in force at power-on, H less the allowance may be D but not less, U and W alike.
#[test]
fn a_thread_may_be_done_in_one_depth() {
    for words in ["D1 H1", "D1 H1.2 U0.2"] {
        ends_with(&format!("{THREAD}G00 X24 Z5\nG88 NAT4 {words}\nM02\n"), "end code=M02");
    }
    let face = "NAT4 G82\nG00 X40 Z0\nG34 X20 F2 M27\nG80\nG00 X40 Z3\nG88 NAT4 D1 H1.2 W0.2\nM02\n";
    ends_with(face, "end code=M02");
    for words in ["D1 H1.2 U0.201", "D1 H1.2 W0.201", "D1 H1.2 W0.3", "D1 H1.2 U0.3"] {
        let program = format!("N9 G81\nG80\nG88 N9 {words}\nM02\n");
        ends_with(&program, "name=lap_data detail=M73 line=3 rules=E100L-LAPC-07");
    }
}

/// E100L-AP3-02, E100L-TINF-03: depths 1, then H − U = 1.5, then H = 2 of the finishing pass, from Ø20 + H − d.
#[test]
fn the_allowance_of_a_thread_is_its_finishing_pass() {
    holds(
        &format!("{THREAD}G00 X24 Z5\nG88 NAT4 D1 H2 U0.5 M74\nM02\n"),
        "rapid x=24 z=5
aux code=M74
rapid x=21 z=5 pass=1 part=approach
thread x=21 z=-10 pass=1 part=cut
rapid x=24 z=-10 pass=1 part=retract
rapid x=24 z=5 pass=1 part=return
rapid x=20.5 z=5 pass=2 part=approach
...
rapid x=20 z=5 pass=3 part=approach
thread x=20 z=-10 pass=3 part=cut rules=E100L-G71-07
rapid x=24 z=-10 pass=3 part=retract
rapid x=24 z=5 pass=3 part=return
end code=M02",
        &Setup::default(),
    );
}

/// E100L-AP3-02: the first pass starts H − d = 1 beyond Ø20; S must lie beyond that, by however little.
#[test]
fn a_thread_is_cut_from_beyond_its_first_pass() {
    let program = |x: &str| format!("{THREAD}G00 X{x} Z5\nG88 NAT4 D1 H2 M74\nM02\n");
    holds(
        &program("21.001"),
        "rapid x=21.001\naux code=M74\nrapid x=21 z=5 pass=1 part=approach\n...\nend code=M02",
        &Setup::default(),
    );
    ends_with(&program("21"), "name=unspecified detail=side line=6 rules=E100L-AP3-02");
}

/// A program that reads a contour for G85 whose third line is this block.
fn contour(block: &str) -> String {
    format!("NAT1 G81\nG00 X20 Z2\n{block}\nG01 Z-10\nX36\nG80\nG00 X36 Z4\nG85 NAT1 D8 F0.3\nM02\n")
}

/// A program that reads a blank whose third line is this block.
fn blank(block: &str) -> String {
    let contour = "N5 G81\nG00 X20 Z2\nG01 Z-10\nX36\nG80\n";
    format!("NAT1 G83\nG01 X36 Z2\n{block}\nZ-10\n{contour}G00 X40 Z10\nG85 NAT1 D8 F0.3\nM02\n")
}

/// A program that reads a contour for G88 whose third line is this block.
fn thread(block: &str) -> String {
    format!("NAT4 G81\nG00 X20 Z5\n{block}\nG34 Z-10 F1.5\nG80\nG00 X24 Z5\nG88 NAT4 D1 H1 M74\nM02\n")
}

/// Section 5: the rows for G words.
#[test]
fn g_words_of_a_definition_are_those_of_its_kind() {
    for (block, code) in [("G81", "G81"), ("G82", "G82"), ("G83", "G83"), ("N7 G81 X20", "G81")] {
        ends_with(
            &contour(block),
            &format!("name=contour_malformed detail={code} line=3 rules=E100L-LAP-01"),
        );
    }
    ends_with(&blank("G83"), "name=contour_malformed detail=G83 line=3 rules=E100L-LAP-02");
    for (block, code) in [("G34 Z-5 F1", "G34"), ("G35 X24 F1", "G35"), ("G04 F1", "G04")] {
        ends_with(
            &contour(block),
            &format!("name=contour_malformed detail={code} line=3 rules=E100L-LAP-04"),
        );
    }
    for (block, code) in
        [("G75 X30 L1", "G75"), ("G76 X30 L1", "G76"), ("G34 Z-5 F1", "G34"), ("G04 F1", "G04")]
    {
        ends_with(&blank(block), &format!("name=contour_malformed detail={code} line=3 rules=E100L-LAP-03"));
    }
    for (block, code) in [
        ("G02 X24 Z3 I2", "G02"),
        ("G03 X24 Z3 K-2", "G03"),
        ("G40", "G40"),
        ("G42 G34 Z4 F1", "G42"),
        ("G75 X24 L1", "G75"),
        ("G76 X24 L1", "G76"),
    ] {
        ends_with(&thread(block), &format!("name=contour_malformed detail={code} line=3 rules=E100L-LAP-04"));
    }
}

/// Section 5: the row for M, T, SA, SB, W and QA.
#[test]
fn words_of_other_axes_and_spindles_have_no_place_in_a_contour() {
    for (words, detail) in
        [("W1", "W"), ("T010101", "T"), ("C1", "C"), ("SB=100", "SB"), ("SA=1", "SA"), ("QA=1", "QA")]
    {
        let block = format!("G01 Z-5 {words}");
        let expected = format!("name=contour_malformed detail={detail} line=3 rules=E100L-LAP-04");
        ends_with(&contour(&block), &expected);
        ends_with(&blank(&block), &expected);
    }
}

/// Section 5: an assignment to a system variable.
#[test]
fn a_contour_assigns_no_system_variables() {
    for (block, name) in [("VZSHZ=1", "VZSHZ"), ("G01 Z-5 VZSHZ=1", "VZSHZ"), ("VUACM[1]='A'", "VUACM")] {
        let expected = format!("name=unspecified detail={name} line=3 rules=E100L-LAP-04");
        ends_with(&contour(block), &expected);
        ends_with(&blank(block), &expected);
    }
    ends_with(&contour("V1=1 V2=2"), "end code=M02");
}

/// E100L-LAP-11: G91 needs X or Z in its block before the first motion alone. Increments count from the AP start (36, 4).
#[test]
fn g90_and_g91_stand_alone_behind_the_first_motion() {
    let program = |blocks: &str| format!("NAT1 G81\n{blocks}\nG80\nG00 X36 Z4\nG85 NAT1 D16 F0.3\nM02\n");
    for blocks in [
        "G91 G00 X-16 Z-2\nG01 Z-12\nX16",
        "G00 X20 Z2\nG91\nG01 Z-12\nX16",
        "G91 G00 X-16 Z-2\nG90\nG01 Z-10\nX36",
    ] {
        holds(
            &program(blocks),
            "rapid x=36 z=4\nrapid x=20 z=2 part=infeed\nlinear x=20 z=-10 part=contour\nlinear x=36 z=-10 part=contour
...\nend code=M02",
            &Setup::default(),
        );
    }
    ends_with(&program("G90\nG00 X20 Z2\nG01 Z-10\nX36"), "detail=G90 line=2 rules=E100L-LAP-11");
}

/// Section 5: in compensation the centre is that of the event less the way from tip to nose centre, here 0.8 in both axes.
/// The nose runs about (20, −10), as a radius, with 10 − 0.8, from (10.8, −10) to (20, −19.2); the tip 0.8 beside.
#[test]
fn the_tip_goes_round_its_own_centre() {
    let entry = NoseRadius { number: 1, x: Length(800_000), z: Length(800_000) };
    let setup = Setup { nose_radius: vec![entry], ..Setup::default() };
    let program = "NAT1 G81\nG00 X20 Z2\nG42 G01 Z0\nZ-10\nG02 X40 Z-20 I10\nG01 X50\nG80 G40 X60 I5
G00 X64 Z4 T010101\nG86 NAT1 D44 F0.3\nM02\n";
    holds(
        program,
        "...
linear x=20 z=-10.8 pass=1 part=contour
arc x=38.4 z=-20 cx=38.4 cz=-10.8 sense=cw pass=1 part=contour rules=E100L-LAP-16
...
end code=M02",
        &setup,
    );
}
