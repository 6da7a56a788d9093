//! Arcs on the side by Z and C: G132, G133.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// A full turn in micro-degrees.
const TURN: i64 = 360_000_000;

impl Builder<'_, '_, '_> {
    /// A run on the side.
    pub(super) fn side_run(&mut self) {
        if self.state.program(Axis::X) <= 0 || self.choices.chance(60) {
            self.position_for_contour();
        }
        for _ in 0..=self.choices.below(5) {
            if self.choices.chance(15) {
                self.between_contours();
            }
            if !self.still_ready() || !self.side_mode() {
                return;
            }
            if !self.attempt(Self::side_arc) {
                self.position_for_contour();
            }
        }
        if self.choices.chance(20) {
            self.begin();
            self.state.plane = 18;
            self.push(vec![Item::g(136)]);
        }
    }

    /// G119 where the side needs it, and sometimes where it does not; false where it cannot be had.
    fn side_mode(&mut self) -> bool {
        let needed = self.state.setup.parameters.side_contour_mode && self.state.plane != 119;
        if !self.allows(Feature::RadiusCompensation) {
            return !needed;
        }
        if needed || self.choices.chance(6) {
            self.begin();
            self.state.plane = 119;
            self.push(vec![Item::g(119)]);
        }
        true
    }

    /// A block of G132 or G133; false where the control would refuse it.
    fn side_arc(&mut self) -> bool {
        let mut items = Vec::new();
        self.beside_contour(false, &mut items);
        let counter = self.choices.chance(50);
        self.select(if counter { Mode::SideCounter } else { Mode::SideClockwise }, &mut items);
        let from = self.present();
        let [x, start, start_c] =
            [self.state.program(Axis::X), self.state.program(Axis::Z), self.state.program_c()];
        let (mut z, mut c) = (start, start_c);
        if self.choices.chance(75) {
            let wanted = self.state.somewhere(Axis::Z, self.choices);
            let (item, reached) = self.target(Axis::Z, wanted);
            items.push(item);
            z = reached;
        }
        if self.choices.chance(75) {
            let wanted = self.some_angle();
            let (item, reached) = self.c_word(wanted);
            items.push(item);
            c = reached;
        }
        if self.choices.chance(6) {
            let (item, reached) = self.target(Axis::X, x);
            if reached != x {
                return false;
            }
            items.push(item);
        }
        let forward = (c - start_c).rem_euclid(TURN);
        let back = self.state.contours.backward && forward != 0;
        let travel = if back { forward - TURN } else { forward };
        let around = std::f64::consts::PI * x as f64 * travel as f64 / TURN as f64;
        let chord = around.hypot((z - start) as f64);
        let exact = (travel == 0).then_some((z - start).abs());
        let Some((word, _)) = self.radius_above(chord, exact) else { return false };
        let under_mode = self.state.plane == 119 || !self.state.setup.parameters.side_contour_mode;
        if x <= 0 || !under_mode || !self.state.fits(Axis::Z, z) {
            return false;
        }
        items.push(word);
        self.state.move_to(Axis::Z, z);
        self.state.turn_to(c);
        self.travelled(from, self.present(), None);
        self.cut_contour(items);
        true
    }
}
