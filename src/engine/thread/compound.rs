//! A block with G71 or G72: a whole thread, pass by pass (execution of threads, 6; E100L-G71-01 to E100L-G71-10,
//! E100L-G72-01 to E100L-G72-03, E100L-TMUL-01, E100L-TMUL-02).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, BalancedInfeed, LeadAxis, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::arithmetic::plane::Point;
use crate::engine::arithmetic::round::Rounding;
use crate::engine::arithmetic::turn::TURN;
use crate::engine::block::OneShot;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{X, Z};
use crate::engine::words::{Address, Words};

use super::cut::{PassCites, taper_rule};
use super::depths::{Depth, Depths, Heights, Sequence};
use super::infeed::{Infeed, Pattern};
use super::lead::Lead;
use super::motion::{Cited, Thread};
use super::pass::{Pass, Taper};
use super::{single, unspecified};

/// A compound cycle.
struct Compound {
    axis: LeadAxis,
    /// The pass of the whole depth, without a flank.
    pass: Pass,
    heights: Heights,
    sequence: Sequence,
    /// B.
    angle: i64,
    /// How many starts.
    starts: i64,
    every: Cited,
    thread: Cited,
}

impl Interpreter<'_> {
    /// A block with G71 or G72.
    pub(in crate::engine) fn compound_thread(
        &mut self,
        words: &Words,
        one_shot: OneShot,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.state.thread.end_chain();
        let axis = if one_shot == OneShot::ThreadAlong { LeadAxis::Z } else { LeadAxis::X };
        let compound = self.compound(words, axis)?;
        let mut depths = Depths::new(compound.sequence, compound.heights);
        let mut is_first = true;
        while let Some(depth) = depths.next(&mut self.slow) {
            for start in 0..compound.starts {
                if !is_first && !planted::is(Bug::PassesUncounted) && !self.task.count_pass() {
                    return Fault::raise(AlarmName::StepLimit, GOTO_03);
                }
                is_first = false;
                let is_last = depths.are_done() && start + 1 == compound.starts;
                self.compound_pass(&compound, depth, start, is_last, sink)?;
            }
        }
        Ok(())
    }

    /// The data of the cycle, and what is tested before its first pass.
    fn compound(&mut self, words: &Words, axis: LeadAxis) -> Result<Compound, Fault> {
        let lead = self.begin_thread()?;
        let axes = self.thread_axes(axis);
        let word = |address| words.get(address).unwrap_or_default();
        let place =
            |axis, address| coordinate(self.state.program(axis), word(address), self.state.incremental);
        let (end, level) = axes.split(Point { x: place(X, Address::X), z: place(Z, Address::Z) });
        let start = axes.split(self.present());
        let side = start.1.saturating_sub(level).signum();
        if side == 0 {
            return Err(unspecified(G33_04, "side"));
        }
        let allowance = word(if axis == LeadAxis::Z { Address::U } else { Address::W });
        let height = word(Address::H);
        let heights = Heights { step: word(Address::D), height, target: height - allowance };
        let sequence = self.sequence(heights)?;
        let change = word(Address::E);
        let starts = word(Address::Q).max(1);
        let pass = Pass {
            axes,
            start,
            end,
            level,
            side,
            taper: single::taper(words, axis).unwrap_or(Taper::Amount(0)),
            shift: 0,
            flank: 0,
            lead: Lead { start: lead, change },
            run_out: words.get(Address::L),
        };
        let own = match axis {
            LeadAxis::Z => const { RuleSet::of(&[G71_01, G71_03]) },
            LeadAxis::X => const { RuleSet::of(&[G72_01, G72_02]) },
        };
        let every = self.cited_by_words(words).and(own).and_if(starts > 1, const { RuleSet::of(&[TMUL_02]) });
        let thread = self
            .cited_by_thread(Thread { axis, change, start: 0 })
            .and_if(change != 0, const { RuleSet::of(&[G71_05]) });
        Ok(Compound { axis, pass, heights, sequence, angle: word(Address::B), starts, every, thread })
    }

    /// How the depths follow each other (E100L-TINF-01, E100L-TINF-06, E100L-TINF-07).
    fn sequence(&self, heights: Heights) -> Result<Sequence, Fault> {
        let kept = &self.state.thread;
        let zigzag = kept.infeed == Infeed::Zigzag;
        let (first, last) = (heights.first_area(), heights.finishing_area());
        let (area, rule) = match kept.pattern {
            Pattern::Halving => return Ok(Sequence::Halving),
            Pattern::Steps => return Ok(Sequence::Steps),
            Pattern::Areas if self.setup.parameters.m75_pattern == 4 => (first.max(last), TINF_07),
            Pattern::Areas if first >= last => return Ok(Sequence::Areas { zigzag }),
            Pattern::Areas => (last, TINF_06),
        };
        if self.setup.readings.balanced_infeed == BalancedInfeed::Refused {
            return Err(unspecified(rule, "M75"));
        }
        Ok(Sequence::Balanced { count: heights.balanced_count(area), zigzag, rule })
    }

    /// One pass, by its depth and the number of its start, from 0.
    fn compound_pass(
        &mut self,
        compound: &Compound,
        depth: Depth,
        start: i64,
        is_last: bool,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let rest = compound.heights.height - depth.depth;
        let flank = self.flank_shift(compound.axis, rest, compound.angle, depth.number);
        let whole = &compound.pass;
        let level = whole.level.saturating_add(whole.side * rest);
        let pass = Pass { level, flank, ..*whole };
        let thread = Thread {
            axis: compound.axis,
            change: whole.lead.change,
            start: match planted::is(Bug::StartsCut) {
                true => Rounding::Cut.divide_narrow(start * TURN, compound.starts),
                false => Rounding::HalfAway.divide_narrow(start * TURN, compound.starts),
            },
        };
        let cites = self.compound_cites(compound, depth, &pass, thread.start != 0, is_last);
        let number = u32::try_from(depth.number).unwrap_or(u32::MAX);
        self.cut((&pass, number), thread, &cites, sink)
    }

    fn compound_cites(
        &self,
        compound: &Compound,
        depth: Depth,
        pass: &Pass,
        turned: bool,
        is_last: bool,
    ) -> PassCites {
        let along = compound.axis == LeadAxis::Z;
        let balanced = !depth.finishing && compound.sequence.is_balanced();
        let mut inner = compound
            .every
            .and_if(along, const { RuleSet::of(&[G71_02, TINF_08]) })
            .by_if(balanced, self.known.balanced);
        inner = match depth.finishing {
            true if along => inner.and(const { RuleSet::of(&[G71_07]) }),
            true => inner.and(const { RuleSet::of(&[G72_03]) }),
            false => inner.and(RuleSet::of(&[TINF_01, compound.sequence.rule()])),
        };
        if pass.flank != 0 {
            let side = match self.state.thread.infeed {
                Infeed::Zigzag => const { RuleSet::of(&[TMOD_01, TMOD_02, TMOD_04]) },
                _ => const { RuleSet::of(&[TMOD_01, TMOD_02, TMOD_03]) },
            };
            inner = inner.and(side).by(self.known.flank);
        }
        let (exit, end) = if along { (G71_06, G71_08) } else { (G72_03, G72_03) };
        PassCites {
            every: compound.every,
            inner,
            taper: taper_rule(pass.taper).with(G71_04),
            thread: compound.thread.and_if(turned, const { RuleSet::of(&[TMUL_01]) }),
            approach: const { RuleSet::of(&[G71_10]) },
            exit: RuleSet::of(&[exit]),
            back: if is_last { RuleSet::of(&[end]) } else { RuleSet::EMPTY },
        }
    }
}
