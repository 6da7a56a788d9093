//! Where a run stands between two blocks, for those who watch it.

use turnspec_oracle::vocabulary::{CallCause, Label, Place};

use crate::engine::Interpreter;

use super::locals::Owner;

/// The calls, variables and modes of a run.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Situation {
    /// The program name in force.
    pub program: Label,
    /// The calls that have not returned, outermost first.
    pub calls: Vec<Level>,
    /// The local variables, in the order in which they were registered; of two with one name the later counts.
    pub locals: Vec<Local>,
    /// The active modes, in the order in which they were begun.
    pub modes: Vec<Mode>,
    /// How many blocks the run may still begin.
    pub steps_left: u64,
}

/// A call that has not returned.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Level {
    /// The called program.
    pub program: Label,
    /// What called it.
    pub cause: CallCause,
    /// The block that called it.
    pub caller: Place,
}

/// A local variable.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Local {
    /// Its name.
    pub name: Label,
    /// Its value.
    pub value: f64,
    /// Whose end removes it.
    pub owner: Holder,
}

/// Whose end removes a local variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Holder {
    /// The reset.
    Main,
    /// The RTS of a call, by its place in [`Situation::calls`].
    Call(usize),
    /// The MODOUT of a mode, by its place in [`Situation::modes`].
    Mode(usize),
}

/// An active mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Mode {
    /// The program that motions call.
    pub program: Label,
    /// How many calls were active when it began; as many must be when it ends.
    pub depth: usize,
}

impl Interpreter<'_> {
    /// Where the run stands: after the last step, before the next one.
    #[must_use]
    pub fn situation(&self) -> Situation {
        let task = &self.task;
        let programs = task.frames.iter().skip(1).map(|frame| frame.caller.name);
        let programs = programs.chain([task.present.name]);
        let calls = task.frames.iter().zip(programs);
        Situation {
            program: task.present.name,
            calls: calls
                .map(|(frame, program)| Level { program, cause: frame.cause, caller: frame.place })
                .collect(),
            locals: task.locals.entries().iter().map(local).collect(),
            modes: task
                .modes()
                .iter()
                .map(|mode| Mode { program: mode.name, depth: mode.owner.into() })
                .collect(),
            steps_left: task.steps.left(),
        }
    }
}

fn local(entry: &super::locals::Entry) -> Local {
    let owner = match entry.owner {
        Owner::Level(0) => Holder::Main,
        Owner::Level(depth) => Holder::Call(usize::from(depth) - 1),
        Owner::Mode(number) => Holder::Mode(usize::from(number.saturating_sub(1))),
    };
    Local { name: entry.name.label(), value: entry.value, owner }
}
