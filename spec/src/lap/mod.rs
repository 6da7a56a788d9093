//! The lathe auto-programming function, G80 to G88 (execution-lap.md): a contour that is written once is cut rough in
//! passes that the control finds, and finished.
//!
//! [`check`] refuses calls and [`contents`] what a definition may not hold; [`kept`] is what is in force in a definition,
//! [`recording`] what was read of it. A [`job`] is a cycle before its first pass: in its [`plane`] lie the [`contour`] and
//! the blank, along whose [`course`] points at levels are sought, as exact [`number`]s. [`bar`] cuts modes I and IV, with
//! [`infeed`] points, [`depths`], and passes that [`follow`] the contour and go through [`air`]; [`copy`] cuts mode II,
//! [`threads`] mode III; [`bar_copy`] cuts mode V, along a [`track`], from points in which it has to [`leave`] the contour,
//! by the common points of [`shape`]s. [`motion`] carries each motion out; [`roles`] says what those of modes I and IV name.

mod air;
mod bar;
mod bar_copy;
mod check;
mod contents;
mod contour;
mod copy;
mod course;
mod depths;
mod follow;
mod infeed;
mod job;
mod kept;
mod leave;
mod motion;
mod number;
mod plane;
mod recording;
mod roles;
mod shape;
mod threads;
mod track;

pub use check::{
    change_points_belong_to_call, check_call, check_contour_block, every_word_has_a_function, has_g,
    not_in_constant_speed, stands_alone,
};
pub use contents::{refuse_assignments, refuse_words};
pub use kept::{Definition, Kept, Mark, Purpose, begin_motion, place, store_feeds};
pub use recording::{Kind as Way, Recorded, Recording};

use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::state::{State, StoredFeed};
use bar::Bar;
use bar_copy::BarCopy;
use copy::Copy;
use job::Job;
use threads::Threads;

/// A rough cycle with the passes that are left of it (E100L-LAP-22).
#[derive(Debug)]
pub enum Cycle {
    /// Modes I and IV.
    Bar(Box<Bar>),
    /// Mode II.
    Copy(Box<Copy>),
    /// Mode III.
    Threads(Box<Threads>),
    /// Mode V.
    BarCopy(Box<BarCopy>),
}

impl Cycle {
    /// The cycle of a call with what was recorded of its definition, before its first pass; `feed` is the contour feed
    /// commanded last before the call.
    pub fn begin(
        call: &Plan,
        recording: Recording,
        feed: Option<StoredFeed>,
        state: &State,
    ) -> Outcome<Self> {
        let job = Job::new(call, &recording, feed, state)?;
        match (call.one_shot, &recording.blank) {
            (Some(86), None) => Ok(Self::Copy(Box::new(Copy::begin(job)))),
            (Some(86), Some(_)) => BarCopy::begin(job).map(|cycle| Self::BarCopy(Box::new(cycle))),
            (Some(88), _) => {
                Threads::begin(job, recording.contour, state).map(|cycle| Self::Threads(Box::new(cycle)))
            }
            _ => Bar::begin(job, state).map(|cycle| Self::Bar(Box::new(cycle))),
        }
    }

    /// Cuts the next pass; whether one is left then.
    pub fn pass(&mut self, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<bool> {
        match self {
            Self::Bar(cycle) => cycle.pass(state, emissions),
            Self::Copy(cycle) => cycle.pass(state, emissions),
            Self::Threads(cycle) => cycle.pass(state, emissions),
            Self::BarCopy(cycle) => cycle.pass(state, emissions),
        }
    }
}
