//! Generated programs reach thread cutting: how many, how deep, and every rule and alarm of it.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, BalancedInfeed, Event, LeadAxis, Part, RuleId, Side};

use crate::citations::{OF_ALL, PROGRAMS};
use crate::deeds::Deeds;
use crate::programs::{cites, motion_of, trace};

/// The rules that events cite (execution of threads, section 9).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    G32_01, G32_02, G32_03, G32_04, G33_01, G33_02, G33_03, G33_04, G33_05, G33_06, G33_07, G33_08, G33_09, G33_10, G34_01,
    G34_02, G34_03, G34_04, G34_05, G71_01, G71_02, G71_03, G71_04, G71_05, G71_06, G71_07, G71_08, G71_10, G72_01, G72_02,
    G72_03, DTAP_03, DTAP_05, TCHM_01, TCHM_02, TCHM_03, TCHM_04, THRD_06, TINF_01, TINF_02, TINF_03, TINF_04, TINF_05,
    TINF_06, TINF_07, TINF_08, TMOD_01, TMOD_02, TMOD_03, TMOD_04, TMUL_01, TMUL_02,
];

/// The alarms with the rules that they stand for.
#[rustfmt::skip]
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::AddressRange, ADDR_01),
    (AlarmName::AddressRange, G34_02),
    (AlarmName::AddressRange, THRD_07),
    (AlarmName::AngleLookahead, ANG_06),
    (AlarmName::AngleNoIntersection, ANG_06),
    (AlarmName::AngleNoIntersection, DTAP_04),
    (AlarmName::AngleNoIntersection, G33_06),
    (AlarmName::AngleOverdetermined, DTAP_01),
    (AlarmName::AngleOverdetermined, G33_06),
    (AlarmName::AngleOverdetermined, G71_04),
    (AlarmName::AngleUnderdetermined, DTAP_01),
    (AlarmName::ChamferNotLinear, CHAM_05),
    (AlarmName::CompensationNotAllowed, NRC_81),
    (AlarmName::GCodesConflict, GCODE_04),
    (AlarmName::NoFeed, THRD_04),
    (AlarmName::NotModelled, THRD_10),
    (AlarmName::StepLimit, GOTO_03),
    (AlarmName::ThreadData, G71_09),
    (AlarmName::ThreadInConstantSpeed, THRD_01),
    (AlarmName::ThreadLeadRange, G33_09),
    (AlarmName::ThreadLeadRange, THRD_04),
    (AlarmName::Unspecified, G33_04),
    (AlarmName::Unspecified, G34_04),
    (AlarmName::Unspecified, NRC_81),
    (AlarmName::Unspecified, TCHM_02),
    (AlarmName::Unspecified, TCHM_03),
    (AlarmName::Unspecified, TCHM_04),
    (AlarmName::Unspecified, THRD_06),
    (AlarmName::Unspecified, THRD_10),
    (AlarmName::Unspecified, TINF_06),
    (AlarmName::Unspecified, TINF_07),
    (AlarmName::WordMissing, G32_01),
    (AlarmName::WordMissing, G32_04),
    (AlarmName::WordMissing, G33_01),
    (AlarmName::WordMissing, G33_03),
    (AlarmName::WordMissing, G34_01),
    (AlarmName::WordMissing, G71_01),
    (AlarmName::WordMissing, G71_09),
    (AlarmName::WordMissing, G72_01),
    (AlarmName::WordWithoutFunction, ADDR_01),
];

/// Details of alarms, with what raises them, that have to be met too.
#[rustfmt::skip]
const DETAILS: &[(AlarmName, &str)] = &[
    (AlarmName::ThreadData, "D"), (AlarmName::ThreadData, "H"), (AlarmName::ThreadData, "B"), (AlarmName::ThreadData, "U"),
    (AlarmName::ThreadData, "W"), (AlarmName::ThreadData, "M73"), (AlarmName::ThreadInConstantSpeed, "G33"),
    (AlarmName::ThreadInConstantSpeed, "G72"), (AlarmName::Unspecified, "side"), (AlarmName::Unspecified, "length"),
    (AlarmName::Unspecified, "chamfer"), (AlarmName::Unspecified, "speed"), (AlarmName::Unspecified, "taper"),
    (AlarmName::Unspecified, "c_axis"), (AlarmName::Unspecified, "J"), (AlarmName::Unspecified, "M75"),
    (AlarmName::NotModelled, "M194"), (AlarmName::WordWithoutFunction, "J"), (AlarmName::WordWithoutFunction, "Q"),
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    programs: u64,
    /// Programs with a thread, and their events.
    threads: u64,
    events: u64,
    passes: u64,
    deeds: Deeds,
}

/// Whether an event cuts a thread.
fn cuts(event: &Event) -> bool {
    matches!(event.action, Action::Thread { spindle: None, .. })
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let events = trace(case);
        self.programs += 1;
        if !events.iter().any(cuts) {
            return;
        }
        self.threads += 1;
        self.events += events.len() as u64;
        self.passes += events.iter().filter(|event| cuts(event)).count() as u64;
        self.deeds.add(&events, deeds(case, &events));
    }
}

/// What the events of a program show.
fn deeds(case: &Case, events: &[Event]) -> BTreeSet<&'static str> {
    let mut deeds = BTreeSet::new();
    let mut exits = 0;
    let mut lines: BTreeMap<u32, u64> = BTreeMap::new();
    let mut called = 0;
    let mut open = None;
    for event in events {
        if cites(event, ANG_06) {
            // The corner that a block with A alone finds, and the block behind it.
            let cut = cuts(event);
            match open.take() {
                None => open = Some(cut),
                Some(false) if cut => drop(deeds.insert("an angle alone before a length")),
                Some(true) if cut => drop(deeds.insert("an angle alone between lengths")),
                Some(true) => drop(deeds.insert("an angle alone behind a length")),
                Some(false) => {}
            }
        }
        match event.action {
            Action::Call { .. } => called += 1,
            Action::Return => called -= 1,
            _ => {}
        }
        let part = motion_of(event).and_then(|motion| motion.part);
        exits = if part == Some(Part::Exit) { exits + 1 } else { 0 };
        let Action::Thread { motion, axis, change, spindle: None, .. } = event.action else { continue };
        *lines.entry(event.block.line).or_default() += u64::from(part == Some(Part::Cut));
        let compound = cites(event, G71_01) || cites(event, G72_01);
        let list = [
            (axis == LeadAxis::X && part.is_some(), "on the face"),
            (part.is_none(), "length of a chain"),
            (part.is_none() && axis == LeadAxis::X, "length along X"),
            (exits == 1, "chamfer"),
            (exits == 2, "chamfer up to the start"),
            (change.is_some() && part == Some(Part::Exit), "chamfer of a changing lead"),
            (change.is_some_and(|change| change.0 < 0), "shrinking lead"),
            (motion.pass > Some(20), "more than twenty passes"),
            (cites(event, TMUL_01), "several starts"),
            (cites(event, TMOD_04) && cites(event, TINF_05), "by turns in equal areas"),
            (compound && cites(event, G33_06), "whole thread with an angle"),
            (cites(event, TINF_06) || cites(event, TINF_07), "balanced infeed"),
            (called > 0, "in a called program"),
            (event.turret == Some(Side::B), "turret B"),
            (event.saddle == Some(Side::B), "saddle B"),
            (cites(event, BARR_01), "beside a barrier"),
            (cites(event, INCH_02), "in inches"),
            (cites(event, ABS_02), "in G91"),
        ];
        deeds.extend(list.into_iter().filter(|(holds, _)| *holds).map(|(_, deed)| deed));
    }
    let compensated = |event: &Event| motion_of(event).is_some_and(|motion| motion.nose.is_some());
    let list = [
        (events.iter().any(compensated), "compensation elsewhere"),
        (case.setup.readings.balanced_infeed == BalancedInfeed::EqualArea, "reading of balanced infeed"),
        (lines.values().any(|count| *count > 1), "a block that cuts more than once"),
        (events.iter().any(|event| matches!(event.action, Action::Select { .. })), "in a schedule"),
    ];
    deeds.extend(list.into_iter().filter(|(holds, _)| *holds).map(|(_, deed)| deed));
    deeds
}

/// Of a hundred programs about ten cut threads; most of them end, after much.
#[test]
fn programs_with_threads_are_many_and_deep() {
    const SOME: u64 = 10_000;
    let mut reached = Reached::default();
    (0..SOME).map(case_from_seed).for_each(|case| reached.add(&case));
    let Reached { threads, events, passes, deeds, .. } = reached;
    let ended = deeds.ended;
    println!("{threads} programs, {ended} ended, {events} events, {passes} thread events");
    println!("{deeds:?}");
    assert!((SOME * 8..SOME * 13).contains(&(threads * 100)), "{threads} programs of {SOME}");
    assert!(ended * 100 > threads * 60, "{ended} of {threads} ended");
    assert!(events > threads * 50 && passes > threads * 12, "{events} events, {passes} of threads");
    deeds.demand(&[
        ("an angle alone before a length", 35),
        ("an angle alone behind a length", 20),
        ("an angle alone between lengths", 35),
        ("a block that cuts more than once", 500),
        ("balanced infeed", 25),
        ("beside a barrier", 40),
        ("by turns in equal areas", 6),
        ("chamfer", 300),
        ("chamfer of a changing lead", 60),
        ("chamfer up to the start", 150),
        ("compensation elsewhere", 150),
        ("in G91", 200),
        ("in a called program", 40),
        ("in a schedule", 20),
        ("in inches", 80),
        ("length along X", 100),
        ("length of a chain", 250),
        ("more than twenty passes", 10),
        ("on the face", 300),
        ("reading of balanced infeed", 250),
        ("saddle B", 30),
        ("several starts", 80),
        ("shrinking lead", 150),
        ("turret B", 15),
        ("whole thread with an angle", 35),
    ]);
}

/// Every rule of these families that an event cites, and every alarm of them with the rule that it stands for.
#[test]
fn every_rule_and_alarm_of_threads_is_reached() {
    let mut behind_angles = BTreeSet::new();
    for case in (0..PROGRAMS).map(case_from_seed) {
        let mut length = false;
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            if let Action::Mode { group, code, .. } = event.action
                && group.as_str() == "motion"
            {
                length = ["G34", "G35"].contains(&code.as_str());
            }
            if let Action::Alarm(alarm) = event.action
                && length
                && cites(event, ANG_06)
            {
                behind_angles.insert(alarm.name);
            }
        });
    }
    let of_lengths = [AlarmName::AngleLookahead, AlarmName::AngleNoIntersection, AlarmName::Unspecified];
    assert_eq!(behind_angles, BTreeSet::from(of_lengths), "alarms of lengths with an angle alone");
    OF_ALL.demand(CITED, ALARMS);
    OF_ALL.demand_details(DETAILS);
}
