//! The areas of chuck and tailstock from their data (E100L-BARR-02, E100L-BARR-03). Sizes are 0 to 2^60,
//! positions at most 2^60 in size.

use turnspec_oracle::vocabulary::Barriers;

use crate::engine::planted::{self, Bug};

use super::rectangle::Rectangle;

/// The data that a program can change: VCHKL VCHKD VCHKX VCHKZ VTSL VTSDA VTSDB VWKR.
pub type Variables = [i64; 8];

/// The jaw and its gripping part, each with its image beyond the axis.
#[must_use]
pub fn chuck(machine: &Barriers, variables: &Variables) -> [Option<Rectangle>; 4] {
    let [grip_length, grip_height, diameter, front, ..] = *variables;
    let (length, height) = (machine.jaw_length.0, machine.jaw_height.0);
    let diameter = if planted::is(Bug::GripDiameterSigned) { diameter } else { diameter.abs() };
    let rear = front - length.max(grip_length);
    let [grip, image] = match grip_length > 0 {
        true => both_sides((rear, front), diameter, grip_height),
        false => [None; 2],
    };
    let jaw_front = if planted::is(Bug::JawFromFront) { front } else { front - grip_length };
    let [jaw, jaw_image] = match length > grip_length {
        true => both_sides((front - length, jaw_front), diameter, height),
        false => [None; 2],
    };
    [grip, image, jaw, jaw_image]
}

/// A part that stands outwards from a diameter, and its image with X negative; from the axis both are one.
fn both_sides(z: (i64, i64), diameter: i64, height: i64) -> [Option<Rectangle>; 2] {
    let outside = diameter + if planted::is(Bug::HeightOnDiameter) { height } else { 2 * height };
    match (height, diameter) {
        (0, _) => [None; 2],
        (_, 0) => [Some(Rectangle { z, x: (-outside, outside) }), None],
        _ if planted::is(Bug::ImageForgotten) => [Some(Rectangle { z, x: (diameter, outside) }), None],
        _ => [(diameter, outside), (-outside, -diameter)].map(|x| Some(Rectangle { z, x })),
    }
}

/// The three steps, each as far as the rear end.
#[must_use]
pub fn tailstock(machine: &Barriers, variables: &Variables) -> [Option<Rectangle>; 3] {
    let [.., front_length, front_diameter, centre_diameter, begin] = *variables;
    let middle = begin + front_length;
    let rear = middle + machine.middle_length.0;
    let end = rear + machine.rear_length.0;
    let step = |begin: i64, length: i64, diameter: i64| {
        let end = if planted::is(Bug::StepAlone) { begin + length } else { end };
        let below = if planted::is(Bug::TailstockAbove) { 0 } else { -diameter };
        (length > 0 && diameter > 0).then_some(Rectangle { z: (begin, end), x: (below, diameter) })
    };
    [
        step(
            begin,
            front_length,
            if planted::is(Bug::CentreForgotten) {
                front_diameter
            } else {
                front_diameter.max(centre_diameter)
            },
        ),
        step(middle, machine.middle_length.0, machine.middle_diameter.0),
        step(rear, machine.rear_length.0, machine.rear_diameter.0),
    ]
}
