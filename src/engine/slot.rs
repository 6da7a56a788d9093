//! A block from its reading to its end. Its room is used again for the next one, unless its parts are kept.

use std::ops::Deref;
use std::sync::Arc;

use turnspec_oracle::vocabulary::Place;

use super::text::Mark;
use super::words::{Parsed, Words};

/// The parts of a block: its own, made anew for each block, or those that are kept for blocks that are run
/// again.
#[derive(Debug, Default)]
pub struct Parts {
    own: Parsed,
    kept: Option<Arc<Parsed>>,
}

impl Parts {
    /// Makes room for the parts of the next block.
    #[inline]
    pub fn renew(&mut self) -> &mut Parsed {
        self.kept = None;
        self.own.clear();
        &mut self.own
    }

    /// Takes over parts that are kept.
    #[inline]
    pub fn share(&mut self, kept: Arc<Parsed>) {
        self.kept = Some(kept);
    }

    /// The parts, to be kept from now on.
    pub fn keep(&mut self) -> Arc<Parsed> {
        let own = &mut self.own;
        self.kept.get_or_insert_with(|| Arc::new(std::mem::take(own))).clone()
    }
}

impl Deref for Parts {
    type Target = Parsed;

    #[inline]
    fn deref(&self) -> &Parsed {
        self.kept.as_deref().unwrap_or(&self.own)
    }
}

/// A block that was read: its place, its parts, its words.
#[derive(Debug, Default)]
pub struct Slot {
    pub place: Place,
    pub parsed: Parts,
    pub words: Words,
    /// Where reading began, if the block was read before its turn.
    pub from: Mark,
    /// How many blocks were read then, skipped and empty ones included.
    pub passed: u64,
}
