//! Lines: their targets, A words among them (execution, chapter 5, A words).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, IncrementalAfterChamfer, ReadingSet, Sink};

use super::Interpreter;
use super::ahead::Need;
use super::arithmetic::frame::coordinate;
use super::arithmetic::plane::Point;
use super::block::Plan;
use super::cite::{self, Cites};
use super::exact::{Formula, Real, round};
use super::fault::Fault;
use super::motion::{Element, Kind};
use super::planted::{self, Bug};
use super::slot::Slot;
use super::state::{Base, W, X, Z};
use super::words::{Address, Words};

/// What a block says about the end of its line.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    x: Option<i64>,
    z: Option<i64>,
    angle: Option<i64>,
    incremental: bool,
}

impl Course {
    /// The course of a block in a dimension mode.
    pub fn of(words: &Words, incremental: bool) -> Self {
        let [x, z, angle] = [Address::X, Address::Z, Address::A].map(|address| words.get(address));
        Self { x, z, angle, incremental }
    }

    /// The dimension mode of a block that follows another mode.
    pub fn mode(words: &Words, before: bool) -> bool {
        words.has_g(91) || before && !words.has_g(90)
    }

    /// The coordinates that the words give, counted from a reference point.
    fn coordinates(&self, reference: Point) -> (Option<i64>, Option<i64>) {
        let from = |reference: i64, word: i64| coordinate(reference, word, self.incremental);
        (self.x.map(|x| from(reference.x, x)), self.z.map(|z| from(reference.z, z)))
    }

    /// The end of a line from an anchor, unless only A is given; a coordinate that is not given is that of
    /// the anchor.
    pub fn end(
        &self,
        anchor: Point,
        reference: Point,
        slow: &mut super::exact::SlowPaths,
    ) -> Result<Point, Fault> {
        match (self.coordinates(reference), self.angle) {
            ((Some(x), None), Some(angle)) => {
                if angle.rem_euclid(HALF_TURN) == 0 {
                    return Fault::raise(AlarmName::AngleNoIntersection, rules::DTAP_04);
                }
                let taper = Taper { from: anchor.z, along: x.saturating_sub(anchor.x), angle, to_x: false };
                Ok(Point { x, z: round(&taper, slow) })
            }
            ((None, Some(z)), Some(angle)) => {
                if angle.rem_euclid(HALF_TURN) == HALF_TURN / 2 {
                    return Fault::raise(AlarmName::AngleNoIntersection, rules::DTAP_04);
                }
                let taper = Taper { from: anchor.x, along: z.saturating_sub(anchor.z), angle, to_x: true };
                Ok(Point { x: round(&taper, slow), z })
            }
            ((x, z), _) => Ok(Point { x: x.unwrap_or(anchor.x), z: z.unwrap_or(anchor.z) }),
        }
    }

    /// The A word, if it is the only coordinate.
    pub fn only_angle(&self) -> Option<i64> {
        self.angle.filter(|_| self.x.is_none() && self.z.is_none())
    }
}

/// Half a turn in micro-degrees.
pub const HALF_TURN: i64 = 180_000_000;

/// The coordinate that an angle and the other coordinate determine (E100L-DTAP-03):
/// Z + dX / (2 tan A), or X + 2 dZ tan A.
pub struct Taper {
    pub from: i64,
    pub along: i64,
    pub angle: i64,
    pub to_x: bool,
}

impl Formula for Taper {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let (sine, cosine) = R::sine_cosine(self.angle, precision);
        let along = R::integer(self.along.into(), precision);
        let two = R::integer(if planted::is(Bug::TaperRadius) { 1 } else { 2 }, precision);
        let change = if self.to_x {
            along.times(&two).times(&sine).over(&cosine)
        } else {
            along.times(&cosine).over(&sine.times(&two))
        };
        R::integer(self.from.into(), precision).plus(&change)
    }
}

/// The intersection of two lines given by a point and an angle each (E100L-ANG-06).
struct Crossing {
    from: Point,
    through: Point,
    first: i64,
    second: i64,
    to_x: bool,
}

impl Formula for Crossing {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value: i64| R::integer(value.into(), precision);
        let (sine_2, cosine_2) = R::sine_cosine(self.second, precision);
        let (sine_between, _) = R::sine_cosine(self.second.saturating_sub(self.first), precision);
        // In half nanometres: twice Z, and the diameter.
        let across_z = integer(self.through.z.saturating_sub(self.from.z)).times(&integer(2));
        let across_x = integer(self.through.x.saturating_sub(self.from.x));
        let cross = across_z.times(&sine_2).minus(&across_x.times(&cosine_2));
        let distance = cross.over(&sine_between);
        let (sine_1, cosine_1) = R::sine_cosine(self.first, precision);
        if self.to_x {
            integer(self.from.x).plus(&sine_1.times(&distance))
        } else {
            integer(self.from.z).plus(&cosine_1.times(&distance).over(&integer(2)))
        }
    }
}

/// The end of the line of a block.
#[derive(Clone, Copy, Debug)]
pub struct LineEnd {
    /// The end point; a coordinate without a word is that of the anchor.
    pub point: Point,
    /// Whether X and Z are commanded or computed.
    pub x: bool,
    pub z: bool,
    /// The corner after this one, when the block has only A.
    pub beyond: Option<Point>,
    /// Where the line begins: the present point, or the corner of an any-angle chamfer.
    pub anchor: Point,
    pub cites: Cites,
    pub readings: ReadingSet,
}

impl Interpreter<'_> {
    /// The present program point.
    pub(super) fn present(&self) -> Point {
        Point { x: self.state.program(X), z: self.state.program(Z) }
    }

    /// The present point in the coordinates of words: those of the contour that G87 carries out, or program coordinates.
    #[inline]
    pub(super) fn origin(&self) -> Point {
        self.present().minus(self.lap.shift())
    }

    /// A block with G00 or G01 and no chamfer.
    pub(super) fn line(&mut self, slot: &Slot, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        let words = &slot.words;
        let mut cites = if plan.motion == 0 {
            self.coordinate_cites(words).and(cite::G00_01)
        } else {
            self.linear_cites(words)
        };
        let angle_target = self.state.angle_target.take();
        let (mut x, mut z, mut readings) = (None, None, ReadingSet::default());
        if words.has_any(Address::set(&[Address::X, Address::Z, Address::A])) {
            let base = self.state.base.take();
            if base.is_none() && angle_target.is_none() && !words.has(Address::A) {
                // Its words alone tell its end.
                (x, z) = Course::of(words, self.state.incremental).coordinates(self.origin());
            } else {
                let end = self.line_end(slot, plan, base, angle_target, sink)?;
                x = end.x.then_some(end.point.x);
                z = end.z.then_some(end.point.z);
                cites = cites.and(end.cites);
                readings = end.readings;
                self.state.angle_target = end.beyond.map(|point| (point.x, point.z));
            }
        }
        let w =
            words.get(Address::W).map(|word| coordinate(self.state.program(W), word, self.state.incremental));
        let turns = words.get(Address::QA);
        let c_word = words.get(Address::C);
        let c = (turns.is_some() || c_word.is_some()).then(|| (c_word, turns.unwrap_or_default()));
        let kind = if plan.motion == 0 { Kind::Rapid } else { Kind::Linear };
        self.perform_placed(Element { kind, x, z, w, c, cites, readings, limited: false }, sink)
    }

    /// Where the line of the block in progress ends.
    pub(super) fn line_end(
        &mut self,
        slot: &Slot,
        plan: Plan,
        base: Option<Base>,
        angle_target: Option<(i64, i64)>,
        sink: &mut impl Sink,
    ) -> Result<LineEnd, Fault> {
        let words = &slot.words;
        let present = self.origin();
        let incremental = self.state.incremental;
        let course = Course::of(words, incremental);
        let mut end = LineEnd {
            point: present,
            x: words.has(Address::X),
            z: words.has(Address::Z),
            beyond: None,
            anchor: present,
            cites: Cites::default(),
            readings: ReadingSet::default(),
        };
        let mut reference = present;
        if let Some(Base { x, z, basic }) = base {
            let corner = Point { x, z };
            if !basic {
                end.anchor = corner;
                reference = corner;
                (end.x, end.z) = (true, true);
            } else {
                if self.setup.readings.incremental_after_chamfer == IncrementalAfterChamfer::Corner
                    && !planted::is(Bug::CornerReading)
                {
                    reference = corner;
                }
                if incremental && (end.x || end.z) {
                    end.cites = cite::CHAM_13;
                    end.readings = self.known.after_chamfer;
                }
            }
        }
        if let Some(angle) = course.only_angle() {
            let chamfer = plan.one_shot.is_chamfer();
            let (corner, beyond) = self.corner_ahead(slot, (end.anchor, angle), chamfer, sink)?;
            let rule = if chamfer { cite::ANG_05 } else { cite::ANG_06 };
            end.cites = end.cites.and(cite::ANG_01).and(rule);
            (end.x, end.z) = (true, true);
            end.point = corner;
            end.beyond = Some(beyond);
            return Ok(end);
        }
        if let Some((x, z)) = angle_target {
            end.cites = end.cites.and(cite::ANG_01).and(cite::ANG_06);
            end.point = Point { x, z };
            return Ok(end);
        }
        end.point = course.end(end.anchor, reference, &mut self.slow)?;
        if words.has(Address::A) {
            (end.x, end.z) = (true, true);
            let cites = cite::DTAP_03.and(cite::ANG_01).and(cite::ANG_02).and_if(incremental, cite::DTAP_05);
            end.cites = end.cites.and(cites);
        }
        Ok(end)
    }

    /// The corner of the line of a block with only an angle and that of the next block, which is read ahead, and the
    /// end of the next one.
    pub(super) fn corner_ahead(
        &mut self,
        slot: &Slot,
        (anchor, angle): (Point, i64),
        chamfer: bool,
        sink: &mut impl Sink,
    ) -> Result<(Point, Point), Fault> {
        let need = Need { chamfer, only_angle: true, place: slot.place, last: slot.words.has_g(80) };
        self.look_ahead(0, need, self.state.motion, sink)?;
        let next = &self.ahead[0].words;
        let course = Course::of(next, Course::mode(next, self.state.incremental));
        self.crossing(anchor, angle, &course)
    }

    /// The corner of a line with only an angle and the next one, and the end of the next one.
    pub(super) fn crossing(
        &mut self,
        anchor: Point,
        angle: i64,
        next: &Course,
    ) -> Result<(Point, Point), Fault> {
        let (x, z) = next.coordinates(anchor);
        let through = Point { x: x.unwrap_or(anchor.x), z: z.unwrap_or(anchor.z) };
        let second = next.angle.unwrap_or_default();
        if second.saturating_sub(angle).rem_euclid(HALF_TURN) == 0 {
            return Fault::raise(AlarmName::AngleNoIntersection, rules::ANG_06);
        }
        let mut coordinate =
            |to_x| round(&Crossing { from: anchor, through, first: angle, second, to_x }, &mut self.slow);
        Ok((Point { x: coordinate(true), z: coordinate(false) }, through))
    }
}
