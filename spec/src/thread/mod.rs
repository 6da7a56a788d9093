//! Thread cutting: G31 to G35, G71 and G72 (execution-threads.md), from the words of a block to its motions.
//!
//! [`check`] refuses blocks, [`kept`] is what goes on in the next block, [`lead`] the lead and where it leads. A block of
//! G31, G32 or G33 cuts one [`pass`] of its [`cycle`], with [`taper`] and [`chamfer`]; G34 and G35 cut a [`leg`]; G71 and
//! G72 are [`compound`]: many passes, with an [`infeed`] and a [`flank`]. [`motion`] carries each motion out.

mod chamfer;
mod check;
mod compound;
mod cycle;
mod flank;
mod infeed;
mod kept;
mod lead;
mod leg;
mod motion;
mod pass;
mod taper;

pub use check::{check_block, check_compound, not_in_compensation, not_in_constant_speed};
pub use compound::Compound;
pub use flank::Flanks;
pub use infeed::{Depth, Infeed};
pub use kept::Kept;
pub use lead::{Lead, measure, of_block as lead_of_block};
pub use motion::Cited;

use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::path::Ahead;
use crate::state::State;

/// Whether a motion code is one of thread cutting.
pub fn is_mode(motion: u16) -> bool {
    matches!(motion, 31..=35)
}

/// E100L-THRD-04: whether the F word of a block is a lead, in G94 too.
pub fn feed_is_lead(plan: &Plan) -> bool {
    plan.is_compound() || plan.one_shot.is_none() && plan.cycle.is_none() && is_mode(plan.motion())
}

/// The motions of a block that cuts a thread in G31 to G35, with its lead. `ahead` are the blocks that look-ahead has read.
pub fn cut(
    plan: &Plan,
    lead: Lead,
    ahead: &[Ahead],
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    // It counts from the present point: a corner of before (E100L-CHAM-13) is left behind.
    state.base = None;
    match plan.motion() {
        34 | 35 => leg::cut(plan, lead, ahead, state, emissions),
        _ => cycle::cut(plan, lead, state, emissions),
    }
}
