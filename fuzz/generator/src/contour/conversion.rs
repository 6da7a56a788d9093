//! Coordinate conversion: a run from G137 to G136.

use turnspec_oracle::vocabulary::{ConversionZeroShift, Feature};

use super::Kept;
use super::plane::Spot;
use super::point::Course;
use crate::builder::Builder;
use crate::number::Number;
use crate::program::Item;
use crate::state::{Axis, Mode};
use crate::unit::Written;

impl Builder<'_, '_, '_> {
    /// G137, positions and contours by X and Y, G136; nothing where the mode cannot begin.
    pub(super) fn conversion_run(&mut self) {
        if self.is_modal_motion() || !self.begin_conversion() {
            return self.line(Mode::Rapid);
        }
        for _ in 0..self.choices.below(9) {
            self.begin();
            self.conversion_block();
            if !self.state.contours.converts() {
                // Behind holes.
                return;
            }
            if !self.still_ready() || self.state.control.steady {
                break;
            }
            if self.choices.chance(3) && !self.begin_conversion() {
                break;
            }
        }
        if self.choices.chance(8) {
            // The end of the program ends the mode.
            return self.nothing_more();
        }
        self.end_conversion();
    }

    /// G136, alone in its block.
    pub(crate) fn end_conversion(&mut self) {
        self.begin();
        let contours = &mut self.state.contours;
        (contours.direction, contours.given, contours.kept) = (None, false, None);
        self.state.plane = 18;
        self.push(vec![Item::g(136)]);
    }

    /// G137; false where the control would refuse it.
    pub(crate) fn begin_conversion(&mut self) -> bool {
        if self.state.incremental && !self.allows(Feature::Absolute) {
            return false;
        }
        let at_limit = [Axis::X, Axis::Z].iter().any(|axis| {
            let (place, limit) = (self.state.machine[*axis as usize], self.state.limits[*axis as usize]);
            limit.positive.is_some_and(|limit| place >= limit.0 - 10)
                || limit.negative.is_some_and(|limit| place <= limit.0 + 10)
        });
        if at_limit {
            return false;
        }
        if self.choices.chance(25)
            && self.allows(Feature::ZeroShift)
            && self.state.contours.direction.is_none()
        {
            self.begin();
            let wanted = self.choices.within(-359, 359) * 1_000_000;
            let (item, angle) = self.angle("C", wanted);
            self.state.c_shift += self.state.program_c() - angle;
            self.push(vec![Item::g(50), item]);
        }
        self.begin();
        let mut items = Vec::new();
        if self.state.incremental {
            items.push(self.incremental_word(false));
        }
        items.push(Item::g(137));
        let grid = self.choices.weighted(&[(30, 30_000_000), (30, 10_000_000), (20, 1_000_000), (20, 1_000)]);
        let wanted = self.choices.within(-359_999_000 / grid, 359_999_000 / grid) * grid;
        let (item, direction) = self.angle("C", wanted);
        items.push(item);
        self.state.mode = Mode::None;
        let contours = &mut self.state.contours;
        (contours.direction, contours.given, contours.kept) =
            (Some(direction.rem_euclid(360_000_000)), false, None);
        self.push(items);
        true
    }

    /// A block in conversion mode, or two.
    fn conversion_block(&mut self) {
        let holds = self.state.kept_point().is_some();
        if !self.state.contours.given {
            match self.choices.below(9) {
                0 => return self.along_axis(),
                1 if self.allows(Feature::Dwell) => return self.dwell(),
                2 => return self.beside_points(),
                3 if self.may_drill_points() => return self.holes(),
                _ => return self.first_point(),
            }
        }
        match self.choices.below(22) {
            20 | 21 if self.may_drill_points() => self.holes(),
            0..=7 if holds => drop(self.attempt(|builder| builder.point_block(Course::Line))),
            8..=13 if holds => drop(self.attempt(|builder| builder.point_block(Course::Arc))),
            14 => self.along_axis(),
            15 => self.beside_points(),
            16 if self.allows(Feature::ZeroShift) => self.shift_of_z(),
            17 if self.choices.chance(50) => self.beyond_the_limit(),
            18 if self.allows(Feature::Tool) => {
                let word = self.tool_word();
                self.push(vec![word]);
            }
            _ if holds => drop(self.attempt(|builder| builder.point_block(Course::Rapid))),
            _ => self.first_point(),
        }
    }

    /// Holes, or a block of other words where none can be.
    fn holes(&mut self) {
        if !self.holes_at_points() {
            self.begin();
            self.beside_points();
        }
    }

    /// A position by both X and Y.
    pub(crate) fn first_point(&mut self) {
        if self.state.incremental {
            let item = self.incremental_word(false);
            self.push(vec![item]);
            self.begin();
        }
        if !self.attempt(|builder| builder.point_block(Course::Both)) {
            self.beside_points();
        }
    }

    /// A block of other words: modes, tools, M codes.
    fn beside_points(&mut self) {
        let mut items = Vec::new();
        self.beside_contour(!self.state.contours.given, &mut items);
        if items.is_empty() {
            items.push(Item::m(65));
        }
        self.push(items);
    }

    /// G50 Z.
    fn shift_of_z(&mut self) {
        let present = self.state.program(Axis::Z);
        let near = present + self.choices.within(-20_000, 20_000) * 1_000;
        let (item, value) = self.length("Z", near);
        self.state.shift[Axis::Z as usize] += present - value;
        self.push(vec![Item::g(50), item]);
    }

    /// Z, or W, in G00 or G01.
    fn along_axis(&mut self) {
        let mut items = Vec::new();
        let linear = self.choices.chance(50) && self.allows(Feature::Linear);
        let mode = if linear { Mode::Linear } else { Mode::Rapid };
        self.select(mode, &mut items);
        if linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        let w = self.state.setup.options.w_axis && self.choices.chance(40);
        self.axis_word(if w { Axis::W } else { Axis::Z }, &mut items);
        self.travelled(from, self.present(), None);
        self.state.after_cutting = linear;
        self.push(items);
    }

    /// A position beyond the positive limit of X, where X is cut back.
    fn beyond_the_limit(&mut self) {
        let Some(limit) = self.state.limits[Axis::X as usize].positive else { return self.along_axis() };
        let beyond = limit.0 - self.state.frame(Axis::X) + self.choices.within(1, 50_000) * 1_000;
        if beyond < 4_000_000 || self.state.sign(Axis::X) < 0 || self.state.incremental {
            return self.along_axis();
        }
        let mut items = Vec::new();
        self.select(Mode::Rapid, &mut items);
        let wanted = [beyond * 3 / 10 + 1_000, -beyond * 4 / 10 - 1_000];
        let (words, point) = self.point_words(wanted, [0, 0], [true, true]);
        items.extend(words);
        self.move_to_point(point);
        self.push(items);
    }

    /// X and Y words toward a point, those that are chosen, counted from `kept` in G91; the point that they lead to.
    pub(crate) fn point_words(
        &mut self,
        wanted: [i64; 2],
        kept: [i64; 2],
        chosen: [bool; 2],
    ) -> (Vec<Item>, [i64; 2]) {
        let (mut items, mut point) = (Vec::new(), kept);
        for (place, address) in ["X", "Y"].into_iter().enumerate() {
            if chosen[place] {
                let origin = if self.state.incremental { kept[place] } else { 0 };
                let (item, length) = self.length(address, wanted[place] - origin);
                items.push(item);
                point[place] = origin + length;
            }
        }
        (items, point)
    }

    /// What a point becomes: program X and C (E100L-CSC-03, E100L-CSC-04).
    pub(crate) fn axes_of_point(&self, point: [i64; 2]) -> (i64, i64) {
        let spot = Spot::of(point);
        let shift = match self.state.setup.parameters.conversion_zero_shift {
            ConversionZeroShift::Included => 0,
            ConversionZeroShift::Excluded => self.state.c_shift,
        };
        let angle = (spot.q.atan2(spot.p).to_degrees() * 1e6).round() as i64;
        let c = self.state.contours.direction.unwrap_or_default() + angle - shift;
        ((spot.radius() * 2.0).round() as i64, c.rem_euclid(360_000_000))
    }

    /// Moves the axes to a point and keeps it.
    pub(crate) fn move_to_point(&mut self, point: [i64; 2]) {
        let from = self.present();
        let x = self.keep_point(point);
        self.state.move_to(Axis::X, x);
        self.travelled(from, self.present(), None);
    }

    /// Turns C to a point and keeps it; the program X where X has to go.
    pub(crate) fn keep_point(&mut self, point: [i64; 2]) -> i64 {
        let (x, c) = self.axes_of_point(point);
        self.state.turn_to(c);
        let c_shift = self.state.c_shift;
        self.state.contours.kept = Some(Kept { point, x, c, c_shift });
        self.state.contours.given = true;
        x
    }

    /// A point of the face.
    pub(crate) fn some_point(&mut self) -> [i64; 2] {
        let (_, high) = self.state.window(Axis::X);
        let most = (high / 3).clamp(4_000_000, 200_000_000);
        let grid = self.choices.pick(&[10_000_000, 1_000_000, 1_000_000, 1_000]);
        [0, 1].map(|_: usize| {
            let coordinate = self.choices.within(-most / grid, most / grid) * grid;
            self.on_grid(coordinate)
        })
    }

    /// The length that a whole number of increments next to this one is.
    pub(crate) fn on_grid(&self, length: i64) -> i64 {
        let number: Number = self.state.units.write_length(length);
        self.state.units.length(Written::Plain(number))
    }
}
