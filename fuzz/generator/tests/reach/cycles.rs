//! Generated programs reach grooving, drilling and tapping cycles and those of driven tools: how many, how deep, and
//! every rule and alarm of them.

use std::collections::BTreeSet;

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, G184Tapping, Part, Reading, RuleId, Side};

use crate::citations::OF_ALL;
use crate::deeds::Deeds;
use crate::programs::{cites, motion_of, trace};

/// The rules that events cite (execution of drilling, section 10).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    GRV_01, GRV_02, GRV_03, GRV_04, GRV_05, GRV_06, GRV_07, GRV_08, GRV_09, GRV_10, TAP_01, TAP_02, TAP_03, TAP_04, TAP_06,
    MCYC_01, MCYC_02, MCYC_03, MCYC_05, MCYC_07, MCYC_08, MCYC_09, MCYC_10, MCYC_12, MCYC_15, MCYC_16, MCYC_17, MCYC_18,
    MCYC_19, MCYC_20, MCYC_22, G181_01, G182_01, G183_01, G183_02, G183_03, G184_01, G184_02, G189_01, STAP_01, STAP_02,
    STAP_03, STAP_04, CTHR_01, CTHR_02, CTHR_03, CTHR_04, CTHR_05, CAX_08, G190_01, G190_02, G190_03, G190_04, G190_05,
    G190_06, G190_07,
];

/// The alarms with the rules that they stand for.
#[rustfmt::skip]
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::AddressRange, ADDR_01),
    (AlarmName::AddressRange, DWELL_02),
    (AlarmName::AddressRange, G183_02),
    (AlarmName::AddressRange, G190_01),
    (AlarmName::AddressRange, G190_07),
    (AlarmName::AddressRange, GRV_04),
    (AlarmName::AddressRange, GRV_05),
    (AlarmName::AddressRange, STAP_01),
    (AlarmName::CAxisClamped, MCYC_11),
    (AlarmName::CAxisNotJoined, MCYC_11),
    (AlarmName::CompensationNotAllowed, NRC_81),
    (AlarmName::CycleApproachNegative, MCYC_05),
    (AlarmName::CycleCancelMissing, MCYC_21),
    (AlarmName::CycleDepthOverdetermined, MCYC_23),
    (AlarmName::CycleFeedMode, MCYC_03),
    (AlarmName::CycleIncremental, MCYC_14),
    (AlarmName::CycleWord, MCYC_14),
    (AlarmName::NoFeed, G01_03),
    (AlarmName::NotAlone, MCYC_02),
    (AlarmName::StatementMisplaced, TAP_01),
    (AlarmName::StepLimit, GOTO_03),
    (AlarmName::Unspecified, CTHR_04),
    (AlarmName::Unspecified, CTHR_05),
    (AlarmName::Unspecified, G183_01),
    (AlarmName::Unspecified, G183_02),
    (AlarmName::Unspecified, G190_01),
    (AlarmName::Unspecified, G190_02),
    (AlarmName::Unspecified, G190_07),
    (AlarmName::Unspecified, GRV_03),
    (AlarmName::Unspecified, GRV_05),
    (AlarmName::Unspecified, GRV_06),
    (AlarmName::Unspecified, GRV_08),
    (AlarmName::Unspecified, GRV_09),
    (AlarmName::Unspecified, GRV_10),
    (AlarmName::Unspecified, MCYC_01),
    (AlarmName::Unspecified, MCYC_04),
    (AlarmName::Unspecified, MCYC_05),
    (AlarmName::Unspecified, MCYC_09),
    (AlarmName::Unspecified, MCYC_14),
    (AlarmName::Unspecified, NRC_81),
    (AlarmName::Unspecified, STAP_01),
    (AlarmName::Unspecified, TAP_01),
    (AlarmName::Unspecified, TAP_02),
    (AlarmName::Unspecified, TAP_04),
    (AlarmName::Unspecified, THRD_06),
    (AlarmName::WordMissing, CTHR_01),
    (AlarmName::WordMissing, G183_01),
    (AlarmName::WordMissing, G190_01),
    (AlarmName::WordMissing, GRV_01),
    (AlarmName::WordMissing, GRV_02),
    (AlarmName::WordMissing, GRV_10),
    (AlarmName::WordMissing, MCYC_04),
    (AlarmName::WordMissing, MCYC_13),
    (AlarmName::WordMissing, MCYC_22),
    (AlarmName::WordMissing, TAP_01),
    (AlarmName::WordWithoutFunction, ADDR_01),
];

/// Details of alarms that have to be met too.
#[rustfmt::skip]
const DETAILS: &[(AlarmName, &str)] = &[
    (AlarmName::Unspecified, "depth"), (AlarmName::Unspecified, "shift"), (AlarmName::Unspecified, "slot"),
    (AlarmName::Unspecified, "speed"), (AlarmName::Unspecified, "c_axis"), (AlarmName::Unspecified, "G96"),
    (AlarmName::Unspecified, "W"), (AlarmName::Unspecified, "U"), (AlarmName::Unspecified, "T"),
    (AlarmName::Unspecified, "D"), (AlarmName::Unspecified, "I"), (AlarmName::Unspecified, "K"),
    (AlarmName::Unspecified, "L"), (AlarmName::Unspecified, "C"), (AlarmName::Unspecified, "J"),
    (AlarmName::Unspecified, "G50"), (AlarmName::CycleWord, "S"), (AlarmName::CycleWord, "M02"),
    (AlarmName::CycleFeedMode, "G181"), (AlarmName::CycleFeedMode, "G187"), (AlarmName::CycleFeedMode, "G190"),
    (AlarmName::WordWithoutFunction, "R"), (AlarmName::WordWithoutFunction, "DA"),
    (AlarmName::StatementMisplaced, "G77"), (AlarmName::StatementMisplaced, "G78"),
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    programs: u64,
    /// Programs with a cycle, their events, and those of cycles.
    cycles: u64,
    events: u64,
    motions: u64,
    deeds: Deeds,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let events = trace(case);
        self.programs += 1;
        if !events.iter().any(is_of_cycle) {
            return;
        }
        self.cycles += 1;
        self.events += events.len() as u64;
        self.motions += events.iter().filter(|event| is_of_cycle(event)).count() as u64;
        self.deeds.add(&events, deeds(case, &events));
    }
}

/// Whether it is a motion of one of these cycles.
fn is_of_cycle(event: &Event) -> bool {
    const AREAS: &[&str] = &["GRV", "TAP", "G181", "G182", "G183", "G184", "G189", "STAP", "G190", "CTHR"];
    let area = |rule: &RuleId| AREAS.contains(&rule.as_str().split('-').nth(1).unwrap_or_default());
    motion_of(event).is_some_and(|motion| motion.part.is_some()) && event.rules.as_slice().iter().any(area)
}

/// What the events of a program show.
fn deeds(case: &Case, events: &[Event]) -> BTreeSet<&'static str> {
    const RULES: &[(RuleId, &str)] = &[
        (GRV_01, "groove from X"),
        (GRV_02, "groove from Z"),
        (GRV_05, "withdrawal of a groove"),
        (GRV_08, "T of a groove"),
        (TAP_02, "G77"),
        (TAP_03, "G78"),
        (G181_01, "G181"),
        (G182_01, "G182"),
        (G183_02, "chips of G183"),
        (G184_01, "G184"),
        (G184_02, "G184 synchronised"),
        (G189_01, "G189"),
        (STAP_03, "G179"),
        (CTHR_02, "G185"),
        (CTHR_03, "G186"),
        (CTHR_04, "G187"),
        (CTHR_05, "G188"),
        (G190_03, "M211"),
        (G190_04, "M212"),
        (G190_05, "M213"),
        (G190_06, "M214"),
        (G190_07, "finishing pass"),
        (MCYC_08, "side"),
        (MCYC_09, "follow-up"),
        (MCYC_17, "further hole of Q"),
        (MCYC_18, "M141"),
        (MCYC_19, "M140"),
        (MCYC_22, "R"),
    ];
    let mut deeds = BTreeSet::new();
    let (mut pecks, mut blocks) = (0, BTreeSet::new());
    let mut cycle = false;
    for event in events {
        match event.action {
            Action::Mode { group, code, .. } if group.as_str() == "cycle" => cycle = code.as_str() != "G180",
            Action::Variable { .. } if cycle => {
                deeds.insert("assignment in a cycle");
            }
            Action::Frame { .. } if cycle => {
                deeds.insert("other frame in a cycle");
            }
            Action::Call { .. } if cycle => {
                deeds.insert("call in a cycle");
            }
            _ => {}
        }
        let Some(motion) = motion_of(event).filter(|_| is_of_cycle(event)) else { continue };
        deeds.extend(RULES.iter().filter(|(rule, _)| cites(event, *rule)).map(|(_, deed)| *deed));
        blocks.insert(event.block.line);
        if motion.part == Some(Part::Cut) && motion.pass.is_some_and(|pass| pass > 1) {
            pecks += 1;
        }
        let list = [
            (cites(event, ABS_02), "in G91"),
            (cites(event, INCH_02), "in inches"),
            (!event.block.program.is_empty(), "in a called program"),
            (event.turret == Some(Side::B), "turret B"),
            (event.saddle == Some(Side::B), "saddle B"),
            (cites(event, BARR_01), "beside a barrier"),
            (
                event.readings.iter().any(|reading| matches!(reading, Reading::ChipDischarge(_))),
                "chip discharge",
            ),
            (
                event.readings.iter().any(|reading| matches!(reading, Reading::KeywayReturn(_))),
                "keyway return",
            ),
        ];
        deeds.extend(list.into_iter().filter(|(holds, _)| *holds).map(|(_, deed)| deed));
    }
    let compensated = |event: &Event| motion_of(event).is_some_and(|motion| motion.nose.is_some());
    let list = [
        (pecks > 20, "more than twenty pecks"),
        (blocks.len() > 8, "more than eight blocks"),
        (events.iter().any(compensated), "compensation elsewhere"),
        (case.setup.parameters.g184_tapping == G184Tapping::Synchronised, "parameter of G184"),
        (events.iter().any(|event| matches!(event.action, Action::Select { .. })), "in a schedule"),
    ];
    deeds.extend(list.into_iter().filter(|(holds, _)| *holds).map(|(_, deed)| deed));
    deeds
}

/// Of a hundred programs about eight have cycles; most of them end, after much.
#[test]
fn programs_with_cycles_are_many_and_deep() {
    const SOME: u64 = 10_000;
    let mut reached = Reached::default();
    (0..SOME).map(case_from_seed).for_each(|case| reached.add(&case));
    let Reached { cycles, events, motions, deeds, .. } = reached;
    let ended = deeds.ended;
    println!("{cycles} programs, {ended} ended, {events} events, {motions} motions of cycles");
    println!("{deeds:?}");
    assert!((SOME * 6..SOME * 11).contains(&(cycles * 100)), "{cycles} programs of {SOME}");
    assert!(ended * 100 > cycles * 60, "{ended} of {cycles} ended");
    assert!(events > cycles * 80 && motions > cycles * 40, "{events} events, {motions} of cycles");
    deeds.demand(&[
        ("G179", 33),
        ("G181", 44),
        ("G182", 40),
        ("G184", 52),
        ("G184 synchronised", 24),
        ("G185", 37),
        ("G186", 25),
        ("G187", 32),
        ("G188", 32),
        ("G189", 43),
        ("G77", 94),
        ("G78", 96),
        ("M140", 12),
        ("M141", 132),
        ("M211", 99),
        ("M212", 27),
        ("M213", 99),
        ("M214", 28),
        ("R", 134),
        ("T of a groove", 30),
        ("assignment in a cycle", 85),
        ("beside a barrier", 39),
        ("call in a cycle", 43),
        ("chip discharge", 24),
        ("chips of G183", 24),
        ("compensation elsewhere", 128),
        ("finishing pass", 36),
        ("follow-up", 269),
        ("further hole of Q", 40),
        ("groove from X", 187),
        ("groove from Z", 188),
        ("in G91", 101),
        ("in a called program", 166),
        ("in a schedule", 13),
        ("in inches", 66),
        ("keyway return", 99),
        ("more than eight blocks", 150),
        ("more than twenty pecks", 128),
        ("other frame in a cycle", 10),
        ("parameter of G184", 136),
        ("saddle B", 28),
        ("side", 84),
        ("turret B", 7),
        ("withdrawal of a groove", 79),
    ]);
}

/// Every rule of these families that an event cites, and every alarm of them with the rule that it stands for.
#[test]
fn every_rule_and_alarm_of_cycles_is_reached() {
    OF_ALL.demand(CITED, ALARMS);
    OF_ALL.demand_details(DETAILS);
}
