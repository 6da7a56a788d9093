//! Theorems about what control flow counts: the steps of a run, and its modal calls.

use turnspec::engine::arithmetic::modes;
use turnspec::engine::arithmetic::steps::Steps;
use turnspec_oracle::integer;

use crate::draw::{between, one_of};
#[cfg(stand_in)]
use crate::kani;

/// The number of a mode that is or was active, or none.
fn mode() -> Option<u8> {
    let number = u8::try_from(between(1, 8)).unwrap_or(1);
    kani::any::<bool>().then_some(number)
}

fn active() -> usize {
    usize::try_from(between(0, 8)).unwrap_or(0)
}

theorems! {
    /// The count of steps never wraps: what is taken is taken off exactly, and what is not left changes nothing.
    /// Of: `Steps::take`, `Steps::left`
    /// Assumes: any number of steps.
    /// Rules: E100L-GOTO-03
    #[unwind(2)]
    fn no_count_of_steps_wraps() {
        let (most, count): (u64, u64) = (kani::any(), kani::any());
        let mut steps = Steps::new(most);
        let taken = steps.take(count);
        kani::cover!(!taken && steps.left() > 0, "some are left, but not enough");
        assert!(taken == (count <= most));
        assert!(if taken { steps.left() + count == most } else { steps.left() == most });
    }

    /// Blocks that were passed count at once as they count one by one.
    /// Of: `Steps::take`
    /// Assumes: any number of steps, at most 8 blocks.
    /// Rules: E100L-GOTO-03
    #[unwind(10)]
    fn passed_blocks_count_one_by_one() {
        let (most, count) = (kani::any(), kani::any::<u8>() >> 5);
        let (mut at_once, mut one_by_one) = (Steps::new(most), Steps::new(most));
        let mut all = true;
        for _ in 0..count {
            all &= one_by_one.take(1);
        }
        kani::cover!(all && count > 1 && one_by_one.left() == 0, "just enough");
        kani::cover!(!all && most > 0, "not enough");
        assert!(at_once.take(count.into()) == all);
        assert!(!all || at_once == one_by_one);
        assert!(all || one_by_one.left() == 0);
    }

    /// Engine and oracle let the same blocks begin: as long as one has steps left the other has made fewer than the
    /// most, and both go on in step.
    /// Of: `Steps::take`, `integer::steps::next`
    /// Assumes: any number of steps, any of them made.
    /// Rules: E100L-GOTO-03
    #[unwind(2)]
    fn both_count_steps_alike() {
        let (most, left): (u64, u64) = (kani::any(), kani::any());
        kani::assume(left <= most);
        let made = most - left;
        let mut steps = Steps::new(most);
        assert!(steps.take(made));
        let next = integer::steps::next(made, most);
        kani::cover!(next == Some(u64::MAX), "the last step that can be counted");
        kani::cover!(next.is_none() && most > 0, "no further step");
        assert!(steps.take(1) == next.is_some());
        assert!(steps.left() == most - next.unwrap_or(made));
    }

    /// Engine and oracle let a motion call the same modes.
    /// Of: `modes::to_call`, `integer::modes::last_to_call`
    /// Assumes: at most 8 active modes, within the call of any mode or of none.
    /// Rules: E100L-MODIN-06, E100L-MODIN-07, E100L-MODIN-08
    #[unwind(2)]
    fn both_call_the_same_modes() {
        let (active, inside) = (active(), mode());
        let called = modes::to_call(active, inside);
        kani::cover!(inside.is_none() && called == 8, "all modes");
        kani::cover!(inside == Some(1), "within the call of the first mode");
        assert!(usize::from(called) == integer::modes::last_to_call(active, inside.map(usize::from)));
    }

    /// Modal calls within modal calls come to an end: each calls modes before its own alone, the first one none.
    /// Of: `modes::to_call`
    /// Assumes: at most 8 active modes, within the call of any of them.
    /// Rules: E100L-MODIN-07, E100L-MODIN-08
    #[unwind(2)]
    fn modal_calls_do_not_call_themselves() {
        let (active, inside) = (active(), mode());
        let called = modes::to_call(active, inside);
        kani::cover!(inside.is_some_and(|mode| mode > 1), "one that calls others");
        assert!(inside.is_none_or(|mode| called < mode));
        assert!(usize::from(called) <= active || inside.is_some());
    }

    /// Each mode that begins has the next number, and there are no more than eight of them.
    /// Of: `modes::next`
    /// Assumes: any number of active modes.
    /// Rules: E100L-MODIN-05
    #[unwind(2)]
    fn modes_are_numbered_one_by_one() {
        let active = if kani::any() { active() } else { kani::any() };
        let number = usize::from(modes::next(active));
        kani::cover!(active == 7, "the last one");
        assert!(if active <= modes::MOST { number == active + 1 } else { number == modes::MOST + 1 });
    }
}

refutations! {
    /// False: there is a step for the block after the last one.
    #[unwind(2)]
    fn one_step_more_is_left() {
        let most = one_of(&[1, 2, u64::MAX]);
        let mut steps = Steps::new(most);
        assert!(steps.take(most) && steps.take(1));
    }
}
