//! Positioning and lines: G00, G01, with C, W, QA and the direct taper angle A.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

impl Builder<'_, '_, '_> {
    /// Selects a motion mode, in writing where that is needed and sometimes where it is not.
    pub(crate) fn select(&mut self, mode: Mode, items: &mut Vec<Item>) {
        if self.state.mode != mode || self.choices.chance(25) {
            let place = if self.choices.chance(80) { 0 } else { items.len() };
            items.insert(place, Item::g(mode as i64));
        }
        self.state.mode = mode;
    }

    /// A block of G00 or G01.
    pub(crate) fn line(&mut self, mode: Mode) {
        let mut items = Vec::new();
        self.companions(&mut items);
        if mode == Mode::Rapid
            && self.choices.chance(4)
            && self.may_index(mode)
            && self.allows(Feature::Turret)
        {
            items.extend([Item::g(0), Item::m(203)]);
        } else {
            self.select(mode, &mut items);
        }
        self.state.mode = mode;
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        self.line_words(&mut items);
        self.travelled_by(&items, from);
        self.state.after_cutting = mode == Mode::Linear;
        self.program_stop(&mut items);
        self.push(items);
    }

    /// Whether M203 in a block of this mode finds the turret clamped (E100L-TUNC-02).
    fn may_index(&self, mode: Mode) -> bool {
        let once = !self.state.control.steady;
        mode == Mode::Rapid
            && once
            && (self.state.setup.inputs.turret_clamp_confirmed || !self.state.after_cutting)
    }

    /// The coordinate words of a line; moves the state.
    pub(crate) fn line_words(&mut self, items: &mut Vec<Item>) {
        let may_turn = self.state.joined && !self.state.clamped;
        let (mut x, mut z) = (self.choices.chance(70), self.choices.chance(70));
        let steady = self.state.control.steady;
        let c = may_turn && !steady && self.choices.chance(50);
        let w = self.state.setup.options.w_axis && !steady && self.choices.chance(25);
        if !(x || z || c || w) {
            (x, z) = (true, self.choices.chance(50));
        }
        for (axis, chosen) in [(Axis::X, x), (Axis::Z, z), (Axis::W, w)] {
            if chosen {
                self.axis_word(axis, items);
            }
        }
        if c {
            self.c_words(items);
        }
    }

    /// A coordinate word of one axis; moves the state. Now and then on a positive limit or beyond it.
    pub(crate) fn axis_word(&mut self, axis: Axis, items: &mut Vec<Item>) {
        let mut wanted = self.state.somewhere(axis, self.choices);
        if let Some(limit) = self.state.limits[axis as usize].positive
            && !self.state.compensation.is_on()
            && !self.state.control.steady
            && self.choices.chance(5)
        {
            let beyond = if self.choices.chance(30) { 0 } else { self.choices.within(0, 50_000) * 1_000 };
            wanted = self.state.sign(axis) * (limit.0 + beyond) - self.state.frame(axis);
        }
        let (item, target) = self.target(axis, wanted);
        items.push(item);
        self.state.move_to(axis, target);
    }

    /// C, QA or both.
    pub(crate) fn c_words(&mut self, items: &mut Vec<Item>) {
        let extended = !self.state.is_eia() && self.choices.chance(20);
        if extended {
            let turns = self.choices.pick(&[1, 2, 5, 1999]);
            items.push(self.whole("QA", turns));
        }
        if !extended || self.choices.chance(60) {
            let grid = self.choices.pick(&[10_000_000, 1_000_000, 1_000]);
            let wanted = self.choices.within(-359_999_000 / grid, 359_999_000 / grid) * grid;
            let (item, angle) = self.angle("C", wanted);
            let base = if self.state.incremental { self.state.program_c() } else { 0 };
            self.state.c = (base + angle + self.state.c_offset + self.state.c_shift).rem_euclid(360_000_000);
            items.push(item);
        }
    }

    /// M00 or M01 in a motion block, rarely.
    fn program_stop(&mut self, items: &mut Vec<Item>) {
        if self.choices.chance(2) && self.allows(Feature::OptionalStop) {
            items.push(Item::m(self.choices.within(0, 1)));
        }
    }

    /// A block of G00 or G01 with A and one coordinate, or a line when no angle fits.
    pub(crate) fn taper(&mut self) {
        let mode = if self.choices.chance(20) { Mode::Rapid } else { Mode::Linear };
        let mut items = Vec::new();
        self.companions(&mut items);
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let base = self.present();
        let wanted = self.somewhere_near(base);
        match self.inclined(base, wanted) {
            Some((words, end)) => {
                items.extend(words);
                self.state.move_to(Axis::X, end.diameter());
                self.state.move_to(Axis::Z, end.coordinate());
            }
            None => self.line_words(&mut items),
        }
        self.travelled_by(&items, base);
        self.state.after_cutting = mode == Mode::Linear;
        self.push(items);
    }
}
