//! What the events of many generated programs cite.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use turnspec_generator::case_from_seed;
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, RuleId};

use crate::programs::is_in;

/// Programs in which every rule has to be met.
pub const PROGRAMS: u64 = 40_000;

/// What all events of these programs cite: one run of them serves every area.
pub static OF_ALL: LazyLock<Citations> = LazyLock::new(|| {
    let mut citations = Citations::default();
    for case in (0..PROGRAMS).map(case_from_seed) {
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| citations.event(event));
    }
    citations
});

/// Rules that events have cited, and alarms with their rules.
#[derive(Default)]
pub struct Citations {
    /// Every rule that an event has cited.
    pub rules: BTreeSet<RuleId>,
    /// How often an alarm was raised with a rule.
    alarms: BTreeMap<(AlarmName, RuleId), u64>,
    /// The details that it had.
    details: BTreeSet<(AlarmName, RuleId, String)>,
}

impl Citations {
    /// Takes note of an event.
    pub fn event(&mut self, event: &Event) {
        self.rules.extend(event.rules.as_slice());
        if let Action::Alarm(raised) = event.action {
            for rule in event.rules.as_slice() {
                *self.alarms.entry((raised.name, *rule)).or_default() += 1;
                self.details.insert((raised.name, *rule, raised.detail.as_str().to_owned()));
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

    /// Demands that each of these alarms was raised with its detail.
    pub fn demand_details(&self, alarms: &[(AlarmName, &str)]) {
        let had: BTreeSet<_> =
            self.details.iter().map(|(name, _, detail)| (*name, detail.as_str())).collect();
        let never: Vec<_> = alarms.iter().filter(|pair| !had.contains(*pair)).collect();
        assert!(never.is_empty(), "details that no alarm had: {never:?}");
    }

    /// Demands that an alarm of these areas was raised with each of these details.
    pub fn demand_details_of(&self, areas: &[&str], details: &[&str]) {
        let own = self.details.iter().filter(|(_, rule, _)| is_in(*rule, areas));
        let had: BTreeSet<_> = own.map(|(_, _, detail)| detail.as_str()).collect();
        let never: Vec<_> = details.iter().filter(|detail| !had.contains(*detail)).collect();
        assert!(never.is_empty(), "details that no program reached: {never:?}");
    }
}
