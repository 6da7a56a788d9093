//! G185 to G188: threads that the C axis cuts with a driven tool.

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// What a thread cycle keeps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Helix {
    code: i64,
    /// The cycle start, in machine coordinates.
    start: [i64; 2],
    /// The direction along the lead axis.
    direction: i64,
    approach: i64,
    taper: i64,
    /// The kept words of X and Z.
    end: [i64; 2],
    /// The C of the last C word, or that of the first block, in program coordinates.
    c: i64,
}

impl Helix {
    /// Lead axis and the other one.
    fn axes(&self) -> (Axis, Axis) {
        if self.code % 2 == 1 { (Axis::Z, Axis::X) } else { (Axis::X, Axis::Z) }
    }

    /// The letters of the approach and of the taper.
    fn letters(&self) -> (&'static str, &'static str) {
        if self.code % 2 == 1 { ("K", "I") } else { ("I", "K") }
    }

    /// Whether lengths follow one another.
    fn is_chain(&self) -> bool {
        self.code >= 187
    }
}

impl Builder<'_, '_, '_> {
    /// The first block; false where the control would refuse it.
    pub(super) fn first_helix(&mut self, code: i64) -> bool {
        let mut items = vec![Item::g(code)];
        self.modes_of_cycle(Some(false), &mut items);
        let start = [self.state.machine[0], self.state.machine[1]];
        let c = self.state.program_c();
        let mut helix = Helix { code, start, direction: 0, approach: 0, taper: 0, end: [0; 2], c };
        let (lead, other) = helix.axes();
        if self.choices.chance(60) {
            let wanted = self.choices.pick(&[2_000_000, 0, 1_500_000, 500_000]);
            helix.approach = self.amount(helix.letters().0, wanted, &mut items);
        }
        let here = self.state.program(lead);
        let wanted = self.coordinate_from(lead, here, 3_000_000, 50_000_000);
        self.end_word(lead, wanted, &mut helix, &mut items);
        let wanted = self.coordinate_from(other, self.state.program(other), 0, 20_000_000);
        self.end_word(other, wanted, &mut helix, &mut items);
        helix.direction = (helix.end[lead as usize] - here).signum();
        self.words_of_helix(40, true, &mut helix, &mut items);
        if self.state.threads.feed().is_none() {
            self.cycle_feed(100, &mut items);
        }
        self.wind(helix, true, items)
    }

    /// A block that follows one; false where the control would refuse it.
    pub(super) fn next_helix(&mut self) -> bool {
        let Some(mut helix) = self.state.cycles.helix else { return false };
        let mut items = Vec::new();
        if self.choices.chance(12) {
            items.push(Item::g(helix.code));
        }
        let (lead, other) = helix.axes();
        let along = helix.is_chain() || self.choices.chance(50);
        if along {
            let wanted = if helix.is_chain() {
                self.state.program(lead) + helix.direction * self.choices.within(1_000, 20_000) * 1_000
            } else {
                self.coordinate_from(lead, self.state.program(lead), 3_000_000, 50_000_000)
            };
            self.end_word(lead, wanted, &mut helix, &mut items);
        }
        if !along || self.choices.chance(50) {
            let wanted = self.coordinate_from(other, self.state.program(other), 0, 5_000_000);
            self.end_word(other, wanted, &mut helix, &mut items);
        }
        self.words_of_helix(15, !helix.is_chain(), &mut helix, &mut items);
        self.wind(helix, false, items)
    }

    fn end_word(&mut self, axis: Axis, wanted: i64, helix: &mut Helix, items: &mut Vec<Item>) {
        let (item, target) = self.target(axis, wanted);
        items.push(item);
        helix.end[axis as usize] = target;
    }

    /// Words of the taper, of C and of the lead, each with this chance in a hundred.
    fn words_of_helix(&mut self, percent: usize, turns: bool, helix: &mut Helix, items: &mut Vec<Item>) {
        if self.choices.chance(percent) {
            let wanted = self.choices.within(-3_000, 3_000) * 1_000;
            helix.taper = self.amount(helix.letters().1, wanted, items);
        }
        if turns && self.choices.chance(percent) {
            let degrees = self.choices.pick(&[0, 90_000, 120_000, 45_500, -30_000]);
            let (item, angle) = self.angle("C", degrees * 1_000);
            helix.c = angle;
            items.push(item);
        }
        self.cycle_feed(percent, items);
        if self.choices.chance(percent / 4) {
            let speed = self.choices.pick(&[4, 12, 1, 20]);
            items.push(self.whole("SA", speed));
        }
    }

    /// Adds a block if the control would not refuse it.
    fn wind(&mut self, helix: Helix, first: bool, items: Vec<Item>) -> bool {
        let (lead, other) = helix.axes();
        let [from, beside] =
            [lead, other].map(|axis| self.state.program_of(axis, helix.start[axis as usize]));
        let [end, level] = [lead, other].map(|axis| helix.end[axis as usize]);
        let place = |along: i64, across: i64| {
            if lead == Axis::X { [along, across] } else { [across, along] }
        };
        let fresh = first || !helix.is_chain();
        if fresh {
            let direction = (end - from).signum();
            let begin = from + direction * helix.approach;
            let away = direction * (end - from) > helix.approach;
            if direction == 0 || !away || !self.move_both(Mode::Rapid, place(begin, level)) {
                return false;
            }
            self.state.c = (helix.c + self.state.c_offset + self.state.c_shift).rem_euclid(360_000_000);
        }
        let begin = self.state.program(lead);
        if helix.direction * (end - begin) <= 0 && !fresh {
            return false;
        }
        let mut goes = self.move_both(Mode::Linear, place(end, level + helix.taper));
        self.turn_along(lead == Axis::X, end - begin);
        if !helix.is_chain() {
            goes =
                goes && self.move_axis(Mode::Rapid, other, beside) && self.move_axis(Mode::Rapid, lead, from);
        }
        if goes {
            (self.state.cycles.mode, self.state.cycles.helix) = (true, Some(helix));
            self.push(items);
        }
        goes
    }

    /// Turns C along a travel of the lead axis.
    fn turn_along(&mut self, face: bool, travel: i64) {
        let Some(feed) = self.state.threads.feed() else { return };
        let turn = 360e6 * self.state.along(face, 0, travel) / feed.max(1.0);
        let turn = if self.state.cycles.backward { -turn } else { turn };
        self.state.c = (self.state.c + turn.round() as i64).rem_euclid(360_000_000);
    }

    /// The way back to the cycle start at the end of a chain; false where a limit refuses it.
    pub(super) fn return_of_helix(&mut self) -> bool {
        let Some(helix) = self.state.cycles.helix.filter(Helix::is_chain) else { return true };
        let place = [Axis::X, Axis::Z].map(|axis| self.state.program_of(axis, helix.start[axis as usize]));
        self.move_both(Mode::Rapid, place)
    }
}
