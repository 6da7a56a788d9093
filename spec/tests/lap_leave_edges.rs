//! Mode V, where the contour falls below the blank moved by a multiple of D, and the tool leaves it (E100L-AP5-05,
//! E100L-AP5-06; execution-lap.md, section 12). The blank is a cylinder, so that K_j is the level X1 − j·D. Values follow by
//! hand.

mod support;

use std::fmt::Write as _;

use turnspec_oracle::vocabulary::Setup;

fn holds(program: &str, expected: &str) {
    support::holds(program, expected, &Setup::default());
}

/// A cylinder of Ø60 from Z0 to Z−60, D4, and a contour of Ø20 from Z0, that ends at its diameter.
fn under_a_cylinder(contour: &str) -> String {
    format!(
        "N1 G83\nG01 X60 Z0\nZ-60\nN2 G81\nG00 X20 Z0\n{contour}G01 X20 Z-60\nX60\nG80\nG00 X80 Z9\n\
         G86 N1 D4 F0.2\nM02\n"
    )
}

/// The cut from a point along its level to the wall at Z−60, and back: relief of 0.2 on the diameter and 0.1 in Z, so that
/// no lift follows, X at F down.
fn cut_from(x: &str, z: &str, relieved: &str) -> String {
    format!(
        "linear x={x} z=-60 part=cut\nrapid x={relieved} z=-59.9 part=relief\nrapid x={relieved} z={z} part=return\n\
         linear x={x} z={z} part=return\n"
    )
}

/// The end of such a contour: along Ø20 to the wall, up to Ø60, relief, home.
const TO_THE_END: &str = "linear x=20 z=-60 part=contour\nlinear x=60 z=-60 part=contour\n\
                          rapid x=60.1 z=-59.9 part=relief\nrapid x=80 z=9 part=home\nend";

/// K5 is Ø40, K9 is Ø24: from Ø40 down to Ø20 the wall falls below K5 to K9, and below K10 not. The ten levels down to Ø20
/// itself make nine passes before. Where the wall begins, on K5, the contour is not below it, and falls at once.
#[test]
fn a_wall_is_left_at_each_depth() {
    let mut expected = "...\nrapid x=20 z=0 pass=10 part=infeed\nlinear x=20 z=-10 part=contour\n\
                        linear x=40 z=-10 part=contour\nlinear x=40 z=-20 part=contour\n"
        .to_owned();
    for (multiple, (x, relieved)) in
        [("40", "40.2"), ("36", "36.2"), ("32", "32.2"), ("28", "28.2"), ("24", "24.2")].iter().enumerate()
    {
        if multiple > 0 {
            let _ = writeln!(expected, "linear x={x} z=-20 part=contour");
        }
        expected += &cut_from(x, "-20", relieved);
    }
    expected += "linear x=20 z=-20 part=contour\n";
    holds(&under_a_cylinder("G01 Z-10\nX40\nZ-20\nX20\n"), &(expected + TO_THE_END));
}

/// The same down a slope, from (40, −20) on K5 to (20, −30): Ø4 deeper each 2 mm.
#[test]
fn a_slope_that_begins_on_a_level_is_left_there_once() {
    let mut expected = "...\nlinear x=40 z=-20 pass=10 part=contour\n".to_owned();
    for (multiple, (x, z, relieved)) in [
        ("40", "-20", "40.2"),
        ("36", "-22", "36.2"),
        ("32", "-24", "32.2"),
        ("28", "-26", "28.2"),
        ("24", "-28", "24.2"),
    ]
    .iter()
    .enumerate()
    {
        if multiple > 0 {
            let _ = writeln!(expected, "linear x={x} z={z} part=contour");
        }
        expected += &cut_from(x, z, relieved);
    }
    expected += "linear x=20 z=-30 part=contour\n";
    holds(&under_a_cylinder("G01 Z-10\nX40\nZ-20\nX20 Z-30\n"), &(expected + TO_THE_END));
}

/// Half a circle of radius 10 about (20, −20): its top is on K5, Ø40. Behind it, it is on K_j, 10 − 2·(j − 5) above its
/// centre: 0, 6, 8, √84 and √96 behind it. In front of the top it rises, and is left nowhere.
#[test]
fn a_hill_is_left_behind_its_top() {
    let mut expected = "...\nlinear x=20 z=-10 pass=10 part=contour\n".to_owned();
    for (x, z, relieved) in [
        ("40", "-20", "40.2"),
        ("36", "-26", "36.2"),
        ("32", "-28", "32.2"),
        ("28", "-29.165151", "28.2"),
        ("24", "-29.797959", "24.2"),
    ] {
        let _ = writeln!(expected, "arc x={x} z={z} sense=ccw cx=20 cz=-20 part=contour");
        expected += &cut_from(x, z, relieved);
    }
    expected += "arc x=20 z=-30 sense=ccw cx=20 cz=-20 part=contour\n";
    holds(&under_a_cylinder("G01 Z-10\nG03 X20 Z-30 K-10\n"), &(expected + TO_THE_END));
}

/// A' (30, 0) lies on K3, Ø42 less 12, and the contour falls at once: the first cut begins in A'. K4 and K5 are at Ø26 and
/// Ø22, 4 and 8 behind it.
#[test]
fn a_contour_may_be_left_in_its_start() {
    holds(
        "N1 G83\nG01 X42 Z0\nZ-60\nN2 G81\nG00 X30 Z0\nG01 X20 Z-10\nZ-60\nX42\nG80\nG00 X80 Z9\nG86 N1 D4 F0.2\nM02\n",
        &format!(
            "...\nrapid x=30 z=0 pass=3 part=infeed\n{}linear x=26 z=-4 part=contour\n{}\
             linear x=22 z=-8 part=contour\n{}linear x=20 z=-10 part=contour\n\
             linear x=20 z=-60 part=contour\nlinear x=42 z=-60 part=contour\n\
             rapid x=42.1 z=-59.9 part=relief\nrapid x=80 z=9 part=home\nend",
            cut_from("30", "0", "30.2"),
            cut_from("26", "-4", "26.2"),
            cut_from("22", "-8", "22.2"),
        ),
    );
}
