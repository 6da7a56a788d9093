//! The motions of a pass in their order (execution of threads, 5; E100L-G33-04), and what each of them cites.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{LeadAxis, Part, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::cite::Cites;
use crate::engine::fault::Fault;
use crate::engine::words::Words;

use super::motion::{Cited, Drive, Step, Thread};
use super::pass::{Pass, Route, Taper};

/// What the motions of a pass cite, besides what their parts always do.
#[derive(Clone, Copy)]
pub struct PassCites {
    /// All of them.
    pub every: Cited,
    /// All but the return.
    pub inner: Cited,
    /// Those too, on a taper.
    pub taper: RuleSet,
    /// The thread.
    pub thread: Cited,
    pub approach: RuleSet,
    pub exit: RuleSet,
    pub back: RuleSet,
}

impl Interpreter<'_> {
    /// What all motions of a block cite.
    pub(in crate::engine) fn cited_by_words(&mut self, words: &Words) -> Cited {
        self.cited_by(self.plane_cites(words))
    }

    /// What they cite for the words of their block.
    pub(in crate::engine) fn cited_by(&mut self, cites: Cites) -> Cited {
        let rules = self.cites.rules(cites);
        Cited { rules, ..Cited::default() }.by_if(self.inch_block, self.known.inch)
    }

    /// What the thread events of a cycle cite besides their start.
    pub(super) fn cited_by_thread(&self, thread: Thread) -> Cited {
        let along = match thread.axis {
            LeadAxis::Z => const { RuleSet::of(&[G33_08]) },
            LeadAxis::X => const { RuleSet::of(&[G32_03]) },
        };
        Cited { rules: along, ..Cited::default() }
            .by_if(thread.axis == LeadAxis::X, self.known.feed_length)
            .and_if(self.state.thread.divisor != 1, const { RuleSet::of(&[THRD_06]) })
            .and_if(thread.change != 0, const { RuleSet::of(&[G33_09]) })
    }

    /// Makes a pass.
    pub(super) fn cut(
        &mut self,
        (pass, number): (&Pass, u32),
        thread: Thread,
        cites: &PassCites,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let route = self.route(pass)?;
        let inner = cites.inner.and_if(route.tapers, cites.taper).by_if(route.tapers, self.known.taper);
        let cut = inner.and(cites.thread.rules).by(cites.thread.readings);
        let Route { approach, cut: end, exit, .. } = route;
        let lead = pass.lead.start;
        let step = |(lead, level), part, drive, cited| Step {
            drive,
            end: pass.axes.point(lead, level),
            tested: [true; 2],
            part: Some((number, part)),
            cited,
        };
        self.make(&step(approach, Part::Approach, Drive::Rapid, inner.and(cites.approach)), sink)?;
        self.make(&step(end, Part::Cut, Drive::Thread(thread, lead), cut), sink)?;
        if let Some(exit) = exit {
            let cited = cut
                .and(const { RuleSet::of(&[TCHM_01, TCHM_02, TCHM_03, TCHM_04]) })
                .and(cites.exit)
                .and_if(exit.clamped, const { RuleSet::of(&[SMAX_01]) })
                .by(self.known.feed_length)
                .by_if(exit.clamped, self.known.clamp);
            for (end, lead) in [Some(exit.first), exit.second].into_iter().flatten() {
                self.make(&step(end, Part::Exit, Drive::Thread(thread, lead), cited), sink)?;
            }
        }
        let (start, start_level) = pass.start;
        let retract = inner.and(const { RuleSet::of(&[G01_04, TCHM_03]) }).by(self.known.feed_length);
        self.make(&step((route.end, start_level), Part::Retract, Drive::Withdrawal, retract), sink)?;
        let back = cites.every.and(cites.back);
        self.make(&step((start, start_level), Part::Return, Drive::Rapid, back), sink)
    }
}

/// The rule of a taper, as it is commanded.
pub fn taper_rule(taper: Taper) -> RuleSet {
    match taper {
        Taper::Amount(_) => const { RuleSet::of(&[G33_05]) },
        Taper::Angle(_) => const { RuleSet::of(&[G33_06]) },
    }
}
