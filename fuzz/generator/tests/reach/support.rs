//! What the events of many generated programs cite.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_oracle::vocabulary::{Action, AlarmName, Event, RuleId};

/// Rules that events have cited, and alarms with their rules.
#[derive(Default)]
pub struct Citations {
    /// Every rule that an event has cited.
    pub rules: BTreeSet<RuleId>,
    /// How often an alarm was raised with a rule.
    alarms: BTreeMap<(AlarmName, RuleId), u64>,
}

impl Citations {
    /// Takes note of an event.
    pub fn event(&mut self, event: &Event) {
        self.rules.extend(event.rules.as_slice());
        if let Action::Alarm(raised) = event.action {
            for rule in event.rules.as_slice() {
                *self.alarms.entry((raised.name, *rule)).or_default() += 1;
            }
        }
    }

    /// Demands that each of these rules was cited, and each of these alarms raised with its rule.
    pub fn demand(&self, rules: &[RuleId], alarms: &[(AlarmName, RuleId)]) {
        for pair in alarms {
            println!("{} {}: {:?}", pair.0, pair.1, self.alarms.get(pair));
        }
        let never: Vec<_> = rules.iter().filter(|rule| !self.rules.contains(*rule)).collect();
        assert!(never.is_empty(), "rules that no program reached: {never:?}");
        let never: Vec<_> = alarms.iter().filter(|pair| !self.alarms.contains_key(*pair)).collect();
        assert!(never.is_empty(), "alarms that no program raised: {never:?}");
    }
}
