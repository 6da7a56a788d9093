//! Lengths of G34 and G35 with A alone, and behind lines with A alone (E100L-ANG-06).

use turnspec_oracle::vocabulary::{Chamfering, Feature};

use crate::builder::Builder;
use crate::geometry::{Point, meeting_of};
use crate::program::Item;
use crate::state::{Axis, Mode};

use super::leg::is_length;

/// The shortest travel along the lead axis, in nanometres.
const LEAST: f64 = 1_000.0;

/// One of the two blocks of a pair.
struct Half {
    mode: Mode,
    along_x: bool,
    /// The lead, in nanometres; none of a line.
    lead: Option<f64>,
    items: Vec<Item>,
}

impl Builder<'_, '_, '_> {
    /// Whether a block may have A alone.
    pub(crate) fn may_be_open(&self) -> bool {
        let any_angle = self.state.setup.parameters.chamfering == Chamfering::AnyAngle;
        any_angle && self.allows(Feature::AnyAngle)
    }

    /// A block with A alone and the block with A, X and Z behind it, at least one of them a length of thread.
    pub(super) fn open_lengths(&mut self) -> bool {
        let begins = !(is_length(self.state.mode) && self.state.threads.chain);
        let mut items = Vec::new();
        self.beside_thread(&mut items);
        let length = self.choices.chance(65);
        let mut first = self.half(length, items);
        let base = self.present();
        let corner = self.point_of_length(base, first.along_x);
        let along_x = self.choices.chance(20);
        let goal = self.point_of_length(corner, along_x);
        let angles = [corner.minus(base).milli(), goal.minus(corner).milli()];
        first.items.push(self.inclination(angles[0]));
        self.beside_length(&mut first, corner.minus(base), begins);
        self.begin_ahead();
        let mut items = Vec::new();
        self.beside_cut(false, &mut items);
        let length = !length || self.choices.chance(65);
        let mut second = self.half(length, items);
        let Some((words, end)) = self.straight(base, goal) else { return false };
        second.items.extend(words);
        second.items.push(self.inclination(angles[1]));
        let Some(corner) = meeting_of(base, angles[0], end, angles[1]) else { return false };
        self.beside_length(&mut second, end.minus(corner), !is_length(first.mode));
        let travels = self.travels(&first, base, corner) && self.travels(&second, corner, end);
        if !travels || !self.point_fits(corner) {
            return false;
        }
        self.state.mode = first.mode;
        self.travelled(base, corner, None);
        self.push(first.items);
        self.state.mode = second.mode;
        self.travelled(corner, end, None);
        self.state.move_to(Axis::X, end.diameter());
        self.state.move_to(Axis::Z, end.coordinate());
        self.state.threads.chain |= is_length(second.mode);
        self.state.after_cutting = second.mode != Mode::Rapid;
        self.push(second.items);
        true
    }

    /// A block with its mode and its lead: a length of thread or a line.
    fn half(&mut self, length: bool, items: Vec<Item>) -> Half {
        let mut half = Half { mode: self.state.mode, along_x: false, lead: None, items };
        half.mode = if length {
            self.choices.pick(&[Mode::GrowingThread, Mode::ShrinkingThread])
        } else {
            self.choices.pick(&[Mode::Linear, Mode::Linear, Mode::Rapid])
        };
        self.select(half.mode, &mut half.items);
        if length {
            half.along_x = self.lead_axis(&mut half.items);
            half.lead = Some(self.lead_words(&mut half.items));
        } else if half.mode == Mode::Linear {
            self.feed_if_needed(&mut half.items);
        }
        half
    }

    /// A point at some distance along the lead axis, and aside.
    fn point_of_length(&mut self, from: Point, along_x: bool) -> Point {
        let (x, z) = (from.diameter(), from.coordinate());
        let most = |lead: bool| if lead { 50_000_000 } else { 20_000_000 };
        let least = |lead: bool| if lead { 1_000_000 } else { 0 };
        let x = self.coordinate_from(Axis::X, x, least(along_x), most(along_x));
        let z = self.coordinate_from(Axis::Z, z, least(!along_x), most(!along_x));
        Point::of(x, z)
    }

    /// E and C of a length of thread; its chain begins with it.
    fn beside_length(&mut self, half: &mut Half, way: Point, begins: bool) {
        let Some(lead) = half.lead else { return };
        let length = self.length_of_way(half.along_x, way);
        if self.choices.chance(30) && length >= LEAST {
            let sign = if half.mode == Mode::GrowingThread { 1.0 } else { -1.0 };
            self.change_word(lead, length, Some(sign), &mut half.items);
        }
        if self.choices.chance(if begins { 35 } else { 12 }) {
            self.start_angle(&mut half.items);
        }
    }

    fn length_of_way(&self, along_x: bool, way: Point) -> f64 {
        let along = if along_x { way.diameter() } else { way.coordinate() };
        self.state.along(along_x, 0, along)
    }

    /// Whether a block has a way, and a length of thread one along its lead.
    fn travels(&self, half: &Half, from: Point, to: Point) -> bool {
        let way = to.minus(from);
        let along = self.length_of_way(half.along_x, way);
        way.length() >= LEAST && (half.lead.is_none() || along >= LEAST)
    }
}
