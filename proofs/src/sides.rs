//! Theorems about the directions of radius compensation: what is left and right, parallel, the same way or back, and
//! where arcs and lines meet.

use turnspec::engine::arithmetic::nose::offset;
use turnspec::engine::arithmetic::plane::{
    Direction, bounded, cross, dot, left, minus, square, tangent,
};

use crate::draw::{factor, within_wide};
#[cfg(stand_in)]
use crate::kani;

/// Bound of directions in compensation, in half nanometres.
const DIRECTION: i128 = 1 << 60;

/// Any direction of at most 2^60 in each component.
fn direction() -> Direction {
    let part = || i128::from(kani::any::<i64>() >> 3);
    (part(), part())
}

/// Any way between two centres: at most 2^61 in each component.
fn between_centres() -> Direction {
    let part = || i128::from(kani::any::<i64>() >> 2);
    (part(), part())
}

/// A direction for products whose values are asserted.
fn factors() -> Direction {
    (factor(DIRECTION), factor(DIRECTION))
}

fn opposite((z, x): Direction) -> Direction {
    (-z, -x)
}

/// As the other half of the turning plane shows it.
fn mirrored((z, x): Direction) -> Direction {
    (z, -x)
}

/// 1 counter-clockwise, -1 clockwise; 1 the tool on the left, -1 on the right.
fn sign() -> i128 {
    if kani::any() { 1 } else { -1 }
}

theorems! {
    /// A direction between any two points is brought within 2^60, keeps its signs, and stays as it is if it was
    /// within.
    /// Of: `plane::bounded`
    /// Assumes: components of at most 2^65 in size, which no two points of 64 bits exceed.
    /// Rules: E100L-NRC-26, E100L-ADDR-01
    #[unwind(4)]
    fn a_bounded_direction_has_room() {
        let (z, x) = (within_wide(1 << 65), within_wide(1 << 65));
        let (bounded_z, bounded_x) = bounded((z, x));
        kani::cover!(z > DIRECTION && x.abs() < DIRECTION, "one component beyond");
        for (bound, of) in [(bounded_z, z), (bounded_x, x)] {
            assert!(bound.abs() <= DIRECTION && bound.signum() == of.signum());
            assert!(bound == of || of.abs() > DIRECTION);
        }
        assert!(bounded((bounded_z, bounded_x)) == (bounded_z, bounded_x));
    }

    /// No product of two directions of compensation overflows.
    /// Of: `plane::cross`, `plane::dot`, `plane::square`
    /// Assumes: directions of at most 2^60.
    /// Rules: E100L-NRC-26, E100L-NRC-51
    #[unwind(2)]
    fn no_product_of_directions_overflows() {
        let (first, second) = (direction(), direction());
        kani::cover!(first.0 == -DIRECTION && second.1 == -DIRECTION, "extremes");
        let directions = first != (0, 0) && second != (0, 0);
        assert!(directions || cross(first, second) == 0 && dot(first, second) == 0);
        assert!(square(first) == dot(first, first));
    }

    /// The way between two centres stays within 2^61, and the way back is the opposite.
    /// Of: `plane::minus`
    /// Assumes: directions of at most 2^60.
    /// Rules: E100L-NRC-52
    #[unwind(2)]
    fn centres_have_room() {
        let (first, second) = (direction(), direction());
        let (z, x) = minus(first, second);
        kani::cover!(z < -DIRECTION, "further apart than a direction is long");
        assert!(z.abs() <= 2 * DIRECTION && x.abs() <= 2 * DIRECTION);
        assert!((z, x) == opposite(minus(second, first)));
    }

    /// Nor does a product with the way between two centres overflow.
    /// Of: `plane::square`, `plane::cross`
    /// Assumes: ways of at most 2^61, directions of at most 2^60.
    /// Rules: E100L-NRC-52
    #[unwind(2)]
    fn no_product_with_centres_overflows() {
        let (centres, from_centre) = (between_centres(), direction());
        kani::cover!(centres.0 == -2 * DIRECTION, "the longest way");
        assert!(square(centres) == dot(centres, centres));
        assert!(centres != (0, 0) || cross(centres, from_centre) == 0);
    }

    /// Left of the left is back, and four times left is ahead; no component grows.
    /// Of: `plane::left`
    /// Assumes: directions of at most 2^61.
    /// Rules: E100L-NRC-02
    #[unwind(2)]
    fn left_of_the_left_is_back() {
        let direction = between_centres();
        kani::cover!(direction.0 < 0 && direction.1 > 0, "any quadrant");
        assert!(left(left(direction)) == opposite(direction));
        assert!(left(left(left(left(direction)))) == direction);
        let (z, x) = left(direction);
        assert!(z.abs() == direction.1.abs() && x.abs() == direction.0.abs());
    }

    /// Along an arc the centre is to the left counter-clockwise and to the right clockwise.
    /// Of: `plane::tangent`, `plane::left`
    /// Assumes: directions of at most 2^60.
    /// Rules: E100L-NRC-48, E100L-CIRC-02
    #[unwind(2)]
    fn the_centre_is_on_one_side_of_an_arc() {
        let (from_centre, turn) = (direction(), sign());
        let along = tangent(from_centre, turn);
        kani::cover!(turn < 0 && from_centre.0 > 0, "clockwise");
        let to_centre = opposite(from_centre);
        assert!(left(along) == if turn > 0 { to_centre } else { from_centre });
        assert!(tangent(from_centre, -turn) == opposite(along));
    }

    /// The programmed path in the other half of the plane, on the other side, has the nose there: the left of a
    /// mirrored direction is the mirrored right, and a mirrored arc turns the other way.
    /// Of: `plane::left`, `plane::tangent`, `nose::offset`
    /// Assumes: directions of at most 2^60, any radius.
    /// Rules: E100L-NRC-01, E100L-NRC-02
    #[unwind(2)]
    fn a_mirrored_path_has_its_nose_on_the_other_side() {
        let (way, turn, side, radius) = (direction(), sign(), sign(), kani::any());
        kani::cover!(way.1 < 0 && side < 0, "the tool on the right");
        assert!(left(mirrored(way)) == opposite(mirrored(left(way))));
        assert!(tangent(mirrored(way), -turn) == mirrored(tangent(way, turn)));
        assert!(offset(-side, radius) == -offset(side, radius));
    }

    /// In the other half of the plane left and right are exchanged; ahead stays ahead, and lengths do not change.
    /// Of: `plane::cross`, `plane::dot`, `plane::square`
    /// Assumes: directions of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-01, E100L-NRC-26
    #[unwind(2)]
    fn mirroring_exchanges_left_and_right() {
        let (first, second) = (factors(), factors());
        kani::cover!(cross(first, second) > 0 && dot(first, second) < 0, "to the left, backward");
        assert!(cross(mirrored(first), mirrored(second)) == -cross(first, second));
        assert!(dot(mirrored(first), mirrored(second)) == dot(first, second));
        assert!(square(mirrored(first)) == square(first));
    }

    /// A reversed direction has left and right exchanged, and ahead and back.
    /// Of: `plane::cross`, `plane::dot`
    /// Assumes: directions of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-31, E100L-NRC-32
    #[unwind(2)]
    fn a_reversal_exchanges_left_and_right() {
        let (first, second) = (factors(), factors());
        kani::cover!(cross(first, second) != 0 && dot(first, second) < 0, "a sharp turn");
        assert!(cross(first, opposite(second)) == -cross(first, second));
        assert!(dot(first, opposite(second)) == -dot(first, second));
    }

    /// On the way back through a corner the turn is the opposite one, as sharp as on the way there.
    /// Of: `plane::cross`, `plane::dot`
    /// Assumes: directions of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-26, E100L-NRC-31
    #[unwind(2)]
    fn the_way_back_turns_the_other_way() {
        let (arriving, leaving) = (factors(), factors());
        kani::cover!(cross(arriving, leaving) > 0, "a turn to the left");
        let (back, further) = (opposite(leaving), opposite(arriving));
        assert!(cross(back, further) == -cross(arriving, leaving));
        assert!(dot(back, further) == dot(arriving, leaving));
    }

    /// Parallel directions lead the same way, with a positive scalar product and the same signs, or back, with a
    /// negative one and the opposite signs; nothing else is parallel.
    /// Of: `plane::cross`, `plane::dot`
    /// Assumes: directions of at most 8, multiples of at most 8, for the model checker; of at most 2^57 for the
    /// property tests.
    /// Rules: E100L-NRC-30, E100L-NRC-31, E100L-NRC-32, E100L-NRC-33
    #[unwind(2)]
    fn parallel_directions_lead_on_or_back() {
        let first = (factor(DIRECTION >> 3), factor(DIRECTION >> 3));
        let times = factor(8);
        let second = if kani::any() { factors() } else { (times * first.0, times * first.1) };
        kani::assume(first != (0, 0) && second != (0, 0) && cross(first, second) == 0);
        let signs = |(z, x): Direction| (z.signum(), x.signum());
        let same = dot(first, second) > 0;
        kani::cover!(same && first != second, "the same way");
        kani::cover!(!same, "back");
        assert!(dot(first, second) != 0);
        assert!(signs(second) == if same { signs(first) } else { opposite(signs(first)) });
    }

    /// Half a nanometre aside at the end of a line makes a corner of it, to the left or to the right, however long
    /// the line is.
    /// Of: `plane::cross`
    /// Assumes: directions of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-34
    #[unwind(2)]
    fn half_a_nanometre_aside_is_a_corner() {
        let ((z, x), aside) = (factors(), sign());
        kani::cover!(z != 0 && x != 0, "an oblique line");
        assert!(cross((z, x), (z, x + aside)) == aside * z);
        assert!(cross((z, x), (z + aside, x)) == -aside * x);
        assert!(cross((z, x), (-z, aside - x)) == aside * z);
    }

    /// An arc and a line are parallel exactly when the line leads neither toward the centre nor away from it, so
    /// that the nearer one of their two common points is known.
    /// Of: `plane::cross`, `plane::dot`, `plane::tangent`
    /// Assumes: directions of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-51, E100L-NRC-63
    #[unwind(2)]
    fn a_line_beside_an_arc_has_a_nearer_point() {
        let (from_centre, line, turn) = (factors(), factors(), sign());
        kani::cover!(dot(from_centre, line) < 0 && turn < 0, "a line inward, a clockwise arc");
        assert!(cross(tangent(from_centre, turn), line) == -turn * dot(from_centre, line));
    }

    /// Two arcs are parallel exactly when their common point lies on the line of their centres.
    /// Of: `plane::cross`, `plane::tangent`, `plane::minus`
    /// Assumes: directions of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-49, E100L-NRC-52
    #[unwind(2)]
    fn the_point_of_two_arcs_is_beside_their_centres() {
        let (first, second, turn, turn_after) = (factors(), factors(), sign(), sign());
        let side = cross(minus(first, second), first);
        kani::cover!(turn != turn_after && side != 0, "an arc and a counter-arc");
        let tangents = cross(tangent(first, turn), tangent(second, turn_after));
        assert!(tangents == turn * turn_after * side);
    }

    /// The side of the line of centres on which that point lies is the same whichever arc comes first.
    /// Of: `plane::cross`, `plane::left`, `plane::minus`
    /// Assumes: directions of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-52, E100L-NRC-63
    #[unwind(2)]
    fn the_order_of_arcs_does_not_matter() {
        let (first, second) = (factors(), factors());
        let aside = |one, other| {
            let centres = minus(one, other);
            let (side, (z, x)) = (cross(centres, one).signum(), left(centres));
            (side * z, side * x)
        };
        kani::cover!(aside(first, second).0 < 0, "on one side");
        assert!(aside(first, second) == aside(second, first));
    }
}

refutations! {
    /// False: parallel directions lead the same way.
    #[unwind(2)]
    fn parallel_directions_lead_on() {
        let (way, times) = (factors(), factor(8));
        kani::assume(way.0.abs() < DIRECTION >> 3 && way.1.abs() < DIRECTION >> 3);
        let along = (times * way.0, times * way.1);
        assert!(cross(way, along) != 0 || dot(way, along) >= 0);
    }

    /// False: the left of a mirrored direction is the mirrored left.
    #[unwind(2)]
    fn mirroring_keeps_the_side() {
        let way = direction();
        assert!(left(mirrored(way)) == mirrored(left(way)));
    }

    /// False: a direction is as long bounded as it was.
    #[unwind(2)]
    fn no_direction_is_shortened() {
        let way = (within_wide(1 << 65), within_wide(1 << 65));
        assert!(bounded(way) == way);
    }
}
