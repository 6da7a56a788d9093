//! Arcs on the face by X and C: G102, G103.

use super::plane::{Spot, is_too_near};
use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

impl Builder<'_, '_, '_> {
    /// A block of G102 or G103; false where the control would refuse it.
    pub(super) fn face_arc(&mut self) -> bool {
        let mut items = Vec::new();
        self.beside_contour(false, &mut items);
        let counter = self.choices.chance(50);
        self.select(if counter { Mode::FaceCounter } else { Mode::FaceClockwise }, &mut items);
        let from = self.present();
        let (start, start_c) = (self.state.program(Axis::X), self.state.program_c());
        let (wanted, wanted_c) = self.end_of_face_arc(start, start_c, counter);
        let (mut x, mut c) = (start, start_c);
        if wanted != start || self.choices.chance(25) {
            let (item, reached) = self.target(Axis::X, wanted);
            items.push(item);
            x = reached;
        }
        if wanted_c != start_c || self.choices.chance(25) {
            let (item, reached) = self.c_word(wanted_c);
            items.push(item);
            c = reached;
        }
        if start <= 0 || x <= 0 || !self.state.fits(Axis::X, x) {
            return false;
        }
        let (one, other) = (Spot::on_face(start, start_c), Spot::on_face(x, c));
        // Half a circle on one ray or on two opposite ones is exact.
        let exact = match (c - start_c).rem_euclid(360_000_000) {
            0 => Some((x - start).abs()),
            180_000_000 => Some(x + start),
            _ => None,
        };
        let Some(word) = self.radius_of_arc(
            one,
            other,
            exact.filter(|twice| twice % 4 == 0).map(|twice| twice / 2),
            counter,
        ) else {
            return false;
        };
        items.push(word);
        self.state.move_to(Axis::X, x);
        self.state.turn_to(c);
        self.travelled(from, self.present(), None);
        self.cut_contour(items);
        true
    }

    /// Where an arc may end: anywhere, on the same or the opposite ray, or so that it goes round the centre.
    fn end_of_face_arc(&mut self, start: i64, start_c: i64, counter: bool) -> (i64, i64) {
        let sense = if counter { 1 } else { -1 };
        let grid = self.choices.pick(&[1_000_000, 1_000]);
        let (x, turn) = match self.choices.below(10) {
            0 => (self.some_diameter(), 0),
            1 => (start, 180_000_000),
            2 => (self.some_diameter(), 180_000_000),
            // Against the sense of the chord, beside the centre.
            3..=5 => {
                let away = self.choices.within(1_000_000 / grid, 60_000_000 / grid) * grid;
                let near = start + self.choices.within(-5_000, 5_000) * 1_000;
                (near, sense * (180_000_000 + away))
            }
            6 => (start, self.some_angle()),
            _ => (self.some_diameter(), self.some_angle()),
        };
        (x, (start_c + turn).rem_euclid(360_000_000))
    }

    /// An L word for an arc between two points of the face: half a circle, a little more than that, or much more. `exact`: the
    /// distance of the points where it is known exactly. None where the control would refuse it.
    pub(super) fn radius_of_arc(
        &mut self,
        start: Spot,
        end: Spot,
        exact: Option<i64>,
        counter: bool,
    ) -> Option<Item> {
        let (word, radius) = self.radius_above(start.distance(end), exact)?;
        let centre = start.centre(end, radius, counter);
        (!is_too_near(centre, radius)).then_some(word)
    }

    /// An L word for an arc with this chord, and what the control reads.
    pub(super) fn radius_above(&mut self, chord: f64, exact: Option<i64>) -> Option<(Item, f64)> {
        if !(2_000.0..150e9).contains(&chord) {
            return None;
        }
        if let Some(exact) = exact
            && self.choices.chance(45)
        {
            let (word, radius) = self.plain_length("L", exact / 2);
            if radius * 2 == exact {
                return Some((word, radius as f64));
            }
        }
        let least = (chord / 2.0).ceil() as i64 + 1_000;
        let wanted = match self.choices.below(6) {
            0 => least + 1_000,
            1 | 2 => least + least / 100 * self.choices.within(0, 12),
            3 | 4 => least * self.choices.within(1, 4) + 5_000_000,
            _ => least.saturating_mul(self.choices.pick(&[10, 100])),
        };
        let (word, radius) = self.length("L", wanted.min(90_000_000_000));
        (radius >= least).then_some((word, radius as f64))
    }
}
