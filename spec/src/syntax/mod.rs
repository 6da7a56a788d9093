//! Text to blocks: the first stage. It knows the grammar, and nothing of what words mean.

mod cursor;
mod expression;
mod grammar;
mod items;
mod number;
mod source;
mod tree;

pub use grammar::parse;
pub use source::Source;
pub use tree::{
    Address, BinaryOperator, Body, Decimal, Expression, Function, Item, ItemKind, Value, Variable,
};
