//! Generated programs reach cutter radius compensation in G17 and G119: how many, how deep, and every rule and alarm of it.

use std::collections::BTreeSet;

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, ContourPlane, Event, Motion, Part, RuleId, SidePlane};

use crate::citations::{Citations, PROGRAMS};
use crate::deeds::Deeds;
use crate::programs::{cites, is_in, motion_of, trace};

/// The rules that events of this compensation cite (execution of contours, section 10, and what it takes over).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    CRC_05, CRC_06, CRC_07, CRC_08, CRC_10, CRC_12, CRC_14, CRC_15, CRC_16, CRC_18, NRC_07, NRC_11, NRC_14, NRC_15, NRC_18,
    NRC_26, NRC_30, NRC_41, NRC_42, NRC_43, NRC_44, NRC_48, NRC_49, NRC_51, NRC_52, NRC_60, NRC_66, CGF_02, CGF_03, CGF_04, CGF_09,
    CGF_10, CGF_11, CGF_12, CGF_14, CGS_01, CGS_04, CSC_02,
];

/// Rules of cutter radius compensation that no event of it has to cite: planes, the entry, what is told of G18.
const OTHERS: &[RuleId] = &[CRC_01, CRC_02, CRC_03, CRC_04, CRC_13];

/// The alarms with the rules that they stand for.
#[rustfmt::skip]
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::CAxisClamped, CAX_07),
    (AlarmName::CompensationArcTooSmall, NRC_48),
    (AlarmName::CompensationNoIntersection, NRC_53),
    (AlarmName::CompensationNotAllowed, NRC_81),
    (AlarmName::ContourXChanged, CRC_18),
    (AlarmName::ContourXNotPositive, CGF_08),
    (AlarmName::ContourXNotPositive, CGS_01),
    (AlarmName::CoordinateRange, ADDR_01),
    (AlarmName::NotModelled, CRC_14),
    (AlarmName::PlaneChangeInCompensation, CRC_13),
    (AlarmName::ProfileGeneration, CGS_06),
    (AlarmName::TravelLimitNegative, NRC_80),
    (AlarmName::TravelLimitPositive, NRC_80),
    (AlarmName::Unspecified, CGF_03),
    (AlarmName::Unspecified, CGF_04),
    (AlarmName::Unspecified, CRC_06),
    (AlarmName::Unspecified, CRC_07),
    (AlarmName::Unspecified, CRC_12),
    (AlarmName::Unspecified, CRC_14),
    (AlarmName::Unspecified, CSC_09),
    (AlarmName::Unspecified, LAP_16),
    (AlarmName::Unspecified, NRC_15),
    (AlarmName::Unspecified, NRC_81),
    (AlarmName::WordWithoutFunction, ADDR_01),
];

/// Details of its alarms that have to be met too.
#[rustfmt::skip]
const DETAILS: &[&str] = &[
    "side", "start_up", "cancel", "frame", "barrier", "repetition", "M109", "waiting", "centre", "A", "QA", "G75", "G76", "G02",
    "G03", "G101", "G132", "G133",
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    programs: u64,
    /// Programs with a motion in this compensation, and their events and motions of it.
    compensated: u64,
    events: u64,
    motions: u64,
    deeds: Deeds,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let events = trace(case);
        self.programs += 1;
        let motions = events.iter().filter(|event| is_of_cutter(event)).count() as u64;
        if motions == 0 {
            return;
        }
        self.compensated += 1;
        self.events += events.len() as u64;
        self.motions += motions;
        self.deeds.add(&events, deeds(case, &events));
    }
}

/// Whether it is a motion in this compensation.
fn is_of_cutter(event: &Event) -> bool {
    motion_of(event).is_some() && cites(event, CRC_05)
}

/// What the events of a program show.
fn deeds(case: &Case, events: &[Event]) -> BTreeSet<&'static str> {
    let mut deeds = BTreeSet::new();
    for event in events.iter().filter(|event| is_of_cutter(event)) {
        let Some(motion) = motion_of(event) else { continue };
        of_motion(case, event, motion, &mut deeds);
        for (rule, deed) in [
            (NRC_11, "corner of two radii"),
            (NRC_26, "corner of two lines"),
            (NRC_30, "straight on"),
            (NRC_43, "one block between"),
            (NRC_44, "contact at the end of the program"),
            (NRC_49, "tangent"),
            (NRC_51, "corner of a line and an arc"),
            (NRC_52, "corner of two arcs"),
            (NRC_66, "contact before the cancel"),
            (CGF_09, "centre along a ray"),
            (CGF_11, "centre through the centre"),
            (CRC_15, "the other arc"),
            (CRC_16, "C in G00 and G01"),
        ] {
            if cites(event, rule) {
                deeds.insert(deed);
            }
        }
    }
    deeds
}

/// What a motion of this compensation shows.
fn of_motion(case: &Case, event: &Event, motion: Motion, deeds: &mut BTreeSet<&'static str>) {
    let travel = motion.c_travel.map(|travel| travel.0).unwrap_or_default();
    if cites(event, CRC_06) {
        deeds.insert(if cites(event, CSC_02) { "face by X and Y" } else { "face by X and C" });
        deeds.insert(match event.action {
            Action::Rapid { .. } => "G00 on the face",
            Action::Linear { .. } if cites(event, CGF_02) => "G101",
            Action::Linear { .. } => "G01 on the face",
            _ if travel.abs() > 180_000_000 => "arc round the centre",
            _ => "G102 and G103",
        });
        if motion.part == Some(Part::Turn) {
            deeds.insert("turn at the centre");
        }
    } else if cites(event, CRC_07) {
        deeds.insert(match case.setup.parameters.side_plane {
            SidePlane::Outer => "outer side",
            SidePlane::Inner => "inner side",
        });
        deeds.insert(match event.action {
            Action::Rapid { .. } => "G00 on the side",
            Action::ContourArc { plane: ContourPlane::SideArc(_), .. } => "G132 and G133",
            _ => "G01 on the side",
        });
        if travel < 0 {
            deeds.insert("C backward on the side");
        }
    }
    if travel.abs() > 300_000_000 && cites(event, CRC_16) {
        deeds.insert("C almost once round");
    }
    if motion.speed.is_some() {
        deeds.insert("constant cutting speed");
    }
    if case.setup.unit_system.is_inch() {
        deeds.insert("inches");
    }
    if cites(event, ABS_02) {
        deeds.insert("G91");
    }
}

/// Of a hundred programs about six have this compensation; most of them end, after much.
#[test]
fn programs_with_cutters_are_many_and_deep() {
    const SOME: u64 = 10_000;
    let mut reached = Reached::default();
    (0..SOME).map(case_from_seed).for_each(|case| reached.add(&case));
    let Reached { programs, compensated, events, motions, deeds } = reached;
    let ended = deeds.ended;
    println!(
        "{programs} programs, {compensated} compensated, {ended} of them ended, {events} events, {motions} motions"
    );
    println!("{deeds:?}");
    assert!((SOME * 4..SOME * 9).contains(&(compensated * 100)), "{compensated} programs");
    assert!(ended * 100 > compensated * 55, "{ended} ended");
    assert!(events > compensated * 25 && motions > compensated * 4, "{events} events, {motions} motions");
    deeds.demand(&[
        ("face by X and C", 150),
        ("face by X and Y", 120),
        ("G00 on the face", 80),
        ("G01 on the face", 60),
        ("G101", 150),
        ("G102 and G103", 100),
        ("arc round the centre", 3),
        ("turn at the centre", 5),
        ("centre along a ray", 3),
        ("centre through the centre", 3),
        ("outer side", 50),
        ("inner side", 50),
        ("G00 on the side", 60),
        ("G01 on the side", 80),
        ("G132 and G133", 60),
        ("C backward on the side", 40),
        ("C almost once round", 10),
        ("C in G00 and G01", 60),
        ("the other arc", 1),
        ("corner of two radii", 3),
        ("corner of two lines", 150),
        ("corner of a line and an arc", 100),
        ("corner of two arcs", 40),
        ("straight on", 20),
        ("tangent", 10),
        ("one block between", 40),
        ("contact at the end of the program", 15),
        ("contact before the cancel", 150),
        ("constant cutting speed", 3),
        ("inches", 30),
        ("G91", 60),
    ]);
}

/// The codes of the plane and of compensation that events have brought into force.
struct Codes {
    plane: String,
    compensation: String,
}

impl Codes {
    fn new() -> Self {
        Self { plane: "G18".to_owned(), compensation: "G40".to_owned() }
    }

    fn note(&mut self, event: &Event) {
        let Action::Mode { code, .. } = event.action else { return };
        match code.as_str() {
            "G17" | "G18" | "G119" => code.as_str().clone_into(&mut self.plane),
            "G40" | "G41" | "G42" => code.as_str().clone_into(&mut self.compensation),
            _ => {}
        }
    }

    /// Whether a plane of rotary tools is in force.
    fn is_rotary(&self) -> bool {
        self.plane != "G18"
    }
}

/// Every rule of this compensation that an event cites, and every alarm of it with the rule that it stands for; those of the areas
/// that know other planes count only while G17 or G119 is in force.
#[test]
fn every_rule_and_alarm_of_cutters_is_reached() {
    const OWN: &[&str] = &["E100L-CRC"];
    let mut citations = Citations::default();
    for case in (0..PROGRAMS).map(case_from_seed) {
        let mut codes = Codes::new();
        for event in trace(&case) {
            codes.note(&event);
            let own = event.rules.as_slice().iter().any(|rule| is_in(*rule, OWN));
            let alarm = matches!(event.action, Action::Alarm(_));
            if own || is_of_cutter(&event) || alarm && codes.is_rotary() {
                citations.event(&event);
            }
        }
    }
    citations.demand(CITED, ALARMS);
    citations.demand_details_of(OWN, DETAILS);
    let of_it = citations.rules.iter().filter(|rule| is_in(**rule, OWN));
    let other: Vec<_> = of_it.filter(|rule| !CITED.contains(rule) && !OTHERS.contains(rule)).collect();
    assert!(other.is_empty(), "rules that are not in the list: {other:?}");
}

/// Without faults in them nothing but compensation stops the programs: most of them end.
#[test]
fn programs_with_cutters_end_where_there_is_no_fault() {
    use turnspec_generator::{Profile, case_from_seed_within};
    use turnspec_oracle::vocabulary::Feature;
    let features: Vec<Feature> = Feature::ALL
        .iter()
        .copied()
        .filter(|feature| !matches!(feature, Feature::Alarm | Feature::TapeCode))
        .collect();
    let profile = Profile::of(&features);
    let mut reached = Reached::default();
    (0..4_000).map(|seed| case_from_seed_within(seed, &profile)).for_each(|case| reached.add(&case));
    let Reached { compensated, deeds, .. } = reached;
    println!("{compensated} compensated, {deeds:?}");
    assert!(compensated > 160 && deeds.ended * 100 > compensated * 80, "{} of {compensated}", deeds.ended);
}
