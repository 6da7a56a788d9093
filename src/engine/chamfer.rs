//! Chamfers and roundings (execution, chapter 5, Chamfering and rounding).
//!
//! Geometry is in half nanometres: twice Z, and the diameter X; directions are pairs (Z, X).

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, ChamferLeg, Chamfering, ReadingSet, Sense, Sink};

use super::Interpreter;
use super::ahead::Need;
use super::angle::Course;
use super::arithmetic::plane::{self, Direction, Point, difference, square, square_distance};
use super::block::{OneShot, Plan};
use super::cite::{self, Cites};
use super::exact::{Formula, Real, round, sign};
use super::fault::Fault;
use super::motion::{Element, Kind};
use super::planted::{self, Bug};
use super::slot::Slot;
use super::state::Base;
use super::words::Address;

/// What L measures.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Measure {
    /// The leg on either line.
    Leg,
    /// The face of the chamfer.
    Face,
    /// The radius of the rounding.
    Radius,
}

/// A corner between two lines.
struct Corner {
    measure: Measure,
    /// |L| in half nanometres.
    size: i128,
    incoming: Direction,
    outgoing: Direction,
}

impl Corner {
    fn cross(&self) -> i128 {
        plane::cross(self.incoming, self.outgoing)
    }

    fn dot(&self) -> i128 {
        plane::dot(self.incoming, self.outgoing)
    }

    /// The distance from the corner to either end of the chamfer. With p = |u1| |u2| and
    /// s = p (1 + cos φ) = p + dot = cross² / (p - dot).
    fn reach<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let size = integer(self.size);
        if self.measure == Measure::Leg {
            return size;
        }
        let (dot, cross) = (self.dot(), self.cross());
        let product = length::<R>(self.incoming, precision).times(&length::<R>(self.outgoing, precision));
        let apart = product.minus(&integer(dot));
        let cross = integer(cross.abs());
        match (self.measure, dot >= 0) {
            // |L| tan(φ/2) = |L| cross / s
            (Measure::Radius, true) => size.times(&cross).over(&product.plus(&integer(dot))),
            (Measure::Radius, false) => size.times(&apart).over(&cross),
            // |L| / (2 cos(φ/2)), cos²(φ/2) = s / 2p
            (_, true) => {
                let square = product.plus(&product).over(&product.plus(&integer(dot)));
                size.times(&square.root()).over(&integer(2))
            }
            (_, false) => {
                let square = product.plus(&product).times(&apart);
                size.times(&square.root()).over(&cross).over(&integer(2))
            }
        }
    }
}

/// The length of a direction.
fn length<R: Real>(direction: Direction, precision: R::Precision) -> R {
    R::integer(square(direction), precision).root()
}

/// The reach of a corner less the length that is there for it.
struct Excess<'c> {
    corner: &'c Corner,
    available: i128,
}

impl Formula for Excess<'_> {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        self.corner.reach::<R>(precision).minus(&R::integer(self.available, precision).root())
    }
}

/// (origin + (sign reach along + aside) / |line|) / divisor: a coordinate of an end of the chamfer, or of
/// the centre of the rounding, which lies aside of it.
struct EndCoordinate<'c> {
    corner: &'c Corner,
    origin: i128,
    line: Direction,
    along: i128,
    aside: i128,
    divisor: i128,
}

impl Formula for EndCoordinate<'_> {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let along = self.corner.reach::<R>(precision).times(&integer(self.along));
        let change = along.plus(&integer(self.aside)).over(&length::<R>(self.line, precision));
        integer(self.origin).plus(&change).over(&integer(self.divisor))
    }
}

/// The elements of a chamfer block.
struct Elements {
    first: Option<Element>,
    second: Option<Element>,
}

impl Interpreter<'_> {
    /// A block with G75 or G76.
    pub(super) fn chamfer(&mut self, slot: &Slot, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        let base = self.state.base.take();
        let angle_target = self.state.angle_target.take();
        let words = &slot.words;
        let basic = self.setup.parameters.chamfering == Chamfering::Basic;
        if !basic {
            self.look_beyond(slot, plan, sink)?;
        }
        let end = self.line_end(slot, plan, base, angle_target, sink)?;
        let corner = end.point;
        let size = words.get(Address::L).unwrap_or_default();
        let rounding = plan.one_shot == OneShot::Rounding;
        let shape = match (basic, rounding) {
            (true, false) => cite::CHAM_03,
            (true, true) => cite::CHAM_11,
            (false, false) => cite::ANG_03,
            (false, true) => cite::ANG_04,
        };
        let common = end.cites.and(shape).and(cite::CHAM_12);
        let line = common.and(self.linear_cites(words));
        let second = if rounding {
            common
                .and(self.coordinate_cites(words))
                .and(self.feed_cites())
                .and(cite::CIRC_02)
                .and(cite::CIRC_09)
        } else {
            line
        };
        let elements = if basic {
            self.basic_corner(corner, end.x, size, rounding, (line, second), end.readings)?
        } else {
            let beyond = match end.beyond {
                Some(point) => point,
                None => self.end_of_next(corner)?,
            };
            let named = if rounding { end.readings } else { end.readings.union(self.known.leg) };
            self.any_corner(end.anchor, corner, beyond, size, rounding, (line, second), named)?
        };
        let placed = corner.plus(self.lap.shift());
        for (tested, coordinate) in [(end.x, placed.x), (end.z, placed.z)] {
            if tested || !basic {
                self.check_coordinate(coordinate)?;
            }
        }
        for element in [elements.first, elements.second].into_iter().flatten() {
            self.perform_placed(element, sink)?;
        }
        self.state.base = Some(Base { x: corner.x, z: corner.z, basic });
        self.state.angle_target = end.beyond.map(|point| (point.x, point.z));
        Ok(())
    }

    /// The basic form: from a motion along one axis to one along the other.
    fn basic_corner(
        &self,
        corner: Point,
        along_x: bool,
        size: i64,
        rounding: bool,
        (line, second): (Cites, Cites),
        readings: ReadingSet,
    ) -> Result<Elements, Fault> {
        let present = self.origin();
        let travel =
            if along_x { corner.x.saturating_sub(present.x) } else { corner.z.saturating_sub(present.z) };
        if travel == 0 {
            return Fault::raise(AlarmName::ChamferAxes, rules::CHAM_08);
        }
        // Amounts on a diameter are twice those on a radius.
        let leg = size.abs() * if along_x { 2 } else { 1 };
        if travel.abs() < leg || planted::is(Bug::ExactFit) && travel.abs() == leg {
            return Fault::raise(AlarmName::ChamferTooShort, rules::CHAM_07);
        }
        let back = leg * travel.signum();
        // L has the sign of the motion behind the corner, on the other axis (E100L-CHAM-04).
        let (begin, finish) = if along_x {
            let begin = Point { x: corner.x - back, z: present.z };
            (begin, Point { x: corner.x, z: present.z.saturating_add(size) })
        } else {
            let begin = Point { x: present.x, z: corner.z - back };
            let aside = if planted::is(Bug::LegRadius) { size } else { 2 * size };
            (begin, Point { x: present.x.saturating_add(aside), z: corner.z })
        };
        let kind = if rounding {
            let left = (travel.signum() * size.signum() > 0) != (along_x && !planted::is(Bug::RoundingSense));
            let centre =
                if along_x { Point { x: begin.x, z: finish.z } } else { Point { x: finish.x, z: begin.z } };
            arc_kind(left, centre)
        } else {
            Kind::Linear
        };
        let first = Element {
            kind: Kind::Linear,
            x: along_x.then_some(begin.x),
            z: (!along_x).then_some(begin.z),
            w: None,
            c: None,
            cites: line,
            readings,
            limited: false,
        };
        let second = Element { kind, x: Some(finish.x), z: Some(finish.z), cites: second, ..first };
        Ok(Elements { first: (travel.abs() != leg).then_some(first), second: Some(second) })
    }

    /// The any-angle form: from A over the corner C to E.
    #[allow(clippy::too_many_arguments)]
    fn any_corner(
        &mut self,
        from: Point,
        at: Point,
        to: Point,
        size: i64,
        rounding: bool,
        (line, second): (Cites, Cites),
        readings: ReadingSet,
    ) -> Result<Elements, Fault> {
        let refuse = || Fault::raise(AlarmName::ChamferAxes, rules::CHAM_08);
        if from == at || at == to {
            return refuse();
        }
        let measure = match (rounding, self.setup.readings.chamfer_leg) {
            (true, _) => Measure::Radius,
            (false, ChamferLeg::Leg) => Measure::Leg,
            (false, ChamferLeg::Face) if planted::is(Bug::FaceAsLeg) => Measure::Leg,
            (false, ChamferLeg::Face) => Measure::Face,
        };
        let corner = Corner {
            measure,
            // The next block says which way the corner turns, and a sign of L nothing (E100L-ANG-08).
            size: 2 * i128::from(size.abs()),
            incoming: difference(at, from),
            outgoing: difference(to, at),
        };
        let cross = corner.cross();
        if cross == 0 && corner.dot() < 0 && measure != Measure::Leg {
            return refuse();
        }
        let element = Element {
            kind: Kind::Linear,
            x: Some(at.x),
            z: Some(at.z),
            w: None,
            c: None,
            cites: line,
            readings,
            limited: false,
        };
        if cross == 0 && rounding {
            return Ok(Elements { first: Some(element), second: None });
        }
        let incoming = self.excess(&corner, square_distance(at, self.origin()));
        let outgoing = self.excess(&corner, square(corner.outgoing));
        if incoming == Ordering::Greater || outgoing == Ordering::Greater {
            return Fault::raise(AlarmName::ChamferTooShort, rules::CHAM_07);
        }
        let begin = self.corner_point(&corner, at, corner.incoming, -1, 0);
        let finish = self.corner_point(&corner, at, corner.outgoing, 1, 0);
        let kind = if rounding {
            let side = if cross > 0 { 1 } else { -1 };
            arc_kind(cross > 0, self.corner_point(&corner, at, corner.incoming, -1, side))
        } else {
            Kind::Linear
        };
        let first = Element { x: Some(begin.x), z: Some(begin.z), ..element };
        let second = Element { kind, x: Some(finish.x), z: Some(finish.z), cites: second, ..element };
        Ok(Elements { first: (incoming != Ordering::Equal).then_some(first), second: Some(second) })
    }

    /// Compares the reach of a corner with the root of a square.
    fn excess(&mut self, corner: &Corner, available: i128) -> Ordering {
        let right_angle = corner.measure == Measure::Radius && corner.dot() == 0;
        if corner.measure == Measure::Leg || right_angle {
            return (corner.size * corner.size).cmp(&available);
        }
        sign(&Excess { corner, available }, &mut self.slow)
    }

    /// The point on a line of the corner at its reach, before (-1) or after (1) it, and aside of it to the
    /// left (1) or right (-1) by L.
    fn corner_point(
        &mut self,
        corner: &Corner,
        at: Point,
        line: Direction,
        along: i128,
        side: i128,
    ) -> Point {
        let aside = side * corner.size;
        let z = EndCoordinate {
            corner,
            origin: 2 * i128::from(at.z),
            line,
            along: along * line.0,
            aside: -aside * line.1,
            divisor: 2,
        };
        let x = EndCoordinate {
            corner,
            origin: at.x.into(),
            line,
            along: along * line.1,
            aside: aside * line.0,
            divisor: 1,
        };
        Point { x: round(&x, &mut self.slow), z: round(&z, &mut self.slow) }
    }

    /// Reads the blocks that the corner needs: the next one, and the one after it when the next one has an
    /// angle alone.
    fn look_beyond(&mut self, slot: &Slot, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        let last = slot.words.has_g(80);
        let need = Need { chamfer: true, only_angle: plan.only_angle, place: slot.place, last };
        self.look_ahead(0, need, self.state.motion, sink)?;
        let next = &self.ahead[0];
        let only_angle = Course::of(&next.words, self.state.incremental).only_angle().is_some();
        if plan.only_angle || !only_angle {
            return Ok(());
        }
        let chamfer = next.words.has_g(75) || next.words.has_g(76);
        let need = Need { chamfer, only_angle: true, place: next.place, last: next.words.has_g(80) };
        self.look_ahead(1, need, self.state.motion, sink)
    }

    /// The end of the line of the next block, which begins at the corner of this one.
    fn end_of_next(&mut self, corner: Point) -> Result<Point, Fault> {
        let next = &self.ahead[0];
        let place = next.place;
        let here = self.state.incremental;
        let incremental =
            if planted::is(Bug::NextDimension) { here } else { Course::mode(&next.words, here) };
        let course = Course::of(&next.words, incremental);
        let end = match course.only_angle() {
            None => course.end(corner, corner, &mut self.slow),
            Some(angle) => {
                let after = &self.ahead[1].words;
                let course = Course::of(after, Course::mode(after, incremental));
                self.crossing(corner, angle, &course).map(|(end, _)| end)
            }
        };
        // What is wrong with the line of the next block is its own fault.
        end.inspect_err(|_| self.fault_place = Some(place))
    }
}

fn arc_kind(left: bool, centre: Point) -> Kind {
    let sense = if left { Sense::CounterClockwise } else { Sense::Clockwise };
    Kind::Arc { sense, centre_x: centre.x, centre_z: centre.z }
}
