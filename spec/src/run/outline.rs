//! The definition that a call of LAP has read, as it can be looked at: the contour and its blank (E100L-LAP-01,
//! E100L-LAP-02).

use super::Run;
use crate::lap::{Recorded, Recording, Way};
use crate::vocabulary::{Length, PlanePosition, Sense};

/// The contour and the blank that a rough call of LAP has read, in the program coordinates of the call.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Outline {
    /// Which one of the run it is, from 1.
    pub number: u64,
    /// The motions of the contour, without allowance; in nose radius compensation those of the tip.
    pub contour: Vec<OutlineMotion>,
    /// The motions of the blank; nothing without one.
    pub blank: Vec<OutlineMotion>,
}

/// A motion of a contour or a blank. The first one leads to where it begins.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OutlineMotion {
    /// Its end.
    pub end: PlanePosition,
    /// Centre and sense of an arc.
    pub arc: Option<(PlanePosition, Sense)>,
}

impl Outline {
    pub(super) fn of(number: u64, recording: &Recording) -> Self {
        let motions = |recorded: &[Recorded]| recorded.iter().map(OutlineMotion::of).collect();
        Self {
            number,
            contour: motions(&recording.contour),
            blank: recording.blank.as_deref().map(motions).unwrap_or_default(),
        }
    }
}

impl OutlineMotion {
    fn of(recorded: &Recorded) -> Self {
        let position = |(x, z)| PlanePosition { x: Length(x), z: Length(z) };
        let arc = match recorded.kind {
            Way::Arc(centre, sense) => Some((position(centre), sense)),
            Way::Rapid | Way::Line | Way::Leg(_) => None,
        };
        Self { end: position(recorded.end), arc }
    }
}

impl Run<'_> {
    /// The definition that the last G85, G86 or G88 has read, from its first pass on.
    #[must_use]
    pub fn outline(&self) -> Option<&Outline> {
        self.channel().outline.as_deref()
    }
}
