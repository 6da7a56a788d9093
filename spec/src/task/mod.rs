//! The user task: values of expressions, and variables.

mod assign;
mod evaluate;
mod function;
mod memory;
mod number;
mod read;

pub use assign::assign;
pub use evaluate::evaluate;
pub use memory::Memory;
pub use number::Number;
