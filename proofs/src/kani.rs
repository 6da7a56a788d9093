//! Stands in for the crate `kani` where the model checker is not at work: `any` draws a value from a fixed
//! pseudo-random sequence, `assume` abandons a sample, `cover!` notes that a situation was met.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, UnwindSafe, catch_unwind, resume_unwind};

/// Samples that a statement is tried with.
const SAMPLES: u64 = 4096;
/// Samples that have to meet the assumptions of a statement.
const LEAST: usize = 64;

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

/// Draws a number between two bounds, both included: the bounds and their neighbours, numbers near zero, or any.
#[must_use]
pub fn between(low: i128, high: i128) -> i128 {
    let span = high.wrapping_sub(low).cast_unsigned();
    let [kind, near, ..] = next().to_le_bytes();
    let near = i128::from(near % 4);
    let value = match kind % 8 {
        0 => low.saturating_add(near),
        1 => high.saturating_sub(near),
        2 => near - 2,
        3 | 4 => i128::any() % high.max(1),
        _ if span == u128::MAX => i128::any(),
        _ => low.wrapping_add((u128::any() % (span + 1)).cast_signed()),
    };
    value.clamp(low, high)
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
/// When a sample refutes it, when one of its situations was never met, or when hardly a sample meets its
/// assumptions.
pub fn holds(statement: fn()) {
    let mut held = 0;
    for outcome in samples(statement) {
        match outcome {
            Outcome::Refuted(counterexample) => resume_unwind(counterexample),
            Outcome::Held => held += 1,
            Outcome::Abandoned => {}
        }
    }
    assert!(held >= LEAST, "only {held} samples meet the assumptions");
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
    Abandoned,
    Refuted(Box<dyn std::any::Any + Send>),
}

fn samples(statement: impl Fn() + UnwindSafe) -> impl Iterator<Item = Outcome> {
    COVERED.with_borrow_mut(BTreeMap::clear);
    (0..SAMPLES).map(move |sample| {
        STATE.set(sample);
        match catch_unwind(AssertUnwindSafe(&statement)) {
            Ok(()) => Outcome::Held,
            Err(payload) if payload.is::<Abandoned>() => Outcome::Abandoned,
            Err(payload) => Outcome::Refuted(payload),
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

impl Arbitrary for bool {
    fn any() -> Self {
        next().is_multiple_of(2)
    }
}

/// Unsigned numbers: extremes, neighbours of powers of two, and numbers of every width.
macro_rules! unsigned {
    ($($type:ident)*) => {
        $(impl Arbitrary for $type {
            fn any() -> Self {
                let [kind, width, near, ..] = next().to_le_bytes();
                let width = u32::from(width) % Self::BITS;
                #[allow(clippy::cast_possible_truncation)]
                let bits = (u128::from(next()) << 64 | u128::from(next())) as Self;
                match kind % 16 {
                    0 => 0,
                    1 => Self::MAX,
                    2..=4 => ((1 as Self) << width).wrapping_add(Self::from(near % 5)).wrapping_sub(2),
                    _ => bits >> width,
                }
            }
        })*
    };
}
unsigned!(u16 u32 u64 usize u128);

/// Signed numbers: those of the unsigned ones, so that both signs, both extremes and every width occur.
macro_rules! signed {
    ($($type:ident $unsigned:ident)*) => {
        $(impl Arbitrary for $type {
            fn any() -> Self {
                let bits = $unsigned::any();
                match next() % 4 {
                    0 => bits.cast_signed(),
                    1 => Self::MIN.wrapping_add((bits >> 1).cast_signed()),
                    2 => (bits >> 1).cast_signed(),
                    _ => (bits >> 1).cast_signed().wrapping_neg(),
                }
            }
        })*
    };
}
signed!(i8 u8 i32 u32 i64 u64 i128 u128);

impl<const N: usize> Arbitrary for [u8; N] {
    fn any() -> Self {
        std::array::from_fn(|_| u8::any())
    }
}

#[cfg(test)]
mod tests {
    use super::{any, assume, fails, holds, note_cover, samples};

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
    #[should_panic(expected = "only 0 samples")]
    fn contradictory_assumptions_are_reported() {
        holds(|| {
            let value: u8 = any();
            assume(value < 10);
            assume(value > 20);
        });
    }

    #[test]
    fn both_extremes_and_zero_are_drawn() {
        for wanted in [i64::MIN, 0, i64::MAX] {
            fails_to_avoid(wanted);
        }
    }

    fn fails_to_avoid(wanted: i64) {
        let drawn = samples(|| ()).any(|_| any::<i64>() == wanted);
        assert!(drawn, "{wanted} is never drawn");
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
