//! Cutter radius compensation in G17 and G119: paths whose numbers follow by hand from the text (execution-contour.md,
//! section 9), every alarm of it, and what the events cite.

mod support;

use support::{ends_with, trace};
use turnspec_oracle::integer::turn::{around, beside};
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Event, Length, NoseRadius, Setup};

/// Tool 1 with a radius of 5 mm. The second amount of the entry and its sign play no part (E100L-CRC-09, E100L-CRC-10).
fn setup() -> Setup {
    let entry = NoseRadius { number: 1, x: Length(-5_000_000), z: Length(1_000_000) };
    Setup { nose_radius: vec![entry], ..Setup::default() }
}

fn holds(program: &str, expected: &str) {
    support::holds(program, expected, &setup());
}

/// The programs that begin so end with these words of the compact notation.
fn all_end_with(begin: &str, cases: &[(&str, &str)]) {
    for (blocks, wanted) in cases {
        ends_with(&format!("{begin}{blocks}"), wanted, &setup());
    }
}

/// The event of this line with this ordinal, of its motions, cites just these rules.
fn cites(program: &str, line: u32, motion: usize, wanted: &str) {
    let events = trace(program, &setup());
    let of_line = |event: &&Event| event.block.line == line && render(event).contains(" mx=");
    let found = events.iter().filter(of_line).nth(motion).map(|event| event.rules);
    let mut found: Vec<&str> = found
        .iter()
        .flat_map(|rules| rules.as_slice())
        .filter_map(|rule| rule.as_str().strip_prefix("E100L-"))
        .collect();
    let mut wanted: Vec<&str> = wanted.split(' ').collect();
    found.sort_unstable();
    wanted.sort_unstable();
    assert_eq!(found, wanted, "{program}");
}

/// On the face at X100 C0 with feed per minute, in the plane G17.
const FACE: &str = "M110\nG94 G00 X100 C0 F100 T010101\nG17\n";
/// The same in conversion mode with θ = 0, no point given.
const CONVERTED: &str = "M110\nG94 F100 T010101\nG137 C0\nG17\n";
/// On the side, at X100 Z50 C0, in the plane G119.
const SIDE: &str = "M110\nG94 G00 X100 Z50 C0 F100 T010101\nG119\n";

/// (40, 0), (0, 40), (−40, 0): directions (−1, 1)/√2 and (−1, −1)/√2. On their right lie 5·(1, 1)/√2 and
/// 5·(−1, 1)/√2: contact in (43.535534, 3.535534), corner in (0, 40 + 5·√2), contact in (−43.535534, 3.535534).
/// X = 2·√(43.535534² + 3.535534²) = 87.357718, C = atan2(3.535534, 43.535534) = 4.642819 degrees.
#[test]
fn lines_and_a_corner_of_the_face() {
    let program = format!("{FACE}G42 G00 X80\nG101 C90\nC180\nG40 G00 X120\nM02\n");
    holds(
        &program,
        "...
mode code=G42
rapid x=80 c=0 mx=87.357718 mc=4.642819 tx=87.357718 tz=0 tc=4.642819 qx=43.535534 qy=3.535534 c_travel=4.642819 px=-
mode code=G101
linear x=80 c=90 mx=94.142136 tx=94.142136 tc=90 px=0 py=40 qx=0 qy=47.071068 c_travel=85.357181 path=61.568543
linear x=80 c=180 tc=175.357181 px=-40 py=0 qx=-43.535534 qy=3.535534 c_travel=85.357181 path=61.568543
mode code=G40
mode code=G00
rapid x=120 c=180 mx=120 mc=180 tx=- tc=- qx=- c_travel=4.642819
...
end code=M02",
    );
    let every = "COORD-03 ABS-01 NRC-07 CRC-05 CRC-06 CRC-14";
    cites(&program, 4, 0, &format!("{every} DIA-01 G00-01 NRC-14 NRC-15 CRC-08 CRC-10 CRC-16"));
    let line = "FEED-02 NRC-42 CGF-01 CGF-02 CGF-06";
    cites(&program, 5, 0, &format!("{every} {line} NRC-26"));
    cites(&program, 6, 0, &format!("{every} {line} NRC-66"));
    cites(&program, 7, 0, "COORD-03 ABS-01 DIA-01 G00-01 NRC-66");
}

/// The circle Ø60 about the face centre, from (30, 0) to (0, 30), with the cutter outside: from (35, 0) to (0, 35), in
/// contact at the end of the program. The start-up has the arc behind it.
#[test]
fn an_arc_of_the_face() {
    let program = format!("{FACE}G42 G01 X60\nG103 C90 L30\nM02\n");
    holds(
        &program,
        "...
linear x=60 c=0 tx=70 tc=0 qx=35 qy=0 c_travel=0 path=30 px=-
mode code=G103
contour_arc x=60 c=90 px=0 py=30 pcx=0 pcy=0 sense=ccw c_travel=90 tx=70 tc=90 qx=0 qy=35 mx=70 mc=90
...",
    );
    let start =
        "COORD-03 ABS-01 DIA-01 G01-01 G01-02 FEED-02 CFEED-01 CFEED-03 NRC-07 NRC-14 NRC-15 NRC-18 NRC-42";
    cites(&program, 4, 0, &format!("{start} CRC-05 CRC-06 CRC-08 CRC-10 CRC-14"));
}

/// The corner (20, 20) of two lines with the cutter inside: (15, 15), X = 2·√450 = 42.426407, C45. Then along the ray to
/// (0, 40).
#[test]
fn lines_in_conversion_mode() {
    let program = format!("{CONVERTED}G00 X30 Y0\nG41 G101 X20 Y0\nY20\nX0\nG40 Y40\nG136\nM02\n");
    holds(
        &program,
        "...
rapid x=60 c=0 px=30 py=0 qx=-
...
linear x=40 c=0 px=20 py=0 qx=15 qy=0 tx=30 tc=0 c_travel=0 path=15 rules=E100L-CGF-09+E100L-NRC-14
linear x=56.568542 c=45 px=20 py=20 qx=15 qy=15 tx=42.426407 tc=45 c_travel=45 path=15
linear x=40 c=90 px=0 py=20 qx=0 qy=15 tx=30 tc=90 c_travel=45 path=15
mode code=G40
linear x=80 c=90 mx=80 px=0 py=40 qx=- tx=- c_travel=0 path=25 rules=E100L-CGF-09+E100L-NRC-66
mode code=G136
...
end code=M02",
    );
}

/// The parallel of the line along q = 5 goes through the centre: X in, C half round, X out. Z would have no place. θ = 90
/// turns all of it.
#[test]
fn the_cutter_goes_through_the_centre_of_the_face() {
    let begin = "M110\nG94 F100 T010101\nG137 C90\nG17\nG41 G00 X30 Y5\n";
    holds(
        &format!("{begin}G101 X-30\nM02\n"),
        "...
rapid x=60.827625 c=99.462322 px=30 py=5 qx=30 qy=0 tx=60 tc=90 c_travel=90
mode code=G101
linear part=radial x=60.827625 c=260.537678 px=-30 py=5 qx=0 qy=0 tx=0 tc=90 mx=0 mc=90 c_travel=0 path=30
linear part=turn x=60.827625 c=260.537678 px=-30 py=5 qx=0 qy=0 tx=0 tc=270 mx=0 mc=270 c_travel=180 path=250
linear part=radial x=60.827625 c=260.537678 px=-30 py=5 qx=-30 qy=0 tx=60 tc=270 mx=60 c_travel=0 path=30
...
end code=M02",
    );
    all_end_with(begin, &[("G101 X-30 Z5\nM02\n", "name=unspecified detail=Z line=6 rules=E100L-CGF-03")]);
}

/// Half a circle about (50, 0) from (50, −20) to (50, 20). The lines before and behind it have the directions (4, −3)/5
/// and (−4, −3)/5; their parallels go through (47, ∓24) and meet the circle with the radius 25 where τ² + 24·τ − 40 = 0,
/// τ = √184 − 12 = 1.564660: in (47 + 0.8·τ, ∓(24 + 0.6·τ)) = (48.251728, ∓24.938796). That is more than half a circle
/// about (50, 0): the other one has its centre in (2·48.251728 − 50, 0).
#[test]
fn an_arc_that_grows_beyond_half_a_circle_becomes_the_other_one() {
    let program =
        format!("{CONVERTED}G00 X0 Y30\nG42 X10 Y10\nG101 X50 Y-20\nG103 Y20 L20\nG101 X10 Y-10\nM02\n");
    holds(
        &program,
        "...
linear px=50 py=-20 qx=48.251728 qy=-24.938796
mode code=G103
contour_arc px=50 py=20 qx=48.251728 qy=24.938796 pcx=46.503456 pcy=0 sense=ccw rules=E100L-CRC-15+E100L-NRC-51+E100L-CGF-04
...
end code=M02",
    );
}

/// Along the cylinder, then along Z: on the right of (1, 0) lies Z35, on that of (0, −1) the cylinder 5 mm back, which is
/// 5·360/(π·100) = 5.729578 degrees: C 54.270422.
#[test]
fn lines_and_a_corner_of_the_side() {
    let program = format!("{SIDE}G42 G01 Z40\nC60\nZ0\nG40 Z-20 C100\nM02\n");
    holds(
        &program,
        "...
linear x=100 z=40 c=0 mx=100 mz=35 mc=0 tx=100 tz=35 tc=0 qx=- c_travel=0 path=15
linear x=100 z=40 c=60 mz=35 mc=54.270422 tz=35 tc=54.270422 c_travel=54.270422
linear x=100 z=0 c=60 mz=0 mc=54.270422 c_travel=0 path=35
mode code=G40
linear x=100 z=-20 c=100 mz=-20 mc=100 c_travel=45.729578 tz=-
...
end code=M02",
    );
    let every =
        "COORD-03 ABS-01 G01-01 G01-02 FEED-02 CFEED-01 CFEED-03 NRC-07 NRC-42 CRC-05 CRC-07 CRC-14 CRC-18";
    cites(&program, 5, 0, &format!("{every} CAX-05 NRC-26 CRC-16"));
    cites(&program, 6, 0, &format!("{every} NRC-66"));
}

/// Half a circle along Z, tangential to the line before it; the cutter is inside, L − R = 10, from Z35 to Z15.
#[test]
fn an_arc_of_the_side() {
    let program = "M110\nG94 G00 X100 Z40 C60 F100 T010101\nG119 M16\nG41 G01 C50\nC20\nG133 Z10 L15\nM02\n";
    holds(
        program,
        "...
linear z=40 c=50 tz=35 tc=50 c_travel=-10
linear z=40 c=20 tz=35 tc=20 c_travel=-30 rules=E100L-NRC-49
mode code=G133
contour_arc x=100 z=10 c=20 mz=15 mc=20 tz=15 tc=20 c_travel=0 pu=0 pcu=0 pcz=25 sense=ccw rules=E100L-NRC-44+E100L-CGS-04
...
end code=M02",
    );
    // Seen from inside, left and right, clockwise and counter-clockwise change places.
    let mut inner = setup();
    inner.parameters.side_plane = turnspec_oracle::vocabulary::SidePlane::Inner;
    let program = program.replace("G41", "G42").replace("G133", "G132");
    support::holds(
        &program,
        "...
linear tz=35 tc=50
linear tz=35 tc=20
...
contour_arc tz=15 tc=20 c_travel=0 pu=0 pcu=0 pcz=25 sense=cw
...",
        &inner,
    );
}

/// On the right of −Z the cutter is 5.729578 degrees back, behind where C stands: M15 turns almost once round.
#[test]
fn c_turns_almost_once_round() {
    holds(
        &format!("{SIDE}G42 G00 Z40\nG01 Z0\nG40 G00 Z10\nM02\n"),
        "...
rapid z=40 c=0 tc=354.270422 mc=354.270422 c_travel=354.270422 rules=E100L-CRC-16
...
linear z=0 tc=354.270422 c_travel=0
...
rapid z=10 c=0 mc=0 c_travel=5.729578
...",
    );
}

/// Z and W do not move the cutter in the plane of the face; their events wait, and show where it is then.
#[test]
fn other_axes_alone() {
    let program = format!("{FACE}G42 G00 X80\nG101 C90\nG01 Z5\nG101 C180\nZ10\nG40 G01 X120 Z20\nM02\n");
    holds(
        &program,
        "...
linear x=80 c=90 tx=94.142136 tz=0 tc=90 qy=47.071068 rules=E100L-NRC-43
mode code=G01
linear x=80 z=5 c=90 mx=94.142136 mz=5 mc=90 tx=94.142136 tz=5 tc=90 qx=0 qy=47.071068 c_travel=- path=5
mode code=G101
linear x=80 z=5 c=180 tz=5 tc=175.357181 path=61.568543
linear x=80 z=10 c=180 mz=10 tx=87.357718 tz=10 tc=175.357181 px=-40 qx=-43.535534 c_travel=0 path=5
mode code=G40
mode code=G01
linear x=120 z=20 c=180 tx=-
...
end code=M02",
    );
    let at_rest = "COORD-03 ABS-01 FEED-02 NRC-07 NRC-42 CRC-05 CRC-06 CRC-14";
    cites(&program, 6, 0, &format!("{at_rest} G01-01 G01-02 G01-04"));
    cites(&program, 8, 0, &format!("{at_rest} CGF-01 CGF-02 CGF-03 CGF-06 CGF-09"));
}

/// A cutter without radius goes where the program goes.
#[test]
fn radius_zero_is_the_program() {
    let with = |number: &str| {
        format!(
            "M110\nG94 G00 X100 C0 F100 T{number}0101\nG17\nG42 X80 C10\nG101 C90\nG103 X60 C180 L60\nG01 C190\nM02\n"
        )
    };
    for event in trace(&with("00"), &setup()) {
        let text = render(&event);
        let of = |key: &str| {
            let key = format!(" {key}=");
            text.split_once(&key).and_then(|(_, rest)| rest.split(' ').next()).map(str::to_owned)
        };
        if of("tc").is_some() {
            assert_eq!((of("tx"), of("tc"), of("mx")), (of("x"), of("c"), of("x")), "{text}");
            assert!(of("px").is_none() || (of("px"), of("py")) == (of("qx"), of("qy")), "{text}");
        }
    }
}

#[test]
fn blocks_are_refused_in_their_order() {
    let face = format!("{FACE}G42 G00 X80\nG101 C90\n");
    all_end_with(
        &face,
        &[
            // Check 6.
            ("G41 C180\nM02\n", "name=unspecified detail=side line=6 rules=E100L-CRC-12"),
            ("G41 G02 X9 I5\nM02\n", "name=unspecified detail=side"),
            ("G02 X9 I5\nM02\n", "name=unspecified detail=G02 line=6 rules=E100L-CRC-06"),
            ("G40 G02 X9 I5\nM02\n", "name=unspecified detail=G02 rules=E100L-CRC-06"),
            ("G132 C9 L1\nM02\n", "name=unspecified detail=G132 rules=E100L-CRC-06"),
            ("G01 X9 A5\nM02\n", "name=unspecified detail=A rules=E100L-CRC-14"),
            ("G01 C9 QA=5\nM02\n", "name=unspecified detail=QA rules=E100L-CRC-14"),
            ("G01 G75 X9 L1\nM02\n", "name=unspecified detail=G75 rules=E100L-CRC-14"),
            ("G01 G76 X9 L1\nM02\n", "name=unspecified detail=G76 rules=E100L-CRC-14"),
            ("G40\nM02\n", "name=unspecified detail=cancel rules=E100L-CRC-14"),
            ("G40 Z5\nM02\n", "name=unspecified detail=cancel rules=E100L-CRC-14"),
            ("G40 G04 F1\nM02\n", "name=unspecified detail=cancel rules=E100L-CRC-14"),
            ("G40 G103 C9 L60\nM02\n", "name=unspecified detail=cancel rules=E100L-CRC-14"),
            ("G40 G00 C9 I1\nM02\n", "name=word_without_function detail=I rules=E100L-ADDR-01"),
            ("G18 C9\nM02\n", "name=plane_change_in_compensation rules=E100L-CRC-13"),
            ("G18\nM02\n", "name=plane_change_in_compensation rules=E100L-CRC-13"),
            ("G136\nM02\n", "name=unspecified detail=compensation rules=E100L-CSC-09"),
            ("G137 C0\nM02\n", "name=compensation_not_allowed rules=E100L-NRC-81"),
            // Step 6.
            ("M109\nM02\n", "name=unspecified detail=M109 line=6 rules=E100L-CRC-14"),
            ("G40 G18 X90 M109\nM02\n", "name=unspecified detail=M109 rules=E100L-CRC-14"),
            // Step 7.
            ("VZOFC=5\nM25 M147 C90\nM02\n", "name=unspecified detail=frame line=7 rules=E100L-CRC-14"),
            ("VZOFX=5\nG40 C9\nM02\n", "name=unspecified detail=frame line=7 rules=E100L-CRC-14"),
            ("M25 M147 C90\nM02\n", "name=not_modelled detail=barrier rules=E100L-CRC-14"),
            ("M147 C90\nM02\n", "name=c_axis_clamped rules=E100L-CAX-07"),
            ("G01 X80\nM02\n", "name=unspecified detail=repetition rules=E100L-CRC-14"),
            ("G01 X-5\nM02\n", "name=contour_x_not_positive rules=E100L-CGF-08"),
            ("G40 G00 X-5\nM02\n", "name=contour_x_not_positive rules=E100L-CGF-08"),
            ("G103 L5\nM02\n", "name=unspecified detail=circle rules=E100L-CGF-04"),
            ("G102 C140 L2\nM02\n", "name=arc_radius_too_small rules=E100L-CGF-04"),
            ("G40 C180\nM02\n", "end code=M02"),
            ("G40 G119 C180\nM02\n", "end code=M02"),
            // Step 8.
            ("G04 F1\nG04 F1\nM02\n", "name=unspecified detail=waiting line=7 rules=E100L-CRC-14"),
            ("M00\nG01 Z5 M00\nM02\n", "name=unspecified detail=waiting line=7"),
            ("G04 F1\nG04 F1 M02\n", "end code=M02"),
        ],
    );
    all_end_with(
        FACE,
        &[
            ("G41\nM02\n", "name=unspecified detail=start_up line=4 rules=E100L-CRC-14"),
            ("G41 Z5\nM02\n", "name=unspecified detail=start_up"),
            ("G41 G22 Z5 D1 L1 PZ=9\nM02\n", "name=unspecified detail=G22 rules=E100L-NRC-81"),
            ("G41 G50 X9\nM02\n", "name=unspecified detail=start_up"),
            ("G41 G102 L9\nM02\n", "name=unspecified detail=start_up"),
            ("G41 G102 C9 L9\nM02\n", "name=unspecified detail=start_up rules=E100L-CRC-14"),
            ("G41 X9 I9\nM02\n", "name=word_without_function detail=I"),
            ("G18 G41 Z9\nG01 Z40\nG40\nG17\nG41 G00 X80\nM02\n", "name=unspecified detail=start_up line=8"),
            (
                "G18 G41 Z9\nG01 Z40\nG40\nG17 G41 G101 C9\nM02\n",
                "name=unspecified detail=G101 rules=E100L-CRC-06",
            ),
            ("G41 X80\nM02\n", "name=unspecified detail=start_up line=4 rules=E100L-NRC-15"),
            ("G41 X80\nG04 F1\nG04 F1\nM02\n", "name=unspecified detail=waiting line=6"),
            ("G41 X80\nG40 X90\nM02\n", "name=unspecified detail=start_up line=4 rules=E100L-NRC-15"),
            // A cutter of 5 mm inside an arc of 4 mm about (36, 0), from (40, 0) to (36, 4) nearly.
            (
                "G41 X80\nG103 X72.444 C6.34 L4\nM02\n",
                "name=compensation_arc_too_small line=5 rules=E100L-NRC-48",
            ),
        ],
    );
}

#[test]
fn blocks_of_the_side_are_refused_in_their_order() {
    all_end_with(
        SIDE,
        &[
            ("G41 X90 Z0\nM02\n", "name=contour_x_changed line=4 rules=E100L-CRC-18"),
            ("G41 X100 Z0\nG01 C9\nM02\n", "end code=M02"),
            ("G41 X100\nM02\n", "name=unspecified detail=start_up"),
            ("G41 C9\nG101 C5\nM02\n", "name=unspecified detail=G101 rules=E100L-CRC-07"),
            ("G41 C9\nG03 Z5 K2\nM02\n", "name=unspecified detail=G03 rules=E100L-CRC-07"),
            ("G41 C9\nG01 X90\nM02\n", "name=contour_x_changed line=5 rules=E100L-CRC-18"),
            ("G41 C9\nG132 Z0 X90 L90\nM02\n", "name=contour_x_changed rules=E100L-CRC-18"),
            ("G41 C9\nG40 X90 Z0\nM02\n", "name=contour_x_changed rules=E100L-CRC-18"),
            ("G41 C9\nZ50\nM02\n", "name=unspecified detail=repetition"),
            ("G41 C9\nG132 L5\nM02\n", "name=unspecified detail=circle rules=E100L-CGS-04"),
            ("G41 C9\nG132 Z0 L24.999\nM02\n", "name=arc_radius_too_small rules=E100L-CGS-04"),
            ("G41 C9\nG133 Z42 L4\nM02\n", "name=compensation_arc_too_small rules=E100L-NRC-48"),
            ("G00 X0\nG41 C9\nM02\n", "name=contour_x_not_positive line=5 rules=E100L-CGS-01"),
            ("G41 C9\nM147 Z9\nM02\n", "name=c_axis_clamped rules=E100L-CAX-07"),
        ],
    );
}

#[test]
fn conversion_mode_and_cutter_compensation() {
    let begin = "M110\nG94 F100 T010101\nG137 C0\n";
    all_end_with(
        begin,
        &[
            ("G41 G00 X9 Y9\nM02\n", "name=unspecified detail=compensation line=4 rules=E100L-CSC-09"),
            ("G119 G41 G00 X9 Y9\nM02\n", "name=unspecified detail=compensation rules=E100L-CSC-09"),
            ("G17 G41 G00 X9 Y9\nM02\n", "name=unspecified detail=start_up rules=E100L-NRC-15"),
            ("G17 G41 G00 Z9\nM02\n", "name=unspecified detail=start_up rules=E100L-CRC-14"),
            ("G17 G41 G00 X9 Y9\nG101 X9\nM02\n", "name=unspecified detail=repetition"),
            ("G17 G41 G101 X9 Y9\nM02\n", "name=unspecified detail=start rules=E100L-CGF-14"),
        ],
    );
}

/// The corner (5, 5) of the lines along +q and −p has the cutter in (0, 0). Half a circle about (25, 0) with the radius 20 + 5
/// passes the centre.
#[test]
fn the_centre_of_the_face_is_refused() {
    all_end_with(
        CONVERTED,
        &[
            (
                "G41 G00 X5 Y-20\nG101 Y5\nX-20\nM02\n",
                "name=unspecified detail=centre line=6 rules=E100L-CRC-14",
            ),
            (
                "G42 G00 X60 Y20\nG101 X25\nG103 Y-20 L20\nM02\n",
                "name=unspecified detail=centre line=7 rules=E100L-CGF-04",
            ),
        ],
    );
}

/// Limits of X and Z are tested where the axes go, and nothing is cut back; the motion that ends compensation is.
#[test]
fn limits_are_those_of_the_cutter() {
    let mut setup = setup();
    setup.limits.x.positive = Some(Length(110_000_000));
    setup.limits.z.positive = Some(Length(20_000_000));
    let holds =
        |begin: &str, blocks: &str, wanted: &str| support::holds(&format!("{begin}{blocks}"), wanted, &setup);
    // The cutter on the right and on the left of the way up, P 10 mm of diameter beside it.
    holds(
        CONVERTED,
        "G41 G00 X56 Y0\nG101 Y5\nG40 G00 X56 Y0\nM02\n",
        "...\nrapid x=112 mx=102\nmode code=G101\nlinear px=56 qx=51 qy=5\nmode code=G40\nmode code=G00\n\
         rapid x=110 c=0 mx=110 px=56 rules=E100L-LIM-01+E100L-NRC-66\n...",
    );
    let refused = "...\nmode code=G00\nalarm name=travel_limit_positive line=5 rules=E100L-NRC-80";
    holds(CONVERTED, "G42 G00 X54 Y0\nG101 Y5\nM02\n", refused);
    holds(
        CONVERTED,
        "G41 G00 X56 Y0\nG101 Y5\nG40 X56 Y0\nM02\n",
        "...\nlinear qx=51 qy=5\nmode code=G40\nalarm name=travel_limit_positive line=7 rules=E100L-LIM-01",
    );
    // Z alone, and with a motion of the plane.
    holds(
        CONVERTED,
        "G41 G00 X30 Y0\nG101 Y5\nZ21\nM02\n",
        "...\nrapid\nmode code=G101\nalarm name=travel_limit_positive line=7 rules=E100L-NRC-80",
    );
    holds(
        CONVERTED,
        "G41 G00 X30 Y0\nG101 Y5 Z21\nM02\n",
        "...\nrapid\nmode code=G101\nalarm name=travel_limit_positive line=6 rules=E100L-NRC-80",
    );
    // On the side the cutter is 5 mm beyond P in Z.
    holds(
        "M110\nG94 G00 X100 C0 F100 T010101\nG119\n",
        "G41 Z16\nG01 C9\nM02\n",
        "...\nmode code=G41\nalarm name=travel_limit_positive line=4 rules=E100L-NRC-80",
    );
}

/// The parallels of a way there and nearly back meet far away.
#[test]
fn what_lies_beyond_the_range_of_x_is_no_place() {
    all_end_with(
        CONVERTED,
        &[(
            "G42 G00 X0 Y30\nG101 X90000\nX0 Y30.001\nM02\n",
            "name=coordinate_range line=6 rules=E100L-ADDR-01",
        )],
    );
}

/// 6137 times 350 degrees are 2147950, more than 5965 turns.
#[test]
fn c_is_wound_too_far() {
    let turns: String = (0..6137).map(|turn| format!("C{}\n", (turn + 1) * 350 % 360)).collect();
    all_end_with(
        SIDE,
        &[(
            &format!("G41 G01 Z40\n{turns}G133 Z20 L30\nM02\n"),
            "name=profile_generation number=2480 line=6142 rules=E100L-CGS-06",
        )],
    );
}

/// G41 in a definition of LAP.
#[test]
fn lap_is_turning() {
    let program =
        "M110\nG17\nG00 X100 Z10 F0.2 T010101\nG85 NA D2\nM02\nNA G81\nG00 X80 Z5\nG41 G01 Z0\nX90\nG80\n";
    all_end_with(program, &[("", "name=unspecified detail=G41 line=8 rules=E100L-LAP-16")]);
}

/// "Where the axes go": on the side of the chord a turn of more than 270 degrees loses its whole turn, round the centre one of
/// less than 90 degrees gains one; others stay.
#[test]
fn rounding_neither_makes_nor_takes_a_whole_turn() {
    const DEGREE: i64 = 1_000_000;
    for (from, to, positive, wanted) in [
        (10 * DEGREE, 9_999_996, true, -4),
        (9_999_996, 10 * DEGREE, false, 4),
        (10 * DEGREE, 10 * DEGREE, true, 0),
        (0, 270 * DEGREE, true, 270 * DEGREE),
        (0, 270 * DEGREE + 1, true, -90 * DEGREE + 1),
        (0, 90 * DEGREE, false, -270 * DEGREE),
        (0, 90 * DEGREE - 1, false, 90 * DEGREE - 1),
        (350 * DEGREE, 10 * DEGREE, true, 20 * DEGREE),
    ] {
        assert_eq!(beside(from, to, positive), wanted, "beside: {from} to {to}");
    }
    for (from, to, positive, wanted) in [
        (10 * DEGREE, 10 * DEGREE, true, 360 * DEGREE),
        (10 * DEGREE, 10 * DEGREE, false, -360 * DEGREE),
        (10 * DEGREE, 10 * DEGREE + 4, true, 360 * DEGREE + 4),
        (10 * DEGREE, 10 * DEGREE + 4, false, -360 * DEGREE + 4),
        (0, 90 * DEGREE - 1, true, 450 * DEGREE - 1),
        (0, 90 * DEGREE, true, 90 * DEGREE),
        (0, 270 * DEGREE, false, -90 * DEGREE),
        (0, 270 * DEGREE + 1, false, -450 * DEGREE + 1),
        (0, 200 * DEGREE, false, -160 * DEGREE),
    ] {
        assert_eq!(around(from, to, positive), wanted, "round: {from} to {to}");
    }
}
