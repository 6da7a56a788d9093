//! Words of every cycle: pecks, dwells, and modes beside them.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::number::Number;
use crate::program::{Item, Word};

impl Builder<'_, '_, '_> {
    /// D for a depth, at most so many pecks; how many there are.
    pub(super) fn peck_word(&mut self, depth: i64, most: i64, items: &mut Vec<Item>) -> i64 {
        let parts = self.choices.pick(&[1, 2, 3, 4, 5, 7, 10, 23]);
        let step = match self.choices.below(8) {
            0 => depth,
            1 => depth * 2,
            2 => depth - 1_000,
            _ => depth / parts + self.choices.within(-20, 20) * 1_000,
        };
        let step = step.max(depth / most + 1).max(self.state.units.finest());
        self.amount("D", step, items)
    }

    /// L, by how much of a depth the tool withdraws, now and then.
    pub(super) fn discharge_word(&mut self, step: i64, depth: i64, items: &mut Vec<Item>) {
        if self.choices.chance(35) {
            let wanted = self.choices.pick(&[step * 2, step * 3, step, step / 2, depth, step * 2 - 1_000]);
            self.amount("L", wanted.max(self.state.units.finest()), items);
        }
    }

    /// E as a dwell, now and then.
    pub(super) fn dwell_word(&mut self, percent: usize, items: &mut Vec<Item>) {
        if !self.choices.chance(percent) || !self.allows(Feature::Dwell) {
            return;
        }
        let hundredths = self.choices.pick(&[1, 50, 100, 150, 12_345, 999_999]);
        let number = match self.state.units.dwell_unit() {
            1 => Number::whole(hundredths),
            10 => Number::decimal(hundredths, 1),
            _ => Number::decimal(hundredths, 2),
        };
        let (value, _) = self.value(number);
        items.push(Item::Word(Word { address: "E", value }));
    }

    /// Modes, S and M codes beside a groove or a tapping block.
    pub(super) fn beside_cycle(&mut self, items: &mut Vec<Item>) {
        if self.choices.chance(25) && self.allows(Feature::Absolute) && self.allows(Feature::Incremental) {
            let incremental = self.choices.chance(50);
            items.push(self.incremental_word(incremental));
        }
        if self.choices.chance(8) {
            self.feed_mode(!self.state.per_minute, items);
        }
        if self.choices.chance(12) {
            self.m_words(items, 2);
        }
    }

    /// G94 or G95, where it is not in force, with an F.
    pub(super) fn feed_mode(&mut self, per_minute: bool, items: &mut Vec<Item>) {
        if self.state.per_minute != per_minute {
            self.state.per_minute = per_minute;
            items.push(Item::g(if per_minute { 94 } else { 95 }));
            items.push(self.feed_word());
        }
    }

    /// F, where there is none yet or now and then.
    pub(super) fn cycle_feed(&mut self, percent: usize, items: &mut Vec<Item>) {
        let written = crate::companions::has(items, "F");
        if !written && (!self.state.feed || self.choices.chance(percent)) {
            items.push(self.feed_word());
        }
    }
}
