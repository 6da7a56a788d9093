//! What a block does in compensation besides its motion: beginning, ending, counting blocks without X/Z
//! motion (E100L-NRC-14, E100L-NRC-20, E100L-NRC-43, E100L-NRC-44, E100L-NRC-66, E100L-NRC-71).

use turnspec_oracle::vocabulary::rule_ids::{CRC_14, CTL_01};
use turnspec_oracle::vocabulary::{AlarmName, Label, ReadingSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::idle::IdleBlocks;
use crate::engine::arithmetic::plane::Direction;
use crate::engine::cite::{self, Cites};
use crate::engine::fault::Fault;
use crate::engine::motion::{Element, Kind};
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Address, Words};

use super::waiting::{Next, Role, Waiting, undefined};
use super::{Change, Compensation, Phase};

/// How many statements may come behind a motion that waits (E100L-CTL-01).
const MOST_STATEMENTS: u8 = 100;

impl Compensation {
    /// A block begins.
    pub fn begin_block(&mut self) {
        self.moved = false;
        self.holding = self.phase == Phase::On;
    }
}

impl Interpreter<'_> {
    /// The block in progress comes to its motion, with what its words do to compensation.
    pub(in crate::engine) fn change_compensation(&mut self, change: Change, words: &Words) {
        self.compensation.phase = match change {
            Change::None => return,
            Change::Begins => {
                self.begin_with_cutter();
                Phase::Starting
            }
            Change::Ends => Phase::Ending,
        };
        self.compensation.imaginary = imaginary(words);
    }

    /// A block that begins or ends compensation and had no motion of its own.
    pub(in crate::engine) fn complete_change(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        match self.compensation.phase {
            Phase::Starting if planted::is(Bug::StartUpWithoutWords) => Ok(()),
            Phase::Starting => {
                let kind = if self.state.motion == 0 { Kind::Rapid } else { Kind::Linear };
                let cites = self.line_cites(Cites::default()).and_if(self.inch_block, cite::INCH_02);
                let (x, z, w, c) = (None, None, None, None);
                let readings = ReadingSet::default();
                self.perform_placed(Element { kind, x, z, w, c, cites, readings, limited: false }, sink)
            }
            Phase::Ending => self.cancel(false, sink),
            _ => Ok(()),
        }
    }

    /// In the block that ends compensation, when its own tests have been passed.
    pub(in crate::engine) fn cancel_before_dwell(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        if self.compensation.phase == Phase::Ending { self.cancel(false, sink) } else { Ok(()) }
    }

    /// Ends compensation, before a motion in X or Z or without one.
    pub(super) fn cancel(&mut self, moves: bool, sink: &mut impl Sink) -> Result<(), Fault> {
        let imaginary = self.compensation.imaginary;
        self.end_waiting(Next::Cancel { moves, imaginary }, sink)?;
        self.release(sink);
        self.compensation.holding = false;
        self.compensation.extra = None;
        self.compensation.phase = if moves { Phase::Ended } else { Phase::LeftOver };
        Ok(())
    }

    /// The program ends: the waiting motion too.
    pub(in crate::engine) fn complete_compensation(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        self.end_waiting(Next::ProgramEnd, sink)?;
        self.release(sink);
        self.compensation.holding = false;
        Ok(())
    }

    /// A block that does not end the program is done.
    pub(in crate::engine) fn finish_block(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        match self.compensation.phase {
            Phase::Ended => self.compensation.phase = Phase::Off,
            Phase::On if !self.compensation.moved => return self.count_idle_block(sink),
            _ => {}
        }
        Ok(())
    }

    /// A statement comes: a waiting motion lets a limited number of them pass (E100L-CTL-01).
    pub(in crate::engine) fn let_statement_pass(&mut self) -> Result<(), Fault> {
        if self.compensation.waiting.is_none() {
            return Ok(());
        }
        if self.compensation.statements >= MOST_STATEMENTS {
            return Err(Fault::about(AlarmName::Unspecified, CTL_01, const { Label::new("statements") }));
        }
        self.compensation.statements += 1;
        Ok(())
    }

    /// A statement that is not counted is done (E100L-CTL-01).
    pub(in crate::engine) fn finish_statement(&mut self, sink: &mut impl Sink) {
        if self.compensation.waiting.is_none() {
            self.release(sink);
            self.compensation.holding = false;
        }
    }

    fn count_idle_block(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        let waits = self.compensation.waiting.is_some();
        self.compensation.idle_blocks = self.compensation.idle_blocks.more(waits);
        if self.compensation.idle_blocks == IdleBlocks::One && !planted::is(Bug::FirstIdleBlock) {
            return Ok(());
        }
        if self.compensation.is_of_cutter() && !planted::is(Bug::CutterWaits) {
            return Err(undefined(CRC_14, "waiting"));
        }
        self.end_waiting(Next::IdleBlocks, sink)?;
        self.release(sink);
        self.compensation.extra = Some(self.extra_motion());
        Ok(())
    }

    /// The return to the corner that the block in progress would make; it has none of its words (E100L-NRC-46).
    fn extra_motion(&mut self) -> Waiting {
        let rapid = self.state.motion == 0;
        let (kind, feed) = if rapid { (Kind::Rapid, None) } else { (Kind::Linear, Some(self.feed())) };
        let (feed, refusal) = match feed.transpose() {
            Ok(feed) => (feed, None),
            Err(fault) => (None, Some(fault)),
        };
        let cites = self.line_cites(cite::NRC_46);
        let here = self.state.machine;
        let way = (&here, &here, None);
        Waiting {
            refusal,
            ..self.waiting_motion(Role::Return, (kind, feed), way, cites, ReadingSet::default())
        }
    }

    /// The rules of a line that its block has no words for.
    fn line_cites(&self, cites: Cites) -> Cites {
        let cites = cites.and(self.lap.cites()).and(cite::COORD_03).and(if self.state.incremental {
            cite::ABS_02
        } else {
            cite::ABS_01
        });
        if self.state.motion == 0 {
            cites.and(cite::G00_01)
        } else {
            cites.and(self.feed_cites()).and(cite::G01_01).and(cite::G01_02)
        }
    }
}

/// The imaginary line that I and K give, from the programmed point on, in half nanometres (E100L-NRC-24,
/// E100L-NRC-70).
fn imaginary(words: &Words) -> Option<Direction> {
    let (i, k) = (words.get(Address::I), words.get(Address::K));
    let half = |value: Option<i64>| 2 * i128::from(value.unwrap_or_default());
    (i.is_some() || k.is_some()).then(|| (half(k), half(i)))
}
