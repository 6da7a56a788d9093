//! Levels of LAP (E100L-AP1-02, E100L-LAPC-03): coordinates of the infeed axis in nanometres, below 2^60; `up` is 1 where
//! heights are greater with greater coordinates, else -1.

/// The level below another by a depth, which is not negative and below 2^38.
#[must_use]
pub fn below(level: i64, up: i64, depth: i64) -> i64 {
    level - up * depth
}

/// Whether a level is that of a change point or below it.
#[must_use]
pub fn has_reached(level: i64, point: i64, up: i64) -> bool {
    up * (level - point) <= 0
}
