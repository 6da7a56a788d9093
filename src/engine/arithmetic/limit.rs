//! Ranges and travel limits of one coordinate (E100L-ADDR-01, E100L-LIM-01, E100L-LIM-02). All of `i64`.

/// What the travel limits make of a machine coordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Limited {
    /// It lies between them.
    Within,
    /// It lies beyond the positive limit, which is this one.
    AbovePositive(i64),
    /// It lies beyond the negative limit.
    BelowNegative,
}

/// Compares a machine coordinate with the limits of its axis, the negative one first.
#[inline]
#[must_use]
pub fn limited(machine: i64, negative: Option<i64>, positive: Option<i64>) -> Limited {
    if negative.is_some_and(|limit| machine < limit) {
        return Limited::BelowNegative;
    }
    match positive {
        Some(limit) if machine > limit => Limited::AbovePositive(limit),
        _ => Limited::Within,
    }
}

/// Whether a coordinate is at most this long, whatever its sign.
#[inline]
#[must_use]
pub fn in_range(coordinate: i64, longest: i64) -> bool {
    coordinate.unsigned_abs() <= longest.unsigned_abs()
}
