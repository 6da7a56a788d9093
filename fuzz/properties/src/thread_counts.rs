//! How many passes the patterns of G71 and G72 make, on whole increments (E100L-TINF-02 to E100L-TINF-07).

use turnspec_oracle::vocabulary::{BalancedInfeed, Setup};

/// A pattern.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Pattern {
    /// M73.
    Halving,
    /// M74.
    Steps,
    /// M75.
    Areas,
}

impl Pattern {
    /// The M code.
    pub(crate) fn code(self) -> u16 {
        match self {
            Self::Halving => 73,
            Self::Steps => 74,
            Self::Areas => 75,
        }
    }
}

/// D, H and the finishing allowance in increments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Heights {
    pub(crate) step: i64,
    pub(crate) height: i64,
    pub(crate) allowance: i64,
}

/// A quotient of positive numbers rounded up.
fn up(numerator: i64, denominator: i64) -> i64 {
    (numerator + denominator - 1) / denominator
}

impl Heights {
    /// The depths, the finishing pass counted; none where the control refuses the pattern.
    pub(crate) fn passes(self, pattern: Pattern, by_turns: bool, setup: &Setup) -> Option<i64> {
        let target = self.height - self.allowance;
        let (area, reached) = (self.step * self.step, target * target);
        let rest = self.height * self.height - reached;
        let in_pattern = match pattern {
            Pattern::Halving if target < self.step => return None,
            Pattern::Halving => up(target - self.step, self.step) + 4,
            Pattern::Steps => up(target, self.step),
            Pattern::Areas if setup.parameters.m75_pattern == 3 && area >= rest => {
                if by_turns {
                    (1..).find(|number| !self.is_before(*number, target)).unwrap_or(1)
                } else {
                    up(reached, area)
                }
            }
            Pattern::Areas if setup.readings.balanced_infeed == BalancedInfeed::Refused => return None,
            Pattern::Areas if target <= self.step => 1,
            Pattern::Areas => {
                let area_of_a_pass = if setup.parameters.m75_pattern == 3 { rest } else { rest.max(area) };
                1 + up(reached - area, area_of_a_pass)
            }
        };
        Some(in_pattern + i64::from(self.allowance > 0))
    }

    /// Whether the n-th depth by turns lies before the target: √n·D for even n, (√(n + 1) + √(n − 1))·D/2 for odd n.
    /// The square of twice the latter over D is 2n + 2√(n² − 1).
    fn is_before(self, number: i64, target: i64) -> bool {
        let (n, area, target) = (i128::from(number), i128::from(self.step).pow(2), i128::from(target));
        if n % 2 == 0 {
            return n * area < target * target;
        }
        let room = 2 * target * target - n * area;
        room > 0 && (n * n - 1) * area * area < room * room
    }

    /// What the number of depths cannot exceed: 5 + max(r, r²) + H/(2U) with r = H/D, without the last term when U is zero;
    /// each quotient rounded up.
    pub(crate) fn most_passes(self) -> i64 {
        let ratio = up(self.height, self.step).max(up(self.height * self.height, self.step * self.step));
        let allowance = if self.allowance > 0 { up(self.height, 2 * self.allowance) } else { 0 };
        5 + ratio + allowance
    }
}

#[cfg(test)]
mod tests {
    use super::{Heights, Pattern};
    use turnspec_oracle::vocabulary::{BalancedInfeed, Setup};

    fn passes(step: i64, height: i64, allowance: i64, pattern: Pattern, by_turns: bool) -> Option<i64> {
        Heights { step, height, allowance }.passes(pattern, by_turns, &Setup::default())
    }

    /// The examples of the rules.
    #[test]
    fn the_numbers_of_passes_are_those_of_the_examples() {
        assert_eq!(passes(1_500, 4_000, 0, Pattern::Halving, false), Some(6));
        assert_eq!(passes(1_000, 3_000, 0, Pattern::Halving, false), Some(6));
        assert_eq!(passes(3_000, 2_000, 0, Pattern::Halving, false), None);
        assert_eq!(passes(800, 2_000, 200, Pattern::Steps, false), Some(4));
        assert_eq!(passes(5_000, 2_000, 0, Pattern::Steps, false), Some(1));
        assert_eq!(passes(1_000, 2_000, 200, Pattern::Areas, false), Some(5));
        assert_eq!(passes(3_000, 5_000, 1_000, Pattern::Areas, false), Some(3));
        assert_eq!(passes(2_999, 5_000, 1_000, Pattern::Areas, false), None);
        assert_eq!(passes(1_000, 2_000, 0, Pattern::Areas, true), Some(4));
        let mut setup = Setup::default();
        setup.readings.balanced_infeed = BalancedInfeed::EqualArea;
        let heights = Heights { step: 2_000, height: 5_000, allowance: 1_000 };
        assert_eq!(heights.passes(Pattern::Areas, false, &setup), Some(4));
        setup.parameters.m75_pattern = 4;
        let heights = Heights { step: 1_000, height: 2_000, allowance: 0 };
        assert_eq!(heights.passes(Pattern::Areas, false, &setup), Some(4));
    }

    #[test]
    fn an_increment_changes_the_number_at_a_threshold_only() {
        assert_eq!(passes(1_000, 3_000, 0, Pattern::Steps, false), Some(3));
        assert_eq!(passes(999, 3_000, 0, Pattern::Steps, false), Some(4));
        assert_eq!(passes(1_001, 3_000, 0, Pattern::Steps, false), Some(3));
    }

    #[test]
    fn the_bound_is_kept() {
        for step in 1..60 {
            for allowance in 0..50 {
                for pattern in [Pattern::Halving, Pattern::Steps, Pattern::Areas] {
                    for parameter in [3, 4] {
                        let mut setup = Setup::default();
                        setup.readings.balanced_infeed = BalancedInfeed::EqualArea;
                        setup.parameters.m75_pattern = parameter;
                        let heights = Heights { step, height: 50, allowance };
                        let count = heights.passes(pattern, true, &setup).unwrap_or_default();
                        assert!(count <= heights.most_passes(), "{heights:?}: {count}");
                    }
                }
            }
        }
    }
}
