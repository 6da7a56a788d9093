//! Machines with two turrets on one saddle, and machines with two saddles.
//!
//! With two turrets the program is one of the usual kind, with blocks that select a turret: [`own`] keeps the data of
//! the turret that is not selected, [`change`] writes the blocks. With two saddles the program is a pair of programs:
//! [`plan`] draws where the sides wait for each other and foresees what lets them go on, [`side`] grows each of them
//! around its [`stop`]s, [`portions`] mixes their texts.

mod change;
mod common;
mod own;
mod plan;
mod portions;
mod setup;
mod side;
mod stop;

pub use own::Turrets;
pub(crate) use setup::{machine_type, set_up};
