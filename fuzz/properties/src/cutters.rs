//! Cutter radius compensation: what holds of contours holds of the way of the cutter centre.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, ContourPlane, Event, Motion, Position, Sense, SideArc};

use crate::contours::{cites, line, polar, spot, travel, turned};
use crate::plane::{Spot, seen_along_arc};
use crate::{Verdict, require};

/// What latching leaves of an equality of three latched points, in nanometres.
const LATCHED: f64 = 8.0;

/// A full turn in micro-degrees.
const TURN: i64 = 360_000_000;

/// Whether a motion is in this compensation.
pub(crate) fn is_of_cutter(motion: Motion) -> bool {
    motion.tip_c.is_some()
}

/// Of a motion in cutter radius compensation or behind one, and the motion before it in the same frame:
///
/// 1. **End.** C travels from where the cutter was to where it is, and in contours out of conversion mode `qx` `qy` is the point
///    of `tx` and `tc`, to within their latching.
/// 2. **Circle.** The centre of an arc is as far from the start of the cutter centre as from its end, to within 8 nm.
/// 3. **Travel and path** of G101, G102 and G103 are those of the cutter centre.
///
/// Rules: E100L-CRC-05, E100L-CRC-14, E100L-CRC-15
pub(crate) fn cutter_step(from: Motion, to: Motion, event: &Event) -> Verdict {
    let (start, end) = (at_cutter(from), at_cutter(to));
    if let (Some(before), Some(behind), Some(travel)) = (start.program.c, end.program.c, to.c_travel) {
        let around = (behind.0 - before.0 - travel.0).rem_euclid(TURN);
        require(around == 0, || format!("C from {} to {} by {}", before.0, behind.0, travel.0))?;
    }
    let converted = cites(event, CGF_14);
    let contour = cites(event, CGF_02) || cites(event, CGF_04);
    if let Some(face) = to.face_tip.filter(|_| contour && !converted) {
        let away = spot(face).distance(polar(end.program));
        // C is latched to a micro-degree.
        let most = 2.0 + end.program.x.0.abs() as f64 * 1e-8;
        require(away < most, || format!("the cutter is {away} nm away from its X and C"))?;
    }
    match event.action {
        Action::Linear { path, .. } if cites(event, CGF_02) => match face_ends(start, end, converted) {
            Some(ends) => line(start, end, ends, path.0),
            None => Ok(()),
        },
        Action::ContourArc { sense, plane: ContourPlane::FaceCentre(centre), .. } => {
            match face_ends(start, end, converted) {
                Some(ends) => arc(travel(to), ends, spot(centre), sense),
                None => Ok(()),
            }
        }
        Action::ContourArc { plane: ContourPlane::SideArc(side), .. } => on_side((from, to), side),
        _ => Ok(()),
    }
}

/// The motion as if it were programmed to where the cutter centre is.
fn at_cutter(motion: Motion) -> Motion {
    let (Some(tip), Some(c)) = (motion.tip, motion.tip_c) else { return motion };
    let program = Position { x: tip.x, z: tip.z, c: Some(c), ..motion.program };
    Motion { program, face: motion.face_tip, ..motion }
}

/// Where the centre starts and ends on the face.
fn face_ends(from: Motion, to: Motion, converted: bool) -> Option<(Spot, Spot)> {
    let start = match from.face.map(spot) {
        Some(start) => start,
        None if converted => return None,
        None => polar(from.program),
    };
    Some((start, spot(to.face?)))
}

/// Statements 2 and 3 of an arc of the face.
fn arc(travel: i64, (start, end): (Spot, Spot), centre: Spot, sense: Sense) -> Verdict {
    on_circle(start, end, centre)?;
    match seen_along_arc(start, end, centre, sense == Sense::CounterClockwise) {
        Some(seen) => turned(travel, seen),
        None => Ok(()),
    }
}

/// Statement 2.
fn on_circle(start: Spot, end: Spot, centre: Spot) -> Verdict {
    let off = (centre.distance(start) - centre.distance(end)).abs();
    require(off < LATCHED, || format!("the centre is {off} nm farther from one end of the cutter's way"))
}

/// Statement 2 of an arc of the side, whose centre is told from the programmed start.
fn on_side((from, to): (Motion, Motion), side: SideArc) -> Verdict {
    let aside = |motion: Motion| {
        let (Some(tip), Some(programmed)) = (motion.tip_c, motion.program.c) else { return 0.0 };
        let turn = (tip.0 - programmed.0 + TURN / 2).rem_euclid(TURN) - TURN / 2;
        std::f64::consts::PI * to.program.x.0 as f64 * turn as f64 / TURN as f64
    };
    let along = |motion: Motion| motion.tip.map_or(motion.program.z, |tip| tip.z).0 as f64;
    let start = Spot { p: aside(from), q: along(from) };
    let end = Spot { p: side.travel.0 as f64 + aside(to), q: along(to) };
    let centre = Spot { p: side.centre.0 as f64, q: side.centre_z.0 as f64 };
    // On a thin part the cutter may be more than half a turn beside the programmed point.
    let once = std::f64::consts::PI * to.program.x.0 as f64;
    let turned = |spot: Spot, turns: i32| Spot { p: spot.p + once * f64::from(turns), ..spot };
    let mut turns = (-2..=2).flat_map(|first| (-2..=2).map(move |second| (first, second)));
    let fits =
        turns.any(|(first, second)| on_circle(turned(start, first), turned(end, second), centre).is_ok());
    if fits { Ok(()) } else { on_circle(start, end, centre) }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{
        Action, Angle, ContourPlane, Event, Length, Motion, PlanePosition, Setup,
    };

    use crate::contours::follow;

    const FACE: &[u8] = b"M110\nG94 G00 X100 C80 F100\nG103 C280 L50\nG101 X60 C10\nC190\nM02\n";
    const SIDE: &[u8] = b"M110\nG94 G00 X100 Z50 F100\nG132 Z20 C60 L60\nM02\n";

    fn motion_of(action: &mut Action) -> Option<&mut Motion> {
        match action {
            Action::Linear { motion, .. } | Action::ContourArc { motion, .. } => Some(motion),
            _ => None,
        }
    }

    /// A trace in which the cutter centre goes where the program goes, and the program is said to go elsewhere.
    fn compensated(program: &[u8], change: impl Fn(&mut Action)) -> Vec<Event> {
        let mut events = Vec::new();
        turnspec_oracle::run(program, &Setup::default(), &mut |event: &Event| events.push(*event));
        for event in &mut events {
            if let Some(motion) = motion_of(&mut event.action) {
                motion.tip = Some(PlanePosition { x: motion.program.x, z: motion.program.z });
                (motion.tip_c, motion.face_tip) = (motion.program.c, motion.face);
                if let Some(face) = &mut motion.face {
                    face.x.0 += 5_000_000;
                    motion.program.x.0 += 10_000_000;
                }
            }
            change(&mut event.action);
        }
        events
    }

    #[test]
    fn the_way_of_the_cutter_is_what_counts() {
        for program in [FACE, SIDE] {
            assert_eq!(follow(&compensated(program, |_| {})), Ok(()));
        }
    }

    #[test]
    fn another_way_of_the_cutter_is_noticed() {
        let travel = |action: &mut Action| {
            if let Some(motion) = motion_of(action) {
                motion.c_travel = motion.c_travel.map(|c| Angle(c.0 + 20_000));
            }
        };
        let path = |action: &mut Action| {
            if let Action::Linear { path, .. } = action {
                *path = Length(path.0 + 4);
            }
        };
        let centre = |action: &mut Action| match action {
            Action::ContourArc { plane: ContourPlane::FaceCentre(centre), .. } => centre.y.0 += 12,
            Action::ContourArc { plane: ContourPlane::SideArc(side), .. } => side.centre.0 += 12,
            _ => {}
        };
        assert!(follow(&compensated(FACE, travel)).is_err());
        assert!(follow(&compensated(FACE, path)).is_err());
        assert!(follow(&compensated(FACE, centre)).is_err());
        assert!(follow(&compensated(SIDE, centre)).is_err());
    }
}
