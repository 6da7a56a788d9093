//! Theorems about how a motion in compensation ends: whether the offset elements meet, and after how many blocks
//! without X/Z motion nothing is waited for any more.

use std::cmp::Ordering;

use turnspec::engine::arithmetic::idle::IdleBlocks;
use turnspec::engine::arithmetic::meeting::Meeting;
use turnspec_oracle::integer;

use crate::draw::one_of;
#[cfg(stand_in)]
use crate::kani;

fn gap() -> Ordering {
    one_of(&[Ordering::Less, Ordering::Equal, Ordering::Greater])
}

fn idle_blocks() -> IdleBlocks {
    one_of(&[IdleBlocks::None, IdleBlocks::One, IdleBlocks::Many])
}

theorems! {
    /// Two offset elements have no common point exactly when a gap is negative; they touch exactly when none is
    /// negative and one is zero.
    /// Of: `Meeting::of`
    /// Assumes: three gaps of any sign.
    /// Rules: E100L-NRC-51, E100L-NRC-52, E100L-NRC-53
    #[unwind(5)]
    fn gaps_decide_how_elements_meet() {
        let gaps = [gap(), gap(), gap()];
        let apart = gaps.contains(&Ordering::Less);
        let touch = gaps.contains(&Ordering::Equal);
        kani::cover!(apart && touch, "one gap zero, another one negative");
        let expected = if touch { Meeting::Touching } else { Meeting::Crossing };
        assert!(Meeting::of(gaps) == (!apart).then_some(expected));
    }

    /// The order of the gaps does not matter, nor does a gap that is left out because it is positive.
    /// Of: `Meeting::of`
    /// Assumes: two and three gaps of any sign.
    /// Rules: E100L-NRC-51, E100L-NRC-52
    #[unwind(5)]
    fn the_order_of_gaps_does_not_matter() {
        let (first, second, third) = (gap(), gap(), gap());
        kani::cover!(first == Ordering::Equal && second == Ordering::Less, "zero, then negative");
        let meeting = Meeting::of([first, second, third]);
        assert!(meeting == Meeting::of([second, first, third]));
        assert!(meeting == Meeting::of([third, second, first]));
        assert!(Meeting::of([first, second]) == Meeting::of([first, Ordering::Greater, second]));
    }

    /// The first block without X/Z motion changes nothing, the second one leaves no motion waiting, and further ones
    /// change nothing again.
    /// Of: `IdleBlocks::more`
    /// Assumes: a motion that waits or none, any count.
    /// Rules: E100L-NRC-43, E100L-NRC-44
    #[unwind(4)]
    fn the_second_idle_block_ends_a_motion() {
        let (waits, before) = (kani::any(), idle_blocks());
        let one = before.more(waits);
        kani::cover!(waits && before == IdleBlocks::None, "the first block");
        kani::cover!(!waits, "none waits");
        assert!((one == IdleBlocks::One) == (waits && before == IdleBlocks::None));
        assert!(one.more(waits) == IdleBlocks::Many && one != IdleBlocks::None);
    }

    /// Engine and oracle let the same blocks without X/Z motion end a motion, and find the same ones between two
    /// elements.
    /// Of: `IdleBlocks::more`, `integer::between::is_too_long`
    /// Assumes: eight blocks, each with X/Z motion or without.
    /// Rules: E100L-NRC-43, E100L-NRC-44, E100L-NRC-46
    #[unwind(10)]
    fn both_count_idle_blocks_alike() {
        // The start-up waits.
        let (mut waits, mut blocks) = (true, IdleBlocks::None);
        let (mut oracle_waits, mut one_between) = (true, false);
        for _ in 0..8 {
            if kani::any() {
                (waits, blocks) = (true, IdleBlocks::None);
                (oracle_waits, one_between) = (true, false);
            } else {
                blocks = blocks.more(waits);
                waits = blocks == IdleBlocks::One;
                let too_long = integer::between::is_too_long(oracle_waits, one_between);
                (oracle_waits, one_between) = (!too_long, !too_long);
            }
            assert!(waits == oracle_waits && (blocks == IdleBlocks::One) == one_between);
        }
        kani::cover!(blocks == IdleBlocks::Many, "two blocks or more");
        kani::cover!(one_between, "one block between");
    }
}

refutations! {
    /// False: elements that have a common point cross.
    #[unwind(5)]
    fn elements_that_meet_cross() {
        assert!(Meeting::of([gap(), gap()]) != Some(Meeting::Touching));
    }

    /// False: every block without X/Z motion ends the motion that waits.
    #[unwind(4)]
    fn every_idle_block_ends_a_motion() {
        assert!(idle_blocks().more(kani::any()) == IdleBlocks::Many);
    }
}
