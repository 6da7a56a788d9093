//! Parsed blocks that are kept to be run again, by their place. What they take is bounded: when there is no
//! more room, all are forgotten.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};
use std::sync::Arc;

use crate::engine::planted::{self, Bug};
use crate::engine::text::{Lines, Mark};
use crate::engine::words::{Item, Operation, Parsed};

/// Most bytes that the kept blocks may take, about.
const ROOM: usize = 16 << 20;

/// A block that is kept.
#[derive(Debug)]
pub struct KeptBlock {
    pub lines: Lines,
    /// Where the next block begins.
    pub after: Mark,
    pub parsed: Arc<Parsed>,
    /// Whether nothing of it is carried out.
    pub idle: bool,
}

/// The kept blocks, by the number of their text and their offset.
#[derive(Debug, Default)]
pub struct Kept {
    blocks: HashMap<(usize, usize), KeptBlock, BuildHasherDefault<PlaceHasher>>,
    taken: usize,
}

impl Kept {
    /// The block at a place of a text, if it is kept.
    #[inline]
    pub fn get(&self, text: usize, at: usize) -> Option<&KeptBlock> {
        self.blocks.get(&place(text, at))
    }

    /// Keeps a block.
    pub fn keep(&mut self, text: usize, block: KeptBlock) {
        let parts = block.parsed.items.capacity() * size_of::<Item>()
            + block.parsed.operations.capacity() * size_of::<Operation>()
            + block.parsed.characters.capacity();
        let size = parts + size_of::<KeptBlock>() + size_of::<Parsed>();
        if self.taken + size > ROOM {
            self.blocks.clear();
            self.taken = 0;
        }
        self.taken += size;
        self.blocks.insert(place(text, block.lines.start), block);
    }
}

/// The place of a block by the number of its text and its offset.
#[inline]
fn place(text: usize, at: usize) -> (usize, usize) {
    if planted::is(Bug::TextsMixedUp) { (0, at) } else { (text, at) }
}

/// Hashes a place; no one gains by programs whose places collide.
#[derive(Default)]
struct PlaceHasher(u64);

impl Hasher for PlaceHasher {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.write_u64(u64::from(*byte)));
    }

    #[inline]
    fn write_usize(&mut self, value: usize) {
        self.write_u64(value as u64);
    }

    #[inline]
    fn write_u64(&mut self, value: u64) {
        self.0 = (self.0.rotate_left(5) ^ value).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    #[inline]
    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 32)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::{Kept, KeptBlock, ROOM};
    use crate::engine::text::{Lines, Mark};
    use crate::engine::words::{Operation, Parsed};

    #[test]
    fn room_is_bounded() {
        let mut kept = Kept::default();
        for start in 0..100_000 {
            let parsed = Parsed { operations: vec![Operation::Negate; 64], ..Parsed::default() };
            let lines = Lines { start, ..Lines::default() };
            let block = KeptBlock { lines, after: Mark::default(), parsed: Arc::new(parsed), idle: false };
            kept.keep(0, block);
            assert!(kept.taken <= ROOM);
            assert!(kept.get(0, start).is_some());
        }
        assert!(kept.get(0, 0).is_none());
        assert!(kept.get(1, 99_999).is_none());
    }
}
