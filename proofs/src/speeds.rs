//! Theorems about spindle speeds.

use turnspec::engine::arithmetic::speed::{SpeedChoice, surface, thousandths};
use turnspec::engine::arithmetic::units::Units;
use turnspec_oracle::vocabulary::SpeedLimit;

use crate::draw::{between, one_of, perhaps};
#[cfg(stand_in)]
use crate::kani;
use crate::units::SYSTEMS;

/// Largest number of an S word.
const MOST: i64 = 65_535;

fn choice() -> SpeedChoice {
    let limits = [None, Some(SpeedLimit::GearMinimum), Some(SpeedLimit::GearMaximum)];
    SpeedChoice { value: kani::any(), limit: one_of(&limits) }
}

theorems! {
    /// A clamped speed is the smaller one of the speed and the clamp.
    /// Of: `SpeedChoice::clamped`
    /// Assumes: any speed, any clamp.
    /// Rules: E100L-SMAX-01, E100L-SMAX-02
    #[unwind(4)]
    fn a_clamped_speed_is_the_smaller_one() {
        let (choice, clamp) = (choice(), kani::any::<i64>());
        kani::cover!(choice.value > clamp, "the clamp acts");
        kani::cover!(choice.value < clamp, "the clamp does not act");
        assert!(choice.clamped(Some(clamp)).value == choice.value.min(clamp));
    }

    /// The clamp is named as the limit exactly when it acts; else the limit stays what it was.
    /// Of: `SpeedChoice::clamped`
    /// Assumes: any speed, any clamp or none.
    /// Rules: E100L-SMAX-01, E100L-CSS-04
    #[unwind(4)]
    fn a_clamp_that_acts_is_named() {
        let (choice, clamp) = (choice(), perhaps(kani::any()));
        let acts = clamp.is_some_and(|clamp| choice.value > clamp);
        kani::cover!(acts && choice.limit.is_some(), "after a gear limit");
        kani::cover!(clamp.is_none(), "no clamp");
        let limit = if acts { Some(SpeedLimit::Clamp) } else { choice.limit };
        assert!(choice.clamped(clamp).limit == limit);
    }

    /// Clamping again changes nothing, and of two clamps the order does not matter to the speed.
    /// Of: `SpeedChoice::clamped`
    /// Assumes: any speed, any clamps or none.
    /// Rules: E100L-SMAX-01
    #[unwind(4)]
    fn clamps_commute() {
        let (choice, one, other) = (choice(), perhaps(kani::any()), perhaps(kani::any()));
        kani::cover!(one.is_some() && other.is_some() && one != other, "two clamps");
        assert!(choice.clamped(one).clamped(one) == choice.clamped(one));
        assert!(choice.clamped(one).clamped(other).value == choice.clamped(other).clamped(one).value);
    }

    /// Every S and SB word is a speed within 64 bits, whole revolutions, and a faster word is a faster speed.
    /// Of: `speed::thousandths`
    /// Assumes: words of at most 65 535.
    /// Rules: E100L-SPD-01, E100L-SB-01, E100L-CSS-02
    #[unwind(4)]
    fn speeds_keep_the_order_of_their_words() {
        let (one, other) = (between(0, MOST), between(0, MOST));
        kani::cover!(one < other, "a faster word");
        assert!(thousandths(one).cmp(&thousandths(other)) == one.cmp(&other));
        assert!(thousandths(one) >= one && thousandths(one) <= 65_535_000);
    }

    /// Every S word of G96 is a cutting speed within 64 bits, and so is a millionfold of it, which the speed is
    /// computed from.
    /// Of: `speed::surface`, `Units::new`
    /// Assumes: words of at most 65 535.
    /// Rules: E100L-CSS-01
    #[unwind(11)]
    fn cutting_speeds_fit() {
        let (number, unit) = (between(0, MOST), Units::new(one_of(&SYSTEMS)).surface);
        let speed = surface(number, unit);
        kani::cover!(number == MOST && unit == 1_000_000, "the fastest");
        assert!((speed == 0) == (number == 0) && speed >= 0);
        assert!(speed.checked_mul(1_000_000).is_some());
    }
}

refutations! {
    /// False: with a clamp the clamp is the limit.
    #[unwind(4)]
    fn a_clamp_always_acts() {
        assert!(choice().clamped(Some(kani::any())).limit == Some(SpeedLimit::Clamp));
    }
}
