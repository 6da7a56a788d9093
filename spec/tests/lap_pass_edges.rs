//! LAP: passes of the modes at their edges, and the rules that their motions cite (execution-lap.md, sections 7 to 14).

mod support;

use support::{cites, ends_with, has_words, trace};
use turnspec_oracle::vocabulary::Setup;
use turnspec_oracle::vocabulary::notation::render;

fn holds(program: &str, expected: &str) {
    support::holds(program, expected, &Setup::default());
}

/// Of the motions of the program with these words, whether each cites the rule, or, if it `must` not, none.
fn cite(program: &str, words: &str, rule: &str, must: bool) {
    let mut found = 0;
    for event in trace(program, &Setup::default()) {
        let text = render(&event);
        if has_words(&text, words) {
            found += 1;
            assert_eq!(cites(&event, rule), must, "{program}\n{text}\n{rule}");
        }
    }
    assert!(found > 0, "{program}\n{words}");
}

/// A call behind a definition, from this AP start.
fn cycle(definition: &str, start: &str, call: &str) -> String {
    format!("{definition}\nG80\nG00 {start}\n{call} F0.3\nM02\n")
}

/// Two levels, Ø28 and Ø20, in mode IV (E100L-AP4-01).
fn high_speed() -> String {
    cycle("N1 G83\nG01 X20 Z50\nX36\nZ20\nG81\nG00 X20 Z50\nG01 Z20\nX36", "X50 Z60", "G85 N1 D8")
}

/// A blank of Ø24 and Ø32 over a cylinder in mode V: X1 is Ø24 (E100L-AP5-01), passes by the depth.
fn bar_copy(depth: &str) -> String {
    let blank = "N1 G83\nG01 X16 Z50\nX24\nZ40\nX32\nZ30";
    cycle(&format!("{blank}\nG81\nG00 X16 Z50\nG01 Z30\nX32 E0.1"), "X40 Z60", &format!("G86 N1 D{depth}"))
}

/// E100L-AP4-01: in the first pass the tool follows the contour to its end, behind its highest part too. It ends at Ø30
/// below that, Ø36: lift to Ø36.2 (E100L-AP1-06).
#[test]
fn the_first_pass_of_mode_iv_goes_beyond_the_highest_part() {
    let contour = "N1 G83\nG01 X16 Z50\nX36\nZ20\nG81\nG00 X16 Z50\nG01 Z40\nX36\nZ36\nX30\nZ20";
    holds(
        &cycle(contour, "X50 Z60", "G85 N1 D8"),
        "rapid x=50 z=60
rapid x=28 z=52 pass=1 part=infeed
linear x=28 z=40 pass=1 part=cut
linear x=36 z=40 pass=1 part=contour
linear x=36 z=36 pass=1 part=contour
linear x=30 z=36 pass=1 part=contour
linear x=30 z=20 pass=1 part=contour
rapid x=30.1 z=20.1 pass=1 part=relief
rapid x=36.2 z=20.1 pass=1 part=clear
...
end code=M02",
    );
}

/// E100L-AP4-03: a level is refused above S; in it, the line begins in S, where the tool is already. Its Z50 is nearer to the
/// contour than 52.
#[test]
fn a_level_may_be_that_of_the_start() {
    let blank = "N1 G83\nG01 X20 Z50\nX36\nZ20\nG81\nG00 X20 Z50\nG01 Z20\nX36";
    holds(
        &cycle(blank, "X28 Z50", "G85 N1 D8"),
        "rapid x=28 z=50
linear x=28 z=20 pass=1 part=cut
linear x=36 z=20 pass=1 part=contour
rapid x=36.1 z=20.1 pass=1 part=relief
rapid x=36.1 z=50 pass=1 part=return
rapid x=20 z=50 pass=2 part=infeed rules=E100L-AP4-03
...
end code=M02",
    );
    let above = cycle(blank, "X27.999 Z50", "G85 N1 D8");
    ends_with(&above, "name=unspecified detail=start rules=E100L-AP4-03", &Setup::default());
}

/// Section 14, mode IV: what the infeed of the first pass, and a cut in one part that meets the contour, do not cite.
#[test]
fn rules_of_mode_iv_are_those_of_what_happens() {
    let program = high_speed();
    cite(&program, "part=infeed pass=1", "E100L-AP4-04", false);
    cite(&program, "part=infeed pass=2", "E100L-AP4-04", true);
    cite(&program, "part=cut", "E100L-AP1-04", true);
    cite(&program, "part=cut", "E100L-AP4-05", false);
    cite(&program, "part=cut", "E100L-AP4-07", false);
    // In mode I a level may miss the contour too (E100L-LAP-21).
    let program = cycle("N1 G81\nG00 X20 Z2\nG01 Z-10\nX24", "X36 Z4", "G85 N1 D8");
    cite(&program, "part=cut", "E100L-AP1-04", true);
    cite(&program, "part=cut", "E100L-AP4-07", false);
}

/// E100L-LAPC-03: the level of the pass in the recess, below Ø28, lies behind A, that of the pass that has met it, below
/// Ø36, does not.
#[test]
fn passes_of_recesses_have_their_own_depth() {
    let contour = "N1 G81\nG00 X16 Z50\nG01 Z40\nX30\nX20 Z30\nZ20\nX30 Z15\nX36";
    let program = cycle(contour, "X36 Z50", "G85 N1 D8 G84 XA=30 DA=4");
    cite(&program, "pass=1", "E100L-LAPC-03", false);
    cite(&program, "pass=2", "E100L-LAPC-03", true);
    cite(&program, "pass=2 part=relief", "E100L-LAPC-02", true);
    // By 4, to Ø24, on the slopes at Z34 and Z18.
    holds(
        &program,
        "...
rapid x=28 z=38 pass=1 part=return
linear x=24 z=34 pass=2 part=contour
linear x=24 z=18 pass=2 part=cut
...
end code=M02",
    );
}

/// E100L-AP1-12: behind the last pass of a recess the relief is 0.2 in X and 0.1 in Z, also where X is the cutting axis.
#[test]
fn the_relief_in_a_face_is_doubled_in_x() {
    holds(
        &cycle("N1 G82\nG00 X60 Z0\nG01 X50\nZ6\nX44\nZ0\nX30\nZ10", "X64 Z10", "G85 N1 D6"),
        "rapid x=64 z=10
rapid x=61.6 z=4 pass=1 part=infeed
linear x=50 z=4 pass=1 part=cut
linear x=50 z=6 pass=1 part=contour
linear x=44 z=6 pass=1 part=contour
linear x=44 z=4 pass=1 part=contour
linear x=30 z=4 pass=1 part=cut
linear x=30 z=10 pass=1 part=contour
rapid x=30.1 z=10.1 pass=1 part=relief
rapid x=44 z=10.1 pass=1 part=return
rapid x=44 z=4 pass=1 part=return
linear x=44 z=0 pass=2 part=contour
linear x=30 z=0 pass=2 part=contour
linear x=30 z=4 pass=2 part=contour
rapid x=30.2 z=4.1 pass=2 part=relief rules=E100L-AP1-12
...
end code=M02",
    );
}

/// Section 7, point 4: without a way along Z, mode II alone has nothing to refuse, and only without W.
#[test]
fn a_face_can_be_copied_along_x() {
    let face = "N1 G81\nG00 X20 Z2\nG01 X36";
    holds(
        &cycle(face, "X40 Z4", "G86 N1 D20"),
        "rapid x=40 z=4
rapid x=20 z=2 pass=1 part=infeed
linear x=36 z=2 pass=1 part=contour
rapid x=36 z=4 part=home
rapid x=40 z=4 part=home
end code=M02",
    );
    let refused = "name=unspecified detail=direction rules=E100L-LAP-20";
    ends_with(&cycle(face, "X40 Z4", "G86 N1 D20 W0.1"), refused, &Setup::default());
    ends_with(&cycle(face, "X40 Z4", "G85 N1 D20"), refused, &Setup::default());
}

/// E100L-AP5-07: the contour ends at Ø20, below its highest point, Ø26: lift to Ø26.2.
#[test]
fn mode_v_is_lifted_over_what_it_has_crossed() {
    let contour = "N1 G83\nG01 X30 Z50\nZ20\nG81\nG00 X20 Z50\nG01 Z40\nX26\nZ36\nX20\nZ20";
    holds(
        &cycle(contour, "X40 Z60", "G86 N1 D12"),
        "rapid x=40 z=60
rapid x=20 z=60 pass=1 part=infeed
rapid x=20 z=50 pass=1 part=infeed
linear x=20 z=40 pass=1 part=contour
linear x=26 z=40 pass=1 part=contour
linear x=26 z=36 pass=1 part=contour
linear x=20 z=36 pass=1 part=contour
linear x=20 z=20 pass=1 part=contour
rapid x=20.1 z=20.1 pass=1 part=relief rules=E100L-AP5-07
rapid x=26.2 z=20.1 pass=1 part=clear rules=E100L-AP5-07
rapid x=40 z=60 pass=- part=home rules=E100L-AP5-07+E100L-LAP-06
end code=M02",
    );
}

/// Section 14: mode V cites the rule of its call, along the contour where its feed comes from; home belongs to no pass.
#[test]
fn rules_of_mode_v() {
    let program = bar_copy("4");
    for (words, rule, must) in [
        ("rapid pass=1", "E100L-LAPC-05", true),
        ("linear pass=2", "E100L-LAPC-05", true),
        ("part=home", "E100L-LAPC-05", true),
        ("linear pass=2", "E100L-LAPC-07", false),
        ("part=contour z=30 x=16", "E100L-LAP-08", true),
        ("part=contour z=30 x=16", "E100L-LAP-07", false),
        ("part=contour x=32", "E100L-LAP-07", true),
        ("part=contour x=32", "E100L-LAP-08", false),
    ] {
        cite(&program, words, rule, must);
    }
    holds(
        &program,
        "...
linear x=16 z=30 f=0.3mm/rev pass=2 part=contour readings=contour_feed=kept
linear x=32 z=30 f=0.1mm/rev pass=2 part=contour
rapid x=32.1 z=30.1 pass=2 part=relief
rapid x=40 z=60 pass=- part=home
end code=M02",
    );
}

/// Section 14: none of the rules for G82 in mode V.
#[test]
fn mode_v_has_no_rule_of_its_own_for_faces() {
    let contour = "N1 G83\nG01 X40 Z6\nX20\nG82\nG00 X40 Z0\nG01 X20\nZ6";
    let program = cycle(contour, "X50 Z10", "G86 N1 D3");
    for rule in ["E100L-AP1-14", "E100L-AP2-02", "E100L-AP3-03", "E100L-AP4-09"] {
        cite(&program, "linear", rule, false);
    }
}

/// E100L-TUNC-02, section 13: the last motion is the last one emitted, here the contour of mode II, relief, home.
#[test]
fn the_last_motion_of_a_cycle_counts_for_the_turret() {
    let mut setup = Setup::default();
    setup.inputs.turret_clamp_confirmed = false;
    let program = |call: &str| {
        format!(
            "N1 G81\nG00 X20 Z2\nG01 Z-10\nX36\nG80\nG00 X36 Z4\n{call} N1 D16 F0.3\nG00 X500 M203\nM02\n"
        )
    };
    ends_with(&program("G86").replace("F0.3", "F0.3 M85"), "name=turret_clamp rules=E100L-TUNC-02", &setup);
    ends_with(&program("G86"), "end code=M02", &setup);
    ends_with(&program("G85").replace("F0.3", "F0.3 M85"), "end code=M02", &setup);
    ends_with(&program("G85"), "end code=M02", &setup);
}

/// E100L-CSS-05: a rapid motion in G96 cites it; one that cuts cites E100L-CSS-01.
#[test]
fn motions_in_constant_cutting_speed() {
    let program = high_speed().replace("G00 X50", "G96 S100 M03\nG00 X50");
    for (kind, rule, must) in [
        ("rapid", "E100L-CSS-05", true),
        ("rapid", "E100L-CSS-01", false),
        ("linear", "E100L-CSS-01", true),
        ("linear", "E100L-CSS-05", false),
    ] {
        cite(&program, &format!("{kind} pass=1"), rule, must);
    }
}
