//! G185 to G188, threads with the C axis, each pass by itself or chained (execution of drilling, 8, "Threads";
//! E100L-CTHR-01 to E100L-CTHR-05).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Feed, FeedLength, FeedRate, FeedUnit, Part, RuleSet, Sink, SpindleState};

use crate::engine::Interpreter;
use crate::engine::arithmetic::drilling::{at_depth, helix_feed, helix_turn};
use crate::engine::arithmetic::turn;
use crate::engine::fault::Fault;
use crate::engine::motion::Turn;
use crate::engine::planted::{self, Bug};
use crate::engine::state::C;
use crate::engine::thread::Cited;
use crate::engine::words::{Address, Words};

use super::axis::Axis;
use super::cites::cycle_rules;
use super::motion::{Drive, Move};
use super::{is_chain, unspecified};

/// The axis along which the lead of a thread cycle is measured.
pub fn lead_axis(code: u16) -> Axis {
    if matches!(code, 185 | 187) { Axis::Z } else { Axis::X }
}

impl Interpreter<'_> {
    /// A hole block of a thread cycle, at the stored feed per revolution.
    pub(super) fn helix(
        &mut self,
        words: &Words,
        feed: Feed,
        is_first: bool,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let code = self.state.cycle.code;
        let axis = lead_axis(code);
        let own = cycle_rules(code, false);
        let every = self.cited_in_cycle(words).and(own).and_if(!is_first, const { RuleSet::of(&[MCYC_09]) });
        if is_first || !is_chain(code) {
            self.go_to_thread(words, axis, is_first, every, sink)?;
            if is_first {
                self.turn_tool(SpindleState::Clockwise, own, sink);
            }
        } else {
            let present = axis.of(self.present());
            let way = self.state.cycle.data.coordinate(axis).saturating_sub(present);
            if way.signum() != self.state.cycle.direction {
                return Err(unspecified(if axis == Axis::Z { CTHR_04 } else { CTHR_05 }, "depth"));
            }
        }
        self.cut_helix(axis, feed, every, sink)?;
        if is_chain(code) {
            return Ok(());
        }
        let other = (axis.other(), self.cycle_start(axis.other()));
        self.go_along(other, Drive::Rapid, (Part::Retract, None), every, sink)?;
        let lead = (axis, self.cycle_start(axis));
        self.go_along(lead, Drive::Rapid, (Part::Return, None), every, sink)
    }

    /// To where the thread begins.
    fn go_to_thread(
        &mut self,
        words: &Words,
        axis: Axis,
        is_first: bool,
        every: Cited,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let start = self.cycle_start(axis);
        let data = self.state.cycle.data;
        let way = data.coordinate(axis).saturating_sub(start);
        let approach = data.amount(axis).unwrap_or_default();
        if way == 0 || way.saturating_abs() <= approach {
            return Err(unspecified(MCYC_05, "depth"));
        }
        let c_word = words.get(Address::C);
        if is_first {
            self.state.cycle.direction = way.signum();
            self.state.cycle.c = self.state.program(C);
        }
        if let Some(word) = c_word {
            self.state.cycle.c = word;
        }
        let names_c = c_word.is_some() || !is_first;
        let turn = names_c.then(|| self.turn_of(self.state.cycle.c));
        let level = axis.put(self.present(), at_depth(start, way.signum(), approach));
        let end = axis.other().put(level, data.coordinate(axis.other()));
        let cited =
            every.and(const { RuleSet::of(&[MCYC_05]) }).and_if(names_c, const { RuleSet::of(&[CAX_05]) });
        self.go(&Move::rapid(end, turn, Part::Position, cited), sink)
    }

    /// The thread, from the present point on.
    fn cut_helix(&mut self, axis: Axis, feed: Feed, every: Cited, sink: &mut impl Sink) -> Result<(), Fault> {
        let data = self.state.cycle.data;
        let present = self.present();
        let (from, to) = (axis.of(present), data.coordinate(axis));
        let taper = data.amount(axis.other()).unwrap_or_default();
        let level = data.coordinate(axis.other()).saturating_add(taper);
        let end = axis.other().put(axis.put(present, to), level);
        let on_radius = axis == Axis::X
            && !planted::is(Bug::HelixOnDiameter)
            && self.setup.readings.feed_length == FeedLength::Radius;
        let twice = i128::from(to.abs_diff(from)) * if on_radius { 1 } else { 2 };
        let lead = feed.value.0;
        let size = helix_turn(twice, lead);
        let travel = if self.state.c_negative { -size } else { size };
        let machine = turn::within(self.state.machine[C].saturating_add(travel));
        let speed = self.state.cycle.c_speed.unwrap_or_default();
        let feed = Feed { value: FeedRate(helix_feed(lead, speed)), unit: FeedUnit::PerMinute };
        let cited = every
            .and(const { RuleSet::of(&[CAX_05, CAX_08, CTHR_01]) })
            .by_if(axis == Axis::X, self.known.feed_length);
        let turn = Some(Turn { travel, machine });
        let drive = Drive::Helix { lead, axis: axis.lead(), feed };
        self.begin_pass()?;
        self.go(&Move { drive, ..Move::rapid(end, turn, Part::Cut, cited) }, sink)
    }
}
