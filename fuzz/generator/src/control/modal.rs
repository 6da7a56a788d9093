//! Modal calls: MODIN, blocks that trigger it, MODOUT.

use std::rc::Rc;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::{Builder, Kind};
use crate::companions::has;
use crate::program::{Item, Statement};
use crate::state::Mode as MotionMode;

use super::local::Owner;
use super::steady::Called;

/// A modal call that is active.
#[derive(Clone, Debug)]
pub(super) struct Mode {
    pub called: Rc<Called>,
}

impl Builder<'_, '_, '_> {
    /// MODIN, a few blocks, MODOUT.
    pub(super) fn modal(&mut self) {
        let control = &self.state.control;
        let depth = control.depth + control.modes.len() + 2;
        if control.shared || depth > usize::from(self.state.setup.parameters.call_depth) {
            return self.harmless_block();
        }
        let known: Vec<_> =
            control.programs.iter().filter(|called| self.is_usable(called, true)).cloned().collect();
        let called = if !known.is_empty() && self.choices.chance(40) {
            known[self.choices.below(known.len())].clone()
        } else {
            let nature = self.nature(true);
            self.shared_program(nature)
        };
        if !self.is_usable(&called, true) || self.state.compensation.has_to_go_on() {
            return self.harmless_block();
        }
        self.begin();
        let number = self.state.control.modes.len() + 1;
        let mut items = self.bound_arguments(&called, Owner::Mode(number));
        if items.is_empty() && self.choices.chance(30) {
            items = self.free_arguments(Owner::Mode(number));
        }
        let statement = self.calling(&called.name, true);
        self.statement(statement, items);
        self.state.control.modes.push(Mode { called });
        if self.choices.chance(12) {
            self.turns();
        }
        for _ in 0..=self.choices.below(4) {
            self.grow_block();
        }
        self.settle_label();
        self.statement(Statement::Modout, Vec::new());
        self.state.control.modes.pop();
        self.state.control.remove(Owner::Mode(number));
    }

    /// A motion of C alone, which triggers nothing, where the axis is joined; else the code that may join it.
    fn turns(&mut self) {
        let free = !self.state.compensation.is_on() && !self.state.barriers.is_watched();
        let allowed = self.allows(Feature::CAxis) && self.allows(Feature::Rapid);
        if !free || !allowed || !self.permits_kind(Kind::CAxis) {
            return;
        }
        let may_turn = |builder: &Self| builder.state.joined && !builder.state.clamped;
        self.begin();
        if !may_turn(self) {
            self.block_of(Kind::CAxis);
            self.begin();
        }
        if may_turn(self) {
            let mut items = Vec::new();
            self.select(MotionMode::Rapid, &mut items);
            self.c_words(&mut items);
            self.state.after_cutting = false;
            self.push(items);
        }
    }

    /// What a block that was just written triggers.
    pub(crate) fn trigger(&mut self, items: &[Item]) {
        let modes = &self.state.control.modes;
        let still = modes.is_empty() || self.state.mode.is_contour() || self.state.cycles.is_on();
        if still || !triggers(items) || !self.allows(Feature::ModalCall) {
            return;
        }
        for place in 0..self.state.control.modes.len() {
            self.run_mode(place);
        }
    }

    /// The state after the program of a modal call, whose motions trigger the modes before it.
    fn run_mode(&mut self, place: usize) {
        let called = self.state.control.modes[place].called.clone();
        self.after_program(&called);
        if called.moves() {
            for before in 0..place {
                self.run_mode(before);
            }
        }
    }
}

/// Whether a block has a motion of X or Z that triggers modal calls.
fn triggers(items: &[Item]) -> bool {
    let codes = &[4, 22, 28, 29, 50, 71, 72, 73, 74, 77, 78];
    let one_shot = |item: &Item| matches!(item, Item::Word(word) if word.is_g(codes));
    (has(items, "X") || has(items, "Y") || has(items, "Z")) && !items.iter().any(one_shot)
}
