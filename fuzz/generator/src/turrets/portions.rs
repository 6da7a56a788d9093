//! The text of a program for two saddles: the side programs in portions behind G13 and G14 (E100L-AX4-03).

use std::collections::BTreeSet;

use turnspec_oracle::vocabulary::{Feature, Side};

use crate::builder::Builder;
use crate::program::{Block, Item, Line};

use super::change::code;

/// What may stand in a portion that has no block.
const EMPTY: [&[u8]; 4] = [b"", b"(NOTHING HERE)", b"  ", b"N7"];

impl Builder<'_, '_, '_> {
    /// Divides the sides into portions and puts them one behind the other.
    pub(super) fn portions(&mut self, mut sides: [Vec<Line>; 2]) -> Vec<Line> {
        let mut text = Vec::new();
        for side in &mut sides {
            side.reverse();
        }
        let whole = self.choices.chance(40);
        let b_first = self.choices.chance(35);
        let mut next = usize::from(b_first);
        while sides.iter().any(|side| !side.is_empty()) {
            if self.choices.chance(6) {
                self.empty_portion(&mut text);
            }
            text.push(self.selection(if next == 0 { Side::A } else { Side::B }));
            let count = if whole { sides[next].len() } else { 1 + self.choices.below(12) };
            for _ in 0..count {
                text.extend(sides[next].pop());
            }
            let other = 1 - next;
            if !sides[other].is_empty() && (sides[next].is_empty() || !self.choices.chance(12)) {
                next = other;
            }
        }
        if self.choices.chance(8) {
            self.empty_portion(&mut text);
        }
        text
    }

    /// A selection block with nothing of a side behind it.
    fn empty_portion(&mut self, text: &mut Vec<Line>) {
        let side = if self.choices.chance(50) { Side::A } else { Side::B };
        text.push(self.selection(side));
        let line = self.choices.pick(&EMPTY);
        if self.whole.permits_text(line, crate::state::Mode::Rapid) {
            text.push(Line::Raw(line.to_vec()));
        }
        let skips = self.state.setup.switches.block_delete && self.choices.chance(50);
        if skips {
            let list: [&[u8]; 3] = [b"/G13", b"/G14", b"/G00 X5"];
            text.push(Line::Raw(self.choices.pick(&list).to_vec()));
        }
    }

    /// A selection block, with a slash that does not act or a name, which counts for nothing, now and then.
    fn selection(&mut self, side: Side) -> Line {
        let named = self.choices.chance(20) && self.allows(Feature::SequenceName);
        let sequence = named.then(|| self.choices.pick(&["1", "10", "A", "000", "100"]).to_owned());
        let delete = self.deletable();
        Line::Block(Block { delete, sequence, items: vec![Item::g(code(side))], ..Block::default() })
    }

    /// Gives blocks of side B names of side A now and then: each side has its own (E100L-AX4-03).
    pub(super) fn share_names(&mut self, sides: &mut [Vec<Line>; 2]) {
        let names = |lines: &[Line]| -> BTreeSet<String> { lines.iter().filter_map(name).collect() };
        let [a, b] = sides;
        let mut used = names(b);
        let known: Vec<String> = names(a).into_iter().collect();
        for line in b {
            let Line::Block(Block { sequence: Some(sequence), .. }) = line else { continue };
            if known.is_empty() || !self.choices.chance(30) {
                continue;
            }
            let wanted = &known[self.choices.below(known.len())];
            if used.insert(wanted.clone()) {
                sequence.clone_from(wanted);
            }
        }
    }
}

/// The sequence name of a line.
fn name(line: &Line) -> Option<String> {
    match line {
        Line::Block(block) => block.sequence.clone(),
        Line::Raw(_) => None,
    }
}
