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

pub use grammar::{Condition, Control, whole};
pub use head::Head;
pub use locals::LocalName;
pub use programs::{Program, Programs, Scope};
pub use reading::Turn;
pub use situation::{Holder, Level, Local, Mode, Situation};

use turnspec_oracle::vocabulary::Label;

use super::arithmetic::steps::Steps;
use super::planted::{self, Bug};
use super::text::Mark;
use call::Frame;
use kept::Kept;
use labels::Labels;
use locals::Locals;
use modal::ActiveMode;

/// As what a program runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Activity {
    /// The main program of the main text.
    Main,
    /// The main text, as a schedule program.
    Schedule,
    /// A main program that a schedule program has selected.
    Selected,
    /// It was called.
    Called,
}

/// A program that runs.
#[derive(Clone, Copy, Debug)]
pub struct Activation {
    /// The program name in force.
    pub name: Label,
    kind: Activity,
    /// Number of its text: 0 is the main text.
    pub text: usize,
    /// Its first block.
    pub start: Mark,
    /// Where the program ends, as far as that is known before the run comes there.
    pub end: usize,
    /// Parsed blocks are kept up to this place.
    kept_until: usize,
    /// The mode whose call this is, or is part of.
    inside: Option<u8>,
    /// Where its sequence names are among those of all programs.
    labels: usize,
}

impl Activation {
    /// The beginning of a program, whose sequence names have a place.
    pub fn new(kind: Activity, labels: usize, program: &Program) -> Self {
        let Program { name, text, start, end } = *program;
        Self { name, kind, text, start, end, kept_until: 0, inside: None, labels }
    }

    /// Keeps all parsed blocks of the program.
    pub fn keep_all(&mut self) {
        self.kept_until = self.end;
    }

    /// Whether it is the main program of the main text, which goes on to the next program name.
    #[inline]
    fn is_open(&self) -> bool {
        self.kind == Activity::Main
    }
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
        let start = Mark { at: 0, line: 1, closed: false };
        let whole = Program { name: Label::default(), text: 0, start, end: usize::MAX };
        let present = Activation::new(Activity::Main, 0, &whole);
        Self {
            main,
            present,
            own_name: None,
            steps: Steps::new(steps.saturating_add(u64::from(planted::is(Bug::OneStepMore)))),
            frames: Vec::new(),
            modes: Vec::new(),
            locals: Locals::default(),
            programs: None,
            labels: Vec::new(),
            kept: Kept::default(),
        }
    }

    /// Counts no steps, or more than there can be.
    pub fn count_no_steps(&mut self) {
        self.steps = Steps::new(u64::MAX);
    }

    /// How many blocks the run may still begin.
    pub fn steps_left(&self) -> Steps {
        self.steps
    }

    /// Sets how many blocks the run may still begin.
    pub fn set_steps(&mut self, steps: Steps) {
        self.steps = steps;
    }

    /// Begins a pass of a cycle, which is a step of the run; false if none is left (E100L-GOTO-03).
    pub fn count_pass(&mut self) -> bool {
        self.steps.take(1)
    }

    /// A text by its number.
    pub fn text(&self, number: usize) -> &'a [u8] {
        self.programs.as_ref().map_or(self.main, |programs| programs.text(number))
    }

    /// A selected program is done: no call is left, and its local variables stay (E100L-SDF-14).
    pub fn leave_program(&mut self) {
        self.frames.clear();
        self.locals.disown();
    }

    /// How many called programs are active.
    pub fn depth(&self) -> u8 {
        u8::try_from(self.frames.len()).unwrap_or(u8::MAX)
    }
}

#[cfg(test)]
mod tests;
