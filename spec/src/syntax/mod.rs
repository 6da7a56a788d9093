//! Text to blocks: the first stage. It knows the grammar, and nothing of what words mean.

mod communication;
mod cursor;
mod expression;
mod grammar;
mod items;
mod number;
mod source;
mod statement;
mod string;
mod tree;

pub use grammar::{Heading, heading, parse};
pub use source::{Line, Source};
pub use tree::{
    Address, BinaryOperator, Body, Callee, Characters, Communication, Condition, Decimal, Expression,
    Function, Item, ItemKind, Statement, StringForm, Value, Variable,
};
