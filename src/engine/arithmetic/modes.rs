//! The numbers of modal calls (E100L-MODIN-05 to E100L-MODIN-08).

/// Most modes at a time (E100L-MODIN-05).
pub const MOST: usize = 8;

/// The number of the next mode, when so many are active.
#[must_use]
pub fn next(active: usize) -> u8 {
    u8::try_from(active.min(MOST)).unwrap_or(0) + 1
}

/// How many of the active modes a motion calls: all of them, within the call of one those before it
/// (E100L-MODIN-07, E100L-MODIN-08).
#[must_use]
pub fn to_call(active: usize, inside: Option<u8>) -> u8 {
    match inside {
        Some(mode) => mode.saturating_sub(1),
        None => next(active) - 1,
    }
}
