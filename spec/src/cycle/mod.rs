//! Grooving, drilling and tapping, and the cycles of driven tools: G73, G74, G77, G78, G178 to G190
//! (execution-drilling.md), from the words of a block to its motions.
//!
//! [`block`] says what a block is in a cycle mode, [`mod@refuse`] and [`data`] what is refused, [`function`] which words are
//! taken, [`kept`] what goes on in the next block. [`work`] carries a block out, pass by pass: a [`groove`], a [`tapping`]
//! with the main spindle, [`hole`]s (between their [`levels`], with [`peck`]s, [`synchronised`], or as [`key_way`]s), or a [`helix`]. [`act`] and [`motion`] make the
//! events, [`cited`] the rules that those of driven tools cite.

mod act;
mod block;
mod cited;
mod data;
mod function;
mod groove;
mod helix;
mod hole;
mod kept;
mod key_way;
mod levels;
mod motion;
mod peck;
mod refuse;
mod synchronised;
mod tapping;
mod work;

pub use block::{CycleBlock, is_groove, is_tapping, synchronised_words};
pub use cited::mode_rules;
pub use data::{check_block, check_groove, check_tapping};
pub use function::words_taken;
pub use kept::Kept;
pub use refuse::{not_in_compensation, refuse, stands_alone, stands_first};
pub use work::Work;
