//! Mode V, along the moved blank to where it meets the contour (E100L-AP5-03, E100L-AP5-04; execution-lap.md, section 12):
//! the first common point, the half-line over the end of the contour, and the highest point of what was cut. K_j is the
//! blank moved by j·D, and a level of 2 in front of it. Values follow by hand.

mod support;

use turnspec_oracle::vocabulary::{Length, Setup};

/// Radii of an arc may differ by 1 mm (E100L-CIRC-11).
fn setup() -> Setup {
    let mut setup = Setup::default();
    setup.parameters.circular_radius_tolerance = Length(1_000_000);
    setup
}

fn holds(program: &str, expected: &str) {
    support::holds(program, expected, &setup());
}

/// A call from (120, 9) for a blank and a contour from (x, 0), written from their second block on.
fn program(x: &str, blank: &str, contour: &str, words: &str) -> String {
    format!(
        "N1 G83\nG01 {blank}N2 G81\nG00 X{x} Z0\nG01 {contour}G80\nG00 X120 Z9\nG86 N1 {words} F0.2\nM02\n"
    )
}

/// K1 passes over a hump of radius 10 about (32, −20): its top, Ø52, is the highest point, though both ends lie lower.
#[test]
fn the_top_of_an_arc_is_the_highest_point_of_its_pass() {
    holds(
        &program("20", "X40 Z0\nZ-10\nG03 X40 Z-30 K-10\nG01 Z-60\n", "Z-60\nX40\n", "D8"),
        "rapid x=120 z=9
rapid x=32 z=9 part=infeed
rapid x=32 z=2 part=infeed
linear x=32 z=0 part=cut
linear x=32 z=-10 part=cut
arc x=32 z=-30 sense=ccw cx=32 cz=-20 part=cut
linear x=32 z=-60 part=cut
rapid x=32.2 z=-59.9 part=relief
rapid x=52.2 z=-59.9 part=clear
rapid x=52.2 z=9 part=return
rapid x=24 z=9 pass=2 part=infeed
...",
    );
}

/// A wall at Z−14 meets the hump 6 before its top, 8 over its centre: Ø48, as high as the pass comes.
#[test]
fn a_top_that_is_not_reached_is_not_the_highest_point() {
    holds(
        &program("20", "X40 Z0\nZ-10\nG03 X40 Z-30 K-10\nG01 Z-60\n", "Z-14\nX60\nZ-60\n", "D8"),
        "...
linear x=32 z=-10 part=cut
arc x=48 z=-14 sense=ccw cx=32 cz=-20 part=cut
rapid x=48.2 z=-13.9 part=relief
rapid x=48.2 z=9 part=return
rapid x=24 z=9 pass=2 part=infeed
...",
    );
}

/// An arc of radius 10 about (24, −20) that begins 6 behind its centre, 8 over it, and ends 10 behind it. K1 is Ø32 in front
/// of it: that is the highest point, not the top of the circle, Ø36.
#[test]
fn a_top_before_the_beginning_of_an_arc_is_not_the_highest_point() {
    holds(
        &program("4", "X40 Z0\nZ-26\nG03 X24 Z-30 I-8 K6\nG01 Z-60\n", "Z-60\nX24\n", "D8"),
        "...
linear x=32 z=-26 part=cut
arc x=16 z=-30 sense=ccw cx=16 cz=-20 part=cut
linear x=16 z=-60 part=cut
rapid x=16.2 z=-59.9 part=relief
rapid x=32.2 z=-59.9 part=clear
rapid x=32.2 z=9 part=return
...",
    );
}

/// The arc ends under its centre's run, with 9.5 for a radius of 10. Its centre does not lie strictly between its ends, so
/// that it is one piece (section 8), whose highest point is its end: Ø71 of K1.
#[test]
fn an_arc_that_ends_over_its_centre_is_as_high_as_its_end() {
    holds(
        &program("20", "X60 Z0\nZ-20\nG03 X79 Z-30 K-10\nG01 Z-60\n", "Z-60\nX100\n", "D8"),
        "...
linear x=52 z=-20 part=cut
arc x=71 z=-30 sense=ccw cx=52 cz=-30 part=cut
linear x=71 z=-60 part=cut
rapid x=71.2 z=-59.9 part=relief
rapid x=71.2 z=9 part=return
...",
    );
}

/// Behind its collar K1 falls from Ø52 to Ø32, past the shoulder of the contour from Ø20 to Ø36: Ø36 comes first, as for
/// K2, that falls from Ø44 to Ø24.
#[test]
fn a_wall_that_falls_meets_the_top_of_a_shoulder() {
    holds(
        &program("20", "X60 Z0\nZ-30\nX40\nZ-60\n", "Z-30\nX36\nZ-60\n", "D8"),
        "...
linear x=52 z=-30 pass=1 part=cut
linear x=36 z=-30 pass=1 part=cut
rapid x=36.2 z=-29.9 pass=1 part=relief
rapid x=52.2 z=-29.9 pass=1 part=clear
rapid x=52.2 z=9 pass=1 part=return
rapid x=44 z=9 pass=2 part=infeed
rapid x=44 z=2 pass=2 part=infeed
linear x=44 z=0 pass=2 part=cut
linear x=44 z=-30 pass=2 part=cut
linear x=36 z=-30 pass=2 part=cut
rapid x=36.2 z=-29.9 pass=2 part=relief
...",
    );
}

/// The blank ends at Ø40, the contour at Ø32: the half-line over the end of the contour is met at Ø36, before K1 falls to
/// the end of the contour.
#[test]
fn a_blank_that_ends_in_a_wall_is_left_over_the_end_of_the_contour() {
    holds(
        &program("16", "X40 Z0\nZ-30\n", "Z-20\nX32\nZ-30\n", "D4"),
        "...
linear x=36 z=-30 pass=1 part=cut
rapid x=36.2 z=-29.9 pass=1 part=relief
rapid x=36.2 z=9 pass=1 part=return
...",
    );
}

/// W1: the rough contour ends at Z−29, the blank goes on to Z−30.
#[test]
fn a_blank_beyond_the_end_of_the_rough_contour_is_not_cut_there() {
    holds(
        &program("16", "X40 Z0\nZ-30\n", "Z-20\nX32\nZ-30\n", "D4 W1"),
        "...
linear x=36 z=-29 pass=1 part=cut
rapid x=36.2 z=-28.9 pass=1 part=relief
...",
    );
}

/// W as long as the clearance: the slope from (20, 2) to (40, −8) begins under B (36, 2), which is no point of it; it is met
/// at 16/20 of its way, Z−6.
#[test]
fn a_slope_that_begins_under_the_start_of_a_pass_is_not_met_there() {
    holds(
        &program("20", "X44 Z0\nZ-10\n", "X40 Z-10\nX44\n", "D8 W2"),
        "...
rapid x=36 z=9 pass=1 part=infeed
rapid x=36 z=2 pass=1 part=infeed
linear x=36 z=0 path=2 pass=1 part=cut
linear x=36 z=-6 path=6 pass=1 part=cut
rapid x=36.2 z=-5.9 pass=1 part=relief
...",
    );
}

/// The contour has a hill of radius 10 about (20, −30), the blank a valley of radius 10 about (68, −30), in K1 (60, −30):
/// they touch in (40, −30), which is a point of both.
#[test]
fn circles_that_touch_meet() {
    holds(
        &program(
            "20",
            "X68 Z0\nZ-20\nG02 X68 Z-40 K-10\nG01 Z-60\n",
            "Z-20\nG03 X20 Z-40 K-10\nG01 Z-60\nX68\n",
            "D8",
        ),
        "...
linear x=60 z=-20 pass=1 part=cut
arc x=40 z=-30 sense=cw cx=60 cz=-30 pass=1 part=cut
rapid x=40.2 z=-29.9 pass=1 part=relief
rapid x=60.2 z=-29.9 pass=1 part=clear
...",
    );
}

/// An arc is the part of its circle, and then its end: of K1 these are Ø72 and Ø74 at Z−30, where the contour rises to Ø100.
#[test]
fn a_circle_meets_the_contour_before_the_end_beside_it() {
    holds(
        &program("20", "X60 Z0\nZ-20\nG03 X82 Z-30 K-10\nG01 Z-60\n", "Z-30\nX100\nZ-60\n", "D8"),
        "...
linear x=52 z=-20 pass=1 part=cut
arc x=72 z=-30 sense=ccw cx=52 cz=-30 pass=1 part=cut
rapid x=72.2 z=-29.9 pass=1 part=relief
...",
    );
}

/// The same over the end of the contour, (30, −30): the circle is on the half-line that rises from it before the end is.
#[test]
fn a_circle_meets_the_half_line_before_the_end_beside_it() {
    holds(
        &program("20", "X60 Z0\nZ-20\nG03 X82 Z-30 K-10\n", "Z-30\nX30\n", "D8"),
        "...
linear x=52 z=-20 pass=1 part=cut
arc x=72 z=-30 sense=ccw cx=52 cz=-30 pass=1 part=cut
rapid x=72.2 z=-29.9 pass=1 part=relief
...",
    );
}

/// At Z−30 an arc of the blank ends beside its circle, and the next one, of radius 10, begins over its centre: in K1 from
/// Ø72 to Ø74. The contour, at Ø73, is not below all of that, and is below K1 at once behind it. It is left there, and met
/// where the second arc is 9.5 over its centre, √9.75 behind it. That cut is one piece (section 8), as high as its ends, so
/// that the relief has lifted the tool far enough.
#[test]
fn a_cut_that_begins_over_its_centre_is_as_high_as_its_ends() {
    holds(
        &program(
            "20",
            "X60 Z0\nZ-20\nG03 X82 Z-30 K-10\nX62 Z-40 I-10 K0\nG01 Z-60\n",
            "Z-25\nX73\nZ-60\n",
            "D8",
        ),
        "...
linear x=73 z=-25 pass=5 part=contour
linear x=73 z=-30 pass=5 part=contour
arc x=73 z=-33.122499 sense=ccw cx=54 cz=-30 pass=5 part=cut
rapid x=73.2 z=-33.022499 pass=5 part=relief
rapid x=73.2 z=-30 pass=5 part=return
linear x=73 z=-30 pass=5 part=return
linear x=73 z=-60 pass=5 part=contour
rapid x=73.1 z=-59.9 pass=5 part=relief
rapid x=120 z=9 part=home
end",
    );
}

/// The last element of this contour is an arc whose circle comes to Ø40 at Z−30, and whose end is Ø42. Between them K1, at
/// Ø41, meets neither contour nor half-line: it is cut to its last point with no more run than the end (section 12).
fn over_a_loose_end(blank: &str) -> String {
    program("20", &format!("X45 Z0\n{blank}"), "Z-20\nG03 X42 Z-30 K-10\n", "D4")
}

#[test]
fn a_blank_that_does_not_meet_the_contour_is_cut_to_its_end() {
    let end = "...\nlinear x=41 z=0 pass=1 part=cut\nlinear x=41 z=-30 pass=1 part=cut\n\
               rapid x=41.2 z=-29.9 pass=1 part=relief\nrapid x=41.2 z=9 pass=1 part=return\n...";
    holds(&over_a_loose_end("Z-40\n"), end);
    holds(&over_a_loose_end("Z-30\nX55 Z-40\n"), end);
}

/// At Z−30 K1 rises from Ø41, to Ø46: it meets the end of the contour, Ø42; or to Ø41.5: that is its last point.
#[test]
fn a_wall_over_the_end_of_the_contour_is_cut_as_far_as_it_meets_it() {
    for (height, end) in [("50", "42"), ("45.5", "41.5")] {
        let expected = format!(
            "...\nlinear x=41 z=-30 pass=1 part=cut\nlinear x={end} z=-30 pass=1 part=cut\n\
             rapid z=-29.9 pass=1 part=relief\nrapid z=9 pass=1 part=return\n..."
        );
        holds(&over_a_loose_end(&format!("Z-30\nX{height}\nZ-40\n")), &expected);
    }
}
