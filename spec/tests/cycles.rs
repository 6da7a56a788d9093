//! Grooving, drilling, tapping and the cycles of driven tools: what their events cite, in which order blocks are refused,
//! and what goes on between blocks. The examples of the rule texts hold besides.

mod support;

use proptest::prelude::*;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{
    CycleReturn, Event, G184Tapping, Length, Limit, MachineType, Setup, ToolOffset, UnitSystem,
};

use support::{kind, texts, value};

/// Kind (or code), pass, part, and sorted rules and readings of each event.
fn cited(program: &str, setup: &Setup) -> Vec<String> {
    let mut lines = Vec::new();
    turnspec_oracle::run(program.as_bytes(), setup, &mut |event: &Event| {
        let text = render(event);
        let rules = event.rules.as_slice().iter().filter_map(|rule| rule.as_str().strip_prefix("E100L-"));
        let readings = event.readings.iter().map(|reading| reading.as_str());
        let mut names: Vec<&str> = rules.chain(readings).collect();
        names.sort_unstable();
        let head = [kind(&text), value(&text, "pass"), value(&text, "part"), value(&text, "code")];
        let head: Vec<&str> = head.into_iter().filter(|each| *each != "-").collect();
        lines.push(format!("{}: {}", head.join(" "), names.join(" ")));
    });
    lines
}

/// A line of [`cited`], with the names in any order.
fn line(head: &str, names: &[&str]) -> String {
    let mut names: Vec<&str> = names.iter().flat_map(|each| each.split_whitespace()).collect();
    names.sort_unstable();
    names.dedup();
    format!("{head}: {}", names.join(" "))
}

fn ends_with(program: &str, setup: &Setup, wanted: &str) {
    support::ends_with(program, wanted, setup);
}

const MOTION: &str = "COORD-03 ABS-01";
const FEED: &str = "FEED-01 G01-04 feed_length=radius";
const PER_MINUTE: &str = "FEED-02 G01-04 feed_length=radius";
/// In front of a cycle of a driven tool.
const JOINED: &str = "M110\nG94 G00 X60 Z20 SB=400 F40\n";

/// All that the events of a groove cite, and nothing else.
#[test]
fn grooves_cite_their_rules() {
    let offset = ToolOffset { number: 2, z: Length(1_000_000), ..ToolOffset::default() };
    let setup = Setup { tool_offset: vec![offset], ..Setup::default() };
    let program = "G00 X60 Z-10\nG91 G73 X-8 Z-2 I2 K5 D2 L4 E1 F0.1\nG90 G73 X54 Z-16 K9 D9 T0002\nM02\n";
    let found = cited(program, &setup);
    let all = "COORD-03 ABS-02 ABS-03 DIA-01 GRV-01";
    let radial = "peck_retract=diameter";
    let mut expected = Vec::new();
    for last in ["", "GRV-07"] {
        expected.push(line("rapid approach", &[all, last, "GRV-03"]));
        expected.push(line("linear 1 cut", &[all, last, FEED, "GRV-04 GRV-10", radial]));
        expected.push(line("rapid 1 retract", &[all, last, "GRV-04", radial]));
        expected.push(line("linear 2 cut", &[all, last, FEED, "GRV-04 GRV-10", radial]));
        expected.push(line("rapid 2 withdraw", &[all, last, "GRV-05", radial]));
        expected.push(line("rapid 3 reentry", &[all, last, "GRV-05", radial]));
        expected.push(line("linear 3 cut", &[all, last, FEED, "GRV-04 GRV-10", radial]));
        expected.push("dwell: DWELL-02 GRV-01 GRV-06".to_owned());
        expected.push(line("rapid return", &[all, last, "GRV-06"]));
        if last.is_empty() {
            expected.push(line("rapid shift", &[all, "GRV-06 GRV-07"]));
        }
    }
    expected.push(line("rapid return", &[all, "GRV-07"]));
    assert_eq!(found.get(2..22), Some(expected.as_slice()));
    let all = "COORD-03 ABS-01 DIA-01 GRV-01";
    let one = line("linear 1 cut", &[all, FEED, "GRV-04 GRV-10", radial]);
    let shift = line("rapid shift", &[all, "GRV-06 GRV-07 GRV-08 tool_offset=added"]);
    let second = [one, line("rapid return", &[all, "GRV-06"]), shift];
    assert_eq!(found.get(23..26), Some(second.as_slice()));
}

/// One hole on the axis: neither a diameter nor a step.
#[test]
fn a_hole_on_the_axis_cites_its_rules() {
    let found = cited("G00 X0 Z5\nG74 Z-3 K1 D4 F0.1\nM02\n", &Setup::default());
    let all = "COORD-03 ABS-01 GRV-02";
    let expected = [
        line("rapid approach", &[all, "GRV-03"]),
        line("linear 1 cut", &[all, FEED, "GRV-04 GRV-09 GRV-10"]),
        line("rapid 1 retract", &[all, "GRV-04"]),
        line("linear 2 cut", &[all, FEED, "GRV-04 GRV-09 GRV-10"]),
        line("rapid return", &[all, "GRV-06"]),
    ];
    assert_eq!(found.get(1..6), Some(expected.as_slice()));
}

/// All that the events of a tapping block cite; M63 is no matter of them.
#[test]
fn taps_cite_their_rules() {
    let found = cited("G00 X50 Z10 S200\nG78 X0 Z-15 K5 F1.5 M63\nM02\n", &Setup::default());
    let all = "COORD-03 ABS-01 DIA-01 TAP-01 TAP-03";
    let turns = "TAP-01 TAP-03 MCODE-05";
    let expected = [
        line("rapid position", &[all]),
        line("spindle", &[turns, "SPD-04 TAP-04"]),
        line("rapid approach", &[all]),
        line("linear cut", &[all, FEED]),
        line("spindle", &[turns]),
        line("spindle", &[turns, "SPD-04"]),
        line("linear exit", &[all, FEED]),
        line("rapid return", &[all]),
        line("spindle", &[turns, "TAP-06"]),
    ];
    assert_eq!(found.get(3..12), Some(expected.as_slice()));
}

/// A deep hole on the side, a second one by Q, with return to the cycle start.
#[test]
fn deep_holes_cite_their_rules() {
    let program = format!("{JOINED}G183 R-10 Z0 C30 I10 D6 L6 E1 Q2 M136 M141\nG180\nG00 X200 Z200\nM02\n");
    let found = cited(&program, &Setup::default());
    let cycle = "G183-01 MCYC-08";
    let (radial, out) = ("peck_retract=diameter", "G183-02 chip_discharge=cutting_start");
    let cut = line("linear 1 cut", &[MOTION, cycle, PER_MINUTE, radial, "MCYC-03 MCYC-18 MCYC-22"]);
    let hole = |again: &str, place: &str| {
        vec![
            line("rapid position", &[MOTION, cycle, "CAX-05", place]),
            line("rapid approach", &[MOTION, cycle, "MCYC-05", again]),
            cut.clone(),
            line("rapid 1 withdraw", &[MOTION, cycle, radial, out]),
            line("rapid 2 reentry", &[MOTION, cycle, radial, out]),
            cut.replace("linear 1", "linear 2"),
            line("dwell", &[cycle, "DWELL-02 G183-03"]),
            line("rapid return", &[MOTION, cycle, "MCYC-15"]),
        ]
    };
    let mut expected = vec![
        "mode G183: G183-01 GCODE-02 MCYC-01".to_owned(),
        "aux M136: MCODE-26".to_owned(),
        "aux M141: MCODE-28".to_owned(),
    ];
    let mut first = hole("", "");
    first.insert(1, line("spindle", &["MCODE-06 SB-03 MCYC-10 G183-01"]));
    expected.append(&mut first);
    expected.append(&mut hole("MCYC-17", "MCYC-20"));
    expected.push("mode G180: GCODE-02 MCYC-01 MCYC-02 MCYC-12".to_owned());
    assert_eq!(found.get(4..25), Some(expected.as_slice()));
}

/// The cycles that leave a hole at feed, and a later hole.
#[test]
fn taps_of_driven_tools_cite_their_rules() {
    let program = format!("{JOINED}G184 X60 Z5 K10\nC90 M136 M140\nG180\nG00 X200 Z200\nM02\n");
    let found = cited(&program, &Setup::default());
    let all = "G184-01 MCYC-07 MCYC-09";
    let turns = "MCODE-06 MCYC-10 G184-01";
    let expected = [
        "aux M136: MCODE-26".to_owned(),
        "aux M140: MCODE-27".to_owned(),
        line("rapid position", &[MOTION, all, "CAX-05"]),
        line("aux M147", &["MCODE-29 MCYC-10 G184-01"]),
        line("linear cut", &[MOTION, all, PER_MINUTE, "MCYC-03 MCYC-19"]),
        line("spindle", &[turns]),
        line("spindle", &[turns, "SB-03"]),
        line("linear exit", &[MOTION, all, PER_MINUTE, "MCYC-03"]),
        line("aux M146", &["MCODE-29 MCYC-10 G184-01"]),
        line("spindle", &[turns]),
        line("spindle", &[turns, "SB-03"]),
        line("rapid return", &[MOTION, all, "MCYC-15 MCYC-16"]),
    ];
    let begin = found.iter().position(|line| line.starts_with("aux M136")).unwrap_or_default();
    assert_eq!(found.get(begin..begin + expected.len()), Some(expected.as_slice()));
}

/// Synchronised tapping on the side.
#[test]
fn synchronised_taps_cite_their_rules() {
    let program = format!("{JOINED}G179 X30 Z0 C9 I10 F500 J2 D30 M136\nG180\nG00 X200 Z200\nM02\n");
    let found = cited(&program, &Setup::default());
    let all = "DIA-01 STAP-02 STAP-03 MCYC-08";
    let turns = "MCODE-06 MCYC-10 STAP-02 STAP-03";
    let tap = "STAP-01 feed_length=radius";
    let expected = [
        line("mode G179", &["GCODE-02 MCYC-01 STAP-01 STAP-03"]),
        "aux M136: MCODE-26".to_owned(),
        line("rapid position", &[MOTION, all, "CAX-05"]),
        line("spindle", &[turns]),
        line("rapid approach", &[MOTION, all, "MCYC-05"]),
        line("aux M147", &["MCODE-29 MCYC-10 STAP-02 STAP-03"]),
        line("spindle", &[turns, "SB-03"]),
        line("thread cut", &[MOTION, all, tap, "MCYC-03"]),
        line("spindle", &[turns, "SB-03"]),
        line("thread exit", &[MOTION, all, tap]),
        line("spindle", &[turns, "STAP-04"]),
        line("aux M146", &["MCODE-29 MCYC-10 STAP-02 STAP-03"]),
        line("rapid return", &[MOTION, all, "MCYC-15 MCYC-16"]),
    ];
    assert_eq!(found.get(4..17), Some(expected.as_slice()));
}

/// Threads of the C axis, in a first block and in others, and G180 behind a chain.
#[test]
fn threads_of_the_c_axis_cite_their_rules() {
    let program = "M110\nG00 X60 Z5 SB=400\nG188 X44 Z-1 C0 F8 SA=5\nX40 K1\nG180\nG186 X40 Z-1 I4 F8\nZ-2\nG180\n\
                   G00 X1 Z1\nM02\n";
    let found = cited(program, &Setup::default());
    let thread = "CAX-05 CTHR-01 CAX-08 feed_length=radius";
    let (chain, single) = ("CTHR-05", "CTHR-03 ");
    let expected = [
        line("rapid position", &[MOTION, chain, "DIA-01 CAX-05 MCYC-05"]),
        line("spindle", &["MCODE-06 SB-03 MCYC-10 CTHR-05"]),
        line("thread cut", &[MOTION, chain, "DIA-01", thread]),
        line("thread cut", &[MOTION, chain, "DIA-01 MCYC-09", thread]),
        line("mode G180", &["GCODE-02 MCYC-01 MCYC-02 MCYC-12"]),
        line("rapid return", &[MOTION, chain]),
        line("mode G186", &["GCODE-02 MCYC-01 CTHR-03"]),
        line("rapid position", &[MOTION, single, "DIA-01 MCYC-05"]),
        line("spindle", &["MCODE-06 SB-03 MCYC-10 CTHR-03"]),
        line("thread cut", &[MOTION, single, "DIA-01", thread]),
        line("rapid retract", &[MOTION, single, "DIA-01"]),
        line("rapid return", &[MOTION, single, "DIA-01"]),
        line("rapid position", &[MOTION, single, "MCYC-05 MCYC-09 CAX-05"]),
        line("thread cut", &[MOTION, single, "MCYC-09", thread]),
    ];
    assert_eq!(found.get(5..19), Some(expected.as_slice()));
}

/// Key ways: one way, with an allowance, on the side.
#[test]
fn key_ways_cite_their_rules() {
    let program = format!("{JOINED}G190 X46 Z0 I10 D3 U1 E10 M214\nG180\nG00 X200 Z200\nM02\n");
    let found = cited(&program, &Setup::default());
    let all = "DIA-01 G190-01 G190-02";
    let pass = "G190-03 keyway_return=cutting_start peck_retract=diameter";
    let plunge = "FEED-02 G01-04 feed_length=radius";
    let code = "MCYC-10 G190-01 G190-02";
    let expected = [
        line("mode G190", &["GCODE-02 MCYC-01 G190-01"]),
        "aux M214: MCODE-38".to_owned(),
        line("spindle", &["MCODE-06 SB-03", code]),
        line("rapid approach", &[MOTION, all, "MCYC-05"]),
        line("aux M147", &["MCODE-29", code]),
        line("linear 1 infeed", &[MOTION, all, pass, plunge, "G190-06"]),
        line("linear 1 cut", &[MOTION, all, pass, PER_MINUTE, "G190-06 MCYC-03"]),
        line("rapid 1 withdraw", &[MOTION, all, pass]),
        line("rapid 1 shift", &[MOTION, all, pass]),
        line("rapid 2 reentry", &[MOTION, all, pass]),
        line("linear 2 infeed", &[MOTION, all, pass, plunge, "G190-07"]),
        line("linear 2 finish", &[MOTION, all, pass, PER_MINUTE, "G190-07 MCYC-03"]),
        line("rapid return", &[MOTION, all, "MCYC-15"]),
        line("rapid return", &[MOTION, all]),
        line("aux M146", &["MCODE-29", code]),
    ];
    assert_eq!(found.get(4..19), Some(expected.as_slice()));
}

/// Inches: a length of the block, which D of a tap is not.
#[test]
fn an_angle_is_no_length() {
    let setup = Setup { unit_system: UnitSystem::Inch, ..Setup::default() };
    let program =
        "M110\nG00 X2 Z1 SB=400\nG178 X2 Z0.2 K0.4 F0.05\nC90 D30\nC180 R-0.1\nG180\nG00 X9 Z9\nM02\n";
    let found = cited(program, &setup);
    let threads: Vec<bool> =
        found.iter().filter(|line| line.starts_with("thread")).map(|line| line.contains("INCH-02")).collect();
    assert_eq!(threads, [true, true, false, false, true, true]);
}

/// The order in which blocks are refused.
#[test]
fn the_first_fault_decides() {
    let setup = Setup::default();
    let drill = format!("{JOINED}G181 X60 Z5 C0 K10\n");
    let spent = format!("{JOINED}G181 X60 Z5 C0 K10 Q2\n");
    let thread = "M110\nG00 X50 Z20 SB=400\nG187 X40 Z10 C0 F20 SA=2\n";
    for (program, wanted) in [
        (format!("{spent}G182 S1\n"), "name=cycle_cancel_missing"),
        (format!("{spent}M02\n"), "name=cycle_cancel_missing"),
        (format!("{spent}G180 V1=1\n"), "name=not_alone rules=E100L-MCYC-02"),
        (format!("{drill}G180\nG96 X1\n"), "name=word_missing rules=E100L-MCYC-13"),
        (format!("{drill}G180\nG180\nM12\nG00 X1 Z1\nM02\n"), "end code=M02"),
        (format!("{drill}G182 G91 M12\n"), "name=unspecified detail=G182"),
        (format!("{drill}G91 G04 S1\n"), "name=cycle_incremental"),
        (format!("{drill}G04 G97 F1 S1\n"), "name=unspecified detail=G04 rules=E100L-MCYC-14"),
        (format!("{drill}M136 T0101 M08 S1\n"), "name=cycle_word detail=T"),
        (format!("{drill}M136 M08 T0101 S1\n"), "name=cycle_word detail=M08"),
        (format!("{drill}S1 M109\n"), "name=cycle_word detail=S"),
        (format!("{drill}G95 F1\nC90\n"), "name=cycle_feed_mode detail=G181 line=5"),
        (format!("{drill}CALRG\n"), "name=word_without_function detail=CALRG"),
        (format!("{drill}QA=1\n"), "name=word_without_function detail=QA"),
        (format!("{drill}I5 K-1\n"), "name=cycle_approach_negative detail=K"),
        (format!("{drill}I5 K1\n"), "name=unspecified detail=I rules=E100L-MCYC-09"),
        (format!("{drill}I0\n"), "name=unspecified detail=I rules=E100L-MCYC-09"),
        (format!("{drill}R-5 Z3\n"), "name=cycle_depth_overdetermined"),
        (format!("{drill}E0.005\n"), "name=address_range rules=E100L-DWELL-02"),
        (format!("{drill}X70 L3\n"), "name=word_without_function detail=L"),
        (format!("{JOINED}G190 X40 Z5 C0 K10 D2 U1\n"), "name=word_without_function detail=U"),
        (format!("{JOINED}G190 X40 Z5 C0 I10 D2 W1\n"), "name=word_without_function detail=W"),
        (format!("{JOINED}G190 X40 Z5 C0 I10 D2 E100000\n"), "name=address_range rules=E100L-ADDR-01"),
        (format!("{thread}Z5 K-1 C5\n"), "name=cycle_approach_negative detail=K"),
        (format!("{thread}Z5 K1 C5\n"), "name=unspecified detail=C rules=E100L-CTHR-04"),
        (format!("{thread}R5\n"), "name=word_without_function detail=R"),
        (format!("{thread}G94 I4\nZ5\n"), "name=cycle_feed_mode detail=G187 line=5"),
        ("G73 X5 D1 F1 J2\n".to_owned(), "name=word_without_function detail=J"),
        ("G04 G77 F1\n".to_owned(), "name=statement_misplaced detail=G77"),
        ("V1=1 G78 X1 Z1 K1\n".to_owned(), "name=statement_misplaced detail=G78"),
        ("G77 G78 X1 Z1 K1\n".to_owned(), "name=statement_misplaced detail=G78"),
        ("G77 G73 X1 Z1 K1\n".to_owned(), "name=g_codes_conflict"),
        ("G181 G182 X1\n".to_owned(), "name=g_codes_conflict"),
        ("G73 X5 D1 I-1 K-1 L-1\n".to_owned(), "name=unspecified detail=I rules=E100L-GRV-03"),
        ("G74 Z-5 D1 I-1 K-1 L-1\n".to_owned(), "name=unspecified detail=I rules=E100L-GRV-06"),
        ("G74 Z-5 D1 L-1 DA=-1\n".to_owned(), "name=address_range rules=E100L-GRV-05"),
        ("G73 X-5 D1 R1\n".to_owned(), "name=word_without_function detail=R"),
        ("M110\nG94 F1\nG181 X1 Z-9 K1 M147 SB=5\n".to_owned(), "name=cycle_word detail=M147"),
        ("M110\nG94\nG181 X1 Z-9 K1 SB=5\n".to_owned(), "name=no_feed"),
        ("M110\nG95 F1\nG94 G178 X1 Z-9 K1 SB=5\n".to_owned(), "end"),
    ] {
        if wanted == "end" {
            ends_with(&program, &setup, "alarm name=no_program_end");
        } else {
            ends_with(&program, &setup, wanted);
        }
    }
}

/// E100L-NRC-81: in compensation, where it ends, and while it is left over; G33 in the block is no matter.
#[test]
fn compensation_refuses_them() {
    let setup = Setup::default();
    let on = "G42 G01 X100 Z100 F0.2\n";
    for (program, wanted) in [
        (format!("{on}G77 X0 Z1 K1\n"), "name=compensation_not_allowed detail=G77"),
        (format!("{on}G33 G74 Z1 D1\n"), "name=compensation_not_allowed detail=G74"),
        (format!("{on}G40 G73 X90 D1\n"), "name=unspecified detail=G73 rules=E100L-NRC-81"),
        (format!("{on}X90\nG40\nG73 X80 D1\n"), "name=unspecified detail=G73 rules=E100L-NRC-81"),
        ("G42 G73 X90 D1 F1\n".to_owned(), "name=compensation_not_allowed detail=G73"),
        (format!("{on}G181 X0 Z1 K1\n"), "name=cycle_feed_mode"),
        (format!("{on}G94 G181 X0 Z1 K1\n"), "name=compensation_not_allowed detail=G181"),
    ] {
        ends_with(&program, &setup, wanted);
    }
}

/// These blocks are no next block of a corner, and begin no modal call; a corner of before is left behind.
#[test]
fn corners_and_modal_calls() {
    let mut setup = Setup::default();
    let corner = "G01 X20 Z0 F0.1\nG75 Z-20 L2\n";
    ends_with(&format!("{corner}G73 X10 D5\nM02\n"), &setup, "name=angle_lookahead line=2");
    ends_with(&format!("{corner}G94 G181 X10 R5 K1\nM02\n"), &setup, "name=angle_lookahead line=2");
    setup.parameters.chamfering = turnspec_oracle::vocabulary::Chamfering::Basic;
    let events = texts(&format!("{corner}G91 G74 Z-5 D9\nG90\nM02\n"), &setup);
    // The chamfer ends at X24 Z-20, whatever its corner is.
    assert!(
        events.iter().any(|event| event.contains("part=cut") && value(event, "z") == "-25"),
        "{events:#?}"
    );
    setup.library.insert("A.SUB".to_owned(), turnspec_oracle::vocabulary::ProgramText(b"O5\nRTS\n".to_vec()));
    let program = "G00 X10 Z0\nMODIN O5\nG73 X5 D9 F1\nMODOUT\nM02\n";
    assert!(!texts(program, &setup).iter().any(|event| event.starts_with("call")));
}

/// The motion mode is in force again after the cycle; F of a cycle in a thread mode is no lead.
#[test]
fn a_thread_mode_stays() {
    let setup = Setup::default();
    let program = "M110\nG00 X60 Z20 SB=400\nG33\nG94 G181 X60 Z5 K10 F100000\n";
    ends_with(program, &setup, "name=address_range");
    let program = "M110\nG00 X60 Z20 SB=400\nG33\nG94 G181 X60 Z5 K10 F50000\nG180\nG00 X1 Z1\nM02\n";
    ends_with(program, &setup, "end code=M02");
    let program = "G00 X60 Z20\nG33\nG73 X50 D4 F0.1\nM02\n";
    assert_eq!(texts(program, &setup).iter().filter(|event| event.contains("part=cut")).count(), 3);
}

/// E100L-GOTO-03: each cutting pass of a block but its first is a step, before its spindle has turned back.
#[test]
fn passes_are_steps() {
    for (cycle, all, steps, last) in [
        ("G181 X60 Z5 C0 K10 Q3", 5, 3, "aux code=M147"),
        ("G183 X60 Z4 C0 K10 D2", 5, 4, "rapid pass=2 part=retract"),
        ("G190 X40 Z4 C0 K10 D2", 5, 4, "rapid pass=3 part=reentry"),
        ("G190 X40 Z4 C0 K10 D2 M212", 5, 4, "linear pass=2 part=cut"),
        ("G178 X60 Z4 C0 K10 Q2", 4, 3, "spindle state=cw"),
    ] {
        let program = format!("{JOINED}{cycle}\nG180\n");
        let mut setup = Setup::default();
        setup.limits.steps = all;
        ends_with(&program, &setup, "name=step_limit line=4");
        setup.limits.steps = steps;
        let events = texts(&program, &setup);
        ends_with(&program, &setup, "name=step_limit line=3");
        let before = events.iter().rev().nth(1).map_or("", String::as_str);
        assert!(last.split(' ').all(|word| before.split(' ').any(|each| each == word)), "{before}\n{last}");
    }
}

/// E100L-TAP-07: with turret B the senses are those of M03 and M04 there.
#[test]
fn taps_on_the_opposite_turret() {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoTurrets;
    let events = texts("G14\nS100\nG77 X0 Z-5 K1 F1\nG73 X-8 D9\nM02\n", &setup);
    let senses: Vec<&str> =
        events.iter().filter(|event| event.contains("TAP-01")).map(|event| value(event, "state")).collect();
    assert_eq!(senses, ["ccw", "-", "-", "stop", "cw", "-", "-", "stop"]);
    let motions = events.iter().filter(|event| event.contains("part="));
    assert!(motions.clone().count() > 4 && motions.clone().all(|event| event.contains("MIRR-05")));
}

/// Grooves of a saddle follow each other without the other saddle between.
#[test]
fn two_saddles_groove() {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoSaddles;
    let program = "G13\nG00 X60\nG73 X50 D4 F0.1\nG77 X0 Z-5 K1 S100 P5\nG14\nG74 Z-9 D3 F0.1 S100 P5\nM02\n";
    let events = texts(program, &setup);
    let cuts: Vec<&str> = events
        .iter()
        .filter(|event| event.contains("part=cut"))
        .map(|event| value(event, "saddle"))
        .collect();
    assert_eq!(cuts, ["A", "A", "A", "A", "B", "B", "B"]);
    assert_eq!(events.last().map(|event| kind(event)), Some("end"));
}

/// E100L-MCYC-15, E100L-G184-02 by parameters, and limits on a position.
#[test]
fn parameters_and_limits() {
    let mut setup = Setup::default();
    setup.parameters.cycle_return = CycleReturn::CycleStart;
    setup.parameters.g184_tapping = G184Tapping::Synchronised;
    let events = texts(&format!("{JOINED}G184 X60 Z5 K10 F500\nG180\nG00 X9 Z9\nM02\n"), &setup);
    assert!(events.iter().any(|event| value(event, "part") == "return" && value(event, "z") == "20"));
    assert!(events.iter().any(|event| value(event, "lead") == "1.25"));
    setup.limits.x = Limit { positive: Some(Length(65_000_000)), negative: None };
    ends_with(
        &format!("{JOINED}G184 X70 Z5 K10 F500\n"),
        &setup,
        "name=travel_limit_positive rules=E100L-LIM-01",
    );
}

fn number() -> impl Strategy<Value = String> {
    prop::sample::select(vec![
        "0",
        "0.001",
        "1",
        "-1",
        "2.5",
        "-2.5",
        "7",
        "-30",
        "90",
        "359.999",
        "99999.999",
        "-99999.999",
        "9999",
    ])
    .prop_map(str::to_owned)
}

fn any_block() -> impl Strategy<Value = String> {
    let code = prop::sample::select(vec![
        "", "", "G73", "G74", "G77", "G78", "G178", "G179", "G180", "G181", "G182", "G183", "G184", "G185",
        "G186", "G187", "G188", "G189", "G190",
    ]);
    let letter = prop::sample::select(vec![
        "X", "Z", "C", "R", "I", "K", "D", "L", "E", "F", "J", "Q", "W", "U", "DA=", "SA=", "SB=", "M", "T",
        "G9",
    ]);
    let word = (letter, number()).prop_map(|(letter, number)| match letter {
        "M" => ["M136", "M141", "M212", "M214", "M16"][number.len() % 5].to_owned(),
        "G9" => ["G90", "G91", "G94", "G95"][number.len() % 4].to_owned(),
        "T" => "T0002".to_owned(),
        _ => format!("{letter}{number}"),
    });
    (code, prop::collection::vec(word, 0..9)).prop_map(|(code, words)| format!("{code}{}\n", words.concat()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    /// Whatever the words, a program ends, and soon.
    #[test]
    fn every_program_ends(blocks in prop::collection::vec(any_block(), 1..6), g94: bool, joined: bool, system in 0_usize..5) {
        let mut setup = Setup::default();
        setup.limits.steps = 60;
        setup.unit_system = [
            UnitSystem::Millimetre,
            UnitSystem::Micrometre,
            UnitSystem::TenMicrometre,
            UnitSystem::Inch,
            UnitSystem::TenThousandthInch,
        ][system];
        setup.options.w_axis = g94;
        let joined = if joined { "M110\n" } else { "" };
        let feed = if g94 { "G94" } else { "G95" };
        let events = texts(&format!("S100 SB=300 SA=2 F2\n{joined}{feed}\n{}M02\n", blocks.concat()), &setup);
        let last = events.last().map_or("", String::as_str);
        prop_assert!(matches!(kind(last), "end" | "alarm"), "{last}");
        prop_assert!(events.len() < 60 * 12);
    }

    /// E100L-GRV-04, E100L-GRV-05: each peck goes D deeper than the one before, the last to the bottom, and a
    /// withdrawal comes exactly when L has been reached.
    #[test]
    fn pecks_reach_the_bottom(depth in 1_i64..40_000, infeed in 400_i64..9_000, discharge in 1_i64..20_000) {
        let mm = |value: i64| format!("{}.{:03}", value / 1_000, value % 1_000);
        let program = format!("G00 Z0\nG74 Z-{} D{} L{} F1\nM02\n", mm(depth), mm(infeed), mm(discharge));
        let events = texts(&program, &Setup::default());
        let level = |event: &String| Length::parse(value(event, "z")).map_or(0, |z| -z.0 / 1_000);
        let (mut reached, mut since) = (0, 0);
        for event in events.iter().filter(|event| value(event, "pass") != "-") {
            match value(event, "part") {
                "cut" => {
                    prop_assert_eq!(level(event), (reached + infeed).min(depth));
                    since += level(event) - reached;
                    reached = level(event);
                }
                "withdraw" => {
                    prop_assert!(since >= discharge && reached < depth);
                    since = 0;
                }
                "retract" => prop_assert!(since < discharge && reached < depth),
                _ => {}
            }
        }
        prop_assert_eq!(reached, depth);
    }
}
