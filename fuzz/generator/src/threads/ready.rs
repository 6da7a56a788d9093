//! What a thread needs of the modes: blocks that allow it, and the way to its cycle start.

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode, State};

impl State {
    /// Whether the modes allow a thread here.
    pub(crate) fn may_cut_threads(&self) -> bool {
        !(self.compensation.is_on() || self.compensation.left_over || self.joined || self.cutting_speed)
    }
}

impl Builder<'_, '_, '_> {
    /// Ends what would forbid a thread, a block at a time; false where that cannot be.
    pub(crate) fn ready_for_threads(&mut self) -> bool {
        let steady = self.state.control.steady;
        if self.state.compensation.left_over && !self.state.compensation.is_on() {
            self.line(Mode::Rapid);
            self.begin();
        }
        if self.state.joined && !steady {
            (self.state.joined, self.state.plane) = (false, 18);
            self.push(vec![Item::m(109)]);
            self.begin();
        }
        if self.state.cutting_speed && !steady {
            self.state.cutting_speed = false;
            let speed = self.spindle_speed();
            self.push(vec![Item::g(97), speed]);
            self.begin();
        }
        self.state.may_cut_threads()
    }

    /// A positioning to program coordinates X and Z.
    pub(crate) fn position(&mut self, point: [i64; 2]) {
        self.begin();
        let mut items = Vec::new();
        let mode = if self.choices.chance(85) { Mode::Rapid } else { Mode::Linear };
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        for (axis, wanted) in [Axis::X, Axis::Z].into_iter().zip(point) {
            let (item, target) = self.target(axis, wanted);
            items.push(item);
            self.state.move_to(axis, target);
        }
        self.travelled(from, self.present(), None);
        self.state.after_cutting = mode == Mode::Linear;
        self.push(items);
    }

    /// A program coordinate of an axis at some distance from another one, within the limits; now and then at one.
    pub(crate) fn coordinate_from(&mut self, axis: Axis, from: i64, least: i64, most: i64) -> i64 {
        let (low, high) = self.state.window(axis);
        if self.choices.chance(6) {
            return if (from > low) == self.choices.chance(50) { low } else { high };
        }
        let grid = self.choices.pick(&[1_000_000, 100_000, 1_000]);
        let away = self.choices.within((least + grid - 1) / grid, most / grid) * grid;
        let up = self.choices.chance(35);
        let (one, other) = if up { (from + away, from - away) } else { (from - away, from + away) };
        if (low..=high).contains(&one) { one } else { other }
    }
}
