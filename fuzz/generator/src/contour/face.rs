//! Lines on the face by X and C: G101.

use crate::builder::Builder;
use crate::state::{Axis, Mode};

/// Where a line leads, seen from the centre of the face.
#[derive(Clone, Copy, PartialEq)]
enum Row {
    /// Along the ray of the start.
    Ray,
    /// To the opposite ray, through the centre.
    Opposite,
    /// Past the centre by a thousandth of a degree.
    Beside,
    /// To the centre.
    Centre,
    /// Anywhere.
    Elsewhere,
    /// Nowhere.
    Stay,
}

const ROWS: &[(usize, Row)] = &[
    (12, Row::Ray),
    (12, Row::Opposite),
    (6, Row::Beside),
    (14, Row::Centre),
    (50, Row::Elsewhere),
    (2, Row::Stay),
];

impl Builder<'_, '_, '_> {
    /// A block of G101; false where the control would refuse it.
    pub(super) fn face_line(&mut self) -> bool {
        let mut items = Vec::new();
        self.beside_contour(false, &mut items);
        self.select(Mode::FaceLine, &mut items);
        let from = self.present();
        let (start, start_c) = (self.state.program(Axis::X), self.state.program_c());
        let row = self.choices.weighted(ROWS);
        let wanted = match row {
            Row::Centre => 0,
            Row::Stay => start,
            _ => self.some_diameter(),
        };
        let half = 180_000_000;
        let wanted_c = match row {
            Row::Ray | Row::Stay => start_c,
            Row::Opposite => start_c + half,
            Row::Beside => start_c + half + self.choices.pick(&[-1_000, 1_000]),
            Row::Centre if self.choices.chance(40) => start_c,
            Row::Centre | Row::Elsewhere => self.some_angle(),
        };
        let (mut x, mut c) = (start, start_c);
        if wanted != start || self.choices.chance(40) {
            let (item, reached) = self.target(Axis::X, wanted);
            items.push(item);
            x = reached;
        }
        if wanted_c.rem_euclid(360_000_000) != start_c || x == start && self.choices.chance(60) {
            let (item, reached) = self.c_word(wanted_c.rem_euclid(360_000_000));
            items.push(item);
            c = reached;
        }
        let centre = start == 0 || x == 0 || (c - start_c).rem_euclid(360_000_000) == half;
        if self.choices.chance(if centre { 6 } else { 20 }) {
            let z = self.state.program(Axis::Z);
            let wanted = if centre { z } else { self.state.somewhere(Axis::Z, self.choices) };
            let (item, reached) = self.target(Axis::Z, wanted);
            if !self.state.fits(Axis::Z, reached) || centre && reached != z {
                return false;
            }
            items.push(item);
            self.state.move_to(Axis::Z, reached);
        }
        let passes_centre = centre && (start != 0 || x != 0);
        let fits = start >= 0 && x >= 0 && self.state.fits(Axis::X, x);
        if !fits || passes_centre && !self.state.fits(Axis::X, 0) {
            return false;
        }
        self.state.move_to(Axis::X, x);
        self.state.turn_to(c);
        self.travelled(from, self.present(), None);
        self.cut_contour(items);
        true
    }

    /// A diameter within the limits, not below zero.
    pub(super) fn some_diameter(&mut self) -> i64 {
        self.state.somewhere(Axis::X, self.choices).abs()
    }
}
