//! Text to blocks: the first stage. It knows the grammar, and nothing of what words mean.

mod cursor;
mod expression;
mod grammar;
mod items;
mod number;
mod source;
mod statement;
mod tree;

pub use grammar::{Heading, heading, parse};
pub use source::{Line, Source};
pub use tree::{
    Address, BinaryOperator, Body, Callee, Condition, Decimal, Expression, Function, Item, ItemKind,
    Statement, Value, Variable,
};
