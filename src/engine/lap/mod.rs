//! LAP, the lathe auto-programming function, G80 to G88 (execution of LAP): what it remembers from block to block, and
//! which definition is read, carried out or passed over.

mod admit;
mod arrival;
mod bar_copying;
mod call;
mod check;
mod copying;
mod definition;
mod finish;
mod front;
mod graph;
mod home;
mod job;
mod level;
mod meeting;
mod outline;
mod pass_over;
mod plane;
mod read;
mod recess;
mod record;
mod rules;
mod threading;
mod travel;
mod turning;
mod value;
mod walk;

use turnspec_oracle::vocabulary::{AlarmName, Ending, Label, Place, RuleId, Sink};

use super::Interpreter;
use super::arithmetic::plane::Point;
use super::cite::Cites;
use super::fault::Fault;
use super::slot::Slot;
use super::state::StoredFeed;
use definition::Definition;
use rules::RuleCache;

/// A code that begins a definition or calls one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Code {
    /// G81.
    Along,
    /// G82.
    Across,
    /// G83.
    Blank,
    /// G85.
    Turn,
    /// G86.
    Copy,
    /// G87.
    Finish,
    /// G88.
    Thread,
}

impl Code {
    /// The code with a number.
    pub fn of(code: u16) -> Option<Self> {
        Some(match code {
            81 => Self::Along,
            82 => Self::Across,
            83 => Self::Blank,
            85 => Self::Turn,
            86 => Self::Copy,
            87 => Self::Finish,
            88 => Self::Thread,
            _ => return None,
        })
    }

    /// As written.
    fn label(self) -> Label {
        let code = match self {
            Self::Along => 81,
            Self::Across => 82,
            Self::Blank => 83,
            Self::Turn => 85,
            Self::Copy => 86,
            Self::Finish => 87,
            Self::Thread => 88,
        };
        Label::of_code(b'G', code)
    }

    /// Whether it begins a definition.
    fn begins_definition(self) -> bool {
        matches!(self, Self::Along | Self::Across | Self::Blank)
    }
}

/// The definition in which the run is.
#[derive(Debug, Default)]
enum Progress {
    /// None.
    #[default]
    None,
    /// It is passed over; where it begins.
    PassedOver(Place),
    /// It is read or carried out.
    Defining(Box<Definition>),
}

/// What LAP remembers.
#[derive(Debug, Default)]
pub struct Lap {
    progress: Progress,
    /// Whether motions are taken note of.
    observes: bool,
    /// The last contour feed E.
    feed: Option<StoredFeed>,
    /// Program coordinates less contour coordinates (E100L-LAPC-06).
    shift: Point,
    /// What the motions of the block in progress cite because they belong to a contour (E100L-LAPC-06).
    cites: Cites,
    cache: RuleCache,
}

impl Lap {
    /// Whether the run is in a definition.
    #[inline]
    pub fn is_active(&self) -> bool {
        !matches!(self.progress, Progress::None)
    }

    /// Whether motions are taken note of.
    #[inline]
    pub fn observes(&self) -> bool {
        self.observes
    }

    /// Program coordinates less contour coordinates.
    #[inline]
    pub fn shift(&self) -> Point {
        self.shift
    }

    /// What every motion of the block in progress cites because it belongs to a contour.
    #[inline]
    pub fn cites(&self) -> Cites {
        self.cites
    }

    /// The definition that is read or carried out.
    fn definition(&self) -> Option<&Definition> {
        match &self.progress {
            Progress::Defining(definition) => Some(definition),
            _ => None,
        }
    }

    /// Whether a definition is read or carried out.
    pub fn defines(&self) -> bool {
        self.definition().is_some()
    }

    fn definition_mut(&mut self) -> Option<&mut Definition> {
        match &mut self.progress {
            Progress::Defining(definition) => Some(definition),
            _ => None,
        }
    }

    /// The reset forgets the last contour feed.
    pub fn reset(&mut self) {
        self.feed = None;
    }
}

impl Interpreter<'_> {
    /// The next block of the definition in which the run is.
    #[cold]
    pub(super) fn next_block_of_definition(
        &mut self,
        slot: &mut Slot,
        sink: &mut impl Sink,
    ) -> Result<Option<Ending>, Fault> {
        match self.lap.progress {
            Progress::PassedOver(begin) => self.pass_block(slot, begin).map(|()| None),
            _ => self.define(slot, sink),
        }
    }
}

/// A fault of a definition.
#[cold]
fn malformed(rule: RuleId, detail: Label) -> Fault {
    Fault::about(AlarmName::ContourMalformed, rule, detail)
}

/// What the manual does not define.
#[cold]
fn unspecified(rule: RuleId, detail: Label) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, detail)
}

#[cfg(test)]
mod tests;
