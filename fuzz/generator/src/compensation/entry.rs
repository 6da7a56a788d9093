//! Blocks that begin compensation and blocks that end it.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

use super::Side;
use super::corner::Element;

/// What a block that begins or ends compensation does besides.
#[derive(Clone, Copy)]
enum Motion {
    /// X, Z or both.
    Line,
    /// The present point.
    Repetition,
    /// Nothing.
    None,
    /// C or W.
    Beside,
    /// A line at an angle.
    Taper,
    /// A chamfer or rounding.
    Chamfer,
    /// G50 with axes.
    Shift,
    /// G04.
    Dwell,
}

impl Builder<'_, '_, '_> {
    /// A block that begins compensation.
    pub(crate) fn start_up(&mut self) {
        let side = if self.choices.chance(50) { Side::Right } else { Side::Left };
        self.state.compensation.due = Some(side);
        let motion = self.choices.weighted(&[
            (60, Motion::Line),
            (6, Motion::Repetition),
            (14, Motion::None),
            (4, Motion::Beside),
            (6, Motion::Taper),
            (6, Motion::Chamfer),
        ]);
        self.changing(motion);
    }

    /// A block that ends compensation.
    pub(crate) fn cancel(&mut self) {
        if self.state.compensation.starting {
            return self.contour_line();
        }
        self.state.compensation.due = Some(Side::Off);
        let motion = self.choices.weighted(&[
            (56, Motion::Line),
            (5, Motion::Repetition),
            (16, Motion::None),
            (4, Motion::Beside),
            (5, Motion::Taper),
            (5, Motion::Chamfer),
            (5, Motion::Shift),
            (4, Motion::Dwell),
        ]);
        self.changing(motion);
    }

    /// A block with the code that is due.
    fn changing(&mut self, motion: Motion) {
        match motion {
            Motion::Taper if self.allows(Feature::AnyAngle) => return self.taper(),
            Motion::Chamfer if self.allows(Feature::Chamfer) || self.allows(Feature::Rounding) => {
                return self.chamfer();
            }
            _ => {}
        }
        let ends = self.state.compensation.due == Some(Side::Off);
        let mut items = Vec::new();
        self.companions(&mut items);
        let mode = if self.choices.chance(45) { Mode::Rapid } else { Mode::Linear };
        self.select(mode, &mut items);
        if mode == Mode::Linear && !matches!(motion, Motion::Shift | Motion::Dwell) {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        let mut one_shot = false;
        match motion {
            Motion::None => {}
            Motion::Beside => drop(self.axes_beside(&mut items)),
            Motion::Repetition => self.present_words(&mut items),
            Motion::Shift if self.allows(Feature::ZeroShift) => {
                items.push(Item::g(50));
                self.shift_words(&mut items);
                one_shot = true;
            }
            Motion::Dwell if self.allows(Feature::Dwell) && !super::has(&items, "F") => {
                items.extend([Item::g(4), Item::whole("F", 1)]);
                one_shot = true;
            }
            _ => self.line_words(&mut items),
        }
        if !one_shot && self.choices.chance(22) && self.allows(Feature::Arc) {
            self.imaginary_words(ends, &mut items);
        }
        if ends && (one_shot || !["X", "Z"].iter().any(|axis| super::has(&items, axis))) {
            self.state.compensation.left_over = true;
        } else {
            self.travelled(from, self.present(), None);
            self.state.after_cutting = mode == Mode::Linear;
        }
        self.push(items);
    }

    /// I and K toward an imaginary point.
    fn imaginary_words(&mut self, ends: bool, items: &mut Vec<Item>) {
        let lengths = [(5, 0), (-5, 0), (0, 5), (0, -5), (3, 4), (4, -3), (-12, 5), (-1, -100), (7, 1)];
        let (k, i) = self.choices.pick(&lengths);
        let size = self.choices.pick(&[1_000_000, 200_000, 10_000]);
        let [i, k] = [("I", i), ("K", k)].map(|(address, length)| {
            if length != 0 || self.choices.chance(30) {
                let (item, length) = self.length(address, length * size);
                items.push(item);
                return length;
            }
            0
        });
        let direction = crate::geometry::Point { z: k as f64, x: i as f64 };
        let compensation = &mut self.state.compensation;
        if ends {
            let last = compensation.last.take();
            let fits = compensation.idle > 1 || last.is_none_or(|last| last.meets_line(direction));
            compensation.misfit |= !fits;
        } else {
            let (offset, to_centre) = (compensation.offset(), compensation.to_centre());
            compensation.last = Some(Element::line(direction.times(-1.0), offset, to_centre));
        }
    }

    /// Writes the code that begins compensation, the plane that it needs and a nose.
    pub(super) fn open(&mut self, side: Side, items: &mut Vec<Item>) {
        if self.state.plane != 18 {
            items.push(Item::g(18));
            self.state.plane = 18;
        }
        items.push(Item::g(side as i64));
        if self.state.compensation.radius() == 0 || self.choices.chance(25) {
            items.extend(self.nose_word());
        }
        let compensation = &mut self.state.compensation;
        compensation.side = side;
        compensation.opening = true;
        compensation.last = None;
    }

    /// Compensation ends in the block in progress.
    pub(super) fn close(&mut self) {
        let compensation = &mut self.state.compensation;
        compensation.side = Side::Off;
        compensation.starting = false;
        compensation.left_over = compensation.radius() != 0;
    }

    /// A plane of rotary tools, or that of the lathe.
    pub(crate) fn plane(&mut self) {
        let plane = self.choices.pick(&[17, 119, 18]);
        self.state.plane = plane;
        let mut items = vec![Item::g(plane)];
        if self.choices.chance(40) {
            self.select(Mode::Rapid, &mut items);
            self.axis_word(Axis::Z, &mut items);
            self.state.compensation.left_over = false;
            self.state.after_cutting = false;
        }
        self.push(items);
    }
}
