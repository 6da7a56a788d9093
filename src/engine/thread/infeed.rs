//! Along which flank the passes of a compound cycle go, and how far each is shifted (E100L-TMOD-01 to
//! E100L-TMOD-04); the choice of their depths (E100L-TINF-01).

use turnspec_oracle::vocabulary::{LeadAxis, ThreadFlank};

use crate::engine::Interpreter;
use crate::engine::exact::{Formula, Real, round};
use crate::engine::planted::{self, Bug};

/// The flank of the passes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Infeed {
    /// M32.
    Left,
    /// M33: by turns.
    Zigzag,
    /// M34.
    Right,
}

impl Infeed {
    /// The infeed of an M code.
    pub fn of(code: u16) -> Option<Self> {
        match code {
            32 => Some(Self::Left),
            33 => Some(Self::Zigzag),
            34 => Some(Self::Right),
            _ => None,
        }
    }

    /// The sign of the shift of the pass with a number, from 1.
    fn sign(self, number: i64, reading: ThreadFlank) -> i64 {
        let left = match self {
            Self::Left => true,
            Self::Zigzag => (number % 2 != 0) != planted::is(Bug::TurnsOnOtherFlank),
            Self::Right => false,
        };
        if left == (reading == ThreadFlank::Negative) { -1 } else { 1 }
    }
}

/// The infeed pattern in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Pattern {
    /// M73.
    Halving,
    /// M74.
    Steps,
    /// M75.
    Areas,
}

impl Pattern {
    /// The pattern of an M code.
    pub fn of(code: u16) -> Option<Self> {
        match code {
            73 => Some(Self::Halving),
            74 => Some(Self::Steps),
            75 => Some(Self::Areas),
            _ => None,
        }
    }
}

/// The size of the shift of a pass: rest times / over times the tangent of half the angle.
struct Shift {
    rest: i64,
    times: i128,
    over: i128,
    half_angle: i64,
}

impl Formula for Shift {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let (sine, cosine) = R::sine_cosine(self.half_angle, precision);
        integer(i128::from(self.rest) * self.times).times(&sine).over(&cosine.times(&integer(self.over)))
    }
}

impl Interpreter<'_> {
    /// The shift of a pass along the lead axis, by the depth that is left below it and the infeed angle, which is
    /// less than 180 degrees.
    pub(super) fn flank_shift(&mut self, axis: LeadAxis, rest: i64, angle: i64, number: i64) -> i64 {
        const SQUARE: i64 = 90_000_000;
        if rest == 0 || angle == 0 {
            return 0;
        }
        let across = if planted::is(Bug::FlankOnRadius) { (1, 1) } else { (2, 1) };
        let (times, over) = if axis == LeadAxis::Z { (1, 2) } else { across };
        let size = match angle {
            // The only angle whose half has a rational tangent, which is 1.
            SQUARE if axis == LeadAxis::Z => rest / 2 + rest % 2,
            SQUARE => rest * 2,
            _ => round(&Shift { rest, times, over, half_angle: angle / 2 }, &mut self.slow),
        };
        size * self.state.thread.infeed.sign(number, self.setup.readings.thread_flank)
    }
}
