//! Elements of a compensated contour: lines and arcs that leave the one before in a chosen way.

use super::{Surface, face_point};
use crate::builder::Builder;
use crate::compensation::corner::left;
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

/// How an arc leaves.
#[derive(Clone, Copy)]
enum Starting {
    Tangential,
    Along,
    Turned,
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
    fn on_ray(&mut self, from: Point, by: f64) -> Point {
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
    fn along(&mut self) -> Point {
        self.choices.pick(&[
            Point { z: 1.0, x: 0.0 },
            Point { z: -1.0, x: 0.0 },
            Point { z: 0.0, x: 1.0 },
            Point { z: 0.0, x: -1.0 },
        ])
    }

    /// The direction in which the element before ends.
    fn cutter_direction(&mut self) -> Point {
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

    /// An arc; false where the control would refuse it.
    fn cutter_arc(&mut self, mut items: Vec<Item>) -> bool {
        let counter = self.choices.chance(50);
        let side = self.state.cutter.surface == Surface::Side;
        let mode = match (side, counter) {
            (false, true) => Mode::FaceCounter,
            (false, false) => Mode::FaceClockwise,
            (true, true) => Mode::SideCounter,
            (true, false) => Mode::SideClockwise,
        };
        self.select(mode, &mut items);
        let from = self.cutter_point();
        let sense = if counter { 1.0 } else { -1.0 };
        let (mut start, mut radius) = (self.start_of_arc(), self.cutter_arc_radius());
        let mut sweep = match self.choices.below(10) {
            0..=3 => 90.0,
            4 => 180.0,
            5 | 6 => self.choices.pick(&[45.0, 60.0, 120.0, 30.0]),
            _ => self.choices.within(20, 170) as f64,
        };
        if !side && from.length() > 1e6 && self.choices.chance(14) {
            // Round the centre of the face, by more than half a turn or less.
            let aside = self.choices.within(-30, 30) as f64;
            start = turn(from.times(1.0 / from.length()), sense * 90.0 + aside);
            let percent = self.choices.within(80, 130) as f64;
            radius = self.on_grid((from.length() * percent / 100.0) as i64);
            sweep = self.choices.within(140, 178) as f64;
        }
        let centre = from.plus(left(start).times(sense * radius as f64));
        let end = centre.plus(turn(from.minus(centre), sense * sweep));
        let Some(way) = self.way_to(end, false) else { return false };
        let chord = way.point.minus(from).length();
        let Some((word, read)) = self.radius_of_chord(radius, chord, way.twice_chord) else { return false };
        if !side && (from.length() < 1_000.0 || way.point.length() < 1_000.0) {
            return false;
        }
        let centre = centre_of(from, way.point, read as f64, sense);
        if !self.takes_element(from, way.point, Some((centre, mode))) {
            return false;
        }
        self.follow(&way);
        items.extend(way.items);
        items.push(word);
        self.cut_contour(items);
        true
    }

    /// The direction in which an arc starts.
    fn start_of_arc(&mut self) -> Point {
        let list = [(34, Starting::Tangential), (30, Starting::Along), (36, Starting::Turned)];
        match self.choices.weighted(&list) {
            Starting::Along => self.along(),
            Starting::Tangential => self.cutter_direction(),
            Starting::Turned => {
                let turned = self.choices.pick(&[45.0, -45.0, 90.0, -90.0, 30.0, -30.0, 60.0, -60.0, 180.0]);
                turn(self.cutter_direction(), turned)
            }
        }
    }

    /// The radius of an arc, larger and smaller than that of the cutter.
    fn cutter_arc_radius(&mut self) -> i64 {
        let cutter = self.state.compensation.radius().max(400_000);
        let radius = match self.choices.below(20) {
            0..=6 => cutter / 4 * self.choices.within(5, 16),
            7..=9 => cutter * self.choices.within(4, 10),
            10 | 11 => cutter / 10 * self.choices.within(4, 9),
            12 => cutter,
            13 => cutter + self.choices.within(-2, 2) * self.state.units.finest(),
            _ => self.choices.within(2, 40) * 1_000_000,
        };
        self.on_grid(radius.max(100_000))
    }

    /// An L word for an arc with about this radius, and what the control reads; none where it is too small for the chord.
    fn radius_of_chord(&mut self, radius: i64, chord: f64, twice: Option<i64>) -> Option<(Item, i64)> {
        let plain = self.choices.chance(70);
        let (word, read) = if plain { self.plain_length("L", radius) } else { self.length("L", radius) };
        let reaches = |read: i64| match twice {
            Some(twice) => 4 * read >= twice,
            None => 2.0 * read as f64 >= chord + 2_000.0,
        };
        if reaches(read) {
            return Some((word, read));
        }
        let (word, read) = self.plain_length("L", (chord / 2.0).ceil() as i64 + 3_000);
        reaches(read).then_some((word, read))
    }
}

/// A vector turned counter-clockwise, in degrees; exactly where it is turned by right angles.
fn turn(vector: Point, degrees: f64) -> Point {
    let (sin, cos) = match degrees {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        -90.0 => (-1.0, 0.0),
        180.0 | -180.0 => (0.0, -1.0),
        _ => degrees.to_radians().sin_cos(),
    };
    Point { z: cos * vector.z - sin * vector.x, x: sin * vector.z + cos * vector.x }
}

/// The centre of an arc with this radius; `sense` is 1 counter-clockwise (E100L-CGF-04, E100L-CGS-04).
fn centre_of(from: Point, to: Point, radius: f64, sense: f64) -> Point {
    let way = to.minus(from);
    let chord = way.length();
    let height = (radius * radius - chord * chord / 4.0).max(0.0).sqrt();
    let middle = from.plus(to).times(0.5);
    let centre = middle.plus(left(way).times(sense * height / chord));
    Point { z: centre.z.round(), x: centre.x.round() }
}

#[cfg(test)]
mod tests {
    use super::{Point, centre_of, turn};

    #[test]
    fn centres_and_turns_are_those_of_the_plane() {
        let (from, to) = (Point { z: 20e6, x: 20e6 }, Point { z: 30e6, x: 30e6 });
        assert_eq!(centre_of(from, to, 10e6, 1.0), Point { z: 20e6, x: 30e6 });
        assert_eq!(centre_of(from, to, 10e6, -1.0), Point { z: 30e6, x: 20e6 });
        assert_eq!(turn(Point { z: 1.0, x: 0.0 }, 90.0), Point { z: 0.0, x: 1.0 });
    }
}
