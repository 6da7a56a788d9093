//! Where two elements meet: which rule decides, and the latched nose centre (E100L-NRC-07, E100L-NRC-11,
//! E100L-NRC-26 to E100L-NRC-33, E100L-NRC-49 to E100L-NRC-53, E100L-NRC-62, E100L-NRC-63).
//!
//! Parallel or not, same or opposite, one common point or none: all of it is decided exactly.

use crate::engine::arithmetic::contour::Spot;
pub use crate::engine::arithmetic::meeting::Meeting;
use crate::engine::arithmetic::nose::touches_both;
use crate::engine::arithmetic::plane::{Direction, Point, cross, dot, square};
use crate::engine::cite::{self, Cites};
use crate::engine::exact::{Formula, Real, SlowPaths, round};
use crate::engine::planted::{self, Bug};

use super::arcs::ArcsCorner;
use super::contour::{Contour, End};
use super::line_arc::LineArcCorner;
use super::lines::LinesCorner;

/// A coordinate axis of the turning plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Along {
    Z,
    X,
}

impl Along {
    /// The component of a direction.
    pub fn of(self, (z, x): Direction) -> i128 {
        match self {
            Self::Z => z,
            Self::X => x,
        }
    }
}

/// A nose centre relative to the programmed point.
pub trait NoseCentre {
    /// The component along an axis of the way from the programmed point, in half nanometres.
    fn component<R: Real>(&self, along: Along, precision: R::Precision) -> R;
}

/// Contact with an element at a point: to the left of its direction by its offset (E100L-NRC-02).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Contact {
    pub tangent: Direction,
    /// In half nanometres.
    pub offset: i128,
}

impl NoseCentre for Contact {
    fn component<R: Real>(&self, along: Along, precision: R::Precision) -> R {
        let left = crate::engine::arithmetic::plane::left(self.tangent);
        let length = R::integer(square(self.tangent), precision).root();
        R::integer(self.offset, precision).times(&R::integer(along.of(left), precision)).over(&length)
    }
}

/// The nose centre of a corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Corner {
    Contact(Contact),
    Lines(LinesCorner),
    LineArc(LineArcCorner),
    Arcs(ArcsCorner),
}

impl NoseCentre for Corner {
    fn component<R: Real>(&self, along: Along, precision: R::Precision) -> R {
        match self {
            Self::Contact(contact) => contact.component(along, precision),
            Self::Lines(corner) => corner.component(along, precision),
            Self::LineArc(corner) => corner.component(along, precision),
            Self::Arcs(corner) => corner.component(along, precision),
        }
    }
}

impl Corner {
    /// The contact of an element at its end.
    pub fn contact_at_end(element: &Contour) -> Self {
        Self::Contact(Contact { tangent: element.end_tangent(), offset: element.offset() })
    }

    /// The contact of an element where it begins.
    pub fn contact_at_beginning(element: &Contour) -> Self {
        Self::Contact(Contact { tangent: element.begin_tangent(), offset: element.offset() })
    }

    /// The corner of an element and the next one, and the rules of it; none without a common point.
    pub fn between(before: &Contour, after: &Contour, slow: &mut SlowPaths) -> Option<(Self, Cites)> {
        let (arriving, leaving) = (before.end_tangent(), after.begin_tangent());
        let radii = Cites::default().and_if(before.radius != after.radius, cite::NRC_11);
        let turn = cross(arriving, leaving);
        let nearly = planted::is(Bug::NearlyParallel) && turn.abs() < dot(arriving, leaving).abs() >> 14;
        if turn == 0 || nearly {
            let same = dot(arriving, leaving) > 0;
            let corner = match planted::is(Bug::ReversalOnOutgoing) {
                true => Self::contact_at_beginning(after),
                false => Self::contact_at_end(before),
            };
            return Some((corner, radii.and(parallel(before, after, same)?)));
        }
        let (corner, rule, side_change) = match (before.end(), after.begin()) {
            (End::Line(arriving), End::Line(leaving)) => {
                let nose = if planted::is(Bug::CornerOfOneRadius) { before.radius } else { after.radius };
                let after = Contour { radius: nose, ..*after };
                let corner = LinesCorner::new((arriving, before.offset()), (leaving, after.offset()));
                (Self::Lines(corner), cite::NRC_26, cite::NRC_62)
            }
            (End::Line(line), End::Arc(circle)) => {
                let corner = LineArcCorner::new(line, before.offset(), circle, slow)?;
                (Self::LineArc(corner), cite::NRC_51, cite::NRC_63)
            }
            (End::Arc(circle), End::Line(line)) => {
                let corner = LineArcCorner::new(line, after.offset(), circle, slow)?;
                (Self::LineArc(corner), cite::NRC_51, cite::NRC_63)
            }
            (End::Arc(first), End::Arc(second)) => {
                let corner = ArcsCorner::new(first, second, slow)?;
                (Self::Arcs(corner), cite::NRC_52, cite::NRC_63)
            }
        };
        Some((corner, radii.and(rule).and_if(before.side != after.side, side_change)))
    }

    /// The latched nose centre at a programmed point.
    pub fn latch(&self, at: Point, slow: &mut SlowPaths) -> Point {
        let z = Coordinate { corner: self, along: Along::Z, origin: 2 * i128::from(at.z), unit: 2 };
        let x = Coordinate { corner: self, along: Along::X, origin: at.x.into(), unit: 1 };
        let x = round(&x, slow);
        Point { x: if planted::is(Bug::LatchedRadius) { x + x % 2 } else { x }, z: round(&z, slow) }
    }

    /// The latched cutter centre at a programmed point of another plane, whose first axis stands for Z and whose
    /// second one for X, lengths both.
    pub fn latch_in_plane(&self, at: Spot, slow: &mut SlowPaths) -> Spot {
        let mut coordinate = |along, origin: i64| {
            round(&Coordinate { corner: self, along, origin: 2 * i128::from(origin), unit: 2 }, slow)
        };
        Spot { p: coordinate(Along::Z, at.p), q: coordinate(Along::X, at.q) }
    }
}

/// The rule of a corner of parallel directions; the nose stays in contact with the first element.
fn parallel(before: &Contour, after: &Contour, same: bool) -> Option<Cites> {
    let lines = !before.is_arc() && !after.is_arc();
    let touches = touches_both(before.offset(), after.offset(), same);
    match (touches, same) {
        (true, true) => Some(if lines { cite::NRC_30 } else { cite::NRC_49 }),
        (true, false) => Some(cite::NRC_31),
        (false, true) if lines => Some(cite::NRC_33),
        (false, false) if lines => Some(cite::NRC_32),
        (false, _) => None,
    }
}

/// A coordinate of a nose centre: a length, or the diameter X.
struct Coordinate<'c> {
    corner: &'c Corner,
    along: Along,
    /// The programmed point in half nanometres.
    origin: i128,
    /// So many half nanometres make one of the coordinate: 2 of a length, 1 of a diameter.
    unit: i128,
}

impl Formula for Coordinate<'_> {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let whole = R::integer(self.origin, precision).plus(&self.corner.component(self.along, precision));
        if self.unit == 1 { whole } else { whole.over(&R::integer(self.unit, precision)) }
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::Sense;

    use super::{Contour, Corner, Point, cite};
    use crate::engine::cite::Cites;
    use crate::engine::compensation::contour::Shape;
    use crate::engine::exact::SlowPaths;

    const ORIGIN: Point = Point { x: 0, z: 0 };

    fn element(shape: Shape, side: i128, radius: i64) -> Contour {
        Contour { shape, side, radius, to_centre: ORIGIN }
    }

    fn line(z: i128, x: i128) -> Shape {
        Shape::Line((2 * z, 2 * x))
    }

    /// The latched centre of a corner in the origin, as (Z, X as a radius) in nanometres.
    fn corner(before: &Contour, after: &Contour) -> Option<((i64, i64), Cites)> {
        let mut slow = SlowPaths::default();
        let (corner, cites) = Corner::between(before, after, &mut slow)?;
        let centre = corner.latch(ORIGIN, &mut slow);
        assert_eq!(centre.x % 2, 0, "{centre:?}");
        Some(((centre.z, centre.x / 2), cites))
    }

    #[test]
    fn parallel_directions_are_decided_exactly() {
        let lines = [line(-30, 10), line(-60, 20), line(30, -10)];
        let [long, same, back] = lines;
        let arc = Shape::Arc { start: (-20, -60), end: (-20, -60), turn: 1 };
        let rule = |first: (Shape, i128, i64), second: (Shape, i128, i64)| {
            let [first, second] = [first, second].map(|(shape, side, radius)| element(shape, side, radius));
            Corner::between(&first, &second, &mut SlowPaths::default()).map(|(_, cites)| cites)
        };
        // The arc leaves along left(-20, -60) = (60, -20), which is the way back.
        for (after, offset, expected) in [
            (same, (1, 5), Some(cite::NRC_30)),
            (same, (-1, 5), Some(cite::NRC_33)),
            (same, (1, 4), Some(cite::NRC_33.and(cite::NRC_11))),
            (back, (-1, 5), Some(cite::NRC_31)),
            (back, (1, 5), Some(cite::NRC_32)),
            (back, (-1, 4), Some(cite::NRC_32.and(cite::NRC_11))),
            (arc, (-1, 5), Some(cite::NRC_31)),
            (arc, (1, 5), None),
        ] {
            assert_eq!(rule((long, 1, 5), (after, offset.0, offset.1)), expected, "{after:?} {offset:?}");
        }
        assert_eq!(rule((arc, 1, 5), (back, 1, 5)), Some(cite::NRC_49));
        assert_eq!(rule((arc, 1, 5), (back, -1, 5)), None);
        // One half nanometre aside is no longer parallel.
        let aside = Shape::Line((-60, 21));
        assert_eq!(rule((long, 1, 5), (aside, 1, 5)), Some(cite::NRC_26));
    }

    #[test]
    fn lines_meet_where_both_distances_are_right() {
        // To -Z, then to +X on the right: one radius before either (E100L-NRC-26).
        let right_angle = corner(&element(line(-9, 0), -1, 800), &element(line(0, 7), -1, 800));
        assert_eq!(right_angle, Some(((800, 800), cite::NRC_26)));
        // Other sides and radii: 800 above the first line, 400 to the left of the second.
        let other = corner(&element(line(-9, 0), -1, 800), &element(line(0, 7), 1, 400));
        assert_eq!(other, Some(((-400, 800), cite::NRC_26.and(cite::NRC_62).and(cite::NRC_11))));
    }

    #[test]
    fn a_line_may_just_touch_an_offset_circle() {
        // An inside arc of radius 1600 that begins along +X, left along -Z: r' is the radius of the nose, and so
        // is the distance of the line from the centre (E100L-NRC-56).
        let arc = Shape::Arc { start: (0, -3200), end: (-3200, 0), turn: -1 };
        let leaving = element(line(-5, 0), -1, 800);
        assert_eq!(corner(&element(arc, -1, 800), &leaving), Some(((1600, 800), cite::NRC_51)));
        assert_eq!(corner(&element(arc, -1, 801), &element(line(-5, 0), -1, 801)), None);
    }

    #[test]
    fn circles_may_just_touch() {
        // Centres 6000 apart, both 5000 from the point between them, 4000 aside: offset by 2000 to the inside they
        // touch half-way, directly below the point.
        let (first, second) = ((6000, 8000), (-6000, 8000));
        let arcs = |radius| {
            let first = element(Shape::Arc { start: first, end: first, turn: 1 }, 1, radius);
            let second = element(Shape::Arc { start: second, end: second, turn: 1 }, 1, radius);
            (first, second)
        };
        let (before, after) = arcs(2000);
        assert_eq!(corner(&before, &after), Some(((0, -4000), cite::NRC_52)));
        let (before, after) = arcs(2001);
        assert_eq!(corner(&before, &after), None);
        // Offset by nothing they meet in the point itself, the nearer of two.
        let (before, after) = arcs(0);
        assert_eq!(corner(&before, &after), Some(((0, 0), cite::NRC_52)));
    }

    #[test]
    fn half_a_nanometre_goes_away_from_zero() {
        // Directions (-1, 0) and (-255, 32) / 257: the corner lies R / 16 before the point (E100L-NRC-07).
        let [before, after] = [line(-100, 0), line(-255, 32)].map(|shape| element(shape, -1, 8));
        assert_eq!(corner(&before, &after), Some(((1, 8), cite::NRC_26)));
        let [before, after] = [line(100, 0), line(255, 32)].map(|shape| element(shape, 1, 8));
        assert_eq!(corner(&before, &after), Some(((-1, 8), cite::NRC_26)));
    }

    #[test]
    fn corners_without_end_are_held_at_the_largest_coordinate() {
        // Back by a left turn with the tool on the left: the corner lies R / tan(2^-61) before the point.
        let far = 1 << 60;
        let [before, after] = [(far, 1), (-far, 0)].map(|way| element(Shape::Line(way), 1, 999_999_000));
        let mut slow = SlowPaths::default();
        let (corner, cites) =
            Corner::between(&before, &after, &mut slow).unwrap_or_else(|| panic!("parallel"));
        assert_eq!(cites, cite::NRC_26);
        assert_eq!(corner.latch(ORIGIN, &mut slow).z, -i64::MAX);
        let most = Point { x: i64::MAX, z: i64::MIN };
        let arc = Shape::arc(most, ORIGIN, Point { x: i64::MIN, z: i64::MAX }, Sense::Clockwise);
        let arc = element(arc, 1, 999_999_000);
        assert!(Corner::between(&before, &arc, &mut slow).is_some());
        assert!(Corner::between(&arc, &arc, &mut slow).is_some());
    }
}
