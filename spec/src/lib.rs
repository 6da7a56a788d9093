//! The reference semantics of CNC lathe control languages.
//!
//! Given a control, a machine set-up and a part program this crate answers one question exactly:
//! what must the control do? The answer is a [trace](vocabulary::Event): events, each with the rules
//! that produced it, or an alarm. The rules themselves stand in `spec/rules/`.
//!
//! The crate is written to be read beside the manual. It is pure: no input or output, no clock, no
//! globals, no floating point that is not correctly rounded. Use the `turnspec` crate when you need
//! speed.
//!
//! One way through it, a stage a room: `syntax` (text to blocks), `run` (which block comes next), `schedule` (which
//! main program), `task` (expressions, variables, data communication, and the programs that run within each other),
//! `modal` (codes and modes), `turret` (two turrets on one saddle), `saddle` (two saddles), `path` (motion), `thread`
//! (thread cutting), `cycle` (grooving, drilling and tapping, driven tools), `contour` (contours with the C axis,
//! coordinate conversion), `lap` (lathe auto-programming), `barrier` (areas to keep out of), `compensation` (nose and cutter
//! radius),
//! `frame` (machine coordinates and
//! limits); `controls` holds the tables, `integer`, `quantity` and `real` the numbers.

mod barrier;
pub mod book;
mod check;
mod compensation;
mod contour;
mod controls;
mod cycle;
mod emission;
mod fault;
mod frame;
pub mod integer;
mod lap;
mod modal;
mod path;
mod quantity;
mod real;
mod run;
mod saddle;
mod schedule;
mod state;
pub mod syntax;
mod task;
mod thread;
mod turret;
pub mod vocabulary;

pub use check::{Diagnostic, check};
pub use run::{ActiveMode, ActiveProgram, LocalVariable, Outline, OutlineMotion, Run, run};
