//! Theorems about small integer helpers.
//!
//! Each theorem is one function: a harness for the model checker, which proves it for all inputs within
//! its bound, and a property test, which samples it wherever `cargo test` runs. Its doc comment is the
//! statement in plain English. Every family has a refuted twin, a false statement that must be caught, so
//! that a harness that could not fail would be noticed. `README.md` tabulates them.

#[cfg(any(kani, test))]
#[macro_use]
mod harness;
#[cfg(all(any(kani, test), stand_in))]
pub mod kani;
#[cfg(any(kani, test))]
pub mod labels;
#[cfg(any(kani, test))]
pub mod reading_sets;
#[cfg(any(kani, test))]
pub mod rule_sets;
