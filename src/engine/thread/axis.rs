//! The axis of the lead and the other one: points and lengths along them (execution of threads, "Names").

use turnspec_oracle::vocabulary::{FeedLength, LeadAxis};

use crate::engine::arithmetic::lead_axis::{halves, twice_length};
use crate::engine::arithmetic::plane::Point;

/// The lead axis, and how lengths along X count.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    pub lead: LeadAxis,
    pub reading: FeedLength,
}

impl Axes {
    /// The point with a coordinate on the lead axis and one on the other axis.
    pub fn point(self, lead: i64, level: i64) -> Point {
        match self.lead {
            LeadAxis::Z => Point { x: level, z: lead },
            LeadAxis::X => Point { x: lead, z: level },
        }
    }

    /// The coordinates of a point on the lead axis and on the other axis.
    pub fn split(self, point: Point) -> (i64, i64) {
        match self.lead {
            LeadAxis::Z => (point.z, point.x),
            LeadAxis::X => (point.x, point.z),
        }
    }

    /// How many coordinates make a length of two along the lead axis: a radius is half a diameter.
    pub fn lead_halves(self) -> i128 {
        halves(self.lead == LeadAxis::X, self.reading)
    }

    /// The same of the other axis.
    pub fn level_halves(self) -> i128 {
        halves(self.lead == LeadAxis::Z, self.reading)
    }

    /// Twice the length between two coordinates of the lead axis (E100L-G32-03), in nanometres; at most 2^65.
    pub fn twice_length(self, from: i64, to: i64) -> i128 {
        twice_length(from, to, self.lead_halves())
    }
}
