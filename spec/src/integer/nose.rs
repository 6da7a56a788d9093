//! The nose of the tool, and where its tip goes (E100L-NRC-02, E100L-NRC-04, E100L-NRC-05, E100L-NRC-07).
//!
//! Lengths and coordinates are in nanometres; points are X, as a diameter, and Z.

/// R: the larger one of the lengths of the nose circle, without their signs. Any but the least of 64 bits.
#[must_use]
pub fn radius(x: i64, z: i64) -> i64 {
    x.abs().max(z.abs())
}

/// v: from the tip to the nose centre, for lengths of at most 2^61 in size.
#[must_use]
pub fn to_centre(x: i64, z: i64) -> (i64, i64) {
    (2 * x, z)
}

/// s·R: how far the nose centre is to the left of the contour, for a radius of 0 or more.
#[must_use]
pub fn offset(tool_left: bool, radius: i64) -> i64 {
    if tool_left { radius } else { -radius }
}

/// Whether contact with an element of the first offset is contact with the next one, of the second offset, whose
/// tangent leads onward, the same way, or else back. Any offsets but the least of 64 bits.
#[must_use]
pub fn touches_both(offset: i64, next: i64, onward: bool) -> bool {
    offset == if onward { next } else { -next }
}

/// T = C − v, from the latched centre; what is beyond 64 bits stays at their end, out of every range.
#[must_use]
pub fn tip(centre: (i64, i64), to_centre: (i64, i64)) -> (i64, i64) {
    (centre.0.saturating_sub(to_centre.0), centre.1.saturating_sub(to_centre.1))
}

/// C = T + v, for coordinates and lengths of at most 2^61 in size.
#[must_use]
pub fn centre(tip: (i64, i64), to_centre: (i64, i64)) -> (i64, i64) {
    (tip.0 + to_centre.0, tip.1 + to_centre.1)
}

/// The machine coordinate of P + (T − P), from those of T and P in the program and that of P in the machine. The
/// latter at most 2^60 in size; any tip, as of [`tip`].
#[must_use]
pub fn machine(tip: i64, program: i64, machine: i64) -> i64 {
    tip.saturating_add(machine - program)
}

/// T in the program, where an axis is in the machine, from the coordinates of P in both. At most 2^60 in size each.
#[must_use]
pub fn tip_at(axis: i64, program: i64, machine: i64) -> i64 {
    program + axis - machine
}
