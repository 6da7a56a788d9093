//! Cutter radius compensation in the planes of rotary tools, G17 and G119: what the generator believes of it, and which blocks
//! it writes.
//!
//! Compensation comes in runs that begin and end it: [`run`] makes ready, begins, adds elements and ends, [`element`] draws lines
//! and [`arc`] arcs that leave the one before in a chosen way, [`words`] finds the words that lead to a point of the plane, [`between`]
//! has blocks without motion in the plane. Corners are those of the nose circle, in the plane (p, q) instead of (z, x).

mod arc;
mod between;
mod element;
mod run;
mod setup;
mod words;

use turnspec_oracle::vocabulary::{Feature, SidePlane};

use crate::builder::Builder;
use crate::compensation::corner::{Element, meeting};
use crate::contour;
use crate::geometry::Point;
use crate::profile::Profile;
use crate::state::{Axis, Mode};

pub(crate) use setup::set_up;

/// Where a run of compensation is.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
enum Surface {
    /// G17, by X and C.
    #[default]
    Face,
    /// G17 in coordinate conversion, by X and Y.
    Conversion,
    /// G119, by Z and C.
    Side,
}

impl Surface {
    /// The code of its plane.
    fn code(self) -> i64 {
        if self == Self::Side { 119 } else { 17 }
    }
}

/// What the generator believes of cutter radius compensation.
#[derive(Clone, Default, Debug)]
pub struct Cutter {
    surface: Surface,
    /// 1 with the cutter on the left (G41), -1 on the right, in a run.
    sign: i64,
    /// The element whose end is not known yet; none behind the start-up.
    last: Option<Element>,
    /// Whether the next run begins without a radius.
    blunt: bool,
    /// Blocks without motion in the plane since a motion began to wait.
    idle: usize,
    /// The length on the cylinder from where C stood when compensation began, in nanometres.
    around: f64,
}

/// Whether a profile has something for compensation of cutters.
pub(crate) fn is_within(profile: &Profile) -> bool {
    let needed = [Feature::RadiusCompensation, Feature::Tool, Feature::Linear];
    contour::is_within(profile) && needed.iter().all(|feature| profile.allows(*feature))
}

/// The point of the plane that everything is counted from.
const ORIGIN: Point = Point { z: 0.0, x: 0.0 };

impl Builder<'_, '_, '_> {
    /// The present programmed point of the plane, p in the place of Z.
    fn cutter_point(&self) -> Point {
        let state = &self.state;
        match state.cutter.surface {
            Surface::Face => face_point(state.program(Axis::X), state.program_c()),
            Surface::Conversion => {
                let [p, q] = state.kept_point().unwrap_or_default();
                Point { z: p as f64, x: q as f64 }
            }
            Surface::Side => {
                Point { z: self.side_sign() * state.cutter.around, x: state.program(Axis::Z) as f64 }
            }
        }
    }

    /// 1 where the side is seen from outside.
    fn side_sign(&self) -> f64 {
        if self.state.setup.parameters.side_plane == SidePlane::Outer { 1.0 } else { -1.0 }
    }

    /// Takes a motion between two points as the element that waits now; false where the cutter does not fit, would leave the limits,
    /// or come too near to the centre of the face.
    fn takes_element(&mut self, from: Point, to: Point, centre: Option<(Point, Mode)>) -> bool {
        let radius = self.state.compensation.radius() as f64;
        let offset = self.state.cutter.sign as f64 * radius;
        // The corners know the sense of a circle by G02 and G03.
        let circle = centre.map(|(centre, mode)| {
            let counter = matches!(mode, Mode::FaceCounter | Mode::SideCounter);
            (centre, if counter { Mode::CounterClockwise } else { Mode::Clockwise })
        });
        let element = Element::new(from, to, circle, offset, ORIGIN);
        let corner = match &self.state.cutter.last {
            Some(last) => meeting(last, &element),
            None => Some(element.contact_at_beginning()),
        };
        let Some(corner) = corner else { return false };
        let (first, last) = (from.plus(corner), to.plus(element.contact_at_end()));
        let through = centre.is_none() && radius == 0.0;
        let near = corner.length() < 8.0 * radius + 10e6;
        let fits = near
            && !element.is_too_small()
            && self.bears_cutter(first, through)
            && self.bears_cutter(last, through);
        if let Some((centre, mode)) = centre
            && self.state.cutter.surface != Surface::Side
        {
            let sense = if mode == Mode::FaceCounter { 1.0 } else { -1.0 };
            let way = centre.minus(from).length() - sense * offset;
            if (centre.length() - way).abs() < 2_000.0 {
                return false;
            }
        }
        if fits {
            let cutter = &mut self.state.cutter;
            (cutter.last, cutter.idle) = (Some(element), 0);
        }
        fits
    }

    /// Whether the axes reach a place of the cutter centre. `through`: the centre of the face too.
    fn bears_cutter(&self, place: Point, through: bool) -> bool {
        match self.state.cutter.surface {
            Surface::Side => place.z.abs() < 5e10 && self.state.fits(Axis::Z, place.x.round() as i64),
            _ => {
                let away = place.length();
                (through || away > 5_000.0)
                    && away < 4e10
                    && self.state.fits(Axis::X, (away * 2.0).round() as i64)
            }
        }
    }
}

/// The point of the face with this diameter and this angle in micro-degrees.
fn face_point(diameter: i64, angle: i64) -> Point {
    Point::direction(angle).times(diameter as f64 / 2.0)
}
