//! Synchronised tapping: the driven tool and the feed turn together (E100L-STAP-01 to -04, E100L-G184-02).

use super::act::Act;
use super::block::CycleBlock;
use super::cited::Cites;
use super::levels::Levels;
use super::motion::{Go, Manner};
use crate::fault::{Fault, Outcome};
use crate::modal::active_feed;
use crate::quantity::{round_narrow, whole};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Part};

/// A tap.
#[derive(Clone, Copy, Debug)]
pub struct Tap {
    levels: Levels,
    manner: Manner,
    /// The M codes that turn the tool on its way in and out.
    senses: (u16, u16),
}

impl Tap {
    /// The tap of a block. E100L-STAP-01: the lead is F per revolution of the tool, divided by J.
    pub fn begin(block: CycleBlock, levels: &Levels, state: &State) -> Outcome<Self> {
        // Thousandths of a revolution per minute.
        let speed = state.spindle.tool_speed;
        if speed == 0 {
            return Err(Fault::about(AlarmName::Unspecified, STAP_01, "speed"));
        }
        let (feed, _) = active_feed(state)?;
        let leads = state.feed.map_or(1, |feed| feed.leads).max(1);
        let lead = whole(feed.value.0) / whole(leads);
        let lead = if state.modes.per_minute() { lead * whole(1_000) / whole(speed) } else { lead };
        let start = state.cycle.start_angle;
        let manner = Manner::Tap { axis: levels.axis, lead: round_narrow(&lead), start };
        // E100L-STAP-03.
        let senses = if block.code == 179 { (14, 13) } else { (13, 14) };
        Ok(Self { levels: *levels, manner, senses })
    }

    /// In and out; the tool stands then (E100L-STAP-04).
    pub fn acts(&self, cites: &Cites) -> [Act; 6] {
        let thread = |to, part| Act::Go(Go::along(self.levels.axis, to, self.manner, part, cites.tap(part)));
        let (inward, outward) = self.senses;
        let cited = cites.code();
        [
            Act::Code(inward, cited),
            Act::Pass,
            thread(self.levels.bottom, Part::Cut),
            Act::Code(outward, cited),
            thread(self.levels.cut, Part::Exit),
            Act::Code(12, cited.and(Cited::rules(&[STAP_04]))),
        ]
    }
}
