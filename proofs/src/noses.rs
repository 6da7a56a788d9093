//! Theorems about the nose of the tool: its radius, its centre, its tip, the side of the contour that it is on, and
//! whether an arc has room for it.

use turnspec::engine::arithmetic::nose::{is_too_large, nose, offset, touches_both};
use turnspec::engine::arithmetic::plane::{Direction, Point, left};
use turnspec_oracle::integer;

use crate::draw::{between, factor, within};
#[cfg(stand_in)]
use crate::kani;

/// Lengths of a nose: far more than those of a set-up or a variable.
const LENGTH: i64 = 1 << 61;
/// Coordinates: far more than those of any address, offset or shift.
const COORDINATE: i64 = 1 << 59;

fn any_point() -> Point {
    Point { x: kani::any(), z: kani::any() }
}

fn point(size: i64) -> Point {
    Point { x: within(size), z: within(size) }
}

fn pair(point: Point) -> (i64, i64) {
    (point.x, point.z)
}

/// 1, the tool on the left, or -1.
fn side() -> i128 {
    if kani::any() { 1 } else { -1 }
}

fn radius() -> i64 {
    between(0, i64::MAX)
}

/// Of at most 2^60 in each component.
fn direction() -> Direction {
    let part = || i128::from(kani::any::<i64>() >> 3);
    (part(), part())
}

/// The exact sum of two numbers, at the end of 64 bits that is nearest to it.
fn saturated(first: i64, second: i128) -> i64 {
    let sum = (i128::from(first) + second).clamp(i64::MIN.into(), i64::MAX.into());
    i64::try_from(sum).unwrap_or(0)
}

theorems! {
    /// The nose radius is the larger one of the lengths along X and Z without their signs.
    /// Of: `nose::nose`
    /// Assumes: lengths of at most 2^61 in size.
    /// Rules: E100L-NRC-04
    #[unwind(2)]
    fn the_radius_is_the_larger_length() {
        let (x, z) = (within(LENGTH), within(LENGTH));
        let (radius, _) = nose([x, z]);
        kani::cover!(x < 0 && radius == -x && z > 0, "the one along X, negative");
        assert!(radius >= x.abs() && radius >= z.abs());
        assert!(radius == x.abs() || radius == z.abs());
    }

    /// The nose centre lies no further from the tip than the radius along Z and twice the radius as a diameter, in
    /// the direction that the signs of the lengths say; without a nose it is the tip.
    /// Of: `nose::nose`
    /// Assumes: lengths of at most 2^61 in size.
    /// Rules: E100L-NRC-04, E100L-NRC-05
    #[unwind(2)]
    fn the_signs_of_a_nose_point_to_its_centre() {
        let (x, z) = (within(LENGTH), within(LENGTH));
        let (radius, to_centre) = nose([x, z]);
        kani::cover!(x < 0 && z > 0, "a boring bar");
        assert!(to_centre.x.signum() == x.signum() && to_centre.z.signum() == z.signum());
        let reach = |length: i64| i128::from(length).abs();
        assert!(reach(to_centre.x) <= 2 * reach(radius) && reach(to_centre.z) <= reach(radius));
        assert!((radius == 0) == (to_centre == Point { x: 0, z: 0 }));
    }

    /// Engine and oracle measure a nose alike.
    /// Of: `nose::nose`, `integer::nose::radius`, `integer::nose::to_centre`
    /// Assumes: lengths of at most 2^61 in size.
    /// Rules: E100L-NRC-04, E100L-NRC-05
    #[unwind(2)]
    fn both_measure_a_nose_alike() {
        let (x, z) = (within(LENGTH), within(LENGTH));
        let (radius, to_centre) = nose([x, z]);
        kani::cover!(radius != z, "another radius than the length along Z");
        assert!(radius == integer::nose::radius(x, z));
        assert!(pair(to_centre) == integer::nose::to_centre(x, z));
    }

    /// The tip of a nose centre has that nose centre.
    /// Of: `Point::minus`, `Point::plus`, `integer::nose::tip`, `integer::nose::centre`
    /// Assumes: coordinates and ways of at most 2^60 in size.
    /// Rules: E100L-NRC-05, E100L-NRC-07
    #[unwind(2)]
    fn tip_and_centre_correspond() {
        let (centre, to_centre) = (point(1 << 60), point(1 << 60));
        let tip = centre.minus(to_centre);
        kani::cover!(tip.x > centre.x && tip.z < centre.z, "a boring bar");
        assert!(tip.plus(to_centre) == centre);
        let tip = integer::nose::tip(pair(centre), pair(to_centre));
        assert!(integer::nose::centre(tip, pair(to_centre)) == pair(centre));
    }

    /// Beyond every range a point that is moved stays at the end of 64 bits; within them the sum is exact.
    /// Of: `Point::plus`, `Point::minus`
    /// Assumes: any points.
    /// Rules: E100L-NRC-07, E100L-ADDR-01
    #[unwind(2)]
    fn no_moved_point_wraps() {
        let (start, by) = (any_point(), any_point());
        kani::cover!(start.x < 0 && by.x == i64::MIN, "a move beyond 64 bits");
        let (there, back) = (start.plus(by), start.minus(by));
        assert!(there.x == saturated(start.x, by.x.into()) && there.z == saturated(start.z, by.z.into()));
        assert!(back.x == saturated(start.x, -i128::from(by.x)));
        assert!(back.z == saturated(start.z, -i128::from(by.z)));
    }

    /// Engine and oracle find the same tip of a nose centre, even where it leaves 64 bits.
    /// Of: `Point::minus`, `integer::nose::tip`
    /// Assumes: any points.
    /// Rules: E100L-NRC-07
    #[unwind(2)]
    fn both_find_the_same_tip() {
        let (centre, to_centre) = (any_point(), any_point());
        kani::cover!(centre.x == i64::MAX && to_centre.x < 0, "a centre beyond 64 bits");
        assert!(pair(centre.minus(to_centre)) == integer::nose::tip(pair(centre), pair(to_centre)));
    }

    /// Engine and oracle take the axes to the same place for a tip: as far from the programmed point as it is.
    /// Of: `Point::minus`, `Point::plus`, `integer::nose::machine`
    /// Assumes: tips of at most 2^60 in size, programmed points of at most 2^59.
    /// Rules: E100L-NRC-07, E100L-NRC-80
    #[unwind(2)]
    fn both_take_the_axes_to_the_tip() {
        let (tip, program, machine) = (point(1 << 60), point(COORDINATE), point(COORDINATE));
        let axes = machine.plus(tip.minus(program));
        kani::cover!(program.x != machine.x && axes.x != machine.x, "offset and displaced");
        assert!(axes.x == integer::nose::machine(tip.x, program.x, machine.x));
        assert!(axes.z == integer::nose::machine(tip.z, program.z, machine.z));
    }

    /// Engine and oracle find the tip again where the axes are, and the axes stay there when it is kept.
    /// Of: `Point::plus`, `integer::nose::tip_at`, `integer::nose::machine`
    /// Assumes: points and displacements of at most 2^59 in size.
    /// Rules: E100L-NRC-46, E100L-NRC-71
    #[unwind(2)]
    fn both_keep_the_tip_where_the_axes_are() {
        let (program, machine, displacement) = (within(COORDINATE), within(COORDINATE), within(COORDINATE));
        let at = |z| Point { x: 0, z }.plus(Point { x: 0, z: displacement }).z;
        let (tip, axis) = (at(program), at(machine));
        kani::cover!(program != machine && displacement < 0, "offset and displaced");
        assert!(integer::nose::tip_at(axis, program, machine) == tip);
        assert!(integer::nose::machine(tip, program, machine) == axis);
    }

    /// On the other side of the contour a nose has the opposite offset; only without a radius the side does not
    /// matter.
    /// Of: `nose::offset`
    /// Assumes: any radius that is not negative.
    /// Rules: E100L-NRC-01, E100L-NRC-02
    #[unwind(2)]
    fn the_other_side_has_the_opposite_offset() {
        let (side, radius) = (side(), radius());
        let (here, there) = (offset(side, radius), offset(-side, radius));
        kani::cover!(radius == i64::MAX, "the largest radius");
        assert!(here == -there && (here == there) == (radius == 0));
        assert!(radius == 0 || here.signum() == side);
    }

    /// The oracle's offset, in nanometres, is half the engine's, in half nanometres.
    /// Of: `nose::offset`, `integer::nose::offset`
    /// Assumes: any radius that is not negative.
    /// Rules: E100L-NRC-02
    #[unwind(2)]
    fn both_offset_alike() {
        let (tool_left, radius) = (kani::any::<bool>(), radius());
        kani::cover!(!tool_left && radius > 0, "the tool on the right");
        let offset = offset(if tool_left { 1 } else { -1 }, radius);
        assert!(offset == 2 * i128::from(integer::nose::offset(tool_left, radius)));
    }

    /// Straight on a nose touches both elements with one offset; back it does on the other side.
    /// Of: `nose::touches_both`, `nose::offset`
    /// Assumes: any radius above zero.
    /// Rules: E100L-NRC-30, E100L-NRC-31, E100L-NRC-32, E100L-NRC-33
    #[unwind(2)]
    fn parallel_elements_are_touched_on_one_line() {
        let (side, radius, same) = (side(), radius(), kani::any::<bool>());
        kani::assume(radius > 0);
        kani::cover!(!same, "back");
        let (here, there) = (offset(side, radius), offset(-side, radius));
        assert!(touches_both(here, here, same) == same);
        assert!(touches_both(here, there, same) != same);
    }

    /// With another radius a nose does not touch both of two parallel elements, on whatever sides.
    /// Of: `nose::touches_both`, `nose::offset`
    /// Assumes: any two different radii that are not negative.
    /// Rules: E100L-NRC-11, E100L-NRC-32, E100L-NRC-33
    #[unwind(2)]
    fn another_radius_touches_one_element() {
        let (before, after) = (radius(), radius());
        kani::assume(before != after);
        kani::cover!(before == 0, "an element without a radius");
        assert!(!touches_both(offset(side(), before), offset(side(), after), kani::any()));
    }

    /// Engine and oracle decide alike whether a nose touches both of two parallel elements.
    /// Of: `nose::touches_both`, `nose::offset`, `integer::nose::touches_both`, `integer::nose::offset`
    /// Assumes: any radii that are not negative.
    /// Rules: E100L-NRC-30, E100L-NRC-31, E100L-NRC-32, E100L-NRC-33
    #[unwind(2)]
    fn both_touch_parallel_elements_alike() {
        let radii = (radius(), if kani::any() { 0 } else { radius() });
        let ((before, after), onward) = ((kani::any(), kani::any()), kani::any());
        let of_engine = |left: bool, radius| offset(if left { 1 } else { -1 }, radius);
        let touches = touches_both(of_engine(before, radii.0), of_engine(after, radii.1), onward);
        kani::cover!(touches && before == after, "both touched");
        let (offset, next) =
            (integer::nose::offset(before, radii.0), integer::nose::offset(after, radii.1));
        assert!(touches == integer::nose::touches_both(offset, next, onward));
    }

    /// Whether an arc has room for a nose is decided without overflow: outside it always has, in its centre
    /// never.
    /// Of: `nose::is_too_large`
    /// Assumes: noses of at most 2^62, directions of at most 2^60.
    /// Rules: E100L-NRC-48
    #[unwind(2)]
    fn no_nose_overflows() {
        let (inward, from_centre) = (i128::from(kani::any::<i64>() >> 1), direction());
        kani::cover!(from_centre.0 == -(1 << 60), "a direction of the largest size");
        assert!(!is_too_large(inward, from_centre) || inward > 0 || from_centre == (0, 0));
        assert!(is_too_large(inward, (0, 0)));
    }

    /// An arc has room exactly for the noses of at most its radius.
    /// Of: `nose::is_too_large`
    /// Assumes: radii along an axis, or five times a number along the sides 3 and 4, none zero; numbers and noses of at most 8
    /// and 40 for the model checker, of at most 2^57 and 2^60 for the property tests.
    /// Rules: E100L-NRC-48, E100L-NRC-56
    #[unwind(2)]
    fn an_arc_has_room_for_its_own_radius() {
        let unit = factor(1 << 57);
        kani::assume(unit != 0);
        let inward = if kani::any() { 5 * unit.abs() + factor(8) } else { 5 * factor(1 << 57) };
        let along_axis = is_too_large(inward, (0, 5 * unit));
        let oblique = is_too_large(inward, (3 * unit, 4 * unit));
        kani::cover!(inward == 5 * unit.abs(), "the radius itself");
        kani::cover!(inward == 5 * unit.abs() + 1, "half a nanometre more");
        assert!(along_axis == (inward > 5 * unit.abs()) && oblique == along_axis);
    }

    /// Where a nose is too large, a larger one is, too; the quadrant does not matter.
    /// Of: `nose::is_too_large`
    /// Assumes: directions and noses of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-NRC-48, E100L-NRC-58
    #[unwind(2)]
    fn a_larger_nose_fits_no_better() {
        let (z, x) = (factor(1 << 60), factor(1 << 60));
        let (inward, more) = (factor(1 << 60), factor(1 << 60).abs());
        let too_large = is_too_large(inward, (z, x));
        kani::cover!(too_large && (z, x) != (0, 0), "too large a nose");
        assert!(!too_large || is_too_large(inward + more, (z, x)));
        assert!(is_too_large(inward, left((z, x))) == too_large);
        assert!(is_too_large(inward, (z, -x)) == too_large);
    }
}

refutations! {
    /// False: a nose touches both of two parallel elements with one radius, whatever its sides.
    #[unwind(2)]
    fn one_radius_is_enough() {
        let radius = radius();
        assert!(touches_both(offset(side(), radius), offset(side(), radius), kani::any()));
    }

    /// False: the tip is as far from the programmed point as the nose centre.
    #[unwind(2)]
    fn the_tip_is_the_centre() {
        let (centre, [x, z]) = (point(COORDINATE), [within(1 << 40), within(1 << 40)]);
        let (_, to_centre) = nose([x, z]);
        assert!(centre.minus(to_centre) == centre);
    }

    /// False: an arc has room for every nose below its size along both axes together.
    #[unwind(2)]
    fn both_axes_make_room() {
        let (z, x) = (factor(8), factor(8));
        let inward = factor(16);
        assert!(inward >= z.abs() + x.abs() || !is_too_large(inward, (z, x)));
    }
}
