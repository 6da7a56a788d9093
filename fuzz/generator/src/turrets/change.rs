//! Two turrets on one saddle: blocks that select a turret, and words that depend on the one that is selected.

use turnspec_oracle::vocabulary::{Feature, MachineType, Side};

use crate::builder::Builder;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::Item;
use crate::state::Mode;

/// The code that selects a turret or a side.
pub(super) fn code(side: Side) -> i64 {
    match side {
        Side::A => 13,
        Side::B => 14,
    }
}

/// The code by which the cutting speed follows it.
pub(super) fn reference_code(side: Side) -> i64 {
    match side {
        Side::A => 110,
        Side::B => 111,
    }
}

impl Builder<'_, '_, '_> {
    /// A block that selects the other turret, or the one that is selected already; in front of it what would forbid the
    /// change is ended, a block at a time.
    pub(crate) fn turret_block(&mut self) {
        let selected = self.state.turrets.selected;
        if self.state.compensation.is_on() || self.choices.chance(12) {
            return self.turret_words_alone(selected);
        }
        if self.ready_to_change() {
            self.turning_block(18);
            self.turret_words_alone(selected.other());
            self.state.change_turret();
            self.turning_block(28);
        }
    }

    /// A command of the main spindle beside a change: what it does there depends on who started it (E100L-MIRR-07,
    /// E100L-MIRR-08).
    fn turning_block(&mut self, percent: usize) {
        if !self.choices.chance(percent) || !self.allows(Feature::Spindle) {
            return;
        }
        let mut items = Vec::new();
        let code = self.choices.pick(&[3, 3, 4, 4, 5, 19]);
        if self.choices.chance(70) && self.bears_m(code) {
            items.push(Item::m(code));
            self.note_turning(code);
        }
        if items.is_empty() || self.choices.chance(50) {
            items.push(self.spindle_speed());
        }
        self.push(items);
    }

    /// Whether the turret may be changed here (E100L-MIRR-09, E100L-MIRR-20); if not, a block toward it is added.
    fn ready_to_change(&mut self) -> bool {
        if self.state.compensation.left_over {
            self.line(Mode::Rapid);
        } else if self.state.joined {
            (self.state.joined, self.state.plane) = (false, 18);
            self.push(vec![Item::m(109)]);
        } else if self.state.cutting_speed {
            self.state.cutting_speed = false;
            let speed = self.spindle_speed();
            self.push(vec![Item::g(97), speed]);
        } else if self.state.incremental && self.allows(Feature::Absolute) {
            let item = self.incremental_word(false);
            self.push(vec![item]);
        }
        let state = &self.state;
        !(state.compensation.left_over || state.joined || state.cutting_speed || state.incremental)
    }

    /// The code of a turret, with words that are ignored now and then (E100L-MIRR-03).
    fn turret_words_alone(&mut self, turret: Side) {
        let mut items = vec![Item::g(code(turret))];
        let free = !self.state.compensation.is_on() && !self.state.control.has_modes();
        if free && self.choices.chance(18) {
            for _ in 0..=self.choices.below(2) {
                let place = self.choices.below(items.len() + 1);
                let item = self.ignored();
                if !crate::companions::has(&items, address(&item)) {
                    items.insert(place, item);
                }
            }
        }
        self.push(items);
    }

    /// A word or an assignment that would do something, or be an alarm, in another block.
    fn ignored(&mut self) -> Item {
        let text = !self.state.is_eia() && self.allows(Feature::Expression);
        match self.choices.below(if text && self.allows(Feature::Variable) { 9 } else { 7 }) {
            0 => Item::whole("X", 50),
            1 => Item::whole("T", 199),
            2 => Item::m(2),
            3 => Item::whole("S", 70_000),
            4 => Item::m(self.choices.within(3, 4)),
            5 => Item::whole("F", 0),
            6 => Item::whole("Z", -7),
            7 => Item::Assignment(Variable::Common(1), Expression::Constant(Number::whole(5))),
            _ => {
                let [one, zero] = [1, 0].map(|number| Expression::Constant(Number::whole(number)));
                Item::Assignment(Variable::Common(2), Expression::binary(Operator::Divide, one, zero))
            }
        }
    }

    /// G13, where it changes nothing, and the codes that say whose X the cutting speed follows.
    pub(crate) fn turret_words(&mut self, items: &mut Vec<Item>, percent: usize) {
        match self.state.setup.machine.r#type {
            MachineType::OneTurret => {
                for code in [13, 110] {
                    if self.choices.chance(percent / 4) && self.allows(Feature::Turret) {
                        items.push(Item::g(code));
                    }
                }
            }
            MachineType::TwoTurrets => self.reference_word(items, percent),
            MachineType::TwoSaddles => {
                if self.choices.chance(percent / 4) && self.allows(Feature::Turret) {
                    items.push(Item::g(self.choices.within(110, 111)));
                }
            }
        }
    }

    /// In G96 the code of the turret that is selected, otherwise any of the two (E100L-MIRR-19).
    fn reference_word(&mut self, items: &mut Vec<Item>, percent: usize) {
        let turrets = &self.state.turrets;
        let (selected, bound) = (turrets.selected, self.state.cutting_speed);
        let needed = bound && turrets.reference != selected;
        if self.state.control.steady || !needed && !self.choices.chance(percent / 3) {
            return;
        }
        let turret = if bound || self.choices.chance(50) { selected } else { selected.other() };
        if needed || self.allows(Feature::Turret) {
            self.state.turrets.reference = turret;
            items.push(Item::g(reference_code(turret)));
        }
    }

    /// Whether an M code that depends on turrets and saddles raises no alarm here.
    pub(crate) fn bears_m(&self, code: i64) -> bool {
        let steady = self.state.control.steady;
        match code {
            3 | 4 => self.state.turrets.may_turn(code == 3, steady),
            194 => !(self.threads || self.cycles),
            100 => !self.state.compensation.is_on() && !steady && !self.waits_at_m100(),
            _ => true,
        }
    }

    /// Whether the program is a side that has to wait at M100.
    fn waits_at_m100(&self) -> bool {
        self.state.setup.machine.r#type == MachineType::TwoSaddles && !self.allows(Feature::Spindle)
    }

    /// Notes an M code of the main spindle, of threads or of cycles.
    pub(crate) fn note_turning(&mut self, code: i64) {
        self.state.threads.note_m(code);
        self.state.cycles.note_m(code);
        match code {
            3 | 4 => self.state.turrets.turn(code == 3),
            5 | 19 if !self.state.control.steady => self.state.turrets.stop(),
            _ => {}
        }
    }
}

/// The address of a word.
fn address(item: &Item) -> &'static str {
    match item {
        Item::Word(word) => word.address,
        _ => "",
    }
}
