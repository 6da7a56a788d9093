//! G190: the passes of a key way (E100L-G190-02 to -07).

use super::act::Act;
use super::cited::Cites;
use super::kept::KeptWords;
use super::levels::Levels;
use super::motion::{Axis, Go, Manner};
use super::peck::retract;
use crate::fault::{Fault, Outcome};
use crate::quantity::{Exact, narrow, round_narrow, whole};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, KeywayReturn, Part};

/// Passes that are left, in program coordinates and lengths in nanometres.
#[derive(Clone, Debug)]
pub struct KeyWay {
    /// The axis of the infeed.
    axis: Axis,
    /// Where the cut begins.
    level: i64,
    direction: i64,
    /// The beginning of the slot and its end.
    slot: (i64, i64),
    /// From the cutting start to the bottom, and to the allowance.
    total: i64,
    height: i64,
    /// D.
    infeed: i64,
    /// M214: equal infeeds.
    equal: bool,
    /// M211: every pass goes one way.
    one_way: bool,
    relief: KeywayReturn,
    retract: i64,
    /// The feed of the infeed.
    plunge: Manner,
    /// How many passes there are up to the allowance.
    count: i64,
    /// How many were cut.
    cut: i64,
    cites: Cites,
}

impl KeyWay {
    /// The passes of a key way, of which the words are kept.
    pub fn begin(kept: &KeptWords, levels: &Levels, cites: Cites, state: &State) -> Outcome<Self> {
        let Levels { axis, direction, cut: level, .. } = *levels;
        let start = axis.other().of(levels.start);
        let (end, allowance, letter) = match axis {
            Axis::Z => (kept.x, kept.w, "W"),
            Axis::X => (kept.z, kept.u, "U"),
        };
        let end = end.unwrap_or(start);
        if end == start {
            return Err(Fault::about(AlarmName::Unspecified, G190_02, "slot"));
        }
        let total = levels.depth();
        let height = total - allowance.unwrap_or(0);
        if height <= 0 {
            return Err(Fault::about(AlarmName::Unspecified, G190_07, letter));
        }
        // A first block has D, and it is not zero.
        let infeed = kept.d.unwrap_or(height).max(1);
        Ok(Self {
            axis,
            level,
            direction,
            slot: (start, end),
            total,
            height,
            infeed,
            equal: state.is_active(214),
            one_way: state.is_active(211),
            relief: state.setup.readings.keyway_return,
            retract: retract(state.setup.parameters.drilling_retract.0, axis, state.setup),
            plunge: kept.e.map_or(Manner::Feed, Manner::FeedAt),
            count: narrow(&(whole(height) / whole(infeed)).ceil()),
            cut: 0,
            cites,
        })
    }

    /// The beginning of the slot.
    pub fn start(&self) -> i64 {
        self.slot.0
    }

    /// The next pass, with the way to the one behind it; none when all are cut.
    pub fn next(&mut self) -> Option<Vec<Act>> {
        let number = self.cut + 1;
        let finishing = number > self.count;
        if number > self.all() {
            return None;
        }
        self.cut = number;
        let depth = self.depth(number, finishing);
        let pass = u32::try_from(number).unwrap_or(u32::MAX);
        // E100L-G190-04: there and back.
        let end = if !self.one_way && number % 2 == 0 { self.slot.0 } else { self.slot.1 };
        let part = if finishing { Part::Finish } else { Part::Cut };
        let go = |axis, to, manner, part| {
            Act::Go(Go::along(axis, to, manner, part, self.cited(part, finishing)).in_pass(pass))
        };
        let mut acts = vec![
            Act::Pass,
            go(self.axis, self.at(&depth), self.plunge, Part::Infeed),
            go(self.axis.other(), end, Manner::Feed, part),
        ];
        if self.one_way && number < self.all() {
            let above = &depth - whole(self.retract);
            let back = self.at(&if above < Exact::ZERO { Exact::ZERO } else { above });
            let rapid = |axis, to, part| go(axis, to, Manner::Rapid, part);
            let shift = rapid(self.axis.other(), self.slot.0, Part::Shift);
            match self.relief {
                KeywayReturn::CuttingStart => {
                    let cited = self.cited(Part::Reentry, finishing);
                    let reentry = Go::along(self.axis, back, Manner::Rapid, Part::Reentry, cited);
                    acts.extend([rapid(self.axis, self.level, Part::Withdraw), shift]);
                    acts.push(Act::Go(reentry.in_pass(pass.saturating_add(1))));
                }
                KeywayReturn::Relief => acts.extend([rapid(self.axis, back, Part::Retract), shift]),
            }
        }
        Some(acts)
    }

    /// How many passes there are, the finishing pass included (E100L-G190-07).
    fn all(&self) -> i64 {
        self.count + i64::from(self.total != self.height)
    }

    /// E100L-G190-05, E100L-G190-06: how deep a pass is, from the cutting start.
    fn depth(&self, number: i64, finishing: bool) -> Exact {
        if finishing {
            return whole(self.total);
        }
        if self.equal {
            return whole(self.height) * whole(number) / whole(self.count);
        }
        let steps = whole(self.infeed) * whole(number);
        if number < self.count { steps } else { whole(self.height) }
    }

    /// The coordinate of a depth, latched.
    fn at(&self, depth: &Exact) -> i64 {
        round_narrow(&(whole(self.level) + whole(self.direction) * depth))
    }

    /// What a motion of a pass names.
    fn cited(&self, part: Part, finishing: bool) -> Cited {
        let infeed = if finishing {
            G190_07
        } else if self.equal {
            G190_06
        } else {
            G190_05
        };
        let way = if self.one_way {
            Cited::rules(&[G190_03]).reading(self.relief)
        } else {
            Cited::rules(&[G190_04])
        };
        let cuts = matches!(part, Part::Infeed | Part::Cut | Part::Finish);
        self.cites.key_way(part, self.one_way).and(way).and_if(cuts, Cited::rules(&[infeed]))
    }
}
