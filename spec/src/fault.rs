//! A fault: the alarm that a stage raises, before the run knows its place in the trace.

use std::ops::Range;

use crate::vocabulary::{Alarm, AlarmName, Label, Place, Reading, ReadingSet, RuleId, RuleSet};

/// Result of a stage.
pub type Outcome<T> = Result<T, Fault>;

/// An alarm with its rules and, where it is known, the word that is at fault.
#[derive(Clone, PartialEq, Debug)]
pub struct Fault {
    /// The alarm.
    pub alarm: Alarm,
    /// The rules that demand it.
    pub rules: RuleSet,
    /// The readings it depends on.
    pub readings: ReadingSet,
    /// Byte span of the word at fault.
    pub span: Option<Range<u32>>,
    /// The block at fault, when it is not the block that is being carried out.
    pub block: Option<Place>,
}

impl Fault {
    /// The alarm that a rule demands.
    pub fn new(name: AlarmName, rule: RuleId) -> Self {
        let (alarm, rules) = (Alarm::new(name), RuleSet::of(&[rule]));
        Self { alarm, rules, readings: ReadingSet::default(), span: None, block: None }
    }

    /// The alarm about a code, address or name.
    pub fn about(name: AlarmName, rule: RuleId, detail: &str) -> Self {
        let alarm = Alarm::about(name, Label::new(detail));
        Self { alarm, ..Self::new(name, rule) }
    }

    /// The fault, depending on a reading.
    pub fn reading(self, reading: impl Into<Reading>) -> Self {
        Self { readings: self.readings.with(reading), ..self }
    }

    /// The fault at a word, unless it knows its word already.
    pub fn at(mut self, span: Range<u32>) -> Self {
        self.span.get_or_insert(span);
        self
    }

    /// The fault of another block, unless it knows its block already.
    pub fn of_block(mut self, block: Place) -> Self {
        self.block.get_or_insert(block);
        self
    }
}

/// `Err` of [`Fault::new`].
pub fn fail<T>(name: AlarmName, rule: RuleId) -> Outcome<T> {
    Err(Fault::new(name, rule))
}
