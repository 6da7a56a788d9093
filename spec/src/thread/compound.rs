//! G71 and G72: a whole thread in one block (E100L-G71-01 to -10, E100L-G72-01 to -03, E100L-TMUL-01, E100L-TMUL-02).

use super::flank::Flanks;
use super::infeed::{Depth, Infeed};
use super::lead;
use super::motion::{Cited, Thread};
use super::pass::{Citations, Pass, Spot};
use super::taper::Taper;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::integer::thread::level_above;
use crate::modal::Plan;
use crate::quantity::{round_narrow, whole};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, LeadAxis, Setup};

/// A cycle with the passes that are left of it.
#[derive(Clone, Debug)]
pub struct Compound {
    /// What all passes have in common, at the level of the last one.
    pass: Pass,
    /// H.
    height: i64,
    /// B.
    tip: i64,
    flanks: Flanks,
    infeed: Infeed,
    /// How many starts the thread has (E100L-TMUL-01).
    starts: i64,
    /// The depth that is cut now.
    depth: Depth,
    /// How many starts were cut at it.
    cut: i64,
}

impl Compound {
    /// The cycle of a block, before its first pass.
    pub fn begin(plan: &Plan, state: &mut State) -> Outcome<Self> {
        let words = &plan.words;
        let word = |letter| words.get(letter).unwrap_or(0);
        let lead = lead::of_block(state)?.changing(word('E'));
        // It counts from the present point: a corner of before (E100L-CHAM-13) is left behind.
        state.base = None;
        let (axis, allowance, amount) = match plan.one_shot {
            Some(72) => (LeadAxis::X, 'W', 'K'),
            _ => (LeadAxis::Z, 'U', 'I'),
        };
        let present = state.frame.program();
        let base = |present| if plan.modes.incremental() { present } else { 0 };
        let target = (base(present.x) + word('X'), base(present.z) + word('Z'));
        let (start, end) = (Spot::of((present.x, present.z), axis), Spot::of(target, axis));
        // E100L-G71-02: outside where the cycle start is above the level.
        let side = (start.level - end.level).signum();
        if side == 0 {
            return Err(Fault::about(AlarmName::Unspecified, G33_04, "side"));
        }
        let pass = Pass {
            thread: Thread { lead, axis, start_angle: 0 },
            start,
            end: end.lead,
            level: end.level,
            side,
            // E100L-G71-04.
            taper: Taper::of(words.get(amount), words.get('A'), axis).unwrap_or_default(),
            shift: 0,
            flank: 0,
            chamfer: words.get('L'),
            number: 0,
            citations: Citations::default(),
        };
        let flanks = Flanks::in_force(state);
        let (step, height) = (word('D'), word('H'));
        let mut infeed = Infeed::new(step, height, height - word(allowance), flanks, state)?;
        let depth = infeed.next();
        let starts = word('Q').max(1);
        Ok(Self { pass, height, tip: word('B'), flanks, infeed, starts, depth, cut: 0 })
    }

    /// Cuts the next pass: each depth in turn, at each depth each start in turn (E100L-G71-10, E100L-TMUL-02). Whether one
    /// is left then.
    pub fn cut(&mut self, plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<bool> {
        if self.cut == 0 {
            self.pass.number = self.pass.number.saturating_add(1);
        }
        let is_last = self.depth.last && self.cut + 1 == self.starts;
        self.pass_at_depth(is_last, state).cut(plan, state, emissions)?;
        self.cut += 1;
        if self.cut == self.starts {
            self.cut = 0;
            if !is_last {
                self.depth = self.infeed.next();
            }
        }
        Ok(!is_last)
    }

    /// The next pass.
    fn pass_at_depth(&self, is_last: bool, state: &State) -> Pass {
        let above = self.height - self.depth.value;
        let axis = self.pass.thread.axis;
        let flank = self.flanks.shift(above, self.tip, self.pass.number, axis, state);
        // E100L-TMUL-01.
        let start_angle = round_narrow(&(whole(self.cut * 360_000_000) / whole(self.starts)));
        let flank_cited = Cited::default().and_if(flank != 0, self.flanks.cited(state));
        let infeed = self.infeed.cited(state);
        let citations = self.citations(is_last, start_angle, infeed, flank_cited, state.setup);
        Pass {
            thread: Thread { start_angle, ..self.pass.thread },
            level: level_above(self.pass.level, self.pass.side, above),
            flank,
            citations,
            ..self.pass
        }
    }

    fn citations(
        &self,
        is_last: bool,
        start_angle: i64,
        infeed: Cited,
        flank: Cited,
        setup: &Setup,
    ) -> Citations {
        let start = Cited::default()
            .and_if(start_angle != 0, Cited::rules(&[TMUL_01]))
            .and_if(self.pass.thread.lead.change != 0, Cited::rules(&[G71_05]));
        let starts = Cited::rules(&[TMUL_02]);
        let own = match self.pass.thread.axis {
            LeadAxis::Z => Citations {
                all: Cited::rules(&[G71_01, G71_03]),
                // E100L-TINF-08: depths are diameters.
                work: Cited::rules(&[G71_02, TINF_08]),
                thread: Cited::rules(&[G33_08]),
                exit: Cited::rules(&[G71_06]),
                back: Cited::rules(&[G71_08]),
                ..Citations::default()
            },
            LeadAxis::X => Citations {
                all: Cited::rules(&[G72_01, G72_02]),
                thread: Cited::rules(&[G32_03]).reading(setup.readings.feed_length),
                exit: Cited::rules(&[G72_03]),
                back: Cited::rules(&[G72_03]),
                ..Citations::default()
            },
        };
        let finishing = Cited::rules(&[if self.pass.thread.axis == LeadAxis::Z { G71_07 } else { G72_03 }]);
        let depth = if self.depth.finishing { finishing } else { infeed };
        Citations {
            all: own.all.and_if(self.starts > 1, starts),
            work: own.work.and(depth).and(flank),
            taper: Cited::rules(&[G71_04]),
            approach: Cited::rules(&[G71_10]),
            thread: own.thread.and(start),
            back: Cited::default().and_if(is_last, own.back),
            ..own
        }
    }
}
