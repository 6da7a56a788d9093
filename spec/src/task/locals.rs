//! Local variables (E100L-LVAR-03 to -13): a stack of entries, of which the last one of a name counts.

use crate::fault::{Fault, Outcome};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId};

/// E100L-LVAR-03: how many entries there may be.
const CAPACITY: usize = 127;

/// A local variable that is registered.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Entry {
    /// Its name.
    pub name: Label,
    /// Its value.
    pub value: f64,
    /// With what it ends.
    pub owner: Owner,
}

/// What an entry ends with (E100L-LVAR-12, E100L-MODIN-09).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Owner {
    /// A program that runs; the main program is 0, each one that is called one more than its caller.
    Program(usize),
    /// A MODIN mode, by number.
    Mode(usize),
}

/// How an assignment to a local name acts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Registration {
    /// In a block of items, or behind NOEX: the entry of the name changes; without one the running program gets
    /// one (E100L-LVAR-04, E100L-LVAR-06).
    Change {
        /// The program that runs.
        program: usize,
    },
    /// Behind CALL, MODIN and macro codes: a new entry in any case, for what is about to begin (E100L-LVAR-08,
    /// E100L-MODIN-09).
    New {
        /// What is about to begin.
        owner: Owner,
    },
}

/// The entries, in the order in which they were registered.
#[derive(Clone, Debug, Default)]
pub struct Locals(Vec<Entry>);

impl Locals {
    /// E100L-LVAR-09: the value of the last entry of a name.
    pub fn get(&self, name: Label) -> Option<f64> {
        self.0.iter().rev().find(|entry| entry.name == name).map(|entry| entry.value)
    }

    /// All entries.
    pub fn entries(&self) -> &[Entry] {
        &self.0
    }

    /// Carries an assignment out; the rules that say what happened to the entry.
    pub fn set(&mut self, name: Label, value: f64, registration: Registration) -> Outcome<&'static [RuleId]> {
        let program = match registration {
            Registration::New { owner } => {
                self.register(Entry { name, value, owner })?;
                return Ok(match owner {
                    Owner::Program(_) => &[LVAR_08],
                    Owner::Mode(_) => &[MODIN_09],
                });
            }
            Registration::Change { program } => program,
        };
        let called = program > 0;
        if let Some(entry) = self.0.iter_mut().rev().find(|entry| entry.name == name) {
            entry.value = value;
            return Ok(if called { &[LVAR_06, LVAR_11] } else { &[LVAR_06] });
        }
        self.register(Entry { name, value, owner: Owner::Program(program) })?;
        Ok(if called { &[LVAR_04, LVAR_10] } else { &[LVAR_04] })
    }

    fn register(&mut self, entry: Entry) -> Outcome<()> {
        if self.0.len() >= CAPACITY {
            return Err(Fault::about(AlarmName::LocalCapacity, LVAR_03, entry.name.as_str()));
        }
        self.0.push(entry);
        Ok(())
    }

    /// E100L-SDF-14: the entries go on to the next program.
    pub fn keep(&mut self) {
        self.0.iter_mut().for_each(|entry| entry.owner = Owner::Program(0));
    }

    /// E100L-LVAR-12, E100L-MODIN-09: the entries of what ends are removed.
    pub fn remove(&mut self, owner: Owner) {
        self.0.retain(|entry| entry.owner != owner);
    }
}

#[cfg(test)]
mod tests {
    use super::{Locals, Owner, Registration};
    use crate::vocabulary::Label;

    /// E100L-LVAR-08, E100L-LVAR-09, E100L-LVAR-11, E100L-LVAR-12.
    #[test]
    fn a_new_entry_hides_an_old_one_until_it_is_removed() {
        let name = Label::new("ABC");
        let mut locals = Locals::default();
        let called = Owner::Program(1);
        for (value, registration) in [
            (20.0, Registration::Change { program: 0 }),
            (100.0, Registration::New { owner: called }),
            (220.0, Registration::Change { program: 1 }),
        ] {
            assert!(locals.set(name, value, registration).is_ok());
            assert_eq!(locals.get(name), Some(value));
        }
        assert_eq!(locals.entries().len(), 2);
        locals.remove(called);
        assert_eq!(locals.get(name), Some(20.0));
    }
}
