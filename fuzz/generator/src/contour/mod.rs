//! Contours with the C axis and coordinate conversion: what the generator believes of them, and which blocks it writes.
//!
//! Contours come in runs: blocks that allow them ([`ready`]), a positioning, a number of lines and arcs, and what may stand
//! between them. On the face [`face`] writes lines and [`face_arc`] arcs by X and C, on the side [`side`] arcs by Z and C;
//! [`conversion`] goes from G137 to G136, where [`point`] leads to points by X and Y. [`plane`] has the points of a plane.

mod conversion;
mod face;
mod face_arc;
mod plane;
mod point;
mod ready;
mod setup;
mod side;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::profile::Profile;
use crate::program::Item;
use crate::state::{Axis, Mode, State};

pub(crate) use setup::{is_set_up, set_up};

/// What the generator believes of contours.
#[derive(Clone, Default, Debug)]
pub struct Contours {
    /// Whether M16 is in force.
    backward: bool,
    /// θ of conversion mode in micro-degrees, where it is in force.
    direction: Option<i64>,
    /// Whether a block has given a point since.
    given: bool,
    /// The point that was programmed last.
    kept: Option<Kept>,
}

/// A point in conversion mode, in nanometres, and what it became.
#[derive(Clone, Copy, Debug)]
struct Kept {
    point: [i64; 2],
    x: i64,
    c: i64,
    c_shift: i64,
}

impl Contours {
    /// Notes an M code.
    pub(crate) fn note_m(&mut self, code: i64) {
        if matches!(code, 15 | 16) {
            self.backward = code == 16;
        }
    }

    /// Whether conversion mode is in force.
    pub(crate) fn converts(&self) -> bool {
        self.direction.is_some()
    }

    /// Whether C turns in the negative direction.
    pub(crate) fn is_backward(&self) -> bool {
        self.backward
    }
}

impl State {
    /// The point of conversion mode that was programmed last, if the axes stand there (E100L-CSC-06).
    pub(crate) fn kept_point(&self) -> Option<[i64; 2]> {
        let near = |a: i64, b: i64| (a - b).abs() < 100;
        let kept = self.contours.kept?;
        let holds = near(kept.x, self.program(Axis::X)) && near(kept.c, self.program_c());
        (holds && kept.c_shift == self.c_shift).then_some(kept.point)
    }

    /// Moves C to a program coordinate, in micro-degrees.
    pub(crate) fn turn_to(&mut self, c: i64) {
        self.c = (c + self.c_offset + self.c_shift).rem_euclid(360_000_000);
    }
}

impl Mode {
    /// That of a contour code, or none after G137.
    pub(crate) fn of_contour(code: i64) -> Self {
        match code {
            101 => Self::FaceLine,
            102 => Self::FaceClockwise,
            103 => Self::FaceCounter,
            132 => Self::SideClockwise,
            133 => Self::SideCounter,
            _ => Self::None,
        }
    }

    /// Whether it is one of contours.
    pub(crate) fn is_contour(self) -> bool {
        (self as i64) > 100 && self != Self::None
    }
}

/// Whether a profile has something for contours.
pub(crate) fn is_within(profile: &Profile) -> bool {
    [Feature::ContourGeneration, Feature::CAxis, Feature::Feed, Feature::Rapid]
        .iter()
        .all(|feature| profile.allows(*feature))
}

impl Builder<'_, '_, '_> {
    /// A run of contours, or a positioning where none can be cut.
    pub(crate) fn contours(&mut self) {
        if !self.ready_for_contours() {
            return self.line(Mode::Rapid);
        }
        match self.choices.below(10) {
            0..=3 => self.face_run(),
            4..=6 => self.side_run(),
            _ => self.conversion_run(),
        }
        if self.choices.chance(45) && self.state.contours.direction.is_none() {
            self.begin();
            self.line(Mode::Rapid);
        }
    }

    /// A run on the face by X and C.
    fn face_run(&mut self) {
        if self.state.program(Axis::X) < 0 || self.choices.chance(60) {
            self.position_for_contour();
        }
        for _ in 0..=self.choices.below(6) {
            if self.choices.chance(15) {
                self.between_contours();
            }
            if !self.still_ready() {
                return;
            }
            let written = if self.choices.chance(55) {
                self.attempt(Self::face_line)
            } else {
                self.attempt(Self::face_arc)
            };
            if !written {
                self.position_for_contour();
            }
        }
    }

    /// A C word for a program coordinate, in micro-degrees, and the angle that is reached.
    pub(crate) fn c_word(&mut self, wanted: i64) -> (Item, i64) {
        let present = self.state.program_c();
        let base = if self.state.incremental { present } else { 0 };
        let mut travel = wanted - base;
        if travel != 0 && self.choices.chance(15) {
            travel -= 360_000_000 * travel.signum();
        }
        let (item, angle) = self.angle("C", travel);
        (item, (base + angle).rem_euclid(360_000_000))
    }
}
