//! Blocks at which a side of a program waits: a block of the usual kinds, with P, M100 and common words.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::{ATTEMPTS, Builder, Kind};
use crate::number::Number;
use crate::program::{Item, Line};

use super::plan::Stop;

/// Kinds of blocks that can be a stop; the first is one of the words alone.
const KINDS: &[(usize, Option<Kind>)] = &[
    (26, None),
    (18, Some(Kind::Rapid)),
    (18, Some(Kind::Linear)),
    (9, Some(Kind::Arc)),
    (6, Some(Kind::Dwell)),
    (8, Some(Kind::Modes)),
];

impl Builder<'_, '_, '_> {
    /// The block of a stop.
    pub(super) fn stop_block(&mut self, stop: &Stop) {
        let expressions = self.expressions;
        let kind = self.kind_of_stop(stop);
        self.expressions = 0;
        let at = self.lines.len();
        let shifts = stop.common.iter().any(|item| matches!(item, Item::Word(word) if word.is_g(&[50])));
        match kind {
            _ if stop.at_end => self.end_block(),
            _ if shifts => self.shift_block(),
            Some(kind) => {
                self.within_profile(ATTEMPTS, |builder| {
                    builder.begin();
                    builder.fitting(|builder| builder.block_of(kind));
                    true
                });
            }
            None => {}
        }
        self.expressions = expressions;
        let words = self.words_of_stop(stop);
        let is_block = |line: &Line| matches!(line, Line::Block(block) if block.statement.is_none() && !block.items.is_empty());
        let place = self.lines.iter().skip(at).position(is_block);
        let Some(Line::Block(block)) = place.and_then(|place| self.lines.get_mut(at + place)) else {
            return self.push_whole(&words);
        };
        for word in words {
            let place = self.choices.below(block.items.len() + 1);
            block.items.insert(place, word);
        }
    }

    /// The kind of the block, behind what has to stand in front of it: neither P, where the side waits, nor M100 may
    /// stand in compensation (E100L-PSYNC-09, E100L-M100-04).
    fn kind_of_stop(&mut self, stop: &Stop) -> Option<Kind> {
        let waits = stop.p.is_some() && !stop.passed;
        let plain = stop.common.is_empty() && !stop.at_end;
        let compensation = &self.state.compensation;
        if compensation.is_on() && !compensation.has_to_go_on() && stop.m100 && !waits && plain {
            return Some(Kind::Cancel);
        }
        if waits || stop.m100 {
            self.out_of_compensation();
        }
        if self.state.compensation.is_on() {
            return Some(Kind::ContourLine);
        }
        if plain && !stop.m100 && self.choices.chance(14) && self.allows(Feature::RadiusCompensation) {
            return Some(Kind::StartUp);
        }
        let list: Vec<_> = KINDS
            .iter()
            .copied()
            .filter(|(_, kind)| kind.is_none_or(|kind| kind.is_within(&self.profile)))
            .collect();
        self.choices.weighted(&list)
    }

    /// The block that ends the side.
    fn end_block(&mut self) {
        self.begin();
        let code = if self.choices.chance(30) { 30 } else { 2 };
        self.push_whole(&[Item::m(code)]);
    }

    /// A block of these words, with what the whole program may need.
    fn push_whole(&mut self, items: &[Item]) {
        let profile = std::mem::replace(&mut self.profile, self.whole);
        self.within_profile(ATTEMPTS, |builder| {
            builder.push(items.to_vec());
            true
        });
        self.profile = profile;
    }

    /// A zero shift, now and then, in the block of a clamp of G50.
    fn shift_block(&mut self) {
        if self.choices.chance(30) && self.allows(Feature::ZeroShift) && !self.state.compensation.is_on() {
            self.within_profile(ATTEMPTS, |builder| {
                builder.begin();
                let mut items = Vec::new();
                builder.shift_words(&mut items);
                builder.push(items);
                true
            });
        }
    }

    /// P, M100 and the common words.
    fn words_of_stop(&mut self, stop: &Stop) -> Vec<Item> {
        let mut words = stop.common.clone();
        if let Some(p) = stop.p {
            self.begin();
            words.push(if p > 0 && self.choices.chance(4) {
                Item::plain("P", Number::decimal(10 * p - 4, 1))
            } else {
                self.whole("P", p)
            });
        }
        if stop.m100 {
            words.push(Item::m(100));
        }
        self.choices.shuffle(&mut words);
        words
    }
}
