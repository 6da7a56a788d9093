//! Which MODIN modes a motion calls (E100L-MODIN-07, E100L-MODIN-08). Any numbers.

/// The number of the last mode that is called, 0 if none is: of all that are active, or of those before the one
/// within whose call the motion stands.
#[must_use]
pub fn last_to_call(active: usize, within: Option<usize>) -> usize {
    within.map_or(active, |mode| mode.saturating_sub(1))
}
