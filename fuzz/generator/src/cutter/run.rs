//! A run of compensation: what it needs, its start-up, its elements, and the block that ends it.

use turnspec_oracle::vocabulary::Feature;

use super::Surface;
use crate::builder::Builder;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::{Axis, Mode};

impl Builder<'_, '_, '_> {
    /// A run of compensation, or a positioning where there can be none.
    pub(crate) fn cutter(&mut self) {
        if self.state.control.has_modes() || !self.ready_for_contours() {
            return self.line(Mode::Rapid);
        }
        let surface =
            self.choices.weighted(&[(36, Surface::Face), (32, Surface::Conversion), (32, Surface::Side)]);
        let blunt =
            surface == Surface::Face && self.state.compensation.radius() == 0 && self.choices.chance(30);
        self.state.cutter = super::Cutter { surface, blunt, ..super::Cutter::default() };
        if !blunt {
            self.take_cutter();
        }
        if !self.position_for_cutter(surface) {
            return;
        }
        let mut open = false;
        for _ in 0..=usize::from(self.choices.chance(25)) {
            let through = surface == Surface::Conversion && self.choices.chance(15);
            let begun = if through { self.centre_line() } else { self.begin_cutter(None) };
            if !begun {
                break;
            }
            if self.state.cutter.blunt {
                self.blunt_ray();
            }
            if !self.cut_elements(through) || self.state.cutter.idle > 1 {
                return self.nothing_more();
            }
            let last = !self.state.control.is_called() && self.choices.chance(8);
            open = last || !self.attempt(|builder| builder.cutter_cancel());
            if open {
                break;
            }
        }
        if open || surface == Surface::Conversion && self.choices.chance(8) {
            // The end of the program ends the compensation, or the conversion mode.
            return self.nothing_more();
        }
        if surface == Surface::Conversion {
            self.end_conversion();
        }
    }

    /// A block with the T word of a cutter.
    fn take_cutter(&mut self) {
        self.begin();
        let mut items = Vec::new();
        items.extend(self.cutter_word(true));
        if items.is_empty() || self.choices.chance(20) {
            items.push(Item::m(8));
        }
        self.push(items);
    }

    /// The way to where compensation may begin; false where there is none.
    fn position_for_cutter(&mut self, surface: Surface) -> bool {
        if surface == Surface::Conversion {
            if !self.begin_conversion() {
                return false;
            }
            for _ in 0..=self.choices.below(2) {
                self.first_point();
            }
            if self.state.kept_point().is_none() {
                self.end_conversion();
                return false;
            }
            return true;
        }
        if self.state.program(Axis::X) < 20_000_000 || self.choices.chance(70) {
            self.position_for_contour();
        }
        self.state.program(Axis::X) > 0
    }

    /// The plane and the block that begins compensation; false where there is none. `wanted`: its sign, and where it leads.
    fn begin_cutter(&mut self, wanted: Option<(i64, Point)>) -> bool {
        let plane = self.state.cutter.surface.code();
        if self.state.plane != plane && self.choices.chance(60) {
            self.begin();
            self.state.plane = plane;
            self.push(vec![Item::g(plane)]);
        }
        let sign = wanted.map_or_else(|| self.choices.pick(&[1, -1]), |(sign, _)| sign);
        let cutter = &mut self.state.cutter;
        (cutter.sign, cutter.last, cutter.idle, cutter.around) = (sign, None, 0, 0.0);
        self.attempt(|builder| builder.cutter_start_up(wanted.map(|(_, point)| point)))
    }

    /// A block that begins compensation.
    fn cutter_start_up(&mut self, wanted: Option<Point>) -> bool {
        let mut items = Vec::new();
        self.beside_cutter(&mut items);
        let plane = self.state.cutter.surface.code();
        if self.state.plane != plane || self.choices.chance(6) {
            items.push(Item::g(plane));
            self.state.plane = plane;
        }
        items.push(Item::g(if self.state.cutter.sign > 0 { 41 } else { 42 }));
        let bare = self.state.compensation.radius() == 0 && !self.state.cutter.blunt;
        if bare && !Self::has_tool(&items) && self.choices.chance(75) {
            items.extend(self.cutter_word(false));
        }
        self.straight_block(wanted, items)
    }

    /// A block that ends compensation.
    fn cutter_cancel(&mut self) -> bool {
        let mut items = Vec::new();
        self.beside_cutter(&mut items);
        items.push(Item::g(40));
        if self.choices.chance(12) {
            let plane = self.choices.pick(&[18, 17, 119]);
            items.push(Item::g(plane));
            self.state.plane = plane;
        }
        self.straight_block(None, items)
    }

    /// A straight motion that is no element.
    fn straight_block(&mut self, wanted: Option<Point>, mut items: Vec<Item>) -> bool {
        let mode = self.straight_mode();
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.cutter_point();
        let still = wanted.is_none() && self.choices.chance(6);
        let wanted = match wanted {
            Some(wanted) => wanted,
            None if still => from,
            None => self.cutter_leg(from),
        };
        let Some(way) = self.way_to(wanted, still) else { return false };
        self.follow(&way);
        items.extend(way.items);
        self.push_straight(mode, items);
        true
    }

    /// A beginning and a line of which the cutter centre leads through the centre of the face, or along a ray; false where there is
    /// none (E100L-CGF-09, E100L-CGF-10, E100L-CGF-11).
    fn centre_line(&mut self) -> bool {
        let radius = self.state.compensation.radius();
        let (_, high) = self.state.window(Axis::X);
        if self.on_grid(radius) != radius || !self.state.fits(Axis::X, 0) || high < 60_000_000 {
            return self.begin_cutter(None);
        }
        let away = self.choices.within(8, 28) * 1_000_000;
        let (sign, way) = (self.choices.pick(&[1, -1]), self.choices.pick(&[1, -1]));
        let start = Point { z: (-way * away) as f64, x: (-sign * way * radius) as f64 };
        if !self.begin_cutter(Some((sign, start))) {
            return self.begin_cutter(None);
        }
        let on = self.choices.pick(&[-1, -1, 2, 4]);
        let end = Point { z: (-way * away / on) as f64, x: start.x };
        self.attempt(|builder| builder.cutter_line_to(end, Vec::new()));
        true
    }

    /// A line without a radius along a ray of the face, and one with a radius: the first ends where it meets the parallel of the
    /// second, on the ray on which it begins but for rounding (E100L-CRC-14).
    fn blunt_ray(&mut self) {
        self.state.cutter.blunt = false;
        let from = self.cutter_point();
        let by = self.choices.pick(&[-1, 1]) * self.choices.within(1, 30) * 500_000;
        let end = self.on_ray(from, by as f64);
        if self.attempt(|builder| builder.cutter_line_to(end, Vec::new())) {
            self.attempt(|builder| {
                let items = builder.cutter_word(false).into_iter().collect();
                let wanted = builder.cutter_leg(builder.cutter_point());
                builder.cutter_line_to(wanted, items)
            });
        }
    }

    /// Elements with what stands between them; false where there is none. `begun`: there may be one already.
    fn cut_elements(&mut self, begun: bool) -> bool {
        let count = self.choices.below(8) + usize::from(!begun);
        for _ in 0..count {
            if !self.is_idle() && self.choices.chance(14) {
                self.between_elements();
            }
            if self.is_idle() && self.allows(Feature::Alarm) && self.choices.chance(1) {
                self.between_elements();
                if self.state.cutter.idle > 1 {
                    return true;
                }
            }
            self.attempt(Self::cutter_element);
        }
        for _ in 0..6 {
            if self.state.cutter.last.is_some() {
                break;
            }
            self.attempt(Self::cutter_element);
        }
        self.state.cutter.last.is_some()
    }
}
