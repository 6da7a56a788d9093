//! Contours with the C axis and coordinate conversion at their edges: points that rounding would bring together, arcs at
//! exactly 0.001 mm from the centre, what counts the turns of C anew. All values follow by hand from the rule texts.

mod support;

use support::{ends_with, holds};
use turnspec_oracle::vocabulary::Setup;

/// CGF-06: the sides are decided by the angles, not by the rounded points. X0.002 is (0.001, 0) at C0 and, latched, at C0.001
/// too (0.001·sin 0.001° is 0.00000002): d = 0.001 is no 0 (CGF-09), C turns by it.
#[test]
fn two_angles_of_one_rounded_point_are_two_rays() {
    holds(
        "M110\nG94 G00 X0.002 C0 F100\nG101 C0.001\nC0\nM02\n",
        "...
linear x=0.002 c=0.001 c_travel=0.001 px=0.001 py=0 path=0 rules=E100L-CGF-02+E100L-CGF-06
linear x=0.002 c=0 c_travel=-0.001 px=0.001 py=0 path=0
...
end code=M02",
        &Setup::default(),
    );
}

/// CGF-09: along a ray the path is |ΔX|/2, 6 mm from X12 to X24. The latched points at C40 are (4.596267, 3.856726) and
/// (9.192533, 7.713451); they are only √(4.596266² + 3.856725²) = 5.99999907 apart, latched 5.999999.
#[test]
fn the_length_along_a_ray_is_that_of_x() {
    holds(
        "M110\nG94 G00 X12 C40 F100\nG101 X24\nM02\n",
        "...\nlinear x=24 c=40 c_travel=0 path=6 rules=E100L-CGF-09\n...\nend code=M02",
        &Setup::default(),
    );
}

/// CGF-04: an arc that passes the centre of the face at less than 0.001 mm is refused. The chord from (a, −4) to (a, 4) with
/// L5 has h = 3, clockwise M = (a + 3, 0), and the arc passes p = a + 3 − 5: at 2.001 the centre is beyond the arc, and C
/// turns as the chord does, by 2·63.423491 (atan2(4, 2.001)); at 1.999 it is between them, and C turns by 360 − 2·63.446409 the
/// other way.
#[test]
fn an_arc_at_exactly_a_thousandth_from_the_centre_is_cut() {
    for (a, expected) in [
        ("2.001", "px=2.001 py=4 sense=cw pcx=5.001 pcy=0 c_travel=126.846982"),
        ("1.999", "px=1.999 py=4 sense=cw pcx=4.999 pcy=0 c_travel=-233.107182"),
    ] {
        let program = format!("M110\nG94 G137 C0 F100\nG00 X{a} Y-4\nG102 Y4 L5\nM02\n");
        holds(&program, &format!("...\ncontour_arc {expected}\n...\nend code=M02"), &Setup::default());
    }
    let between = "M110\nG94 G137 C0 F100\nG00 X2 Y-4\nG102 Y4 L5\nM02\n";
    ends_with(between, "name=unspecified detail=centre line=4 rules=E100L-CGF-04", &Setup::default());
}

/// The same with L0.001 about the centre of the face itself: half a circle from (0.001, 0) to (−0.001, 0), q = 2·L, M = (0, 0),
/// and the arc is 0.001 from it all the way.
#[test]
fn a_circle_of_a_thousandth_about_the_centre_is_cut() {
    holds(
        "M110\nG94 G00 X0.002 C0 F100\nG103 C180 L0.001\nM02\n",
        "...\ncontour_arc x=0.002 c=180 c_travel=180 sense=ccw px=-0.001 py=0 pcx=0 pcy=0\n...\nend code=M02",
        &Setup::default(),
    );
}

/// CSC-07, ABS-02: in G91 X and Y are travels in the plane, Z and W travels as ever: 5 − 2 = 3, 7 + 4 = 11.
#[test]
fn other_axes_travel_with_a_point_in_increments() {
    let mut setup = Setup::default();
    setup.options.w_axis = true;
    holds(
        "M110\nG137 C0\nG00 X30 Y40 Z5 W7\nG91 Y-80 Z-2 W4\nM02\n",
        "...
rapid x=100 z=5 w=7 px=30 py=40
mode code=G91
rapid x=100 z=3 w=11 px=30 py=-40 rules=E100L-CSC-07+E100L-ABS-02
...
end code=M02",
        &setup,
    );
}

/// 5965 turns, and a degree more: an arc on the side by 59 degrees is beyond (CGS-06).
fn wound(before: &str, behind: &str) -> String {
    format!(
        "M110\n{before}G94 G00 X100 Z50 QA=1999 F100\nQA=1999\nQA=1967\nC1\n{behind}G132 Z20 C60 L60\nM02\n"
    )
}

/// CGS-06: the turns are counted from M110, or from a G119 when the mode of CGS-07 is valid: from no other code, and from no
/// G119 when it is not.
#[test]
fn what_counts_the_turns_anew() {
    let plain = Setup::default();
    let mut with_mode = Setup::default();
    with_mode.parameters.side_contour_mode = true;
    let beyond = "name=profile_generation number=2480 rules=E100L-CGS-06";
    for behind in ["", "G119\n", "G90\n", "M16\nM15\n", "M146\n"] {
        ends_with(&wound("", behind), beyond, &plain);
    }
    for behind in ["", "G90\n", "G01\n", "M16\nM15\n", "G04 F1\n"] {
        ends_with(&wound("G119\n", behind), beyond, &with_mode);
    }
    ends_with(&wound("", "G119\n"), "end code=M02", &with_mode);
    ends_with(&wound("G119\n", "G18\nG119\n"), "end code=M02", &with_mode);
    for setup in [&plain, &with_mode] {
        ends_with(&wound("", "M109\nM110\nG119\nC0\n"), "end code=M02", setup);
    }
    ends_with(&wound("", "M109\nM110\nC0\n"), "end code=M02", &plain);
}

/// CRC-06, check 6: a block that begins or ends compensation of turning in G101 is refused although it has no motion; one
/// with the word G101 alone, which does neither and is no contour block, is not.
#[test]
fn the_mode_of_lines_and_compensation_of_turning() {
    let setup = Setup::default();
    let refused = "name=unspecified detail=G101 rules=E100L-CRC-06";
    ends_with("M110\nG94 F100\nG101 G42\nM02\n", refused, &setup);
    ends_with("M110\nG94 F100\nG101\nG41\nM02\n", refused, &setup);
    let turning = "M110\nG94 F100\nG42 G01 X100 Z100\nZ50\n";
    ends_with(&format!("{turning}G101 G40\nM02\n"), refused, &setup);
    holds(
        &format!("{turning}G101\nG01 Z40\nM02\n"),
        "...\nmode code=G101\n...\nmode code=G01\nlinear x=100 z=40\n...\nend code=M02",
        &setup,
    );
}

/// CGF-04, CRC-14: with a cutter of no radius its centre is P. (25, 11) is X 2·√746 = 54.626001 (CSC-03) and C23.749494;
/// 54.626 less is X0.000001, the point (0, 0), latched (0.0000005·cos C is 0.00000046): an arc from there passes the centre of
/// the face, with which C has no direction.
#[test]
fn an_arc_of_a_cutter_from_the_rounded_centre_is_refused() {
    let setup = Setup::default();
    let start_up = "M110\nG94 F100\nG137 C0\nG00 X25 Y11\nG136\nG17\nG91 G41 G101 X-54.626\n";
    ends_with(
        &format!("{start_up}G90 G102 X20 L10\nM02\n"),
        "name=unspecified detail=centre line=8 rules=E100L-CGF-04",
        &setup,
    );
    // A line from there is one from the centre (CGF-10).
    holds(
        &format!("{start_up}G90 G101 X20\nM02\n"),
        "...\nlinear x=0.000001 c=23.749494 px=0 py=0 qx=0 qy=0\nmode code=G90\nlinear x=20 c=23.749494 c_travel=0 part=-\n...\nend code=M02",
        &setup,
    );
}
