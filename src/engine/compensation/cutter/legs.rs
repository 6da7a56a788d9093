//! The motions by which the axes follow the cutter centre from one place to another (execution of contours, 9, "Where the
//! axes go"; E100L-CRC-15, E100L-CRC-16).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{ContourPlane, Feed, Length, Part, RuleSet, Sense, SideArc};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::{Spot, cross, way};
use crate::engine::arithmetic::turn;
use crate::engine::contour::{Course, Lines, Shape, Station, face_point};
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::{Place, Plane, Programmed, ProgrammedArc};

/// How a motion is cut.
#[derive(Clone, Copy, Debug)]
pub enum Cut {
    /// Each axis on its own, or along the line of all axes.
    Axes,
    /// Straight in its plane, or an axis alone; with its length.
    Line(i64),
    /// An arc.
    Arc(Sense, ContourPlane),
}

/// One motion of the axes.
#[derive(Clone, Copy, Debug)]
pub struct Leg {
    pub cut: Cut,
    pub(super) place: Place,
    /// The travel of C.
    pub travel: i64,
    /// That of its own, if it has one.
    pub feed: Option<Feed>,
    pub part: Option<Part>,
    /// The rules of its way.
    pub rules: RuleSet,
}

/// The motions of a block in their order.
pub type Legs = [Option<Leg>; 3];

fn one(leg: Leg) -> Legs {
    [Some(leg), None, None]
}

fn station(place: &Place) -> Station {
    Station { point: place.point, x: place.x, c: place.c }
}

impl ProgrammedArc {
    /// The centre about which the cutter centre goes, and whether it is another one: that of the minor arc.
    fn centre_between(&self, from: Spot, to: Spot) -> (Spot, bool) {
        let sense = if self.sense == Sense::CounterClockwise { 1 } else { -1 };
        let turns = sense * cross(way(self.centre, from), way(self.centre, to));
        if turns >= 0 || planted::is(Bug::CutterMajorArc) {
            return (self.centre, false);
        }
        let other = |from: i64, to: i64, centre: i64| from.saturating_add(to).saturating_sub(centre);
        let p = other(from.p, to.p, self.centre.p);
        (Spot { p, q: other(from.q, to.q, self.centre.q) }, true)
    }
}

impl Interpreter<'_> {
    /// The motions of a block from one place of the cutter centre to another.
    pub(super) fn cutter_legs(
        &mut self,
        plane: Plane,
        (from, to): (&Place, &Place),
        programmed: &Programmed,
        feed: Option<Feed>,
    ) -> Result<Legs, Fault> {
        match (programmed.motion, programmed.arc, feed) {
            (101, _, Some(feed)) => self.lines_of_cutter((from, to), programmed, feed),
            (_, Some(arc), _) => {
                let (centre, other) = arc.centre_between(from.point, to.point);
                let leg = match plane {
                    Plane::Face => arc_on_face((from, to), centre, &arc)?,
                    Plane::Side { .. } => self.arc_on_side((from, to), (plane, centre), programmed, &arc)?,
                };
                let rules = if other { leg.rules.with(CRC_15) } else { leg.rules };
                Ok(one(Leg { rules, ..leg }))
            }
            _ => {
                let negative = match planted::is(Bug::CutterTurnsAsNow) {
                    true => self.state.c_negative,
                    false => programmed.negative,
                };
                let target = if planted::is(Bug::CutterTravelOfProgram) { &programmed.place } else { to };
                let travel = turn::travel(from.c, target.c, 0, negative);
                let rules = RuleSet::EMPTY;
                Ok(one(Leg { cut: Cut::Axes, place: *to, travel, feed: None, part: None, rules }))
            }
        }
    }

    /// The motions of G101.
    fn lines_of_cutter(
        &self,
        (from, to): (&Place, &Place),
        programmed: &Programmed,
        feed: Feed,
    ) -> Result<Legs, Fault> {
        let course = Course::between(station(from), station(to), programmed.z, programmed.z_target);
        let lines = Lines::of(&course)?;
        let end = if planted::is(Bug::CutterPathToProgram) { &programmed.place } else { to };
        let length = Course { end: station(end), ..course }.length_of_points(to.z);
        let percent = self.setup.parameters.centre_override;
        let legs = lines.legs(&course, feed, percent, RuleSet::EMPTY);
        Ok(legs.map(|leg| {
            let leg = leg?;
            let (x, point) = leg.face.unwrap_or_default();
            let cut = match (lines, leg.shape) {
                (Lines::One(_), _) => Cut::Line(length),
                (_, Shape::Line(path)) => Cut::Line(path),
                (_, Shape::Arc(sense, plane)) => Cut::Arc(sense, plane),
            };
            let place = Place { point, x, c: leg.c, ..*to };
            let (travel, part, rules) = (leg.travel, leg.part, leg.rules);
            Some(Leg { cut, place, travel, feed: Some(leg.feed), part, rules })
        }))
    }

    /// The arc of G132 or G133.
    fn arc_on_side(
        &self,
        (from, to): (&Place, &Place),
        (plane, centre): (Plane, Spot),
        programmed: &Programmed,
        arc: &ProgrammedArc,
    ) -> Result<Leg, Fault> {
        let travel = match planted::is(Bug::CutterUnwoundLost) {
            true => turn::shorter(from.c, to.c),
            false => to.unwrapped.saturating_sub(from.unwrapped),
        };
        self.check_wound(travel)?;
        let from_start = |p: i64| Length(plane.seen(p).saturating_sub(programmed.from_u));
        let side = SideArc {
            travel: from_start(programmed.place.point.p),
            centre: from_start(centre.p),
            centre_z: Length(centre.q),
        };
        let cut = Cut::Arc(arc.sense, ContourPlane::SideArc(side));
        Ok(Leg { cut, place: *to, travel, feed: None, part: None, rules: RuleSet::EMPTY })
    }
}

/// The arc of G102 or G103.
fn arc_on_face((from, to): (&Place, &Place), centre: Spot, arc: &ProgrammedArc) -> Result<Leg, Fault> {
    let course = Course::between(station(from), station(to), to.z, None);
    let travel = course.arc_turn(centre, arc.radius, arc.sense)?;
    let cut = Cut::Arc(arc.sense, ContourPlane::FaceCentre(face_point(centre)));
    let rules = const { RuleSet::of(&[CGF_04]) };
    Ok(Leg { cut, place: *to, travel, feed: None, part: None, rules })
}
