//! What the two implementations have in common for the command line: both run block by block.

use turnspec::engine::Interpreter;
use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::{Ending, Event};

/// A run that is carried out block by block.
pub trait Machine {
    /// Carries out the next block; `Some` when the run has ended.
    fn step(&mut self, sink: &mut dyn FnMut(&Event)) -> Option<Ending>;
}

impl Machine for Run<'_> {
    fn step(&mut self, mut sink: &mut dyn FnMut(&Event)) -> Option<Ending> {
        Run::step(self, &mut sink)
    }
}

impl Machine for Interpreter<'_> {
    fn step(&mut self, mut sink: &mut dyn FnMut(&Event)) -> Option<Ending> {
        Interpreter::step(self, &mut sink)
    }
}
