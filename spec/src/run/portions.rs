//! The portions of a text for two saddles: which blocks belong to which side (E100L-AX4-01 to -03).

use super::texts::{Read, Spot, Texts};
use crate::syntax::{Body, parse};
use crate::turret::selected_by;
use crate::vocabulary::{Label, Setup, Side};

/// A block that selects the side of those behind it; it belongs to none.
#[derive(Clone, Copy, Debug)]
struct Selection {
    start: Spot,
    behind: Spot,
    side: Side,
}

/// The blocks of the main text that belong together.
#[derive(Clone, Debug)]
pub struct Portion {
    /// All selections of the text, in order.
    selections: Vec<Selection>,
    /// The side; none for what stands in front of the first selection.
    side: Option<Side>,
}

/// Where a portion goes on.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    /// With the block that was found: it is one of the portion.
    Here,
    /// Not before this place.
    To(Spot),
    /// Nowhere: it is at its end.
    Nowhere,
}

impl Portion {
    /// What stands in front of the first selection.
    pub fn front(texts: &Texts, setup: &Setup) -> Self {
        Self { selections: selections(texts, setup), side: None }
    }

    /// The side program of a side, in the same text.
    pub fn of_side(&self, side: Side) -> Self {
        Self { side: Some(side), selections: self.selections.clone() }
    }

    /// Whether the text has a selection.
    pub fn is_divided(&self) -> bool {
        !self.selections.is_empty()
    }

    /// The way to the next block of the portion, from the beginning of a block.
    pub fn way(&self, block: Spot) -> Way {
        let (before, behind) =
            self.selections.split_at(self.selections.partition_point(|each| each.start < block));
        let selects = behind.first().is_some_and(|selection| selection.start == block);
        if !selects && before.last().map(|selection| selection.side) == self.side {
            return Way::Here;
        }
        let own = |each: &&Selection| Some(each.side) == self.side;
        behind.iter().find(own).map_or(Way::Nowhere, |next| Way::To(next.behind))
    }
}

/// E100L-AX4-03: the blocks without fault that hold one turret code as a plain number and nothing else.
fn selections(texts: &Texts, setup: &Setup) -> Vec<Selection> {
    let mut selections = Vec::new();
    let mut next = texts.start(0);
    while let Ok(Some(Read { start, line, behind })) = texts.read(next) {
        if let Ok(Body::Items(items)) = parse(&line, setup, &mut Label::default()).map(|block| block.body)
            && let ([_], [side]) = (items.as_slice(), selected_by(&items).as_slice())
        {
            selections.push(Selection { start, behind, side: *side });
        }
        next = behind;
    }
    selections
}

/// Whether a text has a block that counts: not empty, not skipped, and more than a sequence name.
pub fn has_blocks(texts: &Texts, setup: &Setup) -> bool {
    let mut next = texts.start(0);
    while let Ok(Some(Read { line, behind, .. })) = texts.read(next) {
        let counts = match parse(&line, setup, &mut Label::default()).map(|block| block.body) {
            Ok(Body::Empty | Body::Skipped) => false,
            Ok(Body::Items(items)) => !items.is_empty(),
            Ok(_) | Err(_) => true,
        };
        if counts {
            return true;
        }
        next = behind;
    }
    false
}
