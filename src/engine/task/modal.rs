//! Modal calls (execution, chapter 9, "Modal calls"; E100L-MODIN-02 to E100L-MODIN-09).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, CallCause, Label, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::modes;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::Task;
use super::locals::Owner;
use super::programs::ProgramId;

/// A mode that MODIN has begun.
#[derive(Clone, Copy, Debug)]
pub struct ActiveMode {
    pub program: ProgramId,
    pub name: Label,
    /// Depth of the activation that began it.
    pub owner: u8,
}

/// A call of the series that one motion triggers.
#[derive(Clone, Copy, Debug)]
pub struct ModalCall {
    /// Number of its mode, from 1.
    pub mode: u8,
    /// Number of the last mode of the series.
    last: u8,
}

impl Task<'_> {
    /// Whether a mode is active.
    #[inline]
    pub fn has_modes(&self) -> bool {
        !self.modes.is_empty()
    }

    /// How many modes a motion calls (E100L-MODIN-07, E100L-MODIN-08).
    pub fn modes_to_call(&self) -> u8 {
        let more = u8::from(planted::is(Bug::ModeCallsItself));
        modes::to_call(self.modes.len(), self.present.inside.map(|mode| mode.saturating_add(more)))
    }

    /// The number of the next mode.
    pub fn next_mode(&self) -> u8 {
        modes::next(self.modes.len())
    }

    /// Whether a mode is active that the present activation has begun.
    pub fn has_own_mode(&self) -> bool {
        self.modes.last().is_some_and(|mode| mode.owner == self.depth())
    }

    /// The active modes, in the order in which they were begun.
    pub fn modes(&self) -> &[ActiveMode] {
        &self.modes
    }
}

impl Interpreter<'_> {
    /// MODIN and its macro codes, after their assignments.
    pub(super) fn begin_mode(&mut self, name: Label, word: Label) -> Result<(), Fault> {
        if self.task.present.inside.is_some() {
            return Err(Fault::about(AlarmName::Unspecified, MODIN_07, word));
        }
        if self.task.modes.len() >= modes::MOST + usize::from(planted::is(Bug::NineModes)) {
            return Fault::raise(AlarmName::ModinDepth, MODIN_05);
        }
        let program = self.find_program(name)?;
        let owner = self.task.depth();
        self.task.modes.push(ActiveMode { program, name, owner });
        Ok(())
    }

    /// MODOUT.
    pub(super) fn end_mode(&mut self) -> Result<(), Fault> {
        if !self.task.has_modes() {
            return Fault::raise(AlarmName::ModoutWithoutModin, MODIN_04);
        }
        if !self.task.has_own_mode() {
            return Err(Fault::about(AlarmName::Unspecified, MODIN_04, Label::new("MODOUT")));
        }
        if planted::is(Bug::FirstModeEnds) {
            self.task.modes.rotate_left(1);
        }
        self.task.modes.pop();
        let number = self.task.next_mode();
        self.task.locals.remove(Owner::Mode(number));
        Ok(())
    }

    /// The calls that the motion of the block in progress triggers.
    #[cold]
    pub(in crate::engine) fn call_modes(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        self.call_next_mode(ModalCall { mode: 0, last: self.task.modes_to_call() }, sink)
    }

    /// The call of the mode after one of a series, if there is one.
    pub(super) fn call_next_mode(&mut self, after: ModalCall, sink: &mut impl Sink) -> Result<(), Fault> {
        if after.mode >= after.last {
            return Ok(());
        }
        let backwards = planted::is(Bug::ModesBackwards);
        let place = if backwards { after.last - after.mode - 1 } else { after.mode };
        let Some(mode) = self.task.modes.get(usize::from(place)).copied() else { return Ok(()) };
        self.check_depth()?;
        let mut rules = const { RuleSet::of(&[MODIN_02]) };
        if self.task.modes.len() > 1 {
            rules = rules.with(MODIN_06);
        }
        if self.task.present.inside.is_some() {
            rules = rules.with(MODIN_07);
        }
        self.emit(sink, rules, Action::Call { name: mode.name, cause: CallCause::Modal });
        let modal = ModalCall { mode: after.mode + 1, last: after.last };
        self.begin_program(mode.program, CallCause::Modal, Some(modal));
        Ok(())
    }
}
