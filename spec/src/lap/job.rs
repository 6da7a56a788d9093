//! What a rough cycle has to do: the data of its call, and its contour in its place (execution-lap.md, section 7).

use super::contour::{Element, Outline};
use super::motion::Course;
use super::plane::{Plane, Spot};
use super::recording::{Kind, Recording};
use crate::fault::{Fault, Outcome, fail};
use crate::modal::{Plan, Words};
use crate::path::coordinate_readings;
use crate::state::{State, StoredFeed};
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, ContourFeed, RuleId, Setup};

/// A rough cycle before its first pass.
#[derive(Clone, Debug)]
pub struct Job {
    /// The code of the call.
    pub code: u16,
    /// Its words.
    pub words: Words,
    /// How the contour lies.
    pub plane: Plane,
    /// S: where the tool is in the call.
    pub start: Spot,
    /// The rough contour (E100L-LAP-21); for G88 the contour.
    pub rough: Outline,
    /// The blank.
    pub blank: Option<Outline>,
    /// r.
    pub relief: i64,
    /// c.
    pub clearance: i64,
    /// F.
    pub feed: Option<StoredFeed>,
    /// The E of elements that have none (E100L-LAP-08).
    kept_feed: Option<StoredFeed>,
    /// Whether the first motion of the contour is in G00 (E100L-LAP-05).
    pub rapid_first: bool,
    /// Whether the tool returns to S (E100L-LAPC-08).
    pub returns: bool,
    /// What all events name.
    pub cited: Cited,
    reading: ContourFeed,
}

impl Job {
    /// The data of a call, with what was recorded; `kept` is the contour feed commanded last before it. The tests up to
    /// that of the allowances.
    pub fn new(call: &Plan, recording: &Recording, kept: Option<StoredFeed>, state: &State) -> Outcome<Self> {
        let (words, transverse) = (&call.words, recording.transverse);
        let code = call.one_shot.unwrap_or_default();
        refuse_other_axis(code, words, transverse)?;
        let present = state.frame.program();
        let start = Plane { transverse, up: 1, onward: 1 }.spot((present.x, present.z));
        let allowances = allowances(words, transverse);
        let plane = plane(code, recording, start, allowances)?;
        let contour = Outline::of_contour(&recording.contour, plane);
        let blank = recording.blank.as_ref();
        let blank = blank.map(|motions| Outline::of_blank(motions, &recording.contour, plane));
        let rough = match code {
            88 => contour,
            // E100L-LAP-21.
            _ => contour.moved(plane.up * allowances.0, -plane.onward * allowances.1),
        };
        let parameters = &state.setup.parameters;
        let reading = state.setup.readings.contour_feed;
        Ok(Self {
            code,
            words: words.clone(),
            plane,
            start,
            rough,
            relief: i64::from(parameters.lap_relief) * 1_000,
            clearance: i64::from(parameters.lap_clearance) * 1_000,
            feed: state.feed,
            kept_feed: kept.filter(|_| reading == ContourFeed::Kept),
            rapid_first: matches!(recording.contour.first().map(|first| &first.kind), Some(Kind::Rapid)),
            returns: !words.m.contains(&85),
            cited: cited(call, recording, blank.is_some(), state.setup),
            blank,
            reading,
        })
    }

    /// D.
    pub fn depth(&self) -> i64 {
        self.words.get('D').unwrap_or(0)
    }

    /// E100L-AP4-03: whether S is nearer to the start of the rough contour than the clearance.
    pub fn is_near(&self) -> bool {
        self.plane.onward * (self.rough.start.cutting - self.start.cutting) < self.clearance
    }

    /// E100L-AP1-12, E100L-AP5-03: the relief that counts as a radius in X, along the infeed axis and along the cutting
    /// axis.
    pub fn double_relief(&self) -> (i64, i64) {
        if self.plane.transverse { (self.relief, 2 * self.relief) } else { (2 * self.relief, self.relief) }
    }

    /// The motion along an element of the contour, and what it names; `feed` is that of the pass (E100L-LAP-07,
    /// E100L-LAP-08). Mode II takes F where no E was given, whatever the reading.
    pub fn along(&self, element: &Element, feed: Option<StoredFeed>) -> (Course, Cited) {
        let copying = self.code == 86 && self.blank.is_none();
        let (feed, cited) = match (element.feed, copying) {
            (Some(own), _) => (Some(own), Cited::rules(&[LAP_07])),
            (None, true) => (feed, Cited::rules(&[LAP_08])),
            (None, false) => (self.kept_feed.or(feed), Cited::rules(&[LAP_08]).reading(self.reading)),
        };
        let course = match element.arc {
            Some((centre, sense)) => Course::Arc(centre, sense, feed),
            None => Course::Line(feed),
        };
        (course, cited.and_if(element.compensated, Cited::rules(&[LAP_16])))
    }
}

/// U and W as amounts on the infeed axis and on the cutting axis.
fn allowances(words: &Words, transverse: bool) -> (i64, i64) {
    let (x, z) = (words.get('U').unwrap_or(0), words.get('W').unwrap_or(0));
    if transverse { (z, x) } else { (x, z) }
}

/// E100L-LAPC-02, E100L-LAPC-07: words of the axis that is not the infeed axis.
fn refuse_other_axis(code: u16, words: &Words, transverse: bool) -> Outcome<()> {
    let points = if transverse { ["XA", "XB"] } else { ["ZA", "ZB"] };
    let written = words.written.iter().map(|word| word.label());
    let (other, rule): (&[&str], RuleId) = match code {
        88 => (if transverse { &["U"] } else { &["W"] }, LAPC_07),
        _ => (&points, LAPC_02),
    };
    let mut wrong = written.filter(|label| code != 86 && other.contains(&label.as_str()));
    match wrong.next() {
        Some(label) => Err(Fault::about(AlarmName::WordWithoutFunction, rule, label.as_str())),
        None => Ok(()),
    }
}

/// E100L-LAP-20, E100L-AP2-01: to which side the work lies, and in which sense it is cut.
fn plane(code: u16, recording: &Recording, start: Spot, allowances: (i64, i64)) -> Outcome<Plane> {
    let transverse = recording.transverse;
    let unsigned = Plane { transverse, up: 1, onward: 1 };
    let contour = Outline::of_contour(&recording.contour, unsigned);
    let (infeed, cutting) = if transverse { ("Z", "X") } else { ("X", "Z") };
    let refused = |axis| Err(Fault::about(AlarmName::LapStartPoint, LAP_20, axis));
    let up = (start.infeed - contour.start.infeed).signum();
    if up == 0 {
        return refused(infeed);
    }
    if code == 88 {
        return Ok(Plane { transverse, up, onward: 1 });
    }
    let onward = (contour.end().cutting - contour.start.cutting).signum();
    let copying = code == 86 && recording.blank.is_none();
    if onward == 0 && !(copying && allowances.1 == 0) {
        return Err(Fault::about(AlarmName::Unspecified, LAP_20, "direction"));
    }
    if onward * (contour.start.cutting - start.cutting) < 0 {
        return refused(cutting);
    }
    if up * (start.infeed - contour.start.infeed) <= allowances.0 {
        let rule: RuleId = if copying { AP2_01 } else { LAP_20 };
        let detail = if transverse { "W" } else { "U" };
        return Err(Fault::about(AlarmName::LapAllowance, rule, detail));
    }
    Ok(Plane { transverse, up, onward })
}

/// What all events of a cycle name.
fn cited(call: &Plan, recording: &Recording, blank: bool, setup: &Setup) -> Cited {
    let words = &call.words;
    let (own, transverse): (RuleId, Option<RuleId>) = match (call.one_shot, blank) {
        (Some(85), false) => (LAPC_01, Some(AP1_14)),
        (Some(85), true) => (LAPC_01, Some(AP4_09)),
        (Some(86), false) => (LAPC_05, Some(AP2_02)),
        (Some(86), true) => (LAPC_05, None),
        _ => (LAPC_07, Some(AP3_03)),
    };
    let transverse = transverse.filter(|_| recording.transverse);
    let allowance = ['U', 'W'].into_iter().any(|letter| words.get(letter).unwrap_or(0) != 0);
    let inch = Cited { rules: Cited::rules(&[INCH_02]).rules, readings: coordinate_readings(call, setup) };
    let cited = Cited::rules(&[COORD_03, LAP_01, LAP_09, LAP_18, own])
        .and_if(blank, Cited::rules(&[LAP_02]))
        .and_if(allowance, Cited::rules(&[LAP_21]))
        .and_if(words.inch, inch);
    transverse.map_or(cited, |rule| cited.and(Cited::rules(&[rule])))
}

/// E100L-AP1-02, E100L-AP4-06, E100L-AP5-08: the rough contour, then the blank, run in the direction of cutting.
pub fn check_direction(job: &Job) -> Outcome<()> {
    let outlines = [Some(&job.rough), job.blank.as_ref()];
    if outlines.into_iter().flatten().all(|outline| outline.runs_onward(job.plane)) {
        return Ok(());
    }
    match (job.code, &job.blank) {
        (86, _) => fail(AlarmName::ContourDirection, AP5_08),
        (_, None) => Err(Fault::about(AlarmName::Unspecified, AP1_02, "direction")),
        (_, Some(_)) => Err(Fault::about(AlarmName::Unspecified, AP4_06, "direction")),
    }
}
