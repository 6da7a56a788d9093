//! How two offset elements lie to one another, by the signs of the gaps between them (E100L-NRC-51 to
//! E100L-NRC-53).

use std::cmp::Ordering;

/// How two offset elements lie to one another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Meeting {
    /// They cross.
    Crossing,
    /// They have one common point.
    Touching,
}

impl Meeting {
    /// The meeting by the signs of the gaps that must not be negative; none if one is.
    #[must_use]
    pub fn of(gaps: impl IntoIterator<Item = Ordering>) -> Option<Self> {
        gaps.into_iter().try_fold(Self::Crossing, |meeting, gap| match gap {
            Ordering::Less => None,
            Ordering::Equal => Some(Self::Touching),
            Ordering::Greater => Some(meeting),
        })
    }
}
