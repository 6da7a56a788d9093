//! Blocks that only move along a line or an arc while nothing else is in force: most blocks of most programs. Of the checks
//! of module `block` none but that of arcs can refuse them, so that the others are passed over all at once; builds with debug
//! assertions go through both.

use turnspec_oracle::vocabulary::MachineType;

use super::Interpreter;
use super::block::{ALWAYS, ARC_TAKES, OneShot, Plan, check_arc};
use super::codes::GGroup;
use super::compensation::Change;
use super::cycle::CycleBlock;
use super::fault::Fault;
use super::words::{Address, Words};

/// The groups of codes that a plain block may have.
const GROUPS: u16 = GGroup::set(&[GGroup::Motion, GGroup::Dimension, GGroup::FeedUnit]);
/// What lets a line move, and an arc; and the words that each may have.
const LINE: u64 = Address::set(&[Address::X, Address::Z]);
const LINE_WORDS: u64 = LINE | ALWAYS;
const ARC_WORDS: u64 = (ARC_TAKES | ALWAYS) & !Address::Calrg.bit();

fn is_arc(motion: u16) -> bool {
    matches!(motion, 2 | 3)
}

impl Interpreter<'_> {
    /// Whether a block in a motion mode is plain; a displacement of ended compensation may be left over before it.
    #[inline]
    pub(super) fn is_plain(&self, words: &Words, motion: u16, left_over: bool) -> bool {
        let takes = if is_arc(motion) { ARC_WORDS } else { LINE_WORDS };
        let written = motion <= 3 && words.present() & !takes == 0 && !words.has_codes_beyond(GROUPS);
        let state = &self.state;
        written
            && (state.compensation == 40 || state.plane == 18)
            && !left_over
            && !state.cycle.concerns(words)
            && !state.contour.converts()
            && !self.lap.is_active()
            && self.setup.machine.r#type != MachineType::TwoTurrets
    }
}

/// What a plain block will do.
#[inline]
pub fn plain_plan(words: &Words, motion: u16) -> Result<Plan, Fault> {
    let arc = is_arc(motion);
    let moves = words.has_any(if arc { ARC_TAKES } else { LINE });
    if arc && moves {
        check_arc(words)?;
    }
    let (compensation, cycle) = (Change::None, CycleBlock::None);
    Ok(Plan { one_shot: OneShot::None, motion, moves, only_angle: false, compensation, cycle })
}
