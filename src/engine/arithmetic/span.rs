//! Places in a program text.

/// A byte offset as a trace holds it; a text beyond 4 GiB keeps the largest.
#[inline]
#[must_use]
pub fn offset(offset: usize) -> u32 {
    u32::try_from(offset).unwrap_or(u32::MAX)
}
