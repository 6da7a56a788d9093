//! What each hole cycle does from the cutting start on (execution of drilling, 8, the table of cycles; E100L-G181-01 to
//! E100L-G184-02, E100L-G189-01, E100L-STAP-02 to E100L-STAP-04, E100L-MCYC-16).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, ChipDischarge, Duration, Part, RuleSet, Sink, SpindleState};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::thread::Cited;

use super::axis::Axis;
use super::hole::Holes;
use super::motion::Drive;
use super::peck::{Peck, PeckCites};

use SpindleState::{Clockwise, CounterClockwise, Stop};

impl Interpreter<'_> {
    /// A hole but a key way, from the cutting start to where the tool returns.
    pub(super) fn bottom(&mut self, holes: &Holes, sink: &mut impl Sink) -> Result<(), Fault> {
        let own = holes.own;
        match holes.code {
            _ if holes.synchronised => return self.tap_in_step(holes, sink),
            183 => self.cut_in_pecks(holes, sink)?,
            _ => {
                self.begin_pass()?;
                let cited = holes.cites.cut.and(holes.cites.feed.rules).by(holes.cites.feed.readings);
                let bottom = (holes.axis, holes.bottom);
                self.go_along(bottom, Drive::Feed(holes.feed), (Part::Cut, None), cited, sink)?;
            }
        }
        self.wait_at_bottom(holes, sink);
        match holes.code {
            182 => {
                self.turn_tool(Stop, own, sink);
                self.return_rapidly(holes, false, sink)?;
                self.unclamp(holes, sink);
                self.turn_tool(Clockwise, own, sink);
                Ok(())
            }
            184 => {
                self.turn_tool(Stop, own, sink);
                self.turn_tool(CounterClockwise, own, sink);
                self.leave_at_feed(holes, sink)?;
                self.unclamp(holes, sink);
                self.turn_tool(Stop, own, sink);
                self.turn_tool(Clockwise, own, sink);
                self.return_rapidly(holes, true, sink)
            }
            189 => {
                self.leave_at_feed(holes, sink)?;
                self.unclamp(holes, sink);
                self.return_rapidly(holes, true, sink)
            }
            _ => {
                self.return_rapidly(holes, false, sink)?;
                self.unclamp(holes, sink);
                Ok(())
            }
        }
    }

    /// The dwell of the kept E.
    fn wait_at_bottom(&mut self, holes: &Holes, sink: &mut impl Sink) {
        let Some(time) = self.state.cycle.data.e else { return };
        let mut rules = holes.own.with(DWELL_02);
        if holes.follows {
            rules = rules.with(MCYC_09);
        }
        rules = rules.with(if holes.axis == Axis::Z { MCYC_07 } else { MCYC_08 });
        if holes.code == 183 {
            rules = rules.with(G183_03);
        }
        self.emit(sink, rules, Action::Dwell { time: Duration(time) });
    }

    /// G184 and G189 leave the hole at the feed.
    fn leave_at_feed(&mut self, holes: &Holes, sink: &mut impl Sink) -> Result<(), Fault> {
        let cited = holes
            .cites
            .every
            .and(const { RuleSet::of(&[MCYC_03]) })
            .and(holes.cites.feed.rules)
            .by(holes.cites.feed.readings);
        let level = (holes.axis, holes.level);
        self.go_along(level, Drive::Feed(holes.feed), (Part::Exit, None), cited, sink)
    }

    fn return_rapidly(&mut self, holes: &Holes, after_exit: bool, sink: &mut impl Sink) -> Result<(), Fault> {
        let cited = holes.cites.back.and_if(after_exit, const { RuleSet::of(&[MCYC_16]) });
        let back = (holes.axis, holes.back);
        self.go_along(back, Drive::Rapid, (Part::Return, None), cited, sink)
    }

    /// G183: with the kept D and L.
    fn cut_in_pecks(&mut self, holes: &Holes, sink: &mut impl Sink) -> Result<(), Fault> {
        let data = self.state.cycle.data;
        let Holes { axis, direction, level, bottom, .. } = *holes;
        let to_start = self.setup.readings.chip_discharge == ChipDischarge::CycleStart
            && !planted::is(Bug::DischargeLevelLost);
        let peck = Peck {
            axis,
            level,
            direction,
            depth: direction.saturating_mul(bottom.saturating_sub(level)),
            // D was tested: it is there, and not zero.
            step: data.d.unwrap_or_default().max(1),
            between: data.l,
            retract: self.retract(axis, self.setup.parameters.drilling_retract.0),
            withdrawal: if to_start { holes.start } else { level },
            feed: holes.feed,
        };
        let passes = |cited: Cited| cited.by_if(axis == Axis::X, self.known.peck_retract);
        let cut = holes.cites.cut.and(holes.cites.feed.rules).by(holes.cites.feed.readings);
        let withdraw = holes.cites.every.and(const { RuleSet::of(&[G183_02]) }).by(self.known.chip_discharge);
        let cites =
            PeckCites { cut: passes(cut), retract: passes(holes.cites.every), withdraw: passes(withdraw) };
        self.peck(&peck, &cites, sink)
    }

    /// G178, G179, and G184 where it is synchronised: tool and feed turn together.
    fn tap_in_step(&mut self, holes: &Holes, sink: &mut impl Sink) -> Result<(), Fault> {
        let own = holes.own;
        let (inward, outward) = match holes.code {
            179 if !planted::is(Bug::LeftTapTurnsRight) => (CounterClockwise, Clockwise),
            _ => (Clockwise, CounterClockwise),
        };
        let Holes { axis, lead, .. } = *holes;
        let drive = Drive::Tap { lead, axis: axis.lead(), start: self.state.cycle.start_angle };
        let thread = |cited: Cited| {
            cited.and(const { RuleSet::of(&[STAP_01]) }).by_if(axis == Axis::X, self.known.feed_length)
        };
        let cut = thread(holes.cites.cut);
        let exit = thread(holes.cites.every).and_if(holes.code == 184, const { RuleSet::of(&[MCYC_03]) });
        self.turn_tool(inward, own, sink);
        self.begin_pass()?;
        self.go_along((axis, holes.bottom), drive, (Part::Cut, None), cut, sink)?;
        self.turn_tool(outward, own, sink);
        self.go_along((axis, holes.level), drive, (Part::Exit, None), exit, sink)?;
        self.turn_tool(Stop, own.with(STAP_04), sink);
        self.unclamp(holes, sink);
        self.return_rapidly(holes, true, sink)
    }
}
