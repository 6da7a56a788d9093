//! The motions of a rough cycle: tests, event, rules (execution of LAP, 13 and 14).

use turnspec_oracle::vocabulary::{Action, Length, Motion, Part, ReadingSet, RuleSet, Sense, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::plane::Point;
use crate::engine::cite::{self, Cites};
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::state::{StoredFeed, X, Z};

use super::definition::Leg;
use super::job::Job;
use super::outline::Element;
use super::plane::Axes;
use super::rules::{self, Rules};
use super::turning::Count;

/// How a motion goes.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    Rapid,
    Line(Option<StoredFeed>),
    Arc(Option<StoredFeed>, Sense, Point),
    Thread(Leg),
}

/// One motion of a cycle.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub way: Way,
    pub end: Point,
    pub part: Part,
    pub pass: Option<u32>,
    pub rules: Rules,
    /// Rules that are none of LAP, and readings.
    pub others: RuleSet,
    pub readings: ReadingSet,
}

impl Interpreter<'_> {
    /// Makes a motion, unless it leads nowhere.
    pub(super) fn travel(&mut self, step: &Step, sink: &mut impl Sink) -> Result<(), Fault> {
        let Step { way, end, part, pass, rules, others, mut readings } = *step;
        if end == self.present() {
            return Ok(());
        }
        let kind = match way {
            Way::Rapid => Kind::Rapid,
            Way::Line(_) | Way::Thread(_) => Kind::Linear,
            Way::Arc(_, sense, centre) => Kind::Arc { sense, centre_x: centre.x, centre_z: centre.z },
        };
        let mut cites = cite::COORD_03.and_if(self.inch_block, cite::INCH_02);
        let feed = match way {
            Way::Rapid | Way::Thread(_) => None,
            Way::Line(feed) | Way::Arc(feed, ..) => {
                cites = cites.and(self.cites_of_feed(feed));
                Some(self.reading_of(feed)?)
            }
        };
        self.check_coordinate(end.x)?;
        self.check_coordinate(end.z)?;
        let start = self.state.machine;
        let mut machine = start;
        for (axis, target) in [(X, end.x), (Z, end.z)] {
            machine[axis] = to_machine(target, self.state.frame(axis));
            // Nothing is cut back, as in arcs.
            self.limit(axis, &mut machine[axis], true)?;
        }
        if self.state.watch.acts() {
            self.check_barriers(kind, &machine, &mut cites, &mut readings)?;
        }
        self.state.machine = machine;
        let cuts = !matches!(way, Way::Rapid);
        self.state.last_motion_cut = cuts;
        let mut motion = Motion {
            program: self.position(end.x, end.z, |axis| self.state.program(axis)),
            machine: self.position(self.state.machine_x(machine[X]), machine[Z], |axis| machine[axis]),
            pass,
            part: Some(part),
            ..Motion::default()
        };
        motion.speed = self.motion_speed(end.x, cuts, &mut cites, &mut readings);
        let action = match way {
            Way::Thread(Leg { lead, axis, change, start, .. }) => {
                cites = cites.and_if(self.state.mirror < 0, cite::MIRR_05);
                Action::Thread { motion, lead, axis, change, start, spindle: None, feed: None }
            }
            _ => self.action((kind, feed), motion, (&start, &machine, None), &mut cites, &mut readings),
        };
        if self.inch_block {
            readings = readings.union(self.known.inch);
        }
        let rules = self.rules_of(cites, rules).union(others);
        self.emit_with(sink, rules, readings, action);
        Ok(())
    }

    /// The set of some citations and rules of LAP.
    fn rules_of(&mut self, cites: Cites, rules: Rules) -> RuleSet {
        let base = &mut self.cites;
        self.lap.cache.rules(cites, rules, || base.rules(cites))
    }

    /// Cuts along an element of the contour to a point of it, at its feed or else at that of the pass (E100L-LAP-07,
    /// E100L-LAP-08, E100L-LAP-16).
    pub(super) fn cut_element(
        &mut self,
        job: &Job,
        count: &Count,
        (element, end, of_pass): (&Element, Point, Option<StoredFeed>),
        own: Rules,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let feed = element.feed.or(job.kept_feed).or(of_pass);
        let way = match element.arc {
            Some((sense, centre)) => Way::Arc(feed, sense, centre),
            None => Way::Line(feed),
        };
        let of_feed = if element.feed.is_some() { rules::LAP_07 } else { rules::LAP_08 };
        let own = own.and(of_feed).and_if(element.compensated, rules::LAP_16);
        let named = element.feed.is_none() && job.names_feed;
        let readings = if named { self.known.contour_feed } else { ReadingSet::default() };
        let step = Step {
            way,
            end,
            part: Part::Contour,
            pass: Some(count.number),
            rules: Self::cited(job, count, own),
            others: RuleSet::EMPTY,
            readings,
        };
        self.travel(&step, sink)
    }

    /// Whether a coordinate of the infeed axis lies above the present point.
    pub(super) fn is_above_present(&self, axes: Axes, infeed: i64) -> bool {
        let (present, _) = axes.split(self.present());
        axes.height(infeed) > axes.height(present)
    }
}

/// An amount of 0.2, which a tool is lifted above what it has cut.
pub const SMALL_LIFT: Length = Length(200_000);
