//! Elements that meet the one before in a chosen way: straight on, back, square, acute, tangentially, about the
//! same centre, as long as the nose or shorter.

use crate::builder::Builder;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::{Axis, Mode};

use super::corner::left;

/// Directions of length 5 with whole components, counter-clockwise.
const SPOKES: [(i64, i64); 12] = [
    (5, 0),
    (4, 3),
    (3, 4),
    (0, 5),
    (-3, 4),
    (-4, 3),
    (-5, 0),
    (-4, -3),
    (-3, -4),
    (0, -5),
    (3, -4),
    (4, -3),
];

/// How a line leaves the element before it.
#[derive(Clone, Copy)]
enum Leaving {
    Along(Axis),
    Spoke,
    Ahead,
    Back,
    Nearly,
    Square,
    Acute,
    Anywhere,
}

/// How an arc leaves the element before it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Starting {
    Tangential,
    Concentric,
    Back,
    Anyhow,
}

impl Builder<'_, '_, '_> {
    /// A line of the contour.
    pub(crate) fn contour_line(&mut self) {
        let mut items = Vec::new();
        self.companions(&mut items);
        let mode = if self.choices.chance(15) { Mode::Rapid } else { Mode::Linear };
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        let travel = self.contour_travel(&mut items);
        self.line_to(from.plus(travel), &mut items);
        self.travelled(from, self.present(), None);
        self.state.after_cutting = mode == Mode::Linear;
        self.push(items);
    }

    /// Words to a point; an axis that does not move is usually left out.
    fn line_to(&mut self, wanted: Point, items: &mut Vec<Item>) {
        self.state.compensation.misfit |= !self.point_fits(wanted) || !self.is_near(wanted);
        let from = self.present();
        let still = wanted == from;
        let moves = [(Axis::X, wanted.x - from.x), (Axis::Z, wanted.z - from.z)];
        for (axis, by) in moves {
            if by != 0.0 || still || self.choices.chance(8) {
                let coordinate = if axis == Axis::X { wanted.diameter() } else { wanted.coordinate() };
                let (item, target) = self.target(axis, coordinate);
                items.push(item);
                self.state.move_to(axis, target);
            }
        }
    }

    /// Whether a point lies where blocks should end.
    fn is_near(&self, point: Point) -> bool {
        let within = |axis, value| {
            let (low, high) = self.state.window(axis);
            (low..=high).contains(&value)
        };
        within(Axis::X, point.diameter()) && within(Axis::Z, point.coordinate())
    }

    fn contour_travel(&mut self, items: &mut Vec<Item>) -> Point {
        let leaving = self.choices.weighted(&[
            (22, Leaving::Along(Axis::Z)),
            (18, Leaving::Along(Axis::X)),
            (18, Leaving::Spoke),
            (10, Leaving::Ahead),
            (8, Leaving::Back),
            (4, Leaving::Nearly),
            (8, Leaving::Square),
            (5, Leaving::Acute),
            (7, Leaving::Anywhere),
        ]);
        let length = self.leg();
        let sign = if self.choices.chance(50) { 1.0 } else { -1.0 };
        let last = self.state.compensation.last.as_ref().map(|last| last.direction);
        match (leaving, last) {
            (Leaving::Along(Axis::X), _) => Point { z: 0.0, x: sign * length },
            (Leaving::Ahead, Some(last)) => self.stretched(last),
            (Leaving::Back, Some(last)) => {
                if self.choices.chance(60) {
                    self.change_side(items);
                }
                self.stretched(last).times(-1.0)
            }
            (Leaving::Nearly, Some(last)) => {
                let aside = left(last.times(sign / last.length().max(1.0)));
                let aside = aside.times(self.state.units.finest() as f64);
                self.stretched(last).times(sign).plus(aside)
            }
            (Leaving::Square, Some(last)) => left(self.stretched(last)).times(sign),
            (Leaving::Acute, Some(last)) => {
                let turn = 180_000_000 + self.choices.within(1_000, 40_000) * sign as i64 * 1_000;
                let angle = (last.angle() * 1e6) as i64 + turn;
                Point::direction(angle).times(length.max(1e6))
            }
            (Leaving::Anywhere, _) => {
                let from = self.present();
                self.somewhere_near(from).minus(from)
            }
            (Leaving::Spoke, _) => {
                let spoke = self.choices.below(SPOKES.len());
                self.spoke(spoke, length)
            }
            _ => Point { z: sign * length, x: 0.0 },
        }
    }

    /// Changes to the other side, if no code of the group stands in the block.
    fn change_side(&mut self, items: &mut Vec<Item>) {
        let compensation = &mut self.state.compensation;
        let written = |item: &Item| matches!(item, Item::Word(word) if word.is_g(&[40, 41, 42]));
        if compensation.is_on() && !items.iter().any(written) {
            compensation.side = compensation.side.other();
            items.push(Item::g(compensation.side as i64));
        }
    }

    /// A multiple of a direction, or a simple part of it where it is long.
    fn stretched(&mut self, direction: Point) -> Point {
        let factor = match direction.length() {
            length if length > 2e7 => self.choices.pick(&[1.0, 0.5, 0.2, 0.1]),
            length if length < 1e6 => self.choices.pick(&[1.0, 2.0, 20.0, 50.0]),
            _ => self.choices.pick(&[1.0, 0.5, 2.0, 3.0]),
        };
        direction.times(factor)
    }

    /// A length in nanometres: often about the radius of the nose, or simply long enough.
    fn leg(&mut self) -> f64 {
        let finest = self.state.units.finest();
        let radius = self.state.compensation.radius().max(finest);
        let length = match self.choices.below(10) {
            0 => radius,
            1 => radius / 2,
            2 => radius * 2 + self.choices.within(-1, 1) * finest,
            3 => self.choices.within(1, 1_000) * finest,
            4 | 5 => radius * self.choices.within(2, 6),
            _ => self.choices.within(1, 40) * 1_000_000,
        };
        ((length / finest).max(1) * finest) as f64
    }

    /// A vector of about this length along one of the spokes, whole in increments.
    fn spoke(&self, place: usize, length: f64) -> Point {
        let finest = self.state.units.finest() as f64;
        let size = (length / 5.0 / finest).round().max(1.0) * finest;
        let (z, x) = SPOKES[place % SPOKES.len()];
        Point { z: z as f64, x: x as f64 }.times(size)
    }

    /// An arc of the contour, or a line where none closes.
    pub(crate) fn contour_arc(&mut self) {
        let mode = if self.choices.chance(50) { Mode::Clockwise } else { Mode::CounterClockwise };
        let mut items = Vec::new();
        self.companions(&mut items);
        let start = self.present();
        let starting = self.choices.weighted(&[
            (55, Starting::Tangential),
            (10, Starting::Concentric),
            (8, Starting::Back),
            (27, Starting::Anyhow),
        ]);
        if starting == Starting::Back && self.choices.chance(70) {
            self.change_side(&mut items);
        }
        self.feed_if_needed(&mut items);
        let from = self.spoke_to_start(start, mode, starting);
        let centre = start.minus(from);
        let to = self.end_spoke(from);
        let arc = if self.choices.chance(30) {
            self.arc_by_radius_about(start, centre, centre.plus(to), mode)
        } else {
            self.centred(start, centre, centre.plus(to))
        };
        let Some((words, end, centre)) = arc else {
            self.state.compensation.misfit = true;
            return;
        };
        self.select(mode, &mut items);
        items.extend(words);
        self.state.move_to(Axis::X, end.diameter());
        self.state.move_to(Axis::Z, end.coordinate());
        self.state.compensation.misfit |= !self.is_near(end);
        self.travelled(start, self.present(), Some((centre, mode)));
        self.state.after_cutting = true;
        self.push(items);
    }

    /// The way from the centre of an arc to its start.
    fn spoke_to_start(&mut self, start: Point, mode: Mode, starting: Starting) -> Point {
        let length = self.arc_radius();
        let last = self.state.compensation.last.clone();
        let sense = if mode == Mode::CounterClockwise { 1.0 } else { -1.0 };
        match (starting, last) {
            (Starting::Concentric, Some(last)) => {
                let (_, to_centre, _) = last.circle.unwrap_or((start, self.spoke(0, length), 1.0));
                to_centre.times(-1.0)
            }
            (Starting::Tangential | Starting::Back, Some(last)) => {
                let forth = if starting == Starting::Back { -1.0 } else { 1.0 };
                let across = left(last.direction).times(-sense * forth);
                let spoke = SPOKES.iter().position(|(z, x)| {
                    let spoke = Point { z: *z as f64, x: *x as f64 };
                    let (cross, length) = (spoke.cross(across), across.length());
                    cross.abs() < 1e-9 * length && spoke.z * across.z + spoke.x * across.x > 0.0
                });
                match spoke {
                    Some(place) => self.spoke(place, length),
                    None => across.times(length / across.length().max(1.0)),
                }
            }
            _ => {
                let place = self.choices.below(SPOKES.len());
                self.spoke(place, length)
            }
        }
    }

    /// A radius: about that of the nose, twice of it, or simply large enough.
    fn arc_radius(&mut self) -> f64 {
        let (finest, radius) = (self.state.units.finest(), self.state.compensation.radius());
        let length = match self.choices.below(12) {
            0 => radius,
            1 => radius + 5 * finest,
            2 => radius - 5 * finest,
            3 | 4 => radius * 2,
            5 => radius * 2 - 5 * finest,
            6 => radius / 2,
            7 | 8 => radius * 3 + self.choices.within(0, 100) * finest,
            _ => self.choices.within(1, 40) * 1_000_000,
        };
        length.max(5 * finest) as f64
    }

    /// The way from the centre to the end: along a spoke of the same length.
    fn end_spoke(&mut self, from: Point) -> Point {
        let quarters = self.choices.within(1, 3);
        let turned = (0..quarters).fold(from, |way, _| left(way));
        let whole = |way: Point| (way.z / 5.0).fract() == 0.0 && (way.x / 5.0).fract() == 0.0;
        let on_axis = from.z == 0.0 || from.x == 0.0;
        if on_axis && whole(from) && self.choices.chance(40) {
            let place = self.choices.below(SPOKES.len());
            let spoke = self.spoke(place, from.length());
            return if (spoke.length() - from.length()).abs() < 0.5 { spoke } else { turned };
        }
        turned
    }

    /// Words of an arc of X, Z and L, with CALRG where it is more than half a turn.
    fn arc_by_radius_about(
        &mut self,
        start: Point,
        centre: Point,
        end: Point,
        mode: Mode,
    ) -> Option<(Vec<Item>, Point, Point)> {
        if !self.point_fits(end) {
            return None;
        }
        let (mut words, end) = self.straight(start, end)?;
        let radius = start.minus(centre).length();
        let (item, radius) = self.length("L", radius.round() as i64);
        words.push(item);
        let turn = start.minus(centre).cross(end.minus(centre));
        let counter = mode == Mode::CounterClockwise;
        let major = (turn < 0.0) == counter && turn.abs() > 1.0;
        if major {
            words.push(Item::Calrg);
        }
        let centre = super::super::arcs::centre_by_radius(start, end, radius as f64, counter != major);
        (end != start).then_some((words, end, centre?))
    }
}
