//! How deep the passes of a compound cycle go (E100L-TINF-01 to -08).
//!
//! D is the depth of the first pass, H the height of the thread, T what the pattern has to reach: the height without the
//! finishing allowance. All are nanometres, of X diameters.

use super::flank::Flanks;
use super::lead::sign;
use super::motion::Cited;
use crate::fault::{Fault, Outcome};
use crate::quantity::{Exact, narrow, ratio, round_narrow, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, BalancedInfeed, RuleId};

/// The depths of a cycle, one after the other.
#[derive(Clone, Debug)]
pub struct Infeed {
    pattern: Pattern,
    first: i64,
    height: i64,
    target: i64,
    /// How many depths have come.
    count: u64,
    /// Whether the pattern has reached what it has to.
    reached: bool,
}

/// A depth that is cut.
#[derive(Clone, Copy, Debug)]
pub struct Depth {
    /// How deep it is.
    pub value: i64,
    /// Whether it is that of the finishing pass (E100L-G71-07).
    pub finishing: bool,
    /// Whether it is the last one.
    pub last: bool,
}

/// How the depths follow each other (E100L-TINF-01).
#[derive(Clone, Debug)]
enum Pattern {
    /// M73: D, then D/2, D/4, D/8, D/8 (E100L-TINF-02).
    Halving,
    /// M74 (E100L-TINF-03).
    Steps,
    /// M75 on one flank (E100L-TINF-04).
    Areas,
    /// M75 by turns (E100L-TINF-05).
    AreasByTurns,
    /// M75 where the manual has no formula (E100L-TINF-06, E100L-TINF-07).
    Balanced {
        by_turns: bool,
        /// N: how many depths the pattern has.
        count: u64,
        rule: RuleId,
    },
}

impl Infeed {
    /// The depths of D, H and T, by the M codes in force.
    pub fn new(first: i64, height: i64, target: i64, flanks: Flanks, state: &State) -> Outcome<Self> {
        let pattern = match state.active("thread_pattern") {
            Some(74) => Pattern::Steps,
            Some(75) => areas(first, height, target, flanks, state)?,
            _ => Pattern::Halving,
        };
        Ok(Self { pattern, first, height, target, count: 0, reached: false })
    }

    /// What the passes name that the pattern makes.
    pub fn cited(&self, state: &State) -> Cited {
        let (rule, balanced): (RuleId, bool) = match self.pattern {
            Pattern::Halving => (TINF_02, false),
            Pattern::Steps => (TINF_03, false),
            Pattern::Areas => (TINF_04, false),
            Pattern::AreasByTurns => (TINF_05, false),
            Pattern::Balanced { rule, .. } => (rule, true),
        };
        let reading = Cited::default().reading(state.setup.readings.balanced_infeed);
        Cited::rules(&[TINF_01, rule]).and_if(balanced, reading)
    }

    /// The next depth; behind the last one it stays.
    pub fn next(&mut self) -> Depth {
        if self.reached {
            return Depth { value: self.height, finishing: self.height != self.target, last: true };
        }
        self.count += 1;
        let below = self.below(self.count);
        self.reached = below.is_none();
        Depth {
            value: below.unwrap_or(self.target),
            finishing: false,
            last: self.reached && self.height == self.target,
        }
    }

    /// The depth of a number if it is less than T, latched.
    fn below(&self, number: u64) -> Option<i64> {
        let (first, target) = (whole(self.first), whole(self.target));
        match self.pattern {
            Pattern::Halving => halving(&first, &target, number),
            Pattern::Steps => {
                let depth = first * whole(number);
                (depth < target).then(|| round_narrow(&depth))
            }
            Pattern::Areas => root_below(&(&first * &first * whole(number)), &target),
            Pattern::AreasByTurns if number.is_multiple_of(2) => {
                root_below(&(&first * &first * whole(number)), &target)
            }
            Pattern::AreasByTurns => {
                let square = &first * &first;
                mean_below(&(&square * whole(number - 1)), &(&square * whole(number + 1)), &target)
            }
            Pattern::Balanced { count, .. } if number >= count => None,
            Pattern::Balanced { by_turns, count, .. } => {
                let square = |number| balanced_square(&first, &target, number, count);
                Some(if by_turns && number % 2 == 1 {
                    latched_mean(&square(number - 1), &square(number + 1))
                } else {
                    latched_root(&square(number))
                })
            }
        }
    }
}

/// E100L-TINF-02: steps of D up to T - D, then the rest in parts of D.
fn halving(first: &Exact, target: &Exact, number: u64) -> Option<i64> {
    let until = target - first;
    let steps = (&until / first).ceil();
    let step = whole(number);
    let behind = &step - whole(steps);
    let depth = if behind <= Exact::ZERO {
        let depth = step * first;
        if depth < until { depth } else { until }
    } else if behind <= whole(3) {
        let parts = match narrow(&behind.trunc()) {
            1 => 2,
            2 => 4,
            _ => 8,
        };
        target - first * ratio(1, parts)
    } else {
        return None;
    };
    Some(round_narrow(&depth))
}

/// E100L-TINF-04 to -07: M75.
fn areas(first: i64, height: i64, target: i64, flanks: Flanks, state: &State) -> Outcome<Pattern> {
    let square = |value: i64| whole(value) * whole(value);
    let finishing = square(height) - square(target);
    let by_turns = flanks == Flanks::ByTurns;
    let four = state.setup.parameters.m75_pattern == 4;
    if !four && square(first) >= finishing {
        return Ok(if by_turns { Pattern::AreasByTurns } else { Pattern::Areas });
    }
    let rule: RuleId = if four { TINF_07 } else { TINF_06 };
    if state.setup.readings.balanced_infeed == BalancedInfeed::Refused {
        return Err(Fault::about(AlarmName::Unspecified, rule, "M75"));
    }
    // S: what a pass removes at most.
    let most = if four { finishing.max(square(first)) } else { finishing };
    let left = square(target) - square(first);
    let count = if left > Exact::ZERO { (left / most).ceil() + 1 } else { 1.into() };
    let count = u64::try_from(count).unwrap_or(u64::MAX);
    Ok(Pattern::Balanced { by_turns, count, rule })
}

/// E100L-TINF-06: the square of e(n), of N.
fn balanced_square(first: &Exact, target: &Exact, number: u64, count: u64) -> Exact {
    if number == 0 {
        return Exact::ZERO;
    }
    let (from, to) = (first * first, target * target);
    // N is 2 at least where a number below it is asked for.
    let share = whole(number - 1) / whole(count.max(2) - 1);
    &from + (&to - &from) * share
}

/// The root of a square, if it is less than T.
fn root_below(square: &Exact, target: &Exact) -> Option<i64> {
    (*square < target * target).then(|| latched_root(square))
}

/// The mean of the roots of two squares, if it is less than T: √a + √b < 2T if 2√(ab) < 4T² - a - b.
fn mean_below(a: &Exact, b: &Exact, target: &Exact) -> Option<i64> {
    let rest = whole(4) * target * target - a - b;
    let below = sign(&rest) > 0 && whole(4) * a * b < &rest * &rest;
    below.then(|| latched_mean(a, b))
}

fn latched_root(square: &Exact) -> i64 {
    narrow(&real::nearest_whole(|precision| Interval::of(square, precision).sqrt()))
}

fn latched_mean(a: &Exact, b: &Exact) -> i64 {
    let (a, b) = (a * ratio(1, 4), b * ratio(1, 4));
    narrow(&real::nearest_whole(|precision| {
        Interval::of(&a, precision).sqrt().add(&Interval::of(&b, precision).sqrt())
    }))
}
