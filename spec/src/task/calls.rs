//! Programs that run within each other (E100L-CALL-02, E100L-CALL-04, E100L-RTS-02, E100L-RTS-04): the main program
//! first, the one that runs last.

use super::modal::ModalCalls;
use crate::fault::{Fault, Outcome, fail};
use crate::integer::modes;
use crate::run::{Program, Spot};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, Place, Setup};

/// A program that runs.
#[derive(Clone, Debug)]
pub struct Activation {
    /// The program name in force, with its `O`; empty for a main program without one.
    pub name: Label,
    /// Where its blocks begin, behind its name block once that was read.
    pub start: Spot,
    /// Whether its first block was read.
    pub began: bool,
    /// Whether a schedule program runs it (E100L-SDF-14).
    pub selected: bool,
    /// Where it was called; the main program was not.
    pub caller: Option<Caller>,
    /// The modal calls that its last motion has triggered.
    pub triggered: Option<Triggered>,
}

/// Where a program was called.
#[derive(Clone, Debug)]
pub struct Caller {
    /// The block of the call, or the one that triggered it.
    pub place: Place,
    /// The block behind it.
    pub back: Spot,
    /// The mode, if it is a modal call.
    pub mode: Option<usize>,
}

/// Modal calls that are due (E100L-MODIN-02, E100L-MODIN-06).
#[derive(Clone, Debug)]
pub struct Triggered {
    place: Place,
    back: Spot,
    /// The first mode that was not called yet.
    next: usize,
    last: usize,
}

/// The programs that run, and the modes that are active.
#[derive(Clone, Debug)]
pub struct Calls {
    main: Activation,
    called: Vec<Activation>,
    /// MODIN modes.
    pub modes: ModalCalls,
}

impl Calls {
    /// The main program runs, from its first block on.
    pub fn new(start: Spot) -> Self {
        let name = Label::default();
        let main = Activation { name, start, began: false, selected: false, caller: None, triggered: None };
        Self { main, called: Vec::new(), modes: ModalCalls::default() }
    }

    /// E100L-SDF-14: a main program runs that a schedule program has selected.
    pub fn selected(start: Spot) -> Self {
        let Self { main, called, modes } = Self::new(start);
        Self { main: Activation { selected: true, ..main }, called, modes }
    }

    /// The program that runs.
    pub fn running(&self) -> &Activation {
        self.called.last().unwrap_or(&self.main)
    }

    /// The program that runs.
    pub fn running_mut(&mut self) -> &mut Activation {
        self.called.last_mut().unwrap_or(&mut self.main)
    }

    /// How many called programs are active: the number of the program that runs.
    pub fn depth(&self) -> usize {
        self.called.len()
    }

    /// The programs, the main program first.
    pub fn programs(&self) -> impl Iterator<Item = &Activation> {
        std::iter::once(&self.main).chain(&self.called)
    }

    /// E100L-CALL-04: whether one more program can be called.
    pub fn check_depth(&self, setup: &Setup) -> Outcome<()> {
        let most = usize::from(setup.parameters.call_depth);
        if self.depth() >= most { fail(AlarmName::CallDepth, CALL_04) } else { Ok(()) }
    }

    /// A program begins, at its name block.
    pub fn begin(&mut self, program: Program, caller: Caller) {
        let Program { name, start } = program;
        let caller = Some(caller);
        self.called.push(Activation { name, start, began: false, selected: false, caller, triggered: None });
    }

    /// E100L-RTS-02, E100L-RTS-04, E100L-MODIN-09: the program that runs ends; the block at which its caller goes on.
    pub fn end(&mut self) -> Outcome<Spot> {
        let Some(Caller { back, .. }) = self.running().caller else {
            return fail(AlarmName::ReturnOutsideSubprogram, RTS_04);
        };
        if self.modes.began_by(self.depth()) {
            return Err(Fault::about(AlarmName::Unspecified, MODIN_09, "RTS"));
        }
        self.called.pop();
        Ok(back)
    }

    /// The mode whose call the program that runs belongs to; none outside modal calls (E100L-MODIN-07,
    /// E100L-MODIN-08).
    pub fn within_mode(&self) -> Option<usize> {
        self.called.iter().rev().find_map(|program| program.caller.as_ref()?.mode)
    }

    /// E100L-MODIN-07: the number of the last mode that a motion calls now, 0 if it calls none.
    pub fn last_to_call(&self) -> usize {
        modes::last_to_call(self.modes.count(), self.within_mode())
    }

    /// A motion has triggered the calls of all modes that it can.
    pub fn trigger(&mut self, place: Place, back: Spot) {
        let last = self.last_to_call();
        self.running_mut().triggered = Some(Triggered { place, back, next: 1, last });
    }

    /// E100L-MODIN-06: the next modal call that is due.
    pub fn next_triggered(&mut self) -> Option<Caller> {
        let due = self.running_mut().triggered.as_mut().filter(|due| due.next <= due.last)?;
        let mode = due.next;
        due.next += 1;
        Some(Caller { place: due.place, back: due.back, mode: Some(mode) })
    }
}
