//! The user task: values of expressions, variables, data communication, and the programs that run within each other.

mod assign;
mod calls;
mod communication;
mod evaluate;
mod function;
mod inputs;
mod interference;
mod locals;
mod memory;
mod modal;
mod number;
mod outputs;
mod read;

pub use assign::assign;
pub use calls::{Activation, Caller, Calls};
pub use communication::communicate;
pub use evaluate::evaluate;
pub use locals::{Entry, Owner, Registration};
pub use memory::{Memory, nose_radii_by_number};
pub use modal::Mode;
pub use number::Number;
pub use outputs::comment;
