//! Chuck and tailstock barriers: their areas, which of them are on, and blocks beside them.

use turnspec_oracle::vocabulary::{BarrierPath, Barriers, Feature, Length, Setup};

use crate::builder::Builder;
use crate::choices::Choices;
use crate::expression::Variable;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::{Axis, Mode};

const MM: i64 = 1_000_000;

/// The codes that switch a barrier on and off.
const CODES: [(i64, i64); 2] = [(25, 24), (21, 20)];

/// A rectangle of Z and X, X as a diameter, in nanometres; its edge does not belong to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Area {
    z: (i64, i64),
    x: (i64, i64),
}

impl Area {
    fn is_empty(&self) -> bool {
        self.z.0 >= self.z.1 || self.x.0 >= self.x.1
    }

    /// Whether a straight way, its ends included, has a point inside.
    fn is_crossed(&self, from: (i64, i64), to: (i64, i64)) -> bool {
        let apart = |a: i64, b: i64, (low, high): (i64, i64)| a.max(b) <= low || a.min(b) >= high;
        if self.is_empty() || apart(from.0, to.0, self.z) || apart(from.1, to.1, self.x) {
            return false;
        }
        let way = (i128::from(to.0 - from.0), i128::from(to.1 - from.1));
        let side = |z: i64, x: i64| way.0 * i128::from(x - from.1) - way.1 * i128::from(z - from.0);
        let sides = [self.z.0, self.z.1].map(|z| [side(z, self.x.0), side(z, self.x.1)]);
        let (least, most) = sides
            .iter()
            .flatten()
            .fold((0, 0), |(least, most): (i128, i128), side| (least.min(*side), most.max(*side)));
        from == to || least < 0 && most > 0
    }
}

/// What the generator believes of the barriers.
#[derive(Clone, Debug)]
pub struct Areas {
    /// The data that are in force.
    pub(crate) data: Barriers,
    /// Whether chuck and tailstock are watched.
    on: [bool; 2],
    /// Whether they were at the beginning of the block.
    before: [bool; 2],
    path: BarrierPath,
}

impl Areas {
    /// Both barriers off, with the data of a set-up.
    #[must_use]
    pub fn new(setup: &Setup) -> Self {
        Self { data: setup.barriers, on: [false; 2], before: [false; 2], path: setup.readings.barrier_path }
    }

    /// Whether the program is to have barriers.
    pub(crate) fn is_wanted(&self) -> bool {
        self.data != Barriers::default()
    }

    /// Whether a motion of the present block is tested.
    pub(crate) fn is_watched(&self) -> bool {
        self.on.iter().chain(&self.before).any(|on| *on)
    }

    /// The barrier of a code is in force from this block on until the one of the other code.
    pub(crate) fn begin_block(&mut self) {
        self.before = self.on;
    }

    /// Notes an M code.
    pub(crate) fn note_m(&mut self, code: i64) {
        for (on, (code_on, code_off)) in self.on.iter_mut().zip(CODES) {
            if code == code_on || code == code_off {
                *on = code == code_on;
            }
        }
    }

    /// The rectangles of chuck and tailstock.
    fn rectangles(&self) -> [Vec<Area>; 2] {
        let data = &self.data;
        let front = data.chuck_z.0;
        let grip = data.grip_length.0.max(data.jaw_length.0);
        let c = data.chuck_x.0.abs();
        let mut chuck = Vec::new();
        if data.grip_length.0 > 0 {
            chuck.extend(both_sides((front - grip, front), c, c + 2 * data.grip_height.0));
        }
        let jaw = (front - data.jaw_length.0, front - data.grip_length.0);
        chuck.extend(both_sides(jaw, c, c + 2 * data.jaw_height.0));
        let begin = data.workpiece_end.0;
        let middle = begin + data.front_length.0;
        let rear = middle + data.middle_length.0;
        let end = rear + data.rear_length.0;
        let mut tailstock = Vec::new();
        let steps = [
            (begin, data.front_length.0, data.front_diameter.0.max(data.centre_diameter.0)),
            (middle, data.middle_length.0, data.middle_diameter.0),
            (rear, data.rear_length.0, data.rear_diameter.0),
        ];
        for (begin, length, diameter) in steps {
            if length > 0 {
                tailstock.push(Area { z: (begin, end), x: (-diameter, diameter) });
            }
        }
        [chuck, tailstock].map(|areas| areas.into_iter().filter(|area| !area.is_empty()).collect())
    }

    /// The rectangles that are watched.
    fn watched(&self) -> Vec<Area> {
        let [chuck, tailstock] = self.rectangles();
        let is_on = |place: usize| self.on[place] || self.before[place];
        let lists = [(is_on(0), chuck), (is_on(1), tailstock)];
        lists.into_iter().filter(|(on, _)| *on).flat_map(|(_, areas)| areas).collect()
    }

    /// Whether a way meets an area that is watched.
    fn are_met(&self, from: Point, to: Point, centre: Option<(Point, Mode)>, mode: Mode) -> bool {
        let place = |point: Point| (point.coordinate(), point.diameter());
        let areas = self.watched();
        let ends_only = mode == Mode::Rapid && self.path == BarrierPath::Ends;
        let meets = |from: Point, to: Point| areas.iter().any(|area| area.is_crossed(place(from), place(to)));
        match centre {
            None if ends_only => meets(to, to),
            None => meets(from, to),
            Some((centre, sense)) => {
                meets(from, from)
                    || meets(to, to)
                    || chords(from, to, centre, sense).any(|(a, b)| meets(a, b))
            }
        }
    }
}

/// A rectangle and its image on the other side of the axis.
fn both_sides(z: (i64, i64), inner: i64, outer: i64) -> Vec<Area> {
    if inner == 0 {
        return vec![Area { z, x: (-outer, outer) }];
    }
    vec![Area { z, x: (inner, outer) }, Area { z, x: (-outer, -inner) }]
}

/// Short chords along an arc.
fn chords(from: Point, to: Point, centre: Point, sense: Mode) -> impl Iterator<Item = (Point, Point)> {
    const PARTS: i32 = 90;
    let (spoke, last) = (from.minus(centre), to.minus(centre));
    let counter = sense == Mode::CounterClockwise;
    let turn = if counter { last.angle() - spoke.angle() } else { spoke.angle() - last.angle() };
    let part = turn.rem_euclid(360.0) / f64::from(PARTS) * if counter { 1.0 } else { -1.0 };
    let radius = spoke.length();
    let point = move |place: i32| {
        let angle = spoke.angle() + part * f64::from(place);
        centre.plus(Point::direction((angle * 1e6) as i64).times(radius))
    };
    (0..PARTS).map(move |place| (point(place), point(place + 1)))
}

/// Data of chuck and tailstock that leave most of the room free.
pub(crate) fn barriers(choices: &mut Choices<'_, '_>) -> Barriers {
    let mut data = Barriers::default();
    let grid = choices.pick(&[1_000_000, 1_000]);
    let mut length = |low: i64, high: i64| {
        let (low, high) = (low * MM / grid, high * MM / grid);
        Length(choices.within(low, high) * grid)
    };
    data.jaw_length = length(20, 80);
    data.jaw_height = length(10, 60);
    data.grip_length = length(5, 40);
    data.grip_height = length(3, 30);
    data.chuck_x = length(-60, 120);
    data.chuck_z = length(-160, -40);
    data.rear_length = length(30, 100);
    data.rear_diameter = length(20, 120);
    data.middle_length = length(10, 60);
    data.middle_diameter = length(5, 60);
    data.front_length = length(5, 40);
    data.front_diameter = length(3, 40);
    data.centre_diameter = length(1, 40);
    data.workpiece_end = length(40, 150);
    if choices.chance(25) {
        std::mem::swap(&mut data.front_diameter, &mut data.rear_diameter);
    }
    let sizes: [&mut Length; 9] = [
        &mut data.jaw_length,
        &mut data.jaw_height,
        &mut data.grip_length,
        &mut data.grip_height,
        &mut data.chuck_x,
        &mut data.front_length,
        &mut data.front_diameter,
        &mut data.middle_diameter,
        &mut data.rear_length,
    ];
    for size in sizes {
        if choices.chance(8) {
            *size = Length(0);
        }
    }
    data
}

impl Builder<'_, '_, '_> {
    /// Notes a way of the programmed point; one into an area that is watched does not fit.
    pub(crate) fn watch(&mut self, from: Point, to: Point, centre: Option<(Point, Mode)>) {
        if self.state.barriers.is_watched() && self.state.barriers.are_met(from, to, centre, self.state.mode)
        {
            self.state.compensation.does_not_fit();
        }
    }

    /// Whether the present point lies in an area that is watched or would be.
    fn is_inside(&self, barrier: usize) -> bool {
        let point = (self.state.program(Axis::Z), self.state.program(Axis::X));
        self.state.barriers.rectangles()[barrier].iter().any(|area| area.is_crossed(point, point))
    }

    /// Switches a barrier off in which the present point lies.
    pub(crate) fn clear_of_barriers(&mut self) {
        for (place, (_, off)) in CODES.into_iter().enumerate() {
            if self.state.barriers.on[place] && self.is_inside(place) && self.choices.chance(90) {
                self.state.barriers.note_m(off);
                self.push(vec![Item::m(off)]);
                self.begin();
            }
        }
    }

    /// Switches a barrier, changes its data, or goes to the edge of one.
    pub(crate) fn barrier(&mut self) {
        let barriers = &self.state.barriers;
        let off: Vec<usize> =
            (0..2).filter(|place| !barriers.on[*place] && !self.is_inside(*place)).collect();
        if self.state.control.steady || off.is_empty() && self.choices.chance(80) {
            return self.edge();
        }
        match self.choices.below(10) {
            0..=4 if !off.is_empty() => {
                let place = off[self.choices.below(off.len())];
                self.fitting(|builder| builder.switch(CODES[place].0));
            }
            5 => {
                let place = self.choices.below(2);
                self.fitting(|builder| builder.switch(CODES[place].1));
            }
            6 if !self.state.is_eia() && self.allows(Feature::SystemVariable) => {
                let item = self.barrier_variable();
                self.push(vec![item]);
            }
            _ => self.edge(),
        }
    }

    /// Switches barriers on at the beginning of a program, where the tool stands outside.
    pub(crate) fn guarded(&mut self) -> bool {
        self.begin();
        let place = self.choices.below(2);
        let both = self.choices.chance(50);
        for place in [place, 1 - place].into_iter().take(1 + usize::from(both)) {
            if !self.is_inside(place) {
                self.fitting(|builder| builder.switch(CODES[place].0));
                self.begin();
            }
        }
        true
    }

    /// A block with a code of a barrier, often with a motion.
    fn switch(&mut self, code: i64) {
        let mut items = vec![Item::m(code)];
        self.state.barriers.note_m(code);
        let other = CODES.iter().find(|(on, off)| ![*on, *off].contains(&code));
        if let Some((on, off)) = other
            && self.choices.chance(15)
        {
            let inside = self.is_inside(usize::from(code == 25 || code == 24));
            let second = if self.choices.chance(50) && !inside { *on } else { *off };
            self.state.barriers.note_m(second);
            items.push(Item::m(second));
        }
        if self.choices.chance(35) && self.allows(Feature::Rapid) {
            self.select(Mode::Rapid, &mut items);
            let from = self.present();
            self.line_words(&mut items);
            self.travelled_by(&items, from);
            self.state.after_cutting = false;
        }
        self.push(items);
    }

    /// An assignment to one of the data.
    pub(crate) fn barrier_variable(&mut self) -> Item {
        let (name, low, high) = self.choices.pick(&[
            ("VCHKL", 0, 40),
            ("VCHKD", 0, 30),
            ("VTSL", 0, 40),
            ("VTSDA", 0, 40),
            ("VTSDB", 0, 40),
            ("VCHKX", -60, 120),
            ("VCHKZ", -160, -40),
            ("VWKR", 40, 150),
        ]);
        let (item, value) = self.assign_length(Variable::System(name), low * 1_000, high * 1_000);
        let data = &mut self.state.barriers.data;
        let field = match name {
            "VCHKL" => &mut data.grip_length,
            "VCHKD" => &mut data.grip_height,
            "VTSL" => &mut data.front_length,
            "VTSDA" => &mut data.front_diameter,
            "VTSDB" => &mut data.centre_diameter,
            "VCHKX" => &mut data.chuck_x,
            "VCHKZ" => &mut data.chuck_z,
            _ => &mut data.workpiece_end,
        };
        *field = Length(value);
        item
    }

    /// A motion to the edge of an area, or one increment beside it.
    fn edge(&mut self) {
        let [chuck, tailstock] = self.state.barriers.rectangles();
        let areas: Vec<Area> = chuck.into_iter().chain(tailstock).collect();
        if areas.is_empty() {
            return self.line(Mode::Rapid);
        }
        let area = areas[self.choices.below(areas.len())];
        let finest = self.state.units.finest();
        let along = |choices: &mut Choices<'_, '_>, (low, high): (i64, i64)| match choices.below(6) {
            0 => low,
            1 => high,
            2 => low - finest,
            3 => high + finest,
            _ => choices.within(low / 1_000, high / 1_000) * 1_000,
        };
        let (z, x) = (along(self.choices, area.z), along(self.choices, area.x));
        if self.choices.chance(25) && self.allows(Feature::Arc) && self.allows(Feature::Feed) {
            return self.touching_arc(area);
        }
        let linear = self.choices.chance(50) && self.allows(Feature::Linear) && self.allows(Feature::Feed);
        let mode = if linear || !self.allows(Feature::Rapid) { Mode::Linear } else { Mode::Rapid };
        let mut items = Vec::new();
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        let both = self.choices.weighted(&[(60, (true, true)), (20, (true, false)), (20, (false, true))]);
        for (axis, wanted, chosen) in [(Axis::X, x, both.0), (Axis::Z, z, both.1)] {
            if chosen && self.state.fits(axis, wanted) {
                let origin = if self.state.incremental { self.state.program(axis) } else { 0 };
                let (item, length) = self.plain_length(axis.address(), wanted - origin);
                items.push(item);
                self.state.move_to(axis, origin + length);
            }
        }
        self.travelled(from, self.present(), None);
        self.state.after_cutting = mode == Mode::Linear;
        self.push(items);
    }

    /// A half circle that bulges to the edge of an area, an increment short of it or beyond; the way there first.
    fn touching_arc(&mut self, area: Area) {
        let finest = self.state.units.finest();
        let radius = self.choices.within(2, 20) * 1_000 * finest;
        let short = self.choices.pick(&[0, 0, 1, -1]) * finest;
        let upper = self.choices.chance(70);
        // From above the area the circle bulges down to its outer edge, or from the front to it.
        let (start, end, centre, sense) = if upper {
            let middle = (area.z.0 + area.z.1) / 2 / finest * finest;
            let x = area.x.1 + 2 * (radius + short);
            let sense = Mode::Clockwise;
            ((middle + radius, x), (middle - radius, x), ("K", -radius), sense)
        } else {
            let middle = (area.x.0 + area.x.1) / 2 / (2 * finest) * (2 * finest);
            let z = area.z.1 + radius + short;
            ((z, middle + 2 * radius), (z, middle - 2 * radius), ("I", -radius), Mode::CounterClockwise)
        };
        let fits = |place: (i64, i64)| self.state.fits(Axis::Z, place.0) && self.state.fits(Axis::X, place.1);
        if !fits(start) || !fits(end) || self.state.compensation.is_on() {
            return self.line(Mode::Rapid);
        }
        let expressions = std::mem::take(&mut self.expressions);
        let mut items = vec![self.incremental_word(false)];
        self.select(if self.allows(Feature::Rapid) { Mode::Rapid } else { Mode::Linear }, &mut items);
        self.feed_if_needed(&mut items);
        self.go(start, &mut items, None);
        self.push(items);
        self.begin();
        let mut items = Vec::new();
        self.select(sense, &mut items);
        let (address, offset) = centre;
        let (item, offset) = self.plain_length(address, offset);
        let spoke =
            if upper { Point { z: offset as f64, x: 0.0 } } else { Point { z: 0.0, x: offset as f64 } };
        let centre = self.present().plus(spoke);
        self.go(end, &mut items, Some((centre, sense)));
        items.push(item);
        self.expressions = expressions;
        self.state.after_cutting = true;
        self.push(items);
    }

    /// Words of X and Z to a point (Z, X).
    fn go(&mut self, (z, x): (i64, i64), items: &mut Vec<Item>, centre: Option<(Point, Mode)>) {
        let from = self.present();
        for (axis, wanted) in [(Axis::X, x), (Axis::Z, z)] {
            let (item, target) = self.target(axis, wanted);
            items.push(item);
            self.state.move_to(axis, target);
        }
        self.travelled(from, self.present(), centre);
    }

    /// Data of a jaw beside the present point; false where they cannot be written.
    pub(crate) fn jaw_beside(&mut self) -> bool {
        if self.state.is_eia() || !self.allows(Feature::SystemVariable) {
            return false;
        }
        let x = self.state.program(Axis::X).abs() / 1_000;
        let z = self.state.program(Axis::Z) / 1_000;
        let mut items = Vec::new();
        for (name, value) in [("VCHKL", 20_000), ("VCHKD", 15_000), ("VCHKX", x), ("VCHKZ", z - 5_000)] {
            let (item, value) = self.assign_length(Variable::System(name), value, value);
            let data = &mut self.state.barriers.data;
            let field = match name {
                "VCHKL" => &mut data.grip_length,
                "VCHKD" => &mut data.grip_height,
                "VCHKX" => &mut data.chuck_x,
                _ => &mut data.chuck_z,
            };
            *field = Length(value);
            items.push(item);
        }
        self.push(items);
        self.begin();
        true
    }

    /// Switches barriers on and moves into one, by an increment or far, straight, along an arc, by a torque skip.
    pub(crate) fn enter_barrier(&mut self) -> bool {
        let lists = self.state.barriers.rectangles();
        let places: Vec<usize> = (0..2).filter(|place| !lists[*place].is_empty()).collect();
        if places.is_empty() {
            return false;
        }
        let place = places[self.choices.below(places.len())];
        let area = lists[place][self.choices.below(lists[place].len())];
        let (code, _) = CODES[place];
        let finest = 2 * self.state.units.finest();
        let inside = |choices: &mut Choices<'_, '_>, (low, high): (i64, i64)| match choices.below(3) {
            0 => low + finest,
            1 => high - finest,
            _ => low + (high - low) / 2,
        };
        let (mut z, x) = (inside(self.choices, area.z), inside(self.choices, area.x));
        let expressions = std::mem::take(&mut self.expressions);
        let free = !self.state.barriers.is_watched() && !self.state.compensation.is_on();
        if free && self.choices.chance(60) {
            let beyond = self.approach(&area, x, lists[1 - place].first());
            z = beyond.filter(|_| self.choices.chance(25)).unwrap_or(z);
        }
        self.state.barriers.note_m(code);
        let beside = self.choices.chance(30);
        if !beside {
            self.push(vec![Item::m(code)]);
            self.begin();
        }
        let mut items = vec![self.incremental_word(false)];
        let skip = self.choices.chance(15) && self.allows(Feature::Torque) && !self.state.is_eia();
        let mode = self.choices.pick(&[Mode::Rapid, Mode::Linear, Mode::Clockwise]);
        self.select(if skip { Mode::Rapid } else { mode }, &mut items);
        self.feed_if_needed(&mut items);
        let start = if skip { (area.z.1 + 5 * MM, x) } else { (z, x) };
        if beside {
            items.push(Item::m(code));
        }
        self.go(start, &mut items, None);
        if mode == Mode::Clockwise && !skip {
            items.push(self.plain_length("L", 400 * MM).0);
        }
        self.push(items);
        if skip {
            let (z, d, l) = (z, MM, 2 * MM);
            let target = self.plain_length("Z", z).0;
            let (d, l) = (self.plain_length("D", d).0, self.plain_length("L", l).0);
            self.push(vec![Item::g(22), target, d, l, Item::whole("F", 1), Item::whole("PZ", 50)]);
        }
        self.expressions = expressions;
        true
    }

    /// The way to a point beside an area at this X, or into one of the other barrier, which is switched on there;
    /// in the first case Z on the other side of the area.
    fn approach(&mut self, area: &Area, x: i64, other: Option<&Area>) -> Option<i64> {
        let mut items = vec![self.incremental_word(false)];
        self.select(Mode::Rapid, &mut items);
        let other = other.filter(|_| self.choices.chance(40));
        let (before, behind) = (area.z.0 - 5 * MM, area.z.1 + 5 * MM);
        let (near, far) = if area.z.0 > 0 { (before, behind) } else { (behind, before) };
        let middle = |area: &Area| ((area.z.0 + area.z.1) / 2, (area.x.0 + area.x.1) / 2);
        let point = other.map_or((near, x), middle);
        self.go(point, &mut items, None);
        self.push(items);
        self.begin();
        if other.is_some() {
            for (code, _) in CODES {
                self.state.barriers.note_m(code);
            }
            self.push(CODES.map(|(code, _)| Item::m(code)).to_vec());
            self.begin();
            return None;
        }
        Some(far)
    }
}
