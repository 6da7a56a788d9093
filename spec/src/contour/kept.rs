//! What contours and coordinate conversion keep from one block to the next.

use super::plane::PlanePoint;
use crate::frame::Frame;
use crate::integer::turn::FULL_TURN;
use crate::vocabulary::Setup;

/// E100L-CGS-06: how far the C axis may be wound, in micro-degrees.
const LONGEST_WAY: u128 = 5_965 * FULL_TURN.unsigned_abs() as u128;

/// What goes on in the next block.
#[derive(Clone, Default, Debug)]
pub struct Kept {
    /// θ, the direction of +X in conversion mode, in micro-degrees of a full turn (E100L-CSC-01). Nothing asks for it out
    /// of that mode, nor for the point.
    pub direction: i64,
    /// The point that the last block with X or Y in conversion mode has programmed.
    point: Option<KeptPoint>,
    /// The travels of C since it was joined or, in the mode of the side, since G119 (E100L-CGS-06). A travel is below 2^40
    /// and the blocks of a run are below 2^64.
    wound: i128,
}

/// A point in conversion mode, and what it became (E100L-CSC-06).
#[derive(Clone, Copy, Debug)]
struct KeptPoint {
    point: PlanePoint,
    x: i64,
    c: i64,
    /// The C amount of the zero shift then.
    shift: i64,
}

impl Kept {
    /// E100L-CSC-01: conversion mode begins, anew if it was in force.
    pub fn begin_conversion(&mut self, direction: i64) {
        self.direction = direction;
        self.point = None;
    }

    /// Whether a block has given a point since it began (E100L-CSC-06, E100L-CSC-08).
    pub fn has_point(&self) -> bool {
        self.point.is_some()
    }

    /// A block with X or Y has programmed a point, which is this program X and C.
    pub fn keep(&mut self, point: PlanePoint, x: i64, c: i64, frame: &Frame) {
        self.point = Some(KeptPoint { point, x, c, shift: frame.zero_shift.c });
    }

    /// E100L-CSC-06: the point that was programmed last, if the axes stand there, with the same zero shift of C.
    pub fn point(&self, frame: &Frame) -> Option<PlanePoint> {
        let present = frame.program();
        let now = (present.x, present.c, frame.zero_shift.c);
        self.point.filter(|kept| (kept.x, kept.c, kept.shift) == now).map(|kept| kept.point)
    }

    /// A G code is carried out. E100L-CGS-06, E100L-CGS-07: in the mode of the side G119 counts the turns anew.
    pub fn select(&mut self, code: u16, setup: &Setup) {
        if code == 119 && setup.parameters.side_contour_mode {
            self.wound = 0;
        }
    }

    /// An M code is carried out. E100L-CGS-06: M110 counts the turns anew.
    pub fn command(&mut self, code: u16) {
        if code == 110 {
            self.wound = 0;
        }
    }

    /// C travels with a motion.
    pub fn wind(&mut self, travel: Option<i64>) {
        self.wound += i128::from(travel.unwrap_or(0));
    }

    /// E100L-CGS-06: whether a travel would wind C too far.
    pub fn is_too_far(&self, travel: i64) -> bool {
        (self.wound + i128::from(travel)).unsigned_abs() > LONGEST_WAY
    }
}
