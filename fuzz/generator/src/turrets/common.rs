//! Common words: commands of the one spindle, which both sides give together (E100L-AX4-06).

use turnspec_oracle::vocabulary::Feature;

use crate::choices::Choices;
use crate::profile::Profile;
use crate::program::Item;

use super::plan::{Plan, Release};

/// What common words need of a profile.
pub(super) const FEATURES: &[Feature] =
    &[Feature::Spindle, Feature::CuttingSpeed, Feature::Gear, Feature::OptionalStop, Feature::Turret];

impl Plan {
    /// Gives common words to stops that start together, and to those of a side that is alone.
    pub(super) fn give_words(&mut self, choices: &mut Choices<'_, '_>, profile: &Profile) {
        let mut cutting = false;
        for place in 0..self.sides[0].stops.len() {
            let here = &self.sides[0].stops[place];
            let Some(Release::Equal(there)) = here.release else { continue };
            let at_end = here.at_end || self.sides[1].stops[there].at_end;
            if choices.chance(62) {
                let common = words(choices, profile, &mut cutting, at_end);
                self.sides[1].stops[there].common.clone_from(&common);
                self.sides[0].stops[place].common = common;
            }
        }
        for stop in self.sides.iter_mut().flat_map(|side| &mut side.stops) {
            let alone = stop.passed || stop.release == Some(Release::Ended);
            if alone && choices.chance(35) {
                stop.common = words(choices, profile, &mut cutting, stop.at_end);
            }
        }
    }

    /// Makes the sides differ: other words on one of two blocks that start together, or a common word in a block that is
    /// let go alone. False when there is no such block.
    pub(super) fn make_differ(&mut self, choices: &mut Choices<'_, '_>, profile: &Profile) -> bool {
        let mut places = Vec::new();
        for (side, plan) in self.sides.iter().enumerate() {
            for (place, stop) in plan.stops.iter().enumerate() {
                if matches!(stop.release, Some(Release::Equal(_) | Release::Smaller)) {
                    places.push((side, place));
                }
            }
        }
        if places.is_empty() {
            return false;
        }
        let (side, place) = choices.pick(&places);
        let stop = &mut self.sides[side].stops[place];
        let before = spelled(&stop.common);
        match choices.below(5) {
            0 => drop(stop.common.pop()),
            2 if stop.common.iter().any(is_speed) => stop.common.push(Item::g(50)),
            1 => {
                for item in &mut stop.common {
                    if is_speed(item) {
                        *item = Item::whole("S", choices.pick(&[777, 778]));
                    }
                }
            }
            _ => stop.common = words(choices, profile, &mut false, stop.at_end),
        }
        if spelled(&stop.common) == before {
            stop.common = if stop.common.is_empty() { vec![Item::m(5)] } else { Vec::new() };
        }
        true
    }
}

fn is_speed(item: &Item) -> bool {
    matches!(item, Item::Word(word) if word.address == "S")
}

/// What tells words apart.
fn spelled(items: &[Item]) -> Vec<String> {
    items.iter().map(|item| format!("{item:?}")).collect()
}

/// Words of the spindle for one block.
fn words(choices: &mut Choices<'_, '_>, profile: &Profile, cutting: &mut bool, at_end: bool) -> Vec<Item> {
    let allows = |feature| profile.allows(feature);
    let mut items = Vec::new();
    if choices.chance(12) && allows(Feature::Spindle) {
        return vec![Item::g(50), Item::whole("S", choices.pick(&[1_500, 3_000, 100]))];
    }
    if choices.chance(28) && allows(Feature::CuttingSpeed) && allows(Feature::Spindle) {
        *cutting = choices.chance(65);
        items.push(Item::g(if *cutting { 96 } else { 97 }));
        items.push(speed(choices, *cutting));
    } else if choices.chance(55) && allows(Feature::Spindle) {
        items.push(speed(choices, *cutting));
    }
    if choices.chance(30) && allows(Feature::Turret) {
        items.push(Item::g(choices.within(110, 111)));
    }
    if choices.chance(50) && allows(Feature::Spindle) {
        items.push(Item::m(choices.pick(&[3, 3, 4, 5, 19])));
    }
    if choices.chance(22) && allows(Feature::Gear) && allows(Feature::Spindle) {
        items.push(Item::m(choices.within(40, 44)));
    }
    if choices.chance(12) && allows(Feature::OptionalStop) && !at_end {
        items.push(Item::m(choices.within(0, 1)));
    }
    items
}

fn speed(choices: &mut Choices<'_, '_>, cutting: bool) -> Item {
    let list = if cutting { [100, 180, 33, 600] } else { [500, 1_200, 3_000, 0] };
    Item::whole("S", choices.pick(&list))
}
