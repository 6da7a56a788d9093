//! Contours with the C axis and coordinate conversion: what their events cite, the order of their tests, what goes on
//! between blocks, and laws of their arcs. The examples of the rule texts hold besides.

mod support;

use proptest::prelude::*;
use support::trace;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{
    Action, Angle, ContourPlane, Event, Length, Motion, Setup, SidePlane, ToolOffset, UnitSystem,
};

/// The events of one line of a program, from this one on, have these kinds and cite these rules, in whatever order.
fn line_cites(program: &str, line: u32, from: usize, wanted: &[&str], setup: &Setup) {
    let sorted = |kind: &str, mut rules: Vec<&str>| {
        rules.sort_unstable();
        format!("{kind} {}", rules.join(" "))
    };
    let events = trace(program, setup).into_iter().filter(|event| event.block.line == line);
    let found: Vec<String> = events
        .skip(from)
        .map(|event| {
            let rules = event.rules.as_slice().iter();
            let rules = rules.filter_map(|rule| rule.as_str().strip_prefix("E100L-")).collect();
            sorted(render(&event).split(' ').next().unwrap_or_default(), rules)
        })
        .collect();
    let wanted: Vec<String> = wanted
        .iter()
        .filter_map(|text| text.split_once(' '))
        .map(|(kind, rules)| sorted(kind, rules.split(' ').collect()))
        .collect();
    assert_eq!(found, wanted, "{program}");
}

/// Whether the last event has these words of the compact notation.
fn ends_with(program: &str, setup: &Setup, wanted: &str) {
    support::ends_with(program, wanted, setup);
}

/// The same with the default set-up.
fn all_end_with(cases: &[(&str, &str)]) {
    for (program, wanted) in cases {
        ends_with(program, &Setup::default(), wanted);
    }
}

#[test]
fn motions_on_the_face_cite_their_rules() {
    let setup = Setup::default();
    let line = "M110\nG00 X100 F50\nG94\nG91 G101 X-40 C90 Z5\nM02\n";
    line_cites(
        line,
        4,
        2,
        &["linear COORD-03 ABS-02 ABS-03 DIA-01 FEED-02 FEED-03 CGF-01 CGF-02 CGF-03 CGF-06"],
        &setup,
    );
    let through = "M110\nG94 G00 X100 F50\nG101 C180\nM02\n";
    line_cites(
        through,
        3,
        1,
        &[
            "linear COORD-03 ABS-01 FEED-02 CGF-01 CGF-02 CGF-06 CGF-11",
            "linear COORD-03 ABS-01 CFEED-01 FEED-02 CGF-01 CGF-02 CGF-06 CGF-11 CGF-12",
            "linear COORD-03 ABS-01 FEED-02 CGF-01 CGF-02 CGF-06 CGF-11",
        ],
        &setup,
    );
    let to_centre = "M110\nG94 G00 X100 F50\nG101 X0\nC90\nM02\n";
    line_cites(
        to_centre,
        3,
        1,
        &["linear COORD-03 ABS-01 DIA-01 FEED-02 CGF-01 CGF-02 CGF-06 CGF-09"],
        &setup,
    );
    line_cites(
        to_centre,
        4,
        0,
        &["linear COORD-03 ABS-01 CFEED-01 FEED-02 CGF-01 CGF-02 CGF-06 CGF-10 CGF-12"],
        &setup,
    );
    let arc = "M110\nG94 G00 X100 F50\nG103 C90 L50\nM02\n";
    line_cites(
        arc,
        3,
        0,
        &["mode GCODE-02 CGF-04", "contour_arc COORD-03 ABS-01 FEED-02 CGF-01 CGF-04 CGF-06"],
        &setup,
    );
}

#[test]
fn motions_on_the_side_cite_their_rules() {
    let mut setup = Setup::default();
    let program = "M110\nG94 G00 X100 F50\nG119 G133 Z20 L40\nC90 X100 L90\nM02\n";
    line_cites(
        program,
        3,
        1,
        &["mode GCODE-02 CGS-01", "contour_arc COORD-03 ABS-01 FEED-02 CGS-01 CGS-02 CGS-04"],
        &setup,
    );
    setup.parameters.side_contour_mode = true;
    line_cites(
        program,
        4,
        0,
        &["contour_arc CAX-05 COORD-03 ABS-01 DIA-01 FEED-02 CGS-01 CGS-02 CGS-04 CGS-05 CGS-07"],
        &setup,
    );
}

#[test]
fn motions_in_conversion_mode_cite_their_rules() {
    let setup = Setup::default();
    let program = "M110\nG50 C30\nG137 C0\nG00 X30 Y40\nG91 X5\nG90 G94 G101 Z5 F50\nX0\nM02\n";
    let rapid = "rapid CAX-05 COORD-03 ABS-01 G00-01 CSC-02 CSC-03 CSC-04";
    line_cites(program, 4, 0, &["mode GCODE-02 G00-01 CSC-05", rapid], &setup);
    line_cites(
        program,
        5,
        1,
        &["rapid CAX-05 COORD-03 ABS-02 G00-01 CSC-02 CSC-03 CSC-04 CSC-06 CSC-07"],
        &setup,
    );
    line_cites(
        program,
        6,
        3,
        &["linear COORD-03 ABS-01 FEED-02 CGF-01 CGF-02 CGF-03 CGF-06 CGF-14 CGF-09 CSC-02 CSC-03 CSC-04"],
        &setup,
    );
    line_cites(
        program,
        7,
        0,
        &["linear COORD-03 ABS-01 FEED-02 CGF-01 CGF-02 CGF-06 CGF-14 CSC-02 CSC-03 CSC-04 CSC-06"],
        &setup,
    );
}

#[test]
fn lengths_in_inches_depend_on_their_conversion() {
    let inch = Setup { unit_system: UnitSystem::Inch, ..Setup::default() };
    let events = trace("M110\nG137 C0\nG00 X1.5 Y2.\nM02\n", &inch);
    let rapid = render(&events[3]);
    for word in ["x=127", "px=38.1", "py=50.8", "readings=inch_conversion=metric_increment"] {
        assert!(rapid.split(' ').any(|found| found == word), "{rapid}");
    }
    ends_with("M110\nG137 C0\nG00 X1 Y10000.\nM02\n", &inch, "alarm name=address_range line=3");
}

/// G96: the speed at the end of each motion, the centre included.
#[test]
fn contours_carry_the_cutting_speed() {
    let program = "M110\nG94 G96 S100 G00 X100 F50\nG101 C180\nG50 S1000\nG101 X50\nG103 C270 L30\nM02\n";
    let events = trace(program, &Setup::default());
    let speeds: Vec<String> = events
        .iter()
        .filter(|event| event.block.line > 2)
        .map(render)
        .filter_map(|text| text.split(' ').find_map(|word| word.strip_prefix("speed=")).map(str::to_owned))
        .collect();
    assert_eq!(speeds.len(), 6, "{speeds:?}");
    let cutting = events.iter().filter(|event| event.block.line > 2 && motion(event).is_some());
    assert!(cutting.map(render).all(|text| text.contains("E100L-CSS-01")));
}

#[test]
fn checks_come_in_their_order() {
    all_end_with(&[
        // Check 1.
        ("G136 M110\nM02\n", "name=not_alone rules=E100L-MCODE-24"),
        ("G136 V1=1\nM02\n", "name=not_alone rules=E100L-CSC-09"),
        // Check 2a.
        ("G137 C0\nG91 X1\nM02\n", "name=conversion_incremental rules=E100L-CSC-08 line=2"),
        ("G137 C0\nG40 G04 F1\nX1 G04 F1\nM02\n", "name=word_without_function detail=X line=3"),
        ("G137 C0\nG41\nM02\n", "name=motion_code_missing line=2"),
        ("G137 C0\nG71 X1 Z1\nM02\n", "name=motion_code_missing line=2"),
        ("G137 C0\nG75 L1\nM02\n", "name=unspecified detail=G75 line=2"),
        ("G137 C0\nG00 G71 X1 Z1\nM02\n", "name=unspecified detail=G71 rules=E100L-CSC-09"),
        ("G137 C0\nG33 X1 Z1\nM02\n", "name=unspecified detail=G33 rules=E100L-CSC-09"),
        ("G137 C0\nG132 G50 X1\nM02\n", "name=unspecified detail=G132"),
        ("G137 C0\nG00 G50 C1\nM02\n", "name=unspecified detail=G50"),
        ("G137 C0\nG01 X1\nM02\n", "name=unspecified detail=G01"),
        ("G137 C0\nG101 Y1\nM02\n", "name=conversion_axis_missing"),
        // Check 3.
        ("G91 G137 G02\nM02\n", "name=word_missing rules=E100L-CSC-01"),
        ("G91 G137 G02 C0\nM02\n", "name=unspecified detail=G02 rules=E100L-CSC-05"),
        ("G91 G137 C0 X1\nM02\n", "name=conversion_incremental rules=E100L-CSC-07"),
        ("G137 C0 X1\nM02\n", "name=word_without_function detail=X"),
        // Check 4.
        ("G102 Z1 W1\nM02\n", "name=contour_arc_z"),
        ("G102 X1 W1\nM02\n", "name=word_missing rules=E100L-CGF-04"),
        ("G102 L0 W1\nM02\n", "name=arc_radius_not_positive rules=E100L-CGF-04"),
        ("G133 L-1\nM02\n", "name=arc_radius_not_positive rules=E100L-CGS-04"),
        ("G133 L1 W1\nM02\n", "name=unspecified detail=G95 rules=E100L-CGS-01"),
        ("G94 G101 L1 W1\nM02\n", "name=axis_missing"),
        ("G94 G101 L1\nM02\n", "name=word_without_function detail=L"),
        ("G94 G102 X1 L1 I1\nM02\n", "name=word_without_function detail=I"),
        // Check 6.
        ("G41\nG94 G101 C1\nM02\n", "name=unspecified detail=G101 rules=E100L-CRC-06"),
        ("G41\nG40 G94 G133 C1 L1\nM02\n", "name=unspecified detail=G133 rules=E100L-CRC-07"),
        ("G102 G41\nM02\n", "name=compensation_not_linear rules=E100L-NRC-19"),
        ("M110\nG17 G94 G101 G41 C1 F9\nM02\n", "name=unspecified detail=start_up rules=E100L-NRC-15"),
        ("G41\nG136\nM02\n", "name=unspecified detail=compensation rules=E100L-CSC-09"),
        ("G312\nM02\n", "name=g_code_unassigned"),
        ("G138\nM02\n", "name=not_modelled detail=G138"),
        ("G136 G137 C0\nM02\n", "name=g_codes_conflict"),
        ("G137 C0 G04 F1\nM02\n", "name=g_codes_conflict"),
        ("G101 G00\nM02\n", "name=g_codes_conflict"),
    ]);
}

#[test]
fn y_is_an_address_of_conversion_mode_alone() {
    all_end_with(&[
        ("Y0 Y0\nM02\n", "name=address_unknown"),
        ("Y=V1\nM02\n", "name=address_unknown"),
        ("G137 C0\nG00 X1 Y1 Y1\nM02\n", "name=duplicate_address line=2"),
        ("G137 C0\nG00 X1 Y100000\nM02\n", "name=address_range line=2"),
        ("G137 C0\nG04 F1 Y1\nM02\n", "name=word_without_function detail=Y line=2"),
        ("NOEX Y1\nM02\n", "name=word_without_function detail=Y"),
        ("CALL O1 Y1\nM02\n", "name=word_without_function detail=Y"),
    ]);
}

#[test]
fn motions_are_tested_in_their_order() {
    all_end_with(&[
        // The C axis, the start, X, the arc, the range, the feed, the barrier.
        ("G94 M147\nG102 X-1 L1\nM02\n", "name=c_axis_not_joined rules=E100L-CGF-07"),
        ("M110\nG94 M147\nG102 X-1 L1\nM02\n", "name=c_axis_clamped rules=E100L-CGF-07"),
        ("M110\nG137 C0\nG94 G102 X0 Y0 L1\nM02\n", "name=unspecified detail=start rules=E100L-CGF-14"),
        ("M110\nG94\nG102 C1 L1\nM02\n", "name=contour_x_not_positive"),
        ("M110\nG94 G00 X90000\nG91 G102 X90000 L1\nM02\n", "name=arc_radius_too_small"),
        ("M110\nG94 G00 X90000\nG91 G101 X90000\nM02\n", "name=coordinate_range"),
        ("M110\nG94 G00 X90\nM25 G101 X95\nM02\n", "name=no_feed"),
        ("M110\nG94 G00 X90 F50\nM25 G101 X95\nM02\n", "name=not_modelled detail=barrier"),
        ("G94\nG132 X1 L1\nM02\n", "name=c_axis_not_joined rules=E100L-CAX-02"),
        ("M110\nG94\nG132 X1 L1\nM02\n", "name=contour_x_changed"),
        ("M110\nG94\nG132 X0 L1\nM02\n", "name=contour_x_not_positive rules=E100L-CGS-01"),
        ("M110\nG94 G00 X9\nG132 L1\nM02\n", "name=unspecified detail=circle rules=E100L-CGS-04"),
        ("M110\nG94 G00 X9\nG132 Z2 L1\nM02\n", "name=no_feed"),
        ("M110\nG94 G00 X9 M21\nG132 Z2 L1 F9\nM02\n", "name=not_modelled detail=barrier rules=E100L-CGS-01"),
    ]);
}

/// Only what a limit is about is tested, and nothing is cut back.
#[test]
fn limits_are_tested_at_each_end() {
    let mut setup = Setup::default();
    setup.limits.z.positive = Some(Length(10_000_000));
    setup.limits.x.positive = Some(Length(100_000_000));
    setup.start.z = Length(20_000_000);
    setup.start.x = Length(50_000_000);
    ends_with("M110\nG94 G101 C90 F50\nM02\n", &setup, "end");
    ends_with("M110\nG94 G101 C90 Z20 F50\nM02\n", &setup, "name=travel_limit_positive");
    ends_with("M110\nG94 G101 X101 Z20 F50\nM02\n", &setup, "name=travel_limit_positive");
    ends_with("M110\nG94 G133 C90 L50 F50\nM02\n", &setup, "end");
    ends_with("M110\nG94 G133 Z15 L50 F50\nM02\n", &setup, "name=travel_limit_positive");
    // At the limit of Z.
    ends_with("G137 C0\nM02\n", &setup, "name=conversion_at_limit rules=E100L-CSC-10");
}

/// No motion code is in force behind G137, not even behind G136; the reset tells it.
#[test]
fn no_motion_code_is_in_force_behind_conversion() {
    all_end_with(&[
        ("G137 C0\nG136\nX10\nM02\n", "name=motion_code_missing line=3"),
        ("G137 C0\nG136\nG41\nM02\n", "name=motion_code_missing line=3"),
        ("G137 C0\nG136\nG50 X10\nM02\n", "end"),
        ("G137 C0\nL5\nM02\n", "name=word_without_function detail=L"),
    ]);
    let events: Vec<String> =
        trace("G01\nG137 C1\nG136\nM02\n", &Setup::default()).iter().map(render).collect();
    assert!(events[3].starts_with("mode group=motion code=G00 line=4"), "{events:?}");
}

/// A point holds while the axes stand where it has put them.
#[test]
fn a_point_holds_while_the_axes_stand_there() {
    let setup = Setup {
        tool_offset: vec![ToolOffset { number: 1, x: Length(0), z: Length(5_000_000) }],
        ..Setup::default()
    };
    // An offset of Z alone changes nothing.
    ends_with("M110\nG137 C0\nG00 X30 Y40\nT0101\nY-40\nM02\n", &setup, "end");
    all_end_with(&[
        ("M110\nG137 C0\nG00 X30 Y40\nVZSHC=5\nG91 X1 Y1\nM02\n", "name=unspecified detail=start line=5"),
        ("M110\nG137 C0\nG00 X30 Y40\nVZSHC=5\nX1 Y1\nM02\n", "end"),
        ("M110\nG137 C0\nG00 X30 Y40\nG137 C0\nG00 Y1\nM02\n", "name=conversion_axis_missing line=5"),
    ]);
}

#[test]
fn look_ahead_meets_no_contour() {
    all_end_with(&[
        ("G94 G01 G75 X10 L1 F9\nG101 Z9\nM02\n", "name=chamfer_corner line=1"),
        ("G94 G01 G75 X10 L1 F9\nG137 C0\nM02\n", "name=chamfer_corner line=1"),
        ("G94 G01 G75 X10 L1 F9\nG136\nM02\n", "name=angle_lookahead line=1"),
        ("G94 G01 G75 X10 L1 F9\nX1 Y1\nM02\n", "name=address_unknown line=2"),
        ("G94 G01 A10 F9\nG101 X1 Z9\nM02\n", "name=angle_lookahead line=1"),
        ("G94 G01 A10 F9\nG102 X1 Z9\nM02\n", "name=contour_arc_z line=2"),
    ]);
}

/// Contours call no programs, positionings by Y do.
#[test]
fn contours_do_not_trigger() {
    let program =
        |block: &str| format!("M110\nG137 C0\nG00 X1 Y1\nMODIN O1\n{block}\nMODOUT\nM02\nO1\nRTS\n");
    for (block, calls) in [("Y2", 1), ("Z2", 1), ("G94 G101 Y2 F9", 0)] {
        let events = trace(&program(block), &Setup::default());
        let found = events.iter().filter(|event| matches!(event.action, Action::Call { .. })).count();
        assert_eq!(found, calls, "{block}");
    }
}

fn motion(event: &Event) -> Option<Motion> {
    match event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } | Action::ContourArc { motion, .. } => {
            Some(motion)
        }
        _ => None,
    }
}

fn distance(one: (Length, Length), other: (Length, Length)) -> f64 {
    ((one.0.0 - other.0.0) as f64).hypot((one.1.0 - other.1.0) as f64)
}

/// A point of the face, in millimetres and degrees.
fn point(radius: f64, angle: f64) -> (f64, f64) {
    (radius * angle.to_radians().cos(), radius * angle.to_radians().sin())
}

/// The angle under which an arc is seen from the centre of the face, in degrees: that of many short chords.
fn seen_from_centre(start: (f64, f64), end: (f64, f64), about: (f64, f64), ccw: bool) -> f64 {
    const CHORDS: u32 = 20_000;
    let angle = |point: (f64, f64)| (point.1 - about.1).atan2(point.0 - about.0);
    let turn = (angle(end) - angle(start)).rem_euclid(std::f64::consts::TAU);
    let turn = if ccw { turn } else { turn - std::f64::consts::TAU };
    let radius = (start.0 - about.0).hypot(start.1 - about.1);
    let on_arc = |index: u32| {
        let angle = angle(start) + turn * f64::from(index) / f64::from(CHORDS);
        (about.0 + radius * angle.cos(), about.1 + radius * angle.sin())
    };
    let chord = |index| {
        let (from, to) = (on_arc(index), on_arc(index + 1));
        (from.0 * to.1 - from.1 * to.0).atan2(from.0 * to.0 + from.1 * to.1)
    };
    (0..CHORDS).map(chord).sum::<f64>().to_degrees()
}

/// C of each motion is C of the one before and the travel.
fn is_wound(trace: &[Event]) -> bool {
    let turns: Vec<(i64, i64)> = trace
        .iter()
        .filter_map(motion)
        .filter_map(|motion| Some((motion.program.c?.0, motion.c_travel.unwrap_or(Angle(0)).0)))
        .collect();
    turns.windows(2).all(|pair| (pair[0].0 + pair[1].1 - pair[1].0) % 360_000_000 == 0)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    /// The end of an arc is as far from its centre as its radius says, and C turns as far as the arc is seen from the
    /// centre of the face.
    #[test]
    fn arcs_of_the_face_have_their_radius(
        x in 1..200_i64, start in 0..359_i64, to in 1..200_i64, end in 0..359_i64, l in 1..300_i64, ccw: bool,
    ) {
        let code = if ccw { 103 } else { 102 };
        let program = format!("M110\nG94 G00 X{x} C{start} F50\nG{code} X{to} C{end} L{l}\nM02\n");
        let trace = trace(&program, &Setup::default());
        prop_assert!(is_wound(&trace));
        for event in &trace {
            let Action::ContourArc { motion, plane: ContourPlane::FaceCentre(centre), .. } = event.action else {
                continue;
            };
            let Some(face) = motion.face else { return Err(TestCaseError::fail("no point")) };
            let radius = distance((face.x, face.y), (centre.x, centre.y));
            // Half a circle leaves no height, whatever the rounding of its ends.
            prop_assert!((radius - l as f64 * 1e6).abs() < 3.0, "{radius}");
            let travel = motion.c_travel.unwrap_or_default().0 as f64 / 1e6;
            let at_start = point(x as f64 / 2.0, start as f64);
            let at_end = point(to as f64 / 2.0, end as f64);
            let about = (centre.x.0 as f64 / 1e6, centre.y.0 as f64 / 1e6);
            let seen = seen_from_centre(at_start, at_end, about, ccw);
            prop_assert!((travel - seen).abs() < 1e-3, "{travel} {seen}");
        }
    }

    /// Seen from inside an arc is that of the other sense.
    #[test]
    fn the_planes_of_the_side_are_mirrored(z in -50..50_i64, c in 0..359_i64, l in 1..500_i64, back: bool) {
        let program = |code| {
            let direction = if back { 16 } else { 15 };
            format!("M110\nG94 G00 X100 F50\nG{code} Z{z} C{c} L{l} M{direction}\nM02\n")
        };
        let mut inner = Setup::default();
        inner.parameters.side_plane = SidePlane::Inner;
        let planes = |trace: Vec<Event>| -> Vec<ContourPlane> {
            let plane = |event: &Event| match event.action {
                Action::ContourArc { plane, .. } => Some(plane),
                _ => None,
            };
            trace.iter().filter_map(plane).collect()
        };
        let (outer, seen) = (trace(&program(132), &Setup::default()), trace(&program(133), &inner));
        prop_assert!(is_wound(&outer));
        prop_assert_eq!(planes(outer), planes(seen));
    }

    /// A point and its opposite are half a turn apart, and a line between them leads through the centre.
    #[test]
    fn conversion_knows_opposite_points(x in -999_i64..999, y in -999_i64..999, angle in 0..359_i64) {
        prop_assume!((x, y) != (0, 0));
        let program = format!(
            "M110\nG94 G137 C{angle}\nG00 X{x} Y{y} F50\nG101 X{} Y{}\nM02\n", -x, -y
        );
        let trace = trace(&program, &Setup::default());
        prop_assert!(is_wound(&trace));
        let travels: Vec<i64> =
            trace.iter().filter_map(motion).filter_map(|motion| motion.c_travel).map(|c| c.0).collect();
        prop_assert_eq!(&travels[1..], [0, 180_000_000, 0]);
    }
}
