//! Modal codes, feeds and limits at their edges. All values follow by hand from the rules named.

mod support;

use support::{cites, has_words};
use turnspec_oracle::vocabulary::Event;
use turnspec_oracle::vocabulary::notation::render;

fn trace(program: &str, setup: &str) -> Vec<Event> {
    support::trace(program, &support::set_up(setup))
}

fn holds(program: &str, setup: &str, expected: &str) {
    support::holds(program, expected, &support::set_up(setup));
}

/// Of the events with all these words of the compact notation, those that cite a rule, and all.
fn citing(program: &str, setup: &str, words: &str, rule: &str) -> (usize, usize) {
    let all = trace(program, setup);
    let meant: Vec<&Event> = all.iter().filter(|event| has_words(&render(event), words)).collect();
    (meant.iter().filter(|event| cites(event, rule)).count(), meant.len())
}

/// AX4-06: the common words of two blocks are carried out once, and these events cite it (execution-turrets.md: `spindle` of
/// main and `mode` of G96, G97, G110, G111 carried out once for two blocks). G01 and M08 are no common words: each saddle has
/// its own. Where there is one saddle nothing is carried out for two.
#[test]
fn only_common_commands_of_two_saddles_cite_that_they_agree() {
    let block = "G96 G01 S100 M08 M03";
    let two = format!("G13\nG00 X100\n{block} P10\nX80 F0.2\nG14\nG00 X50\n{block} P10\nX40 F0.2\nM02\n");
    let saddles = "[machine]\ntype = \"2S\"\n";
    let one = format!("G00 X100\n{block}\nX80 F0.2\nM02\n");
    for (words, of_two, of_one) in [
        ("mode code=G96", (1, 1), (0, 1)),
        ("mode code=G01", (0, 2), (0, 1)),
        ("coolant", (0, 2), (0, 1)),
        ("spindle state=cw", (1, 1), (0, 1)),
    ] {
        assert_eq!(citing(&two, saddles, words, "E100L-AX4-06"), of_two, "{words}");
        assert_eq!(citing(&one, "", words, "E100L-AX4-06"), of_one, "{words}");
    }
}

/// THRD-01: "A block with one of these codes, or that cuts a thread in a mode selected before": G50 has no such code and cuts
/// nothing, so that it goes in a thread mode and G96; the next pass does not.
#[test]
fn a_shift_in_a_thread_mode_and_constant_cutting_speed_cuts_no_thread() {
    holds(
        "G00 X40 Z80\nG33 X29 Z50 F1.5\nG96 S100\nG50 X50\nX28\nM02\n",
        "",
        "...
mode code=G96
spindle state=stop
frame cause=zero_shift x=-10 line=4
alarm name=thread_in_constant_speed detail=G33 line=5 rules=E100L-THRD-01",
    );
}

/// execution-contour.md, check 6: CRC-06 is about a motion block. G02 alone moves nothing, and G01 follows; with a target it
/// is refused.
#[test]
fn a_code_without_motion_does_not_move_in_the_plane_of_the_cutter() {
    let cutter = "[[nose_radius]]\nnumber = 1\nx = 5\nz = 0\n";
    let program = |block: &str| {
        format!("M110\nG94 G00 X100 C0 F100 T010101\nG17\nG42 G01 X80\n{block}\nG01 C90\nM02\n")
    };
    // X = 2·√(40² + 5²), C = atan(5/40), as in cutter_edges.rs.
    holds(
        &program("G02"),
        cutter,
        "...
linear x=80 c=0 tx=87.357718 tc=4.642819 line=4
mode code=G02 previous=G01 line=5
mode code=G01 previous=G02 line=6
linear x=80 c=90 line=6
...
end code=M02",
    );
    holds(
        &program("G02 X70 Z5 L50"),
        cutter,
        "...\nalarm name=unspecified detail=G02 line=5 rules=E100L-CRC-06",
    );
}

/// ADDR-01, DEC-01: F of G94 is 0.1 mm/min in the 1 µm system, 1 mm/min in the 10 µm one, and at most 99999.999 mm/min; as a
/// feed per revolution the same numbers would be 1000 mm, 0.5 µm and 1000 mm.
#[test]
fn the_range_of_a_feed_is_that_of_its_mode() {
    let program = |feed: &str| format!("G94 G01 X10 F{feed}\nM02\n");
    for (system, feed, shown) in [("1um", "999999", "99999.9mm/min"), ("10um", "0.05", "0.05mm/min")] {
        let setup = format!("unit_system = \"{system}\"\n");
        holds(&program(feed), &setup, &format!("...\nlinear f={shown}\n...\nend code=M02"));
    }
    for (system, feed) in [("1um", "1000000"), ("10um", "100000")] {
        let setup = format!("unit_system = \"{system}\"\n");
        holds(&program(feed), &setup, "...\nalarm name=address_range line=1 rules=E100L-ADDR-01");
    }
    // THRD-04: F of a thread is a lead in G94 too, 0.5 µm, less than the least feed per revolution.
    holds(
        "G94 G00 X4000 Z8000\nG34 Z5000 F0.05\nM02\n",
        "unit_system = \"10um\"\n",
        "...\nalarm name=address_range line=2 rules=E100L-ADDR-01",
    );
}

/// MCODE-22: M85 alone is an auxiliary event; LAPC-08 is about the block of a call.
#[test]
fn m85_alone_is_no_matter_of_lap() {
    assert_eq!(citing("M85\nM02\n", "", "aux code=M85", "E100L-MCODE-22"), (1, 1));
    assert_eq!(citing("M85\nM02\n", "", "aux code=M85", "E100L-LAPC-08"), (0, 1));
}

/// execution.md, chapter 3: W is a coordinate with `options.w_axis`; otherwise an amount, not below 0. The range comes before
/// the axis that is missing (AXIS-01).
#[test]
fn w_without_its_axis_is_an_amount() {
    let alarm = |name: &str, rule: &str| format!("alarm name={name} line=1 rules={rule}");
    holds("G00 W-1\nM02\n", "", &alarm("address_range", "E100L-ADDR-01"));
    holds("G00 W1\nM02\n", "", &alarm("axis_missing", "E100L-AXIS-01"));
    holds("G00 W-1\nM02\n", "[options]\nw_axis = true\n", "rapid w=-1\nend code=M02");
}

/// LIM-01 and LIM-02 are tested on the axes that have a word, W among them: the limit takes the place of the coordinate; below
/// the negative one there is no motion.
#[test]
fn limits_of_w() {
    let setup = "[options]\nw_axis = true\n[limits.w]\npositive = 10\nnegative = -5\n";
    holds(
        "G00 W20\nG01 W9 F0.2\nW11\nG00 W-6\nM02\n",
        setup,
        "rapid w=10 mw=10 rules=E100L-LIM-01
mode code=G01
linear w=9 path=1
linear w=10 path=1 rules=E100L-LIM-01
mode code=G00
alarm name=travel_limit_negative line=4 rules=E100L-LIM-02",
    );
    assert_eq!(citing("G00 W9\nM02\n", setup, "rapid w=9", "E100L-LIM-01"), (0, 1));
}

/// FUNC-02: SIN takes any number of degrees; −930 = 150 − 3·360, and so on over some turns in either direction.
#[test]
fn angles_of_many_turns_have_their_functions() {
    for (expression, value) in [
        ("SIN[-930]", "0.5"),
        ("SIN[-1020]", "0.866025403784438"),
        ("COS[-840]", "-0.5"),
        ("COS[-960]", "-0.5"),
        ("TAN[-945]", "-1"),
        ("SIN[930]", "-0.5"),
    ] {
        let all = trace(&format!("V1={expression}\nM02\n"), "");
        let event = all.first().map(render).unwrap_or_default();
        assert!(event.contains(&format!("value={value}")), "{expression}: {event}");
    }
}

/// NRC-71: what is left over goes away with the next block of X or Z, both axes go to P. G41 along −X leaves the tip 1.6 (a
/// diameter) short in X: N4 feeds from (58.4, 100) to (60, 90), path √(0.8² + 10²) = 10.031949.
#[test]
fn the_feed_counts_what_compensation_has_left_over_in_x() {
    holds(
        "G41 G01 X100 Z100 F0.2 T010101\nX60\nG40\nZ90\nM02\n",
        "[[nose_radius]]\nnumber = 1\nx = 0.8\nz = 0.8\n",
        "...
linear x=60 z=100 tx=58.4 tz=100 line=2
mode code=G40
linear x=60 z=90 mx=60 mz=90 path=10.031949 line=4 rules=E100L-NRC-71
...
end code=M02",
    );
}

/// CHAM-13: "torque skips count from the present point", and the corner C = (120, 80) is forgotten after a block that moves X
/// or Z, not after one that moves W. G22 leads Z from D, 75, toward 65 and stops at 65.5: Z-20 ends at 45.5. Behind G22 of W it
/// ends at 80 − 20.
#[test]
fn a_torque_skip_of_z_forgets_the_corner_before_it() {
    let program = |skip: &str| format!("G01 X100 Z80 F0.2\nG91 G75 X20 L-5\n{skip}\nZ-20\nM02\n");
    let setup = |stop: &str| {
        format!(
            "[parameters]\nchamfering = \"basic\"\n[options]\nw_axis = true\n[inputs]\ntorque_stops = [{stop}]\n"
        )
    };
    let of_z = program("G22 Z-10 PZ=50 D2 L1");
    holds(&of_z, &setup("65.5"), "...\nlinear z=65.5 line=3\nlinear x=120 z=45.5 line=4\n...\nend code=M02");
    assert_eq!(citing(&of_z, &setup("65.5"), "linear line=4", "E100L-CHAM-13"), (0, 1));
    let of_w = program("G22 W-10 PW=50 D2 L1");
    holds(
        &of_w,
        &setup("-9.5"),
        "...\nlinear w=-9.5 line=3\nlinear x=120 z=60 line=4 rules=E100L-CHAM-13\n...\nend code=M02",
    );
}

/// E100L-ADDR-01: a word that no function of its block takes is refused with its address, the first in written order. G04 takes
/// its time alone (G04-01), G28 nothing; without a code of the motion group (CSC-05) no word has a function.
#[test]
fn a_word_without_function_is_refused_with_its_address() {
    for (program, detail, line) in [
        ("G04 F2 X10\nM02\n", "X", 1),
        ("G04 F2 L10\nM02\n", "L", 1),
        ("G28 A10\nM02\n", "A", 1),
        ("M110\nG137 C0\nI5\nM02\n", "I", 3),
        ("M110\nG137 C0\nL5 K2\nM02\n", "L", 3),
        ("M110\nG137 C0\nCALRG\nM02\n", "CALRG", 3),
    ] {
        let expected =
            format!("...\nalarm name=word_without_function detail={detail} line={line} rules=E100L-ADDR-01");
        holds(program, "", &expected);
    }
}
