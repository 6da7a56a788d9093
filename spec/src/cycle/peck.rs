//! Pecking: infeeds with a retract or a withdrawal after each (E100L-GRV-04, E100L-GRV-05, E100L-G183-01,
//! E100L-G183-02).

use super::act::Act;
use super::motion::{Axis, Go, Manner};
use crate::thread::Cited;
use crate::vocabulary::{Part, PeckRetract, Setup};

/// Pecks that are left, in program coordinates and lengths along the axis, in nanometres.
#[derive(Clone, Copy, Debug)]
pub struct Peck {
    axis: Axis,
    /// Where the cut begins.
    level: i64,
    direction: i64,
    /// From there to the bottom.
    total: i64,
    amounts: Amounts,
    /// How deep it is.
    reached: i64,
    /// How much of it since the last withdrawal.
    since: i64,
    number: u32,
}

/// The amounts of pecking.
#[derive(Clone, Copy, Debug)]
pub struct Amounts {
    /// D.
    pub infeed: i64,
    /// L.
    pub discharge: Option<i64>,
    /// The retract.
    pub retract: i64,
    /// The level to which a withdrawal goes.
    pub withdrawal: i64,
}

impl Peck {
    /// Before the first one.
    pub fn new(axis: Axis, level: i64, bottom: i64, amounts: Amounts) -> Self {
        let (direction, total) = ((bottom - level).signum(), (bottom - level).abs());
        Self { axis, level, direction, total, amounts, reached: 0, since: 0, number: 0 }
    }

    /// The next peck, and what follows it if it is not the last; none when the bottom is reached.
    pub fn next(&mut self, cited: impl Fn(Part) -> Cited) -> Option<Vec<Act>> {
        let left = self.total - self.reached;
        if left <= 0 {
            return None;
        }
        let Amounts { infeed, discharge, retract, withdrawal } = self.amounts;
        let advance = infeed.min(left);
        self.reached += advance;
        self.since += advance;
        self.number = self.number.saturating_add(1);
        let at = |depth: i64| self.level + self.direction * depth;
        let go = |to, manner, part, pass| {
            Act::Go(Go::along(self.axis, to, manner, part, cited(part)).in_pass(pass))
        };
        let mut acts = vec![Act::Pass, go(at(self.reached), Manner::Feed, Part::Cut, self.number)];
        if self.reached < self.total {
            let back = at((self.reached - retract).max(0));
            if discharge.is_some_and(|discharge| self.since >= discharge) {
                acts.push(go(withdrawal, Manner::Rapid, Part::Withdraw, self.number));
                acts.push(go(back, Manner::Rapid, Part::Reentry, self.number.saturating_add(1)));
                self.since = 0;
            } else {
                acts.push(go(back, Manner::Rapid, Part::Retract, self.number));
            }
        }
        Some(acts)
    }
}

/// E100L-GRV-04: a retract along an axis; on X the reading says whether its amount is a radius.
pub fn retract(amount: i64, axis: Axis, setup: &Setup) -> i64 {
    if axis == Axis::X && setup.readings.peck_retract == PeckRetract::Radius { 2 * amount } else { amount }
}
