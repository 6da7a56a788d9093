//! The fast interpreter of CNC lathe programs, cross-checked against the reference semantics.

#[cfg(feature = "cli")]
pub mod audit;
#[cfg(feature = "cli")]
pub mod campaign;
pub mod differential;
pub mod engine;
#[cfg(feature = "cli")]
pub mod plot;
