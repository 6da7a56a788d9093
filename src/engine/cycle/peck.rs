//! Cutting in pecks (execution of drilling, 5; E100L-GRV-04, E100L-GRV-05, E100L-G183-01, E100L-G183-02).

use turnspec_oracle::vocabulary::{Feed, Part, PeckRetract, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::drilling::{at_depth, next_depth, relieved};
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::thread::Cited;

use super::axis::Axis;
use super::motion::Drive;

/// How a hole or groove is cut in pecks. Lengths are those of the axis.
#[derive(Clone, Copy, Debug)]
pub struct Peck {
    pub axis: Axis,
    /// Where the cut begins.
    pub level: i64,
    /// 1 or -1.
    pub direction: i64,
    /// From there to the bottom, positive.
    pub depth: i64,
    /// D, positive.
    pub step: i64,
    /// L, the infeed between withdrawals.
    pub between: Option<i64>,
    /// How far the tool returns.
    pub retract: i64,
    /// To where it is withdrawn.
    pub withdrawal: i64,
    pub feed: Feed,
}

/// What the motions of pecks cite.
#[derive(Clone, Copy)]
pub struct PeckCites {
    pub cut: Cited,
    pub retract: Cited,
    /// Withdrawal and re-entry.
    pub withdraw: Cited,
}

impl Interpreter<'_> {
    /// An amount by which the tool returns, along an axis.
    pub(super) fn retract(&self, axis: Axis, amount: i64) -> i64 {
        let radius =
            self.setup.readings.peck_retract == PeckRetract::Radius && !planted::is(Bug::PeckReadingLost);
        if axis == Axis::X && radius { amount.saturating_mul(2) } else { amount }
    }

    /// Cuts to the bottom.
    pub(super) fn peck(&mut self, peck: &Peck, cites: &PeckCites, sink: &mut impl Sink) -> Result<(), Fault> {
        let at = |depth| (peck.axis, at_depth(peck.level, peck.direction, depth));
        let (mut done, mut since) = (0_i64, 0_i64);
        let mut number = 1_u32;
        loop {
            let next = match planted::is(Bug::LastPeckWhole) {
                true => done.saturating_add(peck.step),
                false => next_depth(done, peck.step, peck.depth),
            };
            since = since.saturating_add(next.saturating_sub(done));
            done = next;
            if !planted::is(Bug::PecksUncounted) {
                self.begin_pass()?;
            }
            self.go_along(at(done), Drive::Feed(peck.feed), (Part::Cut, Some(number)), cites.cut, sink)?;
            if done >= peck.depth {
                return Ok(());
            }
            let back = at(relieved(done, peck.retract));
            let following = number.saturating_add(1);
            if peck.between.is_some_and(|between| since >= between) {
                since = if planted::is(Bug::DischargeOnce) { since } else { 0 };
                let out = (peck.axis, peck.withdrawal);
                let withdraw = (Part::Withdraw, Some(number));
                self.go_along(out, Drive::Rapid, withdraw, cites.withdraw, sink)?;
                let reentry = (Part::Reentry, Some(following));
                self.go_along(back, Drive::Rapid, reentry, cites.withdraw, sink)?;
            } else {
                let retract = (Part::Retract, Some(number));
                self.go_along(back, Drive::Rapid, retract, cites.retract, sink)?;
            }
            number = following;
        }
    }
}
