//! Theorems about the amounts of grooving, drilling and tapping cycles.

use turnspec::engine::arithmetic::drilling::{
    at_depth, at_part, equal_steps, helix_feed, helix_turn, hole_angle, next_depth, relieved, tap_lead,
};
use turnspec::engine::arithmetic::turn::TURN;

use crate::draw::{between, factor, within};
#[cfg(stand_in)]
use crate::kani;

/// Coordinates and depths, and words.
const FAR: i64 = 1 << 60;
const WORD: i64 = 1 << 38;

/// From 1: at most 8 for the model checker.
fn few(most: i64) -> i64 {
    let value = i64::try_from(factor(most.into()).abs()).unwrap_or(1);
    kani::assume(value > 0);
    value
}

fn direction() -> i64 {
    if kani::any() { 1 } else { -1 }
}

theorems! {
    /// A peck goes deeper, by a step at most, and never beyond the bottom; one that is no whole step ends there.
    /// Of: `drilling::next_depth`
    /// Assumes: depths of at most 2^60, steps of at most 2^38.
    /// Rules: E100L-GRV-04, E100L-G183-01
    #[unwind(2)]
    fn no_peck_passes_the_bottom() {
        let depth = between(1, FAR);
        let (done, step) = (between(0, depth - 1), between(1, WORD));
        let next = next_depth(done, step, depth);
        kani::cover!(next == depth && next - done < step, "a last peck that is less than a step");
        kani::cover!(next < depth, "a peck before the last one");
        assert!(done < next && next <= depth && next - done <= step);
        assert!(next == depth || next - done == step);
    }

    /// As many pecks reach the bottom as there are equal steps to it.
    /// Of: `drilling::next_depth`, `drilling::equal_steps`
    /// Assumes: depths and steps of at most 8 for the model checker, of at most 2^10 and at most 16 steps for the property tests.
    /// Rules: E100L-GRV-04, E100L-G190-05, E100L-G190-06
    #[unwind(18)]
    fn pecks_are_as_few_as_equal_steps() {
        let (depth, step) = (few(1 << 10), few(1 << 10));
        kani::assume(depth <= 16 * step);
        let (mut done, mut pecks) = (0, 0);
        while done < depth && pecks < 17 {
            done = next_depth(done, step, depth);
            pecks += 1;
        }
        kani::cover!(depth % step != 0, "a remainder");
        kani::cover!(pecks > 2, "several pecks");
        assert!(done == depth && pecks == equal_steps(depth, step));
    }

    /// A tool goes back by the amount, and never above the beginning of the cut.
    /// Of: `drilling::relieved`
    /// Assumes: depths of 0 to 2^60, any amount that is not negative.
    /// Rules: E100L-GRV-04, E100L-G183-01
    #[unwind(2)]
    fn a_relieved_tool_stays_in_the_hole() {
        let (depth, amount) = (between(0, FAR), between(0, i64::MAX));
        let back = relieved(depth, amount);
        kani::cover!(amount > depth, "more than the depth");
        kani::cover!(back > 0, "less than the depth");
        assert!(0 <= back && back <= depth && (back == 0 || depth - back == amount));
    }

    /// A depth lies so far from its level, in its direction, and no coordinate saturates.
    /// Of: `drilling::at_depth`
    /// Assumes: levels of at most 2^60 in size, depths of 0 to 2^60.
    /// Rules: E100L-GRV-03, E100L-MCYC-05
    #[unwind(2)]
    fn a_depth_lies_in_its_direction() {
        let (level, depth, direction) = (within(FAR), between(0, FAR), direction());
        kani::cover!(direction < 0 && depth > 0, "downwards");
        assert!((at_depth(level, direction, depth) - level) * direction == depth);
    }

    /// The whole of a depth, and none of it, are exact; what is less than the relief stays on the level.
    /// Of: `drilling::at_part`
    /// Assumes: levels, depths and parts of at most 8 for the model checker, of at most 2^60, 2^60 and 2^20 for the property tests.
    /// Rules: E100L-G190-03, E100L-G190-06
    #[unwind(2)]
    fn the_last_part_is_the_depth() {
        let level = i64::try_from(factor(FAR.into())).unwrap_or(0);
        let (depth, parts, direction) = (few(FAR), few(1 << 20), direction());
        kani::cover!(parts > 1, "several parts");
        assert!(at_part(level, direction, (depth, parts, parts), 0) == at_depth(level, direction, depth));
        assert!(at_part(level, direction, (depth, 0, parts), 0) == level);
        assert!(at_part(level, direction, (depth, 1, parts), depth) == level);
    }

    /// The first hole has the angle of the block, and holes the other way round lie opposite.
    /// Of: `drilling::hole_angle`
    /// Assumes: angles and holes of at most 8 for the model checker, angles within a turn and at most 9999 holes for the property
    /// tests.
    /// Rules: E100L-MCYC-20
    #[unwind(2)]
    fn holes_go_round_either_way() {
        let first = i64::try_from(factor(i128::from(TURN) - 1)).unwrap_or(0);
        let count = few(9_999);
        let number = between(0, 9_998);
        kani::assume(number < count);
        kani::cover!(number > 0, "a further hole");
        assert!(hole_angle(first, 0, count, false) == first && hole_angle(first, 0, count, true) == first);
        assert!(hole_angle(0, number, count, true) == -hole_angle(0, number, count, false));
    }

    /// Without a divisor the lead per revolution is the feed, and at one revolution a minute the feed per minute.
    /// Of: `drilling::tap_lead`, `drilling::helix_feed`
    /// Assumes: feeds of 0 to 2^60.
    /// Rules: E100L-STAP-01, E100L-CTHR-01
    #[unwind(2)]
    fn a_lead_is_a_feed_at_one_revolution() {
        let feed = between(0, FAR);
        kani::cover!(feed > 0, "a feed");
        assert!(tap_lead(feed, 1, None) == feed && tap_lead(feed, 0, None) == feed);
        assert!(tap_lead(feed, 1, Some(1_000)) == feed && helix_feed(feed, 1_000) == feed);
    }

    /// A way of one lead is one turn of the C axis.
    /// Of: `drilling::helix_turn`
    /// Assumes: leads of at most 8 for the model checker, of at most 2^38 nanometres for the property tests.
    /// Rules: E100L-CTHR-01
    #[unwind(2)]
    fn a_lead_is_a_turn() {
        let lead = few(WORD);
        kani::cover!(lead > 1, "any lead");
        assert!(helix_turn(2 * i128::from(lead), 1_000 * lead) == TURN);
        assert!(helix_turn(0, lead) == 0);
    }
}

refutations! {
    /// False: the last peck is a whole step.
    #[unwind(2)]
    fn every_peck_is_a_step() {
        let depth = between(1, FAR);
        let (done, step) = (between(0, depth - 1), between(1, WORD));
        assert!(next_depth(done, step, depth) - done == step);
    }

    /// False: a tool goes back by the whole amount.
    #[unwind(2)]
    fn a_relief_is_the_amount() {
        let (depth, amount) = (between(0, FAR), between(0, FAR));
        assert!(depth - relieved(depth, amount) == amount);
    }

    /// False: holes are whole micro-degrees apart.
    #[unwind(2)]
    fn holes_are_evenly_spread() {
        let count = few(9_999);
        assert!(hole_angle(0, 1, count, false) * count == TURN);
    }
}
