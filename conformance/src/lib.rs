//! Language-neutral conformance cases: a program, a set-up, and the trace that the rules demand.
//!
//! The cases stand in `cases/<control>/*.json`; their shape is [`Case`], described by a JSON Schema in
//! `schemas/`. An implementation in any language can read them: run the program on the set-up, write the
//! trace, compare it line by line with `expect`.

mod case;
mod figure;
mod files;
#[cfg(feature = "schema")]
mod schema;
mod tag;

pub use case::{Basis, Case};
pub use figure::Figure;
pub use files::cases;
#[cfg(feature = "schema")]
pub use schema::schemas;
pub use tag::Flag;
