//! A block of G34 or G35: a length of thread from the present point (execution of threads, 4, "Leg"; E100L-G34-01 to
//! E100L-G34-05).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{LeadAxis, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::angle::Course;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Address, Words};

use super::lead::Lead;
use super::motion::{Cited, Step, Thread};
use super::unspecified;

impl Interpreter<'_> {
    /// A thread block in G34 or G35.
    pub(super) fn thread_leg(
        &mut self,
        words: &Words,
        motion: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let start_lead = self.begin_thread()?;
        let axis = if words.has_m(27) { LeadAxis::X } else { LeadAxis::Z };
        let axes = self.thread_axes(axis);
        let amount = words.get(Address::E).unwrap_or_default();
        let change = if motion == 35 && !planted::is(Bug::ShrinkingGrows) { -amount } else { amount };
        let goes_on = std::mem::replace(&mut self.state.thread.chain, true);
        let counts = !goes_on || planted::is(Bug::AngleInChain);
        let start = words.get(Address::C).filter(|_| counts).unwrap_or_default();
        let present = self.present();
        let course = Course::of(words, self.state.incremental);
        let end = course.end(present, present, &mut self.slow)?;
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
            cited: self.leg_cites(words, thread),
        };
        self.make(&step, sink)
    }

    fn leg_cites(&mut self, words: &Words, thread: Thread) -> Cited {
        let angle = words.has(Address::A);
        self.cited_by_words(words)
            .and_if(angle, const { RuleSet::of(&[ANG_01, ANG_02, DTAP_03]) })
            .and_if(angle && self.state.incremental, const { RuleSet::of(&[DTAP_05]) })
            .and(const { RuleSet::of(&[G34_01, G34_04]) })
            .by_if(thread.axis == LeadAxis::X, self.known.feed_length)
            .and_if(self.state.thread.divisor != 1, const { RuleSet::of(&[THRD_06]) })
            .and_if(thread.change != 0, const { RuleSet::of(&[G33_09, G34_02]) })
            .and_if(thread.start != 0, const { RuleSet::of(&[G34_05]) })
            .and_if(!words.has(Address::F), const { RuleSet::of(&[G34_03]) })
    }
}
