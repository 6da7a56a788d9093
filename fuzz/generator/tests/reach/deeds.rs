//! What many generated programs did, and how they ended.

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::{Action, Event};

/// Counts of programs.
#[derive(Default, Debug)]
pub struct Deeds {
    /// Those that ended without alarm.
    pub ended: u64,
    /// By their ends: the alarm with its detail and first rule.
    endings: BTreeMap<String, u64>,
    /// By what they did, in words.
    did: BTreeMap<&'static str, u64>,
}

impl Deeds {
    /// Takes a program by its events, with each thing that it did once.
    pub fn add(&mut self, events: &[Event], deeds: impl IntoIterator<Item = &'static str>) {
        let ending = match events.last() {
            Some(Event { action: Action::Alarm(alarm), rules, .. }) => {
                let rule = rules.as_slice().first().map(ToString::to_string).unwrap_or_default();
                format!("{} {} {rule}", alarm.name, alarm.detail)
            }
            _ => {
                self.ended += 1;
                "end".to_owned()
            }
        };
        *self.endings.entry(ending).or_default() += 1;
        for deed in deeds {
            *self.did.entry(deed).or_default() += 1;
        }
    }

    /// Demands that at least so many programs did this.
    pub fn demand(&self, list: &[(&str, u64)]) {
        for (deed, least) in list {
            let count = self.did.get(deed).copied().unwrap_or_default();
            assert!(count >= *least, "{count} programs: {deed}");
        }
    }
}
