//! Contours and coordinate conversion beside the examples of the rules.

use turnspec_oracle::vocabulary::{Event, Setup, notation};

use crate::engine::{Interpreter, SlowPaths};

/// The events of a program in compact notation, and the slow paths.
fn trace(program: &str) -> (Vec<String>, SlowPaths) {
    let setup = Setup::default();
    let mut interpreter = Interpreter::new(program.as_bytes(), &setup);
    let mut events = Vec::new();
    while interpreter.step(&mut |event: &Event| events.push(notation::render(event))).is_none() {}
    (events, interpreter.slow_paths())
}

/// Whether an event of a program has all of some fields.
fn has(program: &str, fields: &[&str]) -> bool {
    let (events, _) = trace(program);
    events.iter().any(|event| fields.iter().all(|field| event.split(' ').any(|part| part == *field)))
}

#[test]
fn no_motion_code_outside_of_conversion_mode() {
    let program = "G137 C0\nG136\nX5\nM02\n";
    assert!(has(program, &["alarm", "name=motion_code_missing", "line=3"]));
    assert!(has("G137 C0\nG136\nG01 X5 F0.2\nM02\n", &["mode", "code=G01"]));
}

#[test]
fn codes_that_conversion_mode_leaves_undescribed() {
    assert!(has("G137 C0\nG71 X5 Z5 D1 H2 F1\nM02\n", &["name=unspecified", "detail=G71"]));
    assert!(has("G137 C0\nG132 Z5 L5 F1\nM02\n", &["name=unspecified", "detail=G132"]));
}

#[test]
fn the_kept_point_does_not_outlive_its_frame() {
    let head = "M110\nG137 C0\nG00 X30 Y40\n";
    // The same program X and C, by another zero shift.
    let moved = format!("{head}VZSHC=10 VZOFC=-10\nY20\nM02\n");
    assert!(has(&moved, &["name=unspecified", "detail=start", "line=5"]));
    let back = format!("{head}VZSHC=10 VZSHC=0\nY20\nM02\n");
    assert!(has(&back, &["rapid", "px=30", "py=20"]));
}

#[test]
fn compensation_neither_begins_nor_ends_with_a_line_of_the_face() {
    assert!(has("M110\nG94 F100\nG101\nG42\nM02\n", &["name=unspecified", "detail=G101", "line=4"]));
    let head = "M110\nG94 F100\nG42 G01 X50 Z50 T010101\nZ20\n";
    let ended = format!("{head}G40 G17 G101 X20\nM02\n");
    assert!(has(&ended, &["name=unspecified", "detail=G101", "line=5"]));
}

#[test]
fn compensation_neither_begins_nor_ends_in_an_arc_of_the_c_axis() {
    for (plane, code) in [("G17", "G102"), ("G17", "G103"), ("G119", "G132"), ("G119", "G133")] {
        let begun = format!("M110\nG94 F100\n{plane} {code}\nG42 C10 L50\nM02\n");
        let words = ["name=unspecified", "detail=start_up", "rules=E100L-CRC-14"];
        assert!(has(&begun, &words), "{code}");
    }
    // In the plane of turning it is that of the nose.
    for code in ["G102", "G103", "G132", "G133"] {
        let begun = format!("M110\nG94 F100\n{code}\nG42\nM02\n");
        assert!(has(&begun, &["name=compensation_not_linear", "rules=E100L-NRC-19"]), "{code}");
        let ended = format!("M110\nG94 F100\nG42 G01 X50 Z50 T010101\nZ20\nG40 {code}\nM02\n");
        assert!(has(&ended, &["name=compensation_not_linear", "rules=E100L-NRC-72"]), "{code}");
    }
    assert!(has("G94 F100\nG102\nG42 G02\nM02\n", &["name=compensation_not_linear"]));
}

#[test]
fn a_corner_before_conversion_mode() {
    assert!(has("G01 G75 X10 Z10 L1 F0.2\nG137 C0\nM02\n", &["name=chamfer_corner", "line=1"]));
}

#[test]
fn travels_of_the_c_axis_wind_it_in_every_motion() {
    let wind = "QA=1999\n".repeat(3);
    let program = format!("M110\nG94 G00 X100 {wind}G132 Z20 C60 L60 F100\nM02\n");
    assert!(has(&program, &["name=profile_generation", "number=2480"]));
    let program = format!("M110\nG94 G00 X100 {wind}M110\nG132 Z20 C60 L60 F100\nM02\n");
    assert!(has(&program, &["contour_arc", "c_travel=60"]));
}

#[test]
fn an_arc_on_an_axis_takes_no_slow_path() {
    let (events, slow) = trace("M110\nG94 G00 X100 C10\nG103 C190 L50 F100\nG101 X0\nX40 C33\nM02\n");
    assert_eq!(events.iter().filter(|event| event.contains("contour_arc")).count(), 1);
    assert_eq!(slow, SlowPaths::default());
}
