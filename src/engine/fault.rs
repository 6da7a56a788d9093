//! Why a block cannot be carried out, before it becomes an alarm event.

use std::ops::Deref;

use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

/// An alarm in the making. It is one pointer, so that the results of nearly every step of a block stay in registers: a
/// result in memory is written in small parts and read in large ones, for which a processor has to wait.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fault(Box<Parts>);

/// What makes up a fault.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Parts {
    /// The alarm.
    pub name: AlarmName,
    /// The rule that demands it.
    pub rule: RuleId,
    /// What it is about, if the rule says so.
    pub detail: Label,
}

impl Deref for Fault {
    type Target = Parts;

    fn deref(&self) -> &Parts {
        &self.0
    }
}

impl Fault {
    /// A fault without detail.
    #[cold]
    pub fn new(name: AlarmName, rule: RuleId) -> Self {
        Self::about(name, rule, Label::default())
    }

    /// A fault with a detail.
    #[cold]
    pub fn about(name: AlarmName, rule: RuleId, detail: Label) -> Self {
        Self(Box::new(Parts { name, rule, detail }))
    }

    /// A fault as a result.
    #[cold]
    pub fn raise<T>(name: AlarmName, rule: RuleId) -> Result<T, Self> {
        Err(Self::new(name, rule))
    }
}

#[cfg(test)]
mod tests {
    use super::Fault;

    #[test]
    fn results_fit_into_registers() {
        assert_eq!(size_of::<Result<(), Fault>>(), size_of::<usize>());
        assert!(size_of::<Result<i64, Fault>>() <= 2 * size_of::<usize>());
    }
}
