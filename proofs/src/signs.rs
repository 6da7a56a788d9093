//! Theorems about the exact signs of plane geometry: sides, lines, quadrants.

use turnspec::engine::arithmetic::plane::{
    Direction, Point, cross, difference, dot, left, quadrant, square, square_distance,
};

use crate::draw::within;
#[cfg(stand_in)]
use crate::kani;

/// Latched coordinates in these statements.
const COORDINATE: i64 = 1 << 56;
/// Bound of directions between such points, in half nanometres.
const DIRECTION: i128 = 1 << 58;

fn point(size: i64) -> Point {
    Point { x: within(size), z: within(size) }
}

/// Any direction of at most 2^58.
fn direction() -> Direction {
    let part = || i128::from(kani::any::<i64>() >> 5);
    (part(), part())
}

/// Any number of at most 8 in size: products of small numbers are what a solver multiplies out.
fn small() -> i128 {
    i128::from(kani::any::<i8>() >> 4)
}

fn small_direction() -> Direction {
    (small(), small())
}

fn opposite((z, x): Direction) -> Direction {
    (-z, -x)
}

/// 1 counter-clockwise, -1 clockwise.
fn sense() -> i128 {
    if kani::any() { 1 } else { -1 }
}

theorems! {
    /// The direction from one point to another never overflows, and the way back is the opposite.
    /// Of: `plane::difference`
    /// Assumes: any coordinates.
    /// Rules: E100L-CIRC-04, E100L-DIA-01
    #[unwind(2)]
    fn no_direction_overflows() {
        let one = Point { x: kani::any(), z: kani::any() };
        let other = Point { x: kani::any(), z: kani::any() };
        kani::cover!(one.z == i64::MIN && other.z == i64::MAX, "the longest way");
        assert!(difference(one, other) == opposite(difference(other, one)));
        assert!((difference(one, other) == (0, 0)) == (one == other));
    }

    /// Between latched points directions stay below 2^58.
    /// Of: `plane::difference`
    /// Assumes: coordinates of at most 2^56 in size.
    /// Rules: E100L-CIRC-11, E100L-ANG-03
    #[unwind(2)]
    fn directions_have_room() {
        let (z, x) = difference(point(COORDINATE), point(COORDINATE));
        kani::cover!(z == DIRECTION, "the longest way");
        assert!(z.abs() <= DIRECTION && x.abs() <= DIRECTION);
    }

    /// The vector product of such directions stays in 128 bits; with no direction it is zero.
    /// Of: `plane::cross`
    /// Assumes: directions of at most 2^58.
    /// Rules: E100L-CHAM-08, E100L-ANG-03
    #[unwind(2)]
    fn no_vector_product_overflows() {
        let (first, second) = (direction(), direction());
        kani::cover!(first.0 == -DIRECTION, "an extreme");
        assert!(cross(first, second) == 0 || first != (0, 0) && second != (0, 0));
    }

    /// The scalar product of such directions stays in 128 bits; with no direction it is zero.
    /// Of: `plane::dot`
    /// Assumes: directions of at most 2^58.
    /// Rules: E100L-CHAM-08, E100L-ANG-03
    #[unwind(2)]
    fn no_scalar_product_overflows() {
        let (first, second) = (direction(), direction());
        kani::cover!(second.1 == -DIRECTION, "an extreme");
        assert!(dot(first, second) == 0 || first != (0, 0) && second != (0, 0));
    }

    /// The square of such a direction stays in 128 bits, and is its scalar product with itself.
    /// Of: `plane::square`, `plane::dot`
    /// Assumes: directions of at most 2^58.
    /// Rules: E100L-CIRC-11, E100L-CIRC-16
    #[unwind(2)]
    fn no_square_overflows() {
        let direction = direction();
        kani::cover!(direction.0 == -DIRECTION, "an extreme");
        assert!(square(direction) == dot(direction, direction));
    }

    /// Only a point itself has no distance from it, and the distance back is the same.
    /// Of: `plane::square_distance`
    /// Assumes: coordinates of at most 4 in size.
    /// Rules: E100L-CIRC-07, E100L-CIRC-11
    #[unwind(2)]
    fn only_a_point_itself_has_no_distance() {
        let coordinate = || i64::from(kani::any::<i8>() >> 5);
        let one = Point { x: coordinate(), z: coordinate() };
        let other = if kani::any() { one } else { Point { x: coordinate(), z: coordinate() } };
        kani::cover!(one == other, "the point itself");
        assert!((square_distance(one, other) == 0) == (one == other));
        assert!(square_distance(one, other) == square_distance(other, one));
    }

    /// What is to the left of a direction has it to its right.
    /// Of: `plane::cross`, `plane::dot`
    /// Assumes: directions of at most 8.
    /// Rules: E100L-ANG-03, E100L-ANG-04
    #[unwind(2)]
    fn sides_change_with_the_order() {
        let (first, second) = (small_direction(), small_direction());
        kani::cover!(cross(first, second) > 0, "to the left");
        assert!(cross(first, second) == -cross(second, first));
        assert!(dot(first, second) == dot(second, first));
    }

    /// A quarter turn counter-clockwise lies to the left and neither ahead nor back.
    /// Of: `plane::left`, `plane::cross`, `plane::dot`, `plane::square`
    /// Assumes: directions of at most 8.
    /// Rules: E100L-CIRC-02, E100L-ANG-04
    #[unwind(2)]
    fn a_quarter_turn_lies_to_the_left() {
        let direction = small_direction();
        kani::cover!(direction.0 < 0 && direction.1 < 0, "any quadrant");
        assert!(cross(direction, left(direction)) == square(direction));
        assert!(dot(direction, left(direction)) == 0);
    }

    /// A multiple of a direction lies on its line; it turns back exactly when it is a negative one.
    /// Of: `plane::cross`, `plane::dot`
    /// Assumes: directions of at most 8, multiples of at most 4.
    /// Rules: E100L-CHAM-08, E100L-ANG-03
    #[unwind(2)]
    fn multiples_lie_on_the_line() {
        let (z, x) = small_direction();
        let multiple = i128::from(kani::any::<i8>() >> 5);
        let along = (multiple * z, multiple * x);
        kani::cover!(multiple < 0 && (z, x) != (0, 0), "turning back");
        assert!(cross((z, x), along) == 0);
        assert!((z, x) == (0, 0) || dot((z, x), along).signum() == multiple.signum());
    }

    /// Of a direction along an axis, a point is to the left exactly when its other coordinate says so.
    /// Of: `plane::cross`
    /// Assumes: directions of at most 8.
    /// Rules: E100L-CIRC-02, E100L-CHAM-11
    #[unwind(2)]
    fn the_axes_have_their_sides() {
        let ((z, x), length) = (small_direction(), small());
        kani::assume(length > 0);
        kani::cover!(x < 0, "to the right of Z");
        assert!(cross((length, 0), (z, x)).signum() == x.signum());
        assert!(cross((0, length), (z, x)).signum() == -z.signum());
    }

    /// An arc starts in one quadrant: both signs are known unless it starts at its centre, and a coordinate that
    /// is not zero has its own sign.
    /// Of: `plane::quadrant`
    /// Assumes: directions of at most 2^58, not zero.
    /// Rules: E100L-CIRC-08
    #[unwind(2)]
    fn an_arc_starts_in_one_quadrant() {
        let (z, x) = direction();
        kani::assume((z, x) != (0, 0));
        let (side_z, side_x) = quadrant((z, x), sense());
        kani::cover!(z == 0, "on the X axis");
        kani::cover!(x == 0, "on the Z axis");
        assert!(side_z.abs() == 1 && side_x.abs() == 1);
        assert!((z == 0 || side_z == z.signum()) && (x == 0 || side_x == x.signum()));
    }

    /// The quadrant turns with the start: a quarter turn of one is a quarter turn of the other.
    /// Of: `plane::quadrant`
    /// Assumes: directions of at most 2^58.
    /// Rules: E100L-CIRC-08
    #[unwind(2)]
    fn the_quadrant_turns_with_the_start() {
        let (start, turn) = (direction(), sense());
        kani::cover!(start.0 == 0 && start.1 != 0, "on an axis");
        assert!(quadrant(left(start), turn) == left(quadrant(start, turn)));
        assert!(quadrant(opposite(start), turn) == opposite(quadrant(start, turn)));
    }

    /// On an axis the two senses enter the two quadrants beside it, each along its tangent; elsewhere the sense does
    /// not matter.
    /// Of: `plane::quadrant`
    /// Assumes: directions of at most 2^58, not zero.
    /// Rules: E100L-CIRC-02, E100L-CIRC-08
    #[unwind(2)]
    fn the_sense_decides_on_an_axis() {
        let start = direction();
        kani::assume(start != (0, 0));
        let on_axis = start.0 == 0 || start.1 == 0;
        kani::cover!(on_axis, "on an axis");
        kani::cover!(!on_axis, "inside a quadrant");
        let (counter_clockwise, clockwise) = (quadrant(start, 1), quadrant(start, -1));
        assert!((counter_clockwise == clockwise) != on_axis);
        // The tangent counter-clockwise is to the left of the start.
        let ahead = (left(start).0.signum(), left(start).1.signum());
        assert!(!on_axis || dot(counter_clockwise, ahead) == 1 && dot(clockwise, ahead) == -1);
    }
}

refutations! {
    /// False: what is to the left lies ahead.
    #[unwind(2)]
    fn what_is_to_the_left_lies_ahead() {
        let (first, second) = (small_direction(), small_direction());
        assert!(cross(first, second) <= 0 || dot(first, second) > 0);
    }

    /// False: the sense of an arc does not matter to its quadrant.
    #[unwind(2)]
    fn the_sense_never_matters() {
        let start = small_direction();
        assert!(quadrant(start, 1) == quadrant(start, -1));
    }
}
