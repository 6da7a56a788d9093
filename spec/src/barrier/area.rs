//! The areas of the chuck (E100L-BARR-02) and of the tailstock (E100L-BARR-03), from the data in force
//! (E100L-BARR-07).

use super::rectangle::Rectangle;
use crate::vocabulary::Barriers;

/// Gripping part and jaw, each with its image of negative X. D and D1 are lengths of the radius.
pub fn chuck(data: &Barriers) -> Vec<Rectangle> {
    let (length, height) = (data.jaw_length.0, data.jaw_height.0);
    let (grip_length, grip_height) = (data.grip_length.0, data.grip_height.0);
    let (inside, front) = (data.chuck_x.0.abs(), data.chuck_z.0);
    let mut area = Vec::new();
    if grip_length != 0 && grip_height != 0 {
        // Through to the rear end of the jaw: no seam is between the parts.
        let rear = front - length.max(grip_length);
        area.extend(outside((rear, front), inside, grip_height));
    }
    if length > grip_length && height != 0 {
        area.extend(outside((front - length, front - grip_length), inside, height));
    }
    area
}

/// From a diameter outwards, on both sides of the axis; without a diameter the two sides are one rectangle.
fn outside(z: (i64, i64), inside: i64, height: i64) -> Vec<Rectangle> {
    let outer = inside + 2 * height;
    if inside == 0 {
        vec![Rectangle::new(z, (-outer, outer))]
    } else {
        vec![Rectangle::new(z, (inside, outer)), Rectangle::new(z, (-outer, -inside))]
    }
}

/// Front, middle and rear step, one behind the other, each through to the rear end.
pub fn tailstock(data: &Barriers) -> Vec<Rectangle> {
    let front = data.front_diameter.0.max(data.centre_diameter.0);
    let steps = [
        (data.front_length.0, front),
        (data.middle_length.0, data.middle_diameter.0),
        (data.rear_length.0, data.rear_diameter.0),
    ];
    let mut begin = data.workpiece_end.0;
    let end = begin + steps.iter().map(|(length, _)| length).sum::<i64>();
    let mut area = Vec::new();
    for (length, diameter) in steps {
        if length != 0 && diameter != 0 {
            area.push(Rectangle::new((begin, end), (-diameter, diameter)));
        }
        begin += length;
    }
    area
}
