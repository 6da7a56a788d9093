//! Stands in for the crate `kani` where the model checker is not at work: `any` draws a value from a fixed
//! pseudo-random sequence, `assume` abandons a sample, `cover!` notes that a situation was met.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, UnwindSafe, catch_unwind, resume_unwind};

/// Samples that a statement is tried with.
const SAMPLES: u64 = 4096;

thread_local! {
    static STATE: Cell<u64> = const { Cell::new(0) };
    static COVERED: RefCell<BTreeMap<&'static str, bool>> = const { RefCell::new(BTreeMap::new()) };
}

/// A type of which any value can be drawn.
pub trait Arbitrary {
    /// Draws a value; extreme and small values are drawn often.
    fn any() -> Self;
}

/// Draws any value.
#[must_use]
pub fn any<T: Arbitrary>() -> T {
    T::any()
}

/// Abandons the sample unless the condition holds.
pub fn assume(condition: bool) {
    if !condition {
        resume_unwind(Box::new(Abandoned));
    }
}

/// Notes whether a situation was met; a statement whose situations are never met is tested in vain.
pub fn note_cover(condition: bool, situation: &'static str) {
    COVERED.with_borrow_mut(|covered| *covered.entry(situation).or_default() |= condition);
}

/// Demands that some input meets the condition.
#[macro_export]
macro_rules! cover {
    ($condition:expr, $situation:literal) => {
        $crate::kani::note_cover($condition, $situation)
    };
}
pub use crate::cover;

/// Tries a statement that holds.
///
/// # Panics
/// When a sample refutes it, or when one of its situations was never met.
pub fn holds(statement: fn()) {
    for outcome in samples(statement) {
        if let Outcome::Refuted(counterexample) = outcome {
            resume_unwind(counterexample);
        }
    }
    COVERED.with_borrow(|covered| {
        let never: Vec<_> =
            covered.iter().filter(|(_, met)| !**met).map(|(situation, _)| situation).collect();
        assert!(never.is_empty(), "never met: {never:?}");
    });
}

/// Tries a statement that does not hold.
///
/// # Panics
/// When no sample refutes it.
pub fn fails(statement: fn()) {
    let refuted = samples(statement).any(|outcome| matches!(outcome, Outcome::Refuted(_)));
    assert!(refuted, "no counterexample in {SAMPLES} samples");
}

struct Abandoned;

enum Outcome {
    Held,
    Refuted(Box<dyn std::any::Any + Send>),
}

fn samples(statement: impl Fn() + UnwindSafe) -> impl Iterator<Item = Outcome> {
    COVERED.with_borrow_mut(BTreeMap::clear);
    (0..SAMPLES).map(move |sample| {
        STATE.set(sample);
        match catch_unwind(AssertUnwindSafe(&statement)) {
            Err(payload) if !payload.is::<Abandoned>() => Outcome::Refuted(payload),
            _ => Outcome::Held,
        }
    })
}

/// The next number of the sequence (SplitMix64).
fn next() -> u64 {
    let state = STATE.get().wrapping_add(0x9E37_79B9_7F4A_7C15);
    STATE.set(state);
    let mixed = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}

impl Arbitrary for u8 {
    fn any() -> Self {
        let [kind, value, ..] = next().to_le_bytes();
        match kind % 8 {
            0 => 0,
            1 => Self::MAX,
            2..=5 => value % 32,
            _ => value,
        }
    }
}

impl<const N: usize> Arbitrary for [u8; N] {
    fn any() -> Self {
        std::array::from_fn(|_| u8::any())
    }
}

#[cfg(test)]
mod tests {
    use super::{any, assume, fails, holds, note_cover};

    #[test]
    fn an_assumption_abandons_a_sample() {
        holds(|| {
            let value: u8 = any();
            assume(value < 10);
            assert!(value < 10);
        });
    }

    #[test]
    fn a_false_statement_is_refuted() {
        fails(|| assert!(any::<u8>() < 255));
    }

    #[test]
    #[should_panic(expected = "never met")]
    fn a_situation_that_is_never_met_is_reported() {
        holds(|| note_cover(false, "a situation"));
    }

    #[test]
    #[should_panic(expected = "no counterexample")]
    fn a_twin_that_holds_is_reported() {
        fails(|| {});
    }
}
