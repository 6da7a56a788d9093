//! Depth and feed of a pass (E100L-LAPC-02, E100L-LAPC-03, E100L-LAPC-04).

use super::job::Job;
use crate::fault::{Fault, Outcome};
use crate::integer::lap::has_reached;
use crate::state::{State, StoredFeed};
use crate::thread::Cited;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;

/// A depth and a feed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Cut {
    /// The depth, an amount on the infeed axis.
    pub depth: i64,
    /// The feed.
    pub feed: Option<StoredFeed>,
}

/// What the passes cut, level by level.
#[derive(Clone, Debug)]
pub struct Depths {
    first: Cut,
    /// The change points, that of XB (ZB) in front, with what is cut behind them.
    changes: Vec<(i64, Cut)>,
    up: i64,
}

impl Depths {
    /// Those of a call.
    pub fn of(job: &Job, state: &State) -> Outcome<Self> {
        let first = Cut { depth: job.depth(), feed: job.feed };
        let (transverse, up) = (job.plane.transverse, job.plane.up);
        let names = if transverse { ["ZA", "ZB"] } else { ["XA", "XB"] };
        let depths = ["DA", "DB"];
        let mut changes = Vec::new();
        let (mut before, mut cut) = (job.start.infeed, first);
        for ((name, depth), feed) in names.into_iter().zip(depths).zip(state.lap.other_feeds) {
            cut = Cut { depth: job.words.extended(depth).unwrap_or(cut.depth), feed: feed.or(cut.feed) };
            let Some(point) = job.words.extended(name) else { continue };
            // E100L-LAPC-04.
            if up * (before - point) <= 0 {
                return Err(Fault::about(AlarmName::LapData, LAPC_04, name));
            }
            before = point;
            changes.insert(0, (point, cut));
        }
        Ok(Self { first, changes, up })
    }

    /// What is cut below a level.
    pub fn below(&self, level: i64) -> Cut {
        let reached = self.changes.iter().find(|(point, _)| has_reached(level, *point, self.up));
        reached.map_or(self.first, |(_, cut)| *cut)
    }

    /// What the motions of a pass name that has another depth or feed.
    pub fn cited(&self, cut: Cut) -> Cited {
        Cited::default().and_if(cut != self.first, Cited::rules(&[LAPC_02, LAPC_03]))
    }
}
