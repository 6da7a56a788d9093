//! Cutter radius compensation at its edges: other axes along with the plane, offsets of the frame, exact half circles, and
//! the limits of the addresses. All values follow by hand from execution-contour.md, section 9, and execution.md, chapter 5.

mod support;

use support::{ends_with, holds, trace};
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Angle, Length, NoseRadius, Setup};

/// Tool 1 with this radius in nanometres, on a machine with a W axis.
fn cutter(radius: i64) -> Setup {
    let entry = NoseRadius { number: 1, x: Length(radius), z: Length(0) };
    let mut setup = Setup { nose_radius: vec![entry], ..Setup::default() };
    setup.options.w_axis = true;
    setup
}

/// The same with 5 mm.
fn setup() -> Setup {
    cutter(5_000_000)
}

/// Whether the first motion of this line cites a rule.
fn cites(program: &str, line: u32, rule: &str) -> bool {
    let events = trace(program, &setup());
    let motion = events.iter().find(|event| event.block.line == line && render(event).contains(" mx="));
    assert!(motion.is_some(), "{program}");
    motion.is_some_and(|event| support::cites(event, rule))
}

const FACE: &str = "M110\nG94 G00 X100 C0 F100 T010101\nG17\n";
const CONVERTED: &str = "M110\nG94 F100 T010101\nG137 C0\nG17\n";

/// From the centre of half a circle to its ends the angle is 180 degrees exactly: no other arc (CRC-15). L = 4 < R, the
/// cutter outside: (40, 0) to (48, 0) about (44, 0), L' = 4 + 5, from (35, 0) to (53, 0), on the same ray: C does not turn.
#[test]
fn half_a_circle_is_no_other_arc() {
    for (side, code, sense) in [("G41", "G102", "cw"), ("G42", "G103", "ccw")] {
        let program = format!("{CONVERTED}G00 X30 Y0\n{side} X40 Y0\n{code} X48 L4\nM02\n");
        let expected = format!(
            "...\nrapid px=40 py=0 qx=35 qy=0 tx=70\nmode code={code}\n\
             contour_arc px=48 py=0 qx=53 qy=0 tx=106 tc=0 pcx=44 pcy=0 sense={sense} c_travel=0 \
             rules=E100L-NRC-48+E100L-NRC-60\n..."
        );
        holds(&program, &expected, &setup());
        assert!(!cites(&program, 7, "E100L-CRC-15"), "{program}");
    }
}

/// The mirror image, in p, of the arc of more than half a circle in cutter.rs: all q and the sense change sign.
#[test]
fn a_clockwise_arc_that_grows_beyond_half_a_circle_becomes_the_other_one() {
    let program =
        format!("{CONVERTED}G00 X0 Y-30\nG41 X10 Y-10\nG101 X50 Y20\nG102 Y-20 L20\nG101 X10 Y10\nM02\n");
    holds(
        &program,
        "...
linear px=50 py=20 qx=48.251728 qy=24.938796
mode code=G102
contour_arc px=50 py=-20 qx=48.251728 qy=-24.938796 pcx=46.503456 pcy=0 sense=cw rules=E100L-CRC-15
...
end code=M02",
        &setup(),
    );
}

/// G00 as an element cites NRC-41. A start-up without travel of the axes cites NRC-20, one with travel does not, also where
/// no point of conversion mode is known before it.
#[test]
fn rules_of_rapids_and_of_start_ups() {
    let program = format!("{CONVERTED}G41 G00 X30 Y0\nY20\nM02\n");
    assert!(cites(&program, 6, "E100L-NRC-41") && !cites(&program, 5, "E100L-NRC-20"));
    let program = "M110\nG94 G00 X60 C0 F100 T010101\nG137 C0\nG17\nG41 G00 X30 Y0\nY20\nM02\n";
    assert!(cites(program, 5, "E100L-NRC-20"));
}

/// Lines of the face as in cutter.rs: cutter in X 87.357718, C 4.642819; X 94.142136, C 90. Machine coordinates are larger by
/// 10, 20, 30 and 40. CFEED-03 with diameters and ΔC·500/360: √(12.642282² + 5² + 1² + 6.448360²) = 15.080074;
/// √(6.784418² + 3² + 2² + 118.551640²) = 118.800336. G101: √(2·43.535534² + 4²) = 61.698342.
#[test]
fn z_and_w_go_along_in_a_shifted_frame() {
    let mut setup = setup();
    (setup.zero_offset.x, setup.zero_offset.z) = (Length(10_000_000), Length(20_000_000));
    (setup.zero_offset.c, setup.zero_offset.w) = (Angle(30_000_000), Length(40_000_000));
    holds(
        "M110\nG94 G00 X100 Z0 W0 C0 F100 T010101\nG17\nG42 G01 X80 Z5 W1\nC90 Z8 W3\nG101 C180 Z12\nM02\n",
        "...
linear x=80 z=5 c=0 mx=97.357718 mz=25 mc=34.642819 tx=87.357718 tz=5 tc=4.642819 c_travel=4.642819 path=15.080074
linear x=80 z=8 c=90 mx=104.142136 mz=28 mc=120 tx=94.142136 tz=8 tc=90 c_travel=85.357181 path=118.800336
mode code=G101
linear x=80 z=12 c=180 mx=97.357718 mz=32 mc=205.357181 tz=12 tc=175.357181 path=61.698342
...
end code=M02",
        &setup,
    );
}

/// The end of compensation leads from T = (30, 0) to P = (−40, 0), on opposite rays: X in, C half round, X out, and each
/// event shows its own end.
#[test]
fn the_end_goes_through_the_centre() {
    holds(
        &format!("{CONVERTED}G42 G00 X10 Y5\nG101 X30\nG40 X-40 Y0\nM02\n"),
        "...
linear px=30 py=5 qx=30 qy=0 tx=60 tc=0
mode code=G40
linear part=radial x=0 c=0 mx=0 mc=0 tx=- path=30
linear part=turn x=0 c=180 mx=0 mc=180 c_travel=180 path=250
linear part=radial x=80 c=180 mx=80 mc=180 path=40
...
end code=M02",
        &setup(),
    );
}

/// X of P may be 0, at the target and at the start: only below 0 it is refused. On the right of (−1, 0) lies q = 5, on that of
/// (0, 1) p = 5. Contact in (40, 5), corner in (5, 5), contact in (5, 40). X = 2·√1625 = 80.622577, C = 7.125016, 45, 82.874984.
#[test]
fn p_is_the_centre() {
    holds(
        &format!("{FACE}G42 G01 X80\nX0\nX80 C90\nM02\n"),
        "...
linear x=80 c=0 qx=40 qy=5 tx=80.622577 tc=7.125016
linear x=0 c=0 px=- qx=5 qy=5 tx=14.142136 tc=45 c_travel=37.874984
linear x=80 c=90 qx=5 qy=40 tx=80.622577 tc=82.874984 c_travel=37.874984
...
end code=M02",
        &setup(),
    );
    let below = "M110\nG94 G00 X-10 C0 F100 T010101\nG17\nG42 G01 X80\nM02\n";
    ends_with(below, "name=contour_x_not_positive line=4 rules=E100L-CGF-08", &setup());
}

/// The programmed points (30, 0) and (20, 0) with θ = 90: the start is the kept point, so that T = (15, 0) lies on the same
/// ray and C stays at 90.
#[test]
fn a_start_up_in_g101_begins_in_the_kept_point() {
    holds(
        "M110\nG94 F100 T010101\nG137 C90\nG17\nG00 X30 Y0\nG41 G101 X20\nY20\nM02\n",
        "...\nlinear px=20 py=0 qx=15 qy=0 tx=30 tc=90 c_travel=0 path=15 rules=E100L-CGF-09\n...",
        &setup(),
    );
}

/// Out of conversion mode z is 0, also with a zero shift that conversion leaves out: T as in cutter.rs.
#[test]
fn the_zero_shift_of_conversion_is_none_out_of_it() {
    let mut setup = setup();
    setup.parameters.conversion_zero_shift = turnspec_oracle::vocabulary::ConversionZeroShift::Excluded;
    holds(
        &format!("{FACE}VZSHC=30\nG42 G00 X80 C0\nG101 C90\nM02\n"),
        "...\nrapid x=80 c=0 tx=87.357718 tc=4.642819\n...",
        &setup,
    );
}

/// F·50/100 for the turn alone. The cutter on the left of (−1, 0) goes along q = 0.
#[test]
fn the_turn_has_its_own_feed() {
    let mut setup = setup();
    setup.parameters.centre_override = 50;
    holds(
        &format!("{CONVERTED}G41 G00 X30 Y5\nG101 X-30\nM02\n"),
        "...\nlinear part=radial f=100mm/min\nlinear part=turn f=50mm/min\nlinear part=radial f=100mm/min\n...",
        &setup,
    );
}

/// The arc from (40, 0) with L = 5 = R and the cutter inside. M is latched: h = √(25 − 25/4) = 4.330127. To (43, 4):
/// M = (41.5 − 0.8·h, 2 + 0.6·h) = (38.035898, 4.598076), at the start √24.99999957 and at the end √25.0000036 away. To (44, 3):
/// M = (42 − 0.6·h, 1.5 + 0.8·h) = (39.401924, 4.964102), √25.0000036 and √24.99999957. Less than R at one end is enough.
#[test]
fn an_arc_is_too_small_at_either_end() {
    for end in ["X43 Y4", "X44 Y3"] {
        let program = format!("{CONVERTED}G00 X30 Y0\nG41 X40 Y0\nG103 {end} L5\nM02\n");
        ends_with(&program, "name=compensation_arc_too_small line=7 rules=E100L-NRC-48", &setup());
    }
}

/// L' below 0 by a nanometre, L = 5 and R = 5.000001, although M as latched is R away. q² = 2.524² + 2.517² = 12.705865,
/// h = √(25 − q²/4) = 4.671567 (from 4.6715665), M = (41.262 − 2.517·h/q, 1.2585 + 2.524·h/q) = (37.963293, 4.566381), at the start
/// √25.00001084 and at the end √25.00001082 away; R² = 25.00001.
#[test]
fn an_arc_without_radius_is_too_small() {
    let program = format!("{CONVERTED}G00 X30 Y0\nG41 X40 Y0\nG103 X42.524 Y2.517 L5\nM02\n");
    ends_with(&program, "name=compensation_arc_too_small line=7 rules=E100L-NRC-48", &cutter(5_000_001));
    ends_with(&program, "end code=M02", &cutter(5_000_000));
}

/// The range of a target is tested before the feed: 2·50000, 60000 + 60000 and 50000 + 50000 are beyond 99999.999.
#[test]
fn ranges_are_tested_before_the_feed() {
    for (program, line) in [
        ("M110\nG94 T010101\nG137 C0\nG17\nG41 G00 X30 Y0\nG101 X50000 Y0\nM02\n", 6),
        ("M110\nG94 G00 Z60000 T010101\nG137 C0\nG17\nG41 G00 X30 Y0\nG91 G101 Y5 Z60000\nM02\n", 6),
        ("M110\nG94 G00 X100 Z50000 C0 T010101\nG119\nG41 C9\nG91 G132 Z50000 L30000\nM02\n", 5),
    ] {
        ends_with(program, &format!("name=coordinate_range line={line} rules=E100L-ADDR-01"), &setup());
    }
}

/// P is within the range of the addresses; the cutter, 5 mm beside it, beyond, exactly at its end, or inside.
#[test]
fn the_cutter_has_the_range_of_the_addresses() {
    let face = |side: &str, x: &str, y: &str| format!("{CONVERTED}{side} G00 X{x} Y0\nG101 Y{y}\nM02\n");
    // 2·(49997 ± 5) = 100004, 99984.
    ends_with(&face("G42", "49997", "5"), "name=coordinate_range line=5 rules=E100L-ADDR-01", &setup());
    ends_with(&face("G41", "49997", "5"), "end code=M02", &setup());
    // 2·(49994.999 + 5.0005) = 99999.999; 0.01 aside X is longer by 0.000000002.
    holds(
        &face("G42", "49994.999", "0.01"),
        "...\nrapid tx=99999.999 tc=0\nmode code=G101\nlinear tx=99999.999\n...\nend code=M02",
        &cutter(5_000_500),
    );
    let side = |side: &str, z: &str| {
        format!("M110\nG94 G00 X100 Z90000 C0 F100 T010101\nG119\n{side} G01 Z{z}\nC60\nM02\n")
    };
    ends_with(&side("G41", "99997"), "name=coordinate_range line=4 rules=E100L-ADDR-01", &setup());
    ends_with(&side("G42", "99997"), "end code=M02", &setup());
    holds(
        &side("G41", "99994.999"),
        "...\nlinear tz=99999.999\nlinear tz=99999.999\n...\nend code=M02",
        &setup(),
    );
}

/// Z alone in G17 has its limit in G01 too; on the side W alone asks nothing of Z, which is 5 mm beyond the limit in P alone.
#[test]
fn limits_of_motions_of_other_axes() {
    let mut with_z = setup();
    with_z.limits.z.positive = Some(Length(37_000_000));
    let program = format!("{FACE}G42 G00 X80\nG101 C90\nG01 Z38\nM02\n");
    ends_with(&program, "name=travel_limit_positive line=6 rules=E100L-NRC-80", &with_z);
    let program = "M110\nG94 G00 X100 Z20 C0 F100 T010101\nG119\nG42 G01 Z40\nC60\nW5\nC80\nM02\n";
    holds(
        program,
        "...\nlinear z=40 mz=35\nlinear z=40 mz=35\nlinear w=5 mz=35\nlinear mz=35\n...\nend code=M02",
        &with_z,
    );
    // Z stands at 0, beyond its limit. W alone has no word of Z and passes; the start-up has no first element.
    let mut beyond = setup();
    beyond.limits.z.negative = Some(Length(10_000_000));
    let program = format!("{FACE}G42 G01 X80\nW5\nM02\n");
    ends_with(&program, "name=unspecified detail=start_up line=4 rules=E100L-NRC-15", &beyond);
    // At the end of compensation: W 20 is within its limit, W 5 is not.
    let mut with_w = setup();
    with_w.limits.w.negative = Some(Length(10_000_000));
    let program = |w| format!("{FACE}G00 W30\nG42 X80\nG101 C90\nG40 G00 X120 W{w}\nM02\n");
    ends_with(&program(20), "end code=M02", &with_w);
    ends_with(&program(5), "name=travel_limit_negative line=7 rules=E100L-LIM-02", &with_w);
}

/// One barrier is enough (section 5, step 7).
#[test]
fn z_alone_in_g101_with_a_barrier() {
    for code in ["M25", "M21"] {
        let program = format!("{FACE}G42 G00 X80\nG101 C90\n{code} Z5\nM02\n");
        ends_with(&program, "name=not_modelled detail=barrier line=6 rules=E100L-CGF-01", &setup());
    }
}

/// CRC-14: in G91 a word is added to the coordinate: C from 70 by −30 is C40. The two programs make the
/// same motions.
#[test]
fn an_increment_of_c_is_added() {
    let motions = |words: &str| -> Vec<String> {
        let program = format!(
            "M110\nG94 G00 X200 Z100 C90 T010101\nG119\nG42 G00 C70 Z80\n{words}\nG90 Z40\nG40 G00 C20 Z30\nM02\n"
        );
        let events = trace(&program, &setup());
        assert!(events.last().is_some_and(|end| render(end).contains("end code=M02")), "{program}");
        let is_motion = |text: &String| text.starts_with("linear") || text.starts_with("rapid");
        let text = events.iter().map(render).filter(is_motion);
        text.map(|text| text.split(" rules=").next().unwrap_or_default().to_owned()).collect()
    };
    assert_eq!(motions("G91 G01 C-30 F100"), motions("G90 G01 C40 F100"));
}
