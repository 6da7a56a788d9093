//! Theorems about travel limits and coordinate ranges.

use turnspec::engine::arithmetic::limit::{Limited, in_range, limited};
use turnspec_oracle::integer::{Limited as OracleLimited, TravelLimit};

use crate::draw::perhaps;
#[cfg(stand_in)]
use crate::kani;

/// Limits, set or not.
fn limits() -> (Option<i64>, Option<i64>) {
    (perhaps(kani::any()), perhaps(kani::any()))
}

theorems! {
    /// A target is refused exactly when it lies below the negative limit, and replaced exactly when it lies above
    /// the positive one and is not refused.
    /// Of: `limit::limited`
    /// Assumes: any target, any limits.
    /// Rules: E100L-LIM-01, E100L-LIM-02
    #[unwind(2)]
    fn limits_decide() {
        let (target, (negative, positive)) = (kani::any(), limits());
        let below = negative.is_some_and(|limit| target < limit);
        let above = positive.is_some_and(|limit| target > limit);
        kani::cover!(below && above, "limits the wrong way round");
        kani::cover!(target == i64::MIN, "the least target");
        match limited(target, negative, positive) {
            Limited::BelowNegative => assert!(below),
            Limited::AbovePositive(limit) => assert!(above && !below && positive == Some(limit)),
            Limited::Within => assert!(!above && !below),
        }
    }

    /// A target that a limit has replaced is not replaced again.
    /// Of: `limit::limited`
    /// Assumes: any target, any limits.
    /// Rules: E100L-LIM-01
    #[unwind(2)]
    fn a_replaced_target_stays() {
        let (target, (negative, positive)) = (kani::any(), limits());
        if let Limited::AbovePositive(limit) = limited(target, negative, positive) {
            kani::cover!(negative.is_some(), "both limits");
            assert!(!matches!(limited(limit, negative, positive), Limited::AbovePositive(_)));
            assert!(limit < target);
        }
    }

    /// Without limits every target is allowed; the limits themselves are allowed where they are in order.
    /// Of: `limit::limited`
    /// Assumes: any target, any limits.
    /// Rules: E100L-LIM-01, E100L-LIM-02
    #[unwind(2)]
    fn limits_themselves_are_allowed() {
        let (low, high): (i64, i64) = (kani::any(), kani::any());
        kani::assume(low <= high);
        kani::cover!(low == high, "no room");
        assert!(limited(low, Some(low), Some(high)) == Limited::Within);
        assert!(limited(high, Some(low), Some(high)) == Limited::Within);
        assert!(limited(kani::any(), None, None) == Limited::Within);
    }

    /// Engine and oracle limit alike.
    /// Of: `limit::limited`, `TravelLimit::of`
    /// Assumes: any target, any limits.
    /// Rules: E100L-LIM-01, E100L-LIM-02
    #[unwind(2)]
    fn both_limit_alike() {
        let (target, (negative, positive)) = (kani::any(), limits());
        let engine = match limited(target, negative, positive) {
            Limited::Within => OracleLimited::Allowed,
            Limited::AbovePositive(limit) => OracleLimited::Positive(limit),
            Limited::BelowNegative => OracleLimited::Negative,
        };
        kani::cover!(engine == OracleLimited::Negative, "below");
        kani::cover!(engine == OracleLimited::Allowed && positive.is_some(), "within");
        assert!(TravelLimit { positive, negative }.of(target) == engine);
    }

    /// A coordinate is in range exactly when it lies between the largest length and its opposite, whatever it is.
    /// Of: `limit::in_range`
    /// Assumes: any coordinate, a largest length that is not negative.
    /// Rules: E100L-ADDR-01
    #[unwind(2)]
    fn a_range_is_symmetrical() {
        let (coordinate, longest): (i64, i64) = (kani::any(), kani::any());
        kani::assume(longest >= 0);
        kani::cover!(coordinate == i64::MIN, "the least coordinate");
        kani::cover!(coordinate == -longest && longest > 0, "the end of the range");
        assert!(in_range(coordinate, longest) == (-longest <= coordinate && coordinate <= longest));
    }
}

refutations! {
    /// False: a replaced target lies within both limits.
    #[unwind(2)]
    fn a_replaced_target_is_within_the_limits() {
        let (target, (negative, positive)) = (kani::any(), limits());
        if let Limited::AbovePositive(limit) = limited(target, negative, positive) {
            assert!(limited(limit, negative, positive) == Limited::Within);
        }
    }
}
