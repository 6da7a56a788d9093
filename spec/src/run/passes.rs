//! The passes of a fixed cycle (E100L-G71-10, E100L-GRV-10, E100L-GOTO-03): each but the first is a step of its own.

use super::channel::{Channel, Moved};
use super::statement::Carried;
use crate::compensation::Stream;
use crate::cycle::Work;
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::thread::Compound;
use crate::vocabulary::Place;

/// A cycle of which passes are left.
pub struct Cycle {
    /// The block up to its last pass.
    pub moved: Moved,
    /// Where it stands.
    pub block: Carried,
}

/// Passes that are left.
pub enum Passes {
    /// Of G71 and G72.
    Compound(Box<Compound>),
    /// Of grooving, drilling and tapping, and of the cycles of driven tools.
    Cycle(Box<Work>),
}

impl Channel<'_> {
    /// A cycle begins, with its first pass.
    pub(super) fn begin_cycle(&mut self, plan: Plan, stream: &mut Stream) -> Outcome<Moved> {
        let passes = if plan.is_compound() {
            Passes::Compound(Box::new(Compound::begin(&plan, &mut self.state)?))
        } else {
            Passes::Cycle(Box::new(Work::begin(&plan, &mut self.state)?))
        };
        let mut moved = Moved { plan, in_plane: true, passes: Some(passes) };
        self.pass(&mut moved, stream)?;
        Ok(moved)
    }

    /// One step more, at the block of the cycle.
    pub(super) fn begin_pass(&mut self, block: Carried, place: &mut Place) -> Outcome<()> {
        self.reader.step(block.place, place)
    }

    /// Cuts the next pass.
    pub(super) fn pass(&mut self, moved: &mut Moved, stream: &mut Stream) -> Outcome<()> {
        let Moved { plan, passes: Some(passes), .. } = moved else { return Ok(()) };
        let left = match passes {
            Passes::Compound(compound) => {
                let left = compound.cut(plan, &mut self.state, &mut stream.emissions)?;
                // E100L-G34-05, E100L-G71-08: the motion mode stays; a run of G34 and G35 is interrupted.
                self.state.thread.chain &= left;
                left
            }
            Passes::Cycle(work) => work.go_on(plan, &mut self.state, &mut stream.emissions)?,
        };
        if !left {
            moved.passes = None;
        }
        Ok(())
    }
}
