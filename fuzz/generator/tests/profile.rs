//! Restricted generation stays within its profile: judged by the words of the text and by what the oracle
//! does with it, with means of this file alone.

#![allow(clippy::panic)]

use std::collections::BTreeSet;

use turnspec_generator::{Case, Profile, case_from_seed, case_from_seed_within};
use turnspec_oracle::vocabulary::{
    Action, Chamfering, Event, Feature, RuleId, Setup, SpindleName, SpindleState, TapeCode,
};

const SEEDS: u64 = 2_000;

/// What a plain three-axis interpreter has.
const SMALL: &[Feature] = &[
    Feature::Absolute,
    Feature::Arc,
    Feature::Comment,
    Feature::Coolant,
    Feature::Dwell,
    Feature::Feed,
    Feature::Incremental,
    Feature::Linear,
    Feature::Rapid,
    Feature::SequenceName,
    Feature::Spindle,
];

/// Lines and positions alone.
const SMALLEST: &[Feature] = &[Feature::Feed, Feature::Linear, Feature::Rapid];

/// Everything but what has to do with text, faults and units.
fn machine() -> Vec<Feature> {
    without(&[Feature::Alarm, Feature::TapeCode, Feature::Units, Feature::ProgramName])
}

fn without(features: &[Feature]) -> Vec<Feature> {
    Feature::ALL.iter().copied().filter(|feature| !features.contains(feature)).collect()
}

#[test]
fn every_feature_allowed_gives_the_usual_cases() {
    for seed in 0..300 {
        assert_eq!(case_from_seed_within(seed, &Profile::of(Feature::ALL)), case_from_seed(seed));
    }
}

#[test]
fn small_programs_stay_within_and_run_deep() {
    let ran = stays_within(SMALL);
    assert!(ran.ended * 100 >= SEEDS * 97, "{} of {SEEDS} programs ended", ran.ended);
    for kind in ["rapid", "linear", "arc", "dwell", "spindle", "coolant", "mode"] {
        assert!(ran.kinds.contains(kind), "no {kind} event");
    }
    assert!(ran.events > SEEDS * 10, "{} events", ran.events);
}

#[test]
fn the_smallest_programs_stay_within_and_end() {
    let ran = stays_within(SMALLEST);
    assert!(ran.ended * 100 >= SEEDS * 99, "{} of {SEEDS} programs ended", ran.ended);
}

#[test]
fn programs_without_one_feature_stay_within() {
    for feature in Feature::ALL {
        check(&without(&[*feature]), 0..SEEDS / 10);
    }
}

#[test]
fn programs_of_the_whole_machine_stay_within_and_end() {
    let ran = stays_within(&machine());
    assert!(ran.ended * 100 >= SEEDS * 90, "{} of {SEEDS} programs ended", ran.ended);
}

/// With faults allowed there are some, of allowed words only.
#[test]
fn faults_need_no_more_than_the_profile() {
    let features = [SMALL, &[Feature::Alarm]].concat();
    let ran = stays_within(&features);
    let alarms = SEEDS - ran.ended;
    assert!((SEEDS / 20..SEEDS / 2).contains(&alarms), "{alarms} of {SEEDS} programs raised an alarm");
}

/// A small interpreter with a C axis has contours.
#[test]
fn contours_need_no_more_than_the_profile() {
    let features = [SMALL, &[Feature::CAxis, Feature::ContourGeneration]].concat();
    let ran = stays_within(&features);
    assert!(ran.ended * 100 >= SEEDS * 95, "{} of {SEEDS} programs ended", ran.ended);
    assert!(ran.kinds.contains("contour_arc"), "no contour_arc event");
}

/// The same with radius compensation of noses and cutters.
#[test]
fn cutters_need_no_more_than_the_profile() {
    let needed = [Feature::CAxis, Feature::ContourGeneration, Feature::RadiusCompensation, Feature::Tool];
    let ran = stays_within(&[SMALL, &needed].concat());
    assert!(ran.ended * 100 >= SEEDS * 90, "{} of {SEEDS} programs ended", ran.ended);
    assert!(ran.cutters > SEEDS * 4 / 100, "{} programs with cutters", ran.cutters);
}

/// Threads with no more than they need.
#[test]
fn programs_with_threads_stay_within_and_end() {
    let features = [SMALL, &[Feature::Thread]].concat();
    let ran = stays_within(&features);
    assert!(ran.ended * 100 >= SEEDS * 97, "{} of {SEEDS} programs ended", ran.ended);
    assert!(ran.kinds.contains("thread"), "no thread event");
}

/// Cycles with no more than they need.
#[test]
fn programs_with_cycles_stay_within_and_end() {
    let driven = [Feature::DrivenCycle, Feature::CAxis, Feature::MTool];
    for cycles in [&[Feature::Grooving] as &[Feature], &driven] {
        let ran = stays_within(&[SMALL, cycles].concat());
        assert!(ran.ended * 100 >= SEEDS * 96, "{} of {SEEDS} programs ended", ran.ended);
        assert!(ran.cycles > SEEDS * 4 / 100, "{} programs with cycles", ran.cycles);
    }
}

/// LAP with no more than it needs.
#[test]
fn programs_with_lap_stay_within_and_end() {
    let ran = stays_within(&[SMALL, &[Feature::Lap]].concat());
    assert!(ran.ended * 100 >= SEEDS * 95, "{} of {SEEDS} programs ended", ran.ended);
    assert!(ran.laps > SEEDS * 3 / 100, "{} programs with LAP", ran.laps);
}

/// Programs that were changed, by shrinking for example, are tested by the profile itself.
#[test]
fn a_profile_permits_its_own_cases_and_refuses_others() {
    let profile = Profile::of(SMALL);
    let foreign = |program: &[u8]| Case { program: program.to_vec(), ..case_from_seed_within(1, &profile) };
    let programs: [&[u8]; 8] = [b"V1=5", b"X=5", b"M65", b"G96 S5", b"A5", b"G1\n$X5 F1", b"M\t08", b"/X5"];
    for program in programs {
        assert!(!profile.permits(&foreign(program)), "{}", program.escape_ascii());
    }
    for seed in 0..SEEDS {
        let case = case_from_seed_within(seed, &profile);
        assert!(profile.permits(&case), "seed {seed}\n{}", case.program.escape_ascii());
    }
    let corners = Profile::of(&[SMALL, &[Feature::Chamfer]].concat());
    let any_angle = Case { setup: Setup::default(), program: b"G75 G01 X5 L1 F1\nZ9\nM02\n".to_vec() };
    assert!(!corners.permits(&any_angle));
    let mut basic = any_angle;
    basic.setup.parameters.chamfering = Chamfering::Basic;
    assert!(corners.permits(&basic));
}

/// What the programs of a profile did.
#[derive(Default)]
struct Ran {
    ended: u64,
    events: u64,
    kinds: BTreeSet<String>,
    /// How many programs have a motion of a cycle.
    cycles: u64,
    /// How many programs have a motion of LAP.
    laps: u64,
    /// How many programs have a motion in cutter radius compensation.
    cutters: u64,
}

fn stays_within(features: &[Feature]) -> Ran {
    check(features, 0..SEEDS)
}

fn check(features: &[Feature], seeds: std::ops::Range<u64>) -> Ran {
    let profile = Profile::of(features);
    let mut ran = Ran::default();
    for seed in seeds {
        let case = case_from_seed_within(seed, &profile);
        assert!(case.setup.validate().is_ok());
        let fail = |what: &str| {
            let text = String::from_utf8_lossy(&case.program);
            let absent: Vec<_> = Feature::ALL.iter().filter(|feature| !features.contains(feature)).collect();
            panic!("seed {seed}, {what}, profile without {absent:?}\n{text}\n{:?}", case.setup)
        };
        if !profile.permits(&case) {
            fail("the profile itself refuses it");
        }
        let foreign = foreign_words(&case, features);
        if !foreign.is_empty() {
            fail(&foreign);
        }
        let (mut cuts, mut laps, mut cutter) = (false, false, false);
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            ran.events += 1;
            let of_cycle =
                |rule: &RuleId| rule.as_str().contains("-GRV-") || rule.as_str().contains("-MCYC-");
            cuts |= event.rules.as_slice().iter().any(of_cycle);
            laps |= event.rules.as_slice().iter().any(|rule| rule.as_str().contains("-LAP"));
            cutter |= event.rules.as_slice().iter().any(|rule| rule.as_str() == "E100L-CRC-05");
            ran.ended += u64::from(matches!(event.action, Action::End { .. }));
            ran.kinds.insert(kind(event));
            let foreign = foreign_event(event, features);
            if !foreign.is_empty() {
                fail(&foreign);
            }
        });
        ran.cycles += u64::from(cuts);
        ran.laps += u64::from(laps);
        ran.cutters += u64::from(cutter);
    }
    println!("{} events, {} ended, {:?}", ran.events, ran.ended, ran.kinds);
    ran
}

fn kind(event: &Event) -> String {
    let text = turnspec_oracle::vocabulary::notation::render(event);
    text.split(' ').next().unwrap_or_default().to_owned()
}

/// What of a text lies outside a set of features; empty when nothing does.
fn foreign_words(case: &Case, features: &[Feature]) -> String {
    let has = |feature: &Feature| features.contains(feature);
    let tape = has(&Feature::TapeCode);
    let plain = |byte: &u8| *byte == b'\n' || (b' '..=b'~').contains(byte);
    if !tape && !case.program.iter().all(plain) {
        return "characters".to_owned();
    }
    if case.setup.tape.code != TapeCode::Ascii {
        // The codes of a tape are judged by what the oracle reads in them.
        return String::new();
    }
    let library = case.setup.library.values().flat_map(|text| [b"\n".to_vec(), text.0.clone()]);
    let text = [case.program.clone()].into_iter().chain(library).flatten().collect::<Vec<u8>>();
    if !tape && !text.iter().all(plain) {
        return "characters".to_owned();
    }
    let text = String::from_utf8_lossy(&text).into_owned();
    if without_strings(&text).contains('(') && !has(&Feature::Comment) {
        return "comment".to_owned();
    }
    let text = without_strings(&without_comments(&text));
    let extended = [Feature::MTool, Feature::CAxis, Feature::Torque, Feature::Grooving, Feature::Lap];
    let marks: [(&str, &[Feature]); 5] = [
        ("%:", &[Feature::ProgramName]),
        ("[]*,", &[Feature::Expression]),
        ("=", &[&[Feature::Expression], extended.as_slice()].concat()),
        ("/", &[Feature::BlockDelete, Feature::Expression]),
        ("$", &[Feature::ProgramName, Feature::Expression]),
    ];
    for (characters, any) in marks {
        if text.contains(|found| characters.contains(found)) && !any.iter().any(has) {
            return characters.to_owned();
        }
    }
    let programs = has(&Feature::Subprogram) && has(&Feature::ProgramName);
    let schedules = has(&Feature::Schedule);
    // Headers and the names of files are no words.
    let shown = |line: &&str| !(programs && line.starts_with('$') || schedules && line.contains("PSELECT"));
    text.lines().filter(shown).find_map(|line| foreign_word(line, features)).unwrap_or_default()
}

fn without_comments(text: &str) -> String {
    let mut inside = false;
    let mut rest = String::new();
    for character in text.chars() {
        inside = inside && character != '\n' || character == '(';
        if !inside {
            rest.push(character);
        }
        if inside && character == ')' {
            inside = false;
            rest.push(' ');
        }
    }
    rest
}

/// A line without the files and the program that PSELECT names, and without the Q before the number of repetitions.
fn without_selection(line: &str) -> String {
    let Some((before, items)) = line.split_once("PSELECT") else { return line.to_owned() };
    let repetitions = items.splitn(4, ',').nth(3).unwrap_or_default().trim_start();
    format!("{before}PSELECT {}", repetitions.strip_prefix('Q').unwrap_or(repetitions))
}

/// The text without strings and what surrounds them, and without the codes and commas of statements that send and receive.
fn without_strings(text: &str) -> String {
    let line = |line: &str| {
        let line = without_selection(line);
        let line = line.as_str();
        let communicates = ["GET", "PUT"].iter().any(|keyword| line.contains(keyword));
        if !communicates && !line.contains("VUACM") {
            return line.to_owned();
        }
        let mut rest: String = line.split('\'').step_by(2).collect::<Vec<_>>().concat().replace('^', "");
        if communicates {
            rest = rest.replace(',', " ");
        }
        match rest.split_once("PUT") {
            Some((before, sent)) if sent.contains('$') => format!("{before}PUT"),
            _ => rest,
        }
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// The letters of a line, blanks and the name of the block left out, against what they mean.
fn foreign_word(line: &str, features: &[Feature]) -> Option<String> {
    let line = line.trim_start_matches([' ', '/']);
    let line = match line.strip_prefix('N') {
        Some(rest) if rest.starts_with("OEX") => line,
        Some(_) if !features.contains(&Feature::SequenceName) => return Some(line.to_owned()),
        Some(rest) => rest.trim_start_matches(|character: char| character.is_ascii_alphanumeric()),
        None if line.starts_with(['O', ':']) && features.contains(&Feature::ProgramName) => return None,
        None => line,
    };
    let has = |feature: Feature| features.contains(&feature);
    let cycles = has(Feature::Grooving) || has(Feature::DrivenCycle);
    let lap = has(Feature::Lap);
    let needs: &[(&str, bool)] = &[
        ("A", has(Feature::AnyAngle)),
        ("C", has(Feature::CAxis)),
        ("W", has(Feature::WAxis) || has(Feature::Lap)),
        ("IK", has(Feature::Arc) || has(Feature::Thread) || cycles),
        ("D", has(Feature::Torque) || has(Feature::Thread) || cycles || lap),
        ("F", has(Feature::Feed) || has(Feature::Dwell)),
        ("S", has(Feature::Spindle)),
        ("T", has(Feature::Tool)),
        ("V", has(Feature::Variable) || has(Feature::SystemVariable)),
        ("BH", has(Feature::Alarm) || has(Feature::Thread) || lap),
        ("EJQU", has(Feature::Alarm) || has(Feature::Thread) || cycles || lap),
        ("R", has(Feature::Alarm) || has(Feature::DrivenCycle)),
        ("Y", has(Feature::Alarm) || has(Feature::ContourGeneration)),
        ("P", has(Feature::Alarm) || has(Feature::TwoSaddles)),
        ("O", has(Feature::Subprogram) || has(Feature::ModalCall) || has(Feature::Alarm)),
    ];
    for run in runs(line) {
        if let [letter] = run {
            let letter = char::from(*letter);
            if needs.iter().any(|(list, allowed)| list.contains(letter) && !allowed) {
                return Some(format!("{letter} in {line}"));
            }
        } else if !is_known_name(run, features) {
            return Some(format!("{} in {line}", run.escape_ascii()));
        }
    }
    None
}

/// The addresses, single letters, and the names of a line: two letters with what follows them, or a letter that
/// names a block or a program with what follows it.
fn runs(line: &str) -> Vec<&[u8]> {
    let mut runs = Vec::new();
    for mut run in line.as_bytes().split(|byte| !byte.is_ascii_uppercase() && !byte.is_ascii_digit()) {
        while let [first, rest @ ..] = run {
            let named = rest.first().is_some_and(u8::is_ascii_uppercase) || matches!(first, b'N' | b'O');
            if first.is_ascii_uppercase() && named {
                runs.push(run);
                break;
            }
            if first.is_ascii_uppercase() {
                runs.push(&run[..1]);
            }
            run = rest;
        }
    }
    runs
}

fn is_known_name(run: &[u8], features: &[Feature]) -> bool {
    let has = |feature: Feature| features.contains(&feature);
    match run {
        b"CALRG" => has(Feature::Arc),
        b"DA" => has(Feature::Grooving) || has(Feature::Lap) || has(Feature::Alarm),
        b"DB" | b"FA" | b"FB" | b"XA" | b"XB" | b"ZA" | b"ZB" => has(Feature::Lap) || has(Feature::Alarm),
        b"SB" => has(Feature::MTool),
        b"SA" | b"QA" => has(Feature::CAxis),
        b"PZ" | b"PW" => has(Feature::Torque),
        b"LT" | b"LE" | b"EQ" | b"NE" | b"GT" | b"GE" => has(Feature::Expression),
        b"ATAN2" => has(Feature::Function),
        b"AND" | b"OR" | b"EOR" | b"NOT" => has(Feature::Boolean),
        b"GOTO" | b"IF" | b"NOEX" => has(Feature::ControlStatement),
        b"CALL" | b"RTS" => has(Feature::Subprogram),
        b"MODIN" | b"MODOUT" => has(Feature::ModalCall),
        b"READ" | b"WRITE" | b"GET" | b"PUT" => has(Feature::Communication),
        b"PSELECT" | b"VSET" | b"END" => has(Feature::Schedule),
        b"VDIN" | b"VDOUT" | b"VIRD" | b"VORD" => has(Feature::InputOutput),
        b"VUACM" => has(Feature::UserAlarm),
        [b'N', ..] if has(Feature::ControlStatement) || has(Feature::Lap) => true,
        [b'O', ..] if has(Feature::Subprogram) => true,
        [b'V', ..] => has(Feature::SystemVariable),
        _ if has(Feature::Alarm) || has(Feature::LocalVariable) => true,
        _ => has(Feature::Function),
    }
}

/// What an event shows that lies outside a set of features.
fn foreign_event(event: &Event, features: &[Feature]) -> String {
    let has = |feature: Feature| features.contains(&feature);
    let allowed = match &event.action {
        Action::Rapid { .. } => has(Feature::Rapid),
        Action::Linear { .. } => {
            let feeds = [Feature::Linear, Feature::Torque, Feature::ContourGeneration];
            has(Feature::Feed) && feeds.into_iter().any(has)
        }
        Action::Arc { .. } => has(Feature::Feed) && (has(Feature::Arc) || has(Feature::Rounding)),
        Action::ContourArc { .. } => has(Feature::ContourGeneration),
        Action::Thread { .. } => has(Feature::Thread) || has(Feature::DrivenCycle),
        Action::Dwell { .. } => has(Feature::Dwell),
        Action::Spindle(spindle) => match spindle.spindle {
            SpindleName::Main => {
                (has(Feature::Spindle) || spindle.state == SpindleState::Stop)
                    && (spindle.surface.is_none() || has(Feature::CuttingSpeed))
                    && (spindle.gear.is_empty() || has(Feature::Gear))
            }
            SpindleName::Tool => has(Feature::MTool),
            SpindleName::CAxis => has(Feature::CAxis),
        },
        Action::Tool { .. } => has(Feature::Tool),
        Action::Coolant { .. } => has(Feature::Coolant),
        Action::Aux { code, .. } => match code.as_str() {
            "M15" | "M16" | "M109" | "M110" | "M146" | "M147" => has(Feature::CAxis),
            "M152" | "M153" => has(Feature::MTool),
            "M124" | "M125" => has(Feature::TimeOver),
            "M21" | "M25" => has(Feature::Barrier),
            "M203" => has(Feature::Turret),
            "M100" => has(Feature::TwoTurrets) || has(Feature::TwoSaddles),
            _ => has(Feature::Aux),
        },
        Action::Torque { .. } => has(Feature::Torque),
        Action::Frame { .. } => has(Feature::ZeroShift) || has(Feature::SystemVariable) || has(Feature::Tool),
        Action::Variable { .. } => {
            has(Feature::Variable) || has(Feature::SystemVariable) || has(Feature::LocalVariable)
        }
        Action::Call { .. } | Action::Return => has(Feature::Subprogram),
        Action::Output { .. } => has(Feature::Communication),
        Action::Message { .. } => has(Feature::UserAlarm),
        Action::Select { .. } => has(Feature::Schedule),
        Action::Wait { .. } | Action::Release { .. } | Action::SideEnd { .. } => has(Feature::TwoSaddles),
        Action::Stop | Action::OptionalStop => has(Feature::OptionalStop),
        Action::Mode { .. } | Action::End { .. } | Action::Alarm(_) => true,
    };
    let allowed = allowed
        && (event.turret.is_none() || has(Feature::TwoTurrets))
        && (event.saddle.is_none() || has(Feature::TwoSaddles));
    if !allowed {
        return kind(event);
    }
    let foreign = event.rules.as_slice().iter().find(|rule| !rule_allowed(rule.as_str(), features));
    foreign.map(|rule| rule.to_string()).unwrap_or_default()
}

/// Whether one of the features that a rule is about is allowed.
fn rule_allowed(id: &str, features: &[Feature]) -> bool {
    let mut parts = id.split('-').skip(1);
    let (area, number) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    let about: &[Feature] = match area {
        "ANG" | "DTAP" => &[Feature::AnyAngle, Feature::Chamfer, Feature::Rounding],
        "BARR" => &[Feature::Barrier],
        "CGF" | "CGS" | "CSC" => &[Feature::ContourGeneration],
        "BOOL" => &[Feature::Boolean],
        "CALL" | "RTS" => &[Feature::Subprogram, Feature::ModalCall],
        "GOTO" | "IFST" | "NOEX" => &[Feature::ControlStatement],
        "LVAR" if !["01", "12"].contains(&number) => &[Feature::LocalVariable],
        "MACRO" => &[Feature::MacroCode],
        "MODIN" => &[Feature::ModalCall],
        "NRC" => &[Feature::RadiusCompensation],
        "CAX" | "CFEED" => &[Feature::CAxis, Feature::MTool],
        "CHAM" => &[Feature::Chamfer, Feature::Rounding, Feature::AnyAngle],
        "CIRC" => &[Feature::Arc, Feature::Rounding],
        "CSS" if number != "02" => &[Feature::CuttingSpeed],
        "DEL" => &[Feature::BlockDelete],
        "DWELL" => &[Feature::Dwell],
        "G31" | "G32" | "G33" | "G34" | "G71" | "G72" | "TCHM" | "THRD" | "TINF" | "TMOD" | "TMUL" => {
            &[Feature::Thread]
        }
        "GRV" | "TAP" => &[Feature::Grooving],
        "CTHR" | "G181" | "G182" | "G183" | "G184" | "G189" | "G190" | "MCYC" | "STAP" => {
            &[Feature::DrivenCycle]
        }
        "LAP" | "LAPC" | "AP1" | "AP2" | "AP3" | "AP4" | "AP5" => &[Feature::Lap],
        "FUNC" => &[Feature::Function],
        "G50" => &[Feature::ZeroShift],
        "INCH" => &[Feature::Units],
        "LIM" => &[Feature::Limits],
        "CVAR" => &[Feature::Variable],
        "RDWR" | "GPUT" => &[Feature::Communication],
        "IOV" | "IORD" => &[Feature::InputOutput],
        "VUACM" => &[Feature::UserAlarm],
        "SDF" => &[Feature::Schedule],
        "SB" => &[Feature::MTool],
        "SMAX" | "SPD" => &[Feature::Spindle],
        "STM" => &[Feature::TimeOver],
        "SVAR" if number != "02" => &[Feature::SystemVariable],
        "TOOL" => &[Feature::Tool],
        "TRQ" => &[Feature::Torque],
        "TUNC" => &[Feature::Turret],
        "AX4" | "PSYNC" => &[Feature::TwoSaddles],
        "M100" => &[Feature::TwoTurrets, Feature::TwoSaddles],
        "MIRR" if number != "01" => &[Feature::TwoTurrets],
        _ => return true,
    };
    about.iter().any(|feature| features.contains(feature))
}
