//! The mirror image of turret B (E100L-MIRR-05). Any coordinates.

/// X in the sense of the machine, from X in the sense of the turret, and the other way round; the least of 64 bits
/// becomes the largest.
#[must_use]
pub fn x(x: i64, mirrored: bool) -> i64 {
    if mirrored { x.saturating_neg() } else { x }
}
