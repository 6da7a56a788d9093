//! A call with what it has read: its data, and what is tested before its first pass (execution of LAP, 7).

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids;
use turnspec_oracle::vocabulary::{AlarmName, ContourFeed, Label, RuleId};

use crate::engine::Interpreter;
use crate::engine::arithmetic::lap;
use crate::engine::arithmetic::plane::Point;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::StoredFeed;
use crate::engine::words::{Address, Words};

use super::definition::{Course, Recorded};
use super::outline::{Outline, blank_elements, elements};
use super::plane::Axes;
use super::read::Reading;
use super::rules::{self, Rules};
use super::{Code, unspecified};

/// Most falling slopes (E100L-AP1-13).
const MOST_DESCENTS: usize = 10;

/// Depth and feed behind a change point (E100L-LAPC-03).
#[derive(Clone, Copy, Debug)]
pub struct Change {
    pub place: i64,
    pub depth: i64,
    pub feed: Option<StoredFeed>,
    /// Whether they are others than D and F.
    pub differs: bool,
}

/// Depth and feed of a pass.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    pub depth: i64,
    pub feed: Option<StoredFeed>,
    /// Whether they are others than D and F.
    pub differs: bool,
}

/// What all cycles have in common.
#[derive(Debug)]
pub struct Job {
    pub axes: Axes,
    /// The AP start.
    pub start: Point,
    /// The rough contour; of mode III the contour.
    pub contour: Outline,
    pub blank: Option<Outline>,
    /// D and F.
    pub depth: i64,
    pub feed: Option<StoredFeed>,
    /// The last change point that is given first.
    pub changes: [Option<Change>; 2],
    /// r and c, on the coordinates.
    pub relief: i64,
    pub clearance: i64,
    /// Whether the first motion of the contour is in G00.
    pub first_rapid: bool,
    /// Whether M85 keeps the tool where it is.
    pub stays: bool,
    /// The last E before the call, where it counts.
    pub kept_feed: Option<StoredFeed>,
    /// Whether the feed of an element without E depends on the reading.
    pub names_feed: bool,
    /// Whether it cuts at falling levels.
    pub has_levels: bool,
    /// What every motion cites.
    pub every: Rules,
}

impl Job {
    /// Depth and feed below a level.
    pub fn below(&self, level: i64) -> Cut {
        let reached = |change: &&Change| {
            let missed = level == change.place && planted::is(Bug::ChangeBehindPoint);
            lap::is_reached(level, change.place, self.axes.infeed) && !missed
        };
        match self.changes.iter().flatten().find(reached) {
            Some(change) => Cut { depth: change.depth, feed: change.feed, differs: change.differs },
            None => Cut { depth: self.depth, feed: self.feed, differs: false },
        }
    }

    /// Whether a level lies above a coordinate of the infeed axis.
    pub fn is_above(&self, level: i64, coordinate: i64) -> bool {
        self.axes.height(level) > self.axes.height(coordinate)
    }

    /// The coordinate of the cutting axis, on the line from the AP start to the start of the rough contour, at a
    /// level: a quotient of two numbers, the second of which is not zero.
    pub fn on_start_line(&self, level: i64) -> (i128, i128) {
        lap::on_line(self.axes.split(self.start), self.axes.split(self.contour.start), level)
    }
}

impl Interpreter<'_> {
    /// What a call has to do, with the tests that come before its first pass.
    pub(super) fn job(
        &mut self,
        words: &Words,
        code: Code,
        reading: &Reading,
        kept_feed: Option<StoredFeed>,
    ) -> Result<Job, Fault> {
        if code == Code::Thread {
            self.check_spindle()?;
        }
        check_axis_words(words, code, reading.along)?;
        let contour = &reading.definition.contour_motions;
        let (first, end) = match (contour.first(), contour.last()) {
            (Some(first), Some(last)) => (first.end, last.end),
            _ => return Err(super::malformed(rule_ids::LAP_01, const { Label::new("empty") })),
        };
        let start = self.present();
        let mut axes = Axes { along: reading.along, infeed: 1, cutting: 0 };
        let ((start_i, start_k), (first_i, first_k)) = (axes.split(start), axes.split(first));
        let names = if axes.along { ["X", "Z"] } else { ["Z", "X"] };
        axes.infeed = compare(start_i, first_i);
        if axes.infeed == 0 {
            return Err(start_point(names[0]));
        }
        let word = |address| words.get(address).unwrap_or_default();
        let allowance = Point { x: word(Address::U), z: word(Address::W) };
        let (on_infeed, on_cutting) = axes.split(allowance);
        let copies = code == Code::Copy && !reading.blank;
        if code != Code::Thread {
            axes.cutting = compare(axes.split(end).1, first_k);
            if axes.cutting == 0 && !(copies && on_cutting == 0) {
                return Err(unspecified(rule_ids::LAP_20, const { Label::new("direction") }));
            }
            if axes.cutting * compare(first_k, start_k) < 0 {
                return Err(start_point(names[1]));
            }
            let left = i128::from(start_i).abs_diff(i128::from(first_i));
            let over = u128::from(planted::is(Bug::AllowanceUpToStart));
            if left + over <= i128::from(on_infeed).unsigned_abs() {
                let rule = if copies { rule_ids::AP2_01 } else { rule_ids::LAP_20 };
                return Err(allowance_fault(rule, if axes.along { "U" } else { "W" }));
            }
        }
        let cutting_sense = if planted::is(Bug::AllowanceForward) { axes.cutting } else { -axes.cutting };
        let shift = match code {
            Code::Thread => Point::default(),
            _ => axes.point(axes.infeed * on_infeed, cutting_sense * on_cutting),
        };
        let moved = elements(first, contour).map(|element| element.moved(shift)).collect();
        let blank = reading.blank.then(|| {
            // E100L-LAP-02: it has the ends of the contour as they are programmed.
            let programmed = |motion: Option<&Recorded>| motion.map_or(first, |motion| motion.programmed);
            let (first, end) = (programmed(contour.first()), programmed(contour.last()));
            let elements = blank_elements(axes, first, end, &reading.definition.blank_motions);
            Outline::new(axes, first, elements)
        });
        let every = self.rules_of_every(code, axes, &allowance, blank.is_some());
        let parameters = &self.setup.parameters;
        let kept = self.setup.readings.contour_feed == ContourFeed::Kept;
        let mut job = Job {
            axes,
            start,
            contour: Outline::new(axes, first.plus(shift), moved),
            blank,
            depth: word(Address::D),
            feed: self.state.feed,
            changes: [None; 2],
            relief: i64::from(parameters.lap_relief) * 1000,
            clearance: i64::from(parameters.lap_clearance) * 1000,
            first_rapid: contour.first().is_some_and(|motion| matches!(motion.course, Course::Rapid)),
            stays: words.has_m(85) && !planted::is(Bug::AlwaysHome),
            kept_feed: kept_feed.filter(|_| (kept || planted::is(Bug::KeptFeedAlways)) && !copies),
            names_feed: !copies,
            has_levels: code == Code::Turn,
            every,
        };
        self.take_changes(words, &mut job)?;
        check_outlines(&job, code, reading.blank)?;
        let begin = job.blank.as_ref().map_or(job.contour.start, |blank| blank.start);
        let before = axes.cutting * (axes.split(begin).1 - axes.split(job.contour.start).1);
        if code == Code::Copy && before > job.clearance {
            return Err(allowance_fault(rule_ids::AP5_02, if axes.along { "W" } else { "U" }));
        }
        Ok(job)
    }

    /// The change points of G84 (E100L-LAPC-02, E100L-LAPC-04).
    fn take_changes(&self, words: &Words, job: &mut Job) -> Result<(), Fault> {
        if !words.has_g(84) {
            return Ok(());
        }
        let (first, second) =
            if job.axes.along { (Address::XA, Address::XB) } else { (Address::ZA, Address::ZB) };
        let [_, first_feed, second_feed] = words.contour_feeds;
        let feed = |address, number, or| match words.has(address) {
            true => self.stored(number).map(Some),
            false => Ok(or),
        };
        let depth_a = words.get(Address::DA).unwrap_or(job.depth);
        let feed_a = feed(Address::FA, first_feed, job.feed)?;
        let depth_b = words.get(Address::DB).unwrap_or(depth_a);
        let feed_b = feed(Address::FB, second_feed, feed_a)?;
        let in_force = |feed: Option<StoredFeed>| {
            feed.and_then(|feed| feed.values.get(usize::from(!self.state.per_minute)).copied())
        };
        let change = |address, depth, feed| {
            let differs = depth != job.depth || in_force(feed) != in_force(job.feed);
            words.get(address).map(|place| Change { place, depth, feed, differs })
        };
        let (a, b) = (change(first, depth_a, feed_a), change(second, depth_b, feed_b));
        let mut before = job.axes.split(job.start).0;
        for (address, change) in [(first, a), (second, b)] {
            let Some(change) = change else { continue };
            if !job.is_above(before, change.place) {
                let detail = Label::new(address.text());
                return Err(Fault::about(AlarmName::LapData, rule_ids::LAPC_04, detail));
            }
            before = change.place;
        }
        job.changes = [b, a];
        Ok(())
    }

    fn rules_of_every(&self, code: Code, axes: Axes, allowance: &Point, blank: bool) -> Rules {
        let (of_call, of_mode, across) = match (code, blank) {
            (Code::Turn, false) => (rules::LAPC_01, rules::AP1_01, rules::AP1_14),
            (Code::Turn, true) => (rules::LAPC_01, Rules::default(), rules::AP4_09),
            (Code::Thread, _) => (rules::LAPC_07, Rules::default(), rules::AP3_03),
            (_, false) => (rules::LAPC_05, Rules::default(), rules::AP2_02),
            (_, true) => (rules::LAPC_05, Rules::default(), Rules::default()),
        };
        rules::LAP_01
            .and(rules::LAP_09)
            .and(rules::LAP_18)
            .and(of_call)
            .and(of_mode)
            .and_if(!axes.along, across)
            .and_if(*allowance != Point::default(), rules::LAP_21)
            .and_if(blank, rules::LAP_02)
    }
}

/// The sign of the difference of two coordinates.
fn compare(first: i64, second: i64) -> i64 {
    match first.cmp(&second) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}

/// The words that belong to the other axis (E100L-LAPC-02, E100L-LAPC-07).
fn check_axis_words(words: &Words, code: Code, along: bool) -> Result<(), Fault> {
    let (limits, allowance) = match along {
        true => (Address::set(&[Address::ZA, Address::ZB]), Address::W),
        false => (Address::set(&[Address::XA, Address::XB]), Address::U),
    };
    let (set, rule) = match code {
        Code::Turn => (limits, rule_ids::LAPC_02),
        Code::Thread => (allowance.bit(), rule_ids::LAPC_07),
        _ => return Ok(()),
    };
    match words.order().iter().find(|address| address.bit() & set != 0) {
        Some(address) => Err(Fault::about(AlarmName::WordWithoutFunction, rule, Label::new(address.text()))),
        None => Ok(()),
    }
}

/// Direction of contour and blank, and how many slopes fall.
fn check_outlines(job: &Job, code: Code, blank: bool) -> Result<(), Fault> {
    if code == Code::Thread || code == Code::Copy && !blank {
        return Ok(());
    }
    let backward =
        !job.contour.runs_forward() || job.blank.as_ref().is_some_and(|blank| !blank.runs_forward());
    if backward && code == Code::Copy {
        return Fault::raise(AlarmName::ContourDirection, rule_ids::AP5_08);
    }
    if backward {
        let rule = if blank { rule_ids::AP4_06 } else { rule_ids::AP1_02 };
        return Err(unspecified(rule, const { Label::new("direction") }));
    }
    if code == Code::Turn && job.contour.descents() > MOST_DESCENTS {
        return Fault::raise(AlarmName::DescendingSlopes, rule_ids::AP1_13);
    }
    Ok(())
}

#[cold]
fn start_point(axis: &str) -> Fault {
    Fault::about(AlarmName::LapStartPoint, rule_ids::LAP_20, Label::new(axis))
}

#[cold]
fn allowance_fault(rule: RuleId, address: &str) -> Fault {
    Fault::about(AlarmName::LapAllowance, rule, Label::new(address))
}
