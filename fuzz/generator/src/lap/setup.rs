//! Set-ups of programs with LAP.

use turnspec_oracle::vocabulary::{BalancedInfeed, ContourFeed, FeedLength, Setup};

use crate::choices::Choices;
use crate::profile::Profile;

/// Draws the level, the parameters and the readings of LAP.
pub(crate) fn set_up(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    let fewer = if profile.allows(turnspec_oracle::vocabulary::Feature::Alarm) { 4 } else { 0 };
    setup.options.lap = choices.weighted(&[(82, 4), (14, 3), (fewer, 0)]);
    let parameters = &mut setup.parameters;
    parameters.lap_relief = choices.pick(&[100, 100, 100, 0, 500, 1, 2_500, 9_999]);
    parameters.lap_clearance = choices.pick(&[2_000, 2_000, 2_000, 0, 500, 5_000, 1, 30_000]);
    if profile.allows_readings() {
        let readings = &mut setup.readings;
        readings.contour_feed = choices.pick(&[ContourFeed::Kept, ContourFeed::Call]);
        readings.feed_length = choices.pick(&[FeedLength::Radius, FeedLength::Diameter]);
        readings.balanced_infeed = choices.pick(&[BalancedInfeed::Refused, BalancedInfeed::EqualArea]);
    }
}

/// Whether a set-up differs from the default one in them.
pub(crate) fn is_set_up(setup: &Setup) -> bool {
    let plain = Setup::default();
    setup.options.lap != plain.options.lap
        || setup.parameters.lap_relief != plain.parameters.lap_relief
        || setup.parameters.lap_clearance != plain.parameters.lap_clearance
}
