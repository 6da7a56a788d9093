//! Elements of a compensated contour: lines that leave the one before in a chosen way.

use super::{Surface, face_point};
use crate::builder::Builder;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// How a line leaves.
#[derive(Clone, Copy)]
enum Leaving {
    /// Along a coordinate of the plane.
    Along,
    /// On from the element before.
    Ahead,
    Square,
    Turned,
    Acute,
    Back,
    Anywhere,
    /// Toward the centre of the face or away from it.
    Ray,
    /// To a round diameter and a round angle.
    Round,
}

impl Builder<'_, '_, '_> {
    /// A block with a line or an arc; false where the control would refuse it.
    pub(super) fn cutter_element(&mut self) -> bool {
        let mut items = Vec::new();
        self.beside_cutter(&mut items);
        if self.choices.chance(42) { self.cutter_arc(items) } else { self.cutter_line(items) }
    }

    /// A line to about a point; false where the control would refuse it.
    pub(super) fn cutter_line_to(&mut self, wanted: Point, mut items: Vec<Item>) -> bool {
        let mode = self.straight_mode();
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.cutter_point();
        let Some(way) = self.way_to(wanted, false) else { return false };
        if !self.takes_element(from, way.point, None) {
            return false;
        }
        if mode != Mode::FaceLine || self.passes_aside(from, way.point) {
            self.axes_along(mode, &mut items);
        }
        self.follow(&way);
        items.extend(way.items);
        self.push_straight(mode, items);
        true
    }

    /// Adds a block of a straight mode.
    pub(super) fn push_straight(&mut self, mode: Mode, items: Vec<Item>) {
        if mode == Mode::Rapid {
            self.state.after_cutting = false;
            self.push(items);
        } else {
            self.cut_contour(items);
        }
    }

    /// A mode of straight motions.
    pub(super) fn straight_mode(&mut self) -> Mode {
        self.choices.weighted(match self.state.cutter.surface {
            Surface::Face => &[(60, Mode::FaceLine), (25, Mode::Linear), (15, Mode::Rapid)],
            Surface::Conversion => &[(75, Mode::FaceLine), (25, Mode::Rapid)],
            Surface::Side => &[(70, Mode::Linear), (30, Mode::Rapid)],
        })
    }

    fn cutter_line(&mut self, items: Vec<Item>) -> bool {
        let from = self.cutter_point();
        let wanted = self.cutter_leg(from);
        self.cutter_line_to(wanted, items)
    }

    /// Words of axes that have no part in the plane.
    fn axes_along(&mut self, mode: Mode, items: &mut Vec<Item>) {
        let face = self.state.cutter.surface != Surface::Side;
        if face && self.choices.chance(14) {
            self.aside_word(Axis::Z, items);
        }
        if mode != Mode::FaceLine && self.state.setup.options.w_axis && self.choices.chance(12) {
            self.aside_word(Axis::W, items);
        }
    }

    /// A word of an axis within its limits.
    pub(super) fn aside_word(&mut self, axis: Axis, items: &mut Vec<Item>) {
        let wanted = self.state.somewhere(axis, self.choices);
        let (item, reached) = self.target(axis, wanted);
        items.push(item);
        self.state.move_to(axis, reached);
    }

    /// Whether the cutter centre passes the centre of the face on one side.
    fn passes_aside(&self, from: Point, to: Point) -> bool {
        let way = to.minus(from);
        let offset = self.state.cutter.sign as f64 * self.state.compensation.radius() as f64;
        (from.cross(way) / way.length() + offset).abs() > 100_000.0
    }

    /// Where a line may lead.
    pub(super) fn cutter_leg(&mut self, from: Point) -> Point {
        let face = self.state.cutter.surface == Surface::Face;
        let rays = if face { 14 } else { 0 };
        let leaving = self.choices.weighted(&[
            (24, Leaving::Along),
            (8, Leaving::Ahead),
            (20, Leaving::Square),
            (24, Leaving::Turned),
            (5, Leaving::Acute),
            (2, Leaving::Back),
            (7, Leaving::Anywhere),
            (rays, Leaving::Ray),
            (rays, Leaving::Round),
        ]);
        let length = self.cutter_length();
        let sign = if self.choices.chance(50) { 1.0 } else { -1.0 };
        let turned = match leaving {
            Leaving::Ray => return self.on_ray(from, sign * length),
            Leaving::Round => return self.round_point(from),
            Leaving::Along => return from.plus(self.along().times(length)),
            Leaving::Ahead => 0.0,
            Leaving::Square => 90.0,
            Leaving::Turned => self.choices.pick(&[30.0, 45.0, 60.0, 20.0, 75.0, 120.0, 5.0]),
            Leaving::Acute => self.choices.pick(&[135.0, 150.0, 160.0, 170.0]),
            Leaving::Back => 180.0,
            Leaving::Anywhere => self.choices.within(0, 180_000) as f64 / 1e3,
        };
        from.plus(turn(self.cutter_direction(), sign * turned).times(length))
    }

    /// Toward the centre of the face or away from it; without a radius through it too.
    pub(super) fn on_ray(&mut self, from: Point, by: f64) -> Point {
        let away = from.length().max(1.0);
        if self.state.compensation.radius() == 0 {
            return match self.choices.below(3) {
                0 => super::ORIGIN,
                1 => from.times(-1.0),
                _ => from.times(-0.5),
            };
        }
        from.times(((away + by) / away).max(0.1))
    }

    fn round_point(&mut self, from: Point) -> Point {
        let diameter = (from.length() * 2.0 / 1e6).round() as i64 + self.choices.within(-20, 20);
        let step = self.choices.pick(&[10, 5, 1, 30]);
        let angle = (from.angle() / step as f64).round() as i64 + self.choices.within(-3, 3);
        face_point(diameter.max(1) * 1_000_000, angle * step * 1_000_000)
    }

    /// A direction along a coordinate of the plane.
    pub(super) fn along(&mut self) -> Point {
        self.choices.pick(&[
            Point { z: 1.0, x: 0.0 },
            Point { z: -1.0, x: 0.0 },
            Point { z: 0.0, x: 1.0 },
            Point { z: 0.0, x: -1.0 },
        ])
    }

    /// The direction in which the element before ends.
    pub(super) fn cutter_direction(&mut self) -> Point {
        match &self.state.cutter.last {
            Some(last) if last.direction.length() > 0.0 => {
                last.direction.times(1.0 / last.direction.length())
            }
            _ => self.along(),
        }
    }

    /// The length of an element: like the cutter, or any.
    fn cutter_length(&mut self) -> f64 {
        let radius = self.state.compensation.radius().max(1_000_000);
        let length = match self.choices.below(10) {
            0 | 1 => radius / 4 * self.choices.within(1, 8),
            2..=5 => radius * self.choices.within(2, 6),
            _ => self.choices.within(1, 40) * 1_000_000,
        };
        self.on_grid(length) as f64
    }
}

/// A vector turned counter-clockwise, in degrees; exactly where it is turned by right angles.
pub(super) fn turn(vector: Point, degrees: f64) -> Point {
    let (sin, cos) = match degrees {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        -90.0 => (-1.0, 0.0),
        180.0 | -180.0 => (0.0, -1.0),
        _ => degrees.to_radians().sin_cos(),
    };
    Point { z: cos * vector.z - sin * vector.x, x: sin * vector.z + cos * vector.x }
}

#[cfg(test)]
mod tests {
    use super::{Point, turn};

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(turn(Point { z: 1.0, x: 0.0 }, 90.0), Point { z: 0.0, x: 1.0 });
        assert_eq!(turn(Point { z: 0.0, x: 2.0 }, -180.0), Point { z: 0.0, x: -2.0 });
    }
}
