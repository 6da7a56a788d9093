//! Text to blocks: the first stage. It knows the grammar, and nothing of what words mean.

mod communication;
mod cursor;
mod expression;
mod file_name;
mod grammar;
mod items;
mod number;
mod saddles;
mod schedule;
mod source;
mod statement;
mod string;
mod tree;

pub use communication::Communication;
pub use file_name::FileName;
pub use grammar::{Heading, heading, parse, parse_whole};
pub use schedule::{ScheduleBlock, ScheduleHeading, Selection, parse_schedule, schedule_heading};
pub use source::{Line, Source};
pub use tree::{
    Address, BinaryOperator, Body, Callee, Characters, Condition, Decimal, Expression, Function, Item,
    ItemKind, Statement, StringForm, Value, Variable,
};
