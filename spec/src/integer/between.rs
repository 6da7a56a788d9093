//! Blocks without X/Z motion between two elements (E100L-NRC-43, E100L-NRC-44).

/// Whether the block that has just passed without X/Z motion leaves no motion waiting: none waits anyhow, or it is
/// the second one since the motion that waits.
#[must_use]
pub fn is_too_long(waits: bool, one_between: bool) -> bool {
    !waits || one_between
}
