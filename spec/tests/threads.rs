//! Threads: what their events cite, laws of their passes, and what goes on between blocks. The examples of the rule texts
//! hold besides.

mod support;

use proptest::prelude::*;
use support::trace;
use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{
    Action, BalancedInfeed, Chamfering, Ending, Event, FeedLength, Length, Limit, MachineType, Part, Setup,
    Side, UnitSystem,
};

/// Kind, part and rules of each event.
fn cited(program: &str, setup: &Setup) -> Vec<String> {
    let line = |event: &Event| {
        let text = render(event);
        let kind = text.split(' ').next().unwrap_or_default().to_owned();
        let part = match part(event) {
            Some((pass, part)) => format!(" {pass} {}", part.as_str()),
            None => String::new(),
        };
        let rules = event.rules.as_slice().iter().filter_map(|rule| rule.as_str().strip_prefix("E100L-"));
        let readings = event.readings.iter().map(|reading| format!(" {}", reading.as_str()));
        let head = rules.fold(kind + &part, |line, rule| line + " " + rule);
        readings.fold(head, |line, reading| line + &reading)
    };
    trace(program, setup).iter().map(line).collect()
}

fn part(event: &Event) -> Option<(u32, Part)> {
    match event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } | Action::Thread { motion, .. } => {
            motion.pass.zip(motion.part)
        }
        _ => None,
    }
}

/// The last event of a program in compact notation.
fn last(program: &str, setup: &Setup) -> String {
    trace(program, setup).last().map(render).unwrap_or_default()
}

fn ends_with(program: &str, setup: &Setup, wanted: &str) {
    support::ends_with(program, wanted, setup);
}

/// All that the events of a single pass cite, and nothing else.
#[test]
fn a_pass_cites_its_rules() {
    let program = "G00 X60 Z80 S1000 M03 M23\nG91 G31 X-43 Z-30 I5 K1 E0.1 F3 J2 C90 L2\nX-42\nM02\n";
    let found = cited(program, &Setup::default());
    let passes: Vec<&str> = found
        .iter()
        .map(String::as_str)
        .filter(|line| line.contains(" G33-02") && !line.starts_with("mode"))
        .collect();
    let all = "COORD-03 ABS-02 ABS-03 DIA-01";
    let expected = ["1", "2"].map(|pass| {
        let kept = if pass == "1" { "G33-04" } else { "G33-03 G33-04" };
        let work = "G33-05 G33-07";
        let readings = "taper_reference=start thread_shift=toward_end";
        let cut = format!("{all} G33-02 {kept} {work} G33-08 G33-09 G33-10 THRD-06");
        [
            format!("rapid {pass} approach {all} G33-02 {kept} {work} {readings}"),
            format!("thread {pass} cut {cut} {readings}"),
            format!("thread {pass} exit {cut} TCHM-01 TCHM-02 TCHM-03 TCHM-04 feed_length=radius {readings}"),
            format!("linear {pass} retract {all} G01-04 G33-02 {kept} {work} TCHM-03 feed_length=radius {readings}"),
            format!("rapid {pass} return {all} G33-02 {kept}"),
        ]
    });
    same_words(&passes, &expected.concat());
}

/// The same of a pass on the face, without what does not act.
#[test]
fn a_pass_on_the_face_cites_its_rules() {
    let found = cited("G00 X60 Z5\nG32 X20 Z-1 F2\nZ-2 L3 M22\nM02\n", &Setup::default());
    let passes: Vec<&str> =
        found.iter().map(String::as_str).filter(|line| line.contains(" G32-02")).collect();
    let expected = [("1", "DIA-01 G32-02"), ("2", "G32-02 G32-04")].map(|(pass, own)| {
        let all = format!("COORD-03 ABS-01 {own}");
        [
            format!("rapid {pass} approach {all}"),
            format!("thread {pass} cut {all} G32-03 feed_length=radius"),
            format!("linear {pass} retract {all} G01-04 TCHM-03 feed_length=radius"),
            format!("rapid {pass} return {all}"),
        ]
    });
    same_words(&passes, &expected.concat());
}

/// All that the events of a compound cycle cite.
#[test]
fn a_compound_cycle_cites_its_rules() {
    let program = "G00 X60 Z80 S1000 M03 M23\n\
                   G71 X20 Z10 A175 B60 D1 U0.1 H1.5 L2 E0.1 F3 Q2 M33 M74\nM02\n";
    let found = cited(program, &Setup::default());
    let cycle: Vec<&str> = found.iter().map(String::as_str).filter(|line| line.contains(" G71-01")).collect();
    let all = "COORD-03 ABS-01 DIA-01 G71-01 G71-03 TMUL-02";
    let mut expected = Vec::new();
    for pass in 1..=3 {
        let depth = if pass == 3 {
            "G71-07"
        } else {
            "TINF-01 TINF-03 TMOD-01 TMOD-02 TMOD-04 thread_flank=negative"
        };
        let work = format!("{all} G33-06 G71-04 G71-02 TINF-08 {depth} taper_reference=start");
        for start in ["", " TMUL-01"] {
            let cut = format!("{work} G33-08 G33-09 G71-05{start}");
            expected.push(format!("rapid {pass} approach {work} G71-10"));
            expected.push(format!("thread {pass} cut {cut}"));
            expected.push(format!(
                "thread {pass} exit {cut} TCHM-01 TCHM-02 TCHM-03 TCHM-04 G71-06 feed_length=radius"
            ));
            expected.push(format!("linear {pass} retract {work} TCHM-03 G01-04 feed_length=radius"));
            let end = if pass == 3 && !start.is_empty() { " G71-08" } else { "" };
            expected.push(format!("rapid {pass} return {all}{end}"));
        }
    }
    same_words(&cycle, &expected);
}

/// The lines have the same words, in whatever order behind the first one.
fn same_words(found: &[&str], expected: &[String]) {
    let sorted = |line: &str| {
        let mut words: Vec<String> = line.split(' ').map(str::to_owned).collect();
        words.get_mut(1..).unwrap_or_default().sort();
        words
    };
    let found: Vec<_> = found.iter().map(|line| sorted(line)).collect();
    let expected: Vec<_> = expected.iter().map(|line| sorted(line)).collect();
    assert_eq!(found, expected);
}

/// E100L-G34-03, E100L-G34-05: what a leg cites depends on F, C, E, M27 and the angle of its own block.
#[test]
fn a_leg_cites_its_rules() {
    let program = "G00 X30 Z80\nG34 Z70 F2 C10\nG91 Z-10 A170 E0.1\nX-2 Z-1 M27\nM02\n";
    let found = cited(program, &Setup::default());
    let legs: Vec<&str> =
        found.iter().map(String::as_str).filter(|line| line.starts_with("thread")).collect();
    let all = "thread COORD-03 G34-01 G34-04";
    let expected = [
        format!("{all} ABS-01 G34-05"),
        format!("{all} ABS-02 G34-02 G34-03 G33-09 ANG-01 ANG-02 DTAP-03 DTAP-05"),
        format!("{all} ABS-02 ABS-03 DIA-01 G34-03 feed_length=radius"),
    ];
    same_words(&legs, &expected);
}

/// E100L-G33-03: what ends a cycle and what leaves it.
#[test]
fn codes_of_the_motion_group_end_a_cycle() {
    let setup = Setup::default();
    let begin = "G00 X40 Z80\nG33 X29 Z50 F1.5\n";
    for (between, wanted) in [
        ("G04 F1\nG50 S1000\nT0101\n", "end code=M02"),
        ("G33\n", "alarm name=word_missing rules=E100L-G33-01"),
        ("G31\n", "alarm name=word_missing rules=E100L-G33-01"),
        ("G32\n", "alarm name=word_missing rules=E100L-G32-01"),
        ("G00\nG33\n", "alarm name=word_missing rules=E100L-G33-01"),
    ] {
        ends_with(&format!("{begin}{between}X28\nM02\n"), &setup, wanted);
    }
}

/// E100L-G34-05: a torque skip and a compound cycle interrupt a run of G34 and G35, a dwell does not.
#[test]
fn what_moves_in_between_ends_a_run_of_legs() {
    for (between, starts) in
        [("G04 F1\n", false), ("G35\n", false), ("G71 X20 Z60 D1 H1 M74\n", true), ("G34 X31 Z68\n", false)]
    {
        let program = format!("G00 X30 Z80\nG34 Z70 F2 C10\n{between}Z65 X33 C20\nM02\n");
        let events = trace(&program, &Setup::default());
        let mut threads = events.iter().filter_map(|event| match event.action {
            Action::Thread { start, .. } => Some(start),
            _ => None,
        });
        assert_eq!(threads.next_back().map(|start| start.is_some()), Some(starts), "{between}");
    }
}

/// E100L-THRD-04: in G94 an F word beside a thread code, or in a thread mode, is a lead; one before is none.
#[test]
fn the_lead_in_g94() {
    let setup = Setup::default();
    let behind = "X29 Z50\nM02\n";
    for (before, wanted) in [
        ("G94 G01 F100 X40 Z80\nG33\n", "alarm name=no_feed rules=E100L-THRD-04"),
        ("G94 X40 Z80\nG33 F1.5\n", "end"),
        ("G94 X40 Z80\nG33\nF1.5\n", "end"),
        ("G94 X40 Z80\nG33 F0.001\nF1.5 G50 S100\n", "alarm name=no_feed"),
        ("G94 X40 Z80\nG71 X29 Z50 F1.5 D1 H1 M74\nG33\n", "end"),
        // 0.0005 mm per revolution.
        ("G94 X40 Z80\nG33 F.0005\n", "alarm name=address_range rules=E100L-ADDR-01"),
    ] {
        ends_with(&format!("{before}{behind}"), &setup, wanted);
    }
}

/// A corner is between two lines; an angle alone ends on a line.
#[test]
fn look_ahead_refuses_threads() {
    let any_angle = Setup::default();
    for (program, wanted) in [
        ("G01 G75 X10 Z10 L1 F1\nG33 X29 Z50\nM02\n", "alarm name=chamfer_corner"),
        ("G01 G75 X10 Z10 L1 F1\nG71 X29 Z50 D1 H1 M74\nM02\n", "alarm name=angle_lookahead"),
        ("G01 A45 F1\nG34 X29 A20\nM02\n", "alarm name=angle_lookahead"),
        ("G01 A45 F1\nG33 X29\nM02\n", "alarm name=word_missing block=- rules=E100L-G33-01"),
        ("G33 F1\nG75 X10 L1\nM02\n", "alarm name=chamfer_not_linear"),
    ] {
        let wanted = wanted.replace(" block=-", "");
        ends_with(program, &any_angle, &wanted);
    }
}

/// What legs cite that have an angle alone, or follow on one (E100L-ANG-06).
#[test]
fn an_angle_alone_cites_its_rules() {
    let program =
        "G00 X30 Z80\nG34 A135 F2 C10\nG91 X20 Z-40 A180\nG90 G01 A135\nG35 X60 Z10 A180 J2 C9\nM02\n";
    let found = cited(program, &Setup::default());
    let legs: Vec<&str> =
        found.iter().map(String::as_str).filter(|line| line.starts_with("thread")).collect();
    let all = "thread COORD-03 G34-01 G34-04 ANG-01 ANG-06";
    let expected = [
        format!("{all} ABS-01 G34-05"),
        format!("{all} ABS-02 ABS-03 DIA-01 G34-03"),
        format!("{all} ABS-01 DIA-01 G34-03 G34-05 THRD-06"),
    ];
    same_words(&legs, &expected);
}

/// E100L-ANG-06: where legs end whose corner follows from the next block.
#[test]
fn an_angle_alone_ends_on_the_next_line() {
    let setup = Setup::default();
    for (program, points) in [
        // In G91 the next block counts from where the first one starts, and the one behind it from its end.
        (
            "G00 X30 Z80\nG34 A135 F1\nG91 X20 Z-40 A180\nX2 Z-1\nM02\n",
            &["x=30 z=80", "x=50 z=70", "x=50 z=40", "x=52 z=39"][..],
        ),
        (
            "G00 X30 Z80\nG35 A-45 F1\nG34 X50 Z40 A0 E1 J2 C9 M26\nM02\n",
            &["x=30 z=80", "x=50 z=70", "x=50 z=40"],
        ),
        (
            "G00 X30 Z80\nG34 A180 F1\nG90 G01 X50 Z60 A135 F2\nM02\n",
            &["x=30 z=80", "x=30 z=70", "x=50 z=60"],
        ),
        (
            "G00 X30 Z80\nA135\nG34 X50 Z40 A180 F2\nX60 Z39\nM02\n",
            &["x=30 z=80", "x=50 z=70", "x=50 z=40", "x=60 z=39"],
        ),
        // The next block is rounded itself.
        (
            "G00 X30 Z80\nG34 A135 F1\nG01 G75 X50 Z40 A180 L5\nX60\nM02\n",
            &["x=30 z=80", "x=50 z=70", "x=50 z=45", "x=60 z=40", "x=60 z=40"],
        ),
        // A corner, an angle alone behind it, a leg.
        (
            "G00 X10 Z80\nG01 G75 X30 L5 F1\nA180\nG34 X50 Z60 A135\nM02\n",
            &["x=10 z=80", "x=20 z=80", "x=30 z=75", "x=30 z=70", "x=50 z=60"],
        ),
    ] {
        let events = trace(program, &setup);
        let moved = events.iter().map(render).filter(|event| event.contains(" x="));
        let found: Vec<String> =
            moved.map(|event| event.split(' ').skip(1).take(2).collect::<Vec<_>>().join(" ")).collect();
        assert_eq!(found, points, "{program}");
        assert!(last(program, &setup).starts_with("end "), "{program}");
    }
}

/// In G88 such legs are read like others (E100L-AP3-01), and look-ahead ends with G80.
#[test]
fn an_angle_alone_in_a_thread_of_lap() {
    let mut setup = Setup::default();
    let definition =
        |lines: &str| format!("G00 X60 Z90\nNQ1 G81\nG00 X30 Z80\n{lines}\nG88 NQ1 D1 H1 M74\nM02\n");
    for (lines, wanted) in [
        ("G34 A135 F1\nX50 Z40 A180 E1 C9 J2\nG80", "end code=M02"),
        ("G34 A135 F1\nX50 Z40 A180 G80", "end code=M02"),
        ("G34 A135 F1\nG01 X50 Z40 A180 E1\nG80", "end code=M02"),
        ("G34 Z70 F1\nG01 A135\nG34 X50 Z40 A180\nG80", "end code=M02"),
        ("G34 A135 F1\nG80", "alarm name=angle_lookahead line=4 rules=E100L-ANG-06"),
        ("G34 A135 F1\nG00 X50 Z40 A180\nG80", "alarm name=contour_malformed detail=G00 line=5"),
        ("G34 A135 F1\nX50 Z40 A180 M08\nG80", "alarm name=contour_malformed detail=M08 line=5"),
        ("G34 A135 F1\nG01 X50 Z40 A180 C1\nG80", "alarm name=contour_malformed detail=C line=5"),
    ] {
        ends_with(&definition(lines), &setup, wanted);
    }
    let behind = "G00 X60 Z90\nG88 NQ1 D1 H1 M74\nM02\nNQ1 G81\nG00 X30 Z80\nG34 A135 F1 G80\nX50 Z40 A180\n";
    ends_with(behind, &setup, "alarm name=angle_lookahead line=6 rules=E100L-ANG-06");
    let read = trace(&definition("G34 A135 F1\nX50 Z40 A180\nG80"), &setup);
    let legs: Vec<String> = read.iter().map(render).filter(|event| event.starts_with("thread ")).collect();
    assert!(legs.len() == 2 && legs[0].starts_with("thread x=50 z=70 "), "{legs:?}");
    assert!(legs[1].starts_with("thread x=50 z=40 "), "{legs:?}");
    setup.parameters.chamfering = Chamfering::Off;
    let wanted = "alarm name=angle_underdetermined line=4 rules=E100L-DTAP-01";
    ends_with(&definition("G34 A135 F1\nX50 Z40 A180\nG80"), &setup, wanted);
}

/// An angle alone in a leg: what is wrong with it, and in which order that is found.
#[test]
fn an_angle_alone_is_refused_in_order() {
    let setup = Setup::default();
    let (blind, level) = (
        "alarm name=angle_lookahead line=2 rules=E100L-ANG-06",
        "alarm name=angle_no_intersection line=2 rules=E100L-ANG-06",
    );
    for (lines, wanted) in [
        // The lead, look-ahead, the corner, the length, the lead at the end.
        ("G34 A135\nX9", "alarm name=no_feed line=2 rules=E100L-THRD-04"),
        ("G34 A135 F0.001 J9\nX9", "alarm name=thread_lead_range line=2 rules=E100L-THRD-04"),
        ("G34 A90 F1\nX50 Z40", blind),
        ("G35 A90 F1 E9\nX50 Z40 A270", level),
        ("G34 A90 F1\nX50 Z40 A180", "alarm name=unspecified detail=length line=2 rules=E100L-G34-04"),
        ("G35 A135 F1 E9\nX50 Z40 A180", "alarm name=thread_lead_range line=2 rules=E100L-G33-09"),
        // What the next block may be.
        ("G34 A135 F1\nX50 A180", blind),
        ("G34 A135 F1\nA180", blind),
        ("G34 A135 F1\nG33 X50 Z40 A180", blind),
        ("G34 A135 F1\nG02 X50 Z40 L99", blind),
        ("G34 A135 F1\nX50 Z40 A180 T0101", blind),
        ("G34 A135 F1\nG97 S100 X50 Z40 A180", blind),
        ("G34 A135 F1\nV1=1 X50 Z40 A180", blind),
        ("G01 A135 F1\nG34 X50 Z40", blind),
        ("G34 A135 F1\nG71 X50 Z40 A180 D1 H1 M74", blind),
        ("G34 A135 F1\nIF [1 EQ 1] N9\nN9", "alarm name=unspecified detail=IF line=3 rules=E100L-ANG-06"),
        ("G01 G75 A135 L1 F1\nG34 X50 Z40 A180", "alarm name=chamfer_corner line=2 rules=E100L-ANG-07"),
        ("G01 G75 X50 L1 F1\nG34 A135\nX60 Z40 A180", "alarm name=chamfer_corner line=2 rules=E100L-ANG-07"),
        ("G01 G75 X50 L1 F1\nA135\nG34 X60 Z40", "alarm name=angle_lookahead line=3 rules=E100L-ANG-06"),
        // Its faults have its place.
        ("G34 A135 F1\nX50 Z40 A180 E-1", "alarm name=address_range line=3 rules=E100L-G34-02"),
        ("G34 A135 F1\nX50 Z40 A180 J1.5", "alarm name=unspecified detail=J line=3 rules=E100L-THRD-06"),
        (
            "G34 A135 F1\nX50 Z40 A180 L1",
            "alarm name=word_without_function detail=L line=3 rules=E100L-ADDR-01",
        ),
        ("G34 A135 F1\nG75 X50 Z40 A180 L1", "alarm name=chamfer_not_linear line=3 rules=E100L-CHAM-05"),
        ("G34 A135 F1\nG01 X50 Z40 A180 C9", "alarm name=angle_overdetermined line=3 rules=E100L-DTAP-01"),
        ("G01 A135 F1\nG96 S100 G34 X50 Z40 A180", "alarm name=thread_in_constant_speed detail=G34 line=3"),
        // Only the block behind it may have all three.
        (
            "G34 A135 F1\nX50 Z40 A180\nX60 Z30 A135",
            "alarm name=angle_overdetermined line=4 rules=E100L-DTAP-01",
        ),
    ] {
        ends_with(&format!("G00 X30 Z80\n{lines}\nM02\n"), &setup, wanted);
    }
    ends_with("G00 X30 Z80\nG34 A135 F1", &setup, blind);
}

/// A thread counts from the present point, not from the corner of a chamfer before, and leaves that behind.
#[test]
fn a_corner_before_is_forgotten() {
    let mut setup = Setup::default();
    setup.parameters.chamfering = Chamfering::Basic;
    let events = trace("G00 X0 Z0\nG01 G75 X20 L-2 F1\nG91 G34 Z-10\nG01 X1\nM02\n", &setup);
    let at = |line| events.iter().rfind(|event| event.block.line == line).map(render).unwrap_or_default();
    assert!(at(3).starts_with("thread x=20 z=-12 "), "{}", at(3));
    assert!(at(4).starts_with("linear x=21 z=-12 "), "{}", at(4));
    assert!(!at(3).contains("CHAM-13") && !at(4).contains("CHAM-13"));
}

/// E100L-THRD-10: a limit takes the place of no end, be it that of the approach or of the thread.
#[test]
fn limits_stop_a_pass() {
    let mut setup = Setup::default();
    setup.limits.z = Limit { positive: Some(Length(80_000_000)), negative: None };
    for (word, wanted) in [("K-1", "travel_limit_positive"), ("K1", "end")] {
        let program = format!("G00 X40 Z80\nG33 X29 Z50 F1.5 {word}\nM02\n");
        let found = last(&program, &setup);
        assert!(found.contains(wanted), "{found}");
    }
}

/// E100L-BARR-01: each motion of a pass is tested before its event.
#[test]
fn barriers_stop_a_pass() {
    let mut setup = Setup::default();
    setup.barriers.jaw_length = Length(10_000_000);
    setup.barriers.jaw_height = Length(50_000_000);
    let events = trace("G00 X100 Z80\nG33 X20 Z-5 F1.5 M25\nM02\n", &setup);
    let parts: Vec<_> = events.iter().filter_map(part).collect();
    let alarm = events.last().map(render).unwrap_or_default();
    assert!(alarm.starts_with("alarm name=barrier detail=chuck"), "{alarm}");
    assert_eq!(parts, [(1, Part::Approach)]);
}

/// E100L-G71-10: the passes of a cycle are steps, and each comes in its turn: what a step emits is bounded.
#[test]
fn passes_come_one_by_one() {
    let mut setup = Setup::default();
    setup.limits.steps = 1_000;
    let mut run = Run::new(b"G00 X99990 Z80\nG71 X0 Z10 D0.001 H90000 Q9999 F1 M74\nM02\n", &setup);
    let mut steps = 0;
    loop {
        let mut events = 0;
        let ending = run.step(&mut |_: &Event| events += 1);
        steps += 1;
        assert!(events <= 6, "{events}");
        if ending.is_some() {
            assert_eq!((ending, steps), (Some(Ending::Alarm), 1_001));
            break;
        }
    }
}

/// E100L-PSYNC-03: of two cycles that start together that of side A comes first, all of it; M100 waits behind the last
/// pass.
#[test]
fn cycles_of_two_saddles_follow_each_other() {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoSaddles;
    let cycle = "G00 X30 Z40\nG71 X20 Z10 D1 H2 F1 M74 P10\nG71 X20 Z10 D1 H1 F1 M74 M100\nM02\n";
    let events = trace(&format!("G13\n{cycle}G14\n{cycle}"), &setup);
    let of = |event: &Event| match event.action {
        Action::Thread { .. } => Some('t'),
        Action::Wait { .. } => Some('w'),
        Action::Release { .. } => Some('r'),
        Action::End { .. } => Some('e'),
        _ => None,
    };
    let order: Vec<(char, Option<Side>)> =
        events.iter().filter_map(|event| of(event).map(|kind| (kind, event.saddle))).collect();
    let expected = "wa wb ra rb ta ta tb tb ta wa tb wb ra rb ea";
    let expected: Vec<(char, Option<Side>)> = expected
        .split(' ')
        .filter_map(|word| word.chars().next())
        .zip(expected.split(' ').map(|word| Some(if word.ends_with('a') { Side::A } else { Side::B })))
        .collect();
    let kinds = |list: &[(char, Option<Side>)]| list.iter().map(|(kind, _)| *kind).collect::<String>();
    assert_eq!(kinds(&order), kinds(&expected));
    let threads = |list: &[(char, Option<Side>)]| {
        list.iter().filter(|(kind, _)| *kind == 't').map(|(_, side)| *side).collect::<Vec<_>>()
    };
    assert_eq!(threads(&order), threads(&expected));
}

/// The depths of a cycle with these words, in nanometres, from its cuts.
fn depths(words: &str, height: i64, setup: &Setup) -> Vec<i64> {
    let events = trace(&format!("G00 X1000 Z100\nG71 X0 Z0 F1 {words}\nM02\n"), setup);
    assert!(matches!(events.last().map(|event| event.action), Some(Action::End { .. })), "{words}");
    let cut = |event: &Event| match event.action {
        Action::Thread { motion, .. } => Some(height - motion.program.x.0),
        _ => None,
    };
    events.iter().filter_map(cut).collect()
}

fn words(step: i64, height: i64, allowance: i64) -> String {
    let mm = |value: i64| format!("{}.{:03}", value / 1_000, value % 1_000);
    format!("D{} H{} U{}", mm(step), mm(height), mm(allowance))
}

fn pattern() -> impl Strategy<Value = (i64, i64, i64)> {
    (200_i64..3_000, 2_000_i64..12_000, prop_oneof![Just(0), 1_i64..900])
}

/// A block of thread cutting with words of any size.
fn any_block() -> impl Strategy<Value = String> {
    let code = prop_oneof![
        Just(""),
        Just("G31"),
        Just("G32"),
        Just("G33"),
        Just("G34"),
        Just("G35"),
        Just("G71"),
        Just("G72")
    ];
    let dimension = prop_oneof![Just(""), Just("G90"), Just("G91")];
    let value = prop_oneof![
        Just("0"),
        Just(".001"),
        Just("1"),
        Just("-1.5"),
        Just("2"),
        Just("30"),
        Just("-40"),
        Just("89.999"),
        Just("90"),
        Just("179.999"),
        Just("359.999"),
        Just("1000"),
        Just("-99999.999"),
        Just("99999.999"),
    ];
    let letters = prop::sample::subsequence("XZIKALEJCBDUHWQF".chars().collect::<Vec<_>>(), 0..9);
    let m = prop_oneof![
        Just(""),
        Just("M27"),
        Just("M23"),
        Just("M33"),
        Just("M34"),
        Just("M73"),
        Just("M74"),
        Just("M75")
    ];
    (code, dimension, letters, prop::collection::vec(value, 9), m).prop_map(
        |(code, dimension, letters, values, m)| {
            let words: String =
                letters.iter().zip(values).map(|(letter, value)| format!("{letter}{value}")).collect();
            format!("{dimension}{code}{words}{m}\n")
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Whatever the words, a program ends, and soon.
    #[test]
    fn every_program_ends(blocks in prop::collection::vec(any_block(), 1..5), at in prop::sample::select(vec!["X40Z80", "X0Z0", "X99999.999Z-99999.999"]), inch: bool) {
        let mut setup = Setup::default();
        setup.limits.steps = 50;
        setup.readings.balanced_infeed = BalancedInfeed::EqualArea;
        if inch {
            setup.unit_system = UnitSystem::Inch;
        }
        let at = if inch { at.replace("99999.999", "9999.9999") } else { at.to_owned() };
        let events = trace(&format!("G00 {at} F2 S1000 M03 M23 M74\n{}M02\n", blocks.concat()), &setup);
        let ended = |event: &Event| matches!(event.action, Action::End { .. } | Action::Alarm(_));
        prop_assert!(events.last().is_some_and(ended));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// E100L-TINF-02 to -07, E100L-G71-07: the depths grow, reach the height less the allowance, and end at the height;
    /// no pass of the pattern takes more than the first one, or than the finishing pass.
    #[test]
    fn depths_grow_to_the_height((step, height, allowance) in pattern(), flank in 32..=34, code in 73..=75) {
        let mut setup = Setup::default();
        setup.readings.balanced_infeed = BalancedInfeed::EqualArea;
        prop_assume!(height - allowance >= step);
        let list = depths(&format!("{} M{flank} M{code}", words(step, height, allowance)), height * 1_000, &setup);
        prop_assert!(list.windows(2).all(|pair| matches!(pair, [a, b] if a < b)), "{list:?}");
        prop_assert_eq!(list.last().copied(), Some(height * 1_000));
        prop_assert!(list.contains(&((height - allowance) * 1_000)), "{:?}", list);
        let target = (height - allowance) * 1_000;
        // What a pass removes: along the depth, or in M75 the area.
        let taken = |depth: i64| match code {
            75 => i128::from(depth).pow(2),
            _ => i128::from(depth),
        };
        let (first, finishing) = (taken(step * 1_000), taken(height * 1_000) - taken(target));
        let (most, latched) = if code == 75 { (first.max(finishing), 4 * i128::from(height) * 1_000) } else { (first, 2) };
        let within = list.iter().filter(|depth| **depth <= target && !(code == 75 && flank == 33));
        let steps: Vec<i128> =
            within.scan(0, |before, depth| Some(taken(*depth) - std::mem::replace(before, taken(*depth)))).collect();
        prop_assert!(steps.iter().all(|each| *each <= most + latched), "{steps:?}");
    }

    /// E100L-TINF-04: on one flank every step but the last removes the same area.
    #[test]
    fn areas_are_equal((step, height) in (300_i64..3_000, 2_000_i64..12_000)) {
        prop_assume!(step < height);
        let list = depths(&format!("{} M75", words(step, height, 0)), height * 1_000, &Setup::default());
        for (depth, number) in list.iter().zip(1_i32..) {
            let area = f64::from(number) * (step as f64 * 1_000.0).powi(2);
            let exact = area.sqrt().min(height as f64 * 1_000.0);
            prop_assert!((*depth as f64 - exact).abs() <= 0.51, "{depth} {exact}");
        }
        let expected = (height * height + step * step - 1) / (step * step);
        prop_assert_eq!(list.len() as i64, expected);
    }

    /// E100L-TCHM-03, E100L-TCHM-04: the chamfer withdraws by v·L/(N·P), up to the cycle start.
    #[test]
    fn chamfers_withdraw((speed, lead, chamfer) in (1_i64..6_000, 1_i64..4_000, 1_i64..20_000), diameter: bool) {
        let mut setup = Setup::default();
        if diameter {
            setup.readings.feed_length = FeedLength::Diameter;
        }
        let program = format!(
            "G00 X40 Z80 S{speed} M03 M23\nG33 X30 Z50 F{} L{}\nM02\n",
            lead as f64 / 1_000.0, chamfer as f64 / 1_000.0
        );
        let exits: Vec<(i64, i64)> = trace(&program, &setup).iter().filter_map(|event| match event.action {
            Action::Thread { motion, .. } if motion.part == Some(Part::Exit) => {
                Some((motion.program.x.0, motion.program.z.0))
            }
            _ => None,
        }).collect();
        let rise = 3_000.0 * chamfer as f64 / (speed as f64 * lead as f64) * 1e6 * if diameter { 1.0 } else { 2.0 };
        let first = exits.first().copied().unwrap_or_default();
        if rise < 1e7 {
            prop_assert_eq!(exits.len(), 1);
            prop_assert!((first.0 as f64 - 3e7 - rise).abs() <= 1.0, "{first:?} {rise}");
        } else {
            prop_assert_eq!(first.0, 40_000_000);
            let reached = 5e7 + chamfer as f64 * 1_000.0 * (1.0 - 1e7 / rise);
            prop_assert!((first.1 as f64 - reached).abs() <= 1.0, "{first:?} {reached}");
        }
        prop_assert_eq!(exits.last().map(|exit| exit.1), Some(50_000_000));
    }
}
