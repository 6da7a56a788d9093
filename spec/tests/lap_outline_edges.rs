//! LAP: outlines of contours and blanks at their edges: directions, pieces of arcs, descents, and where a blank is above a
//! level (execution-lap.md, sections 8, 11 and 12). A height is half of X, a run grows toward −Z.

mod support;

use turnspec_oracle::vocabulary::Setup;

fn holds(program: &str, expected: &str) {
    support::holds(program, expected, &Setup::default());
}

/// The program ends with these words of the compact notation.
fn ends_with(program: &str, wanted: &str) {
    support::ends_with(program, wanted, &Setup::default());
}

/// A call behind a definition, from this AP start.
fn cycle(definition: &str, start: &str, call: &str) -> String {
    format!("{definition}\nG80\nG00 {start}\n{call} F0.3\nM02\n")
}

/// Section 8, "Direction": an arc has more run at its end, and both ends on its side of the centre. About (40, 0), radius 5,
/// over the centre: the end is below it, goes back, lies 0.002 over the start (CIRC-11), the start is below it; the last is well.
#[test]
fn an_arc_runs_onward_on_one_side_of_its_centre() {
    let program = |x: &str, z: &str, arc: &str| {
        let contour = format!("N1 G81\nG00 X40 Z9\nG01 X{x} Z{z}\n{arc}\nG01 Z-30\nX60");
        cycle(&contour, "X70 Z9", "G85 N1 D60")
    };
    let refused = "name=unspecified detail=direction rules=E100L-AP1-02";
    ends_with(&program("50", "0", "G03 X34 Z-4 I-5"), refused);
    ends_with(&program("46", "-4", "G03 X46 Z4 I-3 K4"), refused);
    ends_with(&program("50", "0", "G03 X50.002 Z0 I-5"), refused);
    ends_with(&program("34", "4", "G03 X50 Z0 I3 K-4"), refused);
    ends_with(&program("46", "4", "G03 X46 Z-4 I-3 K-4"), "end code=M02");
}

/// Section 8, "Pieces": an arc whose end lies before its centre is one piece, from Ø20 up to Ø36: Ø38, beyond it, meets
/// the wall at Z-30 first. Its circle would reach Ø40.
#[test]
fn an_arc_that_ends_before_its_top_does_not_reach_it() {
    holds(
        &cycle("N1 G81\nG00 X20 Z2\nG01 Z-10\nG03 X36 Z-14 K-10\nG01 Z-30\nX50", "X50 Z2", "G85 N1 D12"),
        "rapid x=50 z=2
rapid x=38 z=2 pass=1 part=infeed
linear x=38 z=-30 pass=1 part=cut
linear x=50 z=-30 pass=1 part=contour
...
end code=M02",
    );
}

/// The same of an arc that ends at the run of its centre, 0.01 below its circle (E100L-CIRC-11): the piece ends in its end,
/// at 19.99, and the level at 19.995 does not meet it.
#[test]
fn an_arc_that_ends_below_its_top_is_one_piece() {
    holds(
        &cycle(
            "N1 G81\nG00 X20 Z2\nG01 Z-10\nG03 X39.98 Z-20 K-10\nG01 Z-30\nX60",
            "X60 Z2",
            "G85 N1 D20.01",
        ),
        "rapid x=60 z=2
rapid x=39.99 z=2 pass=1 part=infeed
linear x=39.99 z=-30 pass=1 part=cut
linear x=60 z=-30 pass=1 part=contour
...
end code=M02",
    );
}

/// Half a circle under its centre (40, −25), radius 5, is a recess: Ø34 is 3 below the centre, 4 to both sides of it. Its two
/// pieces are one motion of the pass in it.
#[test]
fn half_a_circle_under_its_centre_is_a_recess() {
    holds(
        &cycle(
            "N1 G81\nG00 X20 Z2\nG01 Z-10\nX40\nZ-20\nG02 X40 Z-30 K-5\nG01 Z-40\nX60",
            "X60 Z2",
            "G85 N1 D26",
        ),
        "rapid x=60 z=2
rapid x=34 z=2 pass=1 part=infeed
linear x=34 z=-10 pass=1 part=cut
linear x=40 z=-10 pass=1 part=contour
linear x=40 z=-20 pass=1 part=contour
arc x=34 z=-21 cx=40 cz=-25 sense=cw pass=1 part=contour rules=E100L-AP1-10
linear x=34 z=-29 pass=1 part=cut rules=E100L-AP1-10
arc x=40 z=-30 cx=40 cz=-25 sense=cw pass=1 part=contour
linear x=40 z=-40 pass=1 part=contour
linear x=60 z=-40 pass=1 part=contour
rapid x=60.1 z=-39.9 pass=1 part=relief
rapid x=60.1 z=-21 pass=1 part=return
rapid x=34 z=-21 pass=1 part=return
arc x=34 z=-29 cx=40 cz=-25 sense=cw pass=2 part=contour rules=E100L-AP1-11
rapid x=34.2 z=-28.9 pass=2 part=relief rules=E100L-AP1-12
...
end code=M02",
    );
}

/// With G82 the sense is kept when γ·σ = −1, here from Z10 down to Z0 and toward −X: G02 runs over its centre (20, 0), a
/// diameter, from 5 in front of it. Z3 is 4 in front of it: Ø28. The line from (44, 10) to (40, 0) has Ø41.2 there.
#[test]
fn an_arc_of_a_face_is_met_on_its_side() {
    holds(
        &cycle("N1 G82\nG00 X40 Z0\nG01 X30\nG02 X20 Z5 I-5\nG01 Z10", "X44 Z10", "G85 N1 D7"),
        "rapid x=44 z=10
rapid x=41.2 z=3 pass=1 part=infeed
linear x=28 z=3 pass=1 part=cut
arc x=20 z=5 cx=20 cz=0 sense=cw pass=1 part=contour
linear x=20 z=10 pass=1 part=contour
rapid x=20.1 z=10.1 pass=1 part=relief rules=E100L-AP1-14
...
arc x=28 z=3 cx=20 cz=0 sense=cw pass=2 part=contour
...
end code=M02",
    );
}

/// E100L-AP1-13: a slope is an unbroken sequence of falling elements, level ones in between not counted: ten of these are
/// ten, eleven too many.
#[test]
fn a_descent_ends_where_the_contour_rises() {
    for slope in [
        "X-2 Z-1\nX2 Z-1\n",
        "X-1 Z-1\nX-1 Z-2\nX2 Z-1\n",
        "X-1 Z-1\nZ-1\nX-1 Z-1\nX2 Z-1\n",
        "Z-1\nX-2 Z-1\nZ-1\nX2 Z-1\n",
        "X-2 Z-1\nX1 Z-1\nZ-1\nX1 Z-1\n",
    ] {
        let program = |count: usize| {
            let contour = format!("N1 G81\nG00 X20 Z2\nG01 G91 X4 Z-2\n{}X12", slope.repeat(count));
            cycle(&contour, "G90 X60 Z4", "G85 N1 D40")
        };
        ends_with(&program(10), "end code=M02");
        ends_with(&program(11), "name=descending_slopes rules=E100L-AP1-13");
    }
}

/// E100L-LAP-02: the arc ends in the end of the contour, and the line that would be added has no travel. About (36, 25),
/// radius 5, under it: Ø28 is 4 below and meets the stock 3 behind, at Z22; infeed 2 in front (E100L-AP4-02).
#[test]
fn a_blank_may_end_in_an_arc() {
    holds(
        &cycle(
            "N1 G83\nG01 X20 Z50\nX26\nZ25\nG02 X36 Z20 I5\nG81\nG00 X20 Z50\nG01 Z20\nX36",
            "X50 Z60",
            "G85 N1 D8",
        ),
        "rapid x=50 z=60
rapid x=28 z=24 pass=1 part=infeed
linear x=28 z=20 pass=1 part=cut
linear x=36 z=20 pass=1 part=contour
...
end code=M02",
    );
}

/// E100L-AP4-02: the blank rises from Ø16 at Z50 to Ø36 at Z40, through Ø28 at Z44 and Ø20 at Z48; infeed 2 in front.
#[test]
fn stock_begins_where_the_blank_rises_above_the_level() {
    holds(
        &cycle("N1 G83\nG01 X16 Z50\nX36 Z40\nZ20\nG81\nG00 X16 Z50\nG01 Z20\nX36", "X50 Z60", "G85 N1 D8"),
        "rapid x=50 z=60
rapid x=28 z=46 pass=1 part=infeed
linear x=28 z=20 pass=1 part=cut
linear x=36 z=20 pass=1 part=contour
rapid x=36.1 z=20.1 pass=1 part=relief
rapid x=36.1 z=50 pass=1 part=return
rapid x=20 z=50 pass=2 part=infeed
linear x=20 z=20 pass=2 part=cut
...
end code=M02",
    );
}

/// E100L-AP4-05: over a recess at Ø20 the blank is above the level from its start, Ø24, to Z30, where it falls through it;
/// behind Z30 it lies below, up to the end. Fed 2 further, and over the last 2.
#[test]
fn stock_begins_with_a_blank_that_starts_above_the_level() {
    holds(
        &cycle(
            "N1 G83\nG01 X24 Z50\nX18 Z20\nZ10\nG81\nG00 X24 Z50\nG01 X10\nZ10\nX24",
            "X40 Z60",
            "G85 N1 D4",
        ),
        "rapid x=40 z=60
rapid x=24 z=52 pass=1 part=infeed
linear x=24 z=50 pass=1 part=infeed
linear x=20 z=50 pass=1 part=contour
linear x=20 z=28 pass=1 part=cut rules=E100L-AP1-10+E100L-AP4-05
rapid x=20 z=12 pass=1 part=air
linear x=20 z=10 pass=1 part=cut
linear x=24 z=10 pass=1 part=contour
...
end code=M02",
    );
}

/// E100L-AP4-05: where the level runs in the top of the blank there is nothing to cut, its start (20, 50) included. W1 has
/// moved the contour to Z51 and Z11.
#[test]
fn a_blank_that_starts_in_the_level_is_no_stock() {
    holds(
        &cycle("N1 G83\nG01 X20 Z50\nZ10\nG81\nG00 X20 Z50\nG01 X10\nZ10\nX28", "X40 Z60", "G85 N1 D8 W1"),
        "rapid x=40 z=60
rapid x=20 z=53 pass=1 part=infeed
linear x=20 z=51 pass=1 part=infeed
linear x=20 z=49 pass=1 part=cut
rapid x=20 z=13 pass=1 part=air
linear x=20 z=11 pass=1 part=cut
linear x=28 z=11 pass=1 part=contour
...
end code=M02",
    );
}

/// Section 12, "below": at a run less than that of A, Z50, the height of the moved blank there counts, and that is the lowest:
/// its wall falls from Ø30 to Ø20, where an arc about (12, 47) with radius 5 begins. K1 is left at Ø12, no K at another height
/// of the wall of the contour, which W1 has moved to Z51.
#[test]
fn in_front_of_the_blank_its_lowest_height_counts() {
    holds(
        &cycle(
            "N1 G83\nG01 X20 Z50\nG03 X22 Z47 I-4 K-3\nG01 Z10\nG81\nG00 X30 Z50\nG01 X8\nZ10\nX30",
            "X40 Z60",
            "G86 N1 D8 W1",
        ),
        "rapid x=40 z=60
rapid x=30 z=60 pass=1 part=infeed
rapid x=30 z=51 pass=1 part=infeed
linear x=12 z=51 pass=1 part=contour
...
linear x=12 z=51 pass=1 part=return rules=E100L-AP5-06
linear x=8 z=51 pass=1 part=contour
...
end code=M02",
    );
}
