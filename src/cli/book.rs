//! The rule texts by id.

use std::collections::BTreeMap;

use turnspec_oracle::book::{RuleText, e100l};
use turnspec_oracle::vocabulary::RuleId;

use super::Failure;

/// Every rule text.
#[derive(Default)]
pub struct Book {
    rules: BTreeMap<RuleId, RuleText>,
}

impl Book {
    /// Reads the rule texts that the program carries.
    ///
    /// # Errors
    /// When one of them is malformed.
    pub fn open() -> Result<Self, Failure> {
        let rules = e100l().map_err(|error| Failure::about("rule texts", error))?;
        Ok(Self { rules: rules.into_iter().map(|rule| (rule.id, rule)).collect() })
    }

    /// The rules in the order of their ids.
    pub fn rules(&self) -> impl Iterator<Item = &RuleText> {
        self.rules.values()
    }

    /// The text of a rule, if there is one.
    pub fn rule(&self, id: RuleId) -> Option<&RuleText> {
        self.rules.get(&id)
    }

    /// Id and title of a rule, or the id alone if it has no text.
    pub fn heading(&self, id: RuleId) -> String {
        self.rule(id).map_or_else(|| id.to_string(), heading)
    }
}

/// Id and title of a rule.
pub fn heading(rule: &RuleText) -> String {
    format!("{} · {}", rule.id, rule.title)
}
