//! Threads on the engine, beyond the examples of the rule texts.

use turnspec_oracle::vocabulary::notation::fields;
use turnspec_oracle::vocabulary::{
    Action, BalancedInfeed, Event, FeedLength, Setup, TaperReference, ThreadShift, UnitSystem,
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
