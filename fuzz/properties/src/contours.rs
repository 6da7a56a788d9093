//! Contours: every motion of a trace lies on its line or circle, and C turns by the angle under which it is seen.

use arbitrary::{Arbitrary, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, ContourPlane, Event, FacePoint, Motion, Part, Position, RuleId, Sense, SideArc,
};

use crate::contour_pairs::pairs_agree;
use crate::cutters::{cutter_step, is_of_cutter};
use crate::differential::show;
use crate::plane::{Spot, seen_along_arc, seen_along_line};
use crate::shape::{motion, trace};
use crate::{Verdict, require};

/// What latching leaves of an equality, in nanometres.
pub(crate) const LATCHED: f64 = 3.0;

/// How far from exact an angle is that follows from latched points near the centre, in degrees.
const ANGLE: f64 = 0.01;

/// Half a turn in micro-degrees.
const HALF: i64 = 180_000_000;

/// Of every motion of a contour in a program of the generator that follows another motion in the same frame:
///
/// 1. **End.** C travels from where it was to where it is, by less than a turn (on the side less than a turn too), and `px`
///    `py` is the point of X and C, out of conversion mode to the nanometre.
/// 2. **Circle.** The centre of an arc is as far from its start as from its end, to within 3 nm of latching.
/// 3. **Travel.** C turns by the angle under which the line or the arc is seen from the centre of the face, where it keeps
///    0.02 mm away from it; more than half a turn, or half a turn, of an arc goes with its sense. A turn at the centre is at
///    most half a turn, and half a turn is positive.
/// 4. **Path.** F of a line is measured on the distance of its ends, of a motion of X alone on half its travel.
/// 5. **Side.** `pu` is π·X·C/360.
///
/// In cutter radius compensation the same is said of the cutter centre, by [`cutter_step`].
///
/// And of the contours of [`pairs_agree`], which are composed from the bytes: the commanded radius, the image in a mirror, and
/// one increment more.
///
/// Rules: E100L-CGF-01, E100L-CGF-02, E100L-CGF-04, E100L-CGF-06, E100L-CGF-10, E100L-CGF-11, E100L-CGF-14, E100L-CGS-01,
/// E100L-CGS-04, E100L-CGS-05
pub(crate) fn contours_are_true(input: &[u8]) -> Verdict {
    pairs_agree(&mut Unstructured::new(input))?;
    let Ok(case) = Case::arbitrary(&mut Unstructured::new(input)) else { return Ok(()) };
    follow(&trace(&case)).map_err(|message| format!("{message}\n{}", show(&case)))
}

/// The same of a trace.
pub(crate) fn follow(events: &[Event]) -> Verdict {
    let mut before: Option<Motion> = None;
    for event in events {
        if let (Some(from), Some(to)) = (before, motion(event)) {
            let checked = if is_of_cutter(from) || is_of_cutter(to) {
                cutter_step(from, to, event)
            } else if to.tip.is_none() {
                step(from, to, event)
            } else {
                Ok(())
            };
            checked.map_err(|message| format!("{message}: {event:?}"))?;
        }
        before = match event.action {
            // Another frame, another plane.
            Action::Frame { .. } => None,
            Action::Mode { code, .. } if matches!(code.as_str(), "G136" | "G137" | "G13" | "G14") => None,
            // Without C nothing is known of what comes behind.
            _ => motion(event).map_or(before, |motion| motion.program.c.is_some().then_some(motion)),
        };
    }
    Ok(())
}

pub(crate) fn cites(event: &Event, rule: RuleId) -> bool {
    event.rules.as_slice().contains(&rule)
}

pub(crate) fn spot(point: FacePoint) -> Spot {
    Spot { p: point.x.0 as f64, q: point.y.0 as f64 }
}

/// The point of the face of a position.
pub(crate) fn polar(position: Position) -> Spot {
    let angle = position.c.map_or(0.0, |c| c.0 as f64 / 1e6);
    Spot::polar(position.x.0 as f64 / 2.0, angle)
}

fn step(from: Motion, to: Motion, event: &Event) -> Verdict {
    let converted = cites(event, CGF_14);
    let start = if converted { from.face.map(spot) } else { Some(polar(from.program)) };
    match (event.action, to.face) {
        (Action::Linear { path, .. }, Some(end)) if cites(event, CGF_02) => {
            end_of(from, to, converted)?;
            let Some(start) = start else { return Ok(()) };
            line(from, to, (start, spot(end)), path.0)
        }
        (Action::ContourArc { sense, plane: ContourPlane::FaceCentre(centre), .. }, Some(end)) => {
            end_of(from, to, converted)?;
            let Some(start) = start else { return Ok(()) };
            arc(travel(to), (start, spot(end), spot(centre)), sense)
        }
        (Action::ContourArc { plane: ContourPlane::SideArc(side), .. }, None) => {
            end_of(from, to, true)?;
            on_side(from, to, side)
        }
        (Action::ContourArc { .. }, _) => Err("an arc of another plane than its points".to_owned()),
        _ => Ok(()),
    }
}

pub(crate) fn travel(motion: Motion) -> i64 {
    motion.c_travel.map_or(0, |travel| travel.0)
}

/// Statement 1.
fn end_of(from: Motion, to: Motion, converted: bool) -> Verdict {
    let (Some(start), Some(end)) = (from.program.c, to.program.c) else { return Ok(()) };
    let around = (end.0 - start.0 - travel(to)).rem_euclid(2 * HALF);
    require(around == 0, || format!("C from {} to {} by {}", start.0, end.0, travel(to)))?;
    require(travel(to).abs() < 2 * HALF, || "a turn or more".to_owned())?;
    let Some(face) = to.face.filter(|_| !converted) else { return Ok(()) };
    let away = spot(face).distance(polar(to.program));
    require(away < 1.5, || format!("its point is {away} nm away from X and C"))
}

/// Statements 3 and 4 of a line.
pub(crate) fn line(from: Motion, to: Motion, (start, end): (Spot, Spot), path: i64) -> Verdict {
    let travel = travel(to);
    let along = (to.program.z.0 - from.program.z.0) as f64;
    let radial = (to.program.x.0 - from.program.x.0) as f64 / 2.0;
    let length = match to.part {
        Some(Part::Turn) => {
            let turns = travel != 0 && travel > -HALF && travel <= HALF;
            require(turns && to.program.x.0 == 0, || format!("a turn at the centre by {travel}"))?;
            travel.abs() as f64 * 500e6 / 360e6
        }
        Some(Part::Radial) => {
            require(travel == 0, || format!("C turns by {travel} while X moves"))?;
            radial.abs()
        }
        _ if travel == 0 => radial.hypot(along),
        _ => {
            // A cutter centre that passes within a nanometre of the centre turns C by half a turn, latched.
            require(travel.abs() <= HALF, || format!("a line over {travel}"))?;
            if let Some(seen) = seen_along_line(start, end) {
                turned(travel, seen)?;
            }
            start.distance(end).hypot(along)
        }
    };
    let off = (length - path as f64).abs();
    require(off < LATCHED, || format!("a path of {path}, {length} by its ends"))
}

/// Statements 2 and 3 of an arc of the face.
fn arc(travel: i64, (start, end, centre): (Spot, Spot, Spot), sense: Sense) -> Verdict {
    on_circle(start, end, centre)?;
    let positive = sense == Sense::CounterClockwise;
    require(travel.abs() < HALF || (travel > 0) == positive, || format!("{travel} against the sense"))?;
    match seen_along_arc(start, end, centre, positive) {
        Some(seen) => turned(travel, seen),
        None => Ok(()),
    }
}

/// Statement 2.
fn on_circle(start: Spot, end: Spot, centre: Spot) -> Verdict {
    let off = (centre.distance(start) - centre.distance(end)).abs();
    require(off < LATCHED, || format!("the centre is {off} nm farther from one end"))
}

/// Statement 3.
pub(crate) fn turned(travel: i64, seen: f64) -> Verdict {
    let off = (travel as f64 / 1e6 - seen).abs();
    require(off < ANGLE, || format!("C travels by {travel}, seen under {seen}"))
}

/// Statements 2 and 5 of an arc of the side.
fn on_side(from: Motion, to: Motion, side: SideArc) -> Verdict {
    let around = std::f64::consts::PI * to.program.x.0 as f64 * travel(to) as f64 / 360e6;
    let off = (around - side.travel.0 as f64).abs();
    require(off < 1.0, || format!("{} along the cylinder, not {around}", side.travel.0))?;
    require(from.program.x == to.program.x, || "X has changed".to_owned())?;
    let at = |u: i64, z: i64| Spot { p: u as f64, q: z as f64 };
    on_circle(at(0, from.program.z.0), at(side.travel.0, to.program.z.0), at(side.centre.0, side.centre_z.0))
}

#[cfg(test)]
mod tests {
    use super::follow;
    use turnspec_oracle::vocabulary::{Action, Angle, ContourPlane, Event, FacePoint, Length, Setup};

    const FACE: &[u8] = b"M110\nG94 G00 X100 C80 F100\nG103 C280 L50\nG101 X60 C10\nC190\nM02\n";
    const SIDE: &[u8] = b"M110\nG94 G00 X100 Z50 F100\nG132 Z20 C60 L60\nM02\n";
    const CONVERTED: &[u8] = b"M110\nG94 G137 C20\nG00 X30 Y40\nG101 X-50 F100\nG102 X30 Y40 L60\nM02\n";

    fn trace(program: &[u8]) -> Vec<Event> {
        let mut events = Vec::new();
        turnspec_oracle::run(program, &Setup::default(), &mut |event: &Event| events.push(*event));
        events
    }

    /// A trace in which each motion of a contour was changed.
    fn changed(program: &[u8], change: impl Fn(&mut Action)) -> Vec<Event> {
        let mut events = trace(program);
        events.iter_mut().for_each(|event| change(&mut event.action));
        events
    }

    #[test]
    fn true_contours_hold() {
        for program in [FACE, SIDE, CONVERTED] {
            assert_eq!(follow(&trace(program)), Ok(()));
        }
    }

    #[test]
    fn wrong_contours_are_refused() {
        let travel = |action: &mut Action| {
            if let Action::ContourArc { motion, .. } = action {
                motion.c_travel = motion.c_travel.map(|c| Angle(c.0 - 360_000_000));
            }
        };
        let centre = |action: &mut Action| match action {
            Action::ContourArc { plane: ContourPlane::FaceCentre(centre), .. } => centre.y.0 += 5,
            Action::ContourArc { plane: ContourPlane::SideArc(side), .. } => side.centre.0 += 5,
            _ => {}
        };
        let path = |action: &mut Action| {
            if let Action::Linear { path, .. } = action {
                *path = Length(path.0 + 4);
            }
        };
        let point = |action: &mut Action| {
            if let Action::Linear { motion, .. } = action {
                motion.face = motion.face.map(|face| FacePoint { y: Length(face.y.0 + 4), ..face });
            }
        };
        let along = |action: &mut Action| {
            if let Action::ContourArc { plane: ContourPlane::SideArc(side), .. } = action {
                side.travel.0 += 2;
            }
        };
        assert!(follow(&changed(FACE, travel)).is_err());
        assert!(follow(&changed(SIDE, travel)).is_err());
        assert!(follow(&changed(FACE, centre)).is_err());
        assert!(follow(&changed(SIDE, centre)).is_err());
        assert!(follow(&changed(FACE, path)).is_err());
        assert!(follow(&changed(CONVERTED, path)).is_err());
        assert!(follow(&changed(FACE, point)).is_err());
        assert!(follow(&changed(SIDE, along)).is_err());
        assert!(follow(&changed(CONVERTED, travel)).is_err());
    }

    #[test]
    fn a_turn_at_the_centre_is_positive() {
        let back = |action: &mut Action| match action {
            Action::Linear { motion, .. } if motion.c_travel == Some(Angle(180_000_000)) => {
                motion.c_travel = Some(Angle(-180_000_000));
            }
            _ => {}
        };
        assert!(follow(&changed(FACE, back)).is_err());
    }
}
