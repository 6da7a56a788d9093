//! What a run lets be seen between two blocks: the programs that run, local variables, modes.

use super::Run;
use crate::task::{Activation, Entry, Mode, Owner};
use crate::vocabulary::{Label, Place};

/// A program that runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ActiveProgram<'a> {
    /// Its name, with `O`; empty for a main program without one.
    pub name: Label,
    /// The file of the library that it stands in; none for one of the main text.
    pub file: Option<&'a str>,
    /// The block that called it, in the text of the program before; none for the main program.
    pub called_at: Option<Place>,
}

/// A local variable.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LocalVariable {
    /// Its name.
    pub name: Label,
    /// Its value.
    pub value: f64,
    /// The program with which it ends, or which is called while it is there.
    pub owner: Label,
    /// The number of the mode with which it ends, for one that MODIN has registered.
    pub mode: Option<usize>,
}

/// A MODIN mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ActiveMode {
    /// Its number.
    pub number: usize,
    /// The program that it calls, with `O`.
    pub program: Label,
    /// The block that began it.
    pub began_at: Place,
}

impl<'a> Run<'a> {
    /// The programs that run, each called by the one before; the main program is the first.
    pub fn call_stack(&self) -> impl Iterator<Item = ActiveProgram<'a>> {
        let texts = self.channel().reader.programs.texts();
        self.channel().calls.programs().map(|Activation { name, start, caller, .. }| ActiveProgram {
            name: *name,
            file: texts.file(start.text),
            called_at: caller.as_ref().map(|caller| caller.place),
        })
    }

    /// The local variables in the order in which they were registered; of two with one name the later one counts.
    pub fn local_variables(&self) -> impl Iterator<Item = LocalVariable> {
        self.channel().state.memory.locals.entries().iter().map(|Entry { name, value, owner }| {
            let (owner, mode) = match owner {
                Owner::Program(depth) => {
                    (self.channel().calls.programs().nth(*depth).map(|each| each.name), None)
                }
                Owner::Mode(number) => (self.channel().calls.modes.program(*number), Some(*number)),
            };
            LocalVariable { name: *name, value: *value, owner: owner.unwrap_or_default(), mode }
        })
    }

    /// The modes that are active, in the order in which they began.
    pub fn active_modes(&self) -> impl Iterator<Item = ActiveMode> {
        let modes = self.channel().calls.modes.all().iter().enumerate();
        modes.map(|(index, Mode { program, place, .. })| ActiveMode {
            number: index + 1,
            program: *program,
            began_at: *place,
        })
    }
}
