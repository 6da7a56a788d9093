//! Arithmetic of whole numbers: what needs no exact rationals, and how far it reaches.
//!
//! Each function states the range that it is made for; the crate `turnspec-proofs` proves that it neither panics
//! nor wraps there.

mod amounts;
pub mod area;
pub mod between;
pub mod decimal_code;
mod digits;
pub mod lap;
mod limit;
pub mod mirror;
pub mod modes;
pub mod nose;
pub mod steps;
pub mod thread;
pub mod tool;
pub mod turn;

pub use amounts::Amounts;
pub use digits::Digits;
pub use limit::{Limited, TravelLimit};
