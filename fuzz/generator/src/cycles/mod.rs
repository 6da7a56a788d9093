//! Grooving, drilling and tapping cycles, and cycles of driven tools: what the generator believes of them, and which
//! blocks it writes.
//!
//! [`groove`] writes G73 and G74, [`tap`] G77 and G78, each in one block. [`driven`] writes a whole run of a cycle of
//! driven tools, from the blocks that allow it ([`ready`]) to G180 and the positioning behind it: [`hole`] holes, taps
//! and slots, [`points`] holes in conversion mode, [`helix`] threads of the C axis. [`between`] writes what may stand among their blocks, [`way`] foresees
//! their motions, [`words`] writes what all have in common.

mod between;
mod driven;
mod groove;
mod helix;
mod hole;
mod points;
mod ready;
mod setup;
mod tap;
mod way;
mod words;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::profile::Profile;
use crate::state::Mode;

use helix::Helix;
use hole::Hole;
pub(crate) use setup::set_up;

/// What the generator believes of cycles.
#[derive(Clone, Default, Debug)]
pub struct Cycles {
    /// Whether a cycle of driven tools is in force.
    mode: bool,
    /// Whether M16 is in force.
    backward: bool,
    /// The hole cycle that is in force.
    hole: Option<Hole>,
    /// The thread cycle that is in force.
    helix: Option<Helix>,
}

impl Cycles {
    /// Notes an M code.
    pub(crate) fn note_m(&mut self, code: i64) {
        if matches!(code, 15 | 16) {
            self.backward = code == 16;
        }
    }

    /// Whether a cycle of driven tools is in force, whose blocks trigger no modal calls.
    pub(crate) fn is_on(&self) -> bool {
        self.mode
    }
}

/// Whether a profile has something for cycles.
pub(crate) fn is_within(profile: &Profile) -> bool {
    has_motions(profile) && (profile.allows(Feature::Grooving) || has_driven(profile))
}

fn has_motions(profile: &Profile) -> bool {
    [Feature::Feed, Feature::Rapid, Feature::Linear].iter().all(|feature| profile.allows(*feature))
}

fn has_driven(profile: &Profile) -> bool {
    [Feature::DrivenCycle, Feature::CAxis, Feature::MTool].iter().all(|feature| profile.allows(*feature))
}

impl Builder<'_, '_, '_> {
    /// A cycle, or a positioning where there can be none.
    pub(crate) fn cycle(&mut self) {
        let grooves = self.allows(Feature::Grooving);
        match self.choices.below(20) {
            0..=4 if grooves => self.grooves(),
            5..=7 if grooves => self.taps(),
            _ if self.may_drive() => self.driven(),
            _ if grooves => self.grooves(),
            _ => self.line(Mode::Rapid),
        }
    }
}
