//! Theorems about angles of the C axis.

use turnspec::engine::arithmetic::turn::{TURN, share, shift, travel, within};
use turnspec_oracle::integer::turn as oracle;

use crate::draw::{between, factor};
#[cfg(stand_in)]
use crate::kani;

/// An angle within a turn.
fn angle() -> i64 {
    between(0, TURN - 1)
}

/// An angle up to four turns away.
fn near_angle() -> i64 {
    between(-4 * TURN, 4 * TURN)
}

/// Whether an amount is a whole number of turns, at most eight.
fn is_whole_turns(amount: i64) -> bool {
    (-8..=8).any(|turns| amount == turns * TURN)
}

theorems! {
    /// Any angle comes to lie from zero to below a full turn.
    /// Of: `turn::within`
    /// Assumes: any angle.
    /// Rules: E100L-CAX-05
    #[unwind(2)]
    fn an_angle_lies_within_a_turn() {
        let angle: i64 = kani::any();
        kani::cover!(angle < 0, "a negative angle");
        assert!((0..TURN).contains(&within(angle)));
    }

    /// Only whole turns are taken off an angle; one within a turn is kept.
    /// Of: `turn::within`
    /// Assumes: angles of at most four turns.
    /// Rules: E100L-CAX-05
    #[unwind(20)]
    fn only_whole_turns_are_taken_off() {
        let angle = near_angle();
        kani::cover!(angle < -TURN, "more than a turn back");
        assert!(is_whole_turns(angle - within(angle)));
        assert!(within(angle) == angle || !(0..TURN).contains(&angle));
    }

    /// A zero shift of C loses its whole turns and keeps its sign.
    /// Of: `turn::shift`
    /// Assumes: any shift; that only whole turns are lost, up to four turns.
    /// Rules: E100L-G50-04
    #[unwind(20)]
    fn a_shift_keeps_its_sign() {
        let any: i64 = kani::any();
        let kept = shift(any);
        kani::cover!(any < 0 && kept != 0, "a negative shift");
        assert!(-TURN < kept && kept < TURN && (kept == 0 || (kept < 0) == (any < 0)));
        let near = near_angle();
        assert!(is_whole_turns(near - shift(near)));
    }

    /// The way in the positive direction is not negative, that in the negative direction not positive; each is
    /// shorter than a turn but for the turns that are commanded.
    /// Of: `turn::travel`
    /// Assumes: angles within a turn, at most 1999 turns.
    /// Rules: E100L-CAX-05, E100L-CAX-06
    #[unwind(2)]
    fn the_direction_is_kept() {
        let (present, target, turns) = (angle(), angle(), between(0, 1999));
        kani::cover!(turns == 1999 && target < present, "across zero, with all turns");
        let (forward, back) = (travel(present, target, turns, false), travel(present, target, turns, true));
        assert!(turns * TURN <= forward && forward < (turns + 1) * TURN);
        assert!(-(turns + 1) * TURN < back && back <= -turns * TURN);
    }

    /// The way in the positive direction leads to the target: it is the difference, or a turn more.
    /// Of: `turn::travel`
    /// Assumes: angles within a turn, no further turns.
    /// Rules: E100L-CAX-05
    #[unwind(2)]
    fn the_way_forward_leads_to_the_target() {
        let (present, target) = (angle(), angle());
        let difference = target - present;
        kani::cover!(difference < 0, "across zero");
        let way = if difference < 0 { difference + TURN } else { difference };
        assert!(travel(present, target, 0, false) == way);
    }

    /// The way in the negative direction leads to the target: it is the difference, or a turn less.
    /// Of: `turn::travel`
    /// Assumes: angles within a turn, no further turns.
    /// Rules: E100L-CAX-05
    #[unwind(2)]
    fn the_way_back_leads_to_the_target() {
        let (present, target) = (angle(), angle());
        let difference = target - present;
        kani::cover!(difference > 0, "back across zero");
        let way = if difference > 0 { difference - TURN } else { difference };
        assert!(travel(present, target, 0, true) == way);
    }

    /// The two directions together make a full turn, unless there is no way to go.
    /// Of: `turn::travel`
    /// Assumes: angles within a turn, no further turns.
    /// Rules: E100L-CAX-05
    #[unwind(2)]
    fn both_directions_make_a_turn() {
        let (present, target) = (angle(), angle());
        let (forward, back) = (travel(present, target, 0, false), travel(present, target, 0, true));
        kani::cover!(present == target, "no way to go");
        assert!(forward - back == if present == target { 0 } else { TURN });
    }

    /// No start of a thread is a full turn away, and the first is where the spindle stands.
    /// Of: `turn::share`
    /// Assumes: at most 8 starts for the model checker, at most 9999 for the property tests.
    /// Rules: E100L-TMUL-01
    #[unwind(2)]
    fn a_start_is_less_than_a_turn_away() {
        let starts = i64::try_from(factor(9999).abs()).unwrap_or(1);
        kani::assume(starts > 0);
        let number = between(0, starts - 1);
        let share = share(number, starts);
        kani::cover!(number > 1, "the third start");
        assert!((0..TURN).contains(&share) && (share == 0) == (number == 0));
    }

    /// The starts of a thread are even shares of a turn, each rounded.
    /// Of: `turn::share`
    /// Assumes: at most 8 starts for the model checker, at most 9999 for the property tests.
    /// Rules: E100L-TMUL-01
    #[unwind(2)]
    fn starts_are_even_shares() {
        let starts = i64::try_from(factor(9999).abs()).unwrap_or(1);
        kani::assume(starts > 0);
        let number = between(0, starts - 1);
        let over = share(number, starts) * starts - number * TURN;
        kani::cover!(over != 0, "a share that is rounded");
        assert!(2 * over.abs() <= starts);
    }

    /// Engine and oracle bring angles into a turn alike.
    /// Of: `turn::within`, `turn::shift`, `integer::turn::within`, `integer::turn::shift`
    /// Assumes: angles of at most four turns.
    /// Rules: E100L-CAX-05, E100L-G50-04
    #[unwind(2)]
    fn both_bring_angles_into_a_turn_alike() {
        let angle = near_angle();
        kani::cover!(angle < -TURN, "more than a turn back");
        assert!(oracle::within(angle) == within(angle) && oracle::shift(angle) == shift(angle));
    }

    /// Engine and oracle turn alike.
    /// Of: `turn::travel`, `integer::turn::travel`
    /// Assumes: angles within a turn, at most 1999 turns.
    /// Rules: E100L-CAX-05, E100L-CAX-06
    #[unwind(2)]
    fn both_turn_alike() {
        let (present, target, turns, negative) = (angle(), angle(), between(0, 1999), kani::any());
        kani::cover!(negative && turns > 0, "turns back");
        assert!(oracle::travel(present, target, turns, !negative) == travel(present, target, turns, negative));
    }
}

refutations! {
    /// False: the axis goes the shorter way.
    #[unwind(2)]
    fn the_axis_goes_the_shorter_way() {
        assert!(travel(angle(), angle(), 0, kani::any()).abs() <= TURN / 2);
    }

    /// False: the starts of a thread make up a turn exactly.
    #[unwind(2)]
    fn shares_are_exact() {
        let starts = between(1, 8);
        assert!(share(1, starts) * starts == TURN);
    }

    /// False: a zero shift is an angle within a turn.
    #[unwind(2)]
    fn a_shift_is_an_angle() {
        let any = near_angle();
        assert!(shift(any) == within(any));
    }
}
