//! Schedule programs: which main programs run, in what order, how often (E100L-SDF-01 to -21).

mod outline;
mod selection;

pub use selection::{Selected, find};

use std::collections::BTreeMap;

use crate::emission::Emission;
use crate::run::{Spot, Texts};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, Label, Place, RuleSet};
use outline::Outline;

/// The place of a run in its schedule program.
pub struct Schedule {
    /// The block that is read next.
    pub next: Spot,
    outline: Outline,
    /// What the PSELECT blocks carried out so far have found.
    pub found: BTreeMap<Spot, Selected>,
    /// The selected program that runs.
    pub running: Option<Running>,
}

/// A selected program that runs.
pub struct Running {
    /// The program.
    pub selected: Selected,
    /// The PSELECT block.
    pub place: Place,
    /// Which repetition it is, from 1.
    pub repetition: u16,
    /// How many there are.
    pub repetitions: u16,
}

impl Schedule {
    /// At the beginning of the main text.
    pub fn new(texts: &Texts) -> Self {
        let next = texts.main_start();
        Self { next, outline: Outline::new(texts), found: BTreeMap::new(), running: None }
    }

    /// E100L-SDF-15: the first block with a sequence name.
    pub fn block(&self, name: Label) -> Option<Spot> {
        self.outline.block(name)
    }
}

impl Running {
    /// E100L-SDF-06: a repetition begins.
    pub fn event(&self) -> (Place, Emission) {
        let Selected { file, name, .. } = self.selected;
        let select = Action::Select { file, name, repetition: self.repetition };
        (self.place, Emission::new(select, RuleSet::of(&[SDF_06, SDF_14])))
    }
}
