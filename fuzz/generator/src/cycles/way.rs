//! Motions of a cycle, and whether the control would refuse one.

use crate::builder::Builder;
use crate::geometry::Point;
use crate::state::{Axis, Mode, State};

impl State {
    /// The program coordinate, as it is now, of a machine coordinate.
    pub(super) fn program_of(&self, axis: Axis, machine: i64) -> i64 {
        self.sign(axis) * machine - self.frame(axis)
    }
}

impl Builder<'_, '_, '_> {
    /// Moves to program coordinates X and Z; false where a limit refuses it.
    pub(super) fn move_both(&mut self, mode: Mode, [x, z]: [i64; 2]) -> bool {
        let (from, selected) = (self.present(), self.state.mode);
        let refused = |axis: Axis, target: i64| {
            target != self.state.program(axis)
                && !(self.state.fits(axis, target) && target.abs() < 90_000_000_000)
        };
        if refused(Axis::X, x) || refused(Axis::Z, z) {
            return false;
        }
        self.state.mode = mode;
        self.state.control.note_way([x, z]);
        self.watch(from, Point::of(x, z), None);
        self.state.mode = selected;
        self.state.move_to(Axis::X, x);
        self.state.move_to(Axis::Z, z);
        true
    }

    /// Moves one axis to a program coordinate; false where a limit refuses it.
    pub(super) fn move_axis(&mut self, mode: Mode, axis: Axis, target: i64) -> bool {
        let mut place = [Axis::X, Axis::Z].map(|axis| self.state.program(axis));
        place[axis as usize] = target;
        self.move_both(mode, place)
    }

    /// Goes with rapid motion and cuts: to a level, to the bottom, and back to a level.
    pub(super) fn plunge(&mut self, axis: Axis, [start, bottom, back]: [i64; 3]) -> bool {
        self.move_axis(Mode::Rapid, axis, start)
            && self.move_axis(Mode::Linear, axis, bottom)
            && self.move_axis(Mode::Rapid, axis, back)
    }
}
