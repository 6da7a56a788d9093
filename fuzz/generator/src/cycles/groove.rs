//! G73 and G74: grooves, one or several side by side.

use turnspec_oracle::vocabulary::{Feature, ToolOffsetSign};

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// The most cuts of a block, mostly and now and then.
const CUTS: (i64, i64) = (50, 300);

impl Builder<'_, '_, '_> {
    /// The way to a cycle start, and blocks of G73 or G74.
    pub(super) fn grooves(&mut self) {
        if !self.ready_for_grooves() {
            return self.line(Mode::Rapid);
        }
        if self.choices.chance(70) {
            let point = [Axis::X, Axis::Z].map(|axis| self.state.somewhere(axis, self.choices));
            self.position(point);
        }
        for _ in 0..=self.choices.below(3) {
            let code = self.choices.pick(&[73, 74]);
            if !self.attempt(|builder| builder.groove_block(code)) {
                self.begin();
                return self.line(Mode::Rapid);
            }
        }
    }

    /// A block of G73 or G74; false where the control would refuse it.
    fn groove_block(&mut self, code: i64) -> bool {
        let face = code == 74;
        let (infeed, lateral) = if face { (Axis::Z, Axis::X) } else { (Axis::X, Axis::Z) };
        let (near, step) = if face { ("K", "I") } else { ("I", "K") };
        let mut items = vec![Item::g(code)];
        self.beside_cycle(&mut items);
        let (start, from) = (self.state.program(infeed), self.state.program(lateral));
        let wanted = self.coordinate_from(infeed, start, 1_000, 40_000_000);
        let (item, bottom) = self.target(infeed, wanted);
        items.push(item);
        let (direction, travel) = ((bottom - start).signum(), (bottom - start).abs());
        let mut approach = 0;
        if self.choices.chance(60) {
            let wanted = self.choices.pick(&[0, travel / 10, travel / 4, travel / 2, travel - 1_000]);
            approach = self.amount(near, wanted / 1_000 * 1_000, &mut items);
        }
        let depth = travel - approach;
        if direction == 0 || depth <= 0 || approach < 0 {
            return false;
        }
        let most = if self.choices.chance(4) { CUTS.1 } else { CUTS.0 };
        let peck = self.peck_word(depth, most, &mut items);
        self.discharge_word(peck, depth, &mut items);
        if self.choices.chance(30) && !self.state.is_eia() {
            let wanted = self.choices.pick(&[0, 200_000, 1_000, peck, depth, 333_000]);
            self.amount("DA", wanted, &mut items);
        }
        self.dwell_word(25, &mut items);
        let end = self.lateral_words((lateral, from), step, most * peck / depth, &mut items);
        self.cycle_feed(20, &mut items);
        let top = start + direction * approach;
        let Some(end) = end.filter(|_| peck > 0) else { return false };
        let goes = self.plunge(infeed, [top, bottom, start])
            && self.move_axis(Mode::Rapid, lateral, end)
            && self.plunge(infeed, [top, bottom, start])
            && self.move_axis(Mode::Rapid, lateral, from);
        self.state.after_cutting = false;
        if goes {
            self.push(items);
        }
        goes
    }

    /// The lateral target, the step to it and a tool offset for the last groove; where that stands, none where there
    /// would be too many grooves.
    fn lateral_words(
        &mut self,
        (axis, from): (Axis, i64),
        step: &'static str,
        most: i64,
        items: &mut Vec<Item>,
    ) -> Option<i64> {
        let mut end = from;
        if self.choices.chance(60) {
            let wanted = self.coordinate_from(axis, from, 0, 30_000_000);
            let (item, target) = self.target(axis, wanted);
            items.push(item);
            end = target;
            if self.choices.chance(15) {
                end += self.groove_tool(axis, items);
            }
        }
        if end != from || self.choices.chance(10) {
            let way = (end - from).abs();
            let parts = self.choices.pick(&[1, 1, 2, 3, 5, 9]);
            let wanted = match self.choices.below(4) {
                0 => way * 2,
                1 => way,
                _ => way / parts + self.choices.within(-20, 20) * 1_000,
            };
            let step = self.amount(step, wanted.max(self.state.units.finest()), items);
            if step <= 0 || way / step + 2 > most.max(2) {
                return None;
            }
        }
        Some(end)
    }

    /// T of the last groove, which no tool is changed for; by how much it stands elsewhere.
    fn groove_tool(&mut self, axis: Axis, items: &mut Vec<Item>) -> i64 {
        if self.state.incremental || self.state.control.steady || !self.allows(Feature::Tool) {
            return 0;
        }
        let number = self.choices.within(0, 4);
        let tool = if self.choices.chance(50) { i64::from(self.state.tool) } else { 0 };
        items.push(self.whole("T", tool * 100 + number));
        let amount =
            |number: u8| self.state.tool_offsets.get(&number).copied().unwrap_or_default()[axis as usize];
        let by = amount(u8::try_from(number).unwrap_or_default()) - amount(self.state.offset);
        match self.state.setup.readings.tool_offset {
            ToolOffsetSign::Added => by,
            ToolOffsetSign::Subtracted => -by,
        }
    }
}
