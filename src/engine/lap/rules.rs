//! The rules of LAP that the motions of its cycles cite, as bits, and the sets of them and of the other rules.

use turnspec_oracle::vocabulary::{RuleId, RuleSet, rule_ids};

use crate::engine::cite::Cites;

/// A set of rules of LAP.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Rules(u64);

impl Rules {
    /// The union.
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The set, with another one under a condition.
    pub const fn and_if(self, condition: bool, other: Self) -> Self {
        if condition { self.and(other) } else { self }
    }

    fn added_to(self, mut set: RuleSet) -> RuleSet {
        let mut rest = self.0;
        while rest != 0 {
            if let Some(rule) = TABLE.get(rest.trailing_zeros() as usize) {
                set = set.with(*rule);
            }
            rest &= rest - 1;
        }
        set
    }
}

macro_rules! rules {
    ($($name:ident)*) => {
        #[allow(non_camel_case_types, clippy::upper_case_acronyms)]
        #[repr(u8)]
        enum Bit { $($name),* }
        /// The rules in the order of the bits.
        const TABLE: &[RuleId] = &[$(rule_ids::$name),*];
        $(
            pub const $name: Rules = Rules(1 << Bit::$name as u8);
        )*
    };
}

rules! {
    LAP_01 LAP_02 LAP_09 LAP_05 LAP_06 LAP_07 LAP_08 LAP_16 LAP_21 LAP_18 LAPC_01 LAPC_02 LAPC_03 LAPC_05 LAPC_07
    AP1_01 AP1_02 AP1_03 AP1_04 AP1_05 AP1_06 AP1_07 AP1_08 AP1_09 AP1_10 AP1_11 AP1_12 AP1_14
    AP2_01 AP2_02 AP2_03 AP2_04 AP2_05 AP3_01 AP3_02 AP3_03 AP3_04
    AP4_01 AP4_02 AP4_03 AP4_04 AP4_05 AP4_06 AP4_07 AP4_08 AP4_09
    AP5_01 AP5_02 AP5_03 AP5_04 AP5_05 AP5_06 AP5_07
}

/// Remembers the sets made last.
#[derive(Debug, Default)]
pub struct RuleCache {
    entries: Vec<(Cites, Rules, RuleSet)>,
}

impl RuleCache {
    const SIZE: usize = 16;

    /// The set of some citations and rules of LAP.
    pub fn rules(&mut self, cites: Cites, rules: Rules, base: impl FnOnce() -> RuleSet) -> RuleSet {
        let found = self.entries.iter().find(|entry| (entry.0, entry.1) == (cites, rules));
        if let Some((.., set)) = found {
            return *set;
        }
        let set = rules.added_to(base());
        if self.entries.len() >= Self::SIZE {
            self.entries.clear();
        }
        self.entries.push((cites, rules, set));
        set
    }
}
