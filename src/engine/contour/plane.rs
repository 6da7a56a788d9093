//! Points of the face (execution of contours, 4 and 7; E100L-CGF-01, E100L-CSC-03).

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::{Spot, quarter, square, twice_cosine, twice_sine};
use crate::engine::arithmetic::root::root_over;
use crate::engine::arithmetic::turn;
use crate::engine::exact::{Approx, Formula, Real, SlowPaths, arc_tangent_microdegrees, round};

/// (X / 2) sin C, or (X / 2) cos C.
struct Polar {
    diameter: i64,
    angle: i64,
    ordinate: bool,
}

impl Polar {
    /// Half the diameter times a sine or cosine.
    fn of<R: Real>(&self, (sine, cosine): &(R, R), precision: R::Precision) -> R {
        let fraction = if self.ordinate { sine } else { cosine };
        R::integer(self.diameter.into(), precision).times(fraction).over(&R::integer(2, precision))
    }
}

impl Formula for Polar {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        self.of(&R::sine_cosine(self.angle, precision), precision)
    }
}

/// The latched point of the face at a diameter in the direction of an angle.
fn polar(diameter: i64, angle: i64, slow: &mut SlowPaths) -> Spot {
    let (sine, cosine) = (twice_sine(angle), twice_cosine(angle));
    if let (Some(sine), Some(cosine)) = (sine, cosine) {
        return Spot { p: quarter(diameter, cosine), q: quarter(diameter, sine) };
    }
    let both = Approx::sine_cosine(angle, ());
    let mut coordinate = |ordinate: bool, rational: Option<i64>| match rational {
        Some(fraction) => quarter(diameter, fraction),
        None => {
            let polar = Polar { diameter, angle, ordinate };
            polar.of(&both, ()).certain_round().unwrap_or_else(|| round(&polar, slow))
        }
    };
    Spot { p: coordinate(false, cosine), q: coordinate(true, sine) }
}

/// The diameter on which a point lies, latched: 2 root(x² + y²).
pub fn diameter(point: Spot) -> i64 {
    root_over((4 * square(point)).unsigned_abs(), 1)
}

/// The angle in which a point lies, latched and within a turn, when the first axis lies at another one; that of the
/// centre is that of the axis.
pub fn direction(point: Spot, axis: i64, slow: &mut SlowPaths) -> i64 {
    let Spot { p, q } = point;
    let angle = if point.is_centre() { 0 } else { arc_tangent_microdegrees(q, p, slow) };
    turn::within(axis + angle)
}

impl Interpreter<'_> {
    /// The latched point of the face of a program position. The one computed last is remembered: a contour goes on
    /// where it was.
    pub(in crate::engine) fn point_of(&mut self, diameter: i64, angle: i64) -> Spot {
        match self.state.contour.last {
            Some((last_diameter, last_angle, point)) if (last_diameter, last_angle) == (diameter, angle) => {
                point
            }
            _ => {
                let point = polar(diameter, angle, &mut self.slow);
                self.state.contour.last = Some((diameter, angle, point));
                point
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{SlowPaths, Spot, diameter, direction, polar};

    #[test]
    fn points_of_the_face() {
        let slow = &mut SlowPaths::default();
        let at = |diameter, degrees: i64, slow: &mut SlowPaths| polar(diameter, degrees * 1_000_000, slow);
        assert_eq!(at(100_000_000, 30, slow), Spot { p: 43_301_270, q: 25_000_000 });
        assert_eq!(at(100_000_000, 300, slow), Spot { p: 25_000_000, q: -43_301_270 });
        assert_eq!(at(80_000_000, 80, slow), Spot { p: 6_945_927, q: 39_392_310 });
        assert_eq!(at(80_000_001, 180, slow), Spot { p: -40_000_001, q: 0 });
        assert_eq!(*slow, SlowPaths::default());
    }

    #[test]
    fn positions_of_points() {
        let slow = &mut SlowPaths::default();
        let point = Spot { p: -10_000_000, q: -50_000_000 };
        assert_eq!((diameter(point), direction(point, 20_000_000, slow)), (101_980_390, 278_690_068));
        assert_eq!(direction(Spot::default(), 20_000_000, slow), 20_000_000);
        assert_eq!(direction(Spot { p: 1000, q: 0 }, 0, slow), 0);
    }
}
