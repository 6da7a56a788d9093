//! Theorems about straight paths and open rectangles.

use turnspec::engine::arithmetic::plane::Point;
use turnspec::engine::arithmetic::rectangle::Rectangle;
use turnspec::engine::arithmetic::segment::{enters, straddles};

#[cfg(stand_in)]
use crate::draw::within;
#[cfg(stand_in)]
use crate::kani;

/// A coordinate: products of small ones are what a solver multiplies out. Property tests draw larger ones, too.
fn coordinate() -> i64 {
    #[cfg(stand_in)]
    let value = if kani::any() { within(4) } else { within(1 << 56) };
    #[cfg(not(stand_in))]
    let value = i64::from(kani::any::<i8>() >> 6);
    value
}

fn point() -> Point {
    Point { x: coordinate(), z: coordinate() }
}

/// A rectangle with an inside; for the model checker the one about the origin.
fn rectangle() -> Rectangle {
    #[cfg(stand_in)]
    let [z, x] = [(); 2].map(|()| {
        let (one, other) = (coordinate(), coordinate());
        kani::assume(one != other);
        (one.min(other), one.max(other))
    });
    #[cfg(not(stand_in))]
    let [z, x] = [(-1, 1); 2];
    Rectangle { z, x }
}

/// Moved by a way so many times.
fn moved(point: Point, way: Point, times: i64) -> Point {
    Point { x: point.x + times * way.x, z: point.z + times * way.z }
}

theorems! {
    /// A segment enters a rectangle whichever end comes first.
    /// Of: `segment::enters`
    /// Assumes: for the model checker a square of 2 about the origin and coordinates of at most 2 in size; for the
    /// property tests any rectangle, and 2^56.
    /// Rules: E100L-BARR-09
    #[unwind(5)]
    fn a_segment_is_the_same_from_its_other_end() {
        let (from, to, rectangle) = (point(), point(), rectangle());
        let found = enters(from, to, &rectangle);
        kani::cover!(found && !rectangle.contains(from) && !rectangle.contains(to), "through the rectangle");
        assert!(found == enters(to, from, &rectangle));
    }

    /// A segment with an end inside enters; a single point does exactly then.
    /// Of: `segment::enters`, `Rectangle::contains`
    /// Assumes: for the model checker a square of 2 about the origin and coordinates of at most 2 in size; for the
    /// property tests any rectangle, and 2^56.
    /// Rules: E100L-BARR-08, E100L-BARR-09
    #[unwind(5)]
    fn an_end_inside_is_refused() {
        let (from, to, rectangle) = (point(), point(), rectangle());
        let inside = rectangle.contains(from);
        kani::cover!(inside && from != to, "an end inside");
        assert!(!inside || enters(from, to, &rectangle));
        assert!(enters(from, from, &rectangle) == inside);
    }

    /// A mirrored segment enters exactly the mirrored rectangle.
    /// Of: `segment::enters`
    /// Assumes: for the model checker a square of 2 about the origin and coordinates of at most 2 in size; for the
    /// property tests any rectangle, and 2^56.
    /// Rules: E100L-BARR-02, E100L-BARR-09
    #[unwind(5)]
    fn a_mirrored_segment_enters_the_mirrored_rectangle() {
        let (from, to, rectangle) = (point(), point(), rectangle());
        let [mirrored_from, mirrored_to] = [from, to].map(|point| Point { x: -point.x, ..point });
        let mirrored = Rectangle { x: (-rectangle.x.1, -rectangle.x.0), ..rectangle };
        let found = enters(from, to, &rectangle);
        kani::cover!(found && from.x < to.x && from.z < to.z, "an oblique segment");
        assert!(found == enters(mirrored_from, mirrored_to, &mirrored));
    }

    /// A segment enters exactly when one of its halves does.
    /// Of: `segment::enters`
    /// Assumes: for the model checker a square of 2 about the origin, coordinates and half lengths of at most 2 in
    /// size; for the property tests any rectangle, and 2^56.
    /// Rules: E100L-BARR-09
    #[unwind(5)]
    fn a_segment_is_its_halves() {
        let (from, way, rectangle) = (point(), point(), rectangle());
        let (middle, to) = (moved(from, way, 1), moved(from, way, 2));
        let halves = [enters(from, middle, &rectangle), enters(middle, to, &rectangle)];
        kani::cover!(halves == [false, true], "the second half alone");
        assert!(enters(from, to, &rectangle) == halves.contains(&true));
    }

    /// What enters a rectangle enters every larger one.
    /// Of: `segment::enters`
    /// Assumes: for the model checker a square of 2 about the origin, coordinates and additions of at most 2 in size;
    /// for the property tests any rectangle, and 2^56.
    /// Rules: E100L-BARR-09
    #[unwind(5)]
    fn a_larger_rectangle_refuses_more() {
        let (from, to, smaller, by) = (point(), point(), rectangle(), point());
        let larger = Rectangle {
            z: (smaller.z.0 - by.z.abs(), smaller.z.1 + by.x.abs()),
            x: (smaller.x.0 - by.x.abs(), smaller.x.1),
        };
        let found = enters(from, to, &smaller);
        kani::cover!(found && by.z != 0, "a larger one");
        kani::cover!(!found && enters(from, to, &larger), "the larger one alone");
        assert!(!found || enters(from, to, &larger));
    }

    /// Corners lie on both sides of a line whichever way it leads and whichever corner comes first; those of one side,
    /// and corners on the line, do not.
    /// Of: `segment::straddles`
    /// Assumes: any sides but the least of 128 bits.
    /// Rules: E100L-BARR-09
    #[unwind(5)]
    fn both_sides_are_those_of_the_way_back() {
        let sides: [i128; 4] = [kani::any(), kani::any(), kani::any(), kani::any()];
        kani::assume(!sides.contains(&i128::MIN));
        let [first, second, third, fourth] = sides;
        let found = straddles(sides);
        kani::cover!(found && first == 0, "one on the line");
        assert!(found == straddles(sides.map(|side| -side)));
        assert!(found == straddles([fourth, first, third, second]));
        assert!(!straddles(sides.map(|side| side & i128::MAX)));
    }
}

refutations! {
    /// False: a segment enters only with an end inside.
    #[unwind(5)]
    fn only_ends_are_refused() {
        let (from, to, rectangle) = (point(), point(), rectangle());
        assert!(enters(from, to, &rectangle) == (rectangle.contains(from) || rectangle.contains(to)));
    }
}
