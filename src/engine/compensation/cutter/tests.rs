//! Cutter compensation in G17 and G119. The expected values follow from the text: contact lies R beside the programmed
//! point (E100L-NRC-02), a corner where two parallels at the distance R meet (E100L-NRC-26, E100L-NRC-51), the diameter is
//! twice the distance from the centre and C the angle there, on the side C is 360 u / (π X).

use turnspec_oracle::vocabulary::{Event, Setup, SidePlane, notation};

use crate::engine::Interpreter;

/// The events of a program in compact notation.
fn trace_on(program: &str, setup: &Setup) -> Vec<String> {
    let mut interpreter = Interpreter::new(program.as_bytes(), setup);
    let mut events = Vec::new();
    while interpreter.step(&mut |event: &Event| events.push(notation::render(event))).is_none() {}
    events
}

/// Whether an event has all of some fields, separated by blanks; `!key` says that it has none of that key.
fn fits(event: &str, fields: &str) -> bool {
    let parts: Vec<&str> = event.split(' ').collect();
    fields.split(' ').all(|field| match field.strip_prefix('!') {
        Some(key) => !parts.iter().any(|part| part.split('=').next() == Some(key)),
        None if field.starts_with('+') => {
            let rule = format!("E100L-{}", &field[1..]);
            let rules = parts.iter().find_map(|part| part.strip_prefix("rules=")).unwrap_or_default();
            rules.split('+').any(|other| other == rule)
        }
        None => parts.contains(&field),
    })
}

/// Some event after the ones before fits, for each of some fields in order.
#[track_caller]
fn check_on(program: &str, setup: &Setup, expected: &[&str]) {
    let events = trace_on(program, setup);
    let mut rest = events.iter();
    for fields in expected {
        assert!(rest.any(|event| fits(event, fields)), "no {fields} in\n{}", events.join("\n"));
    }
}

#[track_caller]
fn check(program: &str, expected: &[&str]) {
    check_on(program, &Setup::default(), expected);
}

/// The last event fits.
#[track_caller]
fn ends(program: &str, expected: &str) {
    let events = trace_on(program, &Setup::default());
    let last = events.last().map_or("", String::as_str);
    assert!(fits(last, expected), "no {expected} in\n{}", events.join("\n"));
}

/// A cutter of 5 mm, in conversion mode, on the X axis 100 mm from the centre.
const CONVERTED: &str = "M110\nVNSRX[1]=5 VNSRZ[1]=5\nG137 C0\nG17 G94\nG00 X100 Y0 T010101\n";
/// The same on the diameter 200, out of conversion mode.
const FACE: &str = "M110\nVNSRX[1]=5 VNSRZ[1]=5\nG17 G94 F1000\nG00 X200 C0 T010101\n";
/// The same on the cylinder 100, at Z50.
const SIDE: &str = "M110\nVNSRX[1]=5 VNSRZ[1]=5\nG119 G94 F1000\nG00 X100 Z50 C0 T010101\n";

fn after(head: &str, rest: &str) -> String {
    format!("{head}{rest}\nM02\n")
}

#[test]
fn lines_of_the_face_meet_in_corners() {
    // A square about the centre, the cutter to the right of it: 5 mm outside. From (100, 0) to the contact (55, 0), by the
    // corners (55, 55) and (-55, 55) to the contact (-55, -50), and back to the contour.
    let program = after(CONVERTED, "G42 G101 X50 F1000\nY50\nX-50\nY-50\nG40 X-100");
    check(
        &program,
        &[
            "mode code=G42",
            "linear x=100 c=0 mx=110 mc=0 tx=110 tz=0 tc=0 qx=55 qy=0 px=50 py=0 c_travel=0 path=45 !nx !nz \
             +NRC-07 +NRC-14 +NRC-15 +NRC-42 +CRC-05 +CRC-06 +CRC-08 +CRC-10 +CRC-14 +CGF-02 +CGF-09 +CGF-14",
            "linear x=141.421356 c=45 mx=155.563492 mc=45 tx=155.563492 tc=45 qx=55 qy=55 px=50 py=50 c_travel=45 \
             path=55 line=7 +NRC-26 +CRC-05 +CRC-14",
            "linear tx=155.563492 tc=135 qx=-55 qy=55 c_travel=90 path=110 line=8",
            "linear tx=148.660687 tc=222.273689 qx=-55 qy=-50 c_travel=87.273689 path=105 line=9 +NRC-66",
            "linear x=223.606798 c=206.565051 mx=223.606798 !tx !tc !qx px=-100 py=-50 c_travel=-15.708638 path=45 \
             line=10 +NRC-66 +CGF-02",
            "end",
        ],
    );
    let events = trace_on(&program, &Setup::default());
    assert!(!events.iter().any(|event| fits(event, "line=7 +CRC-08")));
    assert!(!events.iter().any(|event| fits(event, "line=10 +CRC-05") || fits(event, "line=10 +NRC-07")));
}

#[test]
fn lines_of_g01_on_the_face_turn_the_c_axis() {
    // From (50, 0) to (0, 50) and on to (-50, 0): the contact lies 5/√2 beyond (50, 0) in both coordinates, the corner
    // 5 √2 above (0, 50). The path is that of CFEED-03.
    check(
        &after(FACE, "G42 G01 X100\nC90\nC180\nG40 G00 X200"),
        &[
            "linear x=100 c=0 tx=107.304304 tc=3.778377 qx=53.535534 qy=3.535534 c_travel=3.778377 path=92.844121 !px \
             +CRC-16 +CFEED-03 +DIA-01",
            "linear x=100 c=90 mc=90 tx=114.142136 qx=0 qy=57.071068 c_travel=86.221623 path=119.947315 line=6 \
             +CRC-16 +CAX-05",
            "linear x=100 c=180 line=7 +NRC-66",
            "rapid x=200 c=180 mx=200 mc=180 !tx !qx line=8 +NRC-66",
            "end",
        ],
    );
}

#[test]
fn c_turns_almost_once_round_to_the_other_side() {
    // In G41 the contact (50, -5) lies before C0, which M15 reaches by 354 degrees, M16 by 6 (E100L-CRC-16).
    check(
        &after(FACE, "G41 G01 X100\nX60\nG40 X200"),
        &["linear c=0 tx=100.498756 tc=354.289407 c_travel=354.289407 +CRC-16"],
    );
    check(
        &after(FACE, "M16\nG41 G01 X100\nM15\nX60\nG40 X200"),
        &["linear c=0 tx=100.498756 tc=354.289407 c_travel=-5.710593 +CRC-16"],
    );
}

#[test]
fn an_arc_of_the_face_is_followed_at_its_distance() {
    // A quarter about the centre, 55 instead of 50, between a start-up that is tangent to it and a tangent line.
    check(
        &after(CONVERTED, "G42 G101 X50 F1000\nG103 X0 Y50 L50\nG101 X-50\nG40 Y100"),
        &[
            "linear qx=55 qy=0 +NRC-15 +NRC-18",
            "contour_arc x=100 c=90 tx=110 tc=90 qx=0 qy=55 px=0 py=50 pcx=0 pcy=0 c_travel=90 line=7 \
             +NRC-48 +NRC-49 +NRC-60 +CGF-04 +CGF-06 +CRC-06",
        ],
    );
    // Half a circle from (50, 0) to (-50, 0) between lines along +X: the parallels meet the circle of 55 at 5 below, so
    // that the cutter would go round by 190 degrees; about (0, -10) it goes round by less (E100L-CRC-15).
    check(
        &after(CONVERTED, "G00 X20 Y20\nG42 Y0\nG101 X50 F1000\nG103 X-50 Y0 L50\nG101 X-20\nG40 Y20"),
        &[
            "rapid qx=20 qy=-5 line=7",
            "linear tx=110 tc=354.784091 qx=54.772256 qy=-5 line=8 +NRC-51",
            "contour_arc tx=110 tc=185.215909 qx=-54.772256 qy=-5 pcx=0 pcy=-10 c_travel=190.431818 line=9 +CRC-15",
        ],
    );
}

#[test]
fn lines_through_the_centre_are_those_of_the_cutter() {
    // Along -X in G42 the cutter runs 5 above the axis and meets no centre; the programmed line does.
    let events = trace_on(&after(CONVERTED, "G42 G101 X50 F1000\nX-50\nG40 X-100"), &Setup::default());
    assert!(!events.iter().any(|event| fits(event, "part=turn")), "{events:?}");
    // A cutter 5 below the line Y5 runs through the centre: from (50, 0) by it to (-50, 0).
    check(
        &after(CONVERTED, "G00 Y5\nG41 G101 X50 F1000\nX-50\nG40 Y50"),
        &[
            "linear qx=50 qy=0 px=50 py=5",
            "linear tx=0 tc=0 qx=0 qy=0 px=-50 py=5 c_travel=0 path=50 part=radial +CGF-11 +NRC-66",
            "linear tx=0 tc=180 qx=0 qy=0 px=-50 py=5 c_travel=180 path=250 part=turn +CGF-12",
            "linear tx=100 tc=180 qx=-50 qy=0 px=-50 py=5 c_travel=0 part=radial",
        ],
    );
}

#[test]
fn lines_and_arcs_of_the_side() {
    // Start-up to the contact 5 below the line along the circumference; an inside corner 5 before C90; then the parallel
    // 5 beside meets the circle of 25 about the centre of an arc of 20 outside.
    let rest = "G42 G01 Z40\nC90\nZ20\nG133 C120 L20\nG01 Z60\nG40 G00 Z80";
    let expected = [
        "linear x=100 z=40 c=0 mz=35 mc=0 tx=100 tz=35 tc=0 c_travel=0 path=15 !qx !px +CRC-07 +CRC-08 +CRC-18",
        "linear z=40 c=90 mz=35 mc=84.270422 tz=35 tc=84.270422 c_travel=84.270422 path=117.042253 line=6 \
         +NRC-26 +CRC-16 +CRC-18",
        "linear z=20 c=90 tz=17.865745 tc=84.270422 c_travel=0 line=7 +NRC-51",
        "contour_arc z=20 c=120 tz=17.865745 tc=125.729578 c_travel=41.459156 pu=26.179939 pcu=13.08997 \
         pcz=35.121267 line=8 +CRC-07 +CGS-04 +NRC-48 +NRC-60",
        "linear z=60 c=120 tz=60 tc=125.729578 line=9 +NRC-66",
        "rapid z=80 c=120 mz=80 mc=120 c_travel=354.270422 !tx line=10 +NRC-66",
    ];
    check(&after(SIDE, rest), &expected);
    // Seen from inside everything is mirrored: the other side, the other sense.
    let mut setup = Setup::default();
    setup.parameters.side_plane = SidePlane::Inner;
    let mirrored = rest.replace("G42", "G41").replace("G133", "G132");
    check_on(&after(SIDE, &mirrored), &setup, &expected);
}

#[test]
fn other_axes_move_while_a_motion_waits() {
    check(
        &after(CONVERTED, "G42 G101 X50 F1000\nY50\nZ30\nX-50\nG40 Y-100"),
        &[
            "linear qx=55 qy=55 tz=0 line=7 +NRC-43",
            "linear x=141.421356 z=30 mx=155.563492 mz=30 mc=45 tx=155.563492 tz=30 tc=45 qx=55 qy=55 px=50 py=50 \
             c_travel=0 path=30 line=8 +NRC-07 +NRC-42 +CRC-05 +CRC-06 +CRC-14 +CGF-03 +CGF-09",
            "linear qx=-50 qy=55 tz=30 path=105 line=9 !part +NRC-66",
        ],
    );
    ends(&after(CONVERTED, "G42 G101 X50 F1000\nY50\nZ30\nZ40\nX-50"), "alarm detail=waiting line=9 +CRC-14");
    check(&after(CONVERTED, "G42 G101 X50 F1000\nY50\nM08"), &["linear qx=55 qy=50 line=7 +NRC-44", "end"]);
    ends(&after(CONVERTED, "G42 G101 X50 F1000"), "alarm detail=start_up line=6 +NRC-15");
}

#[test]
fn codes_and_words_that_are_refused() {
    let face = |rest: &str, expected: &str| ends(&after(FACE, rest), expected);
    let side = |rest: &str, expected: &str| ends(&after(SIDE, rest), expected);
    face("G42 G01 X100\nG41 C90", "alarm name=unspecified detail=side line=6 +CRC-12");
    side("G42 G01 Z40\nG41 C90", "alarm name=unspecified detail=side line=6 +CRC-12");
    face("G42 G01 X100\nC90\nG02 X80 Z50 L50", "alarm name=unspecified detail=G02 line=7 +CRC-06");
    face("G42 G01 X100\nG132 Z50 L50", "alarm name=unspecified detail=G132 line=6 +CRC-06");
    side("G42 G01 Z40\nG101 X80", "alarm name=unspecified detail=G101 line=6 +CRC-07");
    face("G42 G01 X100 QA=1", "alarm name=unspecified detail=QA line=5 +CRC-14");
    face("G42 G01 X100 A30", "alarm name=unspecified detail=A line=5 +CRC-14");
    side("G42 G01 Z40\nG75 Z20 L1", "alarm name=unspecified detail=G75 line=6 +CRC-14");
    face("G42 G01 Z10", "alarm name=unspecified detail=start_up line=5 +CRC-14");
    side("G42 G01 X100", "alarm name=unspecified detail=start_up line=5 +CRC-14");
    face("G42 G04 F1", "alarm name=unspecified detail=start_up line=5 +CRC-14");
    face("G42 G01 X100\nC90\nG40 Z10", "alarm name=unspecified detail=cancel line=7 +CRC-14");
    face("G42 G01 X100\nC90\nG40", "alarm name=unspecified detail=cancel line=7 +CRC-14");
    face("G42 G103 C90 L100", "alarm name=unspecified detail=start_up line=5 +CRC-14");
    face("G42 G01 X100\nC90\nG40 G102 C0 L100", "alarm name=unspecified detail=cancel line=7 +CRC-14");
    face("G42 G01 X100 I5", "alarm name=word_without_function detail=I line=5 +ADDR-01");
    face("G42 G01 X100\nG18 C90", "alarm name=plane_change_in_compensation line=6 +CRC-13");
    face("G42 G01 X100\nC90 M109", "alarm name=unspecified detail=M109 line=6 +CRC-14");
    face("G42 G01 X100 M109", "alarm name=unspecified detail=M109 line=5 +CRC-14");
    face("G42 G01 X100\nC90\nG40 G18 X200 M109", "alarm name=unspecified detail=M109 line=7 +CRC-14");
    // A displacement is left over from G18.
    face(
        "G18 G42 G01 X100 Z50\nZ40\nG40\nG17 G42 X100",
        "alarm name=unspecified detail=start_up line=8 +CRC-14",
    );
    let contour = "N10 G81\nG42 G01 X50 Z10\nZ0\nG40 X60\nG80\n";
    let called = format!("M110\nG17\nG00 X100 Z50\nG85 N10 D2 U0 W0 F0.2\nM02\n{contour}");
    ends(&called, "alarm name=unspecified detail=G42 +LAP-16");
    ends("M110\nG137 C0\nG119 G94\nG00 X50 Y0 G42\nM02\n", "alarm detail=compensation line=4 +CSC-09");
}

#[test]
fn motions_that_are_refused() {
    let face = |rest: &str, expected: &str| ends(&after(FACE, rest), expected);
    let side = |rest: &str, expected: &str| ends(&after(SIDE, rest), expected);
    side("G42 G01 Z40\nC90 X90", "alarm name=contour_x_changed line=6 +CRC-18");
    side("G42 G01 Z40 X90", "alarm name=contour_x_changed line=5 +CRC-18");
    face("G42 G01 X100\nVZOFC=5 C90", "alarm name=unspecified detail=frame line=6 +CRC-14");
    face("G42 G01 X100\nVZOFC=5\nVZOFC=0 C90\nC180", "end");
    face("M25\nG42 G01 X100", "alarm name=not_modelled detail=barrier line=6 +CRC-14");
    face("G42 G01 X100\nM147\nX80", "alarm name=c_axis_clamped line=7 +CAX-07");
    face("G42 G01 X100\nX100", "alarm name=unspecified detail=repetition line=6 +CRC-14");
    side("G42 G01 Z40\nC90\nC90", "alarm name=unspecified detail=repetition line=7 +CRC-14");
    face("G42 G01 X100\nX-20", "alarm name=contour_x_not_positive line=6 +CGF-08");
    ends(
        "M110\nG119 G94 F100\nG00 X0 Z50 C0\nG42 G01 Z40\nM02\n",
        "alarm name=contour_x_not_positive line=4 +CGS-01",
    );
    ends(&after(CONVERTED, "G42 G00 X50 Y0\nVZSHC=5 VZOFC=-5 Y20"), "alarm detail=start line=7 +CSC-06");
    // The parallels of two lines meet in the centre: 5 beside both.
    ends(&after(CONVERTED, "G42 G101 X50 Y-5 F1000\nX-5\nY50"), "alarm detail=centre line=7 +CRC-14");
}

#[test]
fn arcs_too_small_for_the_cutter() {
    // Inside an arc of 4 there is no room for 5.
    let small = "G41 G101 X50 F1000\nG103 X46 Y4 L4";
    ends(&after(CONVERTED, small), "alarm name=compensation_arc_too_small line=7 +NRC-48");
    let side = "G41 G01 Z40\nG133 C5 Z44 L4.5";
    ends(&after(SIDE, side), "alarm name=compensation_arc_too_small line=6 +NRC-48");
}

#[test]
fn limits_are_tested_where_the_axes_go() {
    let square = "G42 G101 X50 F1000\nY50\nX-50\nY-50\nG40 X-100";
    // X 141.4 is within the limit, 155.6 is not.
    let limited = after(CONVERTED, &format!("VPVLX=150\n{square}"));
    ends(&limited, "alarm name=travel_limit_positive line=8 +NRC-80");
    // On the side X is not tested, whatever its limit.
    let side = after(SIDE, "VPVLX=50\nG42 G01 Z40\nC90\nZ20\nG40 Z10");
    ends(&side, "end");
    let side = after(SIDE, "VNVLZ=36\nG42 G01 Z40\nC90\nZ20\nG40 Z10");
    ends(&side, "alarm name=travel_limit_negative line=6 +NRC-80");
}

#[test]
fn the_cylinder_is_developed_over_whole_turns() {
    // The same corner and the same arc as from C90 on, a turn and a third of one later.
    let round = "C90\nC180\nC270\nC0\nC30";
    check(
        &after(SIDE, &format!("G42 G01 Z40\n{round}\nZ20\nG133 C60 L20\nG01 Z60")),
        &[
            "linear c=0 tc=0 tz=35 c_travel=90 line=9 +NRC-30",
            "linear c=30 tc=24.270422 tz=35 c_travel=24.270422 line=10 +NRC-26",
            "contour_arc c=60 tc=65.729578 c_travel=41.459156 pu=26.179939 pcu=13.08997 line=12",
        ],
    );
    // 5964 turns and 324.27 degrees: the programmed 30 degrees are within 5965 turns, the 41.46 of the cutter are not.
    let wind = "QA=1999\nQA=1999\nQA=1966\nC240\n";
    let program = after(SIDE, &format!("{wind}G42 G01 Z40\nC330\nZ20\nG133 C0 L20\nG01 Z60"));
    ends(&program, "alarm name=profile_generation line=12 +CGS-06");
}

/// The machine coordinates and the travel of C of each motion.
fn motions(program: &str) -> Vec<Vec<String>> {
    let fields = |event: &String| {
        let field = |key: &str| {
            let found = event.split(' ').find_map(|part| part.strip_prefix(key)).unwrap_or("0");
            found.to_owned()
        };
        ["mx=", "mz=", "mc=", "c_travel="].map(field).to_vec()
    };
    let events = trace_on(program, &Setup::default());
    assert!(events.last().is_some_and(|event| event.starts_with("end")), "{}", events.join("\n"));
    events.iter().filter(|event| event.contains(" mx=")).map(fields).collect()
}

#[test]
fn a_cutter_without_radius_follows_the_program() {
    for (head, rest) in [
        (
            FACE,
            "G42 G01 X100\nC90\nX60\nG101 X80 C200 Z5\nG103 C300 L60\nG00 X100 C10\nM16\nC350 Z7\nG40 G101 X120 C20",
        ),
        (
            SIDE,
            "G41 G01 Z40\nC90\nG132 C120 Z45 L30\nG133 Z30 L40\nG00 C100 Z20\nM16\nG01 C90\nG133 C60 L70\nG40 G01 Z20",
        ),
        (
            CONVERTED,
            "G42 G101 X50 Y10 F1000\nY60\nX-50\nG103 X-70 Y-40 L100\nG00 X20 Y-50\nZ5\nX60 M16\nG40 G00 Y0",
        ),
    ] {
        let program = after(head, rest).replace("VNSRX[1]=5 VNSRZ[1]=5", "VNSRX[1]=0 VNSRZ[1]=0");
        let plain =
            ["G42 ", "G41 ", "G40 "].iter().fold(program.clone(), |text, code| text.replace(code, ""));
        assert_eq!(motions(&program), motions(&plain), "{program}");
    }
}
