//! G77 and G78: taps in the main spindle.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::program::{Item, Line};
use crate::state::{Axis, Mode};

impl Builder<'_, '_, '_> {
    /// Blocks of G77 or G78, or grooves where the spindle may not turn.
    pub(super) fn taps(&mut self) {
        if !self.allows(Feature::Spindle) || !self.ready_for_threads() {
            return self.grooves();
        }
        if self.choices.chance(60) {
            let point = [Axis::X, Axis::Z].map(|axis| self.state.somewhere(axis, self.choices));
            self.position(point);
        }
        for _ in 0..=self.choices.below(2) {
            if !self.attempt(Self::tapping_block) {
                self.begin();
                return self.line(Mode::Rapid);
            }
        }
    }

    /// Brings the code of the first block from this line on to its beginning, where it has to stand (E100L-TAP-01).
    fn code_first(&mut self, at: usize) {
        let is_code = |item: &Item| matches!(item, Item::Word(word) if word.is_g(&[77, 78]));
        let block = self.lines.iter_mut().skip(at).find_map(|line| match line {
            Line::Block(block) if block.items.iter().any(is_code) => Some(block),
            _ => None,
        });
        if let Some(block) = block {
            block.items.sort_by_key(|item| !is_code(item));
        }
    }

    /// A block of G77 or G78; false where the control would refuse it.
    fn tapping_block(&mut self) -> bool {
        let mut items = vec![Item::g(self.choices.pick(&[77, 78]))];
        if self.choices.chance(25) && self.allows(Feature::Absolute) && self.allows(Feature::Incremental) {
            let incremental = self.choices.chance(50);
            items.push(self.incremental_word(incremental));
        }
        let (x, z) = (self.state.program(Axis::X), self.state.program(Axis::Z));
        let wanted = if self.choices.chance(50) { x } else { self.state.somewhere(Axis::X, self.choices) };
        let (x_item, x) = self.target(Axis::X, wanted);
        let wanted = self.coordinate_from(Axis::Z, z, 1_000_000, 40_000_000);
        let (z_item, bottom) = self.target(Axis::Z, wanted);
        items.extend([x_item, z_item]);
        let travel = (bottom - z).abs();
        let wanted = self.choices.pick(&[0, travel / 10, travel / 3, travel - 1_000]) / 1_000 * 1_000;
        let approach = self.amount("K", wanted, &mut items);
        if approach < 0 || travel <= approach {
            return false;
        }
        let speed = self.choices.pick(&[200, 500, 1, 65_535]);
        self.state.threads.note_speed(false, speed);
        items.push(self.whole("S", speed));
        self.cycle_feed(25, &mut items);
        let near = z + (bottom - z).signum() * approach;
        let goes = self.move_axis(Mode::Rapid, Axis::X, x) && self.plunge(Axis::Z, [near, bottom, z]);
        self.note_turning(5);
        self.state.after_cutting = false;
        if goes {
            let at = self.lines.len();
            self.push(items);
            self.code_first(at);
        }
        goes
    }
}
