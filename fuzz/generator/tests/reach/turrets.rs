//! Generated programs reach two turrets, two saddles and their synchronisation: how many, how deep, and every rule and
//! alarm of them.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Event, MachineType, ReleaseCause, RuleId, Side, SpindleName,
};

use crate::citations::OF_ALL;
use crate::deeds::Deeds;
use crate::programs::{cites, motion_of, trace};

/// The rules that events cite (execution of turrets, section 5).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    MIRR_04, MIRR_05, MIRR_06, MIRR_10, MIRR_11, MIRR_18, MIRR_19, AX4_05, AX4_06, AX4_08, PSYNC_02, PSYNC_03, PSYNC_04,
    M100_01, M100_03, M100_05, M100_06,
];

/// The alarms with the rules that they stand for.
#[rustfmt::skip]
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::TurretMissing, MIRR_01),
    (AlarmName::TurretChange, MIRR_08),
    (AlarmName::TurretChange, MIRR_09),
    (AlarmName::Unspecified, MIRR_03),
    (AlarmName::Unspecified, MIRR_09),
    (AlarmName::Unspecified, MIRR_19),
    (AlarmName::Unspecified, MIRR_20),
    (AlarmName::GCodesConflict, GCODE_04),
    (AlarmName::SidesDiffer, AX4_06),
    (AlarmName::SidesDiffer, AX4_07),
    (AlarmName::Unspecified, AX4_02),
    (AlarmName::Unspecified, AX4_03),
    (AlarmName::Unspecified, AX4_12),
    (AlarmName::Unspecified, PSYNC_09),
    (AlarmName::AddressRange, PSYNC_01),
    (AlarmName::CompensationNotAllowed, M100_04),
    (AlarmName::NoProgramEnd, PROG_02),
    (AlarmName::ProgramNameMisplaced, PROG_02),
    (AlarmName::SequenceNameDuplicate, SEQ_03),
    (AlarmName::NotModelled, ADDR_01),
    (AlarmName::NotModelled, MCODE_09),
    (AlarmName::NotModelled, MCODE_11),
];

/// What the programs of one machine did.
#[derive(Default)]
struct Machine {
    programs: u64,
    events: u64,
    deeds: Deeds,
}

impl Machine {
    fn add(&mut self, case: &Case) {
        let events = trace(case);
        self.programs += 1;
        self.events += events.len() as u64;
        self.deeds.add(&events, deeds(&events));
    }
}

/// What the events of a program show.
fn deeds(events: &[Event]) -> BTreeSet<&'static str> {
    let mut deeds = BTreeSet::new();
    let mut changes = 0;
    let mut started = None;
    let mut waits: BTreeMap<(Side, u32), u32> = BTreeMap::new();
    for event in events {
        let compensated = motion_of(event).is_some_and(|motion| motion.nose.is_some());
        let mirrored = event.turret == Some(Side::B);
        match event.action {
            Action::Mode { group, .. } if group.as_str() == "turret" => changes += 1,
            Action::Spindle(spindle) if spindle.spindle == SpindleName::Main && spindle.speed.0 > 0 => {
                if cites(event, MCODE_05) {
                    started = event.turret;
                } else if started.is_some() && event.turret != started {
                    // E100L-MIRR-07.
                    deeds.insert("speed of a spindle that the other turret started");
                }
            }
            Action::Frame { .. } if cites(event, MIRR_18) => {
                deeds.insert("other data");
            }
            Action::Arc { .. } if mirrored => {
                deeds.insert("arc of turret B");
            }
            Action::Call { .. } if mirrored => {
                deeds.insert("call with turret B");
            }
            Action::Select { .. } if mirrored => {
                deeds.insert("selected program with turret B");
            }
            Action::Wait { .. } => {
                let place = (event.saddle.unwrap_or(Side::A), event.block.line);
                *waits.entry(place).or_default() += 1;
                if waits.get(&place) == Some(&2) {
                    deeds.insert("P and M100 in a block");
                }
            }
            Action::Release { cause, p, .. } => {
                deeds.insert(match (cause, p) {
                    (ReleaseCause::Smaller, _) => "smaller",
                    (ReleaseCause::Equal, _) => "equal",
                    (ReleaseCause::PCode, _) => "p_code",
                    (ReleaseCause::Counterpart, _) => "counterpart",
                    (ReleaseCause::OtherEnded, Some(_)) => "other ended, P",
                    (ReleaseCause::OtherEnded, None) => "other ended, M100",
                });
            }
            Action::SideEnd { code } => {
                deeds.insert(if code.is_empty() {
                    "side ends without code"
                } else {
                    "side ends with a code"
                });
            }
            _ => {}
        }
        if compensated && mirrored {
            deeds.insert("compensation with turret B");
        }
        if compensated && event.saddle.is_some() {
            deeds.insert("compensation of a saddle");
        }
    }
    if changes > 4 {
        deeds.insert("many changes");
    }
    order_of_sides(events, &mut deeds);
    deeds
}

/// What the order of the events shows of the sides.
fn order_of_sides(events: &[Event], deeds: &mut BTreeSet<&'static str>) {
    let mut numbers: [Vec<u16>; 2] = Default::default();
    let mut sides = BTreeSet::new();
    let mut parts: BTreeMap<Side, BTreeSet<u32>> = BTreeMap::new();
    for event in events {
        let Some(side) = event.saddle else { continue };
        sides.insert(side);
        parts.entry(side).or_default().insert(event.block.line);
        if let Action::Wait { p: Some(p), .. } = event.action {
            numbers[side as usize].push(p);
        }
    }
    if numbers.iter().any(|list| !list.is_sorted()) {
        // E100L-PSYNC-08.
        deeds.insert("numbers that do not ascend");
    }
    let ended = |side: Side| {
        events
            .iter()
            .any(|event| event.saddle == Some(side) && matches!(event.action, Action::SideEnd { .. }))
    };
    if !sides.is_empty() && (sides.len() == 1 || !(ended(Side::A) && ended(Side::B))) {
        deeds.insert("one side only");
    }
    // A portion of the other side lies between two blocks of a side (E100L-AX4-04).
    let between = |side: Side| {
        let (Some(own), Some(other)) = (parts.get(&side), parts.get(&side.other())) else { return false };
        let range = (own.first().copied().unwrap_or_default(), own.last().copied().unwrap_or_default());
        other.iter().any(|line| *line > range.0 && *line < range.1)
    };
    if between(Side::A) && between(Side::B) {
        deeds.insert("alternating portions");
    }
}

/// The programs of seeds by their machine.
fn machines(seeds: std::ops::Range<u64>) -> [Machine; 3] {
    let mut machines: [Machine; 3] = Default::default();
    for case in seeds.map(case_from_seed) {
        let machine = match case.setup.machine.r#type {
            MachineType::OneTurret => 0,
            MachineType::TwoTurrets => 1,
            MachineType::TwoSaddles => 2,
        };
        machines[machine].add(&case);
    }
    machines
}

/// Of a hundred programs six are for two turrets and six for two saddles; most of them end, after much.
#[test]
fn programs_for_two_turrets_and_two_saddles_are_many_and_deep() {
    const SOME: u64 = 13_000;
    let [_, turrets, saddles] = machines(0..SOME);
    for (name, machine) in [("1S-2T", &turrets), ("2S", &saddles)] {
        println!(
            "{name}: {} programs, {} ended, {} events",
            machine.programs, machine.deeds.ended, machine.events
        );
        println!("  {:?}", machine.deeds);
        let share = machine.programs * 100;
        assert!((SOME * 5..SOME * 7).contains(&share), "{} programs of {name}", machine.programs);
        assert!(machine.deeds.ended * 100 > machine.programs * 60, "{} of {name} ended", machine.deeds.ended);
        assert!(machine.events > machine.programs * 18, "{} events of {name}", machine.events);
    }
    turrets.deeds.demand(&[
        ("many changes", 20),
        ("other data", 100),
        ("speed of a spindle that the other turret started", 10),
        ("arc of turret B", 60),
        ("compensation with turret B", 20),
        ("call with turret B", 20),
        ("selected program with turret B", 5),
    ]);
    saddles.deeds.demand(&[
        ("smaller", 100),
        ("equal", 100),
        ("p_code", 50),
        ("counterpart", 40),
        ("other ended, P", 100),
        ("other ended, M100", 25),
        ("P and M100 in a block", 20),
        ("numbers that do not ascend", 20),
        ("side ends without code", 100),
        ("side ends with a code", 300),
        ("one side only", 20),
        ("alternating portions", 150),
        ("compensation of a saddle", 100),
    ]);
}

/// Every rule of these families that an event cites, and every alarm of them with the rule that it stands for.
#[test]
fn every_rule_and_alarm_of_turrets_and_saddles_is_reached() {
    OF_ALL.demand(CITED, ALARMS);
}
