//! One of two saddles: what tells it from a machine with one, and where its blocks stop (execution of two saddles,
//! "A side runs").

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Label, Place, ReleaseCause, RuleId, RuleSet, Setup, Side, Sink,
};

use crate::engine::Interpreter;
use crate::engine::block::Plan;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::slot::Slot;
use crate::engine::state::{State, X, Z};
use crate::engine::words::{Address, Words};

use super::{nose_radii, tool_offsets};

/// Where a side waits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stop {
    /// At a P.
    P(u16),
    /// At M100.
    M100,
}

/// What a side can do.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Status {
    /// It goes on.
    #[default]
    Ready,
    /// It waits.
    At(Stop),
    /// Its program is at its end.
    Ended,
}

/// Who carries out the common words of a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Common {
    /// This side alone.
    #[default]
    Own,
    /// This side, for both.
    ForBoth,
    /// The other side has done it.
    Done,
}

/// How far the block is that waits.
#[derive(Clone, Copy, Debug, Default)]
enum Resume {
    /// Nothing waits.
    #[default]
    Nothing,
    /// The block comes to its checks.
    Checks,
    /// The block has only step 8 left.
    Last(Plan),
}

/// What a side has besides its state.
#[derive(Debug, Default)]
pub struct SideRun {
    pub status: Status,
    /// Whether the other side is at its end and has released this one.
    pub alone: bool,
    pub common: Common,
    resume: Resume,
    /// The last block that counts.
    pub last: Place,
    /// M02 or M30, with which the program has ended; 0 without.
    pub code: u16,
}

impl State {
    /// The state of a side at power-on.
    pub fn of_side(setup: &Setup, side: Side) -> Self {
        let mut state = Self::new(setup);
        state.selected = side;
        if side == Side::B {
            let b = &setup.turret_b;
            for (axis, start, offset, limit) in
                [(X, b.start.x, b.zero_offset.x, b.limits.x), (Z, b.start.z, b.zero_offset.z, b.limits.z)]
            {
                state.machine[axis] = start.0;
                state.zero_offset[axis] = offset.0;
                state.positive_limits[axis] = limit.positive.map(|limit| limit.0);
                state.negative_limits[axis] = limit.negative.map(|limit| limit.0);
            }
            state.tool_offsets = tool_offsets(&b.tool_offset);
            state.nose_radii = nose_radii(&b.nose_radius);
        }
        state
    }

    /// Takes over what both sides have in common from the side that ran last.
    pub fn take_common(&mut self, other: &Self) {
        self.spindle = other.spindle;
        self.speed = other.speed;
        self.surface = other.surface;
        self.clamp = other.clamp;
        self.gear = other.gear;
        self.constant_speed = other.constant_speed;
        self.speed_side = other.speed_side;
        self.other_x = other.program(X);
    }
}

/// The common words of a block: S, whether with G50, and which codes of the list.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CommonWords {
    speed: Option<(i64, bool)>,
    codes: u32,
}

impl CommonWords {
    /// Those of a block (E100L-AX4-06).
    pub fn of(words: &Words) -> Self {
        const G: [u16; 4] = [96, 97, 110, 111];
        const M: [u16; 11] = [0, 1, 3, 4, 5, 19, 40, 41, 42, 43, 44];
        let flags = G.map(|code| words.has_g(code)).into_iter().chain(M.map(|code| words.has_m(code)));
        let codes = flags.zip(0..).filter(|(has, _)| *has).map(|(_, bit)| 1 << bit).sum();
        let clamp = words.has_g(50) && !planted::is(Bug::SWithoutG50);
        Self { speed: words.get(Address::S).map(|speed| (speed, clamp)), codes }
    }

    /// Whether there are any.
    pub fn any(self) -> bool {
        self.speed.is_some() || self.codes != 0
    }
}

impl Interpreter<'_> {
    /// Whether the other side does not wait for this one any more; also on machines with one saddle.
    pub(in crate::engine) fn is_alone(&self) -> bool {
        self.side.as_ref().is_none_or(|side| side.alone)
    }

    /// Whether the program of this side is at its end.
    pub(in crate::engine) fn has_ended(&self) -> bool {
        self.side.as_ref().is_some_and(|side| side.status == Status::Ended)
    }

    /// Who carries out the common words of the block in progress.
    #[inline]
    pub(in crate::engine) fn common(&self) -> Common {
        self.side.as_ref().map_or(Common::Own, |side| side.common)
    }

    /// Whether the cutting speed refers to the other side (E100L-AX4-08).
    #[inline]
    pub(in crate::engine) fn speed_is_of_other(&self) -> bool {
        self.side.is_some() && self.state.speed_side != self.state.selected
    }

    /// The program X to which the cutting speed refers.
    pub(in crate::engine) fn reference_x(&self) -> i64 {
        if self.speed_is_of_other() && !planted::is(Bug::OwnReference) {
            self.state.other_x
        } else {
            self.state.program(X)
        }
    }

    /// The machine coordinates at which the torque skips of this side stop.
    pub(in crate::engine) fn torque_stop(&self) -> Option<i64> {
        let b = self.side.is_some() && self.state.selected == Side::B;
        let stops = if b { &self.setup.turret_b.torque_stops } else { &self.setup.inputs.torque_stops };
        stops.get(self.state.stops_used).map(|stop| stop.0)
    }

    /// A block that was read; the last one that counts is where the program ends.
    pub(in crate::engine) fn note_block(&mut self, slot: &Slot) {
        if let Some(side) = &mut self.side
            && !slot.parsed.is_only_name()
        {
            side.last = slot.place;
        }
    }

    /// A common word in a block without P, while the other side runs (E100L-AX4-07).
    pub(in crate::engine) fn check_common(&self, words: &Words) -> Result<(), Fault> {
        if self.is_alone() || words.has(Address::P) || !CommonWords::of(words).any() {
            return Ok(());
        }
        Fault::raise(AlarmName::SidesDiffer, AX4_07)
    }

    /// An evaluated block comes to its checks: with P it waits. Whether it does.
    pub(in crate::engine) fn stop_at_p(
        &mut self,
        words: &Words,
        sink: &mut impl Sink,
    ) -> Result<bool, Fault> {
        self.check_common(words)?;
        let Some(p) = words.get(Address::P).filter(|_| !self.is_alone()) else { return Ok(false) };
        if self.state.compensation != 40 {
            return Err(Fault::about(AlarmName::Unspecified, PSYNC_09, const { Label::new("compensation") }));
        }
        let stop = Stop::P(u16::try_from(p).unwrap_or(u16::MAX));
        self.wait(stop, Resume::Checks, PSYNC_02, sink);
        Ok(true)
    }

    /// A block comes to its last step: with M100 it waits. Whether it does.
    pub(in crate::engine) fn stop_at_m100(
        &mut self,
        words: &Words,
        plan: Plan,
        sink: &mut impl Sink,
    ) -> bool {
        let stops = words.has_m(100) && !self.is_alone();
        if stops {
            self.wait(Stop::M100, Resume::Last(plan), M100_01, sink);
        }
        stops
    }

    fn wait(&mut self, stop: Stop, resume: Resume, rule: RuleId, sink: &mut impl Sink) {
        let (p, code) = shown(stop);
        self.emit(sink, RuleSet::of(&[rule]), Action::Wait { p, code });
        if let Some(side) = &mut self.side {
            (side.status, side.resume) = (Status::At(stop), resume);
        }
    }

    /// The side goes on.
    pub(super) fn release_side(&mut self, cause: ReleaseCause, rule: RuleId, sink: &mut impl Sink) {
        let Some(side) = &mut self.side else { return };
        let Status::At(stop) = side.status else { return };
        side.status = Status::Ready;
        side.alone |= cause == ReleaseCause::OtherEnded && !planted::is(Bug::AloneWaits);
        let (p, code) = shown(stop);
        self.emit(sink, RuleSet::of(&[rule]), Action::Release { p, code, cause });
    }

    /// Goes on with the block that waited; false if none did.
    pub(in crate::engine) fn resume(&mut self, slot: &Slot, sink: &mut impl Sink) -> Result<bool, Fault> {
        let Some(side) = &mut self.side else { return Ok(false) };
        match std::mem::replace(&mut side.resume, Resume::Nothing) {
            Resume::Nothing => return Ok(false),
            Resume::Checks => self.carry_out(slot, sink)?,
            Resume::Last(plan) => self.carry_out_last(slot, plan, None, sink)?,
        };
        Ok(true)
    }

    /// The program of the side ends, with M02 or M30 or without (E100L-AX4-05).
    pub(in crate::engine) fn end_side(&mut self, code: u16, sink: &mut impl Sink) {
        let label = if code == 0 { Label::default() } else { Label::of_code(b'M', code) };
        self.emit(sink, const { RuleSet::of(&[AX4_05]) }, Action::SideEnd { code: label });
        if let Some(side) = &mut self.side {
            (side.status, side.code) = (Status::Ended, code);
        }
    }

    /// No block is left.
    pub(in crate::engine) fn run_out(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        if let Some(side) = &self.side {
            self.place = side.last;
        }
        if self.compensation.acts() {
            self.complete_compensation(sink)?;
        }
        self.end_side(0, sink);
        Ok(())
    }
}

/// How events show where a side waits.
fn shown(stop: Stop) -> (Option<u16>, Label) {
    match stop {
        Stop::P(p) => (Some(p), Label::default()),
        Stop::M100 => (None, const { Label::new("M100") }),
    }
}
