//! The passes of a compound thread cycle (E100L-G71-10, E100L-GOTO-03): each but the first is a step of its own.

use super::statement::Carried;
use super::{Progress, Run};
use crate::compensation::Stream;
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::thread::Compound;

/// A cycle that is carried out.
pub struct Cycle {
    plan: Plan,
    /// Its block.
    pub block: Carried,
    passes: Compound,
}

impl Run<'_> {
    /// A cycle begins, with its first pass.
    pub(super) fn compound(&mut self, plan: Plan, block: Carried, stream: &mut Stream) -> Outcome<Progress> {
        let passes = Compound::begin(&plan, &mut self.state)?;
        self.pass(Box::new(Cycle { plan, block, passes }), stream)
    }

    /// Cuts the next pass; behind the last one comes the rest of the block.
    pub(super) fn pass(&mut self, mut cycle: Box<Cycle>, stream: &mut Stream) -> Outcome<Progress> {
        if cycle.passes.cut(&cycle.plan, &mut self.state, &mut stream.emissions)? {
            self.cycle = Some(cycle);
            return Ok(Progress::Going);
        }
        // E100L-G34-05, E100L-G71-08: the motion mode stays; a run of G34 and G35 is interrupted.
        self.state.thread.chain = false;
        self.after_motion(&cycle.plan, true, cycle.block, stream)
    }
}
