//! Codes and modes: from the words of a block to what is to be done.
//!
//! [`words`](Words) holds the values, [`check`] refuses blocks that contradict themselves, [`carry_out`]
//! does everything but the motion, in the order of E100L-FMT-09.

mod carry_out;
mod check;
mod compensation;
mod feed;
mod function;
mod machine;
mod miscellaneous;
mod reset;
mod spindle;
mod tool;
mod words;
mod written;

pub use carry_out::{before_motion, end, end_code, stop};
pub use check::{Before, Change, Plan, check};
pub use compensation::CutterPlane;
pub use feed::{
    active_feed, dwell, dwell_time, in_force as feed_in_force, is_feed, readings as feed_readings,
};
pub use miscellaneous::by_cycle;
pub use reset::{mode, reset};
pub use spindle::{motion_speed, turning_speed};
pub use words::{Other, Words, evaluate, evaluate_call};
pub use written::Written;
