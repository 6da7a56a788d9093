//! Chamfers and roundings, G75 and G76, with the blocks that they look ahead to; blocks with A alone.

use turnspec_oracle::vocabulary::{ChamferLeg, Chamfering, Feature, IncrementalAfterChamfer};

use crate::builder::Builder;
use crate::geometry::{Point, meeting_of};
use crate::program::Item;
use crate::state::{Axis, Mode};

/// How a line of a contour is written, and where it ends.
struct Leg {
    words: Vec<Item>,
    /// The end as it is programmed: the corner.
    corner: Point,
    /// Whether it is a block with A alone.
    open: bool,
}

impl Builder<'_, '_, '_> {
    /// A chamfer or rounding with its following line, as the set-up has it.
    pub(crate) fn chamfer(&mut self) {
        match self.state.setup.parameters.chamfering {
            Chamfering::Off => self.line(Mode::Linear),
            Chamfering::Basic => self.basic_chamfer(),
            Chamfering::AnyAngle => self.contour(),
        }
    }

    /// The code of a chamfer block, and G01 where it is needed.
    fn chamfer_codes(&mut self, items: &mut Vec<Item>) -> bool {
        let rounding = match (self.allows(Feature::Chamfer), self.allows(Feature::Rounding)) {
            (true, false) => false,
            (false, true) => true,
            _ => self.choices.chance(50),
        };
        self.select(Mode::Linear, items);
        items.insert(0, Item::g(if rounding { 76 } else { 75 }));
        self.feed_if_needed(items);
        rounding
    }

    /// Chamfers between lines along the axes, one axis after the other.
    fn basic_chamfer(&mut self) {
        let mut axis = if self.choices.chance(50) { Axis::X } else { Axis::Z };
        let mut base: Option<[i64; 2]> = None;
        let mut direction = if self.choices.chance(50) { 1 } else { -1 };
        for _ in 0..=self.choices.below(3) {
            let mut items = Vec::new();
            if base.is_none() {
                self.companions(&mut items);
            }
            let other = if axis == Axis::X { Axis::Z } else { Axis::X };
            let (radius, other_radius) = (i64::from(axis == Axis::X) + 1, i64::from(other == Axis::X) + 1);
            let present = self.state.program(axis);
            let travel = self.choices.within(4_000, 40_000) * 1_000;
            let origin = base.map_or(present, |base| base[axis as usize]);
            let (item, target) = self.coordinate(axis, present + direction * travel * radius, origin);
            // Inches are rounded, so that nothing fits exactly there.
            let fits = !self.state.units.system.is_inch() && self.choices.chance(8);
            let size = if fits { travel } else { self.choices.within(100, travel * 2 / 5_000) * 1_000 };
            let sign = if self.choices.chance(50) { 1 } else { -1 };
            let (length_item, length) = self.length("L", sign * size);
            let beside = self.state.program(other) + length * other_radius;
            if !self.state.fits(axis, target) || !self.state.fits(other, beside) {
                break;
            }
            items.extend([item, length_item]);
            self.chamfer_codes(&mut items);
            let from = self.present();
            let mut corner = [self.state.program(Axis::X), self.state.program(Axis::Z)];
            corner[axis as usize] = target;
            self.state.move_to(axis, target);
            self.state.move_to(other, beside);
            self.note_leg(from, Point::of(corner[0], corner[1]));
            self.push(items);
            let end = [self.state.program(Axis::X), self.state.program(Axis::Z)];
            let from_corner =
                self.state.setup.readings.incremental_after_chamfer == IncrementalAfterChamfer::Corner;
            base = Some(if from_corner { corner } else { end });
            (axis, direction) = (other, sign);
            self.begin();
        }
        // What an arc is counted from does not depend on the corner.
        if !self.state.incremental && base.is_some() && self.choices.chance(30) {
            return self.arc();
        }
        self.line_after_basic(axis, direction, base);
        self.state.after_cutting = true;
    }

    /// The line that follows a basic chamfer: along the other axis, on in the direction of the chamfer.
    fn line_after_basic(&mut self, axis: Axis, direction: i64, base: Option<[i64; 2]>) {
        let mut items = Vec::new();
        let travel = self.choices.within(1_000, 40_000) * 1_000 * direction;
        let present = self.state.program(axis);
        let (low, high) = self.state.window(axis);
        let wanted = (present + travel).clamp(low, high);
        let (item, target) = self.coordinate(axis, wanted, base.map_or(present, |base| base[axis as usize]));
        self.select(Mode::Linear, &mut items);
        self.feed_if_needed(&mut items);
        items.push(item);
        let from = self.present();
        self.state.move_to(axis, target);
        self.travelled(from, self.present(), None);
        self.push(items);
    }

    /// Notes a line to a corner and what cuts the corner, whose direction lies between those of its lines.
    fn note_leg(&mut self, from: Point, corner: Point) {
        self.travelled(from, corner, None);
        self.travelled(corner, self.present(), None);
    }

    /// A contour of lines at any angle with chamfers, roundings or open corners between them.
    fn contour(&mut self) {
        let mut first = Vec::new();
        self.companions(&mut first);
        let start = self.present();
        let legs = self.legs(start);
        let (mut base, mut free) = (start, f64::INFINITY);
        let mode = Mode::Linear;
        for (place, leg) in legs.iter().enumerate() {
            let mut items = if place == 0 { std::mem::take(&mut first) } else { Vec::new() };
            items.extend(leg.words.iter().cloned());
            if let Some(next) = legs.get(place + 1) {
                let (arriving, leaving) = (leg.corner.minus(base), next.corner.minus(leg.corner));
                let room = 0.4 * arriving.length().min(leaving.length()).min(free);
                if leg.open && self.choices.chance(40) {
                    self.select(mode, &mut items);
                    self.feed_if_needed(&mut items);
                } else {
                    let rounding = self.chamfer_codes(&mut items);
                    let size = self.corner_size(room, arriving.turn(leaving), rounding);
                    items.push(size);
                }
                free = leaving.length();
            } else {
                self.select(mode, &mut items);
                self.feed_if_needed(&mut items);
            }
            self.push(items);
            if place == 0 {
                self.begin_ahead();
            }
            self.travelled(base, leg.corner, None);
            base = leg.corner;
        }
        self.state.move_to(Axis::X, base.diameter());
        self.state.move_to(Axis::Z, base.coordinate());
        self.state.after_cutting = true;
    }

    /// The lines of a contour: one to four, consecutive ones at an angle; the last one is not open.
    fn legs(&mut self, start: Point) -> Vec<Leg> {
        let mut legs: Vec<Leg> = Vec::new();
        let (mut base, mut direction) = (start, None::<Point>);
        let count = 2 + self.choices.below(3);
        let mut attempts = 0;
        while legs.len() < count && attempts < 20 {
            attempts += 1;
            let wanted = self.somewhere_near(base);
            let incremental = self.state.incremental;
            let turned = !legs.is_empty() && self.choices.chance(6);
            let mode = turned.then(|| self.incremental_word(!incremental));
            let known = legs.len();
            if legs.len() + 2 <= count
                && self.choices.chance(20)
                && let Some((first, second)) = self.open_pair(base, wanted)
                && bends(direction, first.corner.minus(base))
            {
                direction = Some(second.corner.minus(first.corner));
                base = second.corner;
                legs.extend([first, second]);
            } else if let Some((words, corner)) = self.closed_leg(base, wanted)
                && corner.minus(base).length() >= 1e6
                && bends(direction, corner.minus(base))
            {
                direction = Some(corner.minus(base));
                base = corner;
                legs.push(Leg { words, corner, open: false });
            }
            match (legs.get_mut(known), mode) {
                (Some(leg), mode) => leg.words.splice(0..0, mode).for_each(drop),
                (None, _) => self.state.incremental = incremental,
            }
        }
        if legs.is_empty() {
            let mut words = Vec::new();
            self.line_words(&mut words);
            legs.push(Leg { words, corner: self.present(), open: false });
        }
        legs
    }

    fn closed_leg(&mut self, base: Point, wanted: Point) -> Option<(Vec<Item>, Point)> {
        if self.choices.chance(30) {
            return self.inclined(base, wanted);
        }
        if self.choices.chance(25) {
            let (axis, along) = if self.choices.chance(50) {
                (Axis::X, Point { x: wanted.x, ..base })
            } else {
                (Axis::Z, Point { z: wanted.z, ..base })
            };
            let (coordinate, origin) = if axis == Axis::X {
                (along.diameter(), base.diameter())
            } else {
                (along.coordinate(), base.coordinate())
            };
            let (item, reached) = self.coordinate(axis, coordinate, origin);
            let end = if axis == Axis::X {
                Point { x: reached as f64 / 2.0, ..base }
            } else {
                Point { z: reached as f64, ..base }
            };
            return self.point_fits(end).then(|| (vec![item], end));
        }
        self.straight(base, wanted)
    }

    /// A block with A alone and the block with A, X and Z after it (E100L-ANG-06).
    fn open_pair(&mut self, base: Point, corner: Point) -> Option<(Leg, Leg)> {
        let wanted = self.somewhere_near(corner);
        let (first, second) = (corner.minus(base).milli(), wanted.minus(corner).milli());
        let (mut words, end) = self.straight(base, wanted)?;
        let corner = meeting_of(base, first, end, second)?;
        let (arriving, leaving) = (corner.minus(base), end.minus(corner));
        if !bends(Some(arriving), leaving)
            || !self.point_fits(corner)
            || arriving.length() < 1e6
            || leaving.length() < 1e6
        {
            return None;
        }
        words.push(self.inclination(second));
        let open = Leg { words: vec![self.inclination(first)], corner, open: true };
        Some((open, Leg { words, corner: end, open: false }))
    }

    /// L of a chamfer or rounding that takes at most `room` of either line, which meet at a turn in degrees.
    fn corner_size(&mut self, room: f64, turn: f64, rounding: bool) -> Item {
        let half = (turn / 2.0).to_radians();
        let most = match (rounding, self.state.setup.readings.chamfer_leg) {
            (true, _) => room / half.tan(),
            (false, ChamferLeg::Leg) => room,
            (false, ChamferLeg::Face) => room * 2.0 * half.cos(),
        };
        let most = (most.min(1e9) as i64 / 1_000).max(1);
        let size = self.choices.within(most / 10 + 1, most.max(most / 10 + 1)) * 1_000;
        let sign = if self.choices.chance(10) { -1 } else { 1 };
        self.length("L", sign * size).0
    }
}

/// Whether a line turns well from the one before it: neither straight on nor back.
fn bends(before: Option<Point>, travel: Point) -> bool {
    before.is_none_or(|before| (8.0..150.0).contains(&before.turn(travel)))
}
