//! Two turrets on one saddle (E100L-MIRR-01 to -20): what each has for itself, and the blocks that select one.
//!
//! The state holds the data of the turret that is selected; [`own`] keeps those of the other one. [`change`] says what a
//! block with G13 or G14 does.

mod change;
mod own;

pub use change::{change, in_definition, selected_by};
pub use own::OwnData;
