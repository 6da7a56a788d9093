//! Theorems about the areas that chuck and tailstock keep free.

use turnspec::engine::arithmetic::area::{Variables, chuck, tailstock};
use turnspec::engine::arithmetic::plane::Point;
use turnspec::engine::arithmetic::rectangle::Rectangle;
use turnspec_oracle::integer::area;
use turnspec_oracle::vocabulary::{Barriers, Length};

use crate::draw::{between, within};
#[cfg(stand_in)]
use crate::kani;

/// Sizes and positions: far more than those of a set-up or a variable.
const SIZE: i64 = 1 << 60;

fn size() -> i64 {
    between(0, SIZE)
}

/// Data of any size.
fn data() -> Barriers {
    Barriers {
        jaw_length: Length(size()),
        jaw_height: Length(size()),
        grip_length: Length(size()),
        grip_height: Length(size()),
        chuck_x: Length(within(SIZE)),
        chuck_z: Length(within(SIZE)),
        rear_length: Length(size()),
        rear_diameter: Length(size()),
        middle_length: Length(size()),
        middle_diameter: Length(size()),
        front_length: Length(size()),
        front_diameter: Length(size()),
        centre_diameter: Length(size()),
        workpiece_end: Length(within(SIZE)),
    }
}

/// What a program can change of them.
fn variables(data: &Barriers) -> Variables {
    let chuck = [data.grip_length, data.grip_height, data.chuck_x, data.chuck_z];
    let [grip_length, grip_height, x, z] = chuck.map(|length| length.0);
    let tailstock = [data.front_length, data.front_diameter, data.centre_diameter, data.workpiece_end];
    let [front_length, front_diameter, centre_diameter, end] = tailstock.map(|length| length.0);
    [grip_length, grip_height, x, z, front_length, front_diameter, centre_diameter, end]
}

fn bounds(rectangle: Option<Rectangle>) -> Option<area::Bounds> {
    rectangle.map(|Rectangle { z, x }| area::Bounds { z, x })
}

fn contain(area: &[Option<Rectangle>], point: Point) -> bool {
    area.iter().flatten().any(|rectangle| rectangle.contains(point))
}

/// Whether every rectangle has an inside.
fn have_inside(area: &[Option<Rectangle>]) -> bool {
    area.iter().flatten().all(|Rectangle { z, x }| z.0 < z.1 && x.0 < x.1)
}

fn point() -> Point {
    Point { x: between(-i64::MAX, i64::MAX), z: kani::any() }
}

theorems! {
    /// Engine and oracle let the chuck keep the same rectangles free.
    /// Of: `area::chuck`, `integer::area::chuck`
    /// Assumes: sizes of at most 2^60, positions of at most 2^60 in size.
    /// Rules: E100L-BARR-02, E100L-BARR-07
    #[unwind(5)]
    fn both_know_the_chuck_alike() {
        let data = data();
        let found = chuck(&data, &variables(&data));
        kani::cover!(found.iter().all(Option::is_some), "both parts and their images");
        kani::cover!(found[0].is_none() && found[2].is_some(), "no gripping part");
        assert!(found.map(bounds) == area::chuck(&data));
    }

    /// Engine and oracle let the tailstock keep the same rectangles free.
    /// Of: `area::tailstock`, `integer::area::tailstock`
    /// Assumes: sizes of at most 2^60, positions of at most 2^60 in size.
    /// Rules: E100L-BARR-03, E100L-BARR-07
    #[unwind(5)]
    fn both_know_the_tailstock_alike() {
        let data = data();
        let found = tailstock(&data, &variables(&data));
        kani::cover!(found.iter().all(Option::is_some), "three steps");
        assert!(found.map(bounds) == area::tailstock(&data));
    }

    /// Every part of an area has an inside: its bounds are in order and apart.
    /// Of: `area::chuck`, `area::tailstock`
    /// Assumes: sizes of at most 2^60, positions of at most 2^60 in size.
    /// Rules: E100L-BARR-02, E100L-BARR-03
    #[unwind(5)]
    fn every_part_has_an_inside() {
        let data = data();
        let (chuck, tailstock) = (chuck(&data, &variables(&data)), tailstock(&data, &variables(&data)));
        kani::cover!(chuck[0].is_some() && data.chuck_x.0 == 0, "a chuck that grips at the axis");
        assert!(have_inside(&chuck) && have_inside(&tailstock));
    }

    /// Both areas are their own mirror images, and the sign of the gripping diameter does not matter.
    /// Of: `area::chuck`, `area::tailstock`
    /// Assumes: sizes of at most 2^60, positions of at most 2^60 in size, any point but the least X of 64 bits.
    /// Rules: E100L-BARR-02, E100L-BARR-03
    #[unwind(5)]
    fn areas_are_their_own_images() {
        let (data, point) = (data(), point());
        let other = Barriers { chuck_x: Length(-data.chuck_x.0), ..data };
        let image = Point { x: -point.x, ..point };
        let area = chuck(&data, &variables(&data));
        kani::cover!(contain(&area, point) && point.x < 0, "in the chuck beyond the axis");
        assert!(contain(&area, point) == contain(&area, image));
        assert!(contain(&area, point) == contain(&chuck(&other, &variables(&other)), point));
        let area = tailstock(&data, &variables(&data));
        assert!(contain(&area, point) == contain(&area, image));
    }

    /// The steps of the tailstock add up, and no seam is between them: the thinnest one is kept free from the end of
    /// the workpiece to the rear end.
    /// Of: `area::tailstock`
    /// Assumes: sizes of at most 2^60, positions of at most 2^60 in size, any point.
    /// Rules: E100L-BARR-03
    #[unwind(5)]
    fn the_tailstock_has_no_seams() {
        let (data, point) = (data(), point());
        let begin = data.workpiece_end.0;
        let end = begin + data.front_length.0 + data.middle_length.0 + data.rear_length.0;
        let front = data.front_diameter.0.max(data.centre_diameter.0);
        let beyond = point.z <= begin || point.z >= end;
        kani::cover!(point.z == begin + data.front_length.0 && !beyond, "between two steps");
        let area = tailstock(&data, &variables(&data));
        assert!(!beyond || !contain(&area, point));
        let in_front_step = data.front_length.0 > 0 && point.x.abs() < front;
        assert!(beyond || !in_front_step || contain(&area, point));
    }

    /// Nor is a seam between the gripping part and the longer jaw behind it, where both stand out.
    /// Of: `area::chuck`
    /// Assumes: sizes of at most 2^60, positions of at most 2^60 in size, any point.
    /// Rules: E100L-BARR-02
    #[unwind(5)]
    fn the_chuck_has_no_seam() {
        let (data, point) = (data(), point());
        kani::assume(data.grip_length.0 > 0 && data.grip_height.0 > 0);
        let (front, inside) = (data.chuck_z.0, data.chuck_x.0.abs());
        let rear = front - data.jaw_length.0.max(data.grip_length.0);
        let along = rear < point.z && point.z < front;
        let out = point.x.abs();
        kani::cover!(point.z == front - data.grip_length.0 && along && out > inside, "between the parts");
        let found = contain(&chuck(&data, &variables(&data)), point);
        assert!(along || !found);
        assert!(!along || out <= inside || out >= inside + 2 * data.grip_height.0 || found);
    }
}

refutations! {
    /// False: the axis is free of every chuck.
    #[unwind(5)]
    fn the_axis_is_free() {
        let (data, z) = (data(), within(SIZE));
        assert!(!contain(&chuck(&data, &variables(&data)), Point { x: 0, z }));
    }
}
