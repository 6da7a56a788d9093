//! Arcs of a compensated contour: tangential or not, larger and smaller than the cutter, round the centre of the face.

use super::Surface;
use super::element::turn;
use crate::builder::Builder;
use crate::compensation::corner::left;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::Mode;

/// How an arc leaves.
#[derive(Clone, Copy)]
enum Starting {
    Tangential,
    Along,
    Turned,
}

impl Builder<'_, '_, '_> {
    /// An arc; false where the control would refuse it.
    pub(super) fn cutter_arc(&mut self, mut items: Vec<Item>) -> bool {
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
    use super::{Point, centre_of};

    #[test]
    fn centres_are_those_of_the_plane() {
        let (from, to) = (Point { z: 20e6, x: 20e6 }, Point { z: 30e6, x: 30e6 });
        assert_eq!(centre_of(from, to, 10e6, 1.0), Point { z: 20e6, x: 30e6 });
        assert_eq!(centre_of(from, to, 10e6, -1.0), Point { z: 30e6, x: 20e6 });
    }
}
