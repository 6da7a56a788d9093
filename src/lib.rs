//! The fast interpreter of CNC lathe programs, cross-checked against the reference semantics.

pub mod differential;
pub mod engine;
