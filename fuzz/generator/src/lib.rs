//! Generates part programs of the E100L, with set-ups, for differential and property tests.
//!
//! A program is grown block by block beside a forecast of the control's state, so that most programs run
//! deep: arcs close, corners fit, feeds are given, coordinates stay within the limits, and in radius
//! compensation the nose circle finds its corners. Some programs carry a fault of a chosen family, usually
//! late. Everything follows from a stream of bytes: the same bytes, or the same seed, give the same case, and
//! a fuzzer that changes the bytes changes the program.
//!
//! ```
//! let case = turnspec_generator::case_from_seed(1);
//! assert!(case.setup.validate().is_ok());
//! ```

mod arcs;
mod barriers;
mod bench;
mod builder;
mod case;
mod chamfer;
mod choices;
mod codes;
mod companions;
mod compensation;
mod contour;
mod control;
mod cutter;
mod cycles;
mod environment;
mod estimate;
mod expression;
mod faults;
mod formulas;
mod geometry;
mod io;
mod lap;
mod motion;
mod needs;
mod nudged;
mod number;
mod oneshot;
mod print;
mod print_expression;
mod print_statement;
mod profile;
mod program;
mod respelled;
mod scan;
mod schedule;
mod setup;
mod shrink;
mod state;
mod tape;
mod threads;
mod turrets;
mod unit;
mod variables;
mod words;

pub use bench::{
    arcs_and_chamfers, compensated, counting_loop, expressions, nested_calls, straight_line, with_nose,
};
pub use case::{Case, case_from_seed, case_from_seed_within};
pub use expression::{Expression, Function, Operator, Variable};
pub use formulas::Formulas;
pub use nudged::Nudged;
pub use number::Number;
pub use profile::Profile;
pub use program::{
    Block, Caret, Condition, Item, Line, Program, Repetitions, Selection, Sent, Statement, Text, Value, Word,
};
pub use respelled::{Remarked, Respelled};
pub use shrink::shrink;
pub use tape::{decode, encode};
