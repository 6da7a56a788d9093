//! A block with G101, G102 or G103 (execution of contours, 4 and 5; E100L-CGF-01 to E100L-CGF-14).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, ContourPlane, RuleSet, Sense, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::{Spot, cross, dot, passes_near, square, way};
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::arithmetic::turn;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{C, X, Z};
use crate::engine::words::{Address, Words};

use super::arc::Arc;
use super::chord::Chord;
use super::line::Lines;
use super::motion::{Leg, Shape, face_point, word_cites};
use super::{POINT, Station, sense, unspecified};

/// How near to the centre an arc may not pass, in nanometres.
const NEAREST: i64 = 1_000;

/// Where the target lies, seen from the centre of the face by who looks to the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bearing {
    /// Start or target is the centre.
    Centre,
    /// On the same ray.
    Same,
    /// On the opposite ray.
    Opposite,
    /// In the positive direction of C.
    Left,
    /// In the negative direction.
    Right,
}

impl Bearing {
    /// Of two points of the face, compared exactly.
    fn of_points(start: Spot, end: Spot) -> Self {
        if start.is_centre() || end.is_centre() {
            return Self::Centre;
        }
        match cross(start, end) {
            0 if dot(start, end) > 0 => Self::Same,
            0 => Self::Opposite,
            1.. => Self::Left,
            _ => Self::Right,
        }
    }
}

/// How a face block gets to its target.
enum Way {
    Lines(Lines),
    /// With its travel of C.
    Arc(i64, Shape),
}

/// Start and target of a face block: points, and program coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    pub start: Station,
    pub end: Station,
    pub bearing: Bearing,
    /// Program Z before, and the target if the block has a Z word.
    pub z: i64,
    pub z_target: Option<i64>,
    /// Whether the points are those of conversion mode.
    pub converted: bool,
    /// Whether it is that of a cutter centre in compensation.
    pub of_cutter: bool,
}

impl Course {
    /// Between two points of the face, with program Z before and the target of a Z word.
    pub fn between(start: Station, end: Station, z: i64, z_target: Option<i64>) -> Self {
        let bearing = Bearing::of_points(start.point, end.point);
        Self { start, end, bearing, z, z_target, converted: true, of_cutter: true }
    }

    fn bearing(start: Station, end: Station, converted: bool) -> Bearing {
        const HALF: i64 = turn::TURN / 2;
        if start.x == 0 || end.x == 0 {
            return Bearing::Centre;
        }
        if converted {
            return Bearing::of_points(start.point, end.point);
        }
        match turn::within(end.c - start.c) {
            0 => Bearing::Same,
            HALF => Bearing::Opposite,
            ..HALF => Bearing::Left,
            _ => Bearing::Right,
        }
    }

    /// The travel of C in the positive or the negative direction.
    pub fn turn(&self, positive: bool) -> i64 {
        turn::travel(self.start.c, self.end.c, 0, !positive)
    }

    /// The turn on the side of the chord. Of a cutter centre, one of whose C may be a programmed one, the last digit may
    /// contradict the side on nearly the same ray (execution of contours, 9).
    pub fn turn_beside(&self, positive: bool) -> i64 {
        if self.of_cutter && !planted::is(Bug::CutterWholeTurn) {
            turn::beside(self.start.c, self.end.c, !positive)
        } else {
            self.turn(positive)
        }
    }

    /// The turn round the centre, on the other side; likewise.
    fn turn_around(&self, positive: bool) -> i64 {
        if self.of_cutter { turn::around(self.start.c, self.end.c, !positive) } else { self.turn(positive) }
    }

    /// The exact distance of the ends.
    fn chord(&self) -> Chord {
        if self.converted || planted::is(Bug::LatchedChord) {
            Chord::Whole(4 * square(way(self.start.point, self.end.point)))
        } else {
            Chord::on_face(self.start.x, self.end.x, turn::within(self.end.c - self.start.c))
        }
    }

    /// The travel of C along an arc (E100L-CGF-06).
    pub fn arc_turn(&self, centre: Spot, radius: i64, sense: Sense) -> Result<i64, Fault> {
        let positive = sense == Sense::CounterClockwise;
        let left = match self.bearing {
            Bearing::Same => return Ok(0),
            Bearing::Left => true,
            Bearing::Right => false,
            Bearing::Opposite => positive,
            // X is above 0 (E100L-CGF-08), but a point so near that it is the centre when latched.
            Bearing::Centre => return Err(unspecified(CGF_04, "centre")),
        };
        let distance = square(centre);
        let against = self.bearing != Bearing::Opposite && positive != left;
        let near = passes_near(distance, radius, NEAREST) && !planted::is(Bug::NearCentreCut);
        if (against || self.bearing == Bearing::Opposite) && near {
            return Err(unspecified(CGF_04, "centre"));
        }
        let encloses = distance < i128::from(radius) * i128::from(radius) && !planted::is(Bug::ArcWithChord);
        Ok(match self.bearing {
            Bearing::Opposite => self.turn(positive),
            _ if against && encloses => self.turn_around(positive),
            _ => self.turn_beside(left),
        })
    }
}

impl Interpreter<'_> {
    /// A contour block on the face.
    pub(super) fn face_contour(
        &mut self,
        words: &Words,
        motion: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.check_c_axis(CGF_07, CGF_07)?;
        let course = self.course(words)?;
        let arc = motion != 101;
        check_diameters(&course, arc)?;
        let way = if arc { self.face_arc(&course, words, motion)? } else { Way::Lines(Lines::of(&course)?) };
        self.check_coordinate(course.end.x)?;
        course.z_target.map_or(Ok(()), |z| self.check_coordinate(z))?;
        let feed = self.feed()?;
        self.check_no_barrier(CGF_01)?;
        let cites = word_cites(&self.state, self.inch_block, words.has(Address::X) && !course.converted)
            .and(self.feed_cites());
        let mut rules = const { RuleSet::of(&[CGF_01, CGF_06]) };
        if course.converted {
            rules = rules.with(CGF_14).union(self.conversion_rules(words));
        }
        match way {
            Way::Arc(travel, shape) => {
                let leg = Leg {
                    shape,
                    face: Some((course.end.x, course.end.point)),
                    z: None,
                    c: course.end.c,
                    travel,
                    feed,
                    part: None,
                    rules: rules.with(CGF_04),
                };
                self.follow_contour(&leg, cites, sink)?;
            }
            Way::Lines(lines) => {
                let percent = self.setup.parameters.centre_override;
                for leg in lines.legs(&course, feed, percent, rules).into_iter().flatten() {
                    self.follow_contour(&leg, cites, sink)?;
                }
            }
        }
        if words.has_any(POINT) {
            self.keep_point(course.end);
        }
        Ok(())
    }

    /// Start and target of a face block.
    pub(in crate::engine) fn course(&mut self, words: &Words) -> Result<Course, Fault> {
        let incremental = self.state.incremental;
        let converted = self.state.contour.converts();
        let z = self.state.program(Z);
        let z_target = words.get(Address::Z).map(|word| coordinate(z, word, incremental));
        let (start, end) = if converted {
            let held = self.held_point();
            let ends = held.and_then(|held| Some((held, self.target_point(words, Some(held))?)));
            let Some((start, target)) = ends else { return Err(unspecified(CGF_14, "start")) };
            (start, self.converted(target))
        } else {
            let (x, c) = (self.state.program(X), self.state.program(C));
            let target = |address, present| {
                words.get(address).map_or(present, |word| coordinate(present, word, incremental))
            };
            let (to_x, to_c) = (target(Address::X, x), turn::within(target(Address::C, c)));
            let start = Station { point: self.point_of(x, c), x, c };
            (start, Station { point: self.point_of(to_x, to_c), x: to_x, c: to_c })
        };
        let bearing = Course::bearing(start, end, converted);
        Ok(Course { start, end, bearing, z, z_target, converted, of_cutter: false })
    }

    /// The arc of a block.
    fn face_arc(&mut self, course: &Course, words: &Words, motion: u16) -> Result<Way, Fault> {
        let sense = sense(motion);
        let radius = words.get(Address::L).unwrap_or_default();
        let centre = self.face_centre(course, radius, sense)?;
        let travel = course.arc_turn(centre, radius, sense)?;
        Ok(Way::Arc(travel, Shape::Arc(sense, ContourPlane::FaceCentre(face_point(centre)))))
    }

    /// The centre of an arc with a radius, latched.
    pub(in crate::engine) fn face_centre(
        &mut self,
        course: &Course,
        radius: i64,
        sense: Sense,
    ) -> Result<Spot, Fault> {
        let (start, end, chord) = (course.start.point, course.end.point, course.chord());
        Arc { start, end, chord, radius, sense, rule: CGF_04 }.centre(&mut self.slow)
    }
}

/// The diameters of a face block are not negative, of an arc positive.
pub fn check_diameters(course: &Course, arc: bool) -> Result<(), Fault> {
    let least = i64::from(arc);
    if course.start.x < least || course.end.x < least {
        return Fault::raise(AlarmName::ContourXNotPositive, CGF_08);
    }
    Ok(())
}
