//! Rough cycles of contours that look like chance: what they cut, they cut along the contour and nowhere below it.

use turnspec_oracle::vocabulary::{
    Action, AlarmName, Event, Length, MachineType, NoseRadius, Part, ProgramText, Sense, Setup, UnitSystem,
};

use crate::engine::run;

/// A number from 0 to below a bound, of a sequence that looks like chance.
fn chance(seed: &mut u64, below: u64) -> u64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 33) % below
}

/// A whole number between two others, both included.
fn between(seed: &mut u64, low: i64, high: i64) -> i64 {
    low + i64::try_from(chance(seed, (high - low + 1).unsigned_abs())).unwrap_or_default()
}

/// Where a contour lies: longitudinal or not, outside or inside, and toward which side.
#[derive(Clone, Copy, Debug)]
struct Side {
    along: bool,
    infeed: i64,
    cutting: i64,
}

/// A point by run and height, in micrometres.
type Spot = (i64, i64);

impl Side {
    /// The words of a point.
    fn words(self, (run, height): Spot) -> String {
        let (run, height) = (self.cutting * run, self.infeed * height);
        let (x, z) = if self.along { (2 * height, run) } else { (2 * run, height) };
        format!("X{} Z{}", number(x), number(z))
    }

    /// The run and the height of a point in micrometres.
    fn spot(self, x: i64, z: i64) -> (f64, f64) {
        let (x, z) = (x as f64 / 2000.0, z as f64 / 1000.0);
        let (run, height) = if self.along { (z, x) } else { (x, z) };
        (run * self.cutting as f64, height * self.infeed as f64)
    }

    fn keeps_sense(self) -> bool {
        (self.infeed * self.cutting > 0) == self.along
    }
}

fn number(micrometres: i64) -> String {
    let sign = if micrometres < 0 { "-" } else { "" };
    let size = micrometres.unsigned_abs();
    format!("{sign}{}.{:03}", size / 1000, size % 1000)
}

/// A motion of a trace in run and height: its points, close to each other.
struct Path {
    part: Option<Part>,
    cuts: bool,
    points: Vec<(f64, f64)>,
}

/// The words of elements from a point on, and the point in which they end.
fn elements(seed: &mut u64, side: Side, from: Spot, count: u64, text: &mut String) -> Spot {
    let mut at = from;
    let mut wall = 0;
    for _ in 0..count {
        let (run, height) = at;
        let kind = chance(seed, 6);
        let size = between(seed, 1, 40) * 100;
        let fall = if chance(seed, 5) < 2 { -1 } else { 1 };
        let rise = if height < 8000 { size } else { fall * size };
        let to = match kind {
            0 if wall * rise >= 0 => (run, height + rise),
            1 => (run + size, height),
            _ => (run + between(seed, 1, 4000), height + rise),
        };
        wall = if to.0 == run { rise } else { 0 };
        let line = format!("G01 {}\n", side.words(to));
        let arc = kind > 3 && to.0 > run;
        if !arc {
            text.push_str(&line);
            at = to;
            continue;
        }
        // A quarter of a circle.
        let to = (run + rise.abs(), height + rise);
        let over = chance(seed, 2) == 0;
        let code = if over == side.keeps_sense() { "G02" } else { "G03" };
        text.push_str(&format!("{code} {} L{}\n", side.words(to), number(rise.abs())));
        at = to;
    }
    at
}

/// The motions of a trace.
fn paths(trace: &[Event], side: Side) -> Vec<Path> {
    let mut at = (0, 0);
    let mut found = Vec::new();
    for event in trace {
        let (motion, arc) = match event.action {
            Action::Rapid { motion } => (motion, None),
            Action::Linear { motion, .. } => (motion, None),
            Action::Arc { motion, sense, centre_x, centre_z, .. } => {
                (motion, Some((sense, (centre_x.0, centre_z.0))))
            }
            _ => continue,
        };
        let to = (motion.program.x.0, motion.program.z.0);
        let (from, end) = (side.spot(at.0, at.1), side.spot(to.0, to.1));
        let points = (0..=40).map(|step| f64::from(step) / 40.0);
        let points = match arc {
            None => points.map(|t| (from.0 + t * (end.0 - from.0), from.1 + t * (end.1 - from.1))).collect(),
            Some((sense, centre)) => {
                let centre = side.spot(centre.0, centre.1);
                let counter = (sense == Sense::CounterClockwise) == side.keeps_sense();
                let polar = |(run, height): (f64, f64)| {
                    let (run, height) = (run - centre.0, height - centre.1);
                    (run.hypot(height), height.atan2(run))
                };
                let ((radius, first), (_, last)) = (polar(from), polar(end));
                let turn = if counter { 1.0 } else { -1.0 };
                let sweep = (turn * (last - first) + 1e-9).rem_euclid(std::f64::consts::TAU) - 1e-9;
                points
                    .map(|t| first + turn * t * sweep)
                    .map(|angle| (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin()))
                    .collect()
            }
        };
        let cuts = !matches!(event.action, Action::Rapid { .. });
        found.push(Path { part: motion.part, cuts, points });
        at = to;
    }
    found
}

/// How far a point lies from a path.
fn distance(path: &Path, (run, height): (f64, f64)) -> f64 {
    path.points.windows(2).fold(f64::INFINITY, |least, pair| {
        let [(run_1, height_1), (run_2, height_2)] = [pair[0], pair[1]];
        let (along, across) = (run_2 - run_1, height_2 - height_1);
        let square = along * along + across * across;
        let t = if square > 0.0 {
            (((run - run_1) * along + (height - height_1) * across) / square).clamp(0.0, 1.0)
        } else {
            0.0
        };
        least.min((run - run_1 - t * along).hypot(height - height_1 - t * across))
    })
}

fn trace(program: &str, setup: &Setup) -> Vec<Event> {
    let mut events = Vec::new();
    run(program.as_bytes(), setup, &mut |event: &Event| events.push(*event));
    events
}

fn alarm(trace: &[Event]) -> Option<AlarmName> {
    trace.iter().find_map(|event| match event.action {
        Action::Alarm(alarm) => Some(alarm.name),
        _ => None,
    })
}

/// A definition and what is expected of it.
struct Case {
    side: Side,
    program: String,
    /// The contour alone, finished.
    finished: String,
    /// The height of the AP start.
    start: i64,
}

fn case(seed: &mut u64, code: &str, blank: bool) -> Case {
    let sign = |seed: &mut u64| if chance(seed, 2) == 0 { 1 } else { -1 };
    let side = Side { along: chance(seed, 2) == 0, infeed: sign(seed), cutting: sign(seed) };
    let from = (between(seed, -3000, 3000), between(seed, 1000, 9000));
    let g00 = if chance(seed, 2) == 0 { "G00" } else { "G01" };
    let mut contour = format!("{g00} {}\n", side.words(from));
    let count = 1 + chance(seed, 12);
    let end = elements(seed, side, from, count, &mut contour);
    let begin = if side.along { "G81" } else { "G82" };
    let mut definition = String::new();
    if blank {
        let mut text = format!("G01 {}\n", side.words(from));
        let top = (from.0, from.1 + between(seed, 0, 20) * 500);
        if top != from {
            text.push_str(&format!("G01 {}\n", side.words(top)));
        }
        let mut at = top;
        while at.0 < end.0 {
            let count = 1 + chance(seed, 3);
            at = elements(seed, side, at, count, &mut text);
            if at.0 == top.0 {
                break;
            }
        }
        definition = format!("NAT2 G83\n{text}");
    }
    let start = (from.0 - between(seed, 0, 4000), from.1 + between(seed, 500, 20_000));
    let depth = number(between(seed, 1, 16) * 250);
    let home = format!("G00 {}\n", side.words(start));
    let name = if blank { "NAT2" } else { "NAT1" };
    let contour = format!("NAT1 {begin}\n{contour}G80\n");
    Case {
        side,
        program: format!("{definition}{contour}{home}{code} {name} D{depth} F0.3\nM02\n"),
        finished: format!("{contour}{home}G01 F1\nG87 NAT1\nM02\n"),
        start: start.1,
    }
}

/// Runs a case and tests what it cuts; whether it was accepted.
fn test(case: &Case, all: bool) -> bool {
    let setup = Setup::default();
    let rough = trace(&case.program, &setup);
    let refused = [AlarmName::Unspecified, AlarmName::DescendingSlopes, AlarmName::ContourDirection];
    match alarm(&rough) {
        None => {}
        Some(name) => {
            assert!(refused.contains(&name), "{name:?} of\n{}", case.program);
            return false;
        }
    }
    let paths_of = |events: &[Event]| paths(events, case.side);
    let finished = paths_of(&trace(&case.finished, &setup));
    let contour: Vec<&Path> = finished.iter().skip(2).collect();
    let rough = paths_of(&rough);
    // The way from the AP start to an infeed point may lead through the contour.
    let cuts = rough.iter().filter(|path| path.cuts && path.part != Some(Part::Infeed));
    let along: Vec<&Path> = rough.iter().filter(|path| path.part == Some(Part::Contour)).collect();
    // What lies behind a part above the AP start is reached by no level.
    let reached = |point: &&(f64, f64)| all || point.1 < case.start as f64 - 0.5;
    for point in contour.iter().flat_map(|path| path.points.iter()).take_while(reached) {
        let near = along.iter().map(|path| distance(path, *point)).fold(f64::INFINITY, f64::min);
        assert!(near < 2.0, "{point:?} is {near} away in\n{}", case.program);
    }
    let lowest = |run: f64| {
        let near = contour.iter().flat_map(|path| path.points.windows(2)).filter_map(|pair| {
            let (low, high) = (pair[0].0.min(pair[1].0) - 0.1, pair[0].0.max(pair[1].0) + 0.1);
            if !(low..=high).contains(&run) {
                return None;
            }
            let length = pair[1].0 - pair[0].0;
            if length.abs() < 1.0 {
                return Some(pair[0].1.min(pair[1].1));
            }
            let t = ((run - pair[0].0) / length).clamp(0.0, 1.0);
            Some(pair[0].1 + t * (pair[1].1 - pair[0].1))
        });
        near.fold(f64::INFINITY, f64::min)
    };
    for path in cuts {
        for (run, height) in &path.points {
            let below = lowest(*run) - height;
            if below.is_finite() && below > 5.0 {
                // Where the contour is steep, it is no more than near.
                let near = contour.iter().map(|path| distance(path, (*run, *height)));
                let near = near.fold(f64::INFINITY, f64::min);
                assert!(near < 2.0, "{below} below at {run} in\n{}", case.program);
            }
        }
    }
    true
}

fn cases(code: &str, blank: bool, count: u32, least: u32) {
    let mut seed = 7;
    let accepted = (0..count).filter(|_| {
        let case = case(&mut seed, code, blank);
        test(&case, blank || code == "G86")
    });
    let accepted = accepted.count();
    assert!(accepted >= usize::try_from(least).unwrap_or_default(), "only {accepted} of {count}");
}

#[test]
fn bar_turning_cuts_the_contour_and_nothing_below() {
    cases("G85", false, 1500, 500);
}

#[test]
fn high_speed_turning_cuts_the_contour_and_nothing_below() {
    cases("G85", true, 1000, 200);
}

#[test]
fn copying_a_bar_cuts_the_contour_and_nothing_below() {
    cases("G86", true, 600, 100);
}

/// A rough cycle with a contour of 10 000 elements, lines or arcs by turns, and how many events it has.
fn long(code: &str, blank: &str, arcs: bool) -> usize {
    let mut text = format!("{blank}NAT1 G81\nG00 X20 Z0\nG01\n");
    for step in 1..=10_000 {
        let (x, z) = (number(20_000 + step * 10), number(step * 5));
        let word = if !arcs || step % 2 == 0 { "G01" } else { "G03" };
        let radius = if word == "G03" { " L0.005" } else { "" };
        text.push_str(&format!("{word} X{x} Z-{z}{radius}\n"));
    }
    let name = if blank.is_empty() { "NAT1" } else { "NAT2" };
    text.push_str(&format!("G80\nG00 X130 Z10\n{code} {name} D1 F0.3\nM02\n"));
    let begun = std::time::Instant::now();
    let events = trace(&text, &Setup::default());
    assert_eq!(alarm(&events), None);
    let elapsed = begun.elapsed();
    assert!(elapsed.as_secs() < 20, "{elapsed:?}");
    events.len()
}

#[test]
fn a_long_contour_is_rough_soon() {
    let blank = "NAT2 G83\nG01 X20 Z0\nX30\nX120 Z-30\nZ-50\n";
    for arcs in [false, true] {
        assert!(long("G85", "", arcs) > 10_000);
        assert!(long("G86", "", arcs) > 1_000_000);
        assert!(long("G85", blank, arcs) > 10_000);
        assert!(long("G86", blank, arcs) > 10_000);
    }
}

fn pick<'t>(seed: &mut u64, texts: &[&'t str]) -> &'t str {
    let place = usize::try_from(chance(seed, texts.len() as u64)).unwrap_or_default();
    texts.get(place).copied().unwrap_or_default()
}

/// A block of a definition, reasonable or not.
fn block(seed: &mut u64, thread: bool, at: u64) -> String {
    const CODES: &[&str] = &[
        "", "", "", "G01", "G01", "G02", "G03", "G91", "G90", "G00", "G42", "G41", "G40", "G75", "G76", "G80",
    ];
    const THREADS: &[&str] = &["", "G34", "G34", "G35", "G01", "G91", "G90"];
    const OTHERS: &[&str] = &["E0.2", "F0.3", "L2", "I5", "K-3", "A30", "A-120", "L0.5", "I-2", "K4"];
    const STATEMENTS: &[&str] =
        &["CALL O1", "IF [V1 LT 2] N7", "N7 V1=V1+1", "GOTO N8", "N8 RTS", "M85", "C10", "(A)"];
    if chance(seed, 60) == 0 {
        return format!("{}\n", pick(seed, STATEMENTS));
    }
    if at > 0 && chance(seed, 4) > 0 {
        let z = i64::try_from(at).unwrap_or_default() * 2000;
        let x = number(between(seed, 1, 20) * 1000);
        return format!("{} X{x} Z-{}\n", if thread { "G34" } else { "G01" }, number(z));
    }
    let codes = match (at, thread) {
        (0, _) => &["G00", "G00", "G01"],
        (_, true) => THREADS,
        _ => CODES,
    };
    let mut text = pick(seed, codes).to_owned();
    for letter in ["X", "Z"] {
        if chance(seed, 4) > 0 {
            let far = if chance(seed, 60) == 0 { 5_000_000 } else { 1 };
            text.push_str(&format!("{letter}{}", number(between(seed, -10, 10) * 1000 * far / 3)));
        }
    }
    if chance(seed, 3) == 0 {
        text.push_str(pick(seed, OTHERS));
    }
    text.push('\n');
    text
}

#[test]
fn no_words_break_a_cycle() {
    let mut seed = 3;
    let mut events = 0;
    for _ in 0..60_000 {
        let mut setup = Setup::default();
        setup.limits.steps = 400;
        setup.parameters.lap_relief = if chance(&mut seed, 2) == 0 { 0 } else { 9999 };
        setup.parameters.lap_clearance = pick(&mut seed, &["0", "2000", "99999"]).parse().unwrap_or_default();
        if chance(&mut seed, 4) == 0 {
            setup.unit_system = UnitSystem::Inch;
        }
        let call = pick(&mut seed, &["G85", "G85", "G86", "G86", "G87", "G88"]);
        let blank = chance(&mut seed, 2) == 0;
        let mut text = String::new();
        if blank {
            text.push_str("NAT2 G83\n");
            for at in 0..1 + chance(&mut seed, 5) {
                text.push_str(&block(&mut seed, false, at));
            }
        }
        text.push_str(pick(&mut seed, &["NAT1 G81\n", "NAT1 G82\n"]));
        for at in 0..2 + chance(&mut seed, 8) {
            text.push_str(&block(&mut seed, call == "G88", at));
        }
        text.push_str(pick(&mut seed, &["G80\n", "G80 G40 X5\n", "G80 X9 Z-4\n"]));
        let start = (between(&mut seed, -20, 20), between(&mut seed, -10, 20));
        text.push_str(&format!("T010101 G00 X{} Z{} F0.2\n", start.0, start.1));
        let name = if blank && call != "G88" { "NAT2" } else { "NAT1" };
        text.push_str(&format!("{call} {name}"));
        text.push_str(match call {
            "G87" => "",
            "G88" => " D0.7 H2",
            _ => pick(&mut seed, &[" D1", " D0.3", " D7"]),
        });
        let words: &[&str] = match call {
            "G88" => &[" B60", " U0.5", " W0.5", " M33", " M74", " M75"],
            "G87" => &[" U0.5", " W0.2"],
            _ => &[" U0.5", " W0.2", " M85", " F0.1", " G84 XA=1 DA=0.2", " G84 ZA=1 FA=2"],
        };
        for word in words {
            if chance(&mut seed, 5) == 0 {
                text.push_str(word);
            }
        }
        text.push_str("\nG01 X30\nM02\n");
        let size = Length(800_000);
        setup.nose_radius.push(NoseRadius { number: 1, x: size, z: size });
        setup.library.insert("A.SUB".to_owned(), ProgramText(b"O1\nG01 X3\nRTS\n".to_vec()));
        events += trace(&text, &setup).len();
    }
    assert!(events > 200_000, "{events} events");
}

#[test]
fn a_change_of_turret_is_refused_whatever_stands_beside_it() {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoTurrets;
    let refused = |block: &str| {
        let program =
            format!("G00 X60 Z5\nG87 NAT1\nM02\nNAT1 G81\nG00 X50 Z2\n{block}\nG01 Z-10 F0.2\nG80\n");
        let mut found = (AlarmName::NotModelled, String::new());
        run(program.as_bytes(), &setup, &mut |event: &Event| {
            if let Action::Alarm(alarm) = event.action {
                found = (alarm.name, alarm.detail.as_str().to_owned());
            }
        });
        found
    };
    for block in ["G14", "G14 VZOFX=1", "G91 G14 M03", "G14 X9999999", "G96 G14"] {
        assert_eq!(refused(block), (AlarmName::TurretChange, String::new()), "{block}");
    }
    for (block, name, detail) in [
        ("G13", AlarmName::ContourMalformed, "G13"),
        ("G13 M03", AlarmName::ContourMalformed, "G13"),
        ("G13 VZOFX=1", AlarmName::ContourMalformed, "G13"),
        ("G13 G14", AlarmName::GCodesConflict, ""),
    ] {
        assert_eq!(refused(block), (name, detail.to_owned()), "{block}");
    }
}
