//! What a thread keeps from one block to the next.

use super::taper::Taper;
use crate::controls::e100l::g_codes::{GCode, GGroup, g_code};
use crate::modal::Words;

/// What goes on in the next block.
#[derive(Clone, Default, Debug)]
pub struct Kept {
    /// The cycle of G31, G32 or G33, once its first block was carried out.
    pub cycle: Option<Cycle>,
    /// Whether a run of G34 and G35 has begun (E100L-G34-05).
    pub chain: bool,
}

/// The data of a cycle of G31, G32 or G33 (E100L-G33-03, E100L-G32-04), in nanometres.
#[derive(Clone, Copy, Debug)]
pub struct Cycle {
    /// X, as a program coordinate.
    pub x: i64,
    /// Z, as a program coordinate.
    pub z: i64,
    /// The taper.
    pub taper: Taper,
    /// The shift of the start (E100L-G33-07).
    pub shift: i64,
    /// L.
    pub chamfer: Option<i64>,
    /// E, in picometres per revolution.
    pub change: i64,
    /// C of the first block, in micro-degrees (E100L-G33-10).
    pub start_angle: i64,
    /// How many passes were cut.
    pub passes: u32,
}

impl Kept {
    /// The G codes of a block act. E100L-G33-03: any code of the motion group ends a cycle. E100L-G34-05: another
    /// motion mode ends a run of G34 and G35.
    pub fn select(&mut self, words: &Words, motion: u16) {
        if has_motion_code(words) {
            self.cycle = None;
        }
        self.chain &= matches!(motion, 34 | 35);
    }
}

/// Whether a block has a code of the motion group.
pub fn has_motion_code(words: &Words) -> bool {
    words.g.iter().any(|code| g_code(*code) == GCode::Modelled(GGroup::Motion))
}
