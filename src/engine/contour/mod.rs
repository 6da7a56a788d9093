//! Contour generation on face and side, G101 to G103, G132 and G133, and coordinate conversion, G136 and G137
//! (execution of contours): what they remember from block to block, and which words belong to them.

mod arc;
mod check;
mod chord;
mod convert;
mod face;
mod line;
mod mode;
mod motion;
mod plane;
mod position;
mod side;

pub use face::{Course, check_diameters};
pub use line::Lines;
pub use motion::{Shape, face_point, word_cites};
pub use plane::{diameter, direction};
pub use side::Surface;

use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId, Sense, Sink};

use super::Interpreter;
use super::arithmetic::contour::Spot;
use super::fault::Fault;
use super::words::{Address, Words};

/// The motion mode after G137, until a code of the group is written (E100L-CSC-05).
pub const NO_CODE: u16 = u16::MAX;

/// Whether a motion mode is that of contours on the face.
pub fn is_face_mode(motion: u16) -> bool {
    matches!(motion, 101..=103)
}

/// Whether a motion mode cuts contours of the C axis.
#[inline]
pub fn is_mode(motion: u16) -> bool {
    matches!(motion, 101..=103 | 132 | 133)
}

/// The sense of an arc in its plane: that of its code.
pub fn sense(motion: u16) -> Sense {
    if matches!(motion, 103 | 133) { Sense::CounterClockwise } else { Sense::Clockwise }
}

/// The coordinates of conversion mode.
pub const POINT: u64 = Address::set(&[Address::X, Address::Y]);
/// The words, other than those of the axes, that make a contour block of a block in a contour mode.
pub const WORDS: u64 = Address::set(&[Address::L]);
/// The words that G137 takes.
pub const START_TAKES: u64 = Address::set(&[Address::C]);

/// The words that a block without one-shot code takes, in a contour mode, in conversion mode or without a motion code.
pub fn takes(motion: u16, converted: bool) -> u64 {
    const LINE: u64 = Address::set(&[Address::X, Address::Z, Address::C]);
    const POSITION: u64 = Address::set(&[Address::X, Address::Y, Address::Z, Address::W]);
    const POINT_LINE: u64 = Address::set(&[Address::X, Address::Y, Address::Z]);
    const ARC: u64 = Address::set(&[Address::X, Address::C, Address::L]);
    const POINT_ARC: u64 = Address::set(&[Address::X, Address::Y, Address::L]);
    const SIDE: u64 = Address::set(&[Address::X, Address::Z, Address::C, Address::L]);
    match (motion, converted) {
        (101, false) => LINE,
        (101, true) => POINT_LINE,
        (102 | 103, false) => ARC,
        (102 | 103, true) => POINT_ARC,
        (132 | 133, _) => SIDE,
        (0 | 1, true) => POSITION,
        _ => 0,
    }
}

/// A point of the face, and the program X and C there.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Station {
    pub point: Spot,
    pub x: i64,
    pub c: i64,
}

/// Coordinate conversion in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Conversion {
    /// Where the first axis lies, in micro-degrees within a turn.
    angle: i64,
    /// The point that the last block has programmed, and the zero shift of C then; none before the first one.
    kept: Option<(Station, i64)>,
}

/// What contour generation and coordinate conversion remember.
#[derive(Clone, Copy, Debug, Default)]
pub struct Kept {
    /// G137.
    conversion: Option<Conversion>,
    /// The sum of all travels of C since M110, or since G119 (E100L-CGS-06).
    wound: i128,
    /// The point of the face that was computed last, with its diameter and angle.
    last: Option<(i64, i64, Spot)>,
}

impl Kept {
    /// Whether G137 is in force.
    #[inline]
    pub fn converts(&self) -> bool {
        self.conversion.is_some()
    }

    /// C has travelled.
    #[inline]
    pub fn wind(&mut self, travel: i64) {
        self.wound += i128::from(travel);
    }

    /// The turns of C are counted anew.
    pub fn unwind(&mut self) {
        self.wound = 0;
    }
}

impl Interpreter<'_> {
    /// A block in a contour mode that has a word of the contour.
    pub(super) fn cut_contour(
        &mut self,
        words: &Words,
        motion: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.state.base = None;
        if is_face_mode(motion) {
            self.face_contour(words, motion, sink)
        } else {
            self.side_contour(words, motion, sink)
        }
    }
}

#[cold]
pub fn unspecified(rule: RuleId, what: &str) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, Label::new(what))
}

#[cfg(test)]
mod tests;
