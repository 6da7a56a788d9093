//! The reference semantics of CNC lathe control languages.
//!
//! Given a control, a machine set-up and a part program this crate answers one question exactly:
//! what must the control do? The answer is a [trace](vocabulary::Event): events, each with the rules
//! that produced it, or an alarm. The rules themselves stand in `spec/rules/`.
//!
//! The crate is written to be read beside the manual. It is pure: no input or output, no clock, no
//! globals, no floating point that is not correctly rounded. Use the `turnspec` crate when you need
//! speed.

pub mod vocabulary;

use vocabulary::{AlarmName, Ending, Place, RuleSet, Setup, Sink};

/// A run of the oracle, block by block.
pub struct Run<'a> {
    _program: &'a [u8],
}

impl<'a> Run<'a> {
    /// Prepares a run of a program on a valid set-up.
    #[must_use]
    pub fn new(program: &'a [u8], _setup: &'a Setup) -> Self {
        Self { _program: program }
    }

    /// Carries out the next block; its events go to the sink. `Some` when the run has ended.
    pub fn step(&mut self, _sink: &mut impl Sink) -> Option<Ending> {
        Some(Ending::End)
    }
}

/// Runs a whole program.
pub fn run(program: &[u8], setup: &Setup, sink: &mut impl Sink) -> Ending {
    let mut run = Run::new(program, setup);
    loop {
        if let Some(ending) = run.step(sink) {
            return ending;
        }
    }
}

/// One fault that `check` found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// The alarm that the control would raise.
    pub alarm: vocabulary::Alarm,
    /// Its rules.
    pub rules: RuleSet,
    /// The block.
    pub block: Place,
    /// Byte span of the word that is at fault, or of the block.
    pub span: std::ops::Range<u32>,
}

/// Every fault of a program: the grammar faults of each block, and the alarm of the run.
#[must_use]
pub fn check(_program: &[u8], _setup: &Setup) -> Vec<Diagnostic> {
    let _ = AlarmName::Format;
    Vec::new()
}
