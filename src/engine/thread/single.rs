//! A block of G31, G32 or G33: the data of its pass, from its words and from what the cycle keeps
//! (execution of threads, 4; E100L-G33-01 to E100L-G33-03, E100L-G32-01, E100L-G32-04, E100L-G33-10).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{LeadAxis, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Address, Words};

use super::cut::{PassCites, taper_rule};
use super::lead::Lead;
use super::motion::Thread;
use super::pass::{Pass, Taper};

/// The data of the cycle in progress.
#[derive(Clone, Copy, Debug)]
pub struct Cycle {
    /// Program coordinate of the end along the lead axis, and the level.
    end: i64,
    level: i64,
    taper: Taper,
    shift: i64,
    run_out: Option<i64>,
    change: i64,
    start: i64,
    pass: u32,
}

/// The words of a cycle by what they mean.
struct Meaning {
    end: Address,
    level: Address,
    taper: Address,
    shift: Address,
    /// A taper word of 1 changes the level by so much: a radius counts twice.
    taper_times: i64,
}

impl Meaning {
    fn of(axis: LeadAxis) -> Self {
        use Address::{I, K, X, Z};
        match axis {
            LeadAxis::Z => Self {
                end: Z,
                level: X,
                taper: I,
                shift: K,
                taper_times: if planted::is(Bug::TaperHalved) { 1 } else { 2 },
            },
            LeadAxis::X => Self { end: X, level: Z, taper: K, shift: I, taper_times: 1 },
        }
    }
}

/// The taper that the words of a block command, if they do.
pub fn taper(words: &Words, axis: LeadAxis) -> Option<Taper> {
    let Meaning { taper, taper_times, .. } = Meaning::of(axis);
    let amount = words.get(taper).map(|word| Taper::Amount(taper_times * word));
    amount.or(words.get(Address::A).map(Taper::Angle))
}

impl Cycle {
    /// The cycle of a block whose cycle start is the point given, after the blocks before it.
    fn of(
        words: &Words,
        axis: LeadAxis,
        (start, start_level): (i64, i64),
        before: Option<Self>,
        incremental: bool,
    ) -> Self {
        let meaning = Meaning::of(axis);
        let kept = before.unwrap_or(Self {
            end: start,
            level: start_level,
            taper: Taper::Amount(0),
            shift: 0,
            run_out: None,
            change: 0,
            start: words.get(Address::C).unwrap_or_default(),
            pass: 0,
        });
        let place = |address, present, kept| {
            words.get(address).map_or(kept, |word| coordinate(present, word, incremental))
        };
        Self {
            end: place(meaning.end, start, kept.end),
            level: place(meaning.level, start_level, kept.level),
            taper: taper(words, axis).unwrap_or(kept.taper),
            shift: words.get(meaning.shift).unwrap_or(kept.shift),
            run_out: words.get(Address::L).or(kept.run_out),
            change: words.get(Address::E).unwrap_or(kept.change),
            start: words.get(Address::C).filter(|_| planted::is(Bug::AngleOfFollowUp)).unwrap_or(kept.start),
            pass: kept.pass.saturating_add(1),
        }
    }
}

impl Interpreter<'_> {
    /// A thread block in G31, G32 or G33.
    pub(super) fn thread_pass(
        &mut self,
        words: &Words,
        motion: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let lead = self.begin_thread()?;
        let axis = if motion == 32 { LeadAxis::X } else { LeadAxis::Z };
        let axes = self.thread_axes(axis);
        let start = axes.split(self.present());
        let before = self.state.thread.cycle;
        let cycle = Cycle::of(words, axis, start, before, self.state.incremental);
        self.state.thread.cycle = Some(cycle);
        let pass = Pass {
            axes,
            start,
            end: cycle.end,
            level: cycle.level,
            side: start.1.saturating_sub(cycle.level).signum(),
            taper: cycle.taper,
            shift: cycle.shift,
            flank: 0,
            lead: Lead { start: lead, change: cycle.change },
            run_out: cycle.run_out,
        };
        let thread = Thread { axis, change: cycle.change, start: cycle.start };
        let cites = self.pass_cites(words, motion, &cycle, thread, before.is_some());
        self.cut((&pass, cycle.pass), thread, &cites, sink)
    }

    fn pass_cites(
        &mut self,
        words: &Words,
        motion: u16,
        cycle: &Cycle,
        thread: Thread,
        follows: bool,
    ) -> PassCites {
        let (path, after) = match motion {
            31 => (const { RuleSet::of(&[G33_02, G33_04]) }, const { RuleSet::of(&[G33_03]) }),
            32 => (const { RuleSet::of(&[G32_02]) }, const { RuleSet::of(&[G32_04]) }),
            _ => (const { RuleSet::of(&[G33_04]) }, const { RuleSet::of(&[G33_03]) }),
        };
        let every = self.cited_by_words(words).and(path).and_if(follows, after);
        let shifted = cycle.shift != 0;
        PassCites {
            every,
            inner: every
                .and_if(shifted, const { RuleSet::of(&[G33_07]) })
                .by_if(shifted, self.known.thread_shift),
            taper: taper_rule(cycle.taper),
            thread: self.cited_by_thread(thread).and_if(thread.start != 0, const { RuleSet::of(&[G33_10]) }),
            approach: RuleSet::EMPTY,
            exit: RuleSet::EMPTY,
            back: RuleSet::EMPTY,
        }
    }
}
