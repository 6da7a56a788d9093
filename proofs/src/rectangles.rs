//! Theorems about open rectangles: what is inside, what touches only, and what the line of an edge parts from them.

use turnspec::engine::arithmetic::plane::Point;
use turnspec::engine::arithmetic::rectangle::Rectangle;
use turnspec::engine::arithmetic::segment::is_beside;

use crate::draw::between;
#[cfg(stand_in)]
use crate::kani;

/// A coordinate that has an opposite.
fn coordinate() -> i64 {
    between(-i64::MAX, i64::MAX)
}

fn point() -> Point {
    Point { x: coordinate(), z: coordinate() }
}

/// Any bounds, in order or not.
fn rectangle() -> Rectangle {
    Rectangle { z: (coordinate(), coordinate()), x: (coordinate(), coordinate()) }
}

/// With the opposite X.
fn mirrored(point: Point) -> Point {
    Point { x: -point.x, ..point }
}

fn mirrored_rectangle(rectangle: Rectangle) -> Rectangle {
    Rectangle { x: (-rectangle.x.1, -rectangle.x.0), ..rectangle }
}

theorems! {
    /// What touches is not inside: a point on the line of an edge, nor a corner.
    /// Of: `Rectangle::contains`, `Rectangle::corners`
    /// Assumes: any bounds and points but the least of 64 bits.
    /// Rules: E100L-BARR-09
    #[unwind(5)]
    fn touching_is_not_inside() {
        let (point, rectangle) = (point(), rectangle());
        let inside = rectangle.contains(point);
        kani::cover!(inside, "inside");
        let ((low, high), (below, above)) = (rectangle.z, rectangle.x);
        assert!(!inside || ![low, high].contains(&point.z) && ![below, above].contains(&point.x));
        assert!(!rectangle.corners().iter().any(|corner| rectangle.contains(*corner)));
    }

    /// What is inside lies strictly between two opposite corners; a rectangle without extent has no inside.
    /// Of: `Rectangle::contains`, `Rectangle::corners`
    /// Assumes: any bounds and points but the least of 64 bits.
    /// Rules: E100L-BARR-09
    #[unwind(5)]
    fn the_inside_is_between_corners() {
        let (point, rectangle) = (point(), rectangle());
        let [first, .., last] = rectangle.corners();
        let between = first.z < point.z && point.z < last.z && first.x < point.x && point.x < last.x;
        kani::cover!(between, "inside");
        assert!(rectangle.contains(point) == between);
        let extends = rectangle.z.0 < rectangle.z.1 && rectangle.x.0 < rectangle.x.1;
        assert!(extends || !between);
    }

    /// A point is inside exactly when its mirror image is inside the mirror image.
    /// Of: `Rectangle::contains`
    /// Assumes: any bounds and points but the least of 64 bits.
    /// Rules: E100L-BARR-02, E100L-BARR-09
    #[unwind(2)]
    fn a_mirrored_point_is_in_the_mirrored_rectangle() {
        let (point, rectangle) = (point(), rectangle());
        kani::cover!(rectangle.contains(point) && rectangle.x.0 > 0, "inside, off the axis");
        assert!(rectangle.contains(point) == mirrored_rectangle(rectangle).contains(mirrored(point)));
    }

    /// A point is parted from a rectangle exactly when it is not inside.
    /// Of: `segment::is_beside`, `Rectangle::contains`
    /// Assumes: any bounds and points but the least of 64 bits.
    /// Rules: E100L-BARR-08, E100L-BARR-09
    #[unwind(2)]
    fn a_point_is_beside_or_inside() {
        let (point, rectangle) = (point(), rectangle());
        kani::cover!(point.z == rectangle.z.0, "on the line of an edge");
        assert!(is_beside(point, point, &rectangle) != rectangle.contains(point));
    }

    /// Whether a segment is parted from a rectangle does not depend on the order of its ends nor on the side of the
    /// axis; with an end inside it is not, and if it is each end is for itself.
    /// Of: `segment::is_beside`, `Rectangle::contains`
    /// Assumes: any bounds and points but the least of 64 bits.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn a_segment_is_beside_from_either_end() {
        let (from, to, rectangle) = (point(), point(), rectangle());
        let beside = is_beside(from, to, &rectangle);
        kani::cover!(beside && from.z < to.z, "from left to right");
        kani::cover!(!beside && !rectangle.contains(from) && !rectangle.contains(to), "about the rectangle");
        assert!(beside == is_beside(to, from, &rectangle));
        assert!(beside == is_beside(mirrored(from), mirrored(to), &mirrored_rectangle(rectangle)));
        assert!(!beside || !rectangle.contains(from) && !rectangle.contains(to));
    }
}

refutations! {
    /// False: whatever is not inside is parted from the rectangle, its way there included.
    #[unwind(2)]
    fn two_points_outside_are_beside() {
        let (from, to, rectangle) = (point(), point(), rectangle());
        assert!(rectangle.contains(from) || rectangle.contains(to) || is_beside(from, to, &rectangle));
    }
}
