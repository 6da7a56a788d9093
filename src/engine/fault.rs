//! Why a block cannot be carried out, before it becomes an alarm event.

use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

/// An alarm in the making.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fault {
    /// The alarm.
    pub name: AlarmName,
    /// The rule that demands it.
    pub rule: RuleId,
    /// What it is about, if the rule says so.
    pub detail: Label,
}

impl Fault {
    /// A fault without detail.
    #[cold]
    pub fn new(name: AlarmName, rule: RuleId) -> Self {
        Self { name, rule, detail: Label::default() }
    }

    /// A fault with a detail.
    #[cold]
    pub fn about(name: AlarmName, rule: RuleId, detail: Label) -> Self {
        Self { name, rule, detail }
    }

    /// A fault as a result.
    #[cold]
    pub fn raise<T>(name: AlarmName, rule: RuleId) -> Result<T, Self> {
        Err(Self::new(name, rule))
    }
}
