//! Generated programs reach radius compensation: how many, how deep, and every rule and alarm of it.

#![allow(clippy::panic)]

use std::collections::{BTreeMap, BTreeSet};

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, Motion, RuleId};

/// Programs in which every rule has to be met.
const PROGRAMS: u64 = 6_000;

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    programs: u64,
    /// Programs with a motion in compensation.
    compensated: u64,
    /// Those of them that reached M02 or M30.
    ended: u64,
    motions: u64,
    rules: BTreeMap<RuleId, u64>,
    alarms: BTreeMap<(AlarmName, RuleId), u64>,
    last: BTreeMap<AlarmName, u64>,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let (mut motions, mut ended) = (0, false);
        let (mut rules, mut alarm) = (BTreeSet::new(), None);
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            motions += u64::from(motion(event).is_some_and(|motion| motion.tip.is_some()));
            ended |= matches!(event.action, Action::End { .. });
            let of_it = event.rules.as_slice().iter().filter(|rule| is_of_compensation(rule));
            rules.extend(of_it.copied());
            if let Action::Alarm(raised) = event.action {
                alarm = Some(raised.name);
                for rule in event.rules.as_slice() {
                    *self.alarms.entry((raised.name, *rule)).or_default() += 1;
                }
            }
        });
        self.programs += 1;
        self.motions += motions;
        self.compensated += u64::from(motions > 0);
        self.ended += u64::from(motions > 0 && ended);
        if let (Some(alarm), true) = (alarm, motions > 0) {
            *self.last.entry(alarm).or_default() += 1;
        }
        for rule in rules {
            *self.rules.entry(rule).or_default() += 1;
        }
    }
}

fn motion(event: &Event) -> Option<Motion> {
    match event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } | Action::Arc { motion, .. } => Some(motion),
        _ => None,
    }
}

fn is_of_compensation(rule: &RuleId) -> bool {
    ["NRC", "CRC"].iter().any(|area| rule.as_str().split('-').nth(1) == Some(area))
}

#[test]
fn compensated_programs_are_many_and_deep() {
    let mut reached = Reached::default();
    for seed in 0..PROGRAMS {
        reached.add(&case_from_seed(seed));
    }
    println!(
        "{} programs, {} compensated, {} of them ended, {} motions",
        reached.programs, reached.compensated, reached.ended, reached.motions
    );
    println!("{:#?}\n{:#?}\n{:?}", reached.rules, reached.alarms, reached.last);
}
