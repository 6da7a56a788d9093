//! The nose of the tool as it follows an element: its radius, the way to its centre, on which side it is, and
//! whether an arc has room for it (E100L-NRC-02, E100L-NRC-04, E100L-NRC-05, E100L-NRC-30 to E100L-NRC-33,
//! E100L-NRC-48).

use super::plane::{Direction, Point, square};

/// The nose radius, and the way from the tip to the nose centre, from the lengths of the nose along X and Z in
/// nanometres: those of a set-up or a variable, at most 2^61 in size.
/// The larger amount is the radius, of a cutter too (E100L-CRC-09).
#[inline]
#[must_use]
pub fn nose([x, z]: [i64; 2]) -> (i64, Point) {
    (x.abs().max(z.abs()), Point { x: 2 * x, z })
}

/// The signed distance of the nose centre to the left of an element, in half nanometres. The tool is on the side 1,
/// the left, or -1; any radius in nanometres.
#[inline]
#[must_use]
pub fn offset(side: i128, radius: i64) -> i128 {
    2 * side * i128::from(radius)
}

/// Whether a nose that touches the first of two parallel elements at its end touches the second one there too.
/// Offsets as of [`offset`]; `same`: the second one leads on, not back.
#[inline]
#[must_use]
pub fn touches_both(before: i128, after: i128, same: bool) -> bool {
    before == if same { after } else { -after }
}

/// Whether a nose does not fit into an arc: it takes `inward` off the radius, more than there is; outside that is
/// negative. In the centre itself, where an arc has no direction, every nose is too large. At most 2^62 in size, the way
/// from the centre to the arc at most 2^60 in each component.
#[must_use]
pub fn is_too_large(inward: i128, from_centre: Direction) -> bool {
    let radius = square(from_centre);
    radius == 0 || inward > 0 && inward * inward > radius
}
