//! Where two elements meet: which rule decides, and the latched nose centre (E100L-NRC-07, E100L-NRC-11,
//! E100L-NRC-26 to E100L-NRC-33, E100L-NRC-49 to E100L-NRC-53, E100L-NRC-62, E100L-NRC-63).
//!
//! Parallel or not, same or opposite, one common point or none: all of it is decided exactly.

use std::cmp::Ordering;

use crate::engine::arithmetic::plane::{Direction, Point, cross, dot, square};
use crate::engine::cite::{self, Cites};
use crate::engine::exact::{Formula, Real, SlowPaths, round};

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
        if cross(arriving, leaving) == 0 {
            let same = dot(arriving, leaving) > 0;
            return Some((Self::contact_at_end(before), radii.and(parallel(before, after, same)?)));
        }
        let (corner, rule, side_change) = match (before.end(), after.begin()) {
            (End::Line(arriving), End::Line(leaving)) => {
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
        let z = Coordinate { corner: self, along: Along::Z, origin: 2 * i128::from(at.z) };
        let x = Coordinate { corner: self, along: Along::X, origin: at.x.into() };
        Point { x: round(&x, slow), z: round(&z, slow) }
    }
}

/// The rule of a corner of parallel directions; the nose stays in contact with the first element.
fn parallel(before: &Contour, after: &Contour, same: bool) -> Option<Cites> {
    let lines = !before.is_arc() && !after.is_arc();
    let touches = before.offset() == if same { after.offset() } else { -after.offset() };
    match (touches, same) {
        (true, true) => Some(if lines { cite::NRC_30 } else { cite::NRC_49 }),
        (true, false) => Some(cite::NRC_31),
        (false, true) if lines => Some(cite::NRC_33),
        (false, false) if lines => Some(cite::NRC_32),
        (false, _) => None,
    }
}

/// A coordinate of a nose centre: Z in nanometres, or the diameter X.
struct Coordinate<'c> {
    corner: &'c Corner,
    along: Along,
    /// The programmed point in half nanometres.
    origin: i128,
}

impl Formula for Coordinate<'_> {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let whole = R::integer(self.origin, precision).plus(&self.corner.component(self.along, precision));
        match self.along {
            Along::Z => whole.over(&R::integer(2, precision)),
            Along::X => whole,
        }
    }
}

/// How two offset elements lie to one another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Meeting {
    /// They cross.
    Crossing,
    /// They have one common point.
    Touching,
}

impl Meeting {
    /// The meeting by the signs of the gaps that must not be negative; none if one is.
    pub fn of(gaps: impl IntoIterator<Item = Ordering>) -> Option<Self> {
        gaps.into_iter().try_fold(Self::Crossing, |meeting, gap| match gap {
            Ordering::Less => None,
            Ordering::Equal => Some(Self::Touching),
            Ordering::Greater => Some(meeting),
        })
    }
}
