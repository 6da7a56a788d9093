//! Set-ups of programs with threads: readings and parameters of thread cutting.

use turnspec_oracle::vocabulary::{BalancedInfeed, Setup, TaperReference, ThreadFlank, ThreadShift};

use crate::choices::Choices;
use crate::profile::Profile;

/// Draws the readings and parameters of thread cutting.
pub(crate) fn set_up(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    setup.parameters.thread_chamfer_feed = choices.pick(&[640, 640, 320, 100, 2_000, 1, 9_999, 333]);
    setup.parameters.m75_pattern = choices.pick(&[3, 3, 4]);
    if !profile.allows_readings() {
        return;
    }
    let readings = &mut setup.readings;
    readings.taper_reference = choices.pick(&[TaperReference::Start, TaperReference::End]);
    readings.thread_shift = choices.pick(&[ThreadShift::TowardEnd, ThreadShift::Coordinate]);
    readings.thread_flank = choices.pick(&[ThreadFlank::Negative, ThreadFlank::Positive]);
    readings.balanced_infeed = choices.pick(&[BalancedInfeed::Refused, BalancedInfeed::EqualArea]);
}
