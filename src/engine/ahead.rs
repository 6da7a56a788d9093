//! What look-ahead sees (execution, chapter 5): the next block, read and evaluated before its turn.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Place, Sink};

use super::Interpreter;
use super::block::{Before, OneShot};
use super::fault::Fault;
use super::planted::{self, Bug};
use super::slot::Slot;
use super::task::Turn;
use super::thread;
use super::words::{Address, Words};

/// What a block needs from the next one.
#[derive(Clone, Copy, Debug)]
pub struct Need {
    /// Whether the block cuts a corner.
    pub chamfer: bool,
    /// Whether A is its only coordinate.
    pub only_angle: bool,
    /// Its place.
    pub place: Place,
    /// Whether it ends the contour to which it belongs.
    pub last: bool,
}

const ALLOWED: u64 = Address::set(&[Address::X, Address::Z, Address::A, Address::L, Address::F, Address::S]);
const CORNER: u64 = Address::set(&[Address::X, Address::Z, Address::A]);

impl Interpreter<'_> {
    /// Makes the next block (0) or the one after it (1) ready, in a motion mode.
    pub(super) fn look_ahead(
        &mut self,
        depth: usize,
        need: Need,
        motion: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        if self.ahead_count > depth {
            return Ok(());
        }
        let mut slot = self.spare.take().unwrap_or_default();
        let result = self.prepare(&mut slot, need, motion, sink);
        if let Some(place) = self.ahead.get_mut(depth) {
            self.spare = Some(std::mem::replace(place, slot));
        }
        self.ahead_count = depth + 1;
        result
    }

    fn prepare(
        &mut self,
        slot: &mut Slot,
        need: Need,
        motion: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let rule = if need.chamfer { ANG_05 } else { ANG_06 };
        let unfit = || Fault::new(AlarmName::AngleLookahead, rule);
        if need.last {
            self.fault_place = Some(need.place);
            return Err(unfit());
        }
        let found = self.read(slot, Turn::Ahead);
        self.fault_place = Some(if planted::is(Bug::AlarmOneBlockEarly) { need.place } else { slot.place });
        let found = found?;
        let defines = self.lap.defines();
        if found && defines {
            self.admit_parsed(&slot.parsed)?;
        }
        let control = slot.parsed.control.filter(|_| found);
        if let Some(control) = control.filter(|control| !control.is_transfer()) {
            return Err(Fault::about(AlarmName::Unspecified, rule, control.word()));
        }
        if !found || slot.parsed.has_assignment || control.is_some() || self.is_turret_block(&slot.parsed) {
            self.fault_place = Some(need.place);
            return Err(unfit());
        }
        self.evaluate(slot, sink)?;
        if defines {
            self.admit_words(&slot.parsed, &slot.words)?;
        }
        let words = &slot.words;
        // The needing block moves, so that nothing is left over of an ended compensation.
        let before = Before { motion, after_angle: need.only_angle, left_over: false };
        let plan = self.check(&slot.parsed, words, before)?;
        self.fault_place = Some(need.place);
        if need.chamfer && (plan.motion != 1 || plan.one_shot == OneShot::BeginConversion) {
            return Fault::raise(AlarmName::ChamferCorner, ANG_07);
        }
        if !is_fit(words, plan.motion, need, defines) {
            return Err(unfit());
        }
        self.fault_place = None;
        Ok(())
    }
}

/// Whether a block in a motion mode holds what a corner needs and nothing that disturbs it.
fn is_fit(words: &Words, motion: u16, need: Need, in_contour: bool) -> bool {
    // Behind a block with an angle alone a line may be a positioning or a length of thread too.
    let leg = thread::is_leg_mode(motion) && !need.chamfer;
    let codes = words.g_codes().iter().all(|code| match code {
        1 | 75 | 76 | 90 | 91 | 94 | 95 => true,
        0 | 34 | 35 => !need.chamfer,
        80 => in_contour,
        _ => false,
    });
    let complete = words.present() & CORNER == CORNER;
    let more = if in_contour { Address::E.bit() } else { 0 } | if leg { thread::LEG_WORDS } else { 0 };
    let allowed = words.present() & !(ALLOWED | more) == 0;
    (motion <= 1 || leg) && codes && allowed && words.has_any(CORNER) && (complete || !need.only_angle)
}
