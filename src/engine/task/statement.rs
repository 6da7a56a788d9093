//! Carrying out statements (execution, chapter 9).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Ending, Label, RuleId, Sink};

use crate::engine::Interpreter;
use crate::engine::assignment::Origin;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Operand, Parsed};

use super::{Condition, Control};

/// What a macro code begins.
enum Macro {
    Call,
    Mode,
}

impl Interpreter<'_> {
    /// Carries out a block with a statement.
    pub(in crate::engine) fn carry_out_statement(
        &mut self,
        parsed: &Parsed,
        control: Control,
        sink: &mut impl Sink,
    ) -> Result<Option<Ending>, Fault> {
        self.let_statement_pass()?;
        match control {
            Control::Goto(name) => self.jump(name, GOTO_02)?,
            Control::If(condition, name) => {
                if self.holds(parsed, condition)? {
                    self.jump(name, IFST_03)?;
                } else if planted::is(Bug::FalseNeedsName) {
                    let here = self.reader.mark();
                    self.jump(name, IFST_03)?;
                    self.reader.seek(here);
                }
            }
            Control::Select(selecting) => self.select(parsed, selecting, sink)?,
            Control::Set => self.assignments(parsed, Origin::Schedule, sink)?,
            Control::End => return Ok(Some(self.end_schedule(sink))),
            // User Task 1 has GOTO and IF (E100L-UT-02), but none of what follows.
            _ if self.options.level_one => {
                return Err(Fault::about(AlarmName::UserTaskLevel, UT_03, control.word()));
            }
            Control::Transfer(transfer) => return self.transfer(parsed, transfer, sink).map(|()| None),
            // Common and system variables are set first, here and behind MODIN, and stay set (E100L-CVAR-05).
            Control::Call(name) => {
                self.assignments(parsed, Origin::Call, sink)?;
                self.call_by_statement(name, CALL_02, sink)?;
            }
            Control::Return => self.return_from_call(sink)?,
            Control::BeginMode(name) => {
                self.assignments(parsed, Origin::Mode, sink)?;
                self.begin_mode(name, control.word())?;
            }
            Control::EndMode => self.end_mode()?,
            Control::GMacro(code) => self.macro_code(parsed, control.word(), kind(code), MACRO_01, sink)?,
            Control::MMacro(_) => self.macro_code(parsed, control.word(), Macro::Call, MACRO_02, sink)?,
        }
        if parsed.has_assignment {
            self.state.base = None;
        }
        if planted::is(Bug::StatementCounts) {
            self.finish_block(sink)?;
        }
        self.finish_statement(sink);
        Ok(None)
    }

    /// Whether the condition of an IF is true (E100L-IFST-02, E100L-IFST-04).
    fn holds(&mut self, parsed: &Parsed, condition: Condition) -> Result<bool, Fault> {
        match condition {
            Condition::Value(code) => Ok(match self.compute(parsed, code)? {
                Operand::Integer(value) => value != 0 && !(planted::is(Bug::PositiveConditions) && value < 0),
                Operand::Real(value) => {
                    value != 0.0 && !(planted::is(Bug::PositiveConditions) && value < 0.0)
                }
            }),
            Condition::Defined(name) => Ok(self.task.has_local(name)),
        }
    }

    fn assignments(&mut self, parsed: &Parsed, origin: Origin, sink: &mut impl Sink) -> Result<(), Fault> {
        parsed.items.iter().try_for_each(|item| self.assignment(parsed, *item, origin, sink))
    }

    /// A macro code, with the program that the set-up gives to it.
    /// Common variables behind it are set before that begins, and stay set (E100L-CVAR-05).
    fn macro_code(
        &mut self,
        parsed: &Parsed,
        code: Label,
        kind: Macro,
        rule: RuleId,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let origin = match kind {
            Macro::Call => Origin::Call,
            Macro::Mode => Origin::Mode,
        };
        self.assignments(parsed, origin, sink)?;
        let Some(name) = self.setup.macros.get(code.as_str()).copied() else {
            return Err(Fault::about(AlarmName::MacroUnassigned, rule, code));
        };
        match kind {
            Macro::Call => self.call_by_statement(name, rule, sink),
            Macro::Mode => self.begin_mode(name, code),
        }
    }
}

/// What a G code macro begins (E100L-MACRO-01).
fn kind(code: u16) -> Macro {
    let last = if planted::is(Bug::MacroRange) { 171 } else { 170 };
    if code <= last { Macro::Mode } else { Macro::Call }
}
