//! A block with G77 or G78: a tap on the axis of the main spindle (execution of drilling, 7; E100L-TAP-01 to
//! E100L-TAP-07).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Part, RuleSet, Sink, SpindleState};

use crate::engine::Interpreter;
use crate::engine::arithmetic::drilling::at_depth;
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::block::OneShot;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{X, Z};
use crate::engine::words::{Address, Words};

use super::axis::Axis;
use super::motion::Drive;
use super::unspecified;

impl Interpreter<'_> {
    /// A block with G77 or G78.
    pub(in crate::engine) fn tap(
        &mut self,
        words: &Words,
        one_shot: OneShot,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.state.base = None;
        let feed = Drive::Feed(self.feed()?);
        if self.state.c_joined {
            return Err(unspecified(TAP_04, "c_axis"));
        }
        let word = |address| words.get(address).unwrap_or_default();
        let incremental = self.state.incremental;
        let start = self.state.program(Z);
        let x = coordinate(self.state.program(X), word(Address::X), incremental);
        let bottom = coordinate(start, word(Address::Z), incremental);
        let way = bottom.saturating_sub(start);
        if way == 0 || way.saturating_abs() <= word(Address::K) {
            return Err(unspecified(TAP_02, "depth"));
        }
        let level = at_depth(start, way.signum(), word(Address::K));
        let right = one_shot == OneShot::TapRight;
        let own = match right {
            true => const { RuleSet::of(&[TAP_01, TAP_02]) },
            false => const { RuleSet::of(&[TAP_01, TAP_03]) },
        };
        let every = self.cited_in_cycle(words).and(own);
        let by_feed = self.cited_by_feed();
        let cut = every.and(by_feed.rules).by(by_feed.readings);
        self.go_along((Axis::X, x), Drive::Rapid, (Part::Position, None), every, sink)?;
        let reference = self.reference_x();
        if self.spindle_speed(reference).value == 0 {
            return Err(unspecified(TAP_04, "speed"));
        }
        let forward = self.state.mirror > 0 || planted::is(Bug::TapsNotMirrored);
        let (inward, outward) = if right == forward {
            (SpindleState::Clockwise, SpindleState::CounterClockwise)
        } else {
            (SpindleState::CounterClockwise, SpindleState::Clockwise)
        };
        self.turn_main(inward, own.with(TAP_04), sink);
        self.go_along((Axis::Z, level), Drive::Rapid, (Part::Approach, None), every, sink)?;
        self.begin_pass()?;
        self.go_along((Axis::Z, bottom), feed, (Part::Cut, None), cut, sink)?;
        self.turn_main(SpindleState::Stop, own, sink);
        self.turn_main(outward, own, sink);
        self.go_along((Axis::Z, level), feed, (Part::Exit, None), cut, sink)?;
        self.go_along((Axis::Z, start), Drive::Rapid, (Part::Return, None), every, sink)?;
        self.turn_main(SpindleState::Stop, own.with(TAP_06), sink);
        Ok(())
    }

    /// The main spindle turns or stops, as by M03, M04 and M05.
    fn turn_main(&mut self, state: SpindleState, own: RuleSet, sink: &mut impl Sink) {
        let mut rules = own.with(MCODE_05);
        if state != SpindleState::Stop {
            rules = rules.with(SPD_04);
            if self.state.mirror < 0 {
                rules = rules.with(MIRR_06);
            }
            self.state.spindle_side = self.state.selected;
        }
        self.state.spindle = state;
        self.show_main_spindle(sink, rules, false, None);
    }
}
