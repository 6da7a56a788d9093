//! Cycles on the engine, beyond the examples of the rule texts.

use turnspec_oracle::vocabulary::notation::fields;
use turnspec_oracle::vocabulary::rule_ids::{INCH_02, MIRR_06};
use turnspec_oracle::vocabulary::{
    Action, AlarmName, ChipDischarge, CycleReturn, Event, FeedLength, G184Tapping, KeywayReturn, MachineType,
    PeckRetract, Setup, UnitSystem,
};

use crate::engine::run;

mod conversion;

fn trace(program: &str, setup: &Setup) -> Vec<Event> {
    let mut events = Vec::new();
    run(program.as_bytes(), setup, &mut |event: &Event| events.push(*event));
    events
}

/// The values of some keys in the events that have all of them.
fn values(program: &str, setup: &Setup, keys: &[&str]) -> Vec<String> {
    let of = |event: &Event| {
        let fields = fields(event);
        let find = |key: &str| fields.iter().find(|(name, _)| *name == key).map(|(_, value)| value.clone());
        let found: Option<Vec<_>> = keys.iter().map(|key| find(key)).collect();
        found.map(|found| found.join(" "))
    };
    trace(program, setup).iter().filter_map(of).collect()
}

/// The alarm of a program, its detail and its rule.
fn alarm(program: &str) -> String {
    let of = |event: &Event| {
        let Action::Alarm(alarm) = event.action else { return None };
        let rules = event.rules.as_slice().iter().map(|rule| rule.as_str());
        let parts = [alarm.name.as_str(), alarm.detail.as_str()].into_iter().chain(rules);
        Some(parts.filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" "))
    };
    trace(program, &Setup::default()).iter().find_map(of).unwrap_or_default()
}

const JOINED: &str = "M110\nG94 G00 X60 Z20 SB=400\n";

#[test]
fn a_hole_at_half_a_micro_degree_is_latched_away_from_zero() {
    let program = |word: &str| format!("{JOINED}{word}G181 X60 Z5 C0 K10 F40 Q1024\n");
    let turns = |word| values(&program(word), &Setup::default(), &["c", "part"]);
    let second = |word| turns(word).into_iter().find(|turn| turn.ends_with("position")).unwrap_or_default();
    // 360 / 1024 = 0.3515625.
    assert_eq!(second(""), "0.351563 position");
    assert_eq!(second("M16\n"), "359.648437 position");
}

#[test]
fn the_angle_of_a_tap_is_no_length() {
    let setup = Setup { unit_system: UnitSystem::Inch, ..Setup::default() };
    let program = "M110\nG00 X2 Z1 SB=400\nG178 X2 Z0.5 C0 K0.1 F0.05\nC90 D30.5\n";
    let starts = values(program, &setup, &["start"]);
    assert_eq!(starts, ["30.5", "30.5"]);
    let inch = |event: &Event| event.rules.as_slice().contains(&INCH_02);
    let threads = trace(program, &setup);
    let threads = threads.iter().filter(|event| matches!(event.action, Action::Thread { .. }));
    assert_eq!(threads.map(inch).collect::<Vec<_>>(), [true, true, false, false]);
}

#[test]
fn every_hole_but_the_first_is_a_step() {
    let mut setup = Setup::default();
    setup.limits.steps = 4;
    let program = format!("{JOINED}G181 X60 Z5 C0 K10 F40 Q3\n");
    // Three blocks and the second hole.
    let cuts = values(&program, &setup, &["f"]).len();
    let last = trace(&program, &setup).last().map(|event| event.action);
    assert_eq!(cuts, 2);
    assert!(matches!(last, Some(Action::Alarm(alarm)) if alarm.name == AlarmName::StepLimit));
}

#[test]
fn a_cycle_is_seen_by_speed_and_turret_clamp() {
    let mut setup = Setup::default();
    setup.inputs.turret_clamp_confirmed = false;
    let program = "G96 S100 M03\nG00 X100 Z0\nG73 X90 D4 F0.1\nG00 M203\nM02\n";
    // 100 m/min on diameters of 100, 96, 96.1, 92, 92.1, 90 and 100 mm.
    let speeds = values(program, &setup, &["part", "speed"]);
    let expected =
        ["cut 331.573", "retract 331.228", "cut 345.989", "retract 345.613", "cut 353.678", "return 318.31"];
    assert_eq!(speeds, expected);
    // The last motion is the return.
    assert!(
        matches!(trace(program, &setup).last(), Some(event) if matches!(event.action, Action::End { .. }))
    );
}

#[test]
fn no_block_of_a_cycle_is_looked_ahead_at() {
    for next in ["G73 X40 D2", "G77 X0 Z-20 K1", "G181 X30 Z-20 K1", "G180"] {
        let program = format!("G94 G01 X60 Z0 F200\nX50 A90 G75 L1\n{next}\nM02\n");
        let found = alarm(&program);
        assert!(found.starts_with("angle_lookahead"), "{next}: {found}");
    }
}

#[test]
fn a_thread_mode_does_not_make_threads_of_cycle_blocks() {
    let program =
        "G33\nM110\nG94 G00 X60 Z20 SB=400\nG33\nG181 X60 Z5 C0 K10 F40\nC90\nG180\nG00 X70 Z20\nM02\n";
    let found = values(program, &Setup::default(), &["part", "c", "f"]);
    assert_eq!(found, ["cut 0 40mm/min", "cut 90 40mm/min"]);
}

#[test]
fn the_mode_is_checked_before_the_words() {
    let after = |blocks: &str| alarm(&format!("{JOINED}G181 X60 Z5 C0 K10 F40\n{blocks}"));
    assert_eq!(after("G182 G91 C90\n"), "unspecified G182 E100L-MCYC-01");
    assert_eq!(after("G91 G00 C90\n"), "cycle_incremental E100L-MCYC-14");
    assert_eq!(after("M136 M03 S100\n"), "cycle_word M03 E100L-MCYC-14");
    assert_eq!(after("G95 C90\n"), "cycle_feed_mode G181 E100L-MCYC-03");
    assert_eq!(after("G95\nG94\nC90 H5\n"), "word_without_function H E100L-ADDR-01");
    assert_eq!(after("C90 I5\n"), "unspecified I E100L-MCYC-09");
    assert_eq!(after("G180\nG180\nM12\n"), "no_program_end E100L-PROG-02");
}

#[test]
fn a_tap_runs_the_other_way_with_turret_b() {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoTurrets;
    let program = "G14\nG00 X0 Z10 S200\nG77 X0 Z-15 K5 F1.5\nM02\n";
    let events = trace(program, &setup);
    let spindles = events.iter().filter(|event| matches!(event.action, Action::Spindle(_)));
    let mirrored: Vec<_> = spindles.map(|event| event.rules.as_slice().contains(&MIRR_06)).collect();
    assert_eq!(mirrored, [false, true, false, true, false]);
    assert_eq!(values(program, &setup, &["state"]), ["stop", "ccw", "stop", "cw", "stop"]);
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

/// A block of a cycle, reasonable or not, of codes and the words that they take.
fn block(seed: &mut u64) -> String {
    const FORMS: &[(&str, &str)] = &[
        ("G73", "XDZIKLEF"),
        ("G74", "ZDXKILEF"),
        ("G77", "XZKF"),
        ("G78", "XZKF"),
        ("G181", "XZKCEQF"),
        ("G182", "RZICEF"),
        ("G183", "XZKDLCQF"),
        ("G183", "ZRIDLECF"),
        ("G184", "XZKCF"),
        ("G178", "XZKCDJQF"),
        ("G179", "ZRICDJF"),
        ("G189", "XZICEF"),
        ("G190", "XZKDWECQF"),
        ("G190", "XZIDUECF"),
        ("G185", "XZCKIF"),
        ("G186", "XZCKIF"),
        ("G187", "XZCKIF"),
        ("G188", "XZCKIF"),
    ];
    const VALUES: &[&str] = &["1", "2", "0.5", "3", "10", "20", "45", "90", "0.001", "30", "1.001", "-5"];
    const LARGE: &[&str] = &["99999.999", "-99999.999", "-3", "0", "179.999", "359.999", "-0.01"];
    const M_CODES: &[&str] = &["", "", "M136", "M140", "M141", "M211", "M212", "M213", "M214"];
    let place = usize::try_from(chance(seed, FORMS.len() as u64)).unwrap_or_default();
    let (code, words) = FORMS.get(place).copied().unwrap_or_default();
    let mut text = code.to_owned();
    for (place, word) in words.chars().enumerate() {
        if place > 2 && chance(seed, 3) == 0 {
            continue;
        }
        text.push(word);
        text.push_str(match word {
            'J' | 'Q' => pick(seed, &["1", "2", "7", "30"]),
            'X' | 'Z' if chance(seed, 8) != 0 => pick(seed, &["10", "20", "5", "-10", "30"]),
            'F' => pick(seed, &["1", "40", "0.001"]),
            'D' | 'I' | 'K' if chance(seed, 8) != 0 => pick(seed, &["1", "2", "3", "0.5", "0.7"]),
            _ if chance(seed, 16) == 0 => pick(seed, LARGE),
            _ => pick(seed, VALUES),
        });
    }
    text.push_str(pick(seed, M_CODES));
    text.push_str(pick(seed, &["", "", "", "G94", "G95", "G91", "DA=0.2", "SA=2", "SB=300"]));
    text.push('\n');
    text
}

fn setup(seed: &mut u64) -> Setup {
    let mut setup = Setup::default();
    let mut toss = || chance(seed, 2) == 0;
    setup.limits.steps = 60;
    if toss() {
        setup.readings.feed_length = FeedLength::Diameter;
    }
    if toss() {
        setup.readings.peck_retract = PeckRetract::Radius;
        setup.readings.chip_discharge = ChipDischarge::CycleStart;
    }
    if toss() {
        setup.readings.keyway_return = KeywayReturn::Relief;
    }
    if toss() {
        setup.parameters.cycle_return = CycleReturn::CycleStart;
    }
    if toss() {
        setup.parameters.g184_tapping = G184Tapping::Synchronised;
    }
    if toss() && toss() {
        setup.unit_system = UnitSystem::Inch;
    }
    setup
}

#[test]
fn no_words_break_a_cycle() {
    let mut seed = 1;
    let (mut cuts, mut threads) = (0, 0);
    for _ in 0..20_000 {
        let setup = setup(&mut seed);
        let feeds = pick(&mut seed, &["G94", "G95"]);
        let joined = pick(&mut seed, &["M110\n", "M110\n", "M15\n"]);
        let mut program = format!("{joined}{feeds} G00 X60 Z40 S100 SB=400 SA=5\nF30\n");
        for _ in 0..3 {
            program.push_str(&block(&mut seed));
            program.push_str(pick(&mut seed, &["", "C90\n", "X20 C45\n", "Z-20\n"]));
            program.push_str(pick(&mut seed, &["G180\nG00 X60 Z40\n", ""]));
        }
        run(program.as_bytes(), &setup, &mut |event: &Event| match event.action {
            Action::Linear { motion, .. } => cuts += u32::from(motion.part.is_some()),
            Action::Thread { .. } => threads += 1,
            _ => {}
        });
    }
    assert!(cuts > 10_000 && threads > 1000, "{cuts} cuts, {threads} threads");
}
