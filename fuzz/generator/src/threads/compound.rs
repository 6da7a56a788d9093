//! G71 and G72: a whole thread in one block, with data that the control accepts and passes that are not too many.

use turnspec_oracle::vocabulary::{BalancedInfeed, Feature, Setup};

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Mode, State};

use super::pass::{Lead, Pass, Taper};

/// D, H and H less the allowance, in nanometres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heights {
    pub step: i64,
    pub height: i64,
    pub target: i64,
}

impl Heights {
    /// About how many passes the pattern makes of them; none where the control refuses it.
    pub fn passes(self, pattern: i64, setup: &Setup) -> Option<i64> {
        let square = |length: i64| i128::from(length) * i128::from(length);
        let (step, target) = (square(self.step), square(self.target));
        let rest = square(self.height) - target;
        let finishing = i64::from(rest > 0);
        let ratio = |part: i128, whole: i128| i64::try_from(part / whole.max(1)).unwrap_or(i64::MAX / 2) + 1;
        let passes = match pattern {
            74 => self.target / self.step + 1,
            75 if setup.parameters.m75_pattern == 3 && step >= rest => ratio(target, step),
            75 if setup.readings.balanced_infeed == BalancedInfeed::Refused => return None,
            75 if target <= step => 1,
            75 if setup.parameters.m75_pattern == 3 => ratio(target - step, rest) + 1,
            75 => ratio(target - step, rest.max(step)) + 1,
            _ if self.target < self.step => return None,
            _ => self.target / self.step + 4,
        };
        Some(passes + finishing)
    }
}

impl Builder<'_, '_, '_> {
    /// The way to a cycle start, and a compound cycle.
    pub(super) fn compound_thread(&mut self) {
        let code = self.choices.pick(&[71, 71, 72]);
        if !self.choices.chance(15) {
            self.start_of_cycle(code == 72);
        }
        if !self.attempt(|builder| builder.compound_block(code)) {
            self.begin();
            self.line(Mode::Rapid);
        }
    }

    /// A block of G71 or G72; false where the control would refuse it.
    fn compound_block(&mut self, code: i64) -> bool {
        let face = code == 72;
        let mut items = vec![Item::g(code)];
        self.beside_thread(&mut items);
        self.codes_of_thread(true, &mut items);
        let (lead_axis, level_axis) = State::axes(face);
        let (start, start_level) = (self.state.program(lead_axis), self.state.program(level_axis));
        let Some(heights) = self.heights(face, &mut items) else { return false };
        let starts = self.starts(&mut items);
        let pattern = self.state.threads.pattern;
        let most = if self.choices.chance(4) { 300 } else { 40 };
        let Some(passes) = heights.passes(pattern, &self.state.setup) else { return false };
        if passes.saturating_mul(starts) > most {
            return false;
        }
        let away = heights.height + self.choices.pick(&[1_000_000, 3_000_000, 250_000, 1_000]);
        let level = self.coordinate_from(level_axis, start_level, away, away + 20_000_000);
        let end = self.coordinate_from(lead_axis, start, 1_000_000, 60_000_000);
        let (level_item, level) = self.target(level_axis, level);
        let (end_item, end) = self.target(lead_axis, end);
        items.extend([level_item, end_item]);
        let travel = end - start;
        let taper = if self.choices.chance(25) {
            self.taper_word(if face { "K" } else { "I" }, face, travel, &mut items)
        } else {
            Taper::Amount(0)
        };
        let lead = self.lead_words(&mut items);
        let mut change = 0.0;
        if self.choices.chance(12) {
            let length = self.state.along(face, start, end);
            change = self.change_word(lead, length, None, &mut items);
        }
        let mut run_out = None;
        if self.choices.chance(35) {
            let wanted = self.choices.pick(&[0, 1_000_000, 2_000_000, 700_000, travel.abs()]);
            run_out = Some(self.amount("L", wanted, &mut items));
        }
        let flank = self.infeed_angle(heights, face, &mut items);
        let lead = Lead { start: lead, change };
        let last = Pass { face, end, level, taper, shift: 0, flank: 0, lead, run_out };
        // The outermost passes, on both flanks.
        let level = level + (start_level - level).signum() * heights.height;
        for pass in [last, Pass { level, flank, ..last }, Pass { level, flank: -flank, ..last }] {
            let Some(places) = self.state.way_of(&pass) else { return false };
            self.note_places(face, &places);
        }
        self.state.threads.end_chain();
        self.push(items);
        true
    }

    /// Words D, H and the allowance.
    fn heights(&mut self, face: bool, items: &mut Vec<Item>) -> Option<Heights> {
        let grid = self.choices.pick(&[100_000, 10_000, 1_000]);
        let height = self.choices.within(200_000 / grid, 8_000_000 / grid) * grid;
        let height = self.amount("H", height, items);
        let mut target = height;
        if self.choices.chance(45) && (!face || self.allows(Feature::WAxis)) {
            let part = self.choices.pick(&[20, 10, 4, 100, 3]);
            let wanted = if self.choices.chance(10) { 0 } else { height / part / 1_000 * 1_000 };
            target -= self.amount(if face { "W" } else { "U" }, wanted, items);
        }
        let parts = self.choices.pick(&[1, 2, 3, 4, 5, 7, 10]);
        let step = match self.choices.below(8) {
            0 => target,
            1 => height * 2,
            2 => target / 2,
            _ => height / parts + self.choices.within(-20, 20) * 1_000,
        };
        let step = self.amount("D", step.max(2_540), items);
        (step > 0 && target > 0 && height > 0).then_some(Heights { step, height, target })
    }

    /// Q, the number of starts.
    fn starts(&mut self, items: &mut Vec<Item>) -> i64 {
        if !self.choices.chance(25) {
            return 1;
        }
        let starts = self.choices.pick(&[2, 3, 4, 0, 7, 1]);
        items.push(self.whole("Q", starts));
        starts.max(1)
    }

    /// B, and how far it shifts a pass at most.
    fn infeed_angle(&mut self, heights: Heights, face: bool, items: &mut Vec<Item>) -> i64 {
        if !self.choices.chance(55) {
            return 0;
        }
        let degrees = self.choices.pick(&[60_000, 55_000, 90_000, 29_500, 0, 120_000, 1]);
        let (item, angle) = self.angle("B", degrees * 1_000);
        items.push(item);
        let times = if face { 2.0 } else { 0.5 };
        (times * heights.height as f64 * (angle as f64 / 2e6).to_radians().tan()).ceil() as i64
    }
}
