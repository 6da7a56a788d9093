//! Theorems about the planes of contour generation: products that tell sides, sines and cosines of whole numbers, lengths and
//! feeds at the centre, circles that pass it, and the shorter way round.

use turnspec::engine::arithmetic::contour::{
    Spot, cross, dot, half, passes_near, percent_of, quarter, square, turn_length, twice_cosine, twice_sine, way,
};
use turnspec::engine::arithmetic::turn::{TURN, around, beside, shorter, travel};
use turnspec_oracle::integer::turn as oracle;

use crate::draw::{between, factor, one_of, within, within_wide};
#[cfg(stand_in)]
use crate::kani;

/// The largest coordinate.
const FAR: i64 = 1 << 42;

/// A point as far away as they are.
fn spot() -> Spot {
    Spot { p: within(FAR), q: within(FAR) }
}

/// A coordinate whose products are asserted.
fn coordinate() -> i64 {
    i64::try_from(factor(FAR.into())).unwrap_or(0)
}

/// A point whose products are asserted.
fn near_spot() -> Spot {
    Spot { p: coordinate(), q: coordinate() }
}

/// A direction, a multiple of 30 degrees or another, up to two turns away.
fn direction() -> i64 {
    if kani::any() { between(-24, 24) * 30_000_000 } else { within(2 * TURN) }
}

theorems! {
    /// No product of two points overflows, and no difference of them.
    /// Of: `contour::cross`, `contour::dot`, `contour::square`, `contour::way`
    /// Assumes: coordinates of at most 2^42 in size.
    /// Rules: E100L-CGF-06, E100L-CGF-14
    #[unwind(2)]
    fn no_product_of_points_overflows() {
        let (one, other) = (spot(), spot());
        kani::cover!(one.p < 0 && other.q > 0, "on different sides");
        let _ = (cross(one, other), dot(one, other), square(way(one, other)));
        assert!(way(one, other) != Spot::default() || one == other);
    }

    /// The side of two points changes when they are exchanged, or both are mirrored; a point is on no side of itself.
    /// Of: `contour::cross`
    /// Assumes: coordinates of at most 2^42 in size, of 8 for the model checker.
    /// Rules: E100L-CGF-06, E100L-CGF-14
    #[unwind(2)]
    fn sides_are_opposite() {
        let (one, other) = (near_spot(), near_spot());
        let mirrored = |spot: Spot| Spot { q: -spot.q, ..spot };
        kani::cover!(cross(one, other) != 0, "beside");
        assert!(cross(one, other) == -cross(other, one));
        assert!(cross(mirrored(one), mirrored(other)) == -cross(one, other));
        assert!(cross(one, one) == 0);
    }

    /// A point and its multiple lie on one line through the centre: on one ray when the factor is positive, on opposite rays
    /// when it is negative.
    /// Of: `contour::cross`, `contour::dot`, `Spot::is_centre`
    /// Assumes: coordinates of at most 2^30 in size, of 8 for the model checker, a factor of at most 8 in size.
    /// Rules: E100L-CGF-14
    #[unwind(2)]
    fn multiples_lie_on_a_ray() {
        let [p, q, times] = [1 << 30, 1 << 30, 8].map(|size| i64::try_from(factor(size)).unwrap_or(0));
        let (one, other) = (Spot { p, q }, Spot { p: p * times, q: q * times });
        kani::cover!(times < 0 && !one.is_centre(), "on opposite rays");
        assert!(cross(one, other) == 0);
        assert!(one.is_centre() || dot(one, other).signum() == i128::from(times.signum()));
    }

    /// The square of the way between two points is the same in both directions, and zero only between equal ones.
    /// Of: `contour::square`, `contour::way`
    /// Assumes: coordinates of at most 2^42 in size, of 8 for the model checker.
    /// Rules: E100L-CGF-02, E100L-CGF-04
    #[unwind(2)]
    fn distances_are_the_same_both_ways() {
        let (one, other) = (near_spot(), near_spot());
        kani::cover!(one != other, "apart");
        let there = square(way(one, other));
        assert!(there == square(way(other, one)) && there >= 0 && (there == 0) == (one == other));
    }

    /// A sine is odd and goes on with every turn; it is rational at multiples of 30 degrees only, and there 0, half of 1 or 1 in size.
    /// Of: `contour::twice_sine`
    /// Assumes: angles of at most two turns.
    /// Rules: E100L-CGF-01
    #[unwind(2)]
    fn sines_are_odd() {
        let angle = direction();
        let sine = twice_sine(angle);
        kani::cover!(sine == Some(-1), "half of -1");
        assert!(twice_sine(-angle) == sine.map(|twice| -twice) && twice_sine(angle + TURN) == sine);
        assert!(sine.is_none_or(|twice| twice.abs() <= 2 && angle % 30_000_000 == 0));
    }

    /// A cosine is even, and that of the opposite direction has the other sign. Where both are rational, the squares of sine
    /// and cosine make 1.
    /// Of: `contour::twice_cosine`, `contour::twice_sine`
    /// Assumes: angles of at most two turns.
    /// Rules: E100L-CGF-01, E100L-CGF-04
    #[unwind(2)]
    fn cosines_are_even() {
        let angle = direction();
        let (sine, cosine) = (twice_sine(angle), twice_cosine(angle));
        kani::cover!(sine.is_some() && cosine.is_some(), "both rational");
        assert!(twice_cosine(-angle) == cosine);
        assert!(twice_cosine(angle + TURN / 2) == cosine.map(|twice| -twice));
        if let (Some(sine), Some(cosine)) = (sine, cosine) {
            assert!(sine * sine + cosine * cosine == 4);
        }
    }

    /// A coordinate on a diameter is the nearest whole number, the one farther from zero where two are as near.
    /// Of: `contour::quarter`
    /// Assumes: diameters of at most 2^43 in size, fractions of at most 2 in size.
    /// Rules: E100L-CGF-01
    #[unwind(2)]
    fn coordinates_are_rounded_half_away() {
        let (diameter, fraction) = (within(1 << 43), one_of(&[-2, -1, 0, 1, 2]));
        let off = 4 * quarter(diameter, fraction) - diameter * fraction;
        kani::cover!(off == -2, "half of one, below zero");
        assert!((-2..=2).contains(&off));
        assert!(off.abs() < 2 || (off < 0) == (diameter * fraction < 0));
    }

    /// Half a number is rounded away from zero, and so is its opposite.
    /// Of: `contour::half`
    /// Assumes: numbers of at most 2^64 in size.
    /// Rules: E100L-CGF-04
    #[unwind(2)]
    fn halves_go_away_from_zero() {
        let sum = within_wide(1 << 64);
        let off = 2 * half(sum) - sum;
        kani::cover!(off != 0, "odd");
        assert!(off == if sum % 2 == 0 { 0 } else { sum.signum() });
    }

    /// The length of a turn at the centre is the nearest to 500 mm for 360 degrees, whatever its direction.
    /// Of: `contour::turn_length`
    /// Assumes: turns of at most half a turn, of a thousandth of a degree for exactness in the model checker.
    /// Rules: E100L-CGF-12, E100L-CFEED-01
    #[unwind(2)]
    fn lengths_of_turns_are_nearest() {
        let turn = within(TURN / 2);
        kani::cover!(turn < 0, "back");
        assert!(turn_length(turn) >= 0 && turn_length(turn) == turn_length(-turn));
        let short = within(1_000);
        let off = 18 * turn_length(short) - 25 * short.abs();
        assert!(-9 < off && off <= 9);
    }

    /// All of a feed is the feed, more percent never make less of it, and nothing overflows.
    /// Of: `contour::percent_of`
    /// Assumes: a feed below 2^48, at most 1000 percent; for monotony a feed of at most 1000.
    /// Rules: E100L-CGF-12
    #[unwind(2)]
    fn more_percent_are_no_less_feed() {
        let feed = between(0, (1 << 48) - 1);
        let percent = u16::try_from(between(1, 999)).unwrap_or(1);
        kani::cover!(percent > 100, "more than the feed");
        assert!(percent_of(feed, 100) == feed && percent_of(feed, percent) >= 0);
        let small = between(0, 1_000);
        assert!(percent_of(small, percent) <= percent_of(small, percent + 1));
    }

    /// A circle passes the centre near exactly when the distance of its own centre differs from the radius by less.
    /// Of: `contour::passes_near`
    /// Assumes: a whole distance, radius and distance of at most 2^42, of 8 for the model checker.
    /// Rules: E100L-CGF-04
    #[unwind(2)]
    fn near_means_nearer_than_the_distance() {
        let [radius, distance] = [coordinate(), coordinate()].map(i64::abs);
        let away = (radius + coordinate()).abs();
        let near = passes_near(i128::from(away) * i128::from(away), radius, distance);
        kani::cover!(near && radius > distance, "near, and not at the centre of the face");
        assert!(near == ((away - radius).abs() < distance));
    }

    /// The shorter way is at most half a turn, leads where the way forward or back leads, and is positive where both are as
    /// long. Engine and oracle agree on the ways.
    /// Of: `turn::shorter`, `turn::travel`, `integer::turn::travel`
    /// Assumes: angles within a turn.
    /// Rules: E100L-CGF-10
    #[unwind(2)]
    fn the_shorter_way_is_at_most_half_a_turn() {
        let present = between(0, TURN - 1);
        let apart = if kani::any() { one_of(&[0, TURN / 2 - 1, TURN / 2, TURN / 2 + 1]) } else { between(0, TURN - 1) };
        let target = (present + apart) % TURN;
        let way = shorter(present, target);
        kani::cover!(way == TURN / 2, "half a turn");
        assert!(-TURN / 2 < way && way <= TURN / 2);
        let (forward, back) = (travel(present, target, 0, false), travel(present, target, 0, true));
        assert!(way == forward || way == back);
        assert!(forward == oracle::travel(present, target, 0, true));
        assert!(back == oracle::travel(present, target, 0, false));
    }

    /// A way to an angle on a known side leads there, and is no more than three quarters of a turn; where the angles do not contradict
    /// the side it is the way in that direction. Engine and oracle agree.
    /// Of: `turn::beside`, `integer::turn::beside`
    /// Assumes: angles within a turn.
    /// Rules: E100L-CRC-14
    #[unwind(2)]
    fn a_way_beside_the_centre_is_no_whole_turn() {
        let (present, target) = (between(0, TURN - 1), between(0, TURN - 1));
        let negative: bool = kani::any();
        let way = beside(present, target, negative);
        let plain = travel(present, target, 0, negative);
        kani::cover!(way != plain, "rounding");
        assert!(way.abs() <= TURN / 4 * 3);
        assert!(way == plain || (way - plain).abs() == TURN && plain.abs() > TURN / 4 * 3);
        assert!(way == oracle::beside(present, target, !negative));
    }

    /// A way round the centre leads there in its direction, and is a quarter of a turn at least; where it is no less it is the plain
    /// way. Engine and oracle agree.
    /// Of: `turn::around`, `integer::turn::around`
    /// Assumes: angles within a turn.
    /// Rules: E100L-CRC-14
    #[unwind(2)]
    fn a_way_round_the_centre_is_never_nothing() {
        let (present, target) = (between(0, TURN - 1), between(0, TURN - 1));
        let negative: bool = kani::any();
        let way = around(present, target, negative);
        let plain = travel(present, target, 0, negative);
        kani::cover!(way != plain, "rounding");
        assert!(way.abs() >= TURN / 4 && (way < 0) == negative);
        assert!(way == plain || (way - plain).abs() == TURN && plain.abs() < TURN / 4);
        assert!(way == oracle::around(present, target, !negative));
    }
}

refutations! {
    /// False: the shorter way is shorter than a quarter of a turn.
    #[unwind(2)]
    fn the_shorter_way_is_short() {
        let (present, target) = (between(0, TURN - 1), between(0, TURN - 1));
        assert!(shorter(present, target) < TURN / 4);
    }

    /// False: a way beside the centre keeps its direction.
    #[unwind(2)]
    fn beside_the_centre_is_never_back() {
        let (present, target) = (between(0, TURN - 1), between(0, TURN - 1));
        assert!(beside(present, target, false) >= 0);
    }

    /// False: points of one line through the centre lie on one ray.
    #[unwind(2)]
    fn one_line_is_one_ray() {
        let (one, times) = (near_spot(), one_of(&[-1, 1]));
        let other = Spot { p: one.p * times, q: one.q * times };
        assert!(one.is_centre() || dot(one, other) > 0);
    }
}
