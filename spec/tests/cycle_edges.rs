//! The cycles at their edges: which events cite what, offsets and retracts that meet a bound, targets on either side of zero,
//! and what a cycle leaves behind. All values follow by hand from execution-drilling.md and the rules named.

#![allow(clippy::panic)]

mod support;

use support::has_words;
use turnspec_oracle::vocabulary::Event;
use turnspec_oracle::vocabulary::notation::render;

fn trace(program: &str, setup: &str) -> Vec<Event> {
    support::trace(program, &support::set_up(setup))
}

fn holds(program: &str, setup: &str, expected: &str) {
    support::holds(program, expected, &support::set_up(setup));
}

/// Whether the one event with all these words of the compact notation cites a rule.
fn cites(program: &str, setup: &str, words: &str, rule: &str) -> bool {
    let all = trace(program, setup);
    let meant: Vec<&Event> = all.iter().filter(|event| has_words(&render(event), words)).collect();
    let [event] = meant[..] else { panic!("{} events with {words}\n{program}", meant.len()) };
    support::cites(event, rule)
}

/// MCYC-19 is about the feed of G184 with M140; section 10: its cut cites it "in G184, not synchronised, with M140".
#[test]
fn only_floating_tapping_with_m140_cites_that_it_does_not_wait() {
    let cut = |cycle: &str, setup: &str, words: &str| {
        let program =
            format!("M110\nG94 G00 X60 Z20 SB=400\n{cycle} X60 Z5 C0 K10 F400\nG180\nG00 X200 Z200\nM02\n");
        cites(&program, setup, words, "E100L-MCYC-19")
    };
    assert!(cut("M140 G184", "", "linear part=cut"));
    assert!(!cut("G184", "", "linear part=cut"));
    assert!(!cut("M140 G181", "", "linear part=cut"));
    let synchronised = "[parameters]\ng184_tapping = \"synchronised\"\n";
    assert!(!cut("M140 G184", synchronised, "thread part=cut"));
}

/// GRV-08: the place of the last groove is moved by the difference of the two amounts, 3 − 1 = 2: Z-15 becomes Z-13; in the
/// reading `subtracted` Z-17.
#[test]
fn the_offset_in_force_counts_against_that_of_the_last_groove() {
    let program = "G00 X60 Z-10 T0101\nG73 X56 Z-15 K20 D4 F0.1 T0102\nM02\n";
    let offsets = "[[tool_offset]]\nnumber = 1\nz = 1\n[[tool_offset]]\nnumber = 2\nz = 3\n";
    holds(program, offsets, "...\nrapid x=60 z=-13 part=shift rules=E100L-GRV-08\n...\nend code=M02");
    let subtracted = format!("{offsets}[readings]\ntool_offset = \"subtracted\"\n");
    holds(program, &subtracted, "...\nrapid x=60 z=-17 part=shift rules=E100L-GRV-08\n...\nend code=M02");
}

/// Section 8, passes of G190, 3: r = max(l − a, 0). The first pass is 2.5 deep, α is 3: the relief ends at the cutting start,
/// Z10, and does not go on to Z10.5; the re-entry from the cutting start is none.
#[test]
fn the_relief_of_a_key_way_ends_at_the_cutting_start() {
    let program = "M110\nG94 G00 X60 Z20 SB=400\nG190 X40 Z5 C0 K10 D2.5 E10 F40\nG180\nG00 X200 Z200\nM02\n";
    let retract = "[parameters]\ndrilling_retract = 3\n";
    let relief = format!("{retract}[readings]\nkeyway_return = \"relief\"\n");
    holds(
        program,
        &relief,
        "...
linear x=40 z=7.5 pass=1 part=cut
rapid x=40 z=10 pass=1 part=retract rules=E100L-G190-03
rapid x=60 z=10 pass=1 part=shift
linear x=60 z=5 path=5 pass=2 part=infeed
...
end code=M02",
    );
    holds(
        program,
        retract,
        "...
linear x=40 z=7.5 pass=1 part=cut
rapid x=40 z=10 pass=1 part=withdraw
rapid x=60 z=10 pass=1 part=shift
linear x=60 z=5 path=5 pass=2 part=infeed
...
end code=M02",
    );
}

/// Motions of a cycle carry `speed` in G96 "as ever" (section 9): a rapid motion cites CSS-05, a cutting one CSS-01
/// (CSS-05: "A rapid event in G96 cites this rule").
#[test]
fn in_constant_cutting_speed_feeds_and_rapids_of_a_cycle_cite_their_own_rules() {
    let program = "G96 S100 M03\nG00 X60 Z-10\nG73 X56 D4 F0.1\nM02\n";
    for (words, own, other) in [
        ("linear part=cut", "E100L-CSS-01", "E100L-CSS-05"),
        ("rapid part=return", "E100L-CSS-05", "E100L-CSS-01"),
    ] {
        assert!(cites(program, "", words, own), "{words}");
        assert!(!cites(program, "", words, other), "{words}");
    }
}

/// TUNC-02: the `exit` is a cutting motion, and from the cutting start no `return` follows it; the `return` of a drilled hole
/// is rapid.
#[test]
fn the_turret_knows_the_last_motion_of_a_cycle() {
    let program = |code: &str| {
        format!("M110\nG94 G00 X60 Z20 SB=400\n{code} X60 Z5 C0 K10 F40\nG180\nG00 X200 Z200 M203\nM02\n")
    };
    let unconfirmed = "[inputs]\nturret_clamp_confirmed = false\n";
    holds(
        &program("G189"),
        unconfirmed,
        "...\nlinear part=exit\n...\nalarm name=turret_clamp line=5 rules=E100L-TUNC-02",
    );
    holds(&program("G181"), unconfirmed, "...\nrapid part=return\n...\naux code=M203\n...\nend code=M02");
}

/// Section 3, check 1a: with G137 in force a groove, tapping or thread cycle block and G190 are `unspecified` (CSC-09),
/// detail the code, and a hole along X, detail `I`.
#[test]
fn other_cycles_than_holes_along_z_have_no_place_in_coordinate_conversion() {
    for (block, code) in [
        ("G73 X50 D4", "G73"),
        ("G74 Z-5 D4", "G74"),
        ("G77 X0 Z-15 K5", "G77"),
        ("G78 X0 Z-15 K5", "G78"),
        ("G181 X50 Z-5 I1", "I"),
        ("G183 Z-5 D1 I1 K1", "I"),
        ("G190 X50 Z-5 K1 D1", "G190"),
        ("G95 G185 X50 Z-5 SA=1", "G185"),
    ] {
        let program = format!("M110\nG94 G137 C0\nG00 X30 Y0 F100 S200 SB=400\n{block}\nM02\n");
        holds(&program, "", &format!("...\nalarm name=unspecified detail={code} line=4 rules=E100L-CSC-09"));
    }
}

/// Section 3, check 5: a synchronised tap takes D and J in conversion mode too: it starts at 90 degrees, and two threads a
/// pitch halve the lead of 2; no other hole takes D (E100L-STAP-01, E100L-CSC-09).
#[test]
fn a_synchronised_tap_in_conversion_mode_has_its_words() {
    let program = |block: &str| {
        format!("M110\nG95 G137 C0\nG00 X30 Y0 Z20 F2 SB=400\n{block}\nG180\nG136\nG00 X60 Z20\nM02\n")
    };
    holds(
        &program("G178 X0 Y20 Z5 K5 D90 J2"),
        "",
        "...\nrapid x=40 c=90 px=0 py=20 part=position\n...\nthread part=cut lead=1 start=90\n...\nend code=M02",
    );
    holds(
        &program("G94 G182 X0 Y20 Z5 K5 D90"),
        "",
        "...\nalarm name=word_without_function detail=D line=4 rules=E100L-ADDR-01",
    );
}

/// TAP-02: X goes to the word X, in G91 (TAP-01) as far as the word from the present 10; Z to 20 − 5 = 15, to the bottom,
/// which lies on the same side of zero as the start, and back.
#[test]
fn a_tap_is_positioned_on_x_and_may_end_above_zero() {
    holds(
        "G00 X20 Z20 S200\nG77 X10 Z5 K5 F1.5\nG91\nG77 X5 Z-15 K5\nM02\n",
        "",
        "...
rapid x=20 z=20
rapid x=10 z=20 part=position rules=E100L-TAP-02
spindle state=cw
rapid x=10 z=15 part=approach
linear x=10 z=5 part=cut path=10
...
rapid x=10 z=20 part=return
...
rapid x=15 z=20 part=position rules=E100L-TAP-02
spindle state=cw
rapid x=15 z=15 part=approach
linear x=15 z=5 part=cut path=10
...
end code=M02",
    );
}

/// Section 9: "the base point of a chamfer is forgotten after a block that has moved X or Z" (CHAM-13). C = (120, 80), D =
/// (120, 75). The groove and the tap end where they begin, in D: Z-20 leads from there to Z55, not from C to Z60.
#[test]
fn a_cycle_forgets_the_corner_before_it() {
    for cycle in ["G73 X-4 D4", "G74 Z-5 D5", "G77 X0 Z-15 K5", "G78 X0 Z-15 K0"] {
        let program = format!("G01 X100 Z80 F0.2 S200\nG91 G75 X20 L-5\n{cycle}\nZ-20\nM02\n");
        let basic = "[parameters]\nchamfering = \"basic\"\n";
        holds(
            &program,
            basic,
            "...\nlinear x=120 z=75 line=2\n...\nlinear x=120 z=55 line=4\n...\nend code=M02",
        );
        assert!(!cites(&program, basic, "linear line=4", "E100L-CHAM-13"), "{cycle}");
    }
}

/// MCYC-01: the motion mode stays beneath a cycle, whose blocks are no contour blocks (section 2 of the execution): that G132 could
/// not be commanded in G18 (CGS-08) is nothing to the hole, which is drilled to X90.
#[test]
fn a_cycle_block_in_a_motion_mode_of_contours_is_no_contour_block() {
    let start = "M110\nG94 G00 X100 Z50 F100 SB=400\nG119 G132\nG18\n";
    let setup = "[parameters]\nside_contour_mode = true\n";
    holds(
        &format!("{start}G181 X90 Z40 C0 K1\nG180\nG00 X200 Z200\nM02\n"),
        setup,
        "...\nlinear x=90 z=40 part=cut line=5\n...\nend code=M02",
    );
    holds(
        &format!("{start}X90 Z40 C0 L10\nM02\n"),
        setup,
        "...\nalarm name=contour_command_unusable line=5 rules=E100L-CGS-08",
    );
}
