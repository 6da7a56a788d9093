//! Motion: one element from its target to its event (execution, chapter 5, Motion).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Angle, Feed, FeedRate, FeedUnit, Length, Motion, Position, ReadingSet, Sense, Sink,
    Speed, SpeedLimit,
};

use super::Interpreter;
use super::arithmetic::feed::{self, Measure};
use super::arithmetic::frame::{coordinate, to_machine};
use super::arithmetic::limit::{Limited, in_range};
use super::arithmetic::root::root_over;
use super::arithmetic::turn;
use super::cite::{self, Cites};
use super::fault::Fault;
use super::planted::{self, Bug};
use super::state::{Amounts, C, StoredFeed, W, X, Z};
use super::words::{Address, Words};

/// The kind of an element.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    Rapid,
    Linear,
    /// A linear element of a torque skip at a feed of its own.
    LinearAt(Feed),
    /// With its centre in program coordinates.
    Arc {
        sense: Sense,
        centre_x: i64,
        centre_z: i64,
    },
}

/// One motion element in program coordinates; axes without a target stay.
#[derive(Clone, Copy, Debug)]
pub struct Element {
    pub kind: Kind,
    pub x: Option<i64>,
    pub z: Option<i64>,
    pub w: Option<i64>,
    /// C word and full turns.
    pub c: Option<(Option<i64>, i64)>,
    pub cites: Cites,
    pub readings: ReadingSet,
    /// Whether ranges and limits were applied already.
    pub limited: bool,
}

/// A turn of the C axis: its travel and the machine coordinate it leads to.
#[derive(Clone, Copy)]
pub struct Turn {
    pub travel: i64,
    pub machine: i64,
}

impl Element {
    /// Whether it moves X or Z, even if to where they are.
    pub fn moves_plane(&self) -> bool {
        self.x.is_some() || self.z.is_some()
    }
}

impl Interpreter<'_> {
    /// The rules that every motion of a block cites, feed aside.
    pub(super) fn coordinate_cites(&self, words: &Words) -> Cites {
        let turns = words.has(Address::QA);
        self.plane_cites(words)
            .and_if(turns || words.has(Address::C), cite::CAX_05)
            .and_if(turns, cite::CAX_06)
    }

    /// The rules that every motion in X and Z alone cites, feed aside.
    pub(super) fn plane_cites(&self, words: &Words) -> Cites {
        let incremental = self.state.incremental;
        let x = words.has(Address::X);
        cite::COORD_03
            .and(if incremental { cite::ABS_02 } else { cite::ABS_01 })
            .and_if(x, cite::DIA_01)
            .and_if(x && incremental && !planted::is(Bug::DiameterRule), cite::ABS_03)
            .and_if(self.inch_block, cite::INCH_02)
            .and(self.lap.cites())
    }

    /// The rules of the feed mode in force.
    pub(super) fn feed_cites(&self) -> Cites {
        self.cites_of_feed(self.state.feed)
    }

    /// The same where a stored feed is used.
    pub(super) fn cites_of_feed(&self, stored: Option<StoredFeed>) -> Cites {
        let unit = self.state.feed_unit();
        let mode = if unit == FeedUnit::PerMinute { cite::FEED_02 } else { cite::FEED_01 };
        mode.and_if(stored.is_some_and(|feed| feed.given != unit), cite::FEED_03)
    }

    /// The rules of a linear element, path length aside.
    pub(super) fn linear_cites(&self, words: &Words) -> Cites {
        self.coordinate_cites(words).and(self.feed_cites()).and(cite::G01_01).and(cite::G01_02)
    }

    /// The feed in force (E100L-G01-03, E100L-FEED-03).
    pub(super) fn feed(&self) -> Result<Feed, Fault> {
        self.reading_of(self.state.feed)
    }

    /// A stored feed in the mode in force.
    #[inline]
    pub(super) fn reading_of(&self, stored: Option<StoredFeed>) -> Result<Feed, Fault> {
        match stored {
            Some(feed) => {
                let stale = planted::is(Bug::FeedOfOtherMode) && feed.given != self.state.feed_unit();
                let value = feed.values[usize::from(self.state.per_minute == stale)];
                let unit = self.state.feed_unit();
                let [least, most] = self.units.feeds;
                // Given in this mode it was tested with its word.
                if feed.given != unit && !(least..=most).contains(&value) && !self.lap.reads() {
                    return Fault::raise(AlarmName::AddressRange, rules::ADDR_01);
                }
                Ok(Feed { value: FeedRate(value), unit })
            }
            None if self.lap.reads() => Ok(Feed { value: FeedRate(0), unit: self.state.feed_unit() }),
            None => Fault::raise(AlarmName::NoFeed, rules::G01_03),
        }
    }

    /// The feed of an element, if it cuts.
    #[inline]
    pub(super) fn feed_of(&self, kind: Kind) -> Result<Option<Feed>, Fault> {
        match kind {
            Kind::Rapid => Ok(None),
            Kind::LinearAt(feed) => Ok(Some(feed)),
            Kind::Linear | Kind::Arc { .. } => self.feed().map(Some),
        }
    }

    /// Carries out one element that was found in the coordinates of the contour to which it belongs, if to any.
    #[inline(always)]
    pub(super) fn perform_placed(&mut self, mut element: Element, sink: &mut impl Sink) -> Result<(), Fault> {
        if self.lap.is_active() {
            self.place_element(&mut element)?;
        }
        self.perform(element, sink)
    }

    /// Carries out one element.
    #[inline(always)]
    pub(super) fn perform(&mut self, element: Element, sink: &mut impl Sink) -> Result<(), Fault> {
        if self.compensation.acts() {
            return self.perform_compensated(element, sink);
        }
        // Without compensation the tip follows the programmed path; neither tip nor nose is shown (E100L-NRC-06).
        let Element { kind, x, z, w, c, mut cites, mut readings, limited } = element;
        if !limited {
            for target in [x, z, w].into_iter().flatten() {
                self.check_coordinate(target)?;
            }
        }
        let turn = match c {
            Some((target, turns)) => Some(self.turn(target, turns)?),
            None => None,
        };
        let feed = self.feed_of(kind)?;
        let start = self.state.machine;
        let mut end = start;
        let is_arc = matches!(kind, Kind::Arc { .. });
        for (axis, target) in [(X, x), (Z, z), (W, w)] {
            if let Some(target) = target {
                let machine = to_machine(target, self.state.frame(axis));
                end[axis] = machine;
                if !limited && self.limit(axis, &mut end[axis], is_arc)? {
                    cites = cites.and(cite::LIM_01);
                }
            }
        }
        if self.state.watch.acts() && (x.is_some() || z.is_some()) {
            self.check_barriers(kind, &end, &mut cites, &mut readings)?;
        }
        if let Some(turn) = turn {
            end[C] = turn.machine;
        }
        self.state.machine = end;
        self.state.last_motion_cut =
            feed.is_some() || planted::is(Bug::CuttingForgotten) && self.state.last_motion_cut;
        let program_x = self.state.program(X);
        let mut motion = Motion {
            program: self.position(program_x, self.state.program(Z), |axis| self.state.program(axis)),
            machine: self.position(self.state.machine_x(end[X]), end[Z], |axis| end[axis]),
            c_travel: turn.map(|turn| Angle(turn.travel)),
            ..Motion::default()
        };
        if self.state.constant_speed {
            let from = start[X] - self.state.frame(X);
            let diameter = if planted::is(Bug::SpeedAtStart) { from } else { program_x };
            motion.speed = self.motion_speed(diameter, feed.is_some(), &mut cites, &mut readings);
        }
        let way = (&start, &end, turn.map(|turn| turn.travel));
        let action = self.action((kind, feed), motion, way, &mut cites, &mut readings);
        if self.inch_block {
            readings = readings.union(self.known.inch);
        }
        let rules = self.cites.rules(cites);
        self.emit_with(sink, rules, readings, action);
        Ok(())
    }

    /// The speed of the main spindle at the end of a motion, in constant cutting speed.
    pub(super) fn motion_speed(
        &mut self,
        diameter: i64,
        cuts: bool,
        cites: &mut Cites,
        readings: &mut ReadingSet,
    ) -> Option<Speed> {
        if !self.state.constant_speed {
            return None;
        }
        if self.speed_is_of_other() {
            *cites = cites.and(cite::AX4_08);
            return None;
        }
        let choice = self.spindle_speed(diameter);
        *cites = cites.and(if cuts { cite::CSS_01 } else { cite::CSS_05 });
        match choice.limit {
            Some(SpeedLimit::Clamp) => {
                *cites = cites.and(cite::SMAX_01);
                *readings = readings.union(self.known.clamp);
            }
            Some(_) => *cites = cites.and(cite::CSS_04),
            None => {}
        }
        Some(Speed(choice.value))
    }

    /// What an event says of a motion between two machine positions, with the travel of C.
    #[inline(always)]
    pub(super) fn action(
        &self,
        (kind, feed): (Kind, Option<Feed>),
        motion: Motion,
        (start, end, turn): (&Amounts, &Amounts, Option<i64>),
        cites: &mut Cites,
        readings: &mut ReadingSet,
    ) -> Action {
        *cites = cites.and_if(self.state.mirror < 0, cite::MIRR_05);
        match (kind, feed) {
            (Kind::Arc { sense, centre_x, centre_z }, Some(feed)) => {
                Action::Arc { motion, feed, sense, centre_x: Length(centre_x), centre_z: Length(centre_z) }
            }
            (_, Some(feed)) => {
                let path = self.path(start, end, turn);
                if turn.is_some() {
                    *cites = cites.and(cite::CFEED_01).and(cite::CFEED_03);
                } else {
                    *cites = cites.and(cite::G01_04);
                    *readings = readings.union(self.known.feed_length);
                }
                Action::Linear { motion, feed, path: Length(path) }
            }
            (_, None) => Action::Rapid { motion },
        }
    }

    /// A position, with C and W where they belong to it.
    #[inline]
    pub(super) fn position(&self, x: i64, z: i64, other: impl Fn(usize) -> i64) -> Position {
        Position {
            x: Length(x),
            z: Length(z),
            c: self.state.c_joined.then(|| Angle(other(C))),
            w: self.setup.options.w_axis.then(|| Length(other(W))),
        }
    }

    /// Applies the limits of an axis to a machine coordinate; true when it was replaced.
    #[inline]
    pub(super) fn limit(&self, axis: usize, machine: &mut i64, is_arc: bool) -> Result<bool, Fault> {
        match self.state.limited(axis, *machine) {
            Limited::Within if planted::is(Bug::LimitInclusive) => {
                Ok(self.state.positive_limits[axis] == Some(*machine))
            }
            Limited::Within => Ok(false),
            Limited::AbovePositive(limit) if !is_arc || planted::is(Bug::LimitOfArcs) => {
                *machine = limit;
                Ok(true)
            }
            Limited::AbovePositive(_) => Fault::raise(AlarmName::TravelLimitPositive, rules::LIM_01),
            Limited::BelowNegative => Fault::raise(AlarmName::TravelLimitNegative, rules::LIM_02),
        }
    }

    /// The turn of the C axis to a program coordinate, with so many full turns more (E100L-CAX-05, -06).
    pub(super) fn turn(&mut self, target: Option<i64>, turns: i64) -> Result<Turn, Fault> {
        let present = self.state.program(C);
        let target = match target {
            None => present,
            Some(word) => turn::within(coordinate(present, word, self.state.incremental)),
        };
        self.turn_to(target, turns)
    }

    /// The turn of the C axis to an angle of at most a turn.
    pub(super) fn turn_to(&mut self, target: i64, turns: i64) -> Result<Turn, Fault> {
        if !self.state.c_joined {
            return Fault::raise(AlarmName::CAxisNotJoined, rules::CAX_02);
        }
        if self.state.c_clamped && !planted::is(Bug::ClampLost) {
            return Fault::raise(AlarmName::CAxisClamped, rules::CAX_07);
        }
        let present = self.state.program(C);
        let negative = self.state.c_negative;
        let turns = if planted::is(Bug::TurnsOfNegativeSense) && negative { -turns } else { turns };
        let travel = turn::travel(present, target, turns, negative);
        self.state.contour.wind(travel);
        let machine = to_machine(target, self.state.frame(C));
        let machine = if planted::is(Bug::CWrap) { machine } else { turn::within(machine) };
        Ok(Turn { travel, machine })
    }

    /// The length on which the feed is measured (E100L-G01-04, E100L-CFEED-03).
    #[inline]
    pub(super) fn path(&self, start: &Amounts, end: &Amounts, turn: Option<i64>) -> i64 {
        let square = |axis: usize| feed::square(start[axis], end[axis]);
        let w = if planted::is(Bug::PathWithoutW) { 0 } else { square(W) };
        let (x, along) = (square(X), square(Z) + w);
        let Measure { square, divisor } = match turn {
            Some(travel) => feed::path_with_turn(x, along, travel),
            None => feed::path(x, along, self.setup.readings.feed_length),
        };
        root_over(square, divisor)
    }

    /// A program coordinate within the range of its address (E100L-ADDR-01).
    #[inline]
    pub(super) fn check_coordinate(&self, target: i64) -> Result<(), Fault> {
        if !in_range(target, self.units.longest) {
            return Fault::raise(AlarmName::CoordinateRange, rules::ADDR_01);
        }
        Ok(())
    }
}
