//! What the sides share (E100L-AX4-08, E100L-AX4-11): the main spindle, and the turret that G96 looks at.

use crate::controls::e100l::g_codes::GGroup;
use crate::state::{SpindleStore, State};
use crate::vocabulary::Side;

/// A saddle as one of two.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Saddle {
    /// Which one.
    pub side: Side,
    /// Whether there is nobody to wait for: the end of the other side has released it, or the other one has no block
    /// (E100L-PSYNC-04, E100L-M100-03, E100L-AX4-07).
    pub alone: bool,
    /// Where the other saddle stands: X in its program coordinates.
    pub other_x: i64,
}

impl State<'_> {
    /// E100L-AX4-11: the spindle is as the other side has left it. All the rest is each side's own.
    pub fn take_common(&mut self, other: &State) {
        for group in [GGroup::CuttingSpeed, GGroup::CssTurret] {
            self.modes.set(group, other.modes.get(group));
        }
        for group in ["spindle", "gear"] {
            if let Some(code) = other.active(group) {
                self.activate(code);
            }
        }
        let SpindleStore { main, started_with, speed, surface, clamp, .. } = other.spindle;
        self.spindle = SpindleStore { main, started_with, speed, surface, clamp, ..self.spindle };
    }

    /// Says whether there is nobody to wait for.
    pub fn set_alone(&mut self, alone: bool) {
        if let Some(saddle) = &mut self.saddle {
            saddle.alone = alone;
        }
    }

    /// Says where the other saddle stands.
    pub fn see_other_at(&mut self, x: i64) {
        if let Some(saddle) = &mut self.saddle {
            saddle.other_x = x;
        }
    }

    /// Whether a side waits for the other one at P and M100.
    pub fn waits(&self) -> bool {
        self.saddle.is_some_and(|saddle| !saddle.alone)
    }

    /// E100L-AX4-08: whether G96 takes the X of this saddle; of two turrets on one saddle it does of the one that is
    /// selected (E100L-MIRR-19).
    pub fn is_reference(&self) -> bool {
        let reference = if self.modes.get(GGroup::CssTurret) == 111 { Side::B } else { Side::A };
        self.saddle.is_none_or(|saddle| saddle.side == reference)
    }

    /// The present program diameter that G96 takes.
    pub fn reference_x(&self) -> i64 {
        match self.saddle {
            Some(saddle) if !self.is_reference() => saddle.other_x,
            _ => self.frame.program().x,
        }
    }
}
