//! G178, G179, G181 to G184, G189 and G190: holes, taps and slots of driven tools.

use turnspec_oracle::vocabulary::{CycleReturn, Feature};

use crate::builder::Builder;
use crate::number::Number;
use crate::program::{Item, Value};
use crate::state::{Axis, Mode};

/// How deep a hole is, from the cutting start or to a coordinate.
#[derive(Clone, Copy, Debug)]
enum Depth {
    R(i64),
    Bottom(i64),
}

/// What a hole cycle keeps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hole {
    code: i64,
    side: bool,
    /// The cycle start, in machine coordinates.
    start: [i64; 2],
    direction: i64,
    approach: i64,
    depth: Depth,
    /// D of pecks and of a slot.
    step: i64,
    /// W or U.
    allowance: i64,
    /// The end of a slot.
    end: i64,
    /// Whether Q was given.
    pub spent: bool,
}

impl Hole {
    /// Infeed axis and position axis.
    fn axes(&self) -> (Axis, Axis) {
        if self.side { (Axis::X, Axis::Z) } else { (Axis::Z, Axis::X) }
    }
}

/// Whether a block has an M code as a plain number.
fn has_code(items: &[Item], code: i64) -> bool {
    let is_it = |value: &Value| matches!(value, Value::Plain(number) if *number == Number::whole(code));
    items.iter().any(|item| matches!(item, Item::Word(word) if word.address == "M" && is_it(&word.value)))
}

impl Builder<'_, '_, '_> {
    /// The level to which a hole without M136 returns.
    fn level_of_return(&self, top: i64, level: i64) -> i64 {
        match self.state.setup.parameters.cycle_return {
            CycleReturn::CycleStart => top,
            CycleReturn::CuttingStart => level,
        }
    }

    /// A hole with the words that are kept, which a called program drills.
    pub(super) fn drill_again(&mut self, hole: Hole) -> bool {
        let (infeed, _) = hole.axes();
        let top = self.state.program_of(infeed, hole.start[infeed as usize]);
        let back = self.level_of_return(top, top + hole.direction * hole.approach);
        self.move_axis(Mode::Rapid, infeed, back)
    }

    /// The first block; false where the control would refuse it.
    pub(super) fn first_hole(&mut self, code: i64) -> bool {
        let mut items = vec![Item::g(code)];
        let synchronised = self.is_synchronised(code);
        self.modes_of_cycle((!synchronised).then_some(true), &mut items);
        let start = [self.state.machine[0], self.state.machine[1]];
        let side = self.choices.chance(35) && !self.converts();
        let (axis, approach) = if side { (Axis::X, "I") } else { (Axis::Z, "K") };
        let here = self.state.program(axis);
        let wanted = self.choices.pick(&[2_000_000, 0, 5_000_000, 1_000, 3_500_000]);
        let approach = self.amount(approach, wanted, &mut items);
        let direction = if self.choices.chance(70) { -1 } else { 1 };
        let mut hole = Hole {
            code,
            side,
            start,
            direction,
            approach,
            depth: Depth::R(0),
            step: 0,
            allowance: 0,
            end: 0,
            spent: false,
        };
        let depth = self.depth_word(&hole, here, &mut items);
        hole.depth = depth;
        if let Depth::Bottom(bottom) = depth {
            hole.direction = (bottom - here).signum();
        }
        if code == 190 || self.choices.chance(60) {
            self.place_word(&mut hole, &mut items);
        }
        self.words_of_hole([100, 60], &mut hole, &mut items);
        self.cycle_feed(30, &mut items);
        self.drill(hole, items)
    }

    /// A block that follows one; false where the control would refuse it.
    pub(super) fn next_hole(&mut self) -> bool {
        let Some(mut hole) = self.state.cycles.hole else { return false };
        let mut items = Vec::new();
        if self.choices.chance(12) {
            items.push(Item::g(hole.code));
        }
        let (infeed, _) = hole.axes();
        let top = self.state.program_of(infeed, hole.start[infeed as usize]);
        if self.choices.chance(20) {
            hole.depth = self.depth_word(&hole, top, &mut items);
        }
        if self.choices.chance(70) {
            self.place_word(&mut hole, &mut items);
        }
        if self.choices.chance(5) {
            let (item, approach) = self.plain_length(if hole.side { "I" } else { "K" }, hole.approach);
            if approach == hole.approach {
                items.push(item);
            }
        }
        self.words_of_hole([20, 20], &mut hole, &mut items);
        self.cycle_feed(8, &mut items);
        let has = |address| crate::companions::has(&items, address);
        if !["X", "Y", "Z", "C", "R", "Q"].into_iter().any(has) {
            return false;
        }
        self.drill(hole, items)
    }

    /// The word of the bottom or of the depth.
    fn depth_word(&mut self, hole: &Hole, top: i64, items: &mut Vec<Item>) -> Depth {
        let grid = self.choices.pick(&[1_000_000, 100_000, 1_000]);
        let depth = self.choices.within(1_000_000 / grid, 40_000_000 / grid) * grid;
        if hole.code != 190 && self.choices.chance(45) {
            return Depth::R(self.amount("R", hole.direction * depth, items));
        }
        let (axis, _) = hole.axes();
        let (item, bottom) = self.target(axis, top + hole.direction * (hole.approach + depth));
        items.push(item);
        Depth::Bottom(bottom)
    }

    /// The word of the place, or of the end of a slot.
    fn place_word(&mut self, hole: &mut Hole, items: &mut Vec<Item>) {
        if self.converts() {
            hole.end = self.place_by_point(items);
            return;
        }
        let (_, axis) = hole.axes();
        let from = self.state.program(axis);
        let wanted = if hole.code == 190 {
            self.coordinate_from(axis, from, 1_000_000, 40_000_000)
        } else {
            self.state.somewhere(axis, self.choices)
        };
        let (item, place) = self.target(axis, wanted);
        items.push(item);
        hole.end = place;
    }

    /// Other words, with their chances in a hundred: those that a first block has to have, and others.
    fn words_of_hole(&mut self, [needed, other]: [usize; 2], hole: &mut Hole, items: &mut Vec<Item>) {
        let (infeed, _) = hole.axes();
        let top = self.state.program_of(infeed, hole.start[infeed as usize]) + hole.direction * hole.approach;
        let depth = match hole.depth {
            Depth::R(depth) => depth.abs(),
            Depth::Bottom(bottom) => (bottom - top).abs(),
        };
        let synchronised = self.is_synchronised(hole.code);
        if matches!(hole.code, 183 | 190) && self.choices.chance(needed) {
            hole.step = self.peck_word(depth, 25, items);
        }
        match hole.code {
            183 => {
                let step = hole.step;
                if step > 0 {
                    self.discharge_word(step, depth, items);
                }
                self.dwell_word(other / 2, items);
            }
            190 => self.words_of_slot(other, depth, hole, items),
            _ if synchronised => self.words_of_tap(other, items),
            _ => self.dwell_word(other / 2, items),
        }
        if self.choices.chance(45) && !self.converts() {
            let grid = self.choices.pick(&[30_000_000, 1_000_000, 1_000]);
            let wanted = self.choices.within(-359_999_000 / grid, 359_999_000 / grid) * grid;
            let (item, angle) = self.angle("C", wanted);
            self.state.c = (angle + self.state.c_offset + self.state.c_shift).rem_euclid(360_000_000);
            items.push(item);
        }
        if self.choices.chance(9) {
            let count = self.choices.pick(&[1, 2, 3, 4, 6, 7, 0, 13]);
            items.push(self.whole("Q", count));
            hole.spent = true;
            self.turn_by(count);
        }
        self.codes_of_hole(hole.code, items);
    }

    /// Where C is after holes round the axis.
    fn turn_by(&mut self, count: i64) {
        if count > 1 {
            let way = (360_000_000 * (count - 1) + count / 2) / count;
            let way = if self.state.cycles.backward { -way } else { way };
            self.state.c = (self.state.c + way).rem_euclid(360_000_000);
        }
    }

    /// Words of G190: the allowance and the feed of the infeed.
    fn words_of_slot(&mut self, percent: usize, depth: i64, hole: &mut Hole, items: &mut Vec<Item>) {
        if self.choices.chance(percent / 2) && (hole.side || self.allows(Feature::WAxis)) {
            let wanted = self.choices.pick(&[0, 200_000, depth / 2, depth - 1_000]) / 1_000 * 1_000;
            hole.allowance = self.amount(if hole.side { "U" } else { "W" }, wanted, items);
        }
        if self.choices.chance(percent / 2) {
            let amount = self.choices.pick(&[30, 100, 999, 1]);
            items.push(self.whole("E", amount));
        }
    }

    /// Words of a synchronised tap: the start angle and the divisor of the lead.
    fn words_of_tap(&mut self, percent: usize, items: &mut Vec<Item>) {
        if self.choices.chance(percent / 2) {
            let degrees = self.choices.pick(&[90_000, 0, 45_500, 359_999, 180_000]);
            items.push(self.angle("D", degrees * 1_000).0);
        }
        if self.choices.chance(percent / 2) {
            let divisor = self.choices.pick(&[1, 2, 3, 20, 7]);
            items.push(self.whole("J", divisor));
        }
    }

    /// M codes of a hole.
    fn codes_of_hole(&mut self, code: i64, items: &mut Vec<Item>) {
        if !self.allows(Feature::Aux) {
            return;
        }
        let list: &[i64] =
            if code == 190 { &[136, 141, 211, 211, 212, 213, 214] } else { &[136, 141, 169, 140] };
        let mut codes = Vec::new();
        for _ in 0..2 {
            if self.choices.chance(22) {
                let code = self.choices.pick(list);
                let alike = |other: &i64| {
                    *other == code
                        || matches!((*other, code), (211, 212) | (212, 211) | (213, 214) | (214, 213))
                };
                if !codes.iter().any(alike) {
                    codes.push(code);
                }
            }
        }
        items.extend(codes.into_iter().map(Item::m));
    }

    /// Adds a hole block if the control would not refuse it.
    fn drill(&mut self, hole: Hole, items: Vec<Item>) -> bool {
        let (infeed, aside) = hole.axes();
        let [top, beside] =
            [infeed, aside].map(|axis| self.state.program_of(axis, hole.start[axis as usize]));
        let level = top + hole.direction * hole.approach;
        let bottom = match hole.depth {
            Depth::R(depth) => level + depth,
            Depth::Bottom(bottom) => bottom,
        };
        let depth = hole.direction * (bottom - level);
        let slot = hole.code == 190;
        let written = |address: &str| crate::companions::has(&items, address);
        let step_needed = slot || hole.code == 183;
        if hole.direction == 0 || depth <= hole.allowance || step_needed && depth / hole.step.max(1) > 60 {
            return false;
        }
        let ret = if has_code(&items, 136) { top } else { self.level_of_return(top, level) };
        if slot && hole.end == beside {
            return false;
        }
        let placed = written(aside.address()) || written("Y");
        if !slot && placed && !self.move_axis(Mode::Rapid, aside, hole.end) {
            return false;
        }
        let mut goes =
            self.move_axis(Mode::Rapid, infeed, level) && self.move_axis(Mode::Linear, infeed, bottom);
        if slot {
            goes = goes
                && self.move_axis(Mode::Linear, aside, hole.end)
                && self.move_axis(Mode::Rapid, infeed, ret)
                && self.move_axis(Mode::Rapid, aside, beside);
        }
        goes = goes && self.move_axis(Mode::Rapid, infeed, ret);
        if goes {
            self.state.clamped = false;
            (self.state.cycles.mode, self.state.cycles.hole) = (true, Some(hole));
            self.push(items);
        }
        goes
    }
}
