//! Radius compensation: what the generator believes of it, and which blocks it writes while it is in force.
//!
//! A program comes into compensation and out of it by blocks of [`entry`]; between them the blocks of the other
//! kinds go on, with elements of [`contour`] that meet the one before in a chosen way. A block whose corner
//! would not exist, or whose tip would lie beyond a limit, is taken back and another one is written.

mod contour;
pub(crate) mod corner;
mod entry;
mod nose;

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::{Feature, Setup};

use crate::builder::{Builder, Kind};
use crate::companions::has;
use crate::geometry::Point;
use crate::program::Item;
use crate::state::{Axis, Mode, State};
use corner::{Element, meeting};
pub(crate) use nose::nose_radii;

/// The code of the compensation group that is in force.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Side {
    /// G40.
    #[default]
    Off = 40,
    /// G41.
    Left = 41,
    /// G42.
    Right = 42,
}

impl Side {
    /// 1 with the tool on the left, -1 on the right, 0 without compensation.
    fn sign(self) -> f64 {
        match self {
            Self::Off => 0.0,
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// The other side.
    fn other(self) -> Self {
        match self {
            Self::Off => Self::Off,
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// What the generator believes of compensation.
#[derive(Clone, Default, Debug)]
pub struct Compensation {
    /// The code in force.
    pub side: Side,
    /// Whether a displacement may be left over.
    pub left_over: bool,
    /// The nose radius table, X and Z in nanometres.
    pub radii: BTreeMap<u8, [i64; 2]>,
    /// Active nose radius number.
    pub nose: u8,
    /// A code of the group that the next block of companions has to write.
    due: Option<Side>,
    /// Whether the motion that comes is a start-up.
    opening: bool,
    /// Whether a start-up waits for its element.
    starting: bool,
    /// Blocks without X/Z motion since the last one with it.
    idle: usize,
    /// The last element, or the imaginary line of the start-up.
    last: Option<Element>,
    /// Whether the block in progress has no corner, or a tip beyond a limit.
    misfit: bool,
}

impl Compensation {
    /// G40, with the nose radius table of a set-up.
    #[must_use]
    pub fn new(setup: &Setup) -> Self {
        let radii = setup.nose_radius.iter().map(|each| (each.number, [each.x.0, each.z.0])).collect();
        Self { radii, ..Self::default() }
    }

    /// Whether G41 or G42 is in force.
    #[must_use]
    pub fn is_on(&self) -> bool {
        self.side != Side::Off
    }

    /// Whether the program must not end here: a start-up has no element yet.
    #[must_use]
    pub fn has_to_go_on(&self) -> bool {
        self.starting
    }

    /// The amounts of the active nose, X and Z in nanometres.
    fn amounts(&self) -> [i64; 2] {
        self.radii.get(&self.nose).copied().unwrap_or_default()
    }

    /// The radius of the active nose in nanometres.
    #[must_use]
    pub fn radius(&self) -> i64 {
        let [x, z] = self.amounts();
        x.abs().max(z.abs())
    }

    /// How far along Z the tip is from the programmed point at the end of a line along Z, in nanometres.
    #[must_use]
    pub fn tip_aside(&self) -> i64 {
        -self.amounts()[1]
    }

    /// How far the nose centre lies to the left of an element.
    fn offset(&self) -> f64 {
        self.side.sign() * self.radius() as f64
    }

    /// The way from the tip to the nose centre.
    fn to_centre(&self) -> Point {
        let [x, z] = self.amounts();
        Point { z: z as f64, x: x as f64 }
    }

    /// Notes that the block in progress leads where it must not.
    pub fn does_not_fit(&mut self) {
        self.misfit = true;
    }

    /// Counts blocks without X/Z motion that a program which was called has.
    pub fn pass(&mut self, blocks: usize) {
        self.idle += blocks;
    }

    /// Counts a block that was written.
    pub fn note_block(&mut self, items: &[Item]) {
        self.idle = if ["X", "Z", "A"].iter().any(|axis| has(items, axis)) { 0 } else { self.idle + 1 };
    }
}

/// Kinds of blocks in compensation.
const KINDS: &[(usize, Kind)] = &[
    (24, Kind::ContourLine),
    (24, Kind::ContourArc),
    (5, Kind::Rapid),
    (8, Kind::Linear),
    (5, Kind::Arc),
    (4, Kind::Taper),
    (6, Kind::Chamfer),
    (4, Kind::Repetition),
    (5, Kind::Auxiliary),
    (3, Kind::Modes),
    (2, Kind::Dwell),
    (2, Kind::Shift),
    (1, Kind::Torque),
    (4, Kind::Assignment),
    (3, Kind::Idle),
    (3, Kind::Filler),
    (2, Kind::Turret),
    (9, Kind::Cancel),
];

/// Kinds that give an element.
const ELEMENTS: &[(usize, Kind)] = &[
    (10, Kind::ContourLine),
    (8, Kind::ContourArc),
    (3, Kind::Linear),
    (2, Kind::Arc),
    (1, Kind::Taper),
    (2, Kind::Chamfer),
];

/// How often a block is written anew when it does not fit.
const ATTEMPTS: usize = 8;

impl Builder<'_, '_, '_> {
    /// The kind of the next block while compensation is in force.
    pub(crate) fn compensated_kind(&mut self) -> Kind {
        let Self { choices, profile, state, control, .. } = &mut *self;
        let permits = |state: &State, kind| {
            state.control.permits(kind) && state.turrets.permits(kind, state.control.steady)
        };
        // A start-up bears one block without X/Z motion.
        let bound = state.compensation.starting && (state.compensation.idle > 0 || choices.chance(80));
        let list = if bound { ELEMENTS } else { KINDS };
        let control = if bound { 0 } else { *control / 3 };
        let io = if bound || !state.io.is_wanted() { 0 } else { 10 };
        let list = list.iter().copied().chain([(control, Kind::Control), (io, Kind::Io)]);
        let list: Vec<_> =
            list.filter(|(_, kind)| kind.is_within(profile) && permits(state, *kind)).collect();
        if list.iter().all(|(weight, _)| *weight == 0) { Kind::Rapid } else { choices.weighted(&list) }
    }

    /// Writes a block that fits, if one is found; one that does not is seldom let stand.
    pub(crate) fn fitting(&mut self, write: impl Fn(&mut Self)) {
        for _ in 0..ATTEMPTS {
            let (state, lines) = (self.state.clone(), self.lines.len());
            self.state.compensation.misfit = false;
            write(self);
            if !self.state.compensation.misfit || self.choices.chance(2) {
                return;
            }
            self.state = state;
            self.lines.truncate(lines);
        }
    }

    /// The code of the group that is due, with what may stand beside it.
    pub(crate) fn due_compensation(&mut self, items: &mut Vec<Item>) {
        let Some(side) = self.state.compensation.due.take() else { return };
        if side == Side::Off {
            items.push(Item::g(40));
            self.close();
        } else {
            self.open(side, items);
        }
    }

    /// A side, the present one or the other, in a block of compensation.
    pub(crate) fn side_word(&mut self, items: &mut Vec<Item>) {
        let compensation = &mut self.state.compensation;
        if self.choices.chance(70) {
            compensation.side = compensation.side.other();
        }
        items.push(Item::g(compensation.side as i64));
    }

    /// Notes a motion of X and Z, straight or about a centre.
    pub(crate) fn travelled(&mut self, from: Point, to: Point, centre: Option<(Point, Mode)>) {
        self.state.control.note_way([to.diameter(), to.coordinate()]);
        self.watch(from, to, centre);
        let compensation = &mut self.state.compensation;
        if !compensation.is_on() {
            compensation.left_over = false;
            return;
        }
        if std::mem::take(&mut compensation.opening) {
            compensation.starting = true;
            compensation.idle = 0;
            return;
        }
        compensation.idle = 0;
        if from == to {
            compensation.misfit |= compensation.starting;
            return;
        }
        let element = Element::new(from, to, centre, compensation.offset(), compensation.to_centre());
        let corner = match &compensation.last {
            Some(last) => meeting(last, &element),
            None => Some(element.contact_at_beginning()),
        };
        let to_centre = compensation.last.as_ref().map_or(compensation.to_centre(), |last| last.to_centre);
        compensation.starting = false;
        let fits = !element.is_too_small()
            && corner.is_some_and(|corner| self.point_fits(from.plus(corner).minus(to_centre)))
            && self.point_fits(to.plus(element.contact_at_end()).minus(element.to_centre));
        self.state.compensation.misfit |= !fits;
        self.state.compensation.last = Some(element);
    }

    /// Notes a motion from a point to where the axes are, if its block has words of X or Z.
    pub(crate) fn travelled_by(&mut self, items: &[Item], from: Point) {
        if ["X", "Z", "A"].iter().any(|axis| has(items, axis)) {
            self.travelled(from, self.present(), None);
        }
    }

    /// A block that names the present point.
    pub(crate) fn repetition(&mut self) {
        let mut items = Vec::new();
        self.companions(&mut items);
        let mode = if self.choices.chance(30) { Mode::Rapid } else { Mode::Linear };
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        self.present_words(&mut items);
        self.travelled(from, self.present(), None);
        self.state.after_cutting = mode == Mode::Linear;
        self.push(items);
    }

    /// Words that lead to the present point.
    fn present_words(&mut self, items: &mut Vec<Item>) {
        let x = self.choices.chance(60);
        for (axis, chosen) in [(Axis::X, x), (Axis::Z, !x || self.choices.chance(40))] {
            if chosen {
                let (item, target) = self.target(axis, self.state.program(axis));
                items.push(item);
                self.state.move_to(axis, target);
            }
        }
    }

    /// A block that moves C or W alone, or has a code of the group alone.
    pub(crate) fn idle(&mut self) {
        let mut items = Vec::new();
        let arc = !matches!(self.state.mode, Mode::Rapid | Mode::Linear);
        if arc || self.choices.chance(30) || !self.axes_beside(&mut items) {
            self.side_word(&mut items);
        }
        self.push(items);
    }

    /// Words of C or W alone, where there are such axes.
    fn axes_beside(&mut self, items: &mut Vec<Item>) -> bool {
        let steady = self.state.control.steady;
        let c = self.state.joined && !self.state.clamped && self.allows(Feature::CAxis) && !steady;
        let w = self.state.setup.options.w_axis && !steady;
        if w && !(c && self.choices.chance(50)) {
            self.axis_word(Axis::W, items);
        } else if c {
            self.c_words(items);
        }
        w || c
    }
}
