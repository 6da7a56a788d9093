//! The user task: values of expressions, variables, and the programs that run within each other.

mod assign;
mod calls;
mod evaluate;
mod function;
mod locals;
mod memory;
mod modal;
mod number;
mod read;

pub use assign::assign;
pub use calls::{Activation, Caller, Calls};
pub use evaluate::evaluate;
pub use locals::{Entry, Owner, Registration};
pub use memory::Memory;
pub use modal::Mode;
pub use number::Number;
