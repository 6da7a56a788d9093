//! What stands between the blocks of a cycle of driven tools: assignments, statements, called programs, remarks, and
//! blocks that only change what is kept.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::program::{Item, Statement};

impl Builder<'_, '_, '_> {
    /// A block or a few.
    pub(super) fn between_holes(&mut self) {
        self.begin();
        match self.choices.below(6) {
            0 | 1 => self.assignment_between(),
            2 => self.jump_between(),
            3 => self.call_between(),
            4 => self.raw_between(),
            _ => self.kept_words(),
        }
    }

    /// An assignment alone, which is no block of the cycle.
    pub(super) fn assignment_between(&mut self) {
        if self.state.is_eia() || !self.allows(Feature::Expression) {
            return;
        }
        self.begin();
        if self.choices.chance(55) && self.allows(Feature::SystemVariable) {
            let item = self.system();
            self.push(vec![item]);
        } else if self.allows(Feature::Variable) {
            let item = self.common();
            self.push(vec![item]);
        }
    }

    /// GOTO or IF to the next block.
    fn jump_between(&mut self) {
        if !self.allows(Feature::ControlStatement) || !self.allows(Feature::SequenceName) {
            return;
        }
        let conditional = self.choices.chance(50) && self.allows(Feature::Expression) && !self.state.is_eia();
        let name = self.new_name();
        if conditional {
            let (condition, _) = self.plain_condition();
            self.statement(Statement::If(condition, name.clone()), Vec::new());
        } else {
            self.statement(Statement::Goto(name.clone()), Vec::new());
            self.dead_text(&name);
        }
        self.set_label(name);
    }

    /// A called program whose blocks are blocks of the cycle.
    fn call_between(&mut self) {
        let control = &self.state.control;
        let calls = self.allows(Feature::Subprogram)
            && self.allows(Feature::ProgramName)
            && self.state.setup.options.user_task == 2
            && !control.has_modes()
            && control.calls() < usize::from(self.state.setup.parameters.call_depth);
        if !calls {
            return;
        }
        self.settle_label();
        let hole = self.state.cycles.hole.filter(|hole| !hole.spent && !self.converts());
        let drills = hole.is_some_and(|hole| self.drill_again(hole));
        let name = self.raw_program(if drills { &["C0", "RTS"] } else { &["RTS"] });
        self.statement(Statement::Call(name), Vec::new());
        if drills {
            self.state.c = (self.state.c_offset + self.state.c_shift).rem_euclid(360_000_000);
        }
    }

    /// A remark or an empty line.
    fn raw_between(&mut self) {
        let text = self.choices.pick(&[b"(NEXT)".as_slice(), b"", b"%"]);
        if self.profile.permits_text(text, self.state.mode) {
            self.raw(text);
        }
    }

    /// A block that is no hole: F, or SB.
    fn kept_words(&mut self) {
        if self.state.cycles.hole.is_none_or(|hole| hole.spent) {
            return;
        }
        let item = if self.choices.chance(60) || self.state.is_eia() {
            self.feed_word()
        } else {
            Item::whole("SB", self.choices.pick(&[100, 400, 800]))
        };
        self.push(vec![item]);
    }
}
