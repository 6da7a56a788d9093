//! The sequence names of a program, with the first block of each (E100L-GOTO-02, E100L-SEQ-03).

use crate::engine::planted::{self, Bug};
use crate::engine::text::{Mark, Reader};

use super::head::Head;

/// The first block with a name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Entry {
    name: u32,
    line: u32,
    start: usize,
}

/// Where each sequence name of a program stands first.
#[derive(Debug)]
pub struct Labels {
    entries: Vec<Entry>,
}

/// Where a program ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bound {
    /// At an offset.
    Offset(usize),
    /// At the next name block that is not its own, whose offset is given.
    NextName(Option<usize>),
}

impl Labels {
    /// The names from where a reader stands to the end of the program.
    pub fn new(mut reader: Reader, bound: Bound, block_delete: bool) -> Self {
        let mut entries = Vec::new();
        while let Some(lines) = reader.next_lines() {
            if reader.is_no_block(lines) {
                continue;
            }
            if matches!(bound, Bound::Offset(end) if lines.start >= end) {
                break;
            }
            match Head::of(reader.lenient(lines), block_delete) {
                Head::Program(_) if planted::is(Bug::NamesBeyondEnd) => {}
                Head::Program(_) if matches!(bound, Bound::NextName(own) if own != Some(lines.start)) => {
                    break;
                }
                Head::Sequence(name) => entries.push(Entry { name, line: lines.line, start: lines.start }),
                Head::Program(_) | Head::Other => {}
            }
        }
        entries.sort_unstable();
        if planted::is(Bug::LastOfEqualNames) {
            entries.sort_unstable_by_key(|entry| (entry.name, std::cmp::Reverse(entry.line)));
        }
        entries.dedup_by_key(|entry| entry.name);
        entries.shrink_to_fit();
        Self { entries }
    }

    /// The first block with a name.
    pub fn find(&self, name: u32) -> Option<Mark> {
        let place = self.entries.binary_search_by_key(&name, |entry| entry.name).ok()?;
        let entry = self.entries.get(place)?;
        Some(Mark { at: entry.start, line: entry.line, closed: false })
    }
}
