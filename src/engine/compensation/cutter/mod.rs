//! Cutter radius compensation: G41 and G42 in the planes G17 and G119 (execution of contours, 9; E100L-CRC-05 to
//! E100L-CRC-18).
//!
//! Which motion waits, what is held behind it and where corners lie is as for the nose of a turning tool, in the plane
//! (p, q) for (z, x). Here is what differs: which motions count, what a block programs in the plane, and where the axes
//! go.

mod beside;
mod block;
mod check;
mod course;
mod legs;
mod motion;
mod place;

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, Angle, RuleSet, Sense};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::turn;
use crate::engine::contour::{POINT, face_point};
use crate::engine::planted::{self, Bug};
use crate::engine::state::{Amounts, C, X, Z};
use crate::engine::words::{Address, Words};

use super::waiting::Role;

/// The plane in which a cutter is compensated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Plane {
    /// G17: the face plane.
    Face,
    /// G119: the side plane.
    Side {
        /// Whether it is seen from inside.
        inner: bool,
    },
}

impl Plane {
    /// Whether the words of a motion block make it one of the plane; `converted`: in conversion mode.
    pub fn is_moved_by(self, words: &Words, converted: bool) -> bool {
        const FACE: u64 = Address::set(&[Address::X, Address::C]);
        const SIDE: u64 = Address::set(&[Address::Z, Address::C]);
        words.has_any(match self {
            Self::Face if converted => POINT,
            Self::Face => FACE,
            Self::Side { .. } => SIDE,
        })
    }

    /// A length on the cylinder as p, and p as that length.
    fn seen(self, around: i64) -> i64 {
        match self {
            Self::Side { inner: true } if !planted::is(Bug::CutterSideMirrored) => around.saturating_neg(),
            _ => around,
        }
    }

    /// The rules of a motion in compensation.
    fn rules(self) -> RuleSet {
        match self {
            Self::Face => const { RuleSet::of(&[CRC_05, CRC_06, CRC_14]) },
            Self::Side { .. } if planted::is(Bug::CutterDiameterUncited) => {
                const { RuleSet::of(&[CRC_05, CRC_07, CRC_14]) }
            }
            Self::Side { .. } => const { RuleSet::of(&[CRC_05, CRC_07, CRC_14, CRC_18]) },
        }
    }

    /// The same of a motion with its part in compensation.
    fn rules_of(self, role: Role) -> RuleSet {
        match role {
            Role::StartUp { .. } => self.rules().union(const { RuleSet::of(&[CRC_08, CRC_10]) }),
            _ => self.rules(),
        }
    }
}

/// A point of the plane, and the program coordinates there.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
struct Place {
    point: Spot,
    x: i64,
    z: i64,
    /// Within a turn.
    c: i64,
    /// In G119: as far as C has turned, whole turns included, from where it stood when compensation began.
    unwrapped: i64,
}

/// What a motion of the plane programs, with what was in force in its block.
#[derive(Clone, Copy, Debug)]
struct Programmed {
    motion: u16,
    place: Place,
    /// In G119: the length on the cylinder at which the block starts.
    from_u: i64,
    /// Program Z before, and the target if the block has a Z word.
    z: i64,
    z_target: Option<i64>,
    /// The angle in which the first axis of the face lies.
    axis: i64,
    /// M16.
    negative: bool,
    arc: Option<ProgrammedArc>,
    /// The rules of its words and its path.
    rules: RuleSet,
}

/// What an arc programs.
#[derive(Clone, Copy, Debug)]
struct ProgrammedArc {
    centre: Spot,
    /// That of the circle of the cutter centre.
    radius: i64,
    sense: Sense,
}

/// Cutter compensation in force.
#[derive(Debug)]
pub struct Cutter {
    plane: Plane,
    /// Machine coordinates less program coordinates of X, Z and C when it began.
    frame: [i64; 3],
    /// Program C when it began.
    from_c: i64,
    /// All programmed travels of C since.
    turned: i64,
    /// Where the cutter centre is.
    at: Place,
    /// From the programmed point of the last motion that ended to the cutter centre.
    displacement: Place,
    /// What the motion programs that waits.
    programmed: Option<Programmed>,
}

impl Cutter {
    /// Moves a motion of other axes that was held to where the cutter is.
    pub fn displace(&self, action: &mut Action) {
        let (Action::Rapid { motion } | Action::Linear { motion, .. }) = action else { return };
        let by = if planted::is(Bug::CutterHeldMotion) { Place::default() } else { self.displacement };
        motion.machine.x.0 = motion.machine.x.0.saturating_add(by.x);
        motion.machine.z.0 = motion.machine.z.0.saturating_add(by.z);
        if let Some(tip) = &mut motion.tip {
            tip.x.0 = tip.x.0.saturating_add(by.x);
            tip.z.0 = tip.z.0.saturating_add(by.z);
        }
        for Angle(angle) in [&mut motion.machine.c, &mut motion.tip_c].into_iter().flatten() {
            *angle = turn::within(angle.saturating_add(by.c));
        }
        if self.plane == Plane::Face {
            motion.face_tip = Some(face_point(self.at.point));
        }
    }
}

impl Interpreter<'_> {
    /// Compensation begins: of a cutter, if its plane is not that of turning.
    /// A plane code of the block itself has been selected by now, wherever it stands (E100L-CRC-11).
    pub(super) fn begin_with_cutter(&mut self) {
        let plane = match self.state.plane {
            17 => Plane::Face,
            119 => Plane::Side { inner: self.is_seen_from_inside() },
            _ => return,
        };
        let from_c = self.state.program(C);
        let cutter = Cutter {
            plane,
            frame: self.cutter_frame(),
            from_c,
            turned: 0,
            at: Place::default(),
            displacement: Place::default(),
            programmed: None,
        };
        self.compensation.cutter = Some(Box::new(cutter));
    }

    /// Machine coordinates less program coordinates of X, Z and C.
    fn cutter_frame(&self) -> [i64; 3] {
        [X, Z, C].map(|axis| self.state.frame(axis))
    }

    /// Where an axis position of the programmed point becomes that of a place: the programmed point of a motion lies at
    /// `machine` and at `programmed`.
    fn machine_of(machine: &Amounts, programmed: &Place, place: &Place) -> Amounts {
        let mut moved = *machine;
        moved[X] = moved[X].saturating_add(place.x.saturating_sub(programmed.x));
        moved[Z] = moved[Z].saturating_add(place.z.saturating_sub(programmed.z));
        moved[C] = turn::within(moved[C].saturating_add(place.c.saturating_sub(programmed.c)));
        moved
    }
}

#[cfg(test)]
mod chance;
#[cfg(test)]
mod tests;
