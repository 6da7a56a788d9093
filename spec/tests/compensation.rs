//! Laws of radius compensation that hold whatever the contour.

#![allow(clippy::panic)]

mod support;

use proptest::prelude::*;
use support::trace;
use turnspec_oracle::vocabulary::{Action, Event, Length, Motion, NoseRadius, PlanePosition, Setup};

/// One element of a contour: its end, and the radius of an arc, counter-clockwise if `ccw`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Step {
    x: i64,
    z: i64,
    arc: Option<(i64, bool)>,
}

/// A point of the contour in nanometres (z, x), x a radius, and half nanometres are halves.
type Plane = (f64, f64);

fn motion(event: &Event) -> Option<Motion> {
    match event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } | Action::Arc { motion, .. } => Some(motion),
        _ => None,
    }
}

/// The motions of a program that runs to its end; none if a corner of arcs has no common point.
fn run(program: &str, setup: &Setup) -> Option<Vec<Motion>> {
    let trace = trace(program, setup);
    let last = trace.last().map(|event| event.action);
    match last {
        Some(Action::End { .. }) => Some(trace.iter().filter_map(motion).collect()),
        Some(Action::Alarm(alarm)) if alarm.name.as_str().starts_with("compensation_") => None,
        _ => panic!("{program}\n{last:?}"),
    }
}

fn lines(program: &str, setup: &Setup) -> Vec<Motion> {
    run(program, setup).unwrap_or_else(|| panic!("{program}"))
}

/// Tool 1 with these amounts from the tip to the nose centre, in micrometres.
fn tool(x: i64, z: i64) -> Setup {
    let entry = NoseRadius { number: 1, x: Length(x * 1000), z: Length(z * 1000) };
    Setup { nose_radius: vec![entry], ..Setup::default() }
}

/// Millimetres as nanometres.
fn nm(value: i64) -> i64 {
    value * 1_000_000
}

fn block(step: &Step) -> String {
    let (x, z) = (step.x, step.z);
    match step.arc {
        None => format!("G01 X{x} Z{z}\n"),
        Some((radius, true)) => format!("G03 X{x} Z{z} L{radius}\n"),
        Some((radius, false)) => format!("G02 X{x} Z{z} L{radius}\n"),
    }
}

/// The contour with this code, begun in its first point.
fn program(code: &str, contour: &[Step]) -> String {
    let blocks: String = contour.iter().skip(1).map(block).collect();
    let start = contour.first().map_or((0, 0), |step| (step.x, step.z));
    format!("F1 T010101\n{code} G01 X{} Z{}\n{blocks}M02\n", start.0, start.1)
}

/// Points on a grid of 2 mm in diameter and 1 mm in Z, no two alike in succession.
fn contour(arcs: bool) -> impl Strategy<Value = Vec<Step>> {
    let step = (0..30_i64, -30..30_i64, 0..40_i64, any::<bool>(), any::<bool>());
    prop::collection::vec(step, 3..12)
        .prop_map(move |steps| {
            let mut contour: Vec<Step> = Vec::new();
            for (x, z, excess, ccw, straight) in steps {
                let (x, z) = (2 * x, z);
                let arc = contour.last().filter(|_| arcs && !straight).map(|last| {
                    let chord = ((x - last.x) as f64 / 2.0).hypot((z - last.z) as f64);
                    ((chord / 2.0) as i64 + 1 + excess, ccw)
                });
                if contour.last().is_none_or(|last| (last.x, last.z) != (x, z)) {
                    contour.push(Step { x, z, arc });
                }
            }
            contour
        })
        .prop_filter("an element after the start-up", |contour: &Vec<Step>| contour.len() > 2)
}

/// The same contour from its end to its start.
fn reversed(contour: &[Step]) -> Vec<Step> {
    let mut arc = None;
    let turned = contour.iter().rev().map(|step| {
        let here = Step { arc, ..*step };
        arc = step.arc.map(|(radius, ccw)| (radius, !ccw));
        here
    });
    turned.collect()
}

fn noses(motions: &[Motion]) -> Vec<Option<PlanePosition>> {
    motions.iter().map(|motion| motion.nose).collect()
}

/// (z, x) of a diameter and a Z.
fn plane(x: i64, z: i64) -> Plane {
    (z as f64, x as f64 / 2.0)
}

fn nose(motion: &Motion) -> Plane {
    motion.nose.map_or((f64::NAN, f64::NAN), |nose| plane(nose.x.0, nose.z.0))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// With the radius zero the tip and the nose centre follow the programmed path.
    ///
    /// Rules: E100L-NRC-04, E100L-NRC-07, E100L-NRC-13, E100L-NRC-45, E100L-NRC-46
    #[test]
    fn radius_zero_is_the_identity(contour in contour(true), twice in any::<prop::sample::Index>(), left in any::<bool>()) {
        let mut blocks = contour.clone();
        let again = 3 + twice.index(contour.len() - 2);
        blocks.insert(again, Step { arc: None, ..contour[again - 1] });
        let code = if left { "G41" } else { "G42" };
        let compensated = run(&program(code, &blocks), &Setup::default());
        let plain = lines(&program("G40", &blocks), &Setup::default());
        let Some(compensated) = compensated else { panic!("no contour with radius zero is refused") };
        prop_assert_eq!(compensated.len(), plain.len());
        for (motion, plain) in compensated.iter().zip(&plain) {
            let point = PlanePosition { x: plain.program.x, z: plain.program.z };
            prop_assert_eq!((motion.program, motion.machine), (plain.program, plain.machine));
            prop_assert_eq!((motion.tip, motion.nose), (Some(point), Some(point)));
        }
    }

    /// At the end of every line the nose circle touches it, on its side, and at a corner that is no return it touches
    /// the next line as well.
    ///
    /// Rules: E100L-NRC-02, E100L-NRC-26, E100L-NRC-30, E100L-NRC-32, E100L-NRC-44
    #[test]
    fn the_nose_circle_touches_the_lines(contour in contour(false), radius in 1..3_000_i64, left in any::<bool>()) {
        let code = if left { "G41" } else { "G42" };
        let side = if left { 1.0 } else { -1.0 };
        let motions = lines(&program(code, &contour), &tool(radius, radius));
        let point = |index: usize| plane(nm(contour[index].x), nm(contour[index].z));
        let direction = |index: usize| {
            let (from, to) = (point(index - 1), point(index));
            let length = (to.0 - from.0).hypot(to.1 - from.1);
            ((to.0 - from.0) / length, (to.1 - from.1) / length)
        };
        // How far the centre is to the left of the line through a point.
        let aside = |centre: Plane, through: Plane, d: Plane| {
            (centre.1 - through.1) * d.0 - (centre.0 - through.0) * d.1
        };
        let touches = |aside: f64| (aside - side * radius as f64 * 1000.0).abs() < 1.5;
        for (index, motion) in motions.iter().enumerate().skip(1) {
            let centre = nose(motion);
            let here = direction(index);
            prop_assert!(touches(aside(centre, point(index), here)), "{} on its own line", index);
            if index + 1 < contour.len() {
                let next = direction(index + 1);
                let cross = here.0 * next.1 - here.1 * next.0;
                if cross.abs() > 1e-9 {
                    prop_assert!(touches(aside(centre, point(index), next)), "{} on the next line", index);
                }
            }
        }
    }

    /// Between two arcs, or an arc and a line, the nose centre is on the offset circle.
    ///
    /// Rules: E100L-NRC-48, E100L-NRC-49, E100L-NRC-51, E100L-NRC-52
    #[test]
    fn the_nose_circle_touches_the_arcs(contour in contour(true), radius in 1..1_000_i64, left in any::<bool>()) {
        let code = if left { "G41" } else { "G42" };
        let side = if left { 1.0 } else { -1.0 };
        let events = trace(&program(code, &contour), &tool(radius, radius));
        let mut before = (0.0, 0.0);
        let motions = events.iter().filter_map(|event| motion(event).map(|motion| (event.action, nose(&motion))));
        for ((action, centre), step) in motions.zip(&contour) {
            if let (Action::Arc { centre_x, centre_z, .. }, Some((of_arc, ccw))) = (action, step.arc) {
                let sense = if ccw { 1.0 } else { -1.0 };
                let expected = nm(of_arc) as f64 - side * sense * radius as f64 * 1000.0;
                let middle = plane(centre_x.0, centre_z.0);
                for nose in [before, centre] {
                    let distance = (nose.0 - middle.0).hypot(nose.1 - middle.1);
                    prop_assert!((distance - expected).abs() < 6.0, "{distance} {expected}");
                }
            }
            prop_assert_eq!(matches!(action, Action::Arc { .. }), step.arc.is_some());
            before = centre;
        }
    }

    /// A contour mirrored in X, with the other side and a mirrored tool, has the mirrored path.
    ///
    /// Rules: E100L-NRC-02, E100L-NRC-03, E100L-NRC-05, E100L-NRC-07
    #[test]
    fn a_mirrored_contour_has_the_mirrored_path(contour in contour(true), amounts in (-900..900_i64, -900..900_i64), left in any::<bool>()) {
        let (code, other_code) = if left { ("G41", "G42") } else { ("G42", "G41") };
        let mirror = |step: &Step| Step { x: -step.x, z: step.z, arc: step.arc.map(|(radius, ccw)| (radius, !ccw)) };
        let mirrored: Vec<Step> = contour.iter().map(mirror).collect();
        let one = run(&program(code, &contour), &tool(amounts.0, amounts.1));
        let other = run(&program(other_code, &mirrored), &tool(-amounts.0, amounts.1));
        prop_assert_eq!(one.is_some(), other.is_some());
        for (motion, image) in one.iter().flatten().zip(other.iter().flatten()) {
            let back = |point: PlanePosition| PlanePosition { x: Length(-point.x.0), z: point.z };
            prop_assert_eq!((motion.tip, motion.nose), (image.tip.map(back), image.nose.map(back)));
            prop_assert_eq!((motion.machine.x.0, motion.machine.z), (-image.machine.x.0, image.machine.z));
        }
    }

    /// A translated contour has the translated path.
    ///
    /// Rules: E100L-NRC-07, E100L-NRC-13
    #[test]
    fn a_translated_contour_has_the_translated_path(contour in contour(true), shift in (-40..40_i64, -40..40_i64)) {
        let moved: Vec<Step> =
            contour.iter().map(|step| Step { x: step.x + shift.0, z: step.z + shift.1, ..*step }).collect();
        let (one, other) =
            (run(&program("G42", &contour), &tool(813, 813)), run(&program("G42", &moved), &tool(813, 813)));
        prop_assert_eq!(one.is_some(), other.is_some());
        for (motion, image) in one.iter().flatten().zip(other.iter().flatten()) {
            prop_assert_eq!(image.machine.x.0 - motion.machine.x.0, nm(shift.0));
            prop_assert_eq!(image.machine.z.0 - motion.machine.z.0, nm(shift.1));
        }
    }

    /// A point on a line changes nothing of the rest of the path.
    ///
    /// Rules: E100L-NRC-13, E100L-NRC-30
    #[test]
    fn splitting_a_line_changes_nothing(contour in contour(true), place in any::<prop::sample::Index>()) {
        let double = |step: &Step| {
            Step { x: 2 * step.x, z: 2 * step.z, arc: step.arc.map(|(radius, ccw)| (2 * radius, ccw)) }
        };
        let contour: Vec<Step> = contour.iter().map(double).collect();
        let straight: Vec<usize> = (1..contour.len()).filter(|index| contour[*index].arc.is_none()).collect();
        prop_assume!(!straight.is_empty());
        let index = straight[place.index(straight.len())];
        let (from, to) = (contour[index - 1], contour[index]);
        let mut split = contour.clone();
        split.insert(index, Step { x: (from.x + to.x) / 2, z: (from.z + to.z) / 2, arc: None });
        let (one, other) = (run(&program("G41", &contour), &tool(800, 800)), run(&program("G41", &split), &tool(800, 800)));
        prop_assert_eq!(one.is_some(), other.is_some());
        if let (Some(one), Some(mut other)) = (one, other) {
            other.remove(index);
            prop_assert_eq!(one, other);
        }
    }

    /// The contour from its end to its start with the tool on the same side of the material has the same corners.
    ///
    /// Rules: E100L-NRC-26, E100L-NRC-31, E100L-NRC-49, E100L-NRC-51, E100L-NRC-52
    #[test]
    fn a_reversed_contour_has_the_same_corners(contour in contour(true), radius in 1..1_000_i64) {
        let back = reversed(&contour);
        let straight_return = |window: &[Step]| {
            let [a, b, c] = window else { return false };
            let (di, dj) = ((b.x - a.x, 2 * (b.z - a.z)), (c.x - b.x, 2 * (c.z - b.z)));
            b.arc.is_none() && c.arc.is_none() && di.0 * dj.1 == di.1 * dj.0 && di.0 * dj.0 + di.1 * dj.1 < 0
        };
        // The special processing of a return stays on the incoming side.
        prop_assume!(!contour.windows(3).any(straight_return));
        let one = run(&program("G42", &contour), &tool(radius, radius));
        let other = run(&program("G41", &back), &tool(radius, radius));
        prop_assert_eq!(one.is_some(), other.is_some());
        if let (Some(one), Some(other)) = (one, other) {
            let (mut there, mut back) = (noses(&one), noses(&other));
            back.reverse();
            there.truncate(contour.len() - 1);
            back.truncate(contour.len() - 1);
            prop_assert_eq!(&there[1..], &back[1..]);
        }
    }

    /// One block without axis motion after each element changes nothing of the path; two overcut it at most until the
    /// next element begins where it would have begun.
    ///
    /// Rules: E100L-NRC-43, E100L-NRC-44, E100L-NRC-46
    #[test]
    fn blocks_without_motion_keep_the_corners(contour in contour(false)) {
        let plain = program("G42", &contour);
        let with = |blocks: &str| {
            let mut kept = 0;
            plain.lines().map(|line| {
                kept += 1;
                if kept > 2 && !line.starts_with('M') { format!("{line}\n{blocks}") } else { format!("{line}\n") }
            }).collect::<String>()
        };
        let one = lines(&plain, &tool(800, 800));
        prop_assert_eq!(&one, &lines(&with("M08\n"), &tool(800, 800)));
        let two = lines(&with("M08\nM09\n"), &tool(800, 800));
        // Where an element begins: behind the extra motions.
        let last_of = |motions: &[Motion], step: &Step| {
            let at = |motion: &&Motion| (motion.program.x.0, motion.program.z.0) == (nm(step.x), nm(step.z));
            motions.iter().rev().find(at).and_then(|motion| motion.nose)
        };
        let unlike = |step: &&Step| contour.iter().filter(|other| (other.x, other.z) == (step.x, step.z)).count() == 1;
        for step in contour.iter().filter(unlike) {
            prop_assert_eq!(last_of(&one, step), last_of(&two, step));
        }
    }

    /// Increments count from the programmed point.
    ///
    /// Rules: E100L-NRC-83
    #[test]
    fn increments_count_from_the_programmed_point(contour in contour(false)) {
        let absolute = lines(&program("G42", &contour), &tool(800, 800));
        let mut present = (0, 0);
        let steps: Vec<Step> = contour.iter().map(|step| {
            let increment = Step { x: step.x - present.0, z: step.z - present.1, arc: None };
            present = (step.x, step.z);
            increment
        }).collect();
        prop_assert_eq!(absolute, lines(&program("G42 G91", &steps), &tool(800, 800)));
    }
}

/// Kind, line and Z of each motion or alarm.
fn outline(program: &str, setup: &Setup) -> Vec<String> {
    let told = |event: &Event| match (event.action, motion(event)) {
        (Action::Alarm(alarm), _) => Some(format!("{} {}", event.block.line, alarm.name)),
        (_, Some(motion)) => Some(format!("{} Z{}", event.block.line, motion.program.z)),
        _ => None,
    };
    trace(program, setup).iter().filter_map(told).collect()
}

/// The motion in front of a G40 block ends before the limits of X and Z are tested there, and after that of W
/// (E100L-NRC-12, E100L-NRC-66).
#[test]
fn limits_of_a_block_that_ends_compensation() {
    let mut setup = tool(800, 800);
    setup.options.w_axis = true;
    setup.limits.w.negative = Some(Length(-1_000_000));
    setup.limits.x.negative = Some(Length(50_000_000));
    let program = |words: &str| format!("G42 G01 X100 Z100 F0.2 T010101\nZ50\nG40 {words}\nM02\n");
    assert_eq!(outline(&program("X60 W-1"), &setup), ["1 Z100", "2 Z50", "3 Z50"]);
    assert_eq!(outline(&program("X40 W-1"), &setup), ["1 Z100", "2 Z50", "3 travel_limit_negative"]);
    assert_eq!(outline(&program("X60 W-2"), &setup), ["1 Z100", "3 travel_limit_negative"]);
    assert_eq!(outline(&program("W-2"), &setup), ["1 Z100", "3 travel_limit_negative"]);
}

/// However many blocks without axis motion follow, each is carried out when it is read, from the second one on
/// (E100L-NRC-44).
#[test]
fn blocks_without_motion_are_not_held_for_long() {
    let program = format!("G42 G01 X100 Z100 F0.2\nZ50\n{}X120\nM02\n", "M08\n".repeat(1000));
    let setup = Setup::default();
    let mut run = turnspec_oracle::Run::new(program.as_bytes(), &setup);
    let mut sent = [0; 1004];
    for count in &mut sent {
        run.step(&mut |_: &Event| *count += 1);
    }
    // Modes of the start-up block; the start-up; nothing; the element and two blocks; a block each; the way to the
    // corner is none.
    assert_eq!(sent[..5], [2, 1, 0, 3, 1]);
    assert!(sent[4..1002].iter().all(|count| *count == 1));
}
