//! The motions of a block with G101: a line, or what stands for one where it meets the centre of the face (execution
//! of contours, 5; E100L-CGF-02, E100L-CGF-03, E100L-CGF-06, E100L-CGF-09 to E100L-CGF-12).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Feed, FeedRate, Part, RuleSet};

use crate::engine::arithmetic::contour::{Spot, percent_of, square, turn_length, way};
use crate::engine::arithmetic::root::root_over;
use crate::engine::arithmetic::{feed, turn};
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::Station;
use super::face::{Bearing, Course};
use super::motion::{Leg, Shape};
use super::unspecified;

/// How a line is carried out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Lines {
    /// By one motion, with this travel of C.
    One(i64),
    /// By motions of X and C alone, with this turn of C at the centre.
    Apart(i64),
}

impl Lines {
    /// How the line of a course is carried out.
    pub fn of(course: &Course) -> Result<Self, Fault> {
        let (start, end) = (course.start, course.end);
        let lines = match course.bearing {
            Bearing::Centre if start.c == end.c => Self::One(0),
            Bearing::Centre => Self::Apart(turn::shorter(start.c, end.c)),
            Bearing::Same => Self::One(0),
            Bearing::Opposite => Self::Apart(course.turn(!planted::is(Bug::ThroughCentreBackward))),
            Bearing::Left => Self::One(course.turn_beside(true)),
            Bearing::Right => Self::One(course.turn_beside(planted::is(Bug::LineTurnsForward))),
        };
        let travels = course.z_target.is_some_and(|z| z != course.z);
        match lines {
            Self::Apart(_) if travels => Err(unspecified(CGF_03, "Z")),
            lines => Ok(lines),
        }
    }

    /// The motions in their order, with the rules that they have in common.
    pub fn legs(self, course: &Course, feed: Feed, percent: u16, rules: RuleSet) -> [Option<Leg>; 3] {
        let of_bearing = match (self, course.bearing) {
            (Self::One(_), Bearing::Centre) | (_, Bearing::Same) => const { RuleSet::of(&[CGF_02, CGF_09]) },
            (Self::Apart(_), Bearing::Centre) => const { RuleSet::of(&[CGF_02, CGF_10]) },
            (_, Bearing::Opposite) => const { RuleSet::of(&[CGF_02, CGF_11]) },
            _ => const { RuleSet::of(&[CGF_02]) },
        };
        let rules = rules.union(of_bearing);
        let rules = if course.z_target.is_some() { rules.with(CGF_03) } else { rules };
        let (start, end) = (course.start, course.end);
        let leg = |path, to: Station, travel, part| Leg {
            shape: Shape::Line(path),
            face: Some((to.x, to.point)),
            z: course.z_target,
            c: to.c,
            travel,
            feed,
            part,
            rules,
        };
        let radial =
            |from: Station, to: Station| leg(radial_length(from.x, to.x, 0), to, 0, Some(Part::Radial));
        match self {
            Self::One(travel) => [Some(leg(course.length(travel), end, travel, None)), None, None],
            Self::Apart(travel) => {
                let centre = |c| Station { point: Spot::default(), x: 0, c };
                let percent = if planted::is(Bug::OverrideIgnored) { 100 } else { percent };
                let slow = Feed { value: FeedRate(percent_of(feed.value.0, percent)), ..feed };
                let turn = Leg {
                    feed: slow,
                    rules: rules.union(const { RuleSet::of(&[CGF_12, CFEED_01]) }),
                    ..leg(turn_length(travel), centre(end.c), travel, Some(Part::Turn))
                };
                let inward = (start.x != 0).then(|| radial(start, centre(start.c)));
                let outward = (end.x != 0).then(|| radial(centre(end.c), end));
                [inward, Some(turn), outward]
            }
        }
    }
}

impl Course {
    /// The length of the line in space, latched, with a travel of C.
    fn length(&self, travel: i64) -> i64 {
        let z = self.z_target.unwrap_or(self.z);
        if travel == 0 || self.bearing == Bearing::Centre {
            return radial_length(self.start.x, self.end.x, z.saturating_sub(self.z));
        }
        self.length_of_points(z)
    }

    /// The distance of the two points, with the travel to a program Z, latched.
    pub fn length_of_points(&self, z: i64) -> i64 {
        let in_plane = square(way(self.start.point, self.end.point)).unsigned_abs();
        root_over(in_plane + feed::square(self.z, z), 1)
    }
}

/// The length of a motion of X and Z, latched.
fn radial_length(from: i64, to: i64, along: i64) -> i64 {
    root_over(feed::square(from, to) + 4 * feed::square(0, along), 2)
}
