//! Generated programs reach LAP: how many, how deep, and every rule and alarm of it.

use std::collections::BTreeSet;

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, Part, RuleId};

use crate::citations::OF_ALL;
use crate::deeds::Deeds;
use crate::programs::{cites, trace};

/// The rules that events cite (execution of LAP, section 14).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    LAP_01, LAP_02, LAP_05, LAP_06, LAP_07, LAP_08, LAP_09, LAP_13, LAP_16, LAP_18, LAP_21, LAPC_01, LAPC_02,
    LAPC_03, LAPC_05, LAPC_06, LAPC_07, LAPC_08, AP1_01, AP1_02, AP1_03, AP1_04, AP1_05, AP1_06, AP1_07,
    AP1_08, AP1_09, AP1_10, AP1_11, AP1_12, AP1_14, AP2_01, AP2_02, AP2_03, AP2_04, AP2_05, AP3_01, AP3_02,
    AP3_03, AP3_04, AP4_01, AP4_02, AP4_03, AP4_04, AP4_05, AP4_06, AP4_07, AP4_08, AP4_09, AP5_01, AP5_02,
    AP5_03, AP5_04, AP5_05, AP5_06, AP5_07,
];

/// The alarms with the rules that they stand for.
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::BlankFirstElement, LAP_03),
    (AlarmName::CompensationNotAllowed, LAP_15),
    (AlarmName::ContourDirection, AP5_08),
    (AlarmName::ContourMalformed, AP3_01),
    (AlarmName::ContourMalformed, LAP_01),
    (AlarmName::ContourMalformed, LAP_02),
    (AlarmName::ContourMalformed, LAP_03),
    (AlarmName::ContourMalformed, LAP_04),
    (AlarmName::ContourMalformed, LAP_05),
    (AlarmName::ContourMalformed, LAP_09),
    (AlarmName::ContourMalformed, LAP_10),
    (AlarmName::ContourMalformed, LAP_11),
    (AlarmName::ContourMalformed, LAP_12),
    (AlarmName::ContourMalformed, LAP_14),
    (AlarmName::ContourMalformed, LAP_16),
    (AlarmName::DescendingSlopes, AP1_13),
    (AlarmName::Format, LAP_09),
    (AlarmName::LapAllowance, AP2_01),
    (AlarmName::LapAllowance, AP5_02),
    (AlarmName::LapAllowance, LAP_20),
    (AlarmName::LapData, LAPC_01),
    (AlarmName::LapData, LAPC_02),
    (AlarmName::LapData, LAPC_04),
    (AlarmName::LapData, LAPC_05),
    (AlarmName::LapData, LAPC_07),
    (AlarmName::LapData, LAP_07),
    (AlarmName::LapLevel, LAP_22),
    (AlarmName::LapStartPoint, LAP_20),
    (AlarmName::NotAlone, LAP_01),
    (AlarmName::NotAlone, LAP_02),
    (AlarmName::SequenceNameUnknown, LAP_09),
    (AlarmName::StatementMisplaced, LAP_09),
    (AlarmName::Unspecified, AP1_02),
    (AlarmName::Unspecified, AP3_02),
    (AlarmName::Unspecified, AP4_03),
    (AlarmName::Unspecified, AP4_06),
    (AlarmName::Unspecified, AP5_01),
    (AlarmName::Unspecified, LAPC_06),
    (AlarmName::Unspecified, LAP_04),
    (AlarmName::Unspecified, LAP_15),
    (AlarmName::Unspecified, LAP_20),
    (AlarmName::WordMissing, LAPC_01),
    (AlarmName::WordMissing, LAPC_05),
    (AlarmName::WordMissing, LAPC_07),
    (AlarmName::WordWithoutFunction, LAPC_02),
    (AlarmName::WordWithoutFunction, LAPC_07),
    (AlarmName::WordWithoutFunction, LAP_17),
];

/// Details of alarms of LAP that have to be met too.
const DETAILS: &[&str] = &[
    "B",
    "D",
    "DA",
    "E",
    "F",
    "FA",
    "G00",
    "G80",
    "G83",
    "G85",
    "G90",
    "H",
    "M73",
    "MODIN",
    "U",
    "W",
    "X",
    "XB",
    "Z",
    "blank",
    "direction",
    "empty",
    "end",
    "first",
    "side",
    "start",
    "thread",
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    /// Programs with LAP, their events, and those of LAP.
    programs: u64,
    events: u64,
    motions: u64,
    deeds: Deeds,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let events = trace(case);
        let motions = events.iter().filter(|event| is_of_lap(event)).count() as u64;
        if motions == 0 {
            return;
        }
        self.programs += 1;
        self.events += events.len() as u64;
        self.motions += motions;
        let deeds: BTreeSet<_> = events.iter().flat_map(|event| deeds(case, event)).collect();
        self.deeds.add(&events, deeds);
    }
}

/// Whether it is a motion of a rough cycle or of G87.
fn is_of_lap(event: &Event) -> bool {
    let motion = matches!(
        event.action,
        Action::Rapid { .. } | Action::Linear { .. } | Action::Arc { .. } | Action::Thread { .. }
    );
    motion && (cites(event, LAP_01) || cites(event, LAPC_06))
}

/// What a motion shows.
fn deeds(case: &Case, event: &Event) -> Vec<&'static str> {
    const RULES: &[(RuleId, &str)] = &[
        (AP1_02, "mode I"),
        (AP1_10, "over a recess"),
        (AP1_11, "recess"),
        (AP1_14, "mode I across"),
        (AP2_01, "mode II"),
        (AP2_02, "mode II across"),
        (AP3_01, "mode III"),
        (AP3_03, "mode III across"),
        (AP4_01, "mode IV"),
        (AP4_03, "mode IV, start near"),
        (AP4_05, "air"),
        (AP4_09, "mode IV across"),
        (AP5_03, "mode V"),
        (AP5_06, "mode V, from the contour along the blank"),
        (LAPC_03, "change point"),
        (LAPC_06, "G87"),
        (LAP_07, "E"),
        (LAP_16, "compensation"),
        (LAP_21, "allowance"),
        (BARR_01, "beside a barrier"),
        (INCH_02, "inches"),
    ];
    if !is_of_lap(event) {
        return Vec::new();
    }
    let mut deeds: Vec<_> =
        RULES.iter().filter(|(rule, _)| cites(event, *rule)).map(|(_, deed)| *deed).collect();
    let (part, pass) = match event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } | Action::Arc { motion, .. } => {
            (motion.part, motion.pass)
        }
        _ => (None, None),
    };
    let list = [
        (matches!(event.action, Action::Arc { .. }), "arc"),
        (part == Some(Part::Home) && matches!(event.action, Action::Rapid { .. }), "home"),
        (pass.is_some_and(|pass| pass > 20), "more than twenty passes"),
        (case.setup.options.lap == 3, "level 3"),
    ];
    deeds.extend(list.into_iter().filter(|(holds, _)| *holds).map(|(_, deed)| deed));
    deeds
}

/// Of a hundred programs about seven have LAP; most of them end, after much.
#[test]
fn programs_with_lap_are_many_and_deep() {
    const SOME: u64 = 10_000;
    let mut reached = Reached::default();
    (0..SOME).map(case_from_seed).for_each(|case| reached.add(&case));
    let Reached { programs, events, motions, deeds } = reached;
    let ended = deeds.ended;
    println!("{programs} programs, {ended} ended, {events} events, {motions} motions of LAP");
    println!("{deeds:?}");
    assert!((SOME * 5..SOME * 10).contains(&(programs * 100)), "{programs} programs of {SOME}");
    assert!(ended * 100 > programs * 60, "{ended} of {programs} ended");
    assert!(events > programs * 80 && motions > programs * 50, "{events} events, {motions} of LAP");
    deeds.demand(&[
        ("mode I", 200),
        ("over a recess", 80),
        ("recess", 80),
        ("mode II", 60),
        ("mode III", 25),
        ("mode IV", 60),
        ("mode IV, start near", 15),
        ("air", 15),
        ("mode V", 25),
        ("mode V, from the contour along the blank", 10),
        ("change point", 40),
        ("G87", 80),
        ("E", 150),
        ("compensation", 10),
        ("allowance", 200),
        ("arc", 150),
        ("mode I across", 40),
        ("mode II across", 15),
        ("mode III across", 5),
        ("mode IV across", 15),
        ("inches", 30),
        ("more than twenty passes", 12),
        ("level 3", 30),
    ]);
}

/// Every rule of LAP that an event cites, and every alarm of it with the rule that it stands for.
#[test]
fn every_rule_and_alarm_of_lap_is_reached() {
    OF_ALL.demand(CITED, ALARMS);
    OF_ALL.demand_details_of(&["E100L-LAP", "E100L-AP"], DETAILS);
}
