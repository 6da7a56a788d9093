//! Chains of G34 and G35: lengths of thread from point to point.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// Whether it is a mode of lengths.
pub(super) fn is_length(mode: Mode) -> bool {
    matches!(mode, Mode::GrowingThread | Mode::ShrinkingThread)
}

impl Builder<'_, '_, '_> {
    /// A few lengths, with a positioning in front of them.
    pub(super) fn chain_of_threads(&mut self) {
        if self.choices.chance(50) {
            let point = [Axis::X, Axis::Z].map(|axis| self.state.somewhere(axis, self.choices));
            self.position(point);
        }
        for _ in 0..=self.choices.below(4) {
            let open = self.may_be_open() && self.choices.chance(30);
            if !self.attempt(if open { Self::open_lengths } else { Self::length_of_thread }) {
                self.begin();
                return self.line(Mode::Rapid);
            }
        }
    }

    /// A block of G34 or G35.
    fn length_of_thread(&mut self) -> bool {
        let mut items = Vec::new();
        self.beside_thread(&mut items);
        let along_x = self.lead_axis(&mut items);
        let chained = is_length(self.state.mode);
        let code = self.choices.pick(&[34, 35]);
        if self.state.mode != Mode::of_thread(code) || self.choices.chance(25) {
            items.insert(0, Item::g(code));
        }
        let begins = !(chained && self.state.threads.chain);
        let base = self.present();
        let Some((words, end)) = self.target_of_length(base, along_x) else { return false };
        items.extend(words);
        let lead = self.lead_words(&mut items);
        let length = if along_x {
            self.state.along(true, base.diameter(), end.diameter())
        } else {
            self.state.along(false, base.coordinate(), end.coordinate())
        };
        if length < 1_000.0 {
            return false;
        }
        if self.choices.chance(35) {
            let sign = if code == 34 { 1.0 } else { -1.0 };
            self.change_word(lead, length, Some(sign), &mut items);
        }
        if self.choices.chance(if begins { 35 } else { 12 }) {
            self.start_angle(&mut items);
        }
        self.state.mode = Mode::of_thread(code);
        self.state.threads.chain = true;
        self.state.move_to(Axis::X, end.diameter());
        self.state.move_to(Axis::Z, end.coordinate());
        self.travelled(base, end, None);
        self.state.after_cutting = true;
        self.push(items);
        true
    }

    /// M27, or M26 now and then; whether the lead is that along X.
    pub(super) fn lead_axis(&mut self, items: &mut Vec<Item>) -> bool {
        let along_x = self.choices.chance(22) && self.allows(Feature::Aux);
        if along_x || self.choices.chance(5) && self.allows(Feature::Aux) {
            items.push(Item::m(if along_x { 27 } else { 26 }));
        }
        along_x
    }

    /// Words of a target that travels along the lead axis.
    fn target_of_length(&mut self, base: Point, along_x: bool) -> Option<(Vec<Item>, Point)> {
        let lead_axis = if along_x { Axis::X } else { Axis::Z };
        let other_axis = if along_x { Axis::Z } else { Axis::X };
        let (lead, other) = (self.state.program(lead_axis), self.state.program(other_axis));
        let wanted = self.coordinate_from(lead_axis, lead, 1_000_000, 50_000_000);
        if self.choices.chance(40) {
            let (item, target) = self.target(lead_axis, wanted);
            let end = if along_x { Point::of(target, other) } else { Point::of(other, target) };
            return self.point_fits(end).then_some((vec![item], end));
        }
        let aside = self.coordinate_from(other_axis, other, 0, 20_000_000);
        let wanted = if along_x { Point::of(wanted, aside) } else { Point::of(aside, wanted) };
        if self.choices.chance(45) && self.allows(Feature::AnyAngle) {
            self.inclined(base, wanted)
        } else {
            self.straight(base, wanted)
        }
    }
}
