//! Schedule programs ("How input, output and schedules run", chapter 6; E100L-SDF-01 to E100L-SDF-21).
//!
//! A schedule is read and carried out like any program; its blocks have a grammar of their own. While a program
//! that it has selected runs, the schedule waits in [`Running`].

mod contents;
mod files;
mod grammar;
mod run;
mod selection;
#[cfg(test)]
mod tests;

pub use grammar::Selecting;

use std::collections::HashMap;

use turnspec_oracle::vocabulary::{Label, Place};

use super::task::{Activation, Scope};
use super::text::Mark;

/// Most selections that are remembered.
const MOST: usize = 4096;

/// What PSELECT has found: it finds the same whenever it is carried out.
#[derive(Clone, Copy, Debug)]
pub struct Selection {
    /// The file of the program, with its device.
    file: Label,
    program: Activation,
    /// Where its subprograms are found.
    scope: Scope,
}

/// A selected program that runs, and what waits for its end.
#[derive(Debug)]
pub struct Running {
    selection: Selection,
    /// The PSELECT block.
    place: Place,
    /// Which repetition runs, from 1, and the last one.
    repetition: u16,
    last: u16,
    /// The schedule, and where it goes on.
    schedule: Activation,
    back: Mark,
}

/// What a schedule remembers.
#[derive(Debug, Default)]
pub struct Schedule {
    running: Option<Running>,
    /// By the offset of their PSELECT blocks.
    selections: HashMap<u32, Selection>,
}

impl Schedule {
    /// Whether a selected program runs.
    pub fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Where subprograms are found, if not everywhere.
    pub fn scope(&self) -> Option<Scope> {
        self.running.as_ref().map(|running| running.selection.scope)
    }

    fn remember(&mut self, start: u32, selection: Selection) {
        if self.selections.len() >= MOST {
            self.selections.clear();
        }
        self.selections.insert(start, selection);
    }
}
