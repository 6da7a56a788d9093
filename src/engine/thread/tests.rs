//! Threads on the engine, beyond the examples of the rule texts.

use turnspec_oracle::vocabulary::notation::{fields, render};
use turnspec_oracle::vocabulary::{
    Action, BalancedInfeed, Chamfering, Event, FeedLength, Setup, TaperReference, ThreadShift, UnitSystem,
};

use crate::engine::run;

fn trace(program: &str, setup: &Setup) -> Vec<Event> {
    let mut events = Vec::new();
    run(program.as_bytes(), setup, &mut |event: &Event| events.push(*event));
    events
}

/// The values of some keys in the events that have the first of them.
fn values(program: &str, setup: &Setup, keys: &[&str]) -> Vec<String> {
    let of = |event: &Event| {
        let fields = fields(event);
        let find = |key: &str| fields.iter().find(|(name, _)| *name == key).map(|(_, value)| value.clone());
        let found: Option<Vec<_>> = keys.iter().map(|key| find(key)).collect();
        found.map(|found| found.join(" "))
    };
    trace(program, setup).iter().filter_map(of).collect()
}

#[test]
fn a_torque_skip_ends_the_chain_of_legs() {
    let setup = Setup { inputs: serde_inputs(), ..Setup::default() };
    let program = "G00 X29 Z80\nG34 Z60 F2 C120\nG22 Z50 D1 L1 PZ=20\nZ40 C90\nM02\n";
    let starts = values(program, &setup, &["start"]);
    assert_eq!(starts, ["120", "90"]);
}

/// The torque is reached behind the target.
fn serde_inputs() -> turnspec_oracle::vocabulary::Inputs {
    turnspec_oracle::vocabulary::Inputs {
        torque_stops: vec![turnspec_oracle::vocabulary::Length(50_000_000)],
        ..Default::default()
    }
}

#[test]
fn the_second_exit_has_the_lead_that_was_reached() {
    // 60 rpm: the withdrawal reaches the start soon, at sqrt(2.5^2 + 2 * d).
    let program = "G00 X40 Z96 S60 M03 M23\nG33 X29 Z54 E1 F2.5 L10\nM02\n";
    let found = values(program, &Setup::default(), &["lead", "x", "z", "part"]);
    // The exit begins at 32 from the start, with sqrt(70.25); X rises by 5.5 on 5.5 * 60 * lead / 3000.
    assert_eq!(found, ["2.5 29 64 cut", "8.381527307 40 63.078032 exit", "8.490814802 40 54 exit"],);
}

#[test]
fn a_flank_shift_of_half_a_nanometre_goes_away_from_zero() {
    // Depth 1.414214: 0.585786 below it, half of which is 0.292893; M34 is its mirror image.
    let program = "G00 X30 Z40\nG71 X20 Z10 B90 D1 H2 F1.5 M75\nG71 X20 Z10 B90 D1 H2 M34\nM02\n";
    let found = values(program, &Setup::default(), &["lead", "z"]);
    let of = |pass: usize| found.get(pass).map(String::as_str).unwrap_or_default();
    assert_eq!((of(1), of(5)), ("1.5 9.707107", "1.5 10.292893"));
}

#[test]
fn a_chamfer_on_the_face_counts_as_its_lead_does() {
    let mut setup = Setup::default();
    let program = "G00 X60 Z5 S2000 M03 M23\nG32 X20 Z-1 F2\nM02\n";
    assert_eq!(values(program, &setup, &["lead", "x", "z"]), ["2 24 -1", "2 20 0.5"]);
    setup.readings.feed_length = FeedLength::Diameter;
    assert_eq!(values(program, &setup, &["lead", "x", "z"]), ["2 22 -1", "2 20 0.5"]);
}

/// Name, line and rule of the alarm.
fn alarm(program: &str, setup: &Setup) -> String {
    let trace = trace(program, setup);
    let found = trace.iter().find(|event| matches!(event.action, Action::Alarm(_))).map(render);
    let value = |key: &str| {
        let parts = found.iter().flat_map(|text| text.split(' '));
        parts.filter_map(|part| part.strip_prefix(key)).collect::<String>()
    };
    [value("name="), value("line="), value("rules=E100L-")].join(" ").trim().to_owned()
}

#[test]
fn behind_an_angle_alone_travels_count_from_its_start() {
    // To X49 Z40 both times: the corner is 10 before Z80, on X49.
    for (first, second) in [("G34", ""), ("G01", "G35"), ("G35", "G34")] {
        let program = format!("G00 X29 Z80\n{first} G91 A135 F1.5\n{second} X20 Z-40 A180\nM02\n");
        let found = values(&program, &Setup::default(), &["x", "z"]);
        assert_eq!(found, ["29 80", "49 70", "49 40"], "{program}");
    }
    let program = "G00 X29 Z80\nG34 G91 A135 F1.5\nG90 X49 Z40 A180\nM02\n";
    assert_eq!(values(program, &Setup::default(), &["lead", "x", "z"]), ["1.5 49 70", "1.5 49 40"]);
}

#[test]
fn a_leg_behind_an_angle_alone_has_its_words() {
    let program = "G00 X29 Z80\nG34 A135 F2 C90\nX49 Z40 A180 E0.1 J2 C45\nA135 J1\nX69 Z20 A0 M27\nM02\n";
    let found = values(program, &Setup::default(), &["lead", "x", "z"]);
    assert_eq!(found, ["2 49 70", "1 49 40", "2 69 30"]);
    assert_eq!(values(program, &Setup::default(), &["start", "z"]), ["90 70"]);
    assert_eq!(values(program, &Setup::default(), &["change", "z"]), ["0.1 40"]);
    // The last one has M27 and no travel of X.
    assert_eq!(alarm(program, &Setup::default()), "unspecified 5 G34-04");
}

#[test]
fn a_leg_comes_behind_an_angle_alone_that_follows_a_chamfer() {
    let program = "G00 X29 Z80\nG75 G01 X39 L1 F1.5\nA135\nG34 X49 Z40 A180\nM02\n";
    let found = values(program, &Setup::default(), &["x", "z"]);
    assert_eq!(found, ["29 80", "37 80", "40.414214 79.292893", "49 75", "49 40"]);
}

#[test]
fn what_an_angle_alone_in_a_thread_needs() {
    let of = |text: &str| alarm(&format!("G00 X29 Z80\n{text}\nM02\n"), &Setup::default());
    assert_eq!(of("G34 A135 F1"), "angle_lookahead 2 ANG-06");
    assert_eq!(of("G34 A135 F1\nG33 X49 Z40 A180"), "angle_lookahead 2 ANG-06");
    assert_eq!(of("G34 A135 F1\nG02 X49 Z40 L20"), "angle_lookahead 2 ANG-06");
    assert_eq!(of("G34 A135 F1\nG01 X49 Z40 A180 E1"), "word_without_function 3 ADDR-01");
    assert_eq!(of("G34 A135 F1\nX49 Z40 A180 E-1"), "address_range 3 G34-02");
    assert_eq!(of("G34 A135 F1\nX49 Z40 A180 T0101"), "angle_lookahead 2 ANG-06");
    assert_eq!(of("G34 A135 F1\nGOTO N9\nN9"), "unspecified 3 ANG-06");
    assert_eq!(of("G34 A135 F1\nG75 X49 Z40 A180 L1"), "chamfer_not_linear 3 CHAM-05");
    assert_eq!(of("G75 G01 A135 L1 F1\nG34 X49 Z40 A180"), "chamfer_corner 2 ANG-07");
    // The point of intersection has no travel of Z.
    assert_eq!(of("G34 A90 F1\nX49 Z40 A180"), "unspecified 2 G34-04");
    assert_eq!(of("G34 A90 F1 M27\nX49 Z40 A180"), "");
    assert_eq!(of("G34 A135 F1\nX49 Z40 A180\nX59 Z20 A135"), "angle_overdetermined 4 DTAP-01");
    let mut setup = Setup::default();
    setup.parameters.chamfering = Chamfering::Basic;
    let program = "G00 X29 Z80\nG34 A135 F1\nX49 Z40 A180\nM02\n";
    assert_eq!(alarm(program, &setup), "angle_underdetermined 2 DTAP-01");
}

#[test]
fn a_contour_of_a_thread_has_legs_with_an_angle_alone() {
    let program = |legs: &str| format!("NAT4 G81\nG00 X20 Z5\n{legs}\nG00 X28 Z5\nG88 NAT4 D1 H1 M74\nM02\n");
    // 2 of radius under 135 degrees before X24 Z-14.
    let text = program("G34 A180 F1.5\nX24 Z-14 A135 E0.1\nG01 X26\nG80");
    assert_eq!(values(&text, &Setup::default(), &["lead", "x", "z"]), ["1.5 20 -12", "1.5 24 -14"]);
    assert_eq!(alarm(&text, &Setup::default()), "");
    let text = program("G34 A180 F1.5\nG80 X24 Z-14 A135");
    assert_eq!(values(&text, &Setup::default(), &["lead", "x", "z"]), ["1.5 20 -12", "1.5 24 -14"]);
    let text = program("G34 X24 Z-14 F1.5\nG80 A135");
    assert_eq!(alarm(&text, &Setup::default()), "angle_lookahead 4 ANG-06");
    let text = program("G34 A180 F1.5\nG00 X24 Z-14 A135\nG80");
    assert_eq!(alarm(&text, &Setup::default()), "contour_malformed 4 LAP-04");
}

/// A number from 0 to below a bound, of a sequence that looks like chance.
fn chance(seed: &mut u64, below: u64) -> u64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 33) % below
}

fn pick<'t>(seed: &mut u64, texts: &[&'t str]) -> &'t str {
    let place = usize::try_from(chance(seed, texts.len() as u64)).unwrap_or_default();
    texts.get(place).copied().unwrap_or_default()
}

/// A thread block, reasonable or not, of codes and the words that they take.
fn block(seed: &mut u64) -> String {
    const FORMS: &[(&str, &str)] = &[
        ("G71", "XZDHIBUELJQF"),
        ("G71", "XZDHABUELJQF"),
        ("G72", "XZDHKBWELJQF"),
        ("G72", "XZDHABWELJQF"),
        ("G33", "XZIEKLJCF"),
        ("G31", "XZAEKLJCF"),
        ("G32", "XZKIELJCF"),
        ("G32", "XZAIELJCF"),
        ("", "XZEL"),
        ("G34", "XZEJCF"),
        ("G34", "AEJCF"),
        ("", "XZAEJC"),
        ("G35", "XAEJCF"),
        ("G35", "ZAEJCF"),
    ];
    const VALUES: &[&str] = &["1", "2", "0.5", "3", "10", "20", "45", "90", "0.001", "0", "30", "1.001"];
    const LARGE: &[&str] = &["99999.999", "-99999.999", "-3", "-20", "179.999", "359.999", "-0.01"];
    const M_CODES: &[&str] = &["M22", "M23", "M27", "M32", "M33", "M34", "M73", "M74", "M75", "M04"];
    let place = usize::try_from(chance(seed, FORMS.len() as u64)).unwrap_or_default();
    let (code, words) = FORMS.get(place).copied().unwrap_or_default();
    let mut text = code.to_owned();
    for (place, word) in words.chars().enumerate() {
        if chance(seed, 8) == 0 || place > 3 && chance(seed, 2) == 0 {
            continue;
        }
        text.push(word);
        text.push_str(match word {
            'J' | 'Q' => pick(seed, &["1", "2", "7", "30"]),
            _ if chance(seed, 12) == 0 => pick(seed, LARGE),
            _ => pick(seed, VALUES),
        });
    }
    text.push_str(pick(seed, M_CODES));
    text.push_str(pick(seed, &["G90", "G90", "G91"]));
    text.push('\n');
    text
}

#[test]
fn no_words_break_a_thread() {
    let mut seed = 1;
    let mut motions = 0;
    for _ in 0..20_000 {
        let mut setup = Setup::default();
        setup.limits.steps = 60;
        let mut toss = || chance(&mut seed, 2) == 0;
        if toss() {
            setup.readings.feed_length = FeedLength::Diameter;
        }
        if toss() {
            setup.readings.taper_reference = TaperReference::End;
            setup.readings.thread_shift = ThreadShift::Coordinate;
        }
        if toss() {
            setup.readings.balanced_infeed = BalancedInfeed::EqualArea;
            setup.parameters.m75_pattern = if toss() { 3 } else { 4 };
        }
        if toss() {
            setup.unit_system = UnitSystem::Inch;
        }
        if toss() {
            setup.parameters.thread_chamfer_feed = 9999;
        }
        let mut program = format!(
            "G00 X{} Z40 S{} M03 F1.5\n",
            pick(&mut seed, &["30", "-30", "4000"]),
            pick(&mut seed, &["1", "1000", "65535"])
        );
        for _ in 0..4 {
            program.push_str(&block(&mut seed));
        }
        run(program.as_bytes(), &setup, &mut |event: &Event| {
            motions += u32::from(matches!(event.action, Action::Thread { .. }));
        });
    }
    assert!(motions > 1000, "{motions} threads");
}
