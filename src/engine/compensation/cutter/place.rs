//! Where the axes go for a point of the plane (execution of contours, 9, "Where the axes go"; E100L-CRC-10, E100L-CRC-14).

use turnspec_oracle::vocabulary::rule_ids as rules;

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::turn;
use crate::engine::compensation::waiting::undefined;
use crate::engine::contour::{Surface, diameter, direction};
use crate::engine::exact::{Formula, Real, round};
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::{Place, Plane, Programmed};

/// 360 degrees · length / (π X): the turn of C by a length on the cylinder of a diameter.
struct Turned {
    length: i64,
    diameter: i64,
}

impl Formula for Turned {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let turns = R::integer(i128::from(self.length) * i128::from(turn::TURN), precision);
        turns.over(&R::integer(self.diameter.into(), precision).times(&R::pi(precision)))
    }
}

/// A point whose coordinates have so many bits at most. On the face what is beyond 42 lies out of the range of X; on the
/// side Z alone has a range, and u may be long where parallels meet far away.
fn bounded(point: Spot, bits: u32) -> Spot {
    let most = 1_i64 << bits;
    Spot { p: point.p.clamp(-most, most), q: point.q.clamp(-most, most) }
}

impl Interpreter<'_> {
    /// The length on the cylinder of a diameter that a turn of C makes, latched.
    pub(super) fn length_around(&mut self, diameter: i64, turned: i64) -> i64 {
        if turned == 0 { 0 } else { round(&Surface { diameter, turn: turned }, &mut self.slow) }
    }

    /// Where the cutter centre is at the end of a motion, when it lies in a point of the plane.
    pub(super) fn cutter_place(
        &mut self,
        plane: Plane,
        point: Spot,
        programmed: &Programmed,
    ) -> Result<Place, Fault> {
        let of_program = programmed.place;
        if point == of_program.point {
            return Ok(of_program);
        }
        if plane == Plane::Face {
            let point = bounded(point, 42);
            if point.is_centre() && !planted::is(Bug::CutterThroughCentre) {
                return Err(undefined(rules::CRC_14, "centre"));
            }
            let c = direction(point, programmed.axis, &mut self.slow);
            return Ok(Place { point, x: diameter(point), c, ..of_program });
        }
        let point = bounded(point, 60);
        let length = plane.seen(point.p).saturating_sub(plane.seen(of_program.point.p));
        let turned = match length {
            0 => 0,
            _ => round(&Turned { length, diameter: of_program.x }, &mut self.slow),
        };
        let unwrapped = of_program.unwrapped.saturating_add(turned);
        Ok(Place { point, z: point.q, c: turn::within(unwrapped), unwrapped, ..of_program })
    }
}
