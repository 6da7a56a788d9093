//! A block with G73 or G74: one groove or several, or a hole, in pecks (execution of drilling, 6; E100L-GRV-01 to
//! E100L-GRV-10).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, Duration, Part, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::drilling::at_depth;
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::arithmetic::tool::ToolWord;
use crate::engine::block::OneShot;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::thread::Cited;
use crate::engine::words::{Address, Words};

use super::axis::Axis;
use super::motion::Drive;
use super::peck::{Peck, PeckCites};
use super::unspecified;

/// The grooves of a block.
struct Grooves {
    /// That of the cut.
    axis: Axis,
    /// The level of the cycle start.
    start: i64,
    peck: Peck,
    dwell: Option<Duration>,
    /// Where the first and the last groove stand on the other axis.
    first: i64,
    last: i64,
    /// From groove to groove.
    step: i64,
    /// All motions.
    every: Cited,
    /// Those at the feed.
    feed: Cited,
    own: RuleSet,
    /// Whether T gives the place of the last groove.
    shifted: bool,
}

/// What the motions of one groove cite.
struct GrooveCites {
    approach: Cited,
    peck: PeckCites,
    back: Cited,
    shift: Cited,
}

impl Interpreter<'_> {
    /// A block with G73 or G74.
    pub(in crate::engine) fn groove(
        &mut self,
        words: &Words,
        one_shot: OneShot,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.state.base = None;
        let grooves = self.grooves(words, one_shot)?;
        let side = grooves.last.saturating_sub(grooves.first).signum();
        let mut place = grooves.first;
        let mut cites = self.groove_cites(&grooves, false);
        loop {
            self.one_groove(&grooves, &cites, sink)?;
            if place == grooves.last {
                break;
            }
            place = at_depth(place, side, grooves.step);
            if grooves.last.saturating_sub(place).signum() != side {
                place = grooves.last;
                cites = self.groove_cites(&grooves, true);
            }
            let lateral = (grooves.axis.other(), place);
            self.go_along(lateral, Drive::Rapid, (Part::Shift, None), cites.shift, sink)?;
        }
        let back = grooves.every.and(const { RuleSet::of(&[GRV_07]) });
        let lateral = (grooves.axis.other(), grooves.first);
        self.go_along(lateral, Drive::Rapid, (Part::Return, None), back, sink)
    }

    /// The data of the grooves, and what is tested before the first one.
    fn grooves(&mut self, words: &Words, one_shot: OneShot) -> Result<Grooves, Fault> {
        let feed = self.feed()?;
        let (axis, own) = match one_shot {
            OneShot::GrooveAcross => (Axis::X, const { RuleSet::of(&[GRV_01]) }),
            _ => (Axis::Z, const { RuleSet::of(&[GRV_02]) }),
        };
        let word = |address| words.get(address).unwrap_or_default();
        let (start, first) = (axis.of(self.present()), axis.other().of(self.present()));
        let incremental = self.state.incremental;
        let bottom = coordinate(start, word(axis.word()), incremental);
        let lateral = words.get(axis.other().word());
        let place = lateral.map_or(first, |word| coordinate(first, word, incremental));
        let last = place.saturating_add(self.edge_shift(words, axis.other()));
        let approach = word(axis.amount());
        let direction = bottom.saturating_sub(start).signum();
        let depth = bottom.saturating_sub(start).saturating_abs().saturating_sub(approach);
        if direction == 0 || depth <= 0 {
            return Err(unspecified(GRV_03, "depth"));
        }
        let step = word(axis.other().amount());
        if last != first && step == 0 {
            return Err(unspecified(GRV_09, "shift"));
        }
        let retract = words.get(Address::DA).unwrap_or(self.setup.parameters.grooving_retract.0);
        let peck = Peck {
            axis,
            level: at_depth(start, direction, approach),
            direction,
            depth,
            step: word(Address::D),
            between: words.get(Address::L),
            retract: self.retract(axis, retract),
            withdrawal: start,
            feed,
        };
        let dwell = words.has(Address::E).then(|| Duration(words.exact_e.rounded(self.units.time, 1)));
        let every = self.cited_in_cycle(words).and(own);
        let feed = self.cited_by_feed();
        let shifted = words.has(Address::T);
        Ok(Grooves { axis, start, peck, dwell, first, last, step, every, feed, own, shifted })
    }

    /// How far the offset of a T word moves the last groove (E100L-GRV-08).
    fn edge_shift(&self, words: &Words, lateral: Axis) -> i64 {
        let Some(tool) = words.get(Address::T) else { return 0 };
        let number = usize::from(ToolWord::new(tool).offset);
        let [x, z] = self.state.tool_offsets.get(number).copied().unwrap_or_default();
        let [present_x, present_z] = self.state.active_offset();
        let sign = if planted::is(Bug::GrooveEdgeAdded) { 1 } else { self.state.offset_sign };
        sign * match lateral {
            Axis::X => x.saturating_sub(present_x),
            Axis::Z => z.saturating_sub(present_z),
        }
    }

    /// One groove, from the level of the cycle start and back.
    fn one_groove(
        &mut self,
        grooves: &Grooves,
        cites: &GrooveCites,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let Grooves { axis, start, ref peck, dwell, own, .. } = *grooves;
        let level = (axis, peck.level);
        self.go_along(level, Drive::Rapid, (Part::Approach, None), cites.approach, sink)?;
        self.peck(peck, &cites.peck, sink)?;
        if let Some(time) = dwell {
            let rules = own.union(const { RuleSet::of(&[GRV_06, DWELL_02]) });
            self.emit(sink, rules, Action::Dwell { time });
        }
        self.go_along((axis, start), Drive::Rapid, (Part::Return, None), cites.back, sink)
    }

    fn groove_cites(&self, grooves: &Grooves, is_last: bool) -> GrooveCites {
        let every = grooves.every.and_if(is_last, const { RuleSet::of(&[GRV_07]) });
        let passes = every.by_if(grooves.axis == Axis::X, self.known.peck_retract);
        let cut = passes
            .and(const { RuleSet::of(&[GRV_04, GRV_10]) })
            .and_if(grooves.first == grooves.last, const { RuleSet::of(&[GRV_09]) });
        GrooveCites {
            approach: every.and(const { RuleSet::of(&[GRV_03]) }),
            peck: PeckCites {
                cut: cut.and(grooves.feed.rules).by(grooves.feed.readings),
                retract: passes.and(const { RuleSet::of(&[GRV_04]) }),
                withdraw: passes.and(const { RuleSet::of(&[GRV_05]) }),
            },
            back: every.and(const { RuleSet::of(&[GRV_06]) }),
            shift: every
                .and(const { RuleSet::of(&[GRV_06]) })
                .and_if(grooves.shifted, const { RuleSet::of(&[GRV_08]) })
                .by_if(grooves.shifted, self.known.tool_offset),
        }
    }
}
