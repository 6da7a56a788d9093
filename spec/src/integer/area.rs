//! The areas of the chuck (E100L-BARR-02) and of the tailstock (E100L-BARR-03), from the data in force
//! (E100L-BARR-07). Sizes are 0 to 2^60, positions at most 2^60 in size.

use crate::vocabulary::Barriers;

/// The bounds of a rectangle in nanometres, the lower one first; X as a diameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bounds {
    /// The bounds of Z.
    pub z: (i64, i64),
    /// The bounds of X.
    pub x: (i64, i64),
}

/// Gripping part and jaw, each with its image of negative X. D and D1 are lengths of the radius.
#[must_use]
pub fn chuck(data: &Barriers) -> [Option<Bounds>; 4] {
    let (length, height) = (data.jaw_length.0, data.jaw_height.0);
    let (grip_length, grip_height) = (data.grip_length.0, data.grip_height.0);
    let (inside, front) = (data.chuck_x.0.abs(), data.chuck_z.0);
    let (mut grip, mut jaw) = ([None; 2], [None; 2]);
    if grip_length != 0 && grip_height != 0 {
        // Through to the rear end of the jaw: no seam is between the parts.
        let rear = front - length.max(grip_length);
        grip = outside((rear, front), inside, grip_height);
    }
    if length > grip_length && height != 0 {
        jaw = outside((front - length, front - grip_length), inside, height);
    }
    [grip[0], grip[1], jaw[0], jaw[1]]
}

/// From a diameter outwards, on both sides of the axis; without a diameter the two sides are one rectangle.
fn outside(z: (i64, i64), inside: i64, height: i64) -> [Option<Bounds>; 2] {
    let outer = inside + 2 * height;
    if inside == 0 {
        [Some(Bounds { z, x: (-outer, outer) }), None]
    } else {
        [Some(Bounds { z, x: (inside, outer) }), Some(Bounds { z, x: (-outer, -inside) })]
    }
}

/// Front, middle and rear step, one behind the other, each through to the rear end.
#[must_use]
pub fn tailstock(data: &Barriers) -> [Option<Bounds>; 3] {
    let front = data.front_diameter.0.max(data.centre_diameter.0);
    let steps = [
        (data.front_length.0, front),
        (data.middle_length.0, data.middle_diameter.0),
        (data.rear_length.0, data.rear_diameter.0),
    ];
    let mut begin = data.workpiece_end.0;
    let end = begin + steps.iter().map(|(length, _)| length).sum::<i64>();
    steps.map(|(length, diameter)| {
        let from = begin;
        begin += length;
        (length != 0 && diameter != 0).then_some(Bounds { z: (from, end), x: (-diameter, diameter) })
    })
}
