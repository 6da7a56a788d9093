//! Set-ups of programs with contours.

use turnspec_oracle::vocabulary::{ConversionZeroShift, Setup, SidePlane};

use crate::choices::Choices;

/// Draws the parameters of contours and of coordinate conversion.
pub(crate) fn set_up(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    let parameters = &mut setup.parameters;
    parameters.centre_override = choices.pick(&[100, 100, 25, 50, 150, 1, 1_000, 33]);
    parameters.side_plane = choices.pick(&[SidePlane::Outer, SidePlane::Inner]);
    parameters.side_contour_mode = choices.chance(50);
    parameters.conversion_zero_shift =
        choices.pick(&[ConversionZeroShift::Included, ConversionZeroShift::Excluded]);
}

/// Whether a set-up differs from the default one in them.
pub(crate) fn is_set_up(setup: &Setup) -> bool {
    let (these, plain) = (&setup.parameters, Setup::default().parameters);
    these.centre_override != plain.centre_override
        || these.side_plane != plain.side_plane
        || these.side_contour_mode != plain.side_contour_mode
        || these.conversion_zero_shift != plain.conversion_zero_shift
}
