//! Theorems about the run-out chamfer of a thread.

use turnspec::engine::arithmetic::run_out::{
    begin, is_deeper, is_too_long, level_at, reached, reaches_start, rise, turn, unit, withdrawal_rate, withdrawn,
};
use turnspec_oracle::integer::thread as oracle;

use crate::draw::{between, factor, within};
#[cfg(stand_in)]
use crate::kani;

/// Coordinates: far more than those of any address.
const COORDINATE: i64 = 1 << 60;
/// Doubled lengths along the lead axis.
const LENGTH: i64 = 1 << 62;
/// Parameters of the withdrawal rate.
const PARAMETERS: (i64, i64) = (1, 9999);

/// How many coordinates make a length of two.
fn halves() -> i128 {
    if kani::any() { 1 } else { 2 }
}

/// 1 or -1.
fn side() -> i128 {
    if kani::any() { 1 } else { -1 }
}

/// A coordinate: at most 8 in size for the model checker.
fn place(size: i64) -> i64 {
    i64::try_from(factor(size.into())).unwrap_or(0)
}

/// A number from 0, and one from 1: at most 8 for the model checker.
fn some(most: i128) -> i128 {
    factor(most).abs()
}

fn positive(most: i128) -> i128 {
    let value = some(most);
    kani::assume(value > 0);
    value
}

theorems! {
    /// Where a chamfer begins is found without overflow; one of no length begins at the end.
    /// Of: `run_out::begin`
    /// Assumes: ends of at most 2^60 in size, lengths of at most 2^80 picometres.
    /// Rules: E100L-TCHM-02
    #[unwind(2)]
    fn no_chamfer_overflows() {
        let (end, length): (_, i128) = (within(COORDINATE), kani::any());
        kani::assume((0..=1 << 80).contains(&length));
        kani::cover!(length == 1 << 80 && end == -COORDINATE, "the greatest length");
        let from = begin(end, side(), length, halves());
        assert!(length < 1 << 79 || from != end);
    }

    /// A chamfer of a whole number of nanometres begins just so far before the end of the thread, as a difference of
    /// diameters twice as far.
    /// Of: `run_out::begin`
    /// Assumes: coordinates and lengths of at most 8 for the model checker, of at most 2^59 for the property tests.
    /// Rules: E100L-TCHM-02
    #[unwind(2)]
    fn a_chamfer_begins_before_the_end() {
        let (end, length, way) = (place(1 << 59), some(1 << 59), side());
        let from = |halves| way * (i128::from(end) - i128::from(begin(end, way, 1000 * length, halves)));
        kani::cover!(way < 0 && length > 0, "toward smaller coordinates");
        assert!(from(2) == length && from(1) == 2 * length);
    }

    /// A chamfer may be as long as the thread and no longer; no length overflows.
    /// Of: `run_out::is_too_long`
    /// Assumes: twice lengths of at most 2^62 nanometres.
    /// Rules: E100L-TCHM-02
    #[unwind(2)]
    fn a_chamfer_is_as_long_as_the_thread_at_most() {
        let thread = i128::from(between(0, LENGTH));
        kani::cover!(thread == LENGTH.into(), "the longest thread");
        assert!(!is_too_long(500 * thread, thread) && is_too_long(500 * thread + 1, thread));
        assert!(is_too_long(1 << 80, thread));
    }

    /// No level of a thread overflows; a straight thread at level 0 stays there.
    /// Of: `run_out::level_at`
    /// Assumes: levels of at most 2^60 in size, twice lengths of at most 2^62, a rest of at most the whole.
    /// Rules: E100L-TCHM-04
    #[unwind(2)]
    fn no_level_overflows() {
        let (first, last) = (within(COORDINATE), within(COORDINATE));
        let whole = between(1, LENGTH);
        let rest = between(0, LENGTH);
        kani::assume(rest <= whole);
        kani::cover!(first - last > COORDINATE && whole == LENGTH, "a great taper on the longest thread");
        let level = level_at(first, last, whole.into(), rest.into());
        assert!(first != 0 || last != 0 || level == 0);
    }

    /// The level is the first one over the whole length before the end, the last one at the end, and between them
    /// otherwise.
    /// Of: `run_out::level_at`
    /// Assumes: levels and lengths of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-TCHM-04
    #[unwind(2)]
    fn the_level_lies_between_its_ends() {
        let (first, last) = (place(COORDINATE), place(COORDINATE));
        let (whole, rest) = (positive(1 << 60), some(1 << 60));
        kani::assume(rest <= whole);
        let level = level_at(first, last, whole, rest);
        kani::cover!(first < level && level < last, "between");
        assert!(first.min(last) <= level && level <= first.max(last));
        assert!(level_at(first, last, whole, whole) == first && level_at(first, last, whole, 0) == last);
    }

    /// No withdrawal overflows; without one a level of 0 stays.
    /// Of: `run_out::unit`, `run_out::rise`, `run_out::turn`, `run_out::withdrawn`
    /// Assumes: parameters of 1 to 9999, twice lengths of at most 2^62, speeds of 1 to 2^27, leads of 1 to 2^60, levels of at
    /// most 2^60 in size.
    /// Rules: E100L-TCHM-03
    #[unwind(2)]
    fn no_withdrawal_overflows() {
        let unit = unit(between(PARAMETERS.0, PARAMETERS.1).into(), halves());
        let (rise, turn) =
            (rise(unit, between(0, LENGTH).into()), turn(between(1, 1 << 27), between(1, COORDINATE)));
        kani::cover!(turn == 1, "the slowest feed");
        assert!(unit > 0 && (0..1 << 119).contains(&rise) && (1..=1 << 87).contains(&turn));
        let level = within(COORDINATE);
        let after = withdrawn(level, side(), rise, turn);
        assert!(level != 0 || rise != 0 || after == 0);
    }

    /// Whether the start is reached, and whether the tool is deeper, is decided without overflow, as is where the start is
    /// reached; without room it always is.
    /// Of: `run_out::reaches_start`, `run_out::is_deeper`, `run_out::reached`
    /// Assumes: rooms of at most 2^62, a withdrawal below 2^119, feeds of at most 2^87, coordinates of at most 2^60 in size.
    /// Rules: E100L-TCHM-04
    #[unwind(2)]
    fn no_decision_overflows() {
        let (room, turn): (i128, i128) = (between(0, LENGTH).into(), kani::any());
        let rise: i128 = kani::any();
        kani::assume((1..=1 << 87).contains(&turn) && (0..1 << 119).contains(&rise));
        let unit = unit(between(PARAMETERS.0, PARAMETERS.1).into(), halves());
        let reaches = reaches_start(room, rise, turn);
        kani::cover!(reaches && room > 0, "the start is reached");
        assert!(reaches || room > 0);
        if reaches {
            let from = within(COORDINATE);
            let place = reached(from, side(), room, turn, unit, halves());
            assert!(from != 0 || room != 0 || place == 0);
        }
        let above = i128::from(within(LENGTH));
        assert!(above < 0 || !is_deeper(above, rise, turn));
    }

    /// A withdrawal of a whole number changes the level by that number, to its side.
    /// Of: `run_out::withdrawn`
    /// Assumes: levels, withdrawals and feeds of at most 8 for the model checker, of at most 2^30 for the property tests.
    /// Rules: E100L-TCHM-04
    #[unwind(2)]
    fn a_withdrawal_changes_the_level() {
        let (level, side) = (place(1 << 30), side());
        let (turn, rise) = (positive(1 << 30), some(1 << 30));
        kani::cover!(side < 0 && rise > 0, "to smaller levels");
        assert!(i128::from(withdrawn(level, side, rise * turn, turn)) == i128::from(level) + side * rise);
    }

    /// A withdrawal that does not reach the start ends between the level where it begins and the start.
    /// Of: `run_out::withdrawn`, `run_out::reaches_start`
    /// Assumes: levels, rooms, withdrawals and feeds of at most 8 for the model checker, of at most 2^50 for the property
    /// tests.
    /// Rules: E100L-TCHM-04
    #[unwind(2)]
    fn a_withdrawal_ends_before_the_start() {
        let (level, side, room) = (place(1 << 50), side(), some(1 << 50));
        let (turn, rise) = (positive(1 << 50), some(1 << 50));
        kani::assume(!reaches_start(room, rise, turn));
        let way = side * (i128::from(withdrawn(level, side, rise, turn)) - i128::from(level));
        kani::cover!(way > 0 && way < room, "between");
        assert!(0 <= way && way <= room);
    }

    /// Without room the start is reached where the chamfer begins; when the whole withdrawal is needed, at the end.
    /// Of: `run_out::reached`, `run_out::reaches_start`, `run_out::rise`
    /// Assumes: coordinates, lengths and units of at most 8 for the model checker, of at most 2^30 for the property tests.
    /// Rules: E100L-TCHM-04
    #[unwind(2)]
    fn the_start_is_reached_on_the_way() {
        let (from, way, halves) = (place(1 << 30), side(), halves());
        let (unit, length) = (positive(1 << 30), some(1 << 30));
        // As many as the length has, so that each takes a unit.
        let rest = halves * length;
        kani::cover!(halves == 1 && length > 0, "along X");
        assert!(reaches_start(rest, rise(unit, rest), unit) && !reaches_start(rest + 1, rise(unit, rest), unit));
        let place = |room| i128::from(reached(from, way, room, unit, unit, halves));
        assert!(place(0) == from.into() && place(rest) == i128::from(from) + way * length);
    }

    /// The tool is deeper exactly where it withdraws by less than the taper falls.
    /// Of: `run_out::is_deeper`
    /// Assumes: levels, withdrawals and feeds of at most 8 for the model checker, of at most 2^60 for the property tests.
    /// Rules: E100L-TCHM-04
    #[unwind(2)]
    fn a_steep_taper_is_deeper() {
        let (above, turn, rise) = (factor(1 << 60), positive(1 << 60), some(1 << 60));
        kani::cover!(above < 0 && rise == -above * turn, "just as deep");
        assert!(is_deeper(above, rise, turn) == (rise < -above * turn));
    }

    /// Engine and oracle withdraw at the same rate.
    /// Of: `run_out::withdrawal_rate`, `integer::thread::withdrawal_rate`
    /// Assumes: any parameter of 16 bits.
    /// Rules: E100L-TCHM-03
    #[unwind(2)]
    fn both_withdraw_alike() {
        let parameter: u16 = kani::any();
        kani::cover!(parameter > 9999, "beyond every parameter");
        assert!(withdrawal_rate(parameter.into()) == oracle::withdrawal_rate(parameter));
    }

    /// The withdrawal of a chamfer has the rate of the withdrawal behind it: in the units of lead and speed a doubled
    /// nanometre counts 500 of the rate's picometres.
    /// Of: `run_out::unit`, `run_out::withdrawal_rate`
    /// Assumes: parameters of 1 to 9999.
    /// Rules: E100L-TCHM-03
    #[unwind(2)]
    fn a_chamfer_has_the_rate_of_the_withdrawal() {
        let parameter = between(PARAMETERS.0, PARAMETERS.1);
        kani::cover!(parameter == 9999, "the greatest parameter");
        assert!(unit(parameter.into(), 2) == 500 * i128::from(withdrawal_rate(parameter)));
        assert!(unit(parameter.into(), 1) == 2 * unit(parameter.into(), 2));
    }
}

refutations! {
    /// False: every chamfer reaches the level of the cycle start.
    #[unwind(2)]
    fn every_chamfer_reaches_the_start() {
        assert!(reaches_start(some(8), some(8), positive(8)));
    }

    /// False: a chamfer that begins at the end of the thread is the only one that ends there.
    #[unwind(2)]
    fn a_chamfer_has_no_length() {
        let end = place(8);
        assert!(begin(end, side(), 1000 * some(8), halves()) == end);
    }

    /// False: a withdrawal is rounded toward the start.
    #[unwind(2)]
    fn a_withdrawal_is_rounded_up() {
        let (turn, rise) = (positive(8), some(8));
        assert!(i128::from(withdrawn(0, 1, rise, turn)) * turn >= rise);
    }
}
