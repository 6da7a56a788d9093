//! Data communication, input and output variables, user alarms ("How input, output and schedules run",
//! chapters 3 to 5).

mod comment;
mod grammar;
mod inputs;
mod number;
mod outputs;
mod put;
mod strings;
mod transfer;

pub use comment::{Comment, CommentForm};
pub use grammar::{Put, Target, Transfer};
pub use inputs::input_exists;
pub use outputs::output_exists;

use inputs::Taken;

/// Characters that either area holds.
const AREA: usize = 160;

/// What communication remembers. A program that has nothing to do with it never looks here.
#[derive(Debug, Default)]
pub struct Communication<'a> {
    /// How many texts of each device were received.
    received: [usize; 10],
    /// The READ area from the read pointer on (E100L-GPUT-04).
    unread: &'a [u8],
    /// The WRITE area up to the write pointer (E100L-GPUT-11).
    written: Vec<u8>,
    /// Whether a dimensional variable is among what was written.
    dimensional: bool,
    taken: Taken,
    comment: Comment,
}
