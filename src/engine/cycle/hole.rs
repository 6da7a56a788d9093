//! A block that machines in the cycle mode, and what the hole cycles have in common: levels, places, repetition
//! (execution of drilling, 8, "Holes"; E100L-MCYC-05 to E100L-MCYC-09, E100L-MCYC-11, E100L-MCYC-15, E100L-MCYC-17,
//! E100L-MCYC-20, E100L-CSC-09).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, CycleReturn, Feed, Part, RuleSet, Sink, SpindleState};

use crate::engine::Interpreter;
use crate::engine::arithmetic::drilling::{at_depth, hole_angle, tap_lead};
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::turn;
use crate::engine::contour::{self, Station};
use crate::engine::fault::Fault;
use crate::engine::motion::Turn;
use crate::engine::planted::{self, Bug};
use crate::engine::state::C;
use crate::engine::thread::Cited;
use crate::engine::words::{Address, Words};

use super::axis::Axis;
use super::cites::cycle_rules;
use super::keyway::Keyway;
use super::motion::{Drive, Move};
use super::{Kept, TAP_LENGTHS, is_helix, unspecified};

/// The holes of a block.
pub struct Holes {
    pub code: u16,
    pub synchronised: bool,
    /// That of the cut.
    pub axis: Axis,
    /// 1 or -1.
    pub direction: i64,
    /// The level of the cycle start.
    pub start: i64,
    /// That where the cut begins.
    pub level: i64,
    pub bottom: i64,
    /// That to which the tool returns.
    pub back: i64,
    pub feed: Feed,
    /// The lead of a tap.
    pub lead: i64,
    /// Whether the C axis is clamped.
    pub clamps: bool,
    /// Whether the block is no first block.
    pub follows: bool,
    /// The rules of the cycle.
    pub own: RuleSet,
    pub cites: HoleCites,
    keyway: Option<Keyway>,
}

/// Where the first hole of a block is, as far as the block says.
#[derive(Clone, Copy)]
struct Place {
    /// On the position axis.
    across: Option<i64>,
    c: Option<i64>,
    /// The point that it is in conversion mode.
    station: Option<Station>,
}

/// What the motions of a hole cite.
#[derive(Clone, Copy)]
pub struct HoleCites {
    /// All of them.
    pub every: Cited,
    /// At the feed in force.
    pub feed: Cited,
    /// The cut, its feed aside.
    pub cut: Cited,
    pub back: Cited,
}

impl Interpreter<'_> {
    /// Step 7 of a hole block.
    pub(super) fn machine(
        &mut self,
        words: &Words,
        is_first: bool,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.state.base = None;
        if !self.state.c_joined {
            return Fault::raise(AlarmName::CAxisNotJoined, MCYC_11);
        }
        if self.state.c_clamped {
            return Fault::raise(AlarmName::CAxisClamped, MCYC_11);
        }
        let feed = self.feed()?;
        if is_first {
            self.begin_cycle(words);
        }
        self.keep_words(words);
        let code = self.state.cycle.code;
        if self.is_synchronised(code) {
            self.inch_block = self.units.inch && words.has_any(TAP_LENGTHS);
        }
        if is_helix(code) {
            return self.helix(words, feed, is_first, sink);
        }
        let place = self.place(words)?;
        let holes = self.holes(words, feed, is_first)?;
        let first = place.c.unwrap_or_else(|| self.state.program(C));
        let count = words.get(Address::Q).unwrap_or_default().max(1);
        for number in 0..count {
            if number == 0 {
                self.go_to_place(words, place, &holes, sink)?;
                if is_first {
                    let state = if holes.synchronised { SpindleState::Stop } else { SpindleState::Clockwise };
                    self.turn_tool(state, holes.own, sink);
                }
            } else {
                let angle = hole_angle(
                    first,
                    number,
                    count,
                    self.state.c_negative && !planted::is(Bug::HolesForward),
                );
                self.turn_to_place(angle, &holes, sink)?;
            }
            self.one_hole(&holes, number > 0, sink)?;
        }
        Ok(())
    }

    /// Where the words of a block put its first hole; in conversion mode that is a point.
    fn place(&mut self, words: &Words) -> Result<Place, Fault> {
        if !self.state.contour.converts() || !words.has_any(contour::POINT) {
            let Kept { code, axis, .. } = self.state.cycle;
            let across = words.get(axis.other().word()).filter(|_| code != 190);
            return Ok(Place { across, c: words.get(Address::C), station: None });
        }
        let station = self.programmed_station(words)?;
        let word = words.get(Address::X).filter(|_| planted::is(Bug::HoleOnDiameter));
        let axis = if planted::is(Bug::HoleDirectionLost) { self.conversion_axis() } else { 0 };
        let (across, c) = (word.unwrap_or(station.x), station.c.saturating_sub(axis));
        Ok(Place { across: Some(across), c: Some(c), station: Some(station) })
    }

    /// The levels of the holes, and what is tested before the first of them.
    fn holes(&mut self, words: &Words, feed: Feed, is_first: bool) -> Result<Holes, Fault> {
        let code = self.state.cycle.code;
        let synchronised = self.is_synchronised(code);
        let axis = self.state.cycle.axis;
        let data = self.state.cycle.data;
        let start = self.cycle_start(axis);
        if is_first || planted::is(Bug::DirectionAnew) {
            let way = data.r.unwrap_or_else(|| data.coordinate(axis).saturating_sub(start));
            self.state.cycle.direction = way.signum();
        }
        let direction = self.state.cycle.direction;
        let level = at_depth(start, direction, data.amount(axis).unwrap_or_default());
        let bottom = data.r.map_or(data.coordinate(axis), |depth| level.saturating_add(depth));
        let depth = direction.saturating_mul(bottom.saturating_sub(level));
        if direction == 0 || depth <= 0 {
            return Err(unspecified(MCYC_05, "depth"));
        }
        self.state.cycle.spent |= words.has(Address::Q) && !planted::is(Bug::SpentForgotten);
        let keyway = if code == 190 { Some(self.keyway(depth)?) } else { None };
        let lead = if synchronised { self.tap_lead(feed)? } else { 0 };
        let to_start = self.setup.parameters.cycle_return == CycleReturn::CycleStart
            || words.has_m(136) && !planted::is(Bug::ReturnLevelLost);
        let own = cycle_rules(code, synchronised);
        Ok(Holes {
            code,
            synchronised,
            axis,
            direction,
            start,
            level,
            bottom,
            back: if to_start { start } else { level },
            feed,
            lead,
            clamps: !(words.has_m(141) || words.has_m(169) && !planted::is(Bug::ClampKept)),
            follows: !is_first,
            own,
            cites: self.hole_cites(words, own, is_first),
            keyway,
        })
    }

    /// The lead of a tap in step with the tool (E100L-STAP-01).
    fn tap_lead(&self, feed: Feed) -> Result<i64, Fault> {
        let speed = self.state.tool_speed;
        if speed == 0 {
            return Err(unspecified(STAP_01, "speed"));
        }
        let speed = self.state.per_minute.then_some(speed);
        Ok(tap_lead(feed.value.0, self.state.thread.divisor(), speed))
    }

    fn hole_cites(&mut self, words: &Words, own: RuleSet, is_first: bool) -> HoleCites {
        let code = self.state.cycle.code;
        let place = match self.state.cycle.axis {
            _ if code == 190 => RuleSet::EMPTY,
            Axis::Z => const { RuleSet::of(&[MCYC_07]) },
            Axis::X => const { RuleSet::of(&[MCYC_08]) },
        };
        let every = self
            .cited_in_cycle(words)
            .and(own.union(place))
            .and_if(!is_first, const { RuleSet::of(&[MCYC_09]) });
        let free = words.has_m(141) || words.has_m(169);
        let unready = code == 184 && words.has_m(140) && !self.is_synchronised(code);
        let cut = every
            .and(const { RuleSet::of(&[MCYC_03]) })
            .and_if(self.state.cycle.data.r.is_some(), const { RuleSet::of(&[MCYC_22]) })
            .and_if(free, const { RuleSet::of(&[MCYC_18]) })
            .and_if(unready, const { RuleSet::of(&[MCYC_19]) });
        let back = every.and(const { RuleSet::of(&[MCYC_15]) });
        HoleCites { every, feed: self.cited_by_feed(), cut, back }
    }

    /// To the place of the first hole, where the block has words for it.
    fn go_to_place(
        &mut self,
        words: &Words,
        Place { across, c, station }: Place,
        holes: &Holes,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let present = self.present();
        let end = across.map_or(present, |across| holes.axis.other().put(present, across));
        let turn = c.map(|c| self.turn_of(c));
        let mut cited = holes.cites.every.and_if(turn.is_some(), const { RuleSet::of(&[CAX_05]) });
        if station.is_some() {
            cited = cited.and(self.conversion_rules(words).with(CSC_09));
        }
        let point = station.map(|station| station.point);
        self.go(&Move { point, ..Move::rapid(end, turn, Part::Position, cited) }, sink)?;
        if let Some(station) = station.filter(|_| !planted::is(Bug::HolePointForgotten)) {
            self.keep_point(station);
        }
        Ok(())
    }

    /// To the place of a further hole round the axis.
    fn turn_to_place(&mut self, angle: i64, holes: &Holes, sink: &mut impl Sink) -> Result<(), Fault> {
        let end = self.present();
        let turn = Some(self.turn_of(angle));
        let cited = holes.cites.every.and(const { RuleSet::of(&[CAX_05, MCYC_20]) });
        self.go(&Move::rapid(end, turn, Part::Position, cited), sink)
    }

    /// The turn of C to a program coordinate (E100L-CAX-05).
    pub(super) fn turn_of(&self, angle: i64) -> Turn {
        let target = turn::within(angle);
        let travel = turn::travel(self.state.program(C), target, 0, self.state.c_negative);
        Turn { travel, machine: turn::within(to_machine(target, self.state.frame(C))) }
    }

    /// A hole, from over its place to where the tool returns.
    fn one_hole(&mut self, holes: &Holes, again: bool, sink: &mut impl Sink) -> Result<(), Fault> {
        let approach = holes
            .cites
            .every
            .and(const { RuleSet::of(&[MCYC_05]) })
            .and_if(again, const { RuleSet::of(&[MCYC_17]) });
        let level = (holes.axis, holes.level);
        self.go_along(level, Drive::Rapid, (Part::Approach, None), approach, sink)?;
        if holes.clamps {
            self.clamp(true, holes.own, sink);
        }
        match &holes.keyway {
            Some(keyway) => {
                self.cut_keyway(holes, keyway, sink)?;
                self.unclamp(holes, sink);
                Ok(())
            }
            None => self.bottom(holes, sink),
        }
    }

    /// The C axis is free again.
    pub(super) fn unclamp(&mut self, holes: &Holes, sink: &mut impl Sink) {
        if holes.clamps {
            self.clamp(false, holes.own, sink);
        }
    }
}
