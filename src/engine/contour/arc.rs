//! Arcs in the planes of contour generation: the centre by radius (execution of contours, 4; E100L-CGF-04,
//! E100L-CGS-04).

use turnspec_oracle::vocabulary::{AlarmName, RuleId, Sense};

use crate::engine::arithmetic::contour::{Spot, half, square, way};
use crate::engine::arithmetic::root::narrow;
use crate::engine::exact::{Formula, Real, SlowPaths, round};
use crate::engine::fault::Fault;

use super::chord::Chord;
use super::unspecified;

/// An arc with its latched ends, its radius and sense, and the exact distance of its ends.
pub struct Arc {
    pub start: Spot,
    pub end: Spot,
    pub chord: Chord,
    pub radius: i64,
    pub sense: Sense,
    /// The rule that its alarms cite.
    pub rule: RuleId,
}

/// (sum + across / root(square)) / 2: a coordinate of the centre.
struct CentreCoordinate {
    sum: i128,
    across: i128,
    square: i128,
}

impl Formula for CentreCoordinate {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let aside = integer(self.across).over(&integer(self.square).root());
        integer(self.sum).plus(&aside).over(&integer(2))
    }
}

impl Arc {
    /// Its centre, latched.
    pub fn centre(&self, slow: &mut SlowPaths) -> Result<Spot, Fault> {
        if self.start == self.end {
            return Err(unspecified(self.rule, "circle"));
        }
        let Some(height) = self.chord.height(self.radius, slow) else {
            return Fault::raise(AlarmName::ArcRadiusTooSmall, self.rule);
        };
        let chord = way(self.start, self.end);
        let square = square(chord);
        // To the left of the chord counter-clockwise, to its right clockwise.
        let side = if self.sense == Sense::CounterClockwise { 2 } else { -2 };
        let mut coordinate = |start: i64, end: i64, left: i64| {
            let sum = i128::from(start) + i128::from(end);
            let across = side * i128::from(height) * i128::from(left);
            if across == 0 {
                narrow(half(sum))
            } else {
                round(&CentreCoordinate { sum, across, square }, slow)
            }
        };
        Ok(Spot {
            p: coordinate(self.start.p, self.end.p, chord.q.saturating_neg()),
            q: coordinate(self.start.q, self.end.q, chord.p),
        })
    }
}
