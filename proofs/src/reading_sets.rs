//! Theorems about the readings that an event names.

use turnspec_oracle::vocabulary::{Reading, ReadingSet};

#[cfg(stand_in)]
use crate::kani;

fn reading() -> Reading {
    let index = usize::from(kani::any::<u8>());
    kani::assume(index < Reading::ALL.len());
    Reading::ALL[index]
}

fn names(set: ReadingSet, reading: Reading) -> bool {
    set.iter().any(|each| each == reading)
}

theorems! {
    /// A set of two readings names both of them and no other; no reading is lost to another.
    /// Of: `ReadingSet::with`, `ReadingSet::iter`
    /// Assumes: two readings.
    /// Rules: none (the form of the trace)
    #[unwind(16)]
    fn a_set_names_what_was_put_into_it() {
        let (first, second, other) = (reading(), reading(), reading());
        let set = ReadingSet::default().with(first).with(second);
        kani::cover!(first != second, "two readings");
        assert!(!set.is_empty());
        assert!(names(set, other) == (other == first || other == second));
    }

    /// The order of readings does not matter, nor does naming one twice; the union of two sets is the set of
    /// the readings of both.
    /// Of: `ReadingSet::with`, `ReadingSet::union`
    /// Assumes: two readings.
    /// Rules: none (the form of the trace)
    #[unwind(16)]
    fn insertion_and_union_agree() {
        let (first, second) = (reading(), reading());
        let empty = ReadingSet::default();
        let set = empty.with(first).with(second);
        kani::cover!(first == second, "one reading twice");
        assert!(set == empty.with(second).with(first));
        assert!(set == set.with(first));
        assert!(set == empty.with(first).union(empty.with(second)));
        assert!(set.union(empty) == set);
    }
}

refutations! {
    /// False: a union is one of the two sets.
    #[unwind(16)]
    fn a_union_is_one_of_its_parts() {
        let (one, two) = (ReadingSet::default().with(reading()), ReadingSet::default().with(reading()));
        let union = one.union(two);
        assert!(union == one || union == two);
    }
}
