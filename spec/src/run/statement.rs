//! Statements carried out: jumps, calls, modes (execution.md, chapter 9).

use super::channel::Channel;
use super::{Program, Spot};
use crate::compensation::Stream;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::modal;
use crate::syntax::{Callee, Communication, Condition, Item, Statement};
use crate::task::{self, Caller, Mode, Owner, Registration};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, CallCause, Label, Place, RuleId, RuleSet};

/// A statement that is carried out.
#[derive(Clone, Copy)]
pub struct Carried {
    /// Its block.
    pub place: Place,
    /// The block behind it.
    pub behind: Spot,
}

impl Channel<'_> {
    /// Carries a statement out.
    pub(super) fn statement(
        &mut self,
        statement: &Statement,
        block: Carried,
        stream: &mut Stream,
    ) -> Outcome<()> {
        self.compensation.begin_statement()?;
        let level = self.setup.options.user_task;
        if level < 2 && !matches!(statement, Statement::Goto(_) | Statement::If(..)) {
            // E100L-UT-02, E100L-UT-03: subprograms are User Task 2.
            let keyword = statement.label();
            return Err(Fault::about(AlarmName::UserTaskLevel, UT_03, keyword.as_str()));
        }
        match statement {
            Statement::Goto(name) => self.jump(*name, GOTO_02)?,
            Statement::If(condition, name) => {
                if self.holds(condition)? {
                    self.jump(*name, IFST_03)?;
                }
            }
            Statement::Call(callee, settings) => self.call(*callee, settings, block, stream)?,
            Statement::Return => self.end_of_call(stream)?,
            Statement::Modin(callee, settings) => self.modin(statement, *callee, settings, block, stream)?,
            Statement::Modout => {
                let number = self.calls.modes.end(self.calls.depth())?;
                self.state.memory.locals.remove(Owner::Mode(number));
            }
        }
        self.compensation.end_of_statement(stream);
        Ok(())
    }

    /// READ, WRITE, GET and PUT: a block without motion.
    pub(super) fn communicate(&mut self, statement: &Communication, stream: &mut Stream) -> Outcome<()> {
        let own = Registration::Change { program: self.calls.depth() };
        task::communicate(statement, own, &mut self.state, &mut stream.emissions)?;
        if matches!(statement, Communication::Get(..)) {
            // The frame may have changed: a corner of before means nothing now.
            self.state.base = None;
        }
        self.compensation.end_of_block(false, stream, &mut self.state)
    }

    /// E100L-GOTO-01 to -03, E100L-IFST-03: the run goes on with the block of a name; nothing else changes.
    fn jump(&mut self, name: Label, rule: RuleId) -> Outcome<()> {
        match self.reader.programs.block(name, self.calls.running().start) {
            Some(block) => {
                self.reader.go_to(block);
                Ok(())
            }
            None => Err(Fault::about(AlarmName::SequenceNameUnknown, rule, name.as_str())),
        }
    }

    /// E100L-IFST-01, E100L-IFST-02, E100L-IFST-04: every value but zero is true, and every name that has an entry.
    pub(super) fn holds(&mut self, condition: &Condition) -> Outcome<bool> {
        match condition {
            Condition::Value(expression) => Ok(task::evaluate(expression, &mut self.state)?.real() != 0.0),
            Condition::Registered(name) => Ok(self.state.memory.locals.get(*name).is_some()),
        }
    }

    /// The assignments of a statement; common and system variables stay set (E100L-CVAR-05).
    fn settings(
        &mut self,
        settings: &[Item],
        registration: Registration,
        stream: &mut Stream,
    ) -> Outcome<()> {
        let words = modal::evaluate(settings, registration, &mut self.state, &mut stream.emissions)?;
        if words.assigns {
            // The frame may have changed: a corner of before means nothing now.
            self.state.base = None;
        }
        Ok(())
    }

    /// E100L-MACRO-01, E100L-MACRO-02: the name of the program that a statement calls.
    fn name_of(&self, callee: Callee) -> Outcome<Label> {
        match callee {
            Callee::Program(name) => Ok(name),
            Callee::Code(code) => match self.setup.macros.get(code.as_str()) {
                Some(name) => Ok(*name),
                None => Err(Fault::about(AlarmName::MacroUnassigned, rule_of_macro(code), code.as_str())),
            },
        }
    }

    /// E100L-CALL-02.
    fn call(
        &mut self,
        callee: Callee,
        settings: &[Item],
        block: Carried,
        stream: &mut Stream,
    ) -> Outcome<()> {
        let owner = Owner::Program(self.calls.depth() + 1);
        self.settings(settings, Registration::New { owner }, stream)?;
        let name = self.name_of(callee)?;
        self.calls.check_depth(self.setup)?;
        let program = self.reader.programs.find(name)?;
        let (cause, rule) = match callee {
            Callee::Program(_) => (CallCause::Call, CALL_02),
            Callee::Code(code) => (CallCause::Macro, rule_of_macro(code)),
        };
        stream.emissions.push(Emission::new(Action::Call { name, cause }, RuleSet::of(&[rule])));
        self.begin(program, Caller { place: block.place, back: block.behind, mode: None });
        Ok(())
    }

    fn begin(&mut self, program: Program, caller: Caller) {
        self.reader.go_to(program.start);
        self.calls.begin(program, caller);
    }

    /// E100L-RTS-02, E100L-RTS-03, E100L-LVAR-12: modes of codes, frames and common variables stay (E100L-CALL-05).
    fn end_of_call(&mut self, stream: &mut Stream) -> Outcome<()> {
        let ended = Owner::Program(self.calls.depth());
        let back = self.calls.end()?;
        stream.emissions.push(Emission::new(Action::Return, RuleSet::of(&[RTS_02, LVAR_12])));
        self.state.memory.locals.remove(ended);
        self.reader.go_to(back);
        Ok(())
    }

    /// E100L-MODIN-01, E100L-MODIN-05, E100L-MODIN-07, E100L-MODIN-09: a mode begins.
    fn modin(
        &mut self,
        statement: &Statement,
        callee: Callee,
        settings: &[Item],
        block: Carried,
        stream: &mut Stream,
    ) -> Outcome<()> {
        let owner = Owner::Mode(self.calls.modes.count() + 1);
        self.settings(settings, Registration::New { owner }, stream)?;
        let name = self.name_of(callee)?;
        if self.calls.within_mode().is_some() {
            let keyword = statement.label();
            return Err(Fault::about(AlarmName::Unspecified, MODIN_07, keyword.as_str()));
        }
        self.calls.modes.check_count()?;
        let program = self.reader.programs.find(name)?.name;
        let began_by = self.calls.depth();
        self.calls.modes.begin(Mode { program, place: block.place, began_by });
        Ok(())
    }

    /// E100L-MODIN-02, E100L-MODIN-06: the program that runs calls the next of the modes that its last motion has
    /// triggered, if one is left.
    pub(super) fn modal_call(
        &mut self,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<()> {
        let Some(caller) = self.calls.next_triggered() else { return Ok(()) };
        let Some(name) = caller.mode.and_then(|mode| self.calls.modes.program(mode)) else { return Ok(()) };
        *place = caller.place;
        self.calls.check_depth(self.setup)?;
        let program = self.reader.programs.find(name)?;
        let call = Action::Call { name, cause: CallCause::Modal };
        let event = Emission::new(call, RuleSet::of(&[MODIN_02]))
            .rule_if(self.calls.modes.count() > 1, MODIN_06)
            .rule_if(self.calls.within_mode().is_some(), MODIN_07);
        let mut stream = self.compensation.stream(*place, self.state.side(), decided);
        stream.emissions.push(event);
        self.compensation.end_of_statement(&mut stream);
        stream.close();
        self.begin(program, caller);
        Ok(())
    }
}

fn rule_of_macro(code: Label) -> RuleId {
    if code.as_str().starts_with('G') { MACRO_01 } else { MACRO_02 }
}
