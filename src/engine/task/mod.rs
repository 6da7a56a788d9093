//! Which block comes next (execution, chapter 9): jumps, calls and returns, modal calls, local variables.
//!
//! A program that only goes straight on costs nothing here but a count of its blocks. The index of the
//! sequence names of a program is built when one of them is looked for, that of the programs with the first
//! call, and parsed blocks are kept from the first backward jump or call on.

mod call;
mod grammar;
mod head;
mod jump;
mod kept;
mod labels;
mod locals;
mod modal;
mod programs;
mod reading;
mod situation;
mod statement;

pub use grammar::{Condition, Control};
pub use locals::{LocalName, Registration};
pub use reading::Turn;
pub use situation::{Holder, Level, Local, Mode, Situation};

use turnspec_oracle::vocabulary::Label;

use crate::engine::arithmetic::steps::Steps;

use call::Frame;
use kept::Kept;
use labels::Labels;
use locals::Locals;
use modal::ActiveMode;
use programs::{ProgramId, Programs};

/// A program that runs.
#[derive(Clone, Copy, Debug)]
pub struct Activation {
    /// The program name in force.
    pub name: Label,
    /// The called program; none for the main program that was not called.
    program: Option<ProgramId>,
    /// Number of its text: 0 is the main text.
    text: usize,
    /// Where the program ends, known of a called one.
    end: usize,
    /// Parsed blocks are kept up to this place.
    kept_until: usize,
    /// The mode whose call this is, or is part of.
    inside: Option<u8>,
}

/// What control flow remembers.
#[derive(Debug)]
pub struct Task<'a> {
    main: &'a [u8],
    /// The program that runs.
    pub present: Activation,
    /// Offset of the name block of the main program, if it has one.
    own_name: Option<usize>,
    /// How many blocks the run may still begin.
    steps: Steps,
    /// The calls that have not returned, outermost first.
    frames: Vec<Frame>,
    modes: Vec<ActiveMode>,
    locals: Locals,
    programs: Option<Programs<'a>>,
    /// Sequence names of the main program and of called programs, as far as they were looked for.
    labels: Vec<Option<Labels>>,
    kept: Kept,
}

impl<'a> Task<'a> {
    /// The beginning of a run that may begin so many blocks.
    pub fn new(main: &'a [u8], steps: u64) -> Self {
        let present = Activation {
            name: Label::default(),
            program: None,
            text: 0,
            end: usize::MAX,
            kept_until: 0,
            inside: None,
        };
        Self {
            main,
            present,
            own_name: None,
            steps: Steps::new(steps),
            frames: Vec::new(),
            modes: Vec::new(),
            locals: Locals::default(),
            programs: None,
            labels: Vec::new(),
            kept: Kept::default(),
        }
    }

    /// Whether a called program runs.
    pub fn is_called(&self) -> bool {
        self.present.program.is_some()
    }

    /// How many called programs are active.
    fn depth(&self) -> u8 {
        u8::try_from(self.frames.len()).unwrap_or(u8::MAX)
    }
}

#[cfg(test)]
mod tests;
