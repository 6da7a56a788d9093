//! Theorems about the depths of the passes of a thread, and about their flanks. Depths that are roots are tested.

use turnspec::engine::arithmetic::infeed::{
    areas, balanced_count, flank_sign, halving, is_left_by_turns, right_angle_shift, square, steps,
};
use turnspec_oracle::integer::thread as oracle;
use turnspec_oracle::vocabulary::ThreadFlank;

use crate::draw::{between, factor};
#[cfg(stand_in)]
use crate::kani;

/// Depths: more than any D or H word.
const DEPTH: i64 = 1 << 37;

/// From 1: at most 8 for the model checker.
fn few(most: i64) -> i64 {
    let value = i64::try_from(factor(most.into()).abs()).unwrap_or(1);
    kani::assume(value > 0);
    value
}

/// A step, and a target of at least a step.
fn step_and_target() -> (i64, i64) {
    let step = between(1, DEPTH);
    (step, between(step, DEPTH))
}

fn reading() -> ThreadFlank {
    if kani::any() { ThreadFlank::Negative } else { ThreadFlank::Positive }
}

theorems! {
    /// No depth of M73 overflows or passes the target; the first of them are no deeper than a step before it.
    /// Of: `infeed::halving`
    /// Assumes: a step of at most 2^37, a target of at least a step and at most 2^37, any number of a pass.
    /// Rules: E100L-TINF-02
    #[unwind(2)]
    fn no_halved_step_passes_the_target() {
        let (step, target) = step_and_target();
        let number = between(1, i64::MAX);
        let depth = halving(number, step, target);
        kani::cover!(depth.is_some() && number > 3, "a step before the parts");
        kani::cover!(step == target, "no step of D");
        assert!(depth.is_none_or(|depth| depth <= target));
        assert!(depth.is_some() || number > 3);
    }

    /// M73 takes as many steps as reach a step before the target, and three parts of one behind them.
    /// Of: `infeed::halving`
    /// Assumes: steps of at most 8, at most 9 of them before the target, for the model checker; of at most 2^18, at most
    /// 2^18 of them, for the property tests.
    /// Rules: E100L-TINF-02
    #[unwind(2)]
    fn three_parts_stand_behind_the_steps() {
        let (step, whole) = (few(1 << 18), few(1 << 18));
        let rest = between(0, step - 1);
        let target = step * (whole + 1) + rest;
        let count = whole + i64::from(rest > 0);
        kani::cover!(rest > 0, "a shorter step");
        assert!(halving(whole, step, target) == Some(step * whole));
        assert!(halving(count, step, target) == Some(target - step));
        assert!(halving(count + 3, step, target).is_some() && halving(count + 4, step, target).is_none());
    }

    /// The three last steps of M73 leave a half, a quarter and an eighth of a step, rounded.
    /// Of: `infeed::halving`
    /// Assumes: a target that is one step, of at most 8 for the model checker, of at most 2^37 for the property tests.
    /// Rules: E100L-TINF-02
    #[unwind(4)]
    fn a_step_is_halved_three_times() {
        let step = few(DEPTH);
        kani::cover!(step % 8 == 1, "a step that is rounded");
        for number in 1..=3 {
            let parts = 1 << number;
            let left = halving(number, step, step).map(|depth| parts * (step - depth) - step);
            assert!(left.is_some_and(|over| over.abs() <= parts / 2));
        }
    }

    /// The depths of M73 do not decrease.
    /// Of: `infeed::halving`
    /// Assumes: steps, targets and numbers of at most 8 for the model checker, of at most 2^37 for the property tests.
    /// Rules: E100L-TINF-02
    #[unwind(2)]
    fn halved_steps_go_deeper() {
        let (step, target, number) = (few(DEPTH), few(DEPTH), few(DEPTH));
        kani::assume(step <= target);
        let (depth, next) = (halving(number, step, target), halving(number + 1, step, target));
        kani::cover!(depth.is_some() && next > depth, "a deeper one");
        assert!(next.is_none() || depth.is_some() && depth <= next);
    }

    /// Steps of M74 are less than the target and do not overflow; a step behind one that is none is none either.
    /// Of: `infeed::steps`
    /// Assumes: any number of a pass, steps and targets of at most 2^37.
    /// Rules: E100L-TINF-03
    #[unwind(2)]
    fn steps_end_before_the_target() {
        let (step, target) = (between(1, DEPTH), between(1, DEPTH));
        let number = between(1, i64::MAX);
        let depth = steps(number, step, target);
        kani::cover!(depth.is_none() && number == i64::MAX, "the largest number");
        assert!(depth.is_none_or(|depth| depth < target));
        assert!(steps(1, step, target).is_some() == (step < target));
    }

    /// Each step of M74 is D deeper than the one before.
    /// Of: `infeed::steps`
    /// Assumes: steps and numbers of at most 8 for the model checker, of at most 2^18 for the property tests.
    /// Rules: E100L-TINF-03
    #[unwind(2)]
    fn steps_are_as_deep_as_d() {
        let (step, number, target) = (few(1 << 18), few(1 << 18), between(1, DEPTH));
        let (depth, next) = (steps(number, step, target), steps(number + 1, step, target));
        kani::cover!(next.is_some(), "two steps");
        assert!(next.is_none() || next == depth.map(|depth| depth + step));
        assert!(depth.is_some() == (number * step < target));
    }

    /// No area of M75 overflows or reaches that of the target.
    /// Of: `infeed::areas`, `infeed::square`
    /// Assumes: any number of a pass, steps and targets of at most 2^37.
    /// Rules: E100L-TINF-04, E100L-TINF-05
    #[unwind(2)]
    fn no_area_reaches_the_target() {
        let (step, target) = (between(1, DEPTH), between(1, DEPTH));
        let area = areas(between(1, i64::MAX), step, target);
        kani::cover!(area.is_some(), "an area");
        assert!(area.is_none_or(|area| area < square(target)));
    }

    /// The areas of M75 are multiples of the first one, as long as they are less than that of the target: the depth of the
    /// square number n² is n times D.
    /// Of: `infeed::areas`, `infeed::square`
    /// Assumes: numbers and depths of at most 8 for the model checker, numbers of at most 2^15 and depths of at most 2^20 for
    /// the property tests.
    /// Rules: E100L-TINF-04
    #[unwind(2)]
    fn areas_are_multiples() {
        let (step, times, target) = (few(1 << 20), few(1 << 15), few(1 << 30));
        let area = areas(times * times, step, target);
        kani::cover!(area.is_some() && times > 1, "a depth of several steps");
        assert!(area == (times * step < target).then_some(square(times * step)));
    }

    /// The number of balanced passes does not overflow; it is at least 1, and 1 where the first reaches the target.
    /// Of: `infeed::balanced_count`
    /// Assumes: depths of at most 2^37, any area.
    /// Rules: E100L-TINF-06, E100L-TINF-07
    #[unwind(2)]
    fn some_pass_is_balanced() {
        let (step, target, area) = (between(1, DEPTH), between(1, DEPTH), kani::any());
        let count = balanced_count(step, target, area);
        let left = square(target) - square(step);
        kani::cover!(left < 0, "a first pass that reaches the target");
        assert!(count >= 1 && (left > 0 && area > 0 || count == 1));
    }

    /// The balanced passes behind the first one remove at most an area each, and one pass fewer would have to remove more.
    /// Of: `infeed::balanced_count`
    /// Assumes: depths and areas of at most 8 for the model checker, depths of at most 2^37 and areas of at most 2^74 for the
    /// property tests; a step that is less than the target.
    /// Rules: E100L-TINF-06
    #[unwind(2)]
    fn balanced_passes_are_enough_and_no_more() {
        let (step, target, area) = (few(DEPTH), few(DEPTH), factor(1 << 74).abs());
        kani::assume(step < target && area > 0);
        let more = i128::from(balanced_count(step, target, area)) - 1;
        let rest = square(target) - square(step);
        kani::assume(more < 1 << 50);
        kani::cover!(more > 1, "more than two passes");
        assert!(more >= 1 && more * area >= rest && (more - 1) * area < rest);
    }

    /// Left and right flank lie on opposite sides, in either reading, and the readings are opposite.
    /// Of: `infeed::flank_sign`
    /// Assumes: nothing.
    /// Rules: E100L-TMOD-03
    #[unwind(2)]
    fn flanks_are_opposite() {
        let (left, reading) = (kani::any(), reading());
        let sign = flank_sign(left, reading);
        assert!(sign.abs() == 1 && flank_sign(!left, reading) == -sign);
        assert!(flank_sign(left, ThreadFlank::Negative) == -flank_sign(left, ThreadFlank::Positive));
        assert!(flank_sign(true, ThreadFlank::Negative) == -1);
    }

    /// By turns, the first pass is on the left flank and each on the other one than the pass before.
    /// Of: `infeed::is_left_by_turns`
    /// Assumes: any number but the largest.
    /// Rules: E100L-TMOD-04
    #[unwind(2)]
    fn flanks_take_turns() {
        let number: i64 = kani::any();
        kani::assume(number < i64::MAX);
        kani::cover!(number == 2, "the second pass");
        assert!(is_left_by_turns(1) && is_left_by_turns(number) != is_left_by_turns(number + 1));
    }

    /// Engine and oracle choose the flank alike.
    /// Of: `infeed::flank_sign`, `infeed::is_left_by_turns`, `integer::thread::shift_side`,
    /// `integer::thread::is_left_by_turns`
    /// Assumes: any number of a pass.
    /// Rules: E100L-TMOD-03, E100L-TMOD-04
    #[unwind(2)]
    fn both_choose_the_flank_alike() {
        let (number, reading): (u32, _) = (kani::any(), reading());
        let left = is_left_by_turns(number.into());
        kani::cover!(!left && reading == ThreadFlank::Positive, "an even number");
        assert!(left == oracle::is_left_by_turns(number));
        assert!(flank_sign(left, reading) == oracle::shift_side(left, reading));
    }

    /// At a right angle the shift is half of a diameter, rounded away from zero, or twice a length.
    /// Of: `infeed::right_angle_shift`
    /// Assumes: depths of 0 to 2^37 that are left.
    /// Rules: E100L-TMOD-02
    #[unwind(2)]
    fn a_right_angle_shifts_as_far_as_deep() {
        let rest = between(0, DEPTH);
        let half = right_angle_shift(rest, true);
        kani::cover!(rest % 2 == 1, "an odd number of nanometres");
        assert!(2 * half == rest + rest % 2 && right_angle_shift(rest, false) == 2 * rest);
    }
}

refutations! {
    /// False: the first depth of M73 is D.
    #[unwind(2)]
    fn the_first_depth_is_d() {
        let (step, target) = (few(8), few(8));
        kani::assume(step <= target);
        assert!(halving(1, step, target) == Some(step));
    }

    /// False: a balanced thread has one pass more than areas that fit.
    #[unwind(2)]
    fn passes_are_rounded_down() {
        let (step, target, area) = (few(8), few(8), i128::from(few(8)));
        kani::assume(step < target);
        let rest = square(target) - square(step);
        assert!(i128::from(balanced_count(step, target, area)) == 1 + rest / area);
    }

    /// False: half a right angle shifts as far along Z as along X.
    #[unwind(2)]
    fn the_axes_shift_alike() {
        let rest = between(0, DEPTH);
        assert!(right_angle_shift(rest, true) == right_angle_shift(rest, false));
    }
}
