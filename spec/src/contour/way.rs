//! Where a block of the face leads from and to, and how both ends lie about the centre.

use super::plane::PlanePoint;
use super::position;
use crate::fault::{Fault, Outcome};
use crate::integer::turn;
use crate::modal::Plan;
use crate::state::State;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// An end of the way.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct End {
    /// As a point of the face.
    pub point: PlanePoint,
    /// Program X.
    pub x: i64,
    /// Program C, in a full turn.
    pub c: i64,
    /// Whether it is the centre of the face.
    pub is_centre: bool,
}

/// The way of a face block.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// Where it starts.
    pub start: End,
    /// Where it ends.
    pub end: End,
    /// Where Z starts and ends.
    pub z: (i64, i64),
    /// Whose it is, which tells what its rays are told from.
    pub of: Whose,
}

/// Whose a way is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Whose {
    /// A block's with X and C: its angles count.
    Axes,
    /// A block's with X and Y: its points count.
    Points,
    /// That of a cutter centre in compensation: its points count, and its length is theirs (E100L-CRC-14).
    Cutter,
}

/// How the end lies, seen from the centre, to the start; neither is the centre.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bearing {
    /// On the same ray.
    Same,
    /// On the opposite ray.
    Opposite,
    /// Forward, by less than half a turn of C.
    Forward,
    /// Backward.
    Backward,
}

impl End {
    fn of_axes(x: i64, c: i64) -> Self {
        Self { point: PlanePoint::at(x, c), x, c, is_centre: x == 0 }
    }

    /// A point of the face, with its program X and C.
    pub fn of_point(point: PlanePoint, (x, c): (i64, i64)) -> Self {
        Self { point, x, c, is_centre: point == PlanePoint::CENTRE }
    }
}

impl Way {
    /// The way of a block.
    pub fn of(plan: &Plan, state: &State) -> Outcome<Self> {
        let present = state.frame.program();
        let target = |letter, present: i64| match plan.words.get(letter) {
            None => present,
            Some(word) if plan.modes.incremental() => present + word,
            Some(word) => word,
        };
        let z = (present.z, target('Z', present.z));
        if !plan.converts {
            let c = turn::within(target('C', present.c));
            let (start, end) = (End::of_axes(present.x, present.c), End::of_axes(target('X', present.x), c));
            return Ok(Self { start, end, z, of: Whose::Axes });
        }
        // E100L-CGF-14: from the point that was programmed.
        let kept = state.contour.point(&state.frame);
        let (Some(from), Some(to)) = (kept, position::target(plan, kept)) else {
            return Err(Fault::about(AlarmName::Unspecified, CGF_14, "start"));
        };
        let start = End::of_point(from, (present.x, present.c));
        Ok(Self { start, end: End::of_point(to, position::axes(to, state)), z, of: Whose::Points })
    }

    /// E100L-CGF-06, E100L-CGF-14: decided by the programmed points in conversion mode, else by the angles; of a cutter by
    /// the points of its centre.
    pub fn bearing(&self) -> Bearing {
        let (start, end) = (self.start.point, self.end.point);
        let (cross, dot) = (start.cross(end), start.dot(end));
        let half = turn::FULL_TURN / 2;
        match (self.of == Whose::Axes, self.turn(true)) {
            (true, 0) => Bearing::Same,
            (true, forward) if forward == half => Bearing::Opposite,
            (true, forward) if forward < half => Bearing::Forward,
            (true, _) => Bearing::Backward,
            (false, _) if cross > 0 => Bearing::Forward,
            (false, _) if cross < 0 => Bearing::Backward,
            (false, _) if dot > 0 => Bearing::Same,
            (false, _) => Bearing::Opposite,
        }
    }

    /// The positive or the negative turn from start to end.
    pub fn turn(&self, positive: bool) -> i64 {
        turn::travel(self.start.c, self.end.c, 0, positive)
    }

    /// The turn on the side of the chord, by less than half a turn. Of a cutter centre the C of one end may have been
    /// programmed and that of the other computed: on nearly the same ray the points tell the side (E100L-CRC-14).
    pub fn beside(&self, positive: bool) -> i64 {
        match self.of {
            Whose::Cutter => turn::beside(self.start.c, self.end.c, positive),
            Whose::Axes | Whose::Points => self.turn(positive),
        }
    }

    /// The turn round the centre on the other side of the chord, by more than half a turn; likewise.
    pub fn around(&self, positive: bool) -> i64 {
        match self.of {
            Whose::Cutter => turn::around(self.start.c, self.end.c, positive),
            Whose::Axes | Whose::Points => self.turn(positive),
        }
    }

    /// E100L-CGF-10: the shorter turn, the positive one of 180 degrees.
    pub fn shorter(&self) -> i64 {
        let forward = self.turn(true);
        if forward <= turn::FULL_TURN / 2 { forward } else { self.turn(false) }
    }
}
