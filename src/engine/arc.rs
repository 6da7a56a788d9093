//! Arcs by centre and by radius (execution, chapter 5, Arcs).
//!
//! Points are in half nanometres: twice Z, and the diameter X. A radius of r nanometres is 2r of them.

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, ArcOneCoordinate, ReadingSet, Sense, Sink};

use super::Interpreter;
use super::arithmetic::frame::coordinate;
use super::arithmetic::plane::{Point, difference, quadrant, square, square_distance};
use super::arithmetic::root::{half_root, whole_root};
use super::block::full_circle;
use super::cite::{self, Cites};
use super::exact::{Formula, Real, round, sign};
use super::fault::Fault;
use super::motion::{Element, Kind};
use super::planted::{self, Bug};
use super::words::{Address, Words};

/// An arc that is known but for its rules.
struct Arc {
    end: Point,
    /// Whether X and Z are commanded or computed, not just kept.
    moves_x: bool,
    moves_z: bool,
    centre: Point,
    cites: Cites,
    readings: ReadingSet,
}

/// |root a - root b| - tolerance, for a not below b.
struct RadiusGap {
    greater: i128,
    less: i128,
    tolerance: i128,
}

impl Formula for RadiusGap {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let root = |square| R::integer(square, precision).root();
        root(self.greater).minus(&root(self.less)).minus(&R::integer(self.tolerance, precision))
    }
}

/// (middle + side * root(high / square)) / divisor: a coordinate of the centre of an arc by radius.
struct CentreCoordinate {
    middle: i128,
    side: i128,
    high: i128,
    square: i128,
    divisor: i128,
}

impl Formula for CentreCoordinate {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let ratio = integer(self.high).over(&integer(self.square)).root();
        integer(self.middle).plus(&integer(self.side).times(&ratio)).over(&integer(self.divisor))
    }
}

impl Interpreter<'_> {
    /// A block with G02 or G03.
    pub(super) fn arc(&mut self, words: &Words, motion: u16, sink: &mut impl Sink) -> Result<(), Fault> {
        self.state.base = self.state.base.filter(|_| planted::is(Bug::CornerBaseKept));
        let sense = if motion == 2 { Sense::Clockwise } else { Sense::CounterClockwise };
        let start = self.origin();
        let incremental = self.state.incremental;
        let from = |reference: i64, word: i64| coordinate(reference, word, incremental);
        let x = words.get(Address::X).map(|word| from(start.x, word));
        let z = words.get(Address::Z).map(|word| from(start.z, word));
        let arc = match (words.get(Address::L), x, z) {
            (Some(radius), Some(x), Some(z)) => {
                self.arc_by_radius(start, Point { x, z }, radius, sense, words)?
            }
            _ => self.arc_by_centre(start, x, z, sense, words)?,
        };
        let cites = arc
            .cites
            .and(self.coordinate_cites(words))
            .and(self.feed_cites())
            .and(cite::CIRC_02)
            .and(cite::CIRC_09)
            .and(cite::CIRC_10);
        let element = Element {
            kind: Kind::Arc { sense, centre_x: arc.centre.x, centre_z: arc.centre.z },
            x: arc.moves_x.then_some(arc.end.x),
            z: arc.moves_z.then_some(arc.end.z),
            w: None,
            c: None,
            cites,
            readings: arc.readings,
            limited: false,
        };
        self.perform_placed(element, sink)
    }

    fn arc_by_centre(
        &mut self,
        start: Point,
        x: Option<i64>,
        z: Option<i64>,
        sense: Sense,
        words: &Words,
    ) -> Result<Arc, Fault> {
        // G91 does not govern I and K: they are counted from the start in both modes (E100L-ABS-05).
        let i = words.get(Address::I).unwrap_or_default();
        let k = words.get(Address::K).unwrap_or_default();
        let across = if planted::is(Bug::CentreDiameter) { i } else { 2 * i };
        let centre = Point { x: start.x.saturating_add(across), z: start.z.saturating_add(k) };
        let both_given = words.has(Address::I) && words.has(Address::K);
        let mut cites = cite::CIRC_01
            .and(cite::CIRC_04)
            .and(cite::CIRC_05)
            .and_if(!both_given, cite::CIRC_06)
            .and_if(!self.state.incremental, cite::CIRC_03);
        let mut readings = ReadingSet::default();
        let one = x.is_none() || z.is_none();
        if one {
            cites = cites.and(cite::CIRC_08);
            readings = if planted::is(Bug::ArcReading) { ReadingSet::default() } else { self.known.arc };
        }
        if one && self.setup.readings.arc_one_coordinate == ArcOneCoordinate::Quadrant {
            let end = quadrant_end(centre, (-k, -i), x, z, sense)
                .ok_or_else(|| Fault::new(AlarmName::ArcNoEndPoint, rules::CIRC_08))?;
            return Ok(Arc { end, moves_x: true, moves_z: true, centre, cites, readings });
        }
        let end = Point { x: x.unwrap_or(start.x), z: z.unwrap_or(start.z) };
        if end == start {
            return Err(full_circle());
        }
        cites = cites.and(cite::CIRC_11);
        let [start_square, end_square] = [start, end].map(|point| square_distance(point, centre));
        let (greater, less) = (start_square.max(end_square), start_square.min(end_square));
        let halves = if planted::is(Bug::ToleranceOnDiameter) { 1 } else { 2 };
        let tolerance = halves * i128::from(self.setup.parameters.circular_radius_tolerance.0);
        if greater != less {
            let gap = RadiusGap { greater, less, tolerance };
            if sign(&gap, &mut self.slow) == Ordering::Greater {
                return Fault::raise(AlarmName::ArcRadiusMismatch, rules::CIRC_11);
            }
        }
        Ok(Arc { end, moves_x: x.is_some(), moves_z: z.is_some(), centre, cites, readings })
    }

    fn arc_by_radius(
        &mut self,
        start: Point,
        end: Point,
        radius: i64,
        sense: Sense,
        words: &Words,
    ) -> Result<Arc, Fault> {
        if end == start {
            return Err(full_circle());
        }
        let major = words.has(Address::Calrg);
        let square = square_distance(start, end);
        let diameter = 4 * i128::from(radius);
        let high = diameter * diameter - square;
        if high < 0 {
            return Fault::raise(AlarmName::ArcRadiusTooSmall, rules::CIRC_16);
        }
        let (across_z, across_x) = difference(end, start);
        let major_side = major && !(planted::is(Bug::MajorSide) && sense == Sense::Clockwise);
        let side = if (sense == Sense::CounterClockwise) == major_side { -1 } else { 1 };
        // From the middle of the chord to its left by half of root(high / square) times the chord.
        let mut coordinate = |middle: i128, side: i128, divisor: i128| {
            let formula = CentreCoordinate { middle, side, high, square, divisor };
            round(&formula, &mut self.slow)
        };
        let centre = Point {
            z: coordinate(2 * (i128::from(start.z) + i128::from(end.z)), -side * across_x, 4),
            x: coordinate(i128::from(start.x) + i128::from(end.x), side * across_z, 2),
        };
        let cites = cite::CIRC_12
            .and(if major { cite::CIRC_18 } else { cite::CIRC_17 })
            .and(if self.state.incremental { cite::CIRC_19 } else { cite::CIRC_03 });
        let readings = ReadingSet::default();
        Ok(Arc { end, moves_x: true, moves_z: true, centre, cites, readings })
    }
}

/// The end of an arc with one coordinate inside its starting quadrant (E100L-CIRC-08), if there is one.
/// The radius vector of the start is in nanometres, along Z and along X.
fn quadrant_end(
    centre: Point,
    (start_z, start_x): (i64, i64),
    x: Option<i64>,
    z: Option<i64>,
    sense: Sense,
) -> Option<Point> {
    let turn = if sense == Sense::CounterClockwise { 1 } else { -1 };
    let (start_z, start_x) = (2 * i128::from(start_z), 2 * i128::from(start_x));
    let entering = if planted::is(Bug::QuadrantOnAxis) { -turn } else { turn };
    let (side_z, side_x) = quadrant((start_z, start_x), entering);
    let square = square((start_z, start_x));
    match (x, z) {
        (Some(x), _) => {
            let end_x = i128::from(x) - i128::from(centre.x);
            let rest = square - end_x.checked_mul(end_x)?;
            // X grows along the arc where turn and the side of Z agree.
            let ahead = (end_x - start_x).signum() == turn * side_z;
            (rest >= 0 && end_x * side_x >= 0 && ahead)
                .then(|| Point { x, z: half_root(2 * i128::from(centre.z), side_z, rest) })
        }
        (None, Some(z)) => {
            let end_z = 2 * (i128::from(z) - i128::from(centre.z));
            let rest = square - end_z.checked_mul(end_z)?;
            let ahead = (end_z - start_z).signum() == -turn * side_x;
            (rest >= 0 && end_z * side_z >= 0 && ahead)
                .then(|| Point { x: whole_root(i128::from(centre.x), side_x, rest), z })
        }
        (None, None) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Point, Sense, quadrant_end};

    #[test]
    fn the_starting_quadrant() {
        // A circle of radius 5 about the origin, from (z 5, x 0) counter-clockwise: up to x 4, z 3.
        let origin = Point { x: 0, z: 0 };
        let ccw = Sense::CounterClockwise;
        let end = quadrant_end(origin, (5, 0), Some(8), None, ccw);
        assert_eq!(end, Some(Point { x: 8, z: 3 }));
        // Clockwise the motion enters the quadrant below.
        assert_eq!(quadrant_end(origin, (5, 0), Some(8), None, Sense::Clockwise), None);
        let end = quadrant_end(origin, (5, 0), Some(-8), None, Sense::Clockwise);
        assert_eq!(end, Some(Point { x: -8, z: 3 }));
        // From (3, 4) counter-clockwise: z falls to 0, x may not fall back.
        let end = quadrant_end(origin, (3, 4), None, Some(0), ccw);
        assert_eq!(end, Some(Point { x: 10, z: 0 }));
        assert_eq!(quadrant_end(origin, (3, 4), None, Some(4), ccw), None);
        assert_eq!(quadrant_end(origin, (3, 4), None, Some(-1), ccw), None);
        assert_eq!(quadrant_end(origin, (3, 4), None, Some(3), ccw), None);
    }
}
