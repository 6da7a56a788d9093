//! Contours that look like chance: along each element the cutter centre is at the distance of the radius, and the axes
//! are where it is. Computed apart, in `f64`.

use std::f64::consts::PI;

use turnspec_oracle::vocabulary::{Action, ContourPlane, Event, Motion, Sense, Setup, SidePlane};

use crate::engine::run;

/// A number from 0 to below a bound, of a sequence that looks like chance.
fn chance(seed: &mut u64, below: u64) -> u64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 33) % below
}

/// So many steps of a half between two bounds.
fn between(seed: &mut u64, low: i32, high: i32) -> f64 {
    let steps = u64::from((high - low).unsigned_abs()) * 2 + 1;
    f64::from(low) + chance(seed, steps) as f64 / 2.0
}

type Point = (f64, f64);

fn minus(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

fn cross(a: Point, b: Point) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

/// An element: its code, where it ends, its radius.
#[derive(Clone, Copy, Debug)]
struct Element {
    code: u16,
    end: Point,
    radius: f64,
}

fn events(program: &str, setup: &Setup) -> Vec<Event> {
    let mut events = Vec::new();
    run(program.as_bytes(), setup, &mut |event: &Event| events.push(*event));
    events
}

fn motion_of(event: &Event) -> Option<(Motion, Option<(Sense, ContourPlane)>)> {
    match event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } => Some((motion, None)),
        Action::ContourArc { motion, sense, plane, .. } => Some((motion, Some((sense, plane)))),
        _ => None,
    }
}

fn millimetres(value: i64) -> f64 {
    value as f64 / 1e6
}

/// The distance to the left of a line at which a point lies; nothing where the line has no direction.
fn beside(from: Point, to: Point, point: Point) -> f64 {
    let way = minus(to, from);
    cross(way, minus(point, to)) / way.0.hypot(way.1)
}

/// The angle about the centre of the face by which an arc turns, in degrees, by small steps along it.
fn turned_along((from, to): (Point, Point), centre: Point, sense: Sense) -> f64 {
    let (first, last) = (minus(from, centre), minus(to, centre));
    let sign = if sense == Sense::CounterClockwise { 1.0 } else { -1.0 };
    let start = first.1.atan2(first.0);
    let whole = (sign * (last.1.atan2(last.0) - start)).rem_euclid(2.0 * PI);
    let radius = first.0.hypot(first.1);
    let at = |part: f64| {
        let angle = start + sign * whole * part;
        (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin())
    };
    let steps = 4000;
    let turn = |step: i32| {
        let (before, after) =
            (at(f64::from(step - 1) / f64::from(steps)), at(f64::from(step) / f64::from(steps)));
        let dot = before.0 * after.0 + before.1 * after.1;
        cross(before, after).atan2(dot)
    };
    (1..=steps).map(turn).sum::<f64>().to_degrees()
}

#[track_caller]
fn near(found: f64, expected: f64, what: &str, program: &str) {
    assert!((found - expected).abs() < 2e-3, "{what}: {found}, not {expected}\n{program}");
}

/// The corner of an element with the next one is on the side of both; after it nothing is known where they turn back or
/// nearly so.
fn is_sharp(before: Point, at: Point, after: Point) -> bool {
    let (a, b) = (minus(at, before), minus(after, at));
    cross(a, b).abs() < 0.2 * a.0.hypot(a.1) * b.0.hypot(b.1)
}

#[test]
fn cutters_on_the_face() {
    let mut checked = [0; 3];
    for seed in 0..3000 {
        let seed = &mut (seed * 77 + 5);
        let radius = between(seed, 0, 4);
        let left = chance(seed, 2) == 0;
        let side = if left { 1.0 } else { -1.0 };
        let mut start = (between(seed, -60, 60), between(seed, -60, 60));
        let mut program = format!(
            "M110\nVNSRX[1]={radius} VNSRZ[1]={radius}\nG137 C0\nG17 G94 F1000\nG00 X{} Y{} T010101\n",
            start.0, start.1
        );
        let mut elements = Vec::new();
        for number in 0..6 {
            let end = (between(seed, -60, 60), between(seed, -60, 60));
            let code = match chance(seed, 4) {
                0 if number > 0 => 102,
                1 if number > 0 => 103,
                _ => 101,
            };
            let chord = minus(end, start);
            let radius = (chord.0.hypot(chord.1) * 0.75).ceil() + 1.0;
            let begins = if number == 0 { if left { "G41 " } else { "G42 " } } else { "" };
            let word = if code == 101 { String::new() } else { format!(" L{radius}") };
            program += &format!("{begins}G{code} X{} Y{}{word}\n", end.0, end.1);
            elements.push(Element { code, end, radius });
            start = end;
        }
        program += "G40 G101 X70 Y0\nM02\n";
        let events = events(&program, &Setup::default());
        let motions: Vec<_> = events.iter().filter_map(|event| Some((event, motion_of(event)?))).collect();
        let mut last: Option<(Point, Point, Motion)> = None;
        for (event, (motion, arc)) in &motions {
            let line = usize::try_from(event.block.line).unwrap_or_default();
            let (Some(tip), Some(at)) = (motion.face_tip, motion.face) else { continue };
            let (tip, at) =
                ((millimetres(tip.x.0), millimetres(tip.y.0)), (millimetres(at.x.0), millimetres(at.y.0)));
            let Some(element) = line.checked_sub(6).and_then(|index| elements.get(index)) else { continue };
            near(at.0, element.end.0, "px", &program);
            let angle = motion.machine.c.map_or(0.0, |c| millimetres(c.0)).to_radians();
            let diameter = millimetres(motion.machine.x.0);
            if motion.part.is_none() {
                near(diameter / 2.0 * angle.cos(), tip.0, "p of the axes", &program);
                near(diameter / 2.0 * angle.sin(), tip.1, "q of the axes", &program);
            }
            let travel = motion.c_travel.map_or(0, |travel| travel.0);
            if let Some((from, tip_before, before)) = last {
                let c = |motion: &Motion| motion.machine.c.map_or(0, |c| c.0);
                assert_eq!((c(&before) + travel).rem_euclid(360_000_000), c(motion), "{program}");
                match arc {
                    None if element.code == 101 && motion.part.is_none() => {
                        let next = elements.get(line - 5);
                        if next.is_none_or(|next| next.code == 101 && !is_sharp(from, at, next.end)) {
                            near(beside(from, at, tip), side * radius, "distance at the end", &program);
                            checked[0] += 1;
                        }
                        let sense = cross(tip_before, tip).signum();
                        assert!(travel as f64 * sense >= 0.0 && travel.abs() <= 180_000_000, "{program}");
                    }
                    Some((sense, ContourPlane::FaceCentre(centre))) => {
                        let centre = (millimetres(centre.x.0), millimetres(centre.y.0));
                        let sign = if *sense == Sense::CounterClockwise { 1.0 } else { -1.0 };
                        let offset = element.radius - side * sign * radius;
                        let [first, second] = [tip_before, tip].map(|tip| minus(tip, centre));
                        near(first.0.hypot(first.1), offset, "radius at the start", &program);
                        near(second.0.hypot(second.1), offset, "radius at the end", &program);
                        assert!(sign * cross(first, second) >= -1e-6, "more than half a circle\n{program}");
                        let turned = turned_along((tip_before, tip), centre, *sense);
                        near(turned, millimetres(travel), "travel of C", &program);
                        checked[1] += 1;
                    }
                    _ => {}
                }
            }
            last = Some((at, tip, *motion));
        }
        checked[2] +=
            usize::from(matches!(events.last().map(|event| event.action), Some(Action::End { .. })));
    }
    assert!(checked[0] > 2000 && checked[1] > 700 && checked[2] > 300, "{checked:?}");
}

#[test]
fn cutters_on_the_side() {
    let mut checked = [0; 3];
    for seed in 0..3000 {
        let seed = &mut (seed * 91 + 3);
        let inner = chance(seed, 2) == 0;
        let radius = between(seed, 0, 4);
        let left = chance(seed, 2) == 0;
        // The side in u and Z, seen from outside.
        let side = if left != inner { 1.0 } else { -1.0 };
        let diameter = between(seed, 60, 200);
        let length = |degrees: f64| PI * diameter * degrees / 360.0;
        let mut start = (0.0, 50.0);
        let mut program = format!(
            "M110\nVNSRX[1]={radius} VNSRZ[1]={radius}\nG119 G94 F1000\nG00 X{diameter} Z50 C0 T010101\n"
        );
        let mut elements = Vec::new();
        let mut degrees = 0.0;
        for number in 0..6 {
            let travel = if number == 0 { 0.0 } else { between(seed, 1, 60) };
            degrees += travel;
            let end = (length(degrees), between(seed, 0, 100));
            let code = match chance(seed, 4) {
                0 if number > 0 => 132,
                1 if number > 0 => 133,
                _ => 1,
            };
            let chord = minus(end, start);
            let radius = (chord.0.hypot(chord.1) * 0.75).ceil() + 1.0;
            let begins = if number == 0 { if left { "G41 " } else { "G42 " } } else { "" };
            let word = if code == 1 { String::new() } else { format!(" L{radius}") };
            program += &format!("{begins}G{code} Z{} C{}{word}\n", end.1, degrees % 360.0);
            elements.push(Element { code, end, radius });
            start = end;
        }
        program += "G40 G01 Z120\nM02\n";
        let mut setup = Setup::default();
        if inner {
            setup.parameters.side_plane = SidePlane::Inner;
        }
        let events = events(&program, &setup);
        let mut last: Option<(Point, Point)> = None;
        for event in &events {
            let Some((motion, arc)) = motion_of(event) else { continue };
            let (Some(tip), Some(tip_c), Some(c)) = (motion.tip, motion.tip_c, motion.program.c) else {
                continue;
            };
            let line = usize::try_from(event.block.line).unwrap_or_default();
            let Some(element) = line.checked_sub(5).and_then(|index| elements.get(index)) else { continue };
            let aside = (millimetres(tip_c.0 - c.0) + 180.0).rem_euclid(360.0) - 180.0;
            let tip = (element.end.0 + length(aside), millimetres(tip.z.0));
            let travel = motion.c_travel.map_or(0.0, |travel| millimetres(travel.0));
            if let Some((from, tip_before)) = last {
                let next = elements.get(line - 4);
                if element.code == 1
                    && next.is_none_or(|next| next.code == 1 && !is_sharp(from, element.end, next.end))
                {
                    near(beside(from, element.end, tip), side * radius, "distance at the end", &program);
                    checked[0] += 1;
                }
                if let Some((sense, ContourPlane::SideArc(arc))) = arc {
                    let centre = (from.0 + millimetres(arc.centre.0), millimetres(arc.centre_z.0));
                    let sign = if (sense == Sense::CounterClockwise) != inner { 1.0 } else { -1.0 };
                    let offset = element.radius - side * sign * radius;
                    let [first, second] = [tip_before, tip].map(|tip| minus(tip, centre));
                    near(first.0.hypot(first.1), offset, "radius at the start", &program);
                    near(second.0.hypot(second.1), offset, "radius at the end", &program);
                    assert!(sign * cross(first, second) >= -1e-6, "more than half a circle\n{program}");
                    near(length(travel), tip.0 - tip_before.0, "travel of C", &program);
                    near(millimetres(arc.travel.0), element.end.0 - from.0, "programmed travel", &program);
                    checked[1] += 1;
                }
            }
            last = Some((element.end, tip));
        }
        checked[2] +=
            usize::from(matches!(events.last().map(|event| event.action), Some(Action::End { .. })));
    }
    assert!(checked[0] > 2000 && checked[1] > 700 && checked[2] > 300, "{checked:?}");
}

/// One of some words.
fn one<'w>(seed: &mut u64, words: &[&'w str]) -> &'w str {
    let index = usize::try_from(chance(seed, words.len() as u64)).unwrap_or_default();
    words.get(index).copied().unwrap_or_default()
}

#[test]
fn the_longest_and_the_shortest_words_break_nothing() {
    let lengths = ["0", "0.001", "-0.001", "1", "-1", "50", "49.999", "99999.999", "-99999.999", "-50"];
    let radii = ["0", "0.001", "5", "999.999"];
    let mut moved = [0; 3];
    for seed in 0..6000 {
        let seed = &mut (seed * 31 + 11);
        let radius = one(seed, &radii);
        let kind = chance(seed, 3);
        let head = match kind {
            0 => "G17 G94 F1000\nG00 X50 C0 T010101",
            1 => "G119 G94 F1000\nG00 X50 Z0 C0 T010101",
            _ => "G137 C33.333\nG17 G94 F1000\nG00 X50 Y0 T010101",
        };
        let mut program = format!("M110\nVNSRX[1]={radius} VNSRZ[1]={radius}\n{head}\n");
        for number in 0..7 {
            let code = match (kind, number) {
                (_, 0) => one(seed, &["G41 G00", "G42 G01"]),
                (1, _) => one(seed, &["G00", "G01", "G132", "G133"]),
                _ => one(seed, &["G00", "G101", "G102", "G103", "G101"]),
            };
            let arc = matches!(code, "G102" | "G103" | "G132" | "G133");
            let (first, second) = match kind {
                0 => ("X", "C"),
                1 => ("C", "Z"),
                _ => ("X", "Y"),
            };
            let word = |address: &str, seed: &mut u64| {
                let value = one(seed, &lengths);
                let diameter = address == "X" && kind == 0;
                format!("{address}{}", if diameter { value.trim_start_matches('-') } else { value })
            };
            program += &format!("{code} {} {} ", word(first, seed), word(second, seed));
            if arc {
                program += one(seed, &["L0.001", "L50", "L99999.999", "L100"]);
            }
            program += one(seed, &["\n", "\n", "\n", "\nM16\n", "\nM15\n", "\nZ5\n", " G91\n", " G90\n"]);
        }
        program += "G40 G00 X70 C0\nM02\n";
        let events = events(&program, &Setup::default());
        let compensated = |event: &&Event| motion_of(event).is_some_and(|(motion, _)| motion.tip_c.is_some());
        if let Some(count) = usize::try_from(kind).ok().and_then(|kind| moved.get_mut(kind)) {
            *count += usize::from(events.iter().filter(compensated).count() > 1);
        }
    }
    assert!(moved.iter().all(|count| *count > 100), "{moved:?}");
}
