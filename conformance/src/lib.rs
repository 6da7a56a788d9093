//! Language-neutral conformance cases, and the runner that puts other implementations to them.
//!
//! A [`Case`] is a part program, a set-up, and the trace that the rules demand. The [`corpus`] holds the
//! hand-written cases of `cases/<control>/` and the examples of the rule texts; JSON Schemas in `schemas/`
//! describe their files, so that an implementation in any language can read them.
//!
//! An [`Implementation`] is any program that reads a [`Task`] and writes a trace, as `PROTOCOL.md` says. Running
//! it gives an [`Outcome`], [`compare`] a [`Verdict`] as far as its [`Declaration`] lets it be judged. A
//! [`Runner`] does that for a corpus and makes a [`report::Report`].

mod alignment;
mod case;
mod comparison;
pub mod corpus;
mod decimal;
mod declaration;
#[cfg(feature = "drawings")]
mod drawing;
mod exercise;
mod expectation;
mod explanation;
mod export;
mod features;
mod figure;
mod files;
pub mod geometry;
mod observation;
pub mod page;
mod parallel;
mod pipes;
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
pub use declaration::{Alarms, Declaration, DeclarationError, Refusals, Subject, Undecided, Waiver};
#[cfg(feature = "drawings")]
pub use drawing::drawings;
pub use exercise::Exercise;
pub use expectation::{Expected, ExpectedEvent, Line};
pub use export::corpus_files;
pub use features::{CRITERIA, Criterion, features_of};
pub use figure::Figure;
pub use files::cases;
pub use observation::{Observation, printable};
pub use parallel::{finished_in_parallel, in_parallel};
pub use process::{Exit, Implementation, Outcome, RunError};
pub use runner::Runner;
#[cfg(feature = "schema")]
pub use schema::schemas;
pub use selection::Filter;
pub use tag::Flag;
pub use task::{PROTOCOL, Task, bytes_of_text, text_of_bytes};
pub use tolerance::{Relation, Tolerance};
