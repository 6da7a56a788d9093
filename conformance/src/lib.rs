//! Language-neutral conformance cases: a program, a set-up, and the trace that the rules demand.
//!
//! The cases stand in `cases/<control>/*.json`; their shape is [`Case`], described by a JSON Schema in
//! `schemas/`. An implementation in any language can read them: run the program on the set-up, write the
//! trace, compare it line by line with `expect`.

mod alignment;
mod case;
mod comparison;
pub mod corpus;
mod decimal;
mod declaration;
mod exercise;
mod expectation;
mod explanation;
mod export;
mod features;
mod figure;
mod files;
mod observation;
pub mod page;
mod process;
pub mod report;
mod runner;
#[cfg(feature = "schema")]
mod schema;
mod selection;
mod tag;
mod task;
mod tolerance;
mod words;

pub use case::{Basis, Case};
pub use comparison::{Difference, Divergence, Verdict, compare, compare_traces, read_trace};
pub use decimal::Decimal;
pub use declaration::{Alarms, Declaration, DeclarationError, Subject, Undecided, Waiver};
pub use exercise::Exercise;
pub use expectation::{Expected, ExpectedEvent, Line};
pub use export::corpus_files;
pub use features::{CRITERIA, Criterion, features_of};
pub use figure::Figure;
pub use files::cases;
pub use observation::{Observation, printable};
pub use process::{Exit, Implementation, Outcome, RunError};
pub use runner::Runner;
#[cfg(feature = "schema")]
pub use schema::schemas;
pub use selection::Filter;
pub use tag::Flag;
pub use task::{PROTOCOL, Task, bytes_of_text, text_of_bytes};
pub use tolerance::{Relation, Tolerance};
