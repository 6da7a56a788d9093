//! How the axes get from one place of the cutter to the next, and how far C turns (E100L-CRC-14 to -16).

use super::plane::{Spot, Standing};
use crate::contour::{self, Cylinder, FaceArc, FaceStep, PlanePoint, Way, Whose};
use crate::fault::{Outcome, fail};
use crate::integer::turn;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleSet, Sense};

/// Which way a motion goes.
#[derive(Clone, Copy, Debug)]
pub enum Course {
    /// G00 and G01: C turns in the direction of M15 or M16.
    Axes {
        /// Whether that of M15.
        positive: bool,
    },
    /// G101.
    Line {
        /// Whether the block has a Z word.
        has_z: bool,
    },
    /// G102 and G103: the programmed centre, and the radius on which the cutter centre goes.
    FaceArc(FaceArc),
    /// G132 and G133.
    SideArc {
        /// The programmed centre.
        centre: PlanePoint,
        /// The way round.
        sense: Sense,
        /// The plane.
        cylinder: Cylinder,
        /// P at the start.
        from: PlanePoint,
    },
}

/// A motion of the axes.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Where the cutter is then.
    pub to: Standing,
    /// The travel of C.
    pub travel: i64,
    /// What its event tells of its course; none where the path is that of the axes.
    pub course: Option<contour::Course>,
    /// Its rules.
    pub rules: RuleSet,
}

impl Course {
    /// The motions of the axes from one place of the cutter to another. `z_travel`: the travel of Z of P, on the face.
    pub fn steps(
        &self,
        spot: &Spot,
        from: &Standing,
        to: &Standing,
        z_travel: i64,
        state: &State,
    ) -> Outcome<Vec<Step>> {
        let one = |travel, course, rules| vec![Step { to: *to, travel, course, rules }];
        Ok(match *self {
            Self::Axes { positive } => {
                let travel = turn::travel(from.machine.c, to.machine.c, 0, positive);
                // E100L-CRC-16.
                let rules = if travel == 0 { RuleSet::EMPTY } else { RuleSet::of(&[CRC_16]) };
                one(travel, None, rules)
            }
            Self::Line { has_z } => {
                let way = face_way(spot, from, to, z_travel);
                let of = |FaceStep { end, travel, course, rules }| Step {
                    to: spot.on_face(end.point, end.x, end.c),
                    travel,
                    course: Some(course),
                    rules,
                };
                contour::line_steps(&way, has_z)?.into_iter().map(of).collect()
            }
            Self::FaceArc(arc) => {
                let (centre, rules) = nearer_centre(from.point, to.point, arc.centre, arc.sense);
                let arc = FaceArc { centre, ..arc };
                let travel = contour::arc_travel(&face_way(spot, from, to, z_travel), &arc)?;
                one(travel, Some(arc.course()), rules)
            }
            Self::SideArc { centre, sense, cylinder, from: start } => {
                let travel = to.unwrapped.saturating_sub(from.unwrapped);
                if state.contour.is_too_far(travel) {
                    return fail(AlarmName::ProfileGeneration, CGS_06);
                }
                let (centre, rules) = nearer_centre(from.point, to.point, centre, sense);
                one(travel, Some(cylinder.course(start, spot.point, centre, sense)), rules)
            }
        })
    }
}

/// The way of the cutter centre on the face.
fn face_way(spot: &Spot, from: &Standing, to: &Standing, z_travel: i64) -> Way {
    let z = (spot.program.z - z_travel, spot.program.z);
    Way { start: spot.face_end(from), end: spot.face_end(to), z, of: Whose::Cutter }
}

/// M', the centre of the arc of at most 180 degrees between two points; the rule if that is the other one.
fn nearer_centre(
    from: PlanePoint,
    to: PlanePoint,
    centre: PlanePoint,
    sense: Sense,
) -> (PlanePoint, RuleSet) {
    let turn = from.from(centre).cross(to.from(centre));
    let beyond_half = match sense {
        Sense::CounterClockwise => turn < 0,
        Sense::Clockwise => turn > 0,
    };
    if !beyond_half {
        return (centre, RuleSet::EMPTY);
    }
    let other = PlanePoint { p: from.p + to.p - centre.p, q: from.q + to.q - centre.q };
    (other, RuleSet::of(&[CRC_15]))
}

#[cfg(test)]
mod tests {
    use super::{PlanePoint, nearer_centre};
    use crate::vocabulary::Sense::{Clockwise, CounterClockwise};

    #[test]
    fn the_other_arc_has_the_centre_on_the_other_side_of_the_chord() {
        let at = |p, q| PlanePoint { p, q };
        let found = |sense| nearer_centre(at(10, 0), at(0, 10), at(0, 0), sense).0;
        assert_eq!((found(CounterClockwise), found(Clockwise)), (at(0, 0), at(10, 10)));
        // Half a circle is none beyond half.
        for sense in [CounterClockwise, Clockwise] {
            assert_eq!(nearer_centre(at(10, 0), at(-10, 0), at(0, 0), sense).0, at(0, 0));
        }
    }
}
