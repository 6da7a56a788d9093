//! Local variables (E100L-LVAR-01 to E100L-LVAR-13).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Label, RuleSet, Sink, Value};

use crate::engine::Interpreter;
use crate::engine::assignment::Origin;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::Task;

/// Most entries at a time (E100L-LVAR-03).
const MOST: usize = 127;

/// The name of a local variable, filled up with zeros.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LocalName([u8; 4]);

impl LocalName {
    /// The local variable that a run of letters and digits means, if its name is well formed.
    pub fn of(run: &[u8]) -> Result<Self, Fault> {
        let mut name = [0; 4];
        if run.len() > name.len() || matches!(run.first(), Some(b'N' | b'O')) {
            let shown = run.get(..run.len().min(8)).unwrap_or_default();
            return Err(Fault::about(AlarmName::LocalNameMalformed, LVAR_01, Label::from_bytes(shown)));
        }
        for (slot, byte) in name.iter_mut().zip(run) {
            *slot = *byte;
        }
        Ok(Self(name))
    }

    /// As written.
    pub fn label(self) -> Label {
        let mut label = Label::default();
        self.0.iter().filter(|byte| **byte != 0).for_each(|byte| label.push(*byte));
        label
    }
}

/// Whose end removes an entry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Owner {
    /// The activation at a depth; 0 is the main program.
    Level(u8),
    /// The mode with a number.
    Mode(u8),
}

/// A registered variable.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    pub name: LocalName,
    pub value: f64,
    pub owner: Owner,
}

/// The registered variables, in the order in which they were registered.
#[derive(Debug, Default)]
pub struct Locals {
    entries: Vec<Entry>,
}

impl Locals {
    /// The entry that a name means: the last one that bears it (E100L-LVAR-09).
    fn last(&self, name: LocalName) -> Option<&Entry> {
        let mut found = self.entries.iter().filter(|entry| entry.name == name);
        if planted::is(Bug::OldestEntry) { found.next() } else { found.next_back() }
    }

    /// Changes the entry that a name means; false without one.
    fn change(&mut self, name: LocalName, value: f64) -> bool {
        let found = self.entries.iter_mut().rev().find(|entry| entry.name == name);
        found.map(|entry| entry.value = value).is_some()
    }

    fn register(&mut self, entry: Entry) -> Result<(), Fault> {
        if self.entries.len() >= MOST + usize::from(planted::is(Bug::OneLocalMore)) {
            return Err(Fault::about(AlarmName::LocalCapacity, LVAR_03, entry.name.label()));
        }
        self.entries.push(entry);
        Ok(())
    }

    /// Removes the entries of an owner.
    pub fn remove(&mut self, owner: Owner) {
        self.entries.retain(|entry| entry.owner != owner);
    }

    /// Lets no end but the reset remove what is there.
    pub fn disown(&mut self) {
        self.entries.iter_mut().for_each(|entry| entry.owner = Owner::Level(0));
    }

    /// The entries, oldest first.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }
}

impl Task<'_> {
    /// The value of a local variable (E100L-LVAR-05).
    #[inline]
    pub fn read_local(&self, name: LocalName) -> Result<f64, Fault> {
        match self.locals.last(name) {
            Some(entry) => Ok(entry.value),
            None => Err(Fault::about(AlarmName::LocalUndefined, LVAR_05, name.label())),
        }
    }

    /// Whether a name has an entry (E100L-IFST-02).
    pub fn has_local(&self, name: LocalName) -> bool {
        let own = |entry: &Entry| entry.owner == Owner::Level(self.depth());
        self.locals.last(name).is_some_and(|entry| !planted::is(Bug::DefinedHere) || own(entry))
    }

    /// Changes or registers a variable; the rules of that.
    fn store_local(&mut self, name: LocalName, value: f64, origin: Origin) -> Result<RuleSet, Fault> {
        let depth = self.depth();
        let (owner, rules) = match (origin, depth > 0) {
            (Origin::Item | Origin::Schedule | Origin::Field | Origin::Rest, called) => {
                if self.locals.change(name, value) {
                    return Ok(if called {
                        const { RuleSet::of(&[LVAR_13, TYPE_04, LVAR_06, LVAR_11]) }
                    } else {
                        const { RuleSet::of(&[LVAR_13, TYPE_04, LVAR_06]) }
                    });
                }
                let rules = if called {
                    const { RuleSet::of(&[LVAR_13, TYPE_04, LVAR_04, LVAR_10]) }
                } else {
                    const { RuleSet::of(&[LVAR_13, TYPE_04, LVAR_04]) }
                };
                (Owner::Level(depth), rules)
            }
            (Origin::Call, _) => {
                if planted::is(Bug::CallAssigns) && self.locals.change(name, value) {
                    return Ok(const { RuleSet::of(&[LVAR_13, TYPE_04, LVAR_08]) });
                }
                (Owner::Level(depth.saturating_add(1)), const { RuleSet::of(&[LVAR_13, TYPE_04, LVAR_08]) })
            }
            (Origin::Mode, _) => {
                (Owner::Mode(self.next_mode()), const { RuleSet::of(&[LVAR_13, TYPE_04, MODIN_09]) })
            }
        };
        self.locals.register(Entry { name, value, owner })?;
        Ok(rules)
    }
}

impl Interpreter<'_> {
    /// Assigns a local variable.
    pub(in crate::engine) fn assign_local(
        &mut self,
        name: LocalName,
        value: f64,
        origin: Origin,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let rules = self.task.store_local(name, value, origin)?;
        self.emit(
            sink,
            origin.rules(rules),
            Action::Variable { name: name.label(), value: Value::Real(value) },
        );
        Ok(())
    }
}
