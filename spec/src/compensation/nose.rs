//! Side, radius and centre of the nose (E100L-NRC-01, E100L-NRC-02, E100L-NRC-04, E100L-NRC-05).

use crate::controls::e100l::g_codes::GGroup;
use crate::integer::nose;
use crate::path::Point;
use crate::state::State;

/// On which side of the contour the tool is, seen in the direction of travel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// G41.
    Left,
    /// G42.
    Right,
}

/// The nose as it follows an element (E100L-NRC-11: as it is in the block of the element).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Nose {
    /// Side.
    pub side: Side,
    /// R, in nanometres.
    pub radius: i64,
    /// v: from the tip to the nose centre, X as a diameter, and Z.
    pub to_centre: Point,
}

impl Nose {
    /// The nose in force, in compensation.
    pub fn in_force(state: &State) -> Option<Self> {
        let side = match state.modes.get(GGroup::Compensation) {
            41 => Side::Left,
            42 => Side::Right,
            _ => return None,
        };
        // VNSRX and VNSRZ are both lengths of the nose circle: radius values.
        let (x, z) = state.memory.nose_radii.get(usize::from(state.nose)).copied().unwrap_or_default();
        Some(Self { side, radius: nose::radius(x, z), to_centre: nose::to_centre(x, z) })
    }

    /// The cutter in force, with the radius of the entry (E100L-CRC-08, E100L-CRC-09): its axis is the point that follows the
    /// program (E100L-CRC-10).
    pub fn of_cutter(state: &State) -> Option<Self> {
        Self::in_force(state).map(|nose| Self { to_centre: (0, 0), ..nose })
    }

    /// s·R: how far the nose centre is to the left of the contour.
    pub fn offset(&self) -> i64 {
        nose::offset(self.side == Side::Left, self.radius)
    }
}
