//! A block of G34 or G35: a length of thread from the present point (execution of threads, 4, "Leg"; E100L-G34-01 to
//! E100L-G34-05).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{LeadAxis, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::angle::Course;
use crate::engine::arithmetic::plane::Point;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::slot::Slot;
use crate::engine::words::{Address, Words};

use super::lead::Lead;
use super::motion::{Cited, Step, Thread};
use super::unspecified;

impl Interpreter<'_> {
    /// A thread block in G34 or G35.
    pub(super) fn thread_leg(&mut self, slot: &Slot, motion: u16, sink: &mut impl Sink) -> Result<(), Fault> {
        let words = &slot.words;
        let angle_target = self.state.angle_target.take();
        let start_lead = self.begin_thread()?;
        let axis = if words.has_m(27) { LeadAxis::X } else { LeadAxis::Z };
        let axes = self.thread_axes(axis);
        let amount = words.get(Address::E).unwrap_or_default();
        let change = if motion == 35 && !planted::is(Bug::ShrinkingGrows) { -amount } else { amount };
        let goes_on = std::mem::replace(&mut self.state.thread.chain, true);
        let counts = !goes_on || planted::is(Bug::AngleInChain);
        let start = words.get(Address::C).filter(|_| counts).unwrap_or_default();
        let present = self.present();
        let (end, of_angle) = self.end_of_leg(slot, present, angle_target, sink)?;
        let ((from, _), (to, _)) = (axes.split(present), axes.split(end));
        if from == to {
            return Err(unspecified(G34_04, "length"));
        }
        let lead = Lead { start: start_lead, change };
        lead.check_end(axes.twice_length(from, to))?;
        let thread = Thread { axis, change, start };
        let angle = words.has(Address::A);
        let step = Step {
            drive: thread.with_lead(lead.start),
            end,
            tested: [Address::X, Address::Z].map(|address| angle || words.has(address)),
            part: None,
            cited: self.leg_cites(words, thread).and(of_angle),
        };
        self.make(&step, sink)
    }

    /// Where a leg ends, and the rules of its A word.
    fn end_of_leg(
        &mut self,
        slot: &Slot,
        present: Point,
        angle_target: Option<(i64, i64)>,
        sink: &mut impl Sink,
    ) -> Result<(Point, RuleSet), Fault> {
        const OF_CORNER: RuleSet = RuleSet::of(&[ANG_01, ANG_06]);
        let incremental = self.state.incremental;
        let course = Course::of(&slot.words, incremental);
        if let Some(angle) = course.only_angle() {
            let (corner, beyond) = self.corner_ahead(slot, (present, angle), false, sink)?;
            self.state.angle_target = Some((beyond.x, beyond.z));
            return Ok((corner, OF_CORNER));
        }
        if let Some((x, z)) = angle_target {
            let end = if planted::is(Bug::LegFromCorner) {
                course.end(present, present, &mut self.slow)?
            } else {
                Point { x, z }
            };
            return Ok((end, OF_CORNER));
        }
        let rules = match (slot.words.has(Address::A), incremental) {
            (false, _) => RuleSet::EMPTY,
            (true, false) => const { RuleSet::of(&[ANG_01, ANG_02, DTAP_03]) },
            (true, true) => const { RuleSet::of(&[ANG_01, ANG_02, DTAP_03, DTAP_05]) },
        };
        Ok((course.end(present, present, &mut self.slow)?, rules))
    }

    fn leg_cites(&mut self, words: &Words, thread: Thread) -> Cited {
        self.cited_by_words(words)
            .and(const { RuleSet::of(&[G34_01, G34_04]) })
            .by_if(thread.axis == LeadAxis::X, self.known.feed_length)
            .and_if(self.state.thread.divisor != 1, const { RuleSet::of(&[THRD_06]) })
            .and_if(thread.change != 0, const { RuleSet::of(&[G33_09, G34_02]) })
            .and_if(thread.start != 0, const { RuleSet::of(&[G34_05]) })
            .and_if(!words.has(Address::F), const { RuleSet::of(&[G34_03]) })
    }
}
