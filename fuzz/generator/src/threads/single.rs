//! Passes of G31, G32 and G33: a first block, and blocks that follow it.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::control::compare;
use crate::expression::{Expression, Operator};
use crate::program::{Item, Statement, Value, Word};
use crate::state::{Axis, Mode, State};

use super::pass::{Lead, Pass, Taper};

/// The data of a cycle that blocks behind its first one keep.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cycle {
    code: i64,
    end: i64,
    level: i64,
    taper: Taper,
    shift: i64,
    change: f64,
    run_out: Option<i64>,
}

/// Words of a cycle: the taper and the shift.
fn addresses(face: bool) -> (&'static str, &'static str) {
    if face { ("K", "I") } else { ("I", "K") }
}

impl Cycle {
    fn is_face(&self) -> bool {
        self.code == 32
    }

    fn pass(&self, lead: f64) -> Pass {
        Pass {
            face: self.is_face(),
            end: self.end,
            level: self.level,
            taper: self.taper,
            shift: self.shift,
            flank: 0,
            lead: Lead { start: lead, change: self.change },
            run_out: self.run_out,
        }
    }
}

impl Builder<'_, '_, '_> {
    /// A cycle: the way to its start, a first pass, passes behind it, other blocks between them.
    pub(super) fn passes_of_thread(&mut self) {
        if self.kept_cycle().is_none() || self.choices.chance(60) {
            let code = self.choices.pick(&[33, 33, 32, 31]);
            if !self.choices.chance(15) {
                self.start_of_cycle(code == 32);
            }
            if !self.attempt(|builder| builder.first_pass(code)) {
                self.begin();
                return self.line(Mode::Rapid);
            }
        }
        for _ in 0..self.choices.below(5) {
            if self.choices.chance(12) {
                self.between_passes();
            }
            if self.kept_cycle().is_none() || !self.attempt(Self::next_pass) {
                return;
            }
        }
        if self.choices.chance(25) {
            self.passes_in_a_loop();
        }
    }

    /// The cycle that the next block would go on with.
    fn kept_cycle(&self) -> Option<Cycle> {
        self.state.threads.cycle.filter(|cycle| self.state.mode == Mode::of_thread(cycle.code))
    }

    /// A positioning to a point with room around it.
    pub(super) fn start_of_cycle(&mut self, face: bool) {
        let point = [Axis::X, Axis::Z].map(|axis| self.state.somewhere(axis, self.choices));
        if face || self.choices.chance(50) {
            return self.position(point);
        }
        // Above most of the room, as for an external thread.
        let (_, high) = self.state.window(Axis::X);
        let below = self.choices.within(0, 60_000) * 1_000;
        self.position([high - below, point[1]]);
    }

    /// What may stand between the passes of a thread.
    fn between_passes(&mut self) {
        self.begin();
        match self.choices.below(4) {
            0 if self.allows(Feature::Dwell) => self.dwell(),
            1 if !self.state.control.steady => self.shift(),
            2 if self.allows(Feature::Aux) => self.push(vec![Item::m(65)]),
            _ => self.modes_of_thread(),
        }
    }

    fn modes_of_thread(&mut self) {
        let mut items = Vec::new();
        self.beside_thread(&mut items);
        self.codes_of_thread(true, &mut items);
        if !items.is_empty() {
            self.push(items);
        }
    }

    /// A first block; false where the control would refuse it.
    fn first_pass(&mut self, code: i64) -> bool {
        let face = code == 32;
        let mut items = vec![Item::g(code)];
        self.beside_thread(&mut items);
        self.codes_of_thread(false, &mut items);
        let (lead_axis, level_axis) = State::axes(face);
        let (start, start_level) = (self.state.program(lead_axis), self.state.program(level_axis));
        let end = self.coordinate_from(lead_axis, start, 1_000_000, 60_000_000);
        let level = self.coordinate_from(level_axis, start_level, 1_000, 20_000_000);
        let mut cycle =
            Cycle { code, end, level, taper: Taper::Amount(0), shift: 0, change: 0.0, run_out: None };
        self.places_of_cycle([true, true], &mut cycle, &mut items);
        let lead = self.lead_words(&mut items);
        self.words_of_cycle(40, lead, &mut cycle, &mut items);
        if self.choices.chance(20) {
            self.start_angle(&mut items);
        }
        self.cut(cycle, lead, items)
    }

    /// A block that follows a pass.
    fn next_pass(&mut self) -> bool {
        let Some(mut cycle) = self.kept_cycle() else { return false };
        let mut items = Vec::new();
        if self.choices.chance(40) {
            self.beside_thread(&mut items);
            self.codes_of_thread(false, &mut items);
        }
        let (_, level_axis) = State::axes(cycle.is_face());
        let deeper = (cycle.level - self.state.program(level_axis)).signum();
        cycle.level += deeper * self.choices.within(1, 2_000) * 1_000;
        let end = self.choices.chance(15);
        if end {
            let (lead_axis, _) = State::axes(cycle.is_face());
            cycle.end = self.coordinate_from(lead_axis, self.state.program(lead_axis), 1_000_000, 60_000_000);
        }
        let level = !end || self.choices.chance(60);
        self.places_of_cycle([end, level], &mut cycle, &mut items);
        let words = self.choices.chance(15);
        let lead = if words || self.state.threads.feed.is_none() {
            self.lead_words(&mut items)
        } else {
            self.state.threads.feed.unwrap_or_default() / self.state.threads.divisor
        };
        self.words_of_cycle(8, lead, &mut cycle, &mut items);
        if self.choices.chance(6) {
            self.start_angle(&mut items);
        }
        self.cut(cycle, lead, items)
    }

    /// Words of the end and of the level, as they are chosen.
    fn places_of_cycle(&mut self, chosen: [bool; 2], cycle: &mut Cycle, items: &mut Vec<Item>) {
        let (lead_axis, level_axis) = State::axes(cycle.is_face());
        let places = [(lead_axis, &mut cycle.end), (level_axis, &mut cycle.level)];
        for ((axis, place), chosen) in places.into_iter().zip(chosen) {
            if chosen {
                let (item, coordinate) = self.target(axis, *place);
                *place = coordinate;
                items.push(item);
            }
        }
    }

    /// Other words of a cycle, each with this chance in a hundred: taper, shift, change of the lead, chamfer.
    fn words_of_cycle(&mut self, percent: usize, lead: f64, cycle: &mut Cycle, items: &mut Vec<Item>) {
        let face = cycle.is_face();
        let (taper, shift) = addresses(face);
        let (lead_axis, _) = State::axes(face);
        let travel = cycle.end - self.state.program(lead_axis);
        if self.choices.chance(percent) {
            cycle.taper = self.taper_word(taper, face, travel, items);
        }
        if self.choices.chance(percent / 2) {
            let wanted = self.choices.within(-8_000_000, travel.abs() / 2) / 1_000 * 1_000;
            cycle.shift = self.amount(shift, wanted, items);
        }
        if self.choices.chance(percent / 2) {
            let length = self.state.along(face, 0, travel);
            cycle.change = self.change_word(lead, length, None, items);
        }
        if self.choices.chance(percent) {
            let wanted = self.choices.pick(&[0, 1_000_000, 2_000_000, 500_000, travel.abs(), 12_345_000]);
            cycle.run_out = Some(self.amount("L", wanted, items));
        }
    }

    /// A taper by amount or by angle, for a travel along the lead axis.
    pub(super) fn taper_word(
        &mut self,
        address: &'static str,
        face: bool,
        travel: i64,
        items: &mut Vec<Item>,
    ) -> Taper {
        if self.choices.chance(35) && self.allows(Feature::AnyAngle) {
            let away = self.choices.within(-30_000, 30_000) * 1_000;
            let straight = if face { 90_000_000 } else { 0 };
            let half_turn = self.choices.pick(&[0, 0, 180_000_000, -180_000_000]);
            let (item, angle) = self.angle("A", straight + away + half_turn);
            items.push(item);
            return Taper::Angle(angle);
        }
        let most = (travel.abs() / 4).min(12_000_000) / 1_000;
        let wanted = if self.choices.chance(8) { 0 } else { self.choices.within(-most, most) * 1_000 };
        let amount = self.amount(address, wanted, items);
        Taper::Amount(if face { amount } else { 2 * amount })
    }

    /// Adds a block of a cycle if the control would not refuse it.
    fn cut(&mut self, cycle: Cycle, lead: f64, items: Vec<Item>) -> bool {
        let Some(places) = self.state.way_of(&cycle.pass(lead)) else { return false };
        self.state.mode = Mode::of_thread(cycle.code);
        self.state.threads.cycle = Some(cycle);
        self.note_places(cycle.is_face(), &places);
        self.push(items);
        true
    }

    /// A loop whose passes go deeper by a variable.
    fn passes_in_a_loop(&mut self) {
        let control = [Feature::ControlStatement, Feature::SequenceName, Feature::Expression];
        let free = !self.state.control.steady && !self.state.control.has_modes() && !self.state.is_eia();
        let (Some(cycle), true) = (self.kept_cycle(), free && control.iter().all(|each| self.allows(*each)))
        else {
            return;
        };
        let Some(counter) = self.counter() else { return };
        let count = self.choices.within(2, 5);
        let (_, level_axis) = State::axes(cycle.is_face());
        let deeper = (cycle.level - self.state.program(level_axis)).signum();
        let units = self.state.units;
        let step = units.write_length(deeper * self.choices.within(1, 300) * units.finest());
        let first = units.write_length(cycle.level);
        let last = Cycle { level: cycle.level + deeper * 301 * count * units.finest(), ..cycle };
        let Some(feed) = self.state.threads.feed else { return };
        let fits = self.state.way_of(&last.pass(feed / self.state.threads.divisor)).is_some();
        if !fits || self.state.barriers.is_watched() {
            return;
        }
        self.set(&counter, 0);
        self.begin();
        let product = Expression::binary(
            Operator::Multiply,
            Expression::Variable(counter.clone()),
            Expression::Constant(step),
        );
        let level = Expression::binary(Operator::Add, Expression::Constant(first), product);
        let level = Item::Word(Word { address: level_axis.address(), value: Value::Expression(level) });
        let items = vec![self.incremental_word(false), level];
        let name = self.new_name();
        self.set_label(name.clone());
        self.push(items);
        self.forget(&counter);
        self.count(&counter, Operator::Add);
        let below = compare(Operator::Lt, &counter, count);
        self.statement(Statement::If(below, name), Vec::new());
        self.known(&counter, count);
        self.state.threads.cycle = Some(last);
    }
}
