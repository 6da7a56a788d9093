//! Generated programs reach contours with the C axis and coordinate conversion: how many, how deep, and every rule and alarm
//! of them.

use std::collections::BTreeSet;

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, ContourPlane, Event, FrameCause, Part, RuleId, Sense, SidePlane,
};

use crate::citations::OF_ALL;
use crate::deeds::Deeds;
use crate::programs::{cites, motion_of, trace};

/// The rules that events cite (execution of contours, section 10).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    CGF_01, CGF_02, CGF_03, CGF_04, CGF_06, CGF_09, CGF_10, CGF_11, CGF_12, CGF_14, CGS_01, CGS_02, CGS_04, CGS_05, CGS_07,
    CSC_01, CSC_02, CSC_03, CSC_04, CSC_05, CSC_06, CSC_07, CSC_09,
];

/// The alarms with the rules that they stand for.
#[rustfmt::skip]
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::AddressUnknown, ADDR_01),
    (AlarmName::ArcRadiusNotPositive, CGF_04),
    (AlarmName::ArcRadiusNotPositive, CGS_04),
    (AlarmName::ArcRadiusTooSmall, CGF_04),
    (AlarmName::ArcRadiusTooSmall, CGS_04),
    (AlarmName::CAxisClamped, CGF_07),
    (AlarmName::CAxisNotJoined, CGF_07),
    (AlarmName::CompensationNotAllowed, NRC_81),
    (AlarmName::ContourArcZ, CGF_05),
    (AlarmName::ContourCommandUnusable, CGS_08),
    (AlarmName::ContourXChanged, CGS_03),
    (AlarmName::ContourXNotPositive, CGF_08),
    (AlarmName::ContourXNotPositive, CGS_01),
    (AlarmName::ConversionAtLimit, CSC_10),
    (AlarmName::ConversionAxisMissing, CSC_06),
    (AlarmName::ConversionIncremental, CSC_07),
    (AlarmName::ConversionIncremental, CSC_08),
    (AlarmName::MotionCodeMissing, CSC_05),
    (AlarmName::NotAlone, CSC_09),
    (AlarmName::NotModelled, CGF_01),
    (AlarmName::NotModelled, CGS_01),
    (AlarmName::ProfileGeneration, CGS_06),
    (AlarmName::Unspecified, CGF_02),
    (AlarmName::Unspecified, CGF_03),
    (AlarmName::Unspecified, CGF_04),
    (AlarmName::Unspecified, CGF_14),
    (AlarmName::Unspecified, CGS_01),
    (AlarmName::Unspecified, CGS_04),
    (AlarmName::Unspecified, CRC_06),
    (AlarmName::Unspecified, CRC_07),
    (AlarmName::Unspecified, CSC_05),
    (AlarmName::Unspecified, CSC_06),
    (AlarmName::Unspecified, CSC_09),
    (AlarmName::WordMissing, CGF_04),
    (AlarmName::WordMissing, CGS_04),
    (AlarmName::WordMissing, CSC_01),
];

/// Details of alarms of contours that have to be met too.
const DETAILS: &[&str] = &[
    "G95",
    "Z",
    "circle",
    "centre",
    "start",
    "barrier",
    "compensation",
    "G00",
    "G01",
    "G02",
    "G33",
    "G50",
    "G71",
    "G75",
    "G101",
    "G132",
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    programs: u64,
    /// Programs with a contour or a conversion, and their events.
    contours: u64,
    events: u64,
    motions: u64,
    deeds: Deeds,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let events = trace(case);
        self.programs += 1;
        // Cutter radius compensation has a test of its own.
        if events.iter().any(|event| cites(event, CRC_05) || cites(event, CRC_14)) {
            return;
        }
        let motions = events.iter().filter(|event| is_contour(event)).count() as u64;
        if motions == 0 && !events.iter().any(|event| cites(event, CSC_01)) {
            return;
        }
        self.contours += 1;
        self.events += events.len() as u64;
        self.motions += motions;
        self.deeds.add(&events, deeds(case, &events));
    }
}

/// Whether it is a motion of a contour.
fn is_contour(event: &Event) -> bool {
    matches!(event.action, Action::ContourArc { .. }) || cites(event, CGF_02)
}

/// What the events of a program show.
fn deeds(case: &Case, events: &[Event]) -> BTreeSet<&'static str> {
    let mut deeds = BTreeSet::new();
    let mut converts = false;
    for event in events {
        converts = match event.action {
            Action::Mode { code, .. } if code.as_str() == "G137" => true,
            Action::Mode { code, .. } if code.as_str() == "G136" => {
                if cites(event, MCODE_04) {
                    deeds.insert("conversion mode to the end");
                }
                false
            }
            _ => converts,
        };
        of_motion(case, event, &mut deeds);
        match event.action {
            Action::Frame { cause: FrameCause::ToolOffset, .. } if converts => {
                deeds.insert("tool offset in conversion mode");
            }
            Action::Frame { cause: FrameCause::ZeroShift, .. } if converts => {
                deeds.insert("zero shift in conversion mode");
            }
            _ => {}
        }
    }
    deeds
}

/// What a motion of a contour or of conversion mode shows.
fn of_motion(case: &Case, event: &Event, deeds: &mut BTreeSet<&'static str>) {
    let parameters = &case.setup.parameters;
    let Some(motion) = motion_of(event) else { return };
    let travel = motion.c_travel.map(|travel| travel.0).unwrap_or_default();
    match event.action {
        Action::ContourArc { plane: ContourPlane::FaceCentre(_), sense, .. } => {
            let conversion = cites(event, CGF_14);
            deeds.insert(if conversion { "face arc by X and Y" } else { "face arc by X and C" });
            let with_sense = (travel > 0) == (sense == Sense::CounterClockwise);
            match travel.abs() {
                0 => deeds.insert("face arc on a ray"),
                180_000_000 => deeds.insert("face arc of half a turn"),
                180_000_001.. => deeds.insert("face arc round the centre"),
                _ if with_sense => deeds.insert("face arc with its chord"),
                _ => deeds.insert("face arc against its chord"),
            };
        }
        Action::ContourArc { plane: ContourPlane::SideArc(_), .. } => {
            deeds.insert(match parameters.side_plane {
                SidePlane::Outer => "outer side",
                SidePlane::Inner => "inner side",
            });
            deeds.insert(if travel < 0 { "side arc backward" } else { "side arc" });
            if parameters.side_contour_mode {
                deeds.insert("side arc in G119");
            }
        }
        Action::Linear { .. } if cites(event, CGF_02) => {
            let conversion = cites(event, CGF_14);
            deeds.insert(if conversion { "line by X and Y" } else { "line by X and C" });
            if cites(event, CGF_03) {
                deeds.insert("line with Z");
            }
            if motion.part == Some(Part::Turn) && parameters.centre_override != 100 {
                deeds.insert("override at the centre");
            }
        }
        _ if cites(event, CSC_02) => {
            deeds.insert("positioning by X and Y");
            if cites(event, LIM_01) {
                deeds.insert("point beyond the limit");
            }
            if cites(event, CSC_04) {
                deeds.insert(match parameters.conversion_zero_shift {
                    turnspec_oracle::vocabulary::ConversionZeroShift::Included => "zero shift included",
                    turnspec_oracle::vocabulary::ConversionZeroShift::Excluded => "zero shift excluded",
                });
            }
        }
        _ => return,
    }
    if motion.speed.is_some() {
        deeds.insert("constant cutting speed");
    }
    if case.setup.unit_system.is_inch() {
        deeds.insert("inches");
    }
    if cites(event, CSC_07) {
        deeds.insert("point in G91");
    }
}

/// Of a hundred programs six have contours; most of them end, after much.
#[test]
fn programs_with_contours_are_many_and_deep() {
    const SOME: u64 = 10_000;
    let mut reached = Reached::default();
    (0..SOME).map(case_from_seed).for_each(|case| reached.add(&case));
    let Reached { programs, contours, events, motions, deeds } = reached;
    let ended = deeds.ended;
    println!(
        "{programs} programs, {contours} with contours, {ended} of them ended, {events} events, {motions} motions"
    );
    println!("{deeds:?}");
    assert!((SOME * 4..SOME * 9).contains(&(contours * 100)), "{contours} programs");
    assert!(ended * 100 > contours * 60, "{ended} ended");
    assert!(events > contours * 25 && motions > contours * 5, "{events} events, {motions} motions");
    deeds.demand(&[
        ("face arc by X and C", 100),
        ("face arc by X and Y", 60),
        ("face arc on a ray", 10),
        ("face arc of half a turn", 30),
        ("face arc round the centre", 30),
        ("face arc with its chord", 100),
        ("face arc against its chord", 60),
        ("line by X and C", 120),
        ("line by X and Y", 80),
        ("line with Z", 60),
        ("override at the centre", 40),
        ("side arc", 80),
        ("side arc backward", 40),
        ("side arc in G119", 50),
        ("inner side", 50),
        ("outer side", 50),
        ("positioning by X and Y", 120),
        ("point beyond the limit", 3),
        ("point in G91", 30),
        ("zero shift included", 10),
        ("zero shift excluded", 10),
        ("tool offset in conversion mode", 5),
        ("zero shift in conversion mode", 5),
        ("conversion mode to the end", 10),
        ("constant cutting speed", 20),
        ("inches", 50),
    ]);
}

/// Every rule of these families that an event cites, and every alarm of them with the rule that it stands for.
#[test]
fn every_rule_and_alarm_of_contours_is_reached() {
    OF_ALL.demand(CITED, ALARMS);
    OF_ALL.demand_details_of(&["E100L-CGF", "E100L-CGS", "E100L-CSC", "E100L-CRC"], DETAILS);
}
