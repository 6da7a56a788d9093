//! Holes in conversion mode (E100L-CSC-09), and G136 behind G180 (E100L-MCYC-13).

use turnspec_oracle::vocabulary::rule_ids::{CSC_04, CSC_06, DIA_01, G00_01, INCH_02};
use turnspec_oracle::vocabulary::{ConversionZeroShift, Event, RuleId, Setup, UnitSystem, notation};

use super::{alarm, trace, values};

const MODE: &str = "M110\nG94 G00 X200 Z30 SB=400\nG137 C0\n";
const HOLE: &str = "G181 X30 Y40 Z5 K10 F60\n";

/// The alarm of blocks in conversion mode.
fn refused(blocks: &str) -> String {
    alarm(&format!("{MODE}{blocks}"))
}

/// The values of some keys in the events of part `position`.
fn places(program: &str, setup: &Setup, keys: &[&str]) -> Vec<String> {
    let keys: Vec<_> = ["part"].iter().chain(keys).copied().collect();
    let found = values(program, setup, &keys);
    found.iter().filter_map(|found| found.strip_prefix("position ")).map(str::to_owned).collect()
}

fn places_of(blocks: &str, keys: &[&str]) -> Vec<String> {
    places(&format!("{MODE}{blocks}"), &Setup::default(), keys)
}

/// Whether each event of part `position` cites a rule.
fn cites(program: &str, setup: &Setup, rule: RuleId) -> Vec<bool> {
    let is_place = |event: &&Event| notation::render(event).contains("part=position");
    let events = trace(program, setup);
    events.iter().filter(is_place).map(|event| event.rules.as_slice().contains(&rule)).collect()
}

#[test]
fn a_hole_keeps_its_point_without_travel_too() {
    let program = "M110\nG94 G00 X100 Z30 SB=400\nG137 C0\nG181 X50 Y0 Z5 K10 F60\nY50\n";
    assert_eq!(places(program, &Setup::default(), &["x", "c", "px", "py"]), ["141.421356 45 50 50"]);
}

#[test]
fn a_block_without_a_point_drills_where_the_axes_stand() {
    let blocks = format!("{HOLE}Q2\n");
    assert_eq!(places_of(&blocks, &["c"]), ["53.130102", "233.130102"]);
    assert_eq!(places_of(&blocks, &["px", "py"]), ["30 40"]);
    let cuts = values(&format!("{MODE}{HOLE}R-7\nE1\nF30\n"), &Setup::default(), &["part", "px"]);
    assert_eq!(cuts, ["position 30"]);
}

#[test]
fn the_point_is_lost_where_c_has_turned_or_is_shifted() {
    let lost = "unspecified start E100L-CSC-06";
    assert_eq!(refused(&format!("{HOLE}Q2\nG180\nG189 X20 Z5 K10\n")), lost);
    assert_eq!(refused(&format!("{HOLE}VZSHC=10\nY20\n")), lost);
    // The point comes before the depth, and behind the feed.
    assert_eq!(refused(&format!("{HOLE}VZSHC=10\nY20 Z25\n")), lost);
    let shifted = format!("{HOLE}VZSHC=10\nX20 Y0\n");
    assert_eq!(places_of(&shifted, &["px", "c"]), ["30 53.130102", "20 0"]);
}

#[test]
fn a_zero_shift_of_c_moves_holes_as_it_moves_positions() {
    let program = format!("M110\nG50 C30\nG94 G00 X200 Z30 SB=400\nG137 C0\n{HOLE}");
    let mut setup = Setup::default();
    assert_eq!(places(&program, &setup, &["c", "mc"]), ["53.130102 23.130102"]);
    setup.parameters.conversion_zero_shift = ConversionZeroShift::Excluded;
    assert_eq!(places(&program, &setup, &["c", "mc"]), ["83.130102 53.130102"]);
    assert_eq!(cites(&program, &setup, CSC_04), [true]);
}

#[test]
fn no_increments_in_a_cycle_of_conversion_mode() {
    assert_eq!(refused("G91 G181 X30 Y40 Z5 K10 F60\n"), "cycle_incremental E100L-MCYC-14");
    assert_eq!(refused("G00 X30 Y40\nG91\nG181 X30 Y40 Z5 K10 F60\n"), "cycle_incremental E100L-MCYC-14");
    let behind = "G00 X30 Y40\nG91 Y-80\nG90\nG181 X0 Z5 K10 F60\n";
    assert_eq!(places_of(behind, &["x", "c", "px", "py"]), ["80 270 0 -40"]);
}

#[test]
fn c_turns_to_holes_in_the_sense_in_force() {
    let blocks = "M16\nG181 X30 Y40 Z5 K10 Q3 F60\n";
    let places = places_of(blocks, &["c", "c_travel"]);
    assert_eq!(places, ["53.130102 -306.869898", "293.130102 -120", "173.130102 -120"]);
}

#[test]
fn other_cycles_are_refused_before_their_words() {
    let of_mode = |detail: &str| format!("unspecified {detail} E100L-CSC-09");
    for code in ["G73", "G74", "G190"] {
        assert_eq!(refused(&format!("{code} I1 Y5\n")), of_mode(code), "{code}");
    }
    for code in ["G185", "G186", "G187", "G188"] {
        assert_eq!(refused(&format!("G95 {code} I1 Y5\n")), of_mode(code), "{code}");
    }
    for code in ["G77", "G78"] {
        assert_eq!(refused(&format!("{code}\n")), of_mode(code), "{code}");
    }
    for code in ["G178", "G179", "G181", "G182", "G183", "G184", "G189"] {
        let feed = if code == "G178" || code == "G179" { "G95" } else { "G94" };
        let blocks = format!("{feed}\n{code} Y5 I1 K1\n");
        assert_eq!(refused(&blocks), of_mode("I"), "{code}");
    }
    assert_eq!(refused(&format!("{HOLE}I5\n")), of_mode("I"));
    // What the cycle itself refuses comes first.
    assert_eq!(refused(&format!("{HOLE}G180\nG74 Z5 D2\n")), "word_missing E100L-MCYC-13");
    assert_eq!(refused("G95\nG181 X30 Y0 Z5 I10\n"), "cycle_feed_mode G181 E100L-MCYC-03");
    assert_eq!(refused("G137 C0 G181 X30 Y0 Z5 K10\n"), "unspecified G137 E100L-MCYC-14");
}

#[test]
fn words_of_holes_in_conversion_mode() {
    let missing = "conversion_axis_missing E100L-CSC-06";
    assert_eq!(refused("G181 Y30 K-1\n"), missing);
    assert_eq!(refused("G181 Z5 K10 F60\nY30\n"), missing);
    assert_eq!(refused(&format!("{HOLE}C90\n")), "word_without_function C E100L-ADDR-01");
    assert_eq!(refused("G181 X30 Y40 Z5 K10 W1 F60\n"), "word_without_function W E100L-ADDR-01");
    assert_eq!(alarm("M110\nG181 X30 Y40 Z5 K10 F60\n"), "address_unknown E100L-ADDR-01");
}

#[test]
fn points_of_holes_in_other_units() {
    let program = |unit: &str, depths: &str| {
        format!("M110\nG94 G00 X1{unit} Z1{unit} SB=400\nG137 C0\nG178 X3{unit} Y4{unit} {depths}\nY0\n")
    };
    let micrometre = Setup { unit_system: UnitSystem::Micrometre, ..Setup::default() };
    let keys = ["x", "c", "px", "py"];
    let small = program("0000", "Z-9000 K1000 F9000");
    assert_eq!(places(&small, &micrometre, &keys), ["100 53.130102 30 40", "60 0 30 0"]);
    let inch = Setup { unit_system: UnitSystem::Inch, ..Setup::default() };
    let large = program("", "Z-2 K1 F9");
    assert_eq!(places(&large, &inch, &keys), ["254 53.130102 76.2 101.6", "152.4 0 76.2 0"]);
    assert_eq!(cites(&large, &inch, INCH_02), [true, true]);
}

#[test]
fn the_x_of_a_point_is_no_diameter() {
    let program = format!("{MODE}{HOLE}Y20\n");
    let setup = Setup::default();
    for rule in [DIA_01, G00_01] {
        assert_eq!(cites(&program, &setup, rule), [false, false], "{}", rule.as_str());
    }
    assert_eq!(cites(&program, &setup, CSC_06), [false, true]);
}

#[test]
fn the_duty_behind_a_cycle_outlasts_the_end_of_conversion() {
    let missing = "word_missing E100L-MCYC-13";
    assert_eq!(refused(&format!("{HOLE}G180\nG136\nG136\nM12\n")), missing);
    assert_eq!(refused(&format!("{HOLE}G180\nG136\nV1=1\nM12\n")), missing);
    assert_eq!(refused(&format!("{HOLE}G180\nG136\nG137 C0\n")), missing);
    let out_of_mode = "M110\nG94 G00 X60 Z20 SB=400\nG181 Z5 K10 F60\nG180\nG136\nG00 Z20\n";
    assert_eq!(alarm(out_of_mode), missing);
    assert_eq!(refused(&format!("{HOLE}G180\nG136 X20 Z30\n")), "not_alone E100L-CSC-09");
    assert_eq!(refused(&format!("{HOLE}G180\nG136\nG00 X60 Z20\nZ30\n")), "no_program_end E100L-PROG-02");
}

#[test]
fn a_cycle_brings_no_motion_code_back() {
    assert_eq!(refused(&format!("{HOLE}G180\nX30 Y0 Z30\n")), "motion_code_missing E100L-CSC-05");
}
