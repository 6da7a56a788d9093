//! One increment more in one coordinate changes the shape of nothing and moves little.

use turnspec_generator::Nudged;
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Event, Part, PlanePosition, RuleId, RuleSet, Setup, Side,
};

use crate::differential::show;
use crate::shape::{is_of_cycle, is_of_lap, motion, trace};
use crate::{Verdict, require};

/// Alarms that a coordinate decides by a threshold.
const THRESHOLDS: &[AlarmName] = &[
    AlarmName::AddressRange,
    AlarmName::CoordinateRange,
    AlarmName::TravelLimitNegative,
    AlarmName::TravelLimitPositive,
    AlarmName::Barrier,
    AlarmName::ArcRadiusMismatch,
    AlarmName::ArcRadiusTooSmall,
    AlarmName::ArcNoEndPoint,
    AlarmName::ChamferAxes,
    AlarmName::ChamferTooShort,
    AlarmName::TorqueReachedEarly,
    AlarmName::TorqueNotReached,
    AlarmName::CompensationArcTooSmall,
    AlarmName::CompensationNoIntersection,
    // E100L-NRC-21, an element that becomes a repetition.
    AlarmName::CompensationStartUp,
    // E100L-CGF-08, E100L-CGS-03, E100L-CSC-10.
    AlarmName::ContourXNotPositive,
    AlarmName::ContourXChanged,
    AlarmName::ConversionAtLimit,
    AlarmName::ThreadLeadRange,
    // E100L-CIRC-07, a circle that closes on its start; E100L-TRQ-04, an approach without room.
    AlarmName::Unspecified,
];

/// Rules that an event cites on one side of a threshold only: a motion that ends at a limit, a speed at a
/// bound.
const BOUNDS: &[RuleId] = &[LIM_01, CSS_04, SMAX_01];

/// Rules of corners whose elements may have no length: none is emitted then.
const CORNERS: &[RuleId] = &[ANG_03, ANG_04, CHAM_03, CHAM_11];

/// Rules of lines on the face whose motions are others where an end is the centre, or a ray leads through both ends.
const ROWS: &[RuleId] = &[CGF_09, CGF_10, CGF_11];

/// Rules of end points that are computed by division: from an angle, from a circle, at a corner of any angle; or from a point
/// in conversion mode.
/// Close to parallel lines and tangents they move by more than their data.
const COMPUTED: &[RuleId] = &[DTAP_03, ANG_01, ANG_03, ANG_04, ANG_05, ANG_06, CIRC_08, CSC_03];

/// Rules of a pass whose levels are computed from an angle; the passes behind it begin where it did.
const TAPERED: &[RuleId] = &[G33_06];

/// Rules of ends of compensated motions that move little: the corner of two lines, contact.
const STEADY: &[RuleId] = &[NRC_15, NRC_26, NRC_30, NRC_44, NRC_45, NRC_66, NRC_71];

/// Two programs of the generator differ by one increment (0.001 mm, 0.0001 inch) in one X, Z or W word that
/// is a plain number. No expression of them reads a position or the zero shift, so that a coordinate can act
/// in no other way than as a coordinate. Then:
///
/// 1. **Shape.** Both have the same events (kinds, codes, names, senses, lines, readings, and rules but for
///    those of bounds: LIM-01, CSS-04, SMAX-01), up to the first threshold that one of them crosses. A
///    threshold shows as an alarm of `THRESHOLDS` in one of them (or as another alarm that both have at the
///    same line), as an element of a corner that has no length in one of them, as a chamfer of a thread that reaches the level of
///    the cycle start in one of them only, as a line on the face that meets the centre or lies on one ray with it in one of them,
///    as another number of pecks, passes or grooves in a block of a cycle (the property `cycles` says where that changes), as
///    a call of LAP, of which the property `lap` tells, as the
///    beginning of cutter radius compensation, or as a zero shift that is zero in one of them at the reset.
/// 2. **Distance.** Up to that place, and up to the first end point that is computed from an angle, from a
///    circle and one coordinate, at a corner of any angle, or from a point in conversion mode, every machine coordinate of the axis of that
///    word moves by at least nothing and at most the increment, in the same direction throughout; the other
///    axes do not move at all. (1000 nm; from inches at most 3000 nm, since words are rounded to 0.001 mm.)
///    The beginning and the end of a chamfer of a thread are computed from the whole pass, and the levels of a thread at
///    an angle from its length; these motions are passed over.
///    Nothing is multiplied on the way: an absolute word replaces the difference, an incremental one carries
///    it on, G50 keeps it, a limit or a torque stop cuts it off.
///    In compensation this is said of the programmed point: the machine coordinate less the way from it to
///    the tip, which is mirrored in X for turret B. On two saddles it is said of each saddle. A displacement left over (E100L-NRC-71) is passed over.
/// 3. **Radius.** The centre of an arc by radius stays as far from its end, to within the 3 nm of latching.
///
/// 4. **Tip.** In compensation an end by another rule, a motion that repeats its point, and an extra motion are
///    thresholds of their own. Where both lines end by the same rule, at the corner of two lines or in contact,
///    and the nose centre is at most twice its radius away, the way from the programmed point to the tip turns
///    with the directions: by at most 16 times radius × increment / length of the shorter line, and 4 nm.
///
/// Rules: E100L-NRC-07, E100L-NRC-13, E100L-NRC-26, E100L-NRC-44, E100L-ABS-01, E100L-ABS-02, E100L-COORD-03, E100L-G50-02, E100L-LIM-01, E100L-LIM-02,
/// E100L-CIRC-11, E100L-CIRC-16, E100L-CIRC-17, E100L-CHAM-07, E100L-TRQ-04, E100L-TRQ-05, E100L-TRQ-06,
/// E100L-INCH-02
pub(crate) fn a_small_change_moves_little(input: &[u8]) -> Verdict {
    let Some(pair) = Nudged::from_bytes(input) else { return Ok(()) };
    if reads_positions(&pair.before.program) { Ok(()) } else { moves_little(&pair) }
}

fn moves_little(pair: &Nudged) -> Verdict {
    // What a call of LAP makes of a coordinate the property `lap` says; behind a cutter each axis moves with all others.
    let so_far = |case| -> Vec<Event> {
        let mut events = trace(case);
        events.truncate(cutter_begins(&events));
        events.into_iter().take_while(|event| !is_of_lap(event)).collect()
    };
    let (before, after) = (so_far(&pair.before), so_far(&pair.after));
    let same = same_shape(&before, &after);
    let fail = |message: String| format!("{message}\n{}\n{}", show(&pair.before), show(&pair.after));
    let count = same.map_err(fail)?;
    for saddle in [None, Some(Side::A), Some(Side::B)] {
        let own = |trace: &[Event]| -> Vec<Event> {
            trace.iter().take(count).filter(|event| event.saddle == saddle).copied().collect()
        };
        let (before, after) = (own(&before), own(&after));
        let moved = distance(&before, &after, pair).and_then(|()| radii(&before, &after));
        moved.and_then(|()| tips(&before, &after, increment(&pair.before.setup))).map_err(fail)?;
    }
    Ok(())
}

/// How many events come before compensation begins in G17 or G119, whose code may stand before that of the plane.
fn cutter_begins(events: &[Event]) -> usize {
    let plane = |event: &Event| match event.action {
        Action::Mode { code, .. } => match code.as_str() {
            "G18" => Some(false),
            "G17" | "G119" => Some(true),
            _ => None,
        },
        _ => None,
    };
    let mut rotary = false;
    for (index, event) in events.iter().enumerate() {
        rotary = plane(event).unwrap_or(rotary);
        let begins =
            matches!(event.action, Action::Mode { code, .. } if matches!(code.as_str(), "G41" | "G42"));
        let same_block = |next: &&Event| next.block == event.block;
        if begins && events.iter().skip(index).take_while(same_block).find_map(plane).unwrap_or(rotary) {
            return index;
        }
    }
    events.len()
}

/// Whether an expression reads the present position, or the zero shift that depends on it.
fn reads_positions(program: &[u8]) -> bool {
    ["VSIO", "VAPA", "VZSH"].iter().any(|name| program.windows(4).any(|text| text == name.as_bytes()))
}

/// How many events there are before the block in which a threshold is crossed; all of them when there is
/// none.
fn same_shape(before: &[Event], after: &[Event]) -> Result<usize, String> {
    for (index, (one, other)) in before.iter().zip(after).enumerate() {
        if shape(one) == shape(other) {
            continue;
        }
        let events = [one, other];
        let known = |event: &Event| match event.action {
            Action::Alarm(alarm) => THRESHOLDS.contains(&alarm.name),
            Action::Frame { .. } => event.rules.as_slice().contains(&G50_05),
            _ => false,
        };
        let corner = events.iter().any(|event| cites(event, CORNERS));
        let compensated = events.iter().any(|event| cites(event, &[NRC_46])) || corners_differ(one, other);
        let row = events.iter().any(|event| cites(event, ROWS));
        let exits = exits_differ(one, other);
        let cycle = events.iter().any(|event| is_of_cycle(event));
        let threshold =
            corner || row || compensated || exits || cycle || events.iter().any(|event| known(event));
        require(threshold, || format!("{one:?}\n{other:?}"))?;
        let line = one.block.line.min(other.block.line);
        return Ok(before.iter().take(index).take_while(|event| event.block.line < line).count());
    }
    require(before.len() == after.len(), || format!("{} and {} events", before.len(), after.len()))?;
    Ok(before.len())
}

/// Whether a chamfer of a thread reaches the level of the cycle start in one of two passes only, or takes all of the cut.
fn exits_differ(one: &Event, other: &Event) -> bool {
    let cut = |event: &Event| matches!(motion(event).and_then(|motion| motion.part), Some(part) if part != Part::Approach);
    one.block.line == other.block.line && cut(one) && cut(other) && (is_exit(one) || is_exit(other))
}

/// What an event is, its amounts aside.
fn shape(event: &Event) -> String {
    let rules: RuleSet = event.rules.as_slice().iter().copied().filter(is_of_shape).collect();
    let readings: Vec<&str> = match cites(event, &[SMAX_01]) {
        true => Vec::new(),
        false => event.readings.iter().map(|reading| reading.as_str()).collect(),
    };
    let what = match event.action {
        Action::Rapid { motion } => format!("rapid {:?} {:?}", motion.pass, motion.part),
        Action::Linear { motion, feed, .. } => format!("linear {feed:?} {:?} {:?}", motion.pass, motion.part),
        // The lead is that of the place where the motion begins.
        Action::Thread { motion, axis, change, start, lead, .. } => {
            let lead = if motion.part == Some(Part::Exit) { None } else { Some(lead) };
            format!("thread {:?} {:?} {axis:?} {change:?} {start:?} {lead:?}", motion.pass, motion.part)
        }
        Action::Arc { feed, sense, .. } => format!("arc {feed:?} {sense:?}"),
        Action::ContourArc { feed, sense, .. } => format!("contour_arc {feed:?} {sense:?}"),
        Action::Frame { cause, .. } => format!("frame {cause:?}"),
        Action::Spindle(spindle) => {
            format!("{:?} {:?} {} {}", spindle.spindle, spindle.state, spindle.gear, spindle.with_motion)
        }
        other => format!("{other:?}"),
    };
    format!("{} {} {rules:?} {readings:?} {what}", event.n, event.block.line)
}

/// Whether a rule belongs to the shape: those of bounds and of ends of compensated motions do not.
fn is_of_shape(rule: &RuleId) -> bool {
    !BOUNDS.contains(rule) && !is_of_compensation(rule)
}

fn is_of_compensation(rule: &RuleId) -> bool {
    rule.as_str().split('-').nth(1) == Some("NRC")
}

/// Whether two compensated motions end by different rules.
fn corners_differ(one: &Event, other: &Event) -> bool {
    let of_it = |event: &Event| -> RuleSet {
        event.rules.as_slice().iter().copied().filter(is_of_compensation).collect()
    };
    let compensated = |event| motion(event).is_some_and(|motion| motion.tip.is_some());
    compensated(one) && compensated(other) && of_it(one) != of_it(other)
}

fn ends_compensation(event: &Event) -> bool {
    event.rules.as_slice().contains(&NRC_01)
        && matches!(event.action, Action::Mode { code, .. } if code.as_str() == "G40")
}

/// X and Z of the programmed point in machine coordinates; with turret B they are mirrored in X.
fn programmed(event: &Event) -> Option<(i64, i64)> {
    let motion = motion(event)?;
    let tip = motion.tip.unwrap_or(PlanePosition { x: motion.program.x, z: motion.program.z });
    let (x, z) = (tip.x.0 - motion.program.x.0, tip.z.0 - motion.program.z.0);
    let sign = if event.turret == Some(Side::B) { -1 } else { 1 };
    Some((motion.machine.x.0 - sign * x, motion.machine.z.0 - z))
}

fn cites(event: &Event, rules: &[RuleId]) -> bool {
    event.rules.as_slice().iter().any(|rule| rules.contains(rule))
}

/// Statement 2.
fn distance(before: &[Event], after: &[Event], pair: &Nudged) -> Verdict {
    let most = increment(&pair.before.setup);
    let (mut forward, mut backward) = (false, false);
    let mut left_over = false;
    for (place, (one, other)) in before.iter().zip(after).enumerate() {
        if cites(one, COMPUTED) {
            break;
        }
        let behind = before.get(place + 1).is_some_and(is_exit);
        if behind || is_exit(one) || cites(one, TAPERED) {
            continue;
        }
        left_over |= ends_compensation(one);
        let (Some(from), Some(to)) = (motion(one), motion(other)) else { continue };
        left_over &= from.tip.is_none() && !cites(one, &[NRC_66, NRC_71]);
        let w = |position: turnspec_oracle::vocabulary::Position| position.w.unwrap_or_default().0;
        let (Some(here), Some(there)) = (programmed(one), programmed(other)) else { continue };
        let moves = [
            ("X", if left_over { 0 } else { there.0 - here.0 }),
            ("Z", if left_over { 0 } else { there.1 - here.1 }),
            ("W", w(to.machine) - w(from.machine)),
        ];
        for (axis, by) in moves {
            let bound = if axis == pair.axis { most } else { 0 };
            require(by.abs() <= bound, || format!("{axis} moves by {by} nm:\n{one:?}\n{other:?}"))?;
            forward |= by > 0;
            backward |= by < 0;
        }
        require(!(forward && backward), || format!("moves to and fro:\n{one:?}\n{other:?}"))?;
    }
    Ok(())
}

/// Whether it is the chamfer of a thread; it and the cut before it end where the whole pass says.
fn is_exit(event: &Event) -> bool {
    motion(event).and_then(|motion| motion.part) == Some(Part::Exit)
}

/// One increment in nanometres, as a word of the unit system is rounded.
fn increment(setup: &Setup) -> i64 {
    if setup.unit_system.is_inch() { 3_000 } else { 1_000 }
}

/// Statement 3.
fn radii(before: &[Event], after: &[Event]) -> Verdict {
    for (one, other) in before.iter().zip(after).filter(|(one, _)| cites(one, &[CIRC_17, CIRC_18])) {
        let (Some(from), Some(to)) = (radius(one), radius(other)) else { continue };
        require((from - to).abs() <= 3.0, || format!("the radius changes:\n{one:?}\n{other:?}"))?;
    }
    Ok(())
}

/// Statement 4.
fn tips(before: &[Event], after: &[Event], increment: i64) -> Verdict {
    let ends: Vec<_> = before.iter().zip(after).filter(|(one, _)| motion(one).is_some()).collect();
    for around in ends.windows(3) {
        let [(first, _), (one, other), (next, _)] = around else { continue };
        if cites(first, COMPUTED) || cites(one, COMPUTED) || cites(next, COMPUTED) {
            break;
        }
        let lines = [first, one, next].iter().all(|event| !matches!(event.action, Action::Arc { .. }));
        if !lines || !cites(one, STEADY) || corners_differ(one, other) || shape(one) != shape(other) {
            continue;
        }
        let (Some(from), Some(to)) = (displaced(one), displaced(other)) else { continue };
        let (Some(before), Some(behind)) = (length(first, one), length(one, next)) else { continue };
        let shorter = before.min(behind);
        if shorter == 0.0 || from.away > 2.0 * from.radius {
            continue;
        }
        let most = 16.0 * from.radius * increment as f64 / shorter + 4.0;
        let moves = (to.x - from.x).hypot(to.z - from.z);
        require(moves <= most, || format!("the tip moves by {moves} nm, not {most}:\n{one:?}\n{other:?}"))?;
    }
    Ok(())
}

/// Where a compensated motion ends, from the programmed point, X as a radius.
struct Displaced {
    x: f64,
    z: f64,
    /// How far the nose centre is away.
    away: f64,
    /// The nose radius.
    radius: f64,
}

fn displaced(event: &Event) -> Option<Displaced> {
    let motion = motion(event)?;
    let (tip, nose) = (motion.tip?, motion.nose?);
    let from = |point: PlanePosition, x: i64, z: i64| ((point.x.0 - x) as f64 / 2.0, (point.z.0 - z) as f64);
    let (x, z) = from(tip, motion.program.x.0, motion.program.z.0);
    let (nose_x, nose_z) = from(nose, motion.program.x.0, motion.program.z.0);
    let (v_x, v_z) = from(nose, tip.x.0, tip.z.0);
    Some(Displaced { x, z, away: nose_x.hypot(nose_z), radius: v_x.abs().max(v_z.abs()) })
}

/// The length of a line between two programmed points, X as a radius.
fn length(from: &Event, to: &Event) -> Option<f64> {
    let ((from_x, from_z), (to_x, to_z)) = (programmed(from)?, programmed(to)?);
    Some(((to_x - from_x) as f64 / 2.0).hypot((to_z - from_z) as f64))
}

/// The distance of an arc's end from its centre, in nanometres.
fn radius(event: &Event) -> Option<f64> {
    let Action::Arc { motion, centre_x, centre_z, .. } = event.action else { return None };
    let x = (motion.program.x.0 - centre_x.0) as f64 / 2.0;
    let z = (motion.program.z.0 - centre_z.0) as f64;
    Some(x.hypot(z))
}

#[cfg(test)]
mod tests {
    use super::moves_little;
    use turnspec_generator::{Case, Nudged};
    use turnspec_oracle::vocabulary::{Length, NoseRadius, Setup};

    use crate::bytes_of_seed;
    use crate::shape::{is_alarm, trace};

    fn verdict(before: &str, after: &str) -> Result<(), String> {
        let case =
            |text: &str| Case { setup: Setup::default(), program: format!("{text}\nM02\n").into_bytes() };
        moves_little(&Nudged { before: case(before), after: case(after), axis: "X" })
    }

    #[test]
    fn a_small_change_is_one_increment() {
        assert_eq!(verdict("G00 X1\nG91 X1", "G00 X1.001\nG91 X1"), Ok(()));
        assert!(verdict("G00 X1", "G00 X1.002").is_err_and(|message| message.contains("moves by")));
        assert!(verdict("G00 X1 Z1", "G00 X1 Z1.001").is_err_and(|message| message.contains("moves by")));
        assert!(
            verdict("G00 X1\nX2", "G00 X1.001\nX1.999").is_err_and(|message| message.contains("to and fro"))
        );
        assert!(
            verdict("G03 F1 X20 Z0 L20", "G03 F1 X20 Z0 L20.001").is_err_and(|text| text.contains("radius"))
        );
    }

    #[test]
    fn another_shape_is_noticed_and_a_threshold_is_none() {
        assert!(verdict("G00 X1", "G01 X1 F1").is_err());
        assert!(verdict("G00 X1", "G00 X1\nM08").is_err());
        assert!(verdict("G00 X1\nM08", "G00 X1\nM21").is_err());
        assert_eq!(verdict("G00 X99999.998\nG91 X0.001", "G00 X99999.999\nG91 X0.001"), Ok(()));
        assert_eq!(verdict("G02 F1 X20 Z0 L5", "G02 F1 X20.001 Z0 L5"), Ok(()));
    }

    #[test]
    fn another_number_of_passes_is_noticed() {
        let pass = |x: &str| format!("G00 X50 Z50\nG33 X{x} Z20 F2 M23 M03 S500\nX39");
        assert_eq!(verdict(&pass("40"), &pass("40.001")), Ok(()));
        assert!(verdict(&pass("40"), &pass("40.002")).is_err_and(|message| message.contains("moves by")));
        let cycle = |depth: &str| format!("G00 X50 Z50\nG71 X40 Z20 D{depth} H3 F2 M74");
        assert!(verdict(&cycle("1"), &cycle("0.999")).is_err());
    }

    /// A contour with G42 and a nose of this radius in nanometres, its last line to an X.
    fn compensated(radius: i64, x: &str) -> Case {
        let nose = NoseRadius { number: 1, x: Length(radius), z: Length(radius) };
        let setup = Setup { nose_radius: vec![nose], ..Setup::default() };
        let program = format!("G42 G01 X100 Z100 F0.2 T010101\nZ60\nX{x} Z20\nZ0\nG40 G00 X300 Z300\nM02\n");
        Case { setup, program: program.into_bytes() }
    }

    #[test]
    fn a_tip_that_goes_elsewhere_is_noticed() {
        let pair = |radius, x| Nudged {
            before: compensated(800_000, "130"),
            after: compensated(radius, x),
            axis: "X",
        };
        assert_eq!(moves_little(&pair(800_000, "130.001")), Ok(()));
        assert!(moves_little(&pair(810_000, "130")).is_err_and(|message| message.contains("the tip moves")));
        // A point on the line: straight on before, a corner after.
        assert_eq!(
            moves_little(&Nudged {
                before: compensated(800_000, "100"),
                after: compensated(800_000, "100.001"),
                axis: "X",
            }),
            Ok(())
        );
    }

    #[test]
    fn most_pairs_run_to_their_end() {
        let pairs = (0..200).filter_map(|seed| Nudged::from_bytes(&bytes_of_seed(seed, 4_096)));
        let ended: Vec<bool> = pairs.map(|pair| !trace(&pair.before).iter().any(is_alarm)).collect();
        let count = ended.iter().filter(|ended| **ended).count();
        assert!(ended.len() > 100 && count * 2 > ended.len(), "{count} of {}", ended.len());
    }
}
