//! The motions of G101: a line of the face, or at the centre X alone and C alone (E100L-CGF-02, E100L-CGF-03, E100L-CGF-09
//! to -12).

use super::face::FaceStep;
use super::motion::Course;
use super::plane::PlanePoint;
use super::way::{Bearing, End, Way, Whose};
use crate::fault::{Fault, Outcome};
use crate::quantity::{Exact, narrow, ratio, round_narrow, whole};
use crate::real::{self, Interval};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Part, RuleId, RuleSet};

/// The motions from start to end. `has_z`: the block has a Z word.
pub fn steps(way: &Way, has_z: bool) -> Outcome<Vec<FaceStep>> {
    let (start, end) = (way.start, way.end);
    let (before, after) = (at_centre(start.c), at_centre(end.c));
    let steps = match (start.is_centre, end.is_centre) {
        (true, _) | (_, true) if start.c == end.c => vec![along_ray(way)],
        (true, true) => vec![turn(after, way.shorter(), CGF_10)],
        (true, false) => vec![turn(after, way.shorter(), CGF_10), radial(after, end, CGF_10)],
        (false, true) => vec![radial(start, before, CGF_10), turn(after, way.shorter(), CGF_10)],
        (false, false) => match way.bearing() {
            Bearing::Same => vec![along_ray(way)],
            Bearing::Opposite => vec![
                radial(start, before, CGF_11),
                turn(after, way.turn(true), CGF_11),
                radial(after, end, CGF_11),
            ],
            Bearing::Forward => vec![line(way, way.beside(true), RuleSet::EMPTY)],
            Bearing::Backward => vec![line(way, way.beside(false), RuleSet::EMPTY)],
        },
    };
    // Nothing tells where Z would move while C turns alone.
    if has_z && way.z.0 != way.z.1 && steps.iter().any(FaceStep::is_turn) {
        return Err(Fault::about(AlarmName::Unspecified, CGF_03, "Z"));
    }
    let rules = if has_z { RuleSet::of(&[CGF_02, CGF_03]) } else { RuleSet::of(&[CGF_02]) };
    Ok(steps.into_iter().map(|step| FaceStep { rules: step.rules.union(rules), ..step }).collect())
}

/// The centre of the face, with this C.
fn at_centre(c: i64) -> End {
    End { point: PlanePoint::CENTRE, x: 0, c, is_centre: true }
}

/// E100L-CGF-09: C stays.
fn along_ray(way: &Way) -> FaceStep {
    line(way, 0, RuleSet::of(&[CGF_09]))
}

/// E100L-CGF-02, E100L-CGF-03: straight to the target. On a ray X alone is what the line is long, but of a cutter centre.
fn line(way: &Way, travel: i64, rules: RuleSet) -> FaceStep {
    let (start, end) = (way.start, way.end);
    let square = if travel == 0 && way.of != Whose::Cutter {
        let radius = ratio(end.x - start.x, 2);
        &radius * &radius
    } else {
        start.point.distance_square(end.point)
    };
    let along_z: Exact = whole(way.z.1 - way.z.0);
    let square = square + &along_z * &along_z;
    let path = narrow(&real::nearest_whole(|precision| Interval::of(&square, precision).sqrt()));
    FaceStep { end, travel, course: Course::Line { path, part: None }, rules }
}

/// E100L-CGF-10, E100L-CGF-11: X alone.
fn radial(start: End, end: End, rule: RuleId) -> FaceStep {
    let path = round_narrow(&ratio((end.x - start.x).abs(), 2));
    let course = Course::Line { path, part: Some(Part::Radial) };
    FaceStep { end, travel: 0, course, rules: RuleSet::of(&[rule]) }
}

/// E100L-CGF-12: C alone, at the centre; 360 degrees count as 500 mm (E100L-CFEED-01).
fn turn(end: End, travel: i64, rule: RuleId) -> FaceStep {
    let path = round_narrow(&ratio(travel.abs() * 25, 18));
    let course = Course::Line { path, part: Some(Part::Turn) };
    FaceStep { end, travel, course, rules: RuleSet::of(&[rule, CGF_12, CFEED_01]) }
}
