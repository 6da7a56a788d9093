//! The sequence names of a schedule program: blocks behind its END block do not exist (E100L-SDF-15, E100L-SDF-20).

use std::collections::BTreeMap;

use crate::run::{Read, Spot, Texts};
use crate::syntax::{ScheduleHeading, schedule_heading};
use crate::vocabulary::Label;

/// Where each name stands first.
pub struct Outline(BTreeMap<Label, Spot>);

impl Outline {
    /// The names of the main text.
    pub fn new(texts: &Texts) -> Self {
        let mut names = BTreeMap::new();
        let mut next = texts.main_start();
        while let Ok(Some(Read { start, line, behind })) = texts.read(next) {
            let ScheduleHeading { name, is_end } = schedule_heading(&line);
            if let Some(name) = name {
                names.entry(name).or_insert(start);
            }
            if is_end {
                break;
            }
            next = behind;
        }
        Self(names)
    }

    /// The first block with a name.
    pub fn block(&self, name: Label) -> Option<Spot> {
        self.0.get(&name).copied()
    }
}
