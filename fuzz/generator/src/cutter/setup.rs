//! Set-ups of programs with cutter radius compensation.

use turnspec_oracle::vocabulary::{Length, NoseRadius};

use crate::choices::Choices;
use crate::state::State;

/// The numbers of the entries of cutters; those of noses are lower.
pub(super) const CUTTERS: std::ops::RangeInclusive<u8> = 5..=8;

/// Adds entries of cutters, small and large, with X and Z of any sign, and sometimes unequal.
pub(crate) fn set_up(state: &mut State, choices: &mut Choices<'_, '_>) {
    state.setup.options.nose_radius_compensation = true;
    for number in CUTTERS {
        let radius = choices.weighted(&[
            (24, 5_000_000),
            (20, 2_000_000),
            (14, 1_000_000),
            (8, 500_000),
            (10, 10_000_000),
            (8, 4_000_000),
            (3, 1_000),
            (13, 0),
        ]);
        let radius = if radius == 0 { choices.within(0, 12_700) * 1_000 } else { radius };
        let signs = choices.pick(&[(1, 1), (1, 1), (-1, 1), (1, -1), (-1, -1)]);
        let other = if choices.chance(15) { choices.within(0, radius / 1_000) * 1_000 } else { radius };
        let (x, z) = if choices.chance(50) { (radius, other) } else { (other, radius) };
        let (x, z) = (signs.0 * x, signs.1 * z);
        state.setup.nose_radius.retain(|entry| entry.number != number);
        state.setup.nose_radius.push(NoseRadius { number, x: Length(x), z: Length(z) });
        state.compensation.radii.insert(number, [x, z]);
    }
}
