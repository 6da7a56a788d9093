//! A travel limit and a target (E100L-LIM-01, E100L-LIM-02). Any coordinates.

/// The limits of an axis in nanometres; none where none is set.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TravelLimit {
    /// Positive limit.
    pub positive: Option<i64>,
    /// Negative limit.
    pub negative: Option<i64>,
}

/// Where a target lies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Limited {
    /// Beyond no limit.
    Allowed,
    /// Beyond the positive limit, with the limit.
    Positive(i64),
    /// Beyond the negative limit.
    Negative,
}

impl TravelLimit {
    /// Which limit a target lies beyond; a negative limit comes first where both are set the wrong way round.
    #[must_use]
    pub fn of(&self, target: i64) -> Limited {
        match (self.negative, self.positive) {
            (Some(limit), _) if target < limit => Limited::Negative,
            (_, Some(limit)) if target > limit => Limited::Positive(limit),
            _ => Limited::Allowed,
        }
    }
}
