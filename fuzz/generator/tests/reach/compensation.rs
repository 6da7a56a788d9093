//! Generated programs reach radius compensation in G18: how many, how deep, and every rule and alarm of it.

use std::collections::BTreeMap;

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, RuleId};

use crate::citations::Citations;
use crate::programs::motion_of;

/// Programs in which every rule has to be met.
const PROGRAMS: u64 = 12_000;

/// The rules that events of compensation and planes cite (execution, section "Rules that events cite", and the
/// alarms of its checks).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    CRC_01, CRC_02, CRC_03, CRC_04, CRC_13, NRC_01, NRC_07, NRC_11, NRC_14, NRC_15, NRC_18, NRC_19,
    NRC_20, NRC_21, NRC_22, NRC_23, NRC_24, NRC_26, NRC_30, NRC_31, NRC_32, NRC_33, NRC_41, NRC_42, NRC_43,
    NRC_44, NRC_45, NRC_46, NRC_48, NRC_49, NRC_51, NRC_52, NRC_53, NRC_60, NRC_61, NRC_62, NRC_63, NRC_66,
    NRC_69, NRC_70, NRC_71, NRC_72, NRC_80, NRC_81,
];

/// The alarms of compensation and planes.
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::CAxisNotJoined, CRC_02),
    (AlarmName::PlaneChangeInCompensation, CRC_13),
    (AlarmName::CompensationNotLinear, NRC_19),
    (AlarmName::CompensationNotLinear, NRC_72),
    (AlarmName::CompensationStartUp, NRC_21),
    (AlarmName::CompensationStartUp, NRC_22),
    (AlarmName::CompensationImaginaryPoint, NRC_24),
    (AlarmName::CompensationImaginaryPoint, NRC_70),
    (AlarmName::CompensationArcTooSmall, NRC_48),
    (AlarmName::CompensationNoIntersection, NRC_53),
    (AlarmName::CompensationNotAllowed, NRC_81),
    (AlarmName::TravelLimitPositive, NRC_80),
    (AlarmName::TravelLimitNegative, NRC_80),
    (AlarmName::Unspecified, NRC_15),
    (AlarmName::Unspecified, NRC_20),
    (AlarmName::Unspecified, NRC_71),
    (AlarmName::Unspecified, NRC_81),
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    /// Programs with a motion in compensation.
    compensated: u64,
    /// Those of them that reached M02 or M30.
    ended: u64,
    motions: u64,
    citations: Citations,
    last: BTreeMap<AlarmName, u64>,
}

impl Reached {
    fn of(seeds: std::ops::Range<u64>) -> Self {
        let mut reached = Self::default();
        seeds.for_each(|seed| reached.add(&case_from_seed(seed)));
        reached
    }

    fn add(&mut self, case: &Case) {
        let (mut motions, mut ended) = (0, false);
        let mut alarm = None;
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            motions += u64::from(
                motion_of(event).is_some_and(|motion| motion.tip.is_some() && motion.tip_c.is_none()),
            );
            ended |= matches!(event.action, Action::End { .. });
            self.citations.event(event);
            if let Action::Alarm(raised) = event.action {
                alarm = Some(raised.name);
            }
        });
        self.motions += motions;
        self.compensated += u64::from(motions > 0);
        self.ended += u64::from(motions > 0 && ended);
        if let (Some(alarm), true) = (alarm, motions > 0) {
            *self.last.entry(alarm).or_default() += 1;
        }
    }
}

fn is_of_compensation(rule: &RuleId) -> bool {
    ["NRC", "CRC"].iter().any(|area| rule.as_str().split('-').nth(1) == Some(area))
}

/// Of a hundred programs with everything allowed about thirty have compensation, and most of those end.
#[test]
fn compensated_programs_are_many_and_deep() {
    let reached = Reached::of(0..4_000);
    println!("{} programs, {} compensated, {} of them ended", 4_000, reached.compensated, reached.ended);
    println!("{} motions, alarms of the others {:?}", reached.motions, reached.last);
    assert!((1_000..1_500).contains(&reached.compensated), "{}", reached.compensated);
    assert!(reached.ended * 100 > reached.compensated * 70, "{} ended", reached.ended);
    assert!(reached.motions > reached.compensated * 7, "{} motions", reached.motions);
}

/// Every rule of compensation that an event cites, and every alarm of it with the rule that it stands for.
#[test]
fn every_rule_and_alarm_is_reached() {
    let reached = Reached::of(0..PROGRAMS);
    reached.citations.demand(CITED, ALARMS);
}

/// Rules of compensation in G17 and G119, which a test of its own is about.
const OF_CUTTERS: &[RuleId] =
    &[CRC_05, CRC_06, CRC_07, CRC_08, CRC_10, CRC_12, CRC_14, CRC_15, CRC_16, CRC_18];

/// Rules of the chapters on compensation that are not in `CITED` are never cited.
#[test]
fn no_other_rule_is_cited() {
    let reached = Reached::of(PROGRAMS..PROGRAMS + 2_000);
    let of_it = reached.citations.rules.iter().filter(|rule| is_of_compensation(rule));
    let other: Vec<_> = of_it.filter(|rule| !CITED.contains(rule) && !OF_CUTTERS.contains(rule)).collect();
    assert!(other.is_empty(), "not in the list: {other:?}");
}
