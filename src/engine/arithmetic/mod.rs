//! The integer arithmetic of the engine: pure functions, one concept a module.
//!
//! Each function states the range that it is made for; within that range it neither panics nor wraps, and
//! the crate `turnspec-proofs` proves it. Beyond the range of an address, a variable or a limit it is the
//! control that alarms, before these functions are reached.

pub mod area;
pub mod contour;
pub mod decimal_code;
pub mod digits;
pub mod drilling;
pub mod feed;
pub mod frame;
pub mod idle;
pub mod infeed;
pub mod lap;
pub mod lead;
pub mod lead_axis;
pub mod limit;
pub mod meeting;
pub mod modes;
pub mod nose;
pub mod plane;
pub mod rectangle;
pub mod root;
pub mod round;
pub mod run_out;
pub mod scale;
pub mod segment;
pub mod sequence_name;
pub mod span;
pub mod speed;
pub mod steps;
pub mod surd;
pub mod thread_course;
pub mod tool;
pub mod turn;
pub mod units;
pub mod wide;
