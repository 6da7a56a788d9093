//! Words that lead to a point of the plane of a cutter: X and C, X and Y, or Z and C.

use super::{Surface, face_point};
use crate::builder::Builder;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::Axis;

/// A full turn in micro-degrees.
const TURN: i64 = 360_000_000;

/// Words and where they lead.
pub(super) struct Way {
    pub items: Vec<Item>,
    /// The point of the plane.
    pub point: Point,
    /// Twice the chord from the present point, where it is known exactly.
    pub twice_chord: Option<i64>,
    /// The axes: program X and Z, program C; in coordinate conversion the point by X and Y.
    x: i64,
    z: i64,
    c: i64,
    kept: [i64; 2],
    around: f64,
}

impl Builder<'_, '_, '_> {
    /// Words to about a point; none where the axes cannot go there. `still`: the present point will do.
    pub(super) fn way_to(&mut self, wanted: Point, still: bool) -> Option<Way> {
        let way = match self.state.cutter.surface {
            Surface::Face => self.way_on_face(wanted, still),
            Surface::Conversion => self.way_in_conversion(wanted, still),
            Surface::Side => self.way_on_side(wanted, still),
        }?;
        let moves = way.point.minus(self.cutter_point()).length() > 0.0;
        (moves || still).then_some(way)
    }

    /// The way that stays where everything is.
    fn no_way(&self) -> Way {
        let state = &self.state;
        Way {
            items: Vec::new(),
            point: self.cutter_point(),
            twice_chord: None,
            x: state.program(Axis::X),
            z: state.program(Axis::Z),
            c: state.program_c(),
            kept: state.kept_point().unwrap_or_default(),
            around: state.cutter.around,
        }
    }

    /// Moves the axes.
    pub(super) fn follow(&mut self, way: &Way) {
        let from = self.present();
        match self.state.cutter.surface {
            Surface::Conversion => self.move_to_point(way.kept),
            _ => {
                self.state.move_to(Axis::X, way.x);
                self.state.move_to(Axis::Z, way.z);
                self.state.turn_to(way.c);
                self.state.cutter.around = way.around;
            }
        }
        self.travelled(from, self.present(), None);
    }

    fn way_on_face(&mut self, wanted: Point, still: bool) -> Option<Way> {
        let mut way = self.no_way();
        let (start, start_c) = (way.x, way.c);
        let diameter = (wanted.length() * 2.0).round() as i64;
        let angle = (wanted.angle() * 1_000.0).round() as i64 * 1_000;
        let turns = diameter > 0 && (angle - start_c).rem_euclid(TURN) != 0;
        if (diameter - start).abs() > 600 || still && !turns || self.choices.chance(15) {
            let (item, x) = self.target(Axis::X, diameter);
            way.items.push(item);
            way.x = x;
        }
        if turns || self.choices.chance(10) {
            let wanted = if turns { angle } else { start_c };
            let (item, c) = self.c_word(wanted.rem_euclid(TURN));
            way.items.push(item);
            way.c = c;
        }
        if way.items.is_empty() || way.x < 0 || !self.state.fits(Axis::X, way.x) {
            return None;
        }
        way.point = face_point(way.x, way.c);
        way.twice_chord = match (way.c - start_c).rem_euclid(TURN) {
            0 => Some((way.x - start).abs()),
            180_000_000 => Some(way.x + start),
            _ => None,
        };
        Some(way)
    }

    fn way_in_conversion(&mut self, wanted: Point, still: bool) -> Option<Way> {
        let mut way = self.no_way();
        let start = self.state.kept_point()?;
        let wanted = [wanted.z, wanted.x].map(|coordinate| self.on_grid(coordinate.round() as i64));
        let mut chosen = [0, 1].map(|place: usize| wanted[place] != start[place] || self.choices.chance(20));
        if chosen == [false, false] {
            chosen[0] = still;
        }
        let (items, point) = self.point_words(wanted, start, chosen);
        (way.items, way.kept) = (items, point);
        way.point = Point { z: point[0] as f64, x: point[1] as f64 };
        (way.x, way.c) = self.axes_of_point(point);
        way.twice_chord = [0, 1].into_iter().find_map(|axis: usize| {
            (point[axis] == start[axis]).then(|| 2 * (point[1 - axis] - start[1 - axis]).abs())
        });
        (!way.items.is_empty() && self.state.fits(Axis::X, way.x)).then_some(way)
    }

    fn way_on_side(&mut self, wanted: Point, still: bool) -> Option<Way> {
        let mut way = self.no_way();
        let (start, start_c) = (way.z, way.c);
        let around = std::f64::consts::PI * way.x as f64;
        let along = (wanted.z - self.cutter_point().z) * self.side_sign();
        let degrees = along / around * 360.0;
        if around <= 0.0 || degrees.abs() > 355.0 {
            return None;
        }
        let angle = (degrees * 1_000.0).round() as i64 * 1_000;
        let z = wanted.x.round() as i64;
        if (z - start).abs() > 600 || still && angle == 0 || self.choices.chance(15) {
            let (item, reached) = self.target(Axis::Z, z);
            way.items.push(item);
            way.z = reached;
        }
        if angle != 0 || self.choices.chance(8) {
            let back = angle < 0;
            if angle != 0 && self.state.contours.is_backward() != back || self.choices.chance(12) {
                let code = if back { 16 } else { 15 };
                self.state.contours.note_m(code);
                way.items.push(Item::m(code));
            }
            let (item, c) = self.c_word((start_c + angle).rem_euclid(TURN));
            way.items.push(item);
            way.c = c;
        }
        if self.choices.chance(8) {
            // X may be written as it is (E100L-CRC-18).
            let (item, x) = self.plain_target_x(way.x);
            if x == way.x {
                way.items.push(item);
            }
        }
        let forward = (way.c - start_c).rem_euclid(TURN);
        let backward = self.state.contours.is_backward() && forward != 0;
        let travel = if backward { forward - TURN } else { forward };
        way.around += around * travel as f64 / TURN as f64;
        way.point = Point { z: self.side_sign() * way.around, x: way.z as f64 };
        way.twice_chord = (travel == 0).then(|| 2 * (way.z - start).abs());
        let moves = |item: &Item| matches!(item, Item::Word(word) if matches!(word.address, "Z" | "C"));
        let words = way.items.iter().any(moves);
        (words && self.state.fits(Axis::Z, way.z)).then_some(way)
    }
}
