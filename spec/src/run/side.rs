//! What a side of two saddles does: its blocks as on one saddle, and where it waits (E100L-PSYNC-02, E100L-PSYNC-04,
//! E100L-PSYNC-09, E100L-M100-01, E100L-AX4-05, E100L-AX4-07).

use super::channel::{Channel, Moved};
use super::reading::{Block, Content};
use super::statement::Carried;
use crate::compensation::Stream;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::modal::{self, Words};
use crate::saddle::CommonWords;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Label, Place, RuleSet, Side};

/// The program of a side.
pub struct SideProgram<'a> {
    /// Its blocks, and its saddle.
    pub channel: Channel<'a>,
    /// Whether it goes on.
    pub status: Status,
    /// The last block that counts of those that it has come to.
    last: Place,
    /// Its M02 or M30, and the block of it.
    pub ended_with: Option<(Place, u16)>,
}

/// Whether a side goes on.
pub enum Status {
    /// It does, with the rest of a block or the next one.
    Ready(Option<Rest>),
    /// It waits for the other one.
    Waiting(At, Rest),
    /// It is at its end.
    Ended,
}

/// Where a side waits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum At {
    /// A word P, with its value.
    P(u16),
    /// M100.
    M100,
}

/// What is left of a block in which a side waits.
pub struct Rest {
    /// The block.
    pub block: Carried,
    /// Its words, if it was evaluated only.
    pub left: Left,
}

/// From where on a block is left.
pub enum Left {
    /// From check 1 on.
    All(Box<Words>),
    /// From the next pass of a fixed cycle on.
    Passes(Box<Moved>),
    /// From step 8 on.
    Step8(Box<Moved>),
}

impl<'a> SideProgram<'a> {
    /// At the beginning of a side program; one without any block that counts has ended.
    pub fn new(channel: Channel<'a>, has_blocks: bool) -> Self {
        let status = if has_blocks { Status::Ready(None) } else { Status::Ended };
        Self { channel, status, last: Place::default(), ended_with: None }
    }

    /// E100L-AX4-03: both sides have the program name that stands in front of them.
    pub fn begin(&mut self, name: Label, steps: u64) {
        let program = self.channel.calls.running_mut();
        program.name = name;
        program.began = true;
        self.channel.reader.steps = steps;
    }

    /// Which side it is.
    pub fn side(&self) -> Option<Side> {
        self.channel.state.side()
    }

    /// Whether it goes on.
    pub fn is_ready(&self) -> bool {
        matches!(self.status, Status::Ready(_))
    }

    /// Whether it is within a fixed cycle.
    pub fn is_in_cycle(&self) -> bool {
        matches!(self.status, Status::Ready(Some(Rest { left: Left::Passes(_), .. })))
    }

    /// Where it waits; nowhere if it is at its end.
    pub fn waits_at(&self) -> Option<At> {
        match &self.status {
            Status::Waiting(at, _) => Some(*at),
            Status::Ready(_) | Status::Ended => None,
        }
    }

    /// Carries out the rest of a block, or the next one.
    pub fn go_on(&mut self, place: &mut Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<()> {
        let status = std::mem::replace(&mut self.status, Status::Ended);
        self.status = match status {
            Status::Ready(Some(rest)) => self.carry_on(rest, place, decided)?,
            Status::Ready(None) => self.next_block(place, decided)?,
            other => other,
        };
        Ok(())
    }

    fn next_block(&mut self, place: &mut Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<Status> {
        let channel = &mut self.channel;
        let Some(block) = channel.arrive(place)? else {
            *place = self.last;
            return self.with_stream(self.last, decided, |side, stream| side.end(None, stream));
        };
        let Block { place: here, content, behind, .. } = block;
        if !matches!(content, Content::Nothing | Content::Name) {
            self.last = here;
        }
        let block = Carried { place: here, behind };
        self.with_stream(here, decided, |side, stream| match side.channel.words(content, block, stream)? {
            Some(words) => side.evaluated(words, block, stream),
            None => Ok(Status::Ready(None)),
        })
    }

    fn carry_on(
        &mut self,
        rest: Rest,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<Status> {
        let Rest { block, left } = rest;
        *place = block.place;
        if matches!(left, Left::Passes(_)) {
            self.channel.begin_pass(block, place)?;
        }
        self.with_stream(block.place, decided, |side, stream| match left {
            Left::All(words) => side.checked_and_moved(*words, block, stream),
            Left::Passes(mut moved) => {
                side.channel.pass(&mut moved, stream)?;
                side.moved(*moved, block, stream)
            }
            Left::Step8(moved) => side.step_8(&moved, stream),
        })
    }

    fn with_stream(
        &mut self,
        place: Place,
        decided: &mut Vec<(Place, Emission)>,
        act: impl FnOnce(&mut Self, &mut Stream) -> Outcome<Status>,
    ) -> Outcome<Status> {
        let mut stream = self.channel.compensation.stream(place, self.side(), decided);
        let status = act(self, &mut stream);
        stream.close();
        status
    }

    /// A block that was evaluated. E100L-PSYNC-02: with P it waits before anything of it is checked; E100L-PSYNC-04:
    /// not if there is nobody to wait for.
    fn evaluated(&mut self, words: Words, block: Carried, stream: &mut Stream) -> Outcome<Status> {
        let state = &self.channel.state;
        if !state.waits() {
            return self.checked_and_moved(words, block, stream);
        }
        let Some(p) = words.get('P') else {
            if !CommonWords::of(&words).is_empty() {
                return fail(AlarmName::SidesDiffer, AX4_07);
            }
            return self.checked_and_moved(words, block, stream);
        };
        if state.modes.compensating() {
            return Err(Fault::about(AlarmName::Unspecified, PSYNC_09, "compensation"));
        }
        let at = At::P(u16::try_from(p).unwrap_or_default());
        stream.emissions.push(at.wait());
        Ok(Status::Waiting(at, Rest { block, left: Left::All(Box::new(words)) }))
    }

    fn checked_and_moved(&mut self, words: Words, block: Carried, stream: &mut Stream) -> Outcome<Status> {
        let moved = self.channel.up_to_motion(words, stream)?;
        if moved.plan.begins_definition() {
            self.channel.passing = Some(block.place);
        }
        self.moved(moved, block, stream)
    }

    /// E100L-M100-01: M100 waits behind the motion.
    fn moved(&mut self, moved: Moved, block: Carried, stream: &mut Stream) -> Outcome<Status> {
        if moved.passes.is_some() {
            return Ok(Status::Ready(Some(Rest { block, left: Left::Passes(Box::new(moved)) })));
        }
        if !moved.plan.words.m.contains(&100) || !self.channel.state.waits() {
            return self.step_8(&moved, stream);
        }
        stream.emissions.push(At::M100.wait());
        Ok(Status::Waiting(At::M100, Rest { block, left: Left::Step8(Box::new(moved)) }))
    }

    fn step_8(&mut self, moved: &Moved, stream: &mut Stream) -> Outcome<Status> {
        if let Some(code) = modal::end_code(&moved.plan) {
            return self.end(Some(code), stream);
        }
        self.channel.end_of_block(moved, stream)?;
        Ok(Status::Ready(None))
    }

    /// E100L-AX4-05: M02, M30, or no block is left. The reset comes when both sides have ended.
    fn end(&mut self, code: Option<u16>, stream: &mut Stream) -> Outcome<Status> {
        self.channel.compensation.end_of_program(stream, &mut self.channel.state)?;
        self.ended_with = code.map(|code| (stream.place, code));
        let code = code.map_or(Label::default(), |code| Label::of_code(b'M', code));
        stream.emissions.push(Emission::new(Action::SideEnd { code }, RuleSet::of(&[AX4_05])));
        Ok(Status::Ended)
    }
}

impl At {
    /// The key `p` or `code` of its events.
    pub fn keys(self) -> (Option<u16>, Label) {
        match self {
            Self::P(p) => (Some(p), Label::default()),
            Self::M100 => (None, Label::new("M100")),
        }
    }

    fn wait(self) -> Emission {
        let (p, code) = self.keys();
        let rule = match self {
            Self::P(_) => PSYNC_02,
            Self::M100 => M100_01,
        };
        Emission::new(Action::Wait { p, code }, RuleSet::of(&[rule]))
    }
}
