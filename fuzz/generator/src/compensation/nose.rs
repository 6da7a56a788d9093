//! Noses: the entries of set-ups, and which of them a T word selects.

use turnspec_oracle::vocabulary::{Feature, Length, NoseRadius};

use crate::builder::Builder;
use crate::choices::Choices;
use crate::program::Item;

/// The nine positions of a tip about its nose: signs of X and Z.
const TIPS: [(i64, i64); 9] = [(1, 1), (1, 0), (1, -1), (0, 1), (0, 0), (0, -1), (-1, 1), (-1, 0), (-1, -1)];

/// Entries 1 to 4, one or more of them missing now and then, and sometimes one of a high number.
pub(crate) fn nose_radii(choices: &mut Choices<'_, '_>, sets: u8) -> Vec<NoseRadius> {
    let mut entries = Vec::new();
    for number in [1, 2, 3, 4, sets] {
        if choices.chance(if number == sets { 15 } else { 80 }) {
            let radius = choices.weighted(&[
                (30, 800_000),
                (20, 400_000),
                (10, 200_000),
                (10, 1_200_000),
                (6, 5_000_000),
                (2, 100_000_000),
                (4, 1_000),
                (18, 0),
            ]);
            let radius = if radius == 0 { choices.within(1, 3_000) * 1_000 } else { radius };
            let (x, z) = if choices.chance(60) { (1, 1) } else { choices.pick(&TIPS) };
            let other = if choices.chance(10) { choices.within(0, radius / 1_000) * 1_000 } else { radius };
            entries.push(NoseRadius { number, x: Length(x * radius), z: Length(z * other) });
        }
    }
    entries
}

impl Builder<'_, '_, '_> {
    /// A T word of six digits with a nose that has an entry.
    pub(crate) fn nose_word(&mut self) -> Option<Item> {
        let compensation = &mut self.state.compensation;
        let known: Vec<u8> = compensation.radii.keys().copied().filter(|number| *number > 0).collect();
        let allowed = self.profile.allows(Feature::Tool) && self.state.setup.options.nose_radius_compensation;
        if known.is_empty() || !allowed || self.state.control.steady {
            return None;
        }
        let nose = if self.choices.chance(90) { self.choices.pick(&known) } else { 0 };
        let offset = if self.choices.chance(70) { i64::from(nose.min(4)) } else { self.choices.within(0, 4) };
        let tool = self.choices.within(1, 12);
        compensation.nose = nose;
        self.state.offset = u8::try_from(offset).unwrap_or_default();
        self.state.tool = u8::try_from(tool).unwrap_or_default();
        Some(self.whole("T", i64::from(nose) * 10_000 + tool * 100 + offset))
    }
}

#[cfg(test)]
mod tests {
    use super::TIPS;

    #[test]
    fn every_position_of_the_tip_occurs_once() {
        let mut tips = TIPS.to_vec();
        tips.sort_unstable();
        tips.dedup();
        assert_eq!(tips.len(), 9);
    }
}
