//! Holes in conversion mode: their places are points by X and Y (E100L-CSC-09).

use super::has_driven;
use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// The cycles that go there.
const HOLES: &[i64] = &[181, 182, 183, 184, 189, 178, 179];

impl Builder<'_, '_, '_> {
    /// Whether conversion mode is in force.
    pub(super) fn converts(&self) -> bool {
        self.state.contours.converts()
    }

    /// Whether holes may be drilled in conversion mode.
    pub(crate) fn may_drill_points(&self) -> bool {
        has_driven(&self.profile) && !self.state.control.steady && !self.state.incremental
    }

    /// A run of a hole cycle by X and Y, to the block behind G180 or behind G136; false where none can be.
    pub(crate) fn holes_at_points(&mut self) -> bool {
        let code = self.choices.pick(HOLES);
        if self.state.is_eia() && self.is_synchronised(code) {
            return false;
        }
        self.speeds_of_cycle(code);
        if !self.attempt(|builder| builder.first_hole(code)) {
            return false;
        }
        self.rest_of_cycle();
        let point = [Axis::X, Axis::Z].map(|axis| self.state.somewhere(axis, self.choices));
        if self.choices.chance(35) {
            self.end_conversion();
            self.position(point);
        } else {
            self.leave_by_point(point[1]);
        }
        true
    }

    /// X and Y of a point within the limits, one of them where the other is kept; the axes do not move yet, but for C.
    pub(super) fn place_by_point(&mut self, items: &mut Vec<Item>) -> i64 {
        let kept = self.state.kept_point();
        let either = self.choices.below(3);
        let chosen = [0, 1].map(|place| kept.is_none() || either != place);
        let wanted = if self.choices.chance(3) { [0, 0] } else { self.some_point() };
        let (words, point) = self.point_words(wanted, kept.unwrap_or_default(), chosen);
        items.extend(words);
        self.keep_point(point)
    }

    /// The positioning behind a cycle, with X and Z.
    fn leave_by_point(&mut self, wanted: i64) {
        self.begin();
        let mut items = Vec::new();
        self.select(Mode::Rapid, &mut items);
        let kept = self.state.kept_point();
        let chosen = [true, kept.is_none() || self.choices.chance(60)];
        let point = self.some_point();
        let (words, point) = self.point_words(point, kept.unwrap_or_default(), chosen);
        items.extend(words);
        let (item, z) = self.target(Axis::Z, wanted);
        items.push(item);
        self.state.move_to(Axis::Z, z);
        self.move_to_point(point);
        self.state.after_cutting = false;
        self.push(items);
    }
}
