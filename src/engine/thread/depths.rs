//! The depths of the passes of a compound cycle, one after the other (E100L-TINF-02 to E100L-TINF-07, E100L-G71-07).
//!
//! Depths, heights and steps are whole nanometres of at most 2^37.

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::RuleId;
use turnspec_oracle::vocabulary::rule_ids as rules;

use crate::engine::arithmetic::round::Rounding;
use crate::engine::exact::{Formula, Real, SlowPaths, round, sign};
use crate::engine::planted::{self, Bug};

/// How the depths follow each other, up to the height less the allowance.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Sequence {
    /// Steps of D, the last of them divided.
    Halving,
    /// Steps of D.
    Steps,
    /// Steps of equal area.
    Areas {
        /// On both flanks.
        zigzag: bool,
    },
    /// So many depths, of which the second to the last remove equal areas.
    Balanced {
        /// How many.
        count: i64,
        /// On both flanks.
        zigzag: bool,
        /// The rule that says so.
        rule: RuleId,
    },
}

impl Sequence {
    /// Its rule.
    pub fn rule(self) -> RuleId {
        match self {
            Self::Halving => rules::TINF_02,
            Self::Steps => rules::TINF_03,
            Self::Areas { zigzag: false } => rules::TINF_04,
            Self::Areas { zigzag: true } => rules::TINF_05,
            Self::Balanced { rule, .. } => rule,
        }
    }

    /// Whether it is one that the reading `balanced_infeed` admits.
    pub fn is_balanced(self) -> bool {
        matches!(self, Self::Balanced { .. })
    }
}

/// The words D and H, and the height less the finishing allowance.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Heights {
    pub step: i64,
    pub height: i64,
    pub target: i64,
}

impl Heights {
    fn square(length: i64) -> i128 {
        i128::from(length) * i128::from(length)
    }

    /// H² − T², the area of the finishing pass.
    pub fn finishing_area(self) -> i128 {
        Self::square(self.height) - Self::square(self.target)
    }

    /// D², the area of the first pass.
    pub fn first_area(self) -> i128 {
        Self::square(self.step)
    }

    /// How many passes remove at most an area each, the first of them aside, until the target is reached.
    pub fn balanced_count(self, area: i128) -> i64 {
        let rest = Self::square(self.target) - self.first_area();
        if rest <= 0 || area <= 0 {
            return 1;
        }
        let rounding = if planted::is(Bug::BalancedCut) { Rounding::Cut } else { Rounding::Up };
        i64::try_from(rounding.divide(rest, area).max(1) + 1).unwrap_or(i64::MAX)
    }
}

/// (√first + √second) / 2.
struct Mean {
    first: Square,
    second: Square,
    less: i64,
}

/// A square as base + times · part / over.
#[derive(Clone, Copy)]
struct Square {
    base: i128,
    part: i128,
    times: i64,
    over: i64,
}

impl Square {
    fn whole(base: i128) -> Self {
        Self { base, part: 0, times: 0, over: 1 }
    }
}

impl Formula for Mean {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let root = |square: Square| {
            let part =
                integer(square.part).times(&integer(square.times.into())).over(&integer(square.over.into()));
            integer(square.base).plus(&part).root()
        };
        let sum = root(self.first).plus(&root(self.second));
        sum.over(&integer(2)).minus(&integer(self.less.into()))
    }
}

/// The depth of a pass.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Depth {
    /// Latched.
    pub depth: i64,
    /// From 1.
    pub number: i64,
    /// Whether it is that of the finishing pass.
    pub finishing: bool,
}

/// How far a cycle has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Stage {
    Pattern,
    Finishing,
    Done,
}

/// The depths of a cycle, computed as they are asked for.
#[derive(Clone, Copy, Debug)]
pub struct Depths {
    sequence: Sequence,
    heights: Heights,
    number: i64,
    stage: Stage,
}

impl Depths {
    /// From the first one on.
    pub fn new(sequence: Sequence, heights: Heights) -> Self {
        Self { sequence, heights, number: 0, stage: Stage::Pattern }
    }

    /// Whether there is no more.
    pub fn are_done(&self) -> bool {
        self.stage == Stage::Done
    }

    /// The next one.
    pub fn next(&mut self, slow: &mut SlowPaths) -> Option<Depth> {
        if self.stage == Stage::Done {
            return None;
        }
        self.number += 1;
        let finishing = self.stage == Stage::Finishing;
        let Heights { height, target, .. } = self.heights;
        let before = if finishing { None } else { self.before_target(slow) };
        if before.is_none() {
            let spring = planted::is(Bug::SpringPass) && target == height;
            let more = !finishing && (target != height || spring);
            self.stage = if more { Stage::Finishing } else { Stage::Done };
        }
        let depth = before.unwrap_or(if finishing { height } else { target });
        Some(Depth { depth, number: self.number, finishing })
    }

    /// The depth with the present number, if it comes before the target.
    fn before_target(&self, slow: &mut SlowPaths) -> Option<i64> {
        let Heights { step, target, .. } = self.heights;
        let number = self.number;
        match self.sequence {
            Sequence::Halving => self.halving(),
            Sequence::Steps => Some(number.saturating_mul(step)).filter(|depth| *depth < target),
            Sequence::Areas { zigzag } => self.equal_area(zigzag, slow),
            Sequence::Balanced { count, zigzag, .. } if number < count => {
                Some(round(&self.balanced(count, zigzag), slow))
            }
            Sequence::Balanced { .. } => None,
        }
    }

    /// Steps of D up to T − D, then T − D/2, T − D/4 and T − D/8 (E100L-TINF-02).
    fn halving(&self) -> Option<i64> {
        let Heights { step, target, .. } = self.heights;
        let before = target - step;
        let rest = before % step != 0 && !planted::is(Bug::RemainderLeft);
        let steps = before / step + i64::from(rest);
        match self.number - steps {
            ..=0 => Some((self.number * step).min(before)),
            parts @ 1..=3 => Some(Rounding::HalfAway.divide_narrow((target << parts) - step, 1 << parts)),
            _ => None,
        }
    }

    /// √n D; on both flanks the odd ones are the mean of √(n − 1) D and √(n + 1) D (E100L-TINF-04, E100L-TINF-05).
    fn equal_area(&self, zigzag: bool, slow: &mut SlowPaths) -> Option<i64> {
        let (number, target) = (i128::from(self.number), self.heights.target);
        let area = self.heights.first_area();
        let square = |number: i128| Square::whole(number * area);
        if zigzag && number % 2 != 0 {
            let mean = Mean { first: square(number - 1), second: square(number + 1), less: 0 };
            let reaches = sign(&Mean { less: target, ..mean }, slow) != Ordering::Less;
            return if reaches { None } else { Some(round(&mean, slow)) };
        }
        let reached = Heights::square(target);
        if number * area > reached || number * area == reached && !planted::is(Bug::TargetTwice) {
            return None;
        }
        Some(round(&Mean { first: square(number), second: square(number), less: 0 }, slow))
    }

    /// e(n), or the mean of its neighbours (E100L-TINF-06).
    fn balanced(&self, count: i64, zigzag: bool) -> Mean {
        let heights = self.heights;
        let square = |number: i64| {
            if number == 0 {
                return Square::whole(0);
            }
            let part = Heights::square(heights.target) - heights.first_area();
            Square { base: heights.first_area(), part, times: number - 1, over: count - 1 }
        };
        let number = self.number;
        let apart = i64::from(zigzag && number % 2 != 0);
        Mean { first: square(number - apart), second: square(number + apart), less: 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::{Depths, Heights, Sequence, rules};
    use crate::engine::exact::SlowPaths;

    fn all(sequence: Sequence, step: i64, target: i64, height: i64) -> Vec<i64> {
        let mut slow = SlowPaths::default();
        let mut depths = Depths::new(sequence, Heights { step, height, target });
        std::iter::from_fn(|| depths.next(&mut slow).map(|depth| depth.depth)).collect()
    }

    #[test]
    fn steps_are_halved_at_last() {
        assert_eq!(all(Sequence::Halving, 1500, 4000, 4000), [1500, 2500, 3250, 3625, 3813, 4000]);
        assert_eq!(all(Sequence::Halving, 1000, 3000, 3000), [1000, 2000, 2500, 2750, 2875, 3000]);
        assert_eq!(all(Sequence::Halving, 2000, 2000, 2100), [1000, 1500, 1750, 2000, 2100]);
    }

    #[test]
    fn steps_end_at_the_target() {
        assert_eq!(all(Sequence::Steps, 800, 1800, 2000), [800, 1600, 1800, 2000]);
        assert_eq!(all(Sequence::Steps, 5000, 2000, 2000), [2000]);
        assert_eq!(all(Sequence::Steps, 1000, 2000, 2000), [1000, 2000]);
    }

    #[test]
    fn areas_are_equal() {
        let one = Sequence::Areas { zigzag: false };
        assert_eq!(all(one, 10_000, 18_000, 20_000), [10_000, 14_142, 17_321, 18_000, 20_000]);
        assert_eq!(all(one, 3000, 4000, 5000), [3000, 4000, 5000]);
        let both = Sequence::Areas { zigzag: true };
        assert_eq!(all(both, 10_000, 20_000, 20_000), [7071, 14_142, 17_071, 20_000]);
    }

    #[test]
    fn areas_are_balanced() {
        let heights = Heights { step: 2000, height: 5000, target: 4000 };
        let count = heights.balanced_count(heights.finishing_area());
        assert_eq!(count, 3);
        let sequence = |zigzag| Sequence::Balanced { count, zigzag, rule: rules::TINF_06 };
        assert_eq!(all(sequence(false), 2000, 4000, 5000), [2000, 3162, 4000, 5000]);
        assert_eq!(all(sequence(true), 2000, 4000, 5000), [1581, 3162, 4000, 5000]);
    }
}
