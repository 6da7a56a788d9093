//! Blocks without X/Z motion in compensation (E100L-NRC-43, E100L-NRC-44).

/// How many blocks without X/Z motion came since a motion began to wait for its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum IdleBlocks {
    /// None: the motion has just begun to wait.
    #[default]
    None,
    /// One, which changes nothing of the path.
    One,
    /// So many that no motion waits any more.
    Many,
}

impl IdleBlocks {
    /// With one block more. `waits`: a motion waits before it.
    #[must_use]
    pub fn more(self, waits: bool) -> Self {
        if waits && self == Self::None { Self::One } else { Self::Many }
    }
}
