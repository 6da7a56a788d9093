//! The axis along which a cycle cuts, and the other one (execution of drilling, "Names").

use turnspec_oracle::vocabulary::LeadAxis;

use crate::engine::arithmetic::plane::Point;
use crate::engine::state;
use crate::engine::words::Address;

/// X or Z.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axis {
    X,
    Z,
}

impl Axis {
    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Self::X => Self::Z,
            Self::Z => Self::X,
        }
    }

    /// The coordinate of a point.
    pub fn of(self, point: Point) -> i64 {
        match self {
            Self::X => point.x,
            Self::Z => point.z,
        }
    }

    /// A point with another coordinate.
    pub fn put(self, point: Point, coordinate: i64) -> Point {
        match self {
            Self::X => Point { x: coordinate, ..point },
            Self::Z => Point { z: coordinate, ..point },
        }
    }

    /// The address of its coordinate.
    pub fn word(self) -> Address {
        match self {
            Self::X => Address::X,
            Self::Z => Address::Z,
        }
    }

    /// The address of an amount along it.
    pub fn amount(self) -> Address {
        match self {
            Self::X => Address::I,
            Self::Z => Address::K,
        }
    }

    /// Its place among the amounts of the state.
    pub fn place(self) -> usize {
        match self {
            Self::X => state::X,
            Self::Z => state::Z,
        }
    }

    /// As the axis of a lead.
    pub fn lead(self) -> LeadAxis {
        match self {
            Self::X => LeadAxis::X,
            Self::Z => LeadAxis::Z,
        }
    }
}
