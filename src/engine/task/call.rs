//! CALL and RTS (execution, chapter 9, "CALL and RTS"; E100L-CALL-02 to E100L-CALL-05, E100L-RTS-02,
//! E100L-RTS-04).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, CallCause, Label, Place, RuleId, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::text::Mark;

use super::locals::Owner;
use super::modal::ModalCall;
use super::programs::{ProgramId, Programs};
use super::{Activation, Activity};

/// A call that has not returned.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// What runs when it returns, and where that goes on.
    pub caller: Activation,
    pub back: Mark,
    /// The block that called.
    pub place: Place,
    pub cause: CallCause,
    /// Of a modal call, which one it is.
    pub modal: Option<ModalCall>,
}

impl<'a> Interpreter<'a> {
    /// The calls of CALL and of macro codes, after their assignments.
    pub(super) fn call_by_statement(
        &mut self,
        name: Label,
        rule: RuleId,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.check_depth()?;
        let program = self.find_program(name)?;
        let cause = if rule == CALL_02 { CallCause::Call } else { CallCause::Macro };
        self.emit(sink, RuleSet::of(&[rule]), Action::Call { name, cause });
        self.begin_program(program, cause, None);
        Ok(())
    }

    /// One more called program (E100L-CALL-04).
    pub(super) fn check_depth(&self) -> Result<(), Fault> {
        let modal = self.task.frames.iter().filter(|frame| frame.modal.is_some());
        let uncounted = if planted::is(Bug::ModalCallsUncounted) { modal.count() } else { 0 };
        let most = usize::from(self.setup.parameters.call_depth) + usize::from(planted::is(Bug::OneCallMore));
        if self.task.frames.len() >= most + uncounted {
            return Fault::raise(AlarmName::CallDepth, CALL_04);
        }
        Ok(())
    }

    /// The program with a name (E100L-CALL-03, E100L-NAME-05).
    pub(super) fn find_program(&mut self, name: Label) -> Result<ProgramId, Fault> {
        let scope = self.schedule.scope();
        self.programs().find(name, scope)
    }

    /// The programs of all texts.
    pub(in crate::engine) fn programs(&mut self) -> &Programs<'a> {
        let (main, setup) = (self.task.main, self.setup);
        self.task.programs.get_or_insert_with(|| Programs::new(main, setup))
    }

    /// Goes on with a program; what runs now goes on when it returns.
    /// Common variables are neither saved nor restored (E100L-CVAR-02).
    pub(super) fn begin_program(&mut self, id: ProgramId, cause: CallCause, modal: Option<ModalCall>) {
        let Some(program) = self.task.programs.as_ref().and_then(|programs| programs.get(id)) else { return };
        let caller = self.task.present;
        self.task.frames.push(Frame { caller, back: self.reader.mark(), place: self.place, cause, modal });
        self.task.present = Activation {
            kept_until: program.end,
            inside: modal.map(|modal| modal.mode).or(caller.inside),
            ..Activation::new(Activity::Called, id + 1, &program)
        };
        self.reader.turn_to(self.task.text(program.text), program.start);
    }

    /// RTS.
    pub(super) fn return_from_call(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        let Some(frame) = self.task.frames.last().copied() else {
            return Fault::raise(AlarmName::ReturnOutsideSubprogram, RTS_04);
        };
        if self.task.has_own_mode() {
            return Err(Fault::about(AlarmName::Unspecified, MODIN_09, Label::new("RTS")));
        }
        self.emit(sink, const { RuleSet::of(&[RTS_02, LVAR_12]) }, Action::Return);
        if !planted::is(Bug::EntriesKept) {
            self.task.locals.remove(Owner::Level(self.task.depth()));
        }
        if let Some(modal) = frame.modal.filter(|_| planted::is(Bug::ModeEntriesEnd)) {
            self.task.locals.remove(Owner::Mode(modal.mode));
        }
        self.task.frames.pop();
        let name = if planted::is(Bug::NameNotRestored) { self.task.present.name } else { frame.caller.name };
        self.task.present = Activation { name, ..frame.caller };
        self.reader.turn_to(self.task.text(frame.caller.text), frame.back);
        if planted::is(Bug::ReturnBehindNext) {
            self.reader.next_lines();
        }
        match frame.modal {
            Some(modal) => {
                self.finish_statement(sink);
                if !planted::is(Bug::PlaceOfReturn) {
                    self.place = frame.place;
                }
                self.call_next_mode(modal, sink)
            }
            None => Ok(()),
        }
    }
}
