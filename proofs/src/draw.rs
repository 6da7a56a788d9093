//! Numbers within bounds: any of them for the model checker, a varied sample for the property tests.

#[cfg(stand_in)]
use crate::kani;

/// Any number from `low` to `high`.
#[must_use]
pub fn between(low: i64, high: i64) -> i64 {
    #[cfg(stand_in)]
    let value = i64::try_from(kani::between(low.into(), high.into())).unwrap_or(low);
    #[cfg(not(stand_in))]
    let value = kani::any();
    kani::assume(low <= value && value <= high);
    value
}

/// Any number of at most this size, of either sign.
#[must_use]
pub fn within(size: i64) -> i64 {
    between(-size, size)
}

/// As [`within`], in 128 bits.
#[must_use]
pub fn within_wide(size: i128) -> i128 {
    #[cfg(stand_in)]
    let value = kani::between(-size, size);
    #[cfg(not(stand_in))]
    let value = kani::any();
    kani::assume(-size <= value && value <= size);
    value
}

/// A factor of products whose values are asserted: at most 8 in size for the model checker, which has to multiply
/// them out, at most `size` for the property tests.
#[must_use]
pub fn factor(size: i128) -> i128 {
    #[cfg(stand_in)]
    let value = kani::between(-size, size);
    #[cfg(not(stand_in))]
    let value = i128::from(kani::any::<i8>() >> 4);
    kani::assume(-size <= value && value <= size);
    value
}

/// One of a few values.
#[must_use]
pub fn one_of<T: Copy>(values: &[T]) -> T {
    let last = i64::try_from(values.len()).unwrap_or(0) - 1;
    values[usize::try_from(between(0, last)).unwrap_or(0)]
}

/// A value or none.
#[must_use]
pub fn perhaps(value: i64) -> Option<i64> {
    kani::any::<bool>().then_some(value)
}
