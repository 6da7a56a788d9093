//! The motions of contour blocks: tests, event, rules (execution of contours, 5, 6 and 10).

use turnspec_oracle::vocabulary::{
    Action, Angle, ContourPlane, FacePoint, Feed, Length, Motion, Part, ReadingSet, RuleSet, Sense, Sink,
};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::turn;
use crate::engine::cite::{self, Cites};
use crate::engine::fault::Fault;
use crate::engine::state::{C, State, X, Z};

/// How a motion cuts.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Straight in its plane, or an axis alone; with its length.
    Line(i64),
    /// An arc.
    Arc(Sense, ContourPlane),
}

/// One motion of a contour block, in program coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Leg {
    pub shape: Shape,
    /// On the face, where it ends, with its point.
    pub face: Option<(i64, Spot)>,
    /// On the side it may be without a word.
    pub z: Option<i64>,
    pub c: i64,
    pub travel: i64,
    pub feed: Feed,
    pub part: Option<Part>,
    /// The rules of its path.
    pub rules: RuleSet,
}

/// A point as an event shows it.
pub fn face_point(point: Spot) -> FacePoint {
    FacePoint { x: Length(point.p), y: Length(point.q) }
}

/// The rules that the words of a block make its motions cite, those of the C axis and of conversion mode aside.
pub fn word_cites(state: &State, inch: bool, diameter: bool) -> Cites {
    let incremental = state.incremental;
    cite::COORD_03
        .and(if incremental { cite::ABS_02 } else { cite::ABS_01 })
        .and_if(diameter, cite::DIA_01)
        .and_if(diameter && incremental, cite::ABS_03)
        .and_if(inch, cite::INCH_02)
}

impl Interpreter<'_> {
    /// Carries out one motion of a contour block, with the rules that all of its motions cite.
    pub(super) fn follow_contour(
        &mut self,
        leg: &Leg,
        mut cites: Cites,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let mut end = self.state.machine;
        for (axis, target) in [(X, leg.face.map(|(x, _)| x)), (Z, leg.z)] {
            if let Some(target) = target {
                end[axis] = to_machine(target, self.state.frame(axis));
                // Nothing is cut back, as in arcs (E100L-CGF-01, E100L-CGS-01).
                self.limit(axis, &mut end[axis], true)?;
            }
        }
        end[C] = turn::within(to_machine(leg.c, self.state.frame(C)));
        self.state.machine = end;
        self.state.last_motion_cut = true;
        self.state.contour.wind(leg.travel);
        let mut readings = if self.inch_block { self.known.inch } else { ReadingSet::default() };
        let motion = Motion {
            c_travel: Some(Angle(leg.travel)),
            face: leg.face.map(|(_, point)| face_point(point)),
            part: leg.part,
            ..self.motion_to_here(true, &mut cites, &mut readings)
        };
        let feed = leg.feed;
        let action = match leg.shape {
            Shape::Line(path) => Action::Linear { motion, feed, path: Length(path) },
            Shape::Arc(sense, plane) => Action::ContourArc { motion, feed, sense, plane },
        };
        let rules = self.cites.rules(cites).union(leg.rules);
        self.emit_with(sink, rules, readings, action);
        Ok(())
    }

    /// A motion to where the machine is now.
    pub(in crate::engine) fn motion_to_here(
        &mut self,
        cuts: bool,
        cites: &mut Cites,
        readings: &mut ReadingSet,
    ) -> Motion {
        let machine = self.state.machine;
        let x = self.state.program(X);
        Motion {
            program: self.position(x, self.state.program(Z), |axis| self.state.program(axis)),
            machine: self.position(self.state.machine_x(machine[X]), machine[Z], |axis| machine[axis]),
            speed: self.motion_speed(x, cuts, cites, readings),
            ..Motion::default()
        }
    }
}
