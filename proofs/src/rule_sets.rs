//! Theorems about sets of rule ids: what an event cites is sorted, free of duplicates and bounded.
//!
//! A set compares ids and does nothing else with them, so [`RULES`] stands for all of them.

use turnspec_oracle::vocabulary::rule_ids as id;
use turnspec_oracle::vocabulary::{RuleId, RuleSet};

#[cfg(stand_in)]
use crate::kani;

/// One rule more than a set holds, in the order of the catalogue.
const RULES: [RuleId; RuleSet::CAPACITY + 1] = [
    id::ABS_01,
    id::ABS_02,
    id::ABS_03,
    id::DIA_01,
    id::DIA_02,
    id::G00_01,
    id::G01_01,
    id::G01_02,
    id::G01_03,
    id::G01_04,
    id::CIRC_01,
    id::CIRC_02,
    id::CIRC_03,
    id::CIRC_04,
    id::CIRC_05,
    id::CIRC_06,
    id::CIRC_07,
    id::CIRC_08,
    id::CIRC_09,
    id::CIRC_10,
    id::CHAM_01,
    id::CHAM_02,
    id::CHAM_03,
    id::CHAM_04,
    id::CHAM_05,
    id::CHAM_06,
    id::CHAM_07,
    id::CHAM_08,
    id::CHAM_09,
    id::CHAM_10,
    id::CHAM_11,
    id::FEED_01,
];

fn rule() -> RuleId {
    let index = usize::from(kani::any::<u8>());
    kani::assume(index < RULES.len());
    RULES[index]
}

fn cites(set: &RuleSet, rule: RuleId) -> bool {
    set.as_slice().contains(&rule)
}

/// A set without its rule at one place of [`RULES`]: it holds as many as it can.
fn full_set_without(omitted: usize) -> RuleSet {
    let mut set = RuleSet::EMPTY;
    let mut next = 0;
    while next < RULES.len() {
        if next != omitted {
            set = set.with(RULES[next]);
        }
        next += 1;
    }
    set
}

theorems! {
    /// Whatever four rules are put into a set in whatever order, it lists them in the order of the
    /// catalogue, none twice.
    /// Of: `RuleSet::of`, `RuleSet::as_slice`
    /// Assumes: four insertions; 24 ids, which stand for all: a set compares them and does nothing else with them.
    /// Rules: none (the form of the trace)
    #[unwind(26)]
    fn a_set_is_sorted_without_duplicates() {
        let rules = [rule(), rule(), rule(), rule()];
        let set = RuleSet::of(&rules);
        let list = set.as_slice();
        kani::cover!(list.len() == 4, "four different rules");
        kani::cover!(list.len() < 4, "a rule twice");
        assert!(!list.is_empty() && list.len() <= 4);
        for place in 1..list.len() {
            assert!(list[place - 1] < list[place]);
        }
    }

    /// A set with room cites every rule that was put into it, and nothing else.
    /// Of: `RuleSet::of`, `RuleSet::as_slice`
    /// Assumes: three insertions; 24 ids, which stand for all: a set compares them and does nothing else with them.
    /// Rules: none (the form of the trace)
    #[unwind(26)]
    fn a_set_cites_what_was_put_into_it() {
        let (first, second, third, other) = (rule(), rule(), rule(), rule());
        let set = RuleSet::of(&[first, second, third]);
        assert!(cites(&set, first) && cites(&set, second) && cites(&set, third));
        let among = other == first || other == second || other == third;
        kani::cover!(among, "a rule of the set");
        kani::cover!(!among, "another rule");
        assert!(cites(&set, other) == among);
    }

    /// The order in which two rules are put into a set does not matter, nor does putting one in twice.
    /// Of: `RuleSet::with`
    /// Assumes: three insertions; 24 ids, which stand for all: a set compares them and does nothing else with them.
    /// Rules: none (the form of the trace)
    #[unwind(26)]
    fn insertion_commutes_and_repeats() {
        let (before, first, second) = (rule(), rule(), rule());
        let set = RuleSet::EMPTY.with(before);
        kani::cover!(first > second, "against the order of the catalogue");
        assert!(set.with(first).with(second) == set.with(second).with(first));
        assert!(set.with(first).with(first) == set.with(first));
    }

    /// The union of two sets of two rules cites exactly the rules of both, whichever is named first.
    /// Of: `RuleSet::union`
    /// Assumes: two rules a set; 24 ids, which stand for all: a set compares them and does nothing else with them.
    /// Rules: none (the form of the trace)
    #[unwind(26)]
    fn a_union_cites_both_sets() {
        let (one, two) = (RuleSet::of(&[rule(), rule()]), RuleSet::of(&[rule(), rule()]));
        let union = one.union(two);
        let other = rule();
        kani::cover!(union.as_slice().len() == 4, "sets without a common rule");
        assert!(union == two.union(one));
        assert!(cites(&union, other) == (cites(&one, other) || cites(&two, other)));
    }

    /// A full set takes no further rule, keeps those that it has, and nothing overflows.
    /// Of: `RuleSet::with`
    /// Assumes: a set of 23 rules, its capacity; 24 ids, which stand for all: a set compares them and does nothing else with them.
    /// Rules: none (the form of the trace)
    #[unwind(26)]
    fn a_full_set_stays_as_it_is() {
        let omitted = usize::from(kani::any::<u8>());
        kani::assume(omitted < RULES.len());
        let full = full_set_without(omitted);
        kani::cover!(omitted == 0, "the rule left out would come first");
        kani::cover!(omitted == RULES.len() - 1, "the rule left out would come last");
        assert!(full.as_slice().len() == RuleSet::CAPACITY);
        assert!(full.with(RULES[omitted]) == full);
    }
}

refutations! {
    /// False: a set cites every rule that was put into it, however many there are.
    #[unwind(26)]
    fn a_set_without_bound() {
        let omitted = usize::from(kani::any::<u8>());
        kani::assume(omitted < RULES.len());
        assert!(cites(&full_set_without(omitted).with(RULES[omitted]), RULES[omitted]));
    }
}
