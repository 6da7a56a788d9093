//! Arcs, G02 and G03: by centre (exactly closing or within the tolerance), with one coordinate, by radius.

use turnspec_oracle::vocabulary::ArcOneCoordinate;

use crate::builder::Builder;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// Vectors of length 5 with whole components, counter-clockwise.
const SPOKES: [(f64, f64); 12] = [
    (5.0, 0.0),
    (4.0, 3.0),
    (3.0, 4.0),
    (0.0, 5.0),
    (-3.0, 4.0),
    (-4.0, 3.0),
    (-5.0, 0.0),
    (-4.0, -3.0),
    (-3.0, -4.0),
    (0.0, -5.0),
    (3.0, -4.0),
    (4.0, -3.0),
];

/// Words of an arc, where it ends, and its centre.
type Arc = Option<(Vec<Item>, Point, Point)>;

impl Builder<'_, '_, '_> {
    /// A block of G02 or G03, or a line when no arc fits here.
    pub(crate) fn arc(&mut self) {
        let mode = if self.choices.chance(50) { Mode::Clockwise } else { Mode::CounterClockwise };
        let mut items = Vec::new();
        self.companions(&mut items);
        self.feed_if_needed(&mut items);
        if self.state.compensation.left_over && !self.choices.chance(6) {
            return self.line(Mode::Linear);
        }
        let start = self.present();
        let mut arc = match self.choices.below(10) {
            0..=2 => self.exact_arc(start),
            3..=4 => self.near_arc(start),
            5..=6 => self.one_coordinate_arc(start, mode),
            _ => None,
        };
        if arc.is_none() {
            arc = self.radius_arc(start, mode);
        }
        match arc {
            Some((words, end, centre)) => {
                self.select(mode, &mut items);
                items.extend(words);
                self.state.move_to(Axis::X, end.diameter());
                self.state.move_to(Axis::Z, end.coordinate());
                self.travelled(start, end, Some((centre, mode)));
            }
            None => {
                self.select(Mode::Linear, &mut items);
                self.line_words(&mut items);
                self.travelled_by(&items, start);
            }
        }
        self.state.after_cutting = true;
        self.push(items);
    }

    /// An arc by centre that closes exactly wherever lengths can be written exactly.
    fn exact_arc(&mut self, start: Point) -> Arc {
        let from = self.choices.below(SPOKES.len());
        let to = (from + 1 + self.choices.below(SPOKES.len() - 1)) % SPOKES.len();
        let size = self.choices.pick(&[1_000, 200, 20]) * self.choices.within(1, 8);
        let scale = (size * self.state.units.finest()) as f64;
        let spoke = |place: usize| Point { z: SPOKES[place].0, x: SPOKES[place].1 }.times(scale);
        let centre = start.minus(spoke(from));
        self.centred(start, centre, centre.plus(spoke(to)))
    }

    /// An arc by centre whose end point is rounded.
    fn near_arc(&mut self, start: Point) -> Arc {
        let radius = self.choices.within(500, 40_000) as f64 * 1_000.0;
        let spoke = |angle: i64| Point::direction(angle * 1_000_000).times(radius);
        let from = self.choices.within(0, 359);
        let to = from + self.choices.within(5, 355);
        let centre = start.minus(spoke(from));
        self.centred(start, centre, centre.plus(spoke(to)))
    }

    /// Words of an arc by centre, if it closes and ends within the limits.
    pub(crate) fn centred(&mut self, start: Point, centre: Point, end: Point) -> Arc {
        if !self.point_fits(end) {
            return None;
        }
        let (mut words, offset) = self.centre_words(start, centre);
        let (coordinates, end) = self.straight(start, end)?;
        words.splice(0..0, coordinates);
        let centre = start.plus(offset);
        let (first, last) = (offset.length(), end.minus(centre).length());
        let tolerance = self.state.setup.parameters.circular_radius_tolerance.0 as f64;
        let closes = (first - last).abs() <= (tolerance - 5.0).max(1e-3);
        (closes && end != start).then_some((words, end, centre))
    }

    /// I and K toward a centre, a zero usually left out; and the centre from the start.
    fn centre_words(&mut self, start: Point, centre: Point) -> (Vec<Item>, Point) {
        let offset = centre.minus(start);
        let (i, x) = self.length("I", offset.x.round() as i64);
        let (k, z) = self.length("K", offset.z.round() as i64);
        let mut words = vec![i, k];
        if z == 0 && self.choices.chance(70) {
            words.pop();
        }
        if x == 0 && self.choices.chance(70) {
            words.remove(0);
        }
        (words, Point { z: z as f64, x: x as f64 })
    }

    /// An arc with one of X and Z (E100L-CIRC-08).
    fn one_coordinate_arc(&mut self, start: Point, mode: Mode) -> Arc {
        let radius = self.choices.within(1_000, 40_000) as f64 * 1_000.0;
        let from = self.choices.within(0, 359);
        let centre = start.minus(Point::direction(from * 1_000_000).times(radius));
        let (mut words, offset) = self.centre_words(start, centre);
        let centre = start.plus(offset);
        let by_x = self.choices.chance(50);
        let wanted = match self.state.setup.readings.arc_one_coordinate {
            ArcOneCoordinate::Quadrant => self.within_quadrant(start, centre, mode)?,
            ArcOneCoordinate::Start if by_x => Point { x: 2.0 * centre.x - start.x, ..start },
            ArcOneCoordinate::Start => Point { z: 2.0 * centre.z - start.z, ..start },
        };
        let end = if by_x {
            let (item, x) = self.target(Axis::X, wanted.diameter());
            words.insert(0, item);
            Point { x: x as f64 / 2.0, ..wanted }
        } else {
            let (item, z) = self.target(Axis::Z, wanted.coordinate());
            words.insert(0, item);
            Point { z: z as f64, ..wanted }
        };
        let difference = (offset.length() - end.minus(centre).length()).abs();
        let tolerance = self.state.setup.parameters.circular_radius_tolerance.0 as f64;
        let closes = self.state.setup.readings.arc_one_coordinate == ArcOneCoordinate::Quadrant
            || difference <= (tolerance - 5.0).max(1e-3);
        (closes && self.point_fits(end) && end.minus(start).length() > 1e4).then_some((words, end, centre))
    }

    /// A point between the start and the end of its quadrant about the centre.
    fn within_quadrant(&mut self, start: Point, centre: Point, mode: Mode) -> Option<Point> {
        let spoke = start.minus(centre);
        let angle = spoke.angle().rem_euclid(360.0);
        let into = angle.rem_euclid(90.0);
        let counter = mode == Mode::CounterClockwise;
        let on_axis = !(1e-6..=90.0 - 1e-6).contains(&into);
        let left = match (on_axis, counter) {
            (true, _) => 90.0,
            (false, true) => 90.0 - into,
            (false, false) => into,
        };
        if left < 8.0 {
            return None;
        }
        let part = self.choices.within(30, 90) as f64 / 100.0 * left;
        let to = if counter { angle + part } else { angle - part };
        Some(centre.plus(Point::direction((to * 1e6) as i64).times(spoke.length())))
    }

    /// An arc by radius, minor or major.
    fn radius_arc(&mut self, start: Point, mode: Mode) -> Arc {
        let wanted = self.somewhere_near(start);
        let (mut words, end) = self.straight(start, wanted)?;
        let half = end.minus(start).length() / 2.0;
        let increment = if self.state.units.system.is_inch() { 5_080.0 } else { 1_000.0 };
        let least = (half / increment).ceil() * increment;
        let more = self.choices.pick(&[0, 1, 1_000, 100_000]) * self.choices.within(0, 500) * 1_000;
        let (item, radius) = self.length("L", least as i64 + more);
        if end == start || (radius as f64) < half || !(1e3..9e10).contains(&half) {
            return None;
        }
        words.push(item);
        let major = self.choices.chance(30);
        if major {
            let place = self.choices.below(words.len() + 1);
            words.insert(place, Item::Calrg);
        }
        let on_left = (mode == Mode::CounterClockwise) != major;
        let centre = centre_by_radius(start, end, radius as f64, on_left)?;
        Some((words, end, centre))
    }
}

/// The centre of an arc by radius, on the left or the right of the way from its start to its end.
pub(crate) fn centre_by_radius(start: Point, end: Point, radius: f64, on_left: bool) -> Option<Point> {
    let half = end.minus(start).times(0.5);
    let away = (radius * radius - half.z * half.z - half.x * half.x).max(0.0).sqrt();
    let across = Point { z: -half.x, x: half.z }.times(away / half.length());
    let centre = start.plus(half).plus(across.times(if on_left { 1.0 } else { -1.0 }));
    (radius >= half.length()).then_some(centre)
}
