//! Findings that probably have one cause, by the rule that is most likely broken.
//!
//! An event cites many rules, and a bug shows itself in many kinds of event. The rule that an implementation
//! breaks is cited by the events that disagree and seldom by those that agree, so that the share of the
//! disagreeing ones tells it from the rules that only stand beside it.

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::RuleId;

use super::{Campaign, Finding};

/// Findings with the same most likely rule.
#[derive(Clone, Debug)]
pub struct Group<'c> {
    /// The rule; none where the implementation failed altogether.
    pub rule: Option<RuleId>,
    /// The findings, the most frequent first.
    pub findings: Vec<&'c Finding>,
}

impl Group<'_> {
    /// How many programs disagree so.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.findings.iter().map(|finding| finding.count()).sum()
    }
}

impl Campaign {
    /// The findings by their most likely rule, the most frequent group first.
    #[must_use]
    pub fn groups(&self) -> Vec<Group<'_>> {
        let mut groups: Vec<Group<'_>> = Vec::new();
        for finding in &self.findings {
            let rule = self.suspects(finding).first().copied();
            match groups.iter_mut().find(|group| rule.is_some() && group.rule == rule) {
                Some(group) => group.findings.push(finding),
                None => groups.push(Group { rule, findings: vec![finding] }),
            }
        }
        for group in &mut groups {
            group.findings.sort_by_key(|finding| std::cmp::Reverse(finding.count()));
        }
        groups.sort_by_key(|group| std::cmp::Reverse(group.count()));
        groups
    }

    /// The rules of the expected event of a finding, the most likely one to be broken first.
    #[must_use]
    pub fn suspects(&self, finding: &Finding) -> Vec<RuleId> {
        let mut rules = finding.signature.rules.clone();
        rules.sort_by(|a, b| self.by_suspicion(*b, *a));
        rules
    }

    /// Compares the shares of events citing two rules that disagree, then their numbers.
    fn by_suspicion(&self, a: RuleId, b: RuleId) -> Ordering {
        let count = |rule: RuleId| {
            let disagreeing = u128::from(self.disagreeing.get(&rule).copied().unwrap_or_default());
            (disagreeing, disagreeing + u128::from(self.agreeing.get(&rule).copied().unwrap_or_default()))
        };
        let ((a_disagreeing, a_all), (b_disagreeing, b_all)) = (count(a), count(b));
        (a_disagreeing * b_all).cmp(&(b_disagreeing * a_all)).then(a_disagreeing.cmp(&b_disagreeing))
    }
}
