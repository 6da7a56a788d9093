//! Rule ids and small sets of them.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::rule_ids::IDS;

/// The permanent id of a rule, such as `E100L-G50-02`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RuleId(u16);

impl RuleId {
    pub(super) const fn from_index(index: u16) -> Self {
        Self(index)
    }

    /// The rule with this id, if there is one.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let index = IDS.iter().position(|id| *id == text)?;
        u16::try_from(index).ok().map(Self)
    }

    /// The id as text.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        IDS.get(usize::from(self.0)).copied().unwrap_or_default()
    }

    /// Every rule, in the order of the catalogue.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..).zip(IDS).map(|(index, _)| Self(index))
    }
}

impl fmt::Display for RuleId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl fmt::Debug for RuleId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl Serialize for RuleId {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.as_str())
    }
}

impl<'de> Deserialize<'de> for RuleId {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Self::parse(&text).ok_or_else(|| de::Error::custom(format!("unknown rule id {text:?}")))
    }
}

/// A set of at most [`RuleSet::CAPACITY`] rules, in the order of the catalogue.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct RuleSet {
    length: u8,
    ids: [RuleId; Self::CAPACITY],
}

impl RuleSet {
    /// The most rules that one event cites.
    pub const CAPACITY: usize = 31;

    /// No rule.
    pub const EMPTY: Self = Self { length: 0, ids: [RuleId(u16::MAX); Self::CAPACITY] };

    /// The set of these rules.
    #[must_use]
    pub const fn of(rules: &[RuleId]) -> Self {
        let mut set = Self::EMPTY;
        let mut next = 0;
        while next < rules.len() {
            set = set.with(rules[next]);
            next += 1;
        }
        set
    }

    /// The set and one more rule. A rule too many is left out.
    #[must_use]
    pub const fn with(mut self, rule: RuleId) -> Self {
        let length = self.length as usize;
        let mut place = length;
        while place > 0 && self.ids[place - 1].0 >= rule.0 {
            place -= 1;
        }
        if length == Self::CAPACITY || place < length && self.ids[place].0 == rule.0 {
            return self;
        }
        let mut index = length;
        while index > place {
            self.ids[index] = self.ids[index - 1];
            index -= 1;
        }
        self.ids[place] = rule;
        self.length += 1;
        self
    }

    /// The union of two sets.
    #[must_use]
    pub const fn union(mut self, other: Self) -> Self {
        let mut next = 0;
        while next < other.length as usize {
            self = self.with(other.ids[next]);
            next += 1;
        }
        self
    }

    /// The rules, in the order of the catalogue.
    #[must_use]
    pub fn as_slice(&self) -> &[RuleId] {
        self.ids.get(..usize::from(self.length)).unwrap_or_default()
    }
}

impl Default for RuleSet {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl FromIterator<RuleId> for RuleSet {
    fn from_iter<I: IntoIterator<Item = RuleId>>(rules: I) -> Self {
        rules.into_iter().fold(Self::EMPTY, Self::with)
    }
}

impl fmt::Debug for RuleSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.as_slice()).finish()
    }
}

impl Serialize for RuleSet {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.as_slice())
    }
}

impl<'de> Deserialize<'de> for RuleSet {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Vec::<RuleId>::deserialize(deserializer)?.into_iter().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::{RuleId, RuleSet};

    #[test]
    fn a_set_is_sorted_and_has_no_duplicates() {
        let rules: Vec<_> = RuleId::all().take(4).collect();
        let set = RuleSet::of(&[rules[2], rules[0], rules[3], rules[0], rules[2]]);
        assert_eq!(set.as_slice(), [rules[0], rules[2], rules[3]]);
        assert_eq!(set.union(RuleSet::of(&[rules[1]])).as_slice(), rules);
    }

    #[test]
    fn every_id_reads_back() {
        for rule in RuleId::all() {
            assert_eq!(RuleId::parse(rule.as_str()), Some(rule));
        }
    }

    #[test]
    fn a_set_shows_its_ids() {
        let rules: Vec<_> = RuleId::all().take(2).collect();
        assert_eq!(format!("{:?}", RuleSet::of(&rules)), format!("{{{}, {}}}", rules[0], rules[1]));
    }

    #[test]
    fn a_set_reads_back() {
        let set: RuleSet = RuleId::all().take(3).collect();
        assert_eq!(set.as_slice().len(), 3);
        let json = serde_json::to_string(&set).unwrap_or_default();
        assert_eq!(serde_json::from_str::<RuleSet>(&json).ok(), Some(set));
    }
}
