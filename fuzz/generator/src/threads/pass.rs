//! Where a pass goes (execution of threads, 5), to within roundings, and whether the control would refuse it.

use turnspec_oracle::vocabulary::{FeedLength, SpeedClamp, TaperReference, ThreadShift};

use crate::builder::Builder;
use crate::geometry::Point;
use crate::state::{Axis, Mode, State};

/// Nanometres of withdrawal a minute for a parameter of 1 (E100L-TCHM-03).
const RATE: f64 = 4_687_500.0;

/// A lead and its change per revolution, in nanometres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lead {
    pub start: f64,
    pub change: f64,
}

impl Lead {
    /// The lead at a distance; none where it leaves the range of leads, or nearly so.
    pub fn at(self, distance: f64) -> Option<f64> {
        let square = self.start * self.start + 2.0 * self.change * distance;
        (1_001.0 * 1_001.0..=999_000_000.0 * 999_000_000.0).contains(&square).then(|| square.sqrt())
    }
}

/// How the level of a thread changes from its start to its end.
#[derive(Clone, Copy, Debug)]
pub(super) enum Taper {
    /// By a difference of levels.
    Amount(i64),
    /// At an angle in micro-degrees.
    Angle(i64),
}

/// What a pass is given by; the level is the diameter of a thread along Z, and Z of one on the face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass {
    pub face: bool,
    /// Along the lead axis.
    pub end: i64,
    pub level: i64,
    pub taper: Taper,
    pub shift: i64,
    pub flank: i64,
    pub lead: Lead,
    pub run_out: Option<i64>,
}

/// A point along the lead axis and its level.
type Place = (i64, i64);

impl State {
    /// The speed of the main spindle, where it is known and not zero.
    pub(super) fn turning_speed(&self) -> Option<f64> {
        let threads = &self.threads;
        let clamped = self.setup.readings.speed_clamp == SpeedClamp::Always;
        let clamp = threads.clamp.filter(|_| clamped).unwrap_or(i64::MAX);
        let speed = threads.speed.min(clamp);
        (threads.turning && speed > 0).then_some(speed as f64)
    }

    /// By what a travel of X counts as a way of the slide.
    pub(super) fn way_of_x(&self) -> f64 {
        match self.setup.readings.feed_length {
            FeedLength::Radius => 0.5,
            FeedLength::Diameter => 1.0,
        }
    }

    /// The way along the lead axis between two coordinates.
    pub(crate) fn along(&self, face: bool, from: i64, to: i64) -> f64 {
        let way = from.abs_diff(to) as f64;
        if face { way * self.way_of_x() } else { way }
    }

    /// Lead axis and axis of the level.
    pub(super) fn axes(face: bool) -> (Axis, Axis) {
        if face { (Axis::X, Axis::Z) } else { (Axis::Z, Axis::X) }
    }

    /// The places of a pass from its cycle start, both ends of each motion; none where the control would refuse it.
    pub(super) fn way_of(&self, pass: &Pass) -> Option<Vec<Place>> {
        let (lead_axis, level_axis) = Self::axes(pass.face);
        let (start, start_level) = (self.program(lead_axis), self.program(level_axis));
        let direction = (pass.end - start).signum();
        let begin = match self.setup.readings.thread_shift {
            ThreadShift::TowardEnd => start + direction * pass.shift,
            ThreadShift::Coordinate => start + pass.shift,
        };
        if direction == 0 || direction * (pass.end - begin) <= 0 {
            return None;
        }
        let taper = pass.difference(begin)?;
        let (first, last) = match self.setup.readings.taper_reference {
            TaperReference::Start => (pass.level, pass.level + taper),
            TaperReference::End => (pass.level - taper, pass.level),
        };
        let side = (start_level - pass.level).signum();
        if side == 0 || [first, last].iter().any(|level| side * (start_level - level) <= 0) {
            return None;
        }
        let length = self.along(pass.face, begin, pass.end);
        pass.lead.at(length)?;
        let (begin, end) = (begin + pass.flank, pass.end + pass.flank);
        let mut places = vec![(start, start_level), (begin, first)];
        if self.threads.chamfer {
            let level = self.chamfer(pass, (first, last), side, length)?;
            places.push((end - direction * pass.run_out.unwrap_or(0), level));
        } else {
            places.push((end, last));
        }
        places.extend([(end, start_level), (start, start_level)]);
        let fits = |place: &Place| {
            self.fits(lead_axis, place.0)
                && self.fits(level_axis, place.1)
                && place.0.abs().max(place.1.abs()) < 90_000_000_000
        };
        places.iter().all(fits).then_some(places)
    }

    /// The level where a chamfer begins; none where there is none or it could not be cut.
    fn chamfer(&self, pass: &Pass, (first, last): (i64, i64), side: i64, length: f64) -> Option<i64> {
        let run_out = pass.run_out.map_or(pass.lead.start, |word| word as f64);
        if run_out == 0.0 {
            return Some(last);
        }
        let speed = self.turning_speed()?;
        if run_out > length {
            return None;
        }
        let lead = pass.lead.at(length - run_out)?;
        let part = (last - first) as f64 * run_out / length;
        let level = last as f64 - part;
        let rate = RATE * self.setup.parameters.thread_chamfer_feed as f64;
        let rise = rate * run_out / (speed * lead) / if pass.face { 1.0 } else { self.way_of_x() };
        let opens = part * side as f64;
        let reaches = rise > side as f64 * (self.program(Self::axes(pass.face).1) as f64 - level);
        (reaches || rise > opens * 1.001 + 10.0).then_some(level as i64)
    }
}

impl Pass {
    /// The level at the end less that at the start; none where the angle does not reach the end.
    fn difference(&self, begin: i64) -> Option<i64> {
        let angle = match self.taper {
            Taper::Amount(amount) => return Some(amount),
            Taper::Angle(angle) => angle,
        };
        let travel = (self.end - begin) as f64;
        let (sine, cosine) = (angle as f64 / 1e6).to_radians().sin_cos();
        let (steep, level) = if self.face {
            (sine, travel / 2.0 * cosine / sine)
        } else {
            (cosine, 2.0 * travel * sine / cosine)
        };
        (steep.abs() > 0.001 && level.abs() < 1e11).then_some(level.round() as i64)
    }
}

impl Builder<'_, '_, '_> {
    /// Notes the motions of a pass: the first and the last are positionings.
    pub(super) fn note_places(&mut self, face: bool, places: &[Place]) {
        let mode = self.state.mode;
        let point = |(lead, level): Place| if face { Point::of(lead, level) } else { Point::of(level, lead) };
        for (number, way) in places.windows(2).enumerate() {
            let [from, to] = [point(way[0]), point(way[1])];
            let rapid = number == 0 || number + 2 == places.len();
            self.state.mode = if rapid { Mode::Rapid } else { Mode::Linear };
            self.state.control.note_way([to.diameter(), to.coordinate()]);
            self.watch(from, to, None);
        }
        self.state.mode = mode;
        self.state.after_cutting = false;
    }
}
