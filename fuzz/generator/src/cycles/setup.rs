//! Set-ups of programs with cycles: their parameters and readings.

use turnspec_oracle::vocabulary::{
    ChipDischarge, CycleReturn, Feature, G184Tapping, KeywayReturn, Length, PeckRetract, Setup,
};

use crate::choices::Choices;
use crate::profile::Profile;

/// Retracts of pecks, in nanometres.
const RETRACTS: &[i64] = &[100_000, 100_000, 500_000, 0, 333_000, 2_000_000, 99_999_000];

/// Draws the parameters and readings of cycles.
pub(crate) fn set_up(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    let parameters = &mut setup.parameters;
    if profile.allows(Feature::Grooving) {
        parameters.grooving_retract = Length(choices.pick(RETRACTS));
    }
    if super::has_driven(profile) {
        parameters.drilling_retract = Length(choices.pick(RETRACTS));
        parameters.cycle_return = choices.pick(&[CycleReturn::CuttingStart, CycleReturn::CycleStart]);
        parameters.g184_tapping =
            choices.pick(&[G184Tapping::Floating, G184Tapping::Floating, G184Tapping::Synchronised]);
    }
    if !profile.allows_readings() {
        return;
    }
    let readings = &mut setup.readings;
    readings.peck_retract = choices.pick(&[PeckRetract::Diameter, PeckRetract::Radius]);
    readings.chip_discharge = choices.pick(&[ChipDischarge::CuttingStart, ChipDischarge::CycleStart]);
    readings.keyway_return = choices.pick(&[KeywayReturn::CuttingStart, KeywayReturn::Relief]);
}
