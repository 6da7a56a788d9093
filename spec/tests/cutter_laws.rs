//! Laws of cutter radius compensation: a contour of the face is that of the nose centre in turning; on the side the cutter
//! touches both lines of a corner; what is written wildly is refused, or carried out.

mod support;

use proptest::prelude::*;
use support::trace;
use turnspec_oracle::vocabulary::{Action, Length, Motion, NoseRadius, Setup, SidePlane};

/// One element of a contour: its end in millimetres, and the radius of an arc, counter-clockwise if `ccw`.
#[derive(Clone, Copy, Debug)]
struct Step {
    p: i64,
    q: i64,
    arc: Option<(i64, bool)>,
}

fn setup(radius: i64) -> Setup {
    let entry = NoseRadius { number: 1, x: Length(radius * 1000), z: Length(radius * 1000) };
    Setup { nose_radius: vec![entry], ..Setup::default() }
}

/// The last motion of each line of a program that runs to its end.
fn motions(program: &str, setup: &Setup) -> Option<Vec<Motion>> {
    let trace = trace(program, setup);
    if !matches!(trace.last().map(|event| event.action), Some(Action::End { .. })) {
        return None;
    }
    let mut motions: Vec<(u32, Motion)> = Vec::new();
    for event in trace {
        if let Action::Rapid { motion }
        | Action::Linear { motion, .. }
        | Action::Arc { motion, .. }
        | Action::ContourArc { motion, .. } = event.action
        {
            motions.retain(|(line, _)| *line != event.block.line);
            motions.push((event.block.line, motion));
        }
    }
    Some(motions.into_iter().map(|(_, motion)| motion).collect())
}

/// Points on a grid of a millimetre, no two alike in succession; at first a way to the contour.
fn contour(arcs: bool) -> impl Strategy<Value = Vec<Step>> {
    let step = (-30..30_i64, -30..30_i64, 0..40_i64, any::<bool>(), any::<bool>());
    prop::collection::vec(step, 4..10).prop_map(move |steps| {
        let mut contour: Vec<Step> = Vec::new();
        for (p, q, excess, ccw, straight) in steps {
            let last = contour.last().map(|last| (last.p, last.q));
            if last == Some((p, q)) {
                continue;
            }
            let chord = last.map_or(0.0, |(from, to)| (((p - from).pow(2) + (q - to).pow(2)) as f64).sqrt());
            let radius = (chord / 2.0).ceil() as i64 + excess;
            let arc = (arcs && !straight && contour.len() > 1).then_some((radius, ccw));
            contour.push(Step { p, q, arc });
        }
        contour
    })
}

/// The contour on the face in conversion mode, and in turning, z for p and x for q.
fn programs(code: &str, contour: &[Step]) -> (String, String) {
    let mut face = "M110\nG94 F9 T010101\nG137 C20\nG17\n".to_owned();
    let mut turning = "F1 T010101\n\n\n\n".to_owned();
    for (index, Step { p, q, arc }) in contour.iter().enumerate() {
        let x = 2 * q;
        let begin = if index == 1 { code } else { "" };
        let (of_face, of_turning, radius) = match arc {
            _ if index == 0 => ("G00", "G00", String::new()),
            None => ("G101", "G01", String::new()),
            Some((radius, true)) => ("G103", "G03", format!("L{radius}")),
            Some((radius, false)) => ("G102", "G02", format!("L{radius}")),
        };
        face += &format!("{begin} {of_face} X{p} Y{q} {radius}\n");
        turning += &format!("{begin} {of_turning} X{x} Z{p} {radius}\n");
    }
    (face + "M02\n", turning + "M02\n")
}

/// How far, in nanometres, the cutter centre is from the nose centre at most.
fn apart(code: &str, contour: &[Step], radius: i64) -> Option<i64> {
    let (face, turning) = programs(code, contour);
    let (face, turning) = (motions(&face, &setup(radius))?, motions(&turning, &setup(radius))?);
    assert_eq!(face.len(), turning.len());
    let pairs = face.iter().zip(&turning).filter_map(|(face, turning)| face.face_tip.zip(turning.nose));
    Some(pairs.fold(0, |most, (cutter, nose)| {
        most.max((cutter.x.0 - nose.z.0).abs()).max((2 * cutter.y.0 - nose.x.0).abs())
    }))
}

proptest! {
    #[test]
    fn lines_of_the_face_are_those_of_turning(contour in contour(false), radius in 0..6000_i64) {
        for code in ["G41", "G42"] {
            if let Some(apart) = apart(code, &contour, radius) {
                // X is latched as a diameter, q as a radius.
                prop_assert!(apart <= 1, "{apart}");
            }
        }
    }

    /// Centres of arcs are latched in another way; where circles nearly touch, a nanometre moves a corner far.
    #[test]
    fn arcs_of_the_face_are_those_of_turning(contour in contour(true), radius in 0..6000_i64) {
        for code in ["G41", "G42"] {
            if let Some(apart) = apart(code, &contour, radius) {
                prop_assert!(apart <= 100_000, "{apart}");
            }
        }
    }

    #[test]
    fn on_the_side_the_cutter_touches_both_lines(
        contour in contour(false), radius in 1..3000_i64, right: bool, inner: bool,
    ) {
        let code = if right { "G42" } else { "G41" };
        let mut blocks = String::new();
        for (index, step) in contour.iter().enumerate() {
            let (c, z) = (step.p + 100, step.q);
            blocks += &format!("{} C{c} Z{z}\n", if index == 0 { code } else { "G01" });
        }
        let program = format!("M110\nG94 F9 T010101\nG00 X100 C9\nG119\n{blocks}M02\n");
        let mut setup = setup(radius);
        setup.parameters.side_plane = if inner { SidePlane::Inner } else { SidePlane::Outer };
        // M15 goes once round for every way back: the plane of P is unwound.
        let (mut turned, mut before) = (0.0, 9);
        let mut points = Vec::new();
        for step in &contour {
            turned += (step.p + 100 - before).rem_euclid(360) as f64;
            before = step.p + 100;
            points.push((turned * std::f64::consts::PI / 3.6, step.q as f64));
        }
        let Some(motions) = motions(&program, &setup) else { return Ok(()) };
        let cutters: Vec<(f64, f64)> = motions.iter().filter_map(|motion| {
            let (tip, c) = (motion.tip?, motion.tip_c?);
            let aside = (c.0 - motion.program.c?.0 + 180_000_000).rem_euclid(360_000_000) - 180_000_000;
            Some((aside as f64 * std::f64::consts::PI / 3.6e6, (tip.z.0 - motion.program.z.0) as f64 / 1e6))
        }).collect();
        let side = if right == inner { 1.0 } else { -1.0 };
        for (index, (u, z)) in cutters.iter().enumerate().skip(1) {
            let (Some(from), Some(to)) = (points.get(index - 1), points.get(index)) else { continue };
            let (along, up) = (to.0 - from.0, to.1 - from.1);
            let length = along.hypot(up);
            // Of a corner whose place is more than half round aside nothing is known here.
            if u.abs() < 150.0 && z.abs() < 150.0 {
                let left = (along * z - up * u) / length;
                prop_assert!((left - side * radius as f64 / 1e3).abs() < 1e-5, "{program}{left}");
            }
        }
    }

    /// Whatever stands there, the run ends, and C gets where its travels lead. (On a ray C does not turn, though the last
    /// micro-degree of both ends may differ.)
    #[test]
    fn wild_programs_end(blocks in prop::collection::vec(
        (0..40_usize, -40..40_i64, -40..40_i64, 1..80_i64, any::<bool>()), 1..14), plane in 0..3_usize) {
        let begin = ["G17 G42 X80 C20\n", "G119 G42 Z30 C20\n", "G137 C30\nG17 G00 X30 Y5\nG42 X40\n"];
        let begin = begin.get(plane).copied().unwrap_or_default();
        let mut program = format!("M110\nG94 F9 T010101\nG00 X60 Z20 C10\n{begin}");
        for (code, one, other, radius, both) in blocks {
            let arc = match (plane, both) {
                (1, true) => "G132",
                (1, false) => "G133",
                (_, true) => "G102",
                (_, false) => "G103",
            };
            let line = if plane == 1 { "G01" } else { "G101" };
            let target = match (plane, both) {
                (0, true) => format!("X{} C{}", 2 * one.abs(), 9 * other),
                (0, false) => format!("C{}", 9 * other),
                (1, true) => format!("Z{one} C{}", 5 * other),
                (1, false) => format!("Z{one}"),
                (_, true) => format!("X{one} Y{other}"),
                (_, false) => format!("Y{one}"),
            };
            program += &match code {
                0 => format!("G40 {target}\nG42 {line} {target}\n"),
                1 => "VZOFC=1\n".to_owned(),
                2 => "M16\n".to_owned(),
                3 => "G91\n".to_owned(),
                4 => "G01 Z5\n".to_owned(),
                5 => format!("{line} {target} Z{other} \n"),
                6 => "T020202\n".to_owned(),
                7 => format!("G40 {target}\nG41 G00 {target}\n"),
                8..=12 => format!("G00 {target}\n"),
                13..=24 => format!("{arc} {target} L{radius}\n"),
                _ => format!("{line} {target}\n"),
            };
        }
        let trace = trace(&(program + "M02\n"), &setup(3000));
        let last = trace.last().map(|event| event.action);
        let ended = matches!(last, Some(Action::End { .. } | Action::Alarm(_)));
        prop_assert!(ended);
        let mut at = 0;
        for event in &trace {
            if let Action::Rapid { motion } | Action::Linear { motion, .. } | Action::ContourArc { motion, .. } =
                event.action
            {
                let place = motion.machine.c.map_or(0, |c| c.0);
                let way = motion.c_travel.map_or(0, |travel| travel.0);
                let off = (at + way - place + 2).rem_euclid(360_000_000);
                prop_assert!(off <= 4, "{off}");
                at = place;
            }
        }
    }
}
