//! Two saddles (E100L-AX4-01 to -12): what is common to both, and which words command the spindle that they share.
//!
//! Each saddle has a state of its own; [`common`] carries over what belongs to both when the other one goes on.
//! [`words`] compares what two blocks command. How the sides take turns is told in `run`.

mod common;
mod words;

pub use common::Saddle;
pub use words::{Commands, CommonWords, is_common_g, is_common_m};
