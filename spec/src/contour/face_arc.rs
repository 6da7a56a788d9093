//! G102 and G103: an arc of the face, and how far C turns along it (E100L-CGF-04, E100L-CGF-06).

use super::arc::Arc;
use super::face::FaceStep;
use super::motion::{Course, face_point};
use super::plane::{PlanePoint, cosine};
use super::way::{Bearing, Way, Whose};
use crate::fault::{Fault, Outcome};
use crate::modal::Plan;
use crate::quantity::{ratio, whole};
use crate::real::Interval;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, ContourPlane, RuleSet, Sense};

/// How near the centre of the face no arc passes, in nanometres.
const NEAR: i64 = 1_000;

/// An arc of the face.
#[derive(Clone, Copy, Debug)]
pub struct FaceArc {
    /// Its centre.
    pub centre: PlanePoint,
    /// Its radius.
    pub radius: i64,
    /// The way round.
    pub sense: Sense,
}

impl FaceArc {
    /// The arc of a block.
    pub fn of(way: &Way, plan: &Plan) -> Outcome<Self> {
        let sense = if plan.motion() == 102 { Sense::Clockwise } else { Sense::CounterClockwise };
        let radius = plan.words.get('L').unwrap_or(0);
        let arc = Arc { start: way.start.point, end: way.end.point, radius, sense };
        let centre = arc.centre(|precision| chord_square(way, precision), CGF_04)?;
        Ok(Self { centre, radius, sense })
    }

    /// Its course.
    pub fn course(&self) -> Course {
        Course::Arc(self.sense, ContourPlane::FaceCentre(face_point(self.centre)))
    }
}

/// The motion along the arc of a block.
pub fn step(way: &Way, plan: &Plan) -> Outcome<FaceStep> {
    let arc = FaceArc::of(way, plan)?;
    let travel = travel(way, &arc)?;
    Ok(FaceStep { end: way.end, travel, course: arc.course(), rules: RuleSet::of(&[CGF_04]) })
}

/// The square of the exact distance of the ends: of the programmed points in conversion mode, else by diameters and angle.
fn chord_square(way: &Way, precision: usize) -> Interval {
    if way.of != Whose::Axes {
        return Interval::of(&way.start.point.distance_square(way.end.point), precision);
    }
    let (start, end) = (whole(way.start.x), whole(way.end.x));
    let squares = (&start * &start + &end * &end) * ratio(1, 4);
    let product = start * end * ratio(1, 2);
    let between = Interval::of(&product, precision).mul(&cosine(way.turn(true), precision));
    Interval::of(&squares, precision).sub(&between)
}

/// E100L-CGF-06: as the chord does, unless the centre of the face lies between chord and arc.
pub fn travel(way: &Way, arc: &FaceArc) -> Outcome<i64> {
    let FaceArc { centre, radius, sense } = *arc;
    let forward = sense == Sense::CounterClockwise;
    let with_chord = match way.bearing() {
        Bearing::Same => return Ok(0),
        Bearing::Opposite => None,
        Bearing::Forward => Some(forward),
        Bearing::Backward => Some(!forward),
    };
    if with_chord == Some(true) {
        return Ok(way.beside(forward));
    }
    let square = |length: i64| i128::from(length) * i128::from(length);
    let from_centre = centre.square();
    let beyond = |length: i64| length < 0 || from_centre > square(length);
    // ||M| - L| < 0.001 mm.
    if beyond(radius - NEAR) && from_centre < square(radius + NEAR) {
        return Err(Fault::about(AlarmName::Unspecified, CGF_04, "centre"));
    }
    if with_chord.is_none() {
        return Ok(way.turn(forward));
    }
    Ok(if from_centre < square(radius) { way.around(forward) } else { way.beside(!forward) })
}
