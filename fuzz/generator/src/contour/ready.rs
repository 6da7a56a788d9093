//! What a contour needs of the modes, the way to its start, and what may stand between contours.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::{Builder, Kind};
use crate::companions::has;
use crate::number::Number;
use crate::program::{Item, Value};
use crate::state::{Axis, Mode};

impl Builder<'_, '_, '_> {
    /// Ends what would forbid a contour and begins what it needs, a block at a time; false where that cannot be.
    pub(crate) fn ready_for_contours(&mut self) -> bool {
        let state = &self.state;
        if state.control.steady || state.compensation.is_on() || !self.permits_kind(Kind::CAxis) {
            return false;
        }
        if self.state.compensation.left_over {
            self.line(Mode::Rapid);
            self.begin();
        }
        if self.state.barriers.is_watched() {
            for code in [24, 20] {
                self.state.barriers.note_m(code);
            }
            self.push(vec![Item::m(24), Item::m(20)]);
            self.begin();
        }
        if !self.state.joined {
            self.state.joined = true;
            self.push(vec![Item::m(110)]);
            self.begin();
        }
        let mut items = Vec::new();
        if self.state.clamped {
            self.state.clamped = false;
            items.push(Item::m(146));
        }
        if self.choices.chance(60) || self.state.contours.backward {
            let code = self.choices.within(15, 16);
            self.state.contours.note_m(code);
            items.push(Item::m(code));
        } else {
            items.push(Item::m(15));
        }
        if !self.state.per_minute || !self.state.feed {
            self.state.per_minute = true;
            items.extend([Item::g(94), self.feed_word()]);
        }
        self.push(items);
        self.state.compensation.left_over = false;
        !self.state.barriers.is_watched() || self.choices.chance(2)
    }

    /// Whether the modes still allow a contour.
    pub(super) fn still_ready(&self) -> bool {
        let state = &self.state;
        let compensated = state.compensation.is_on() || state.compensation.left_over;
        state.joined && !state.clamped && state.per_minute && !compensated && !state.control.steady
    }

    /// Words beside a contour, none where they would forbid it. `steady`: they change no frame and no dimension mode.
    pub(super) fn beside_contour(&mut self, steady: bool, items: &mut Vec<Item>) {
        let (state, before) = (self.state.clone(), items.len());
        self.companions(items);
        let same = self.state.offset == state.offset && self.state.incremental == state.incremental;
        let watched = self.state.barriers.is_watched();
        if !self.still_ready() || watched || steady && !same {
            self.state = state;
            items.truncate(before);
        }
        let written = |code: i64| items.iter().any(|item| is_m(item, code));
        if !written(15) && !written(16) && self.choices.chance(12) {
            let code = self.choices.within(15, 16);
            self.state.contours.note_m(code);
            items.push(Item::m(code));
        }
    }

    /// Adds an F word where none was given yet, and sometimes otherwise; the contour is cut.
    pub(crate) fn cut_contour(&mut self, mut items: Vec<Item>) {
        if !has(&items, "F") && self.choices.chance(15) {
            items.push(self.feed_word());
        }
        self.state.after_cutting = true;
        self.push(items);
    }

    /// A positioning to a positive X, with Z and C.
    pub(crate) fn position_for_contour(&mut self) {
        self.begin();
        let mut items = Vec::new();
        let mode = if self.choices.chance(85) { Mode::Rapid } else { Mode::Linear };
        let mode = if self.allows(Feature::Linear) { mode } else { Mode::Rapid };
        self.select(mode, &mut items);
        if mode == Mode::Linear {
            self.feed_if_needed(&mut items);
        }
        let from = self.present();
        let (low, high) = self.state.window(Axis::X);
        let grid = self.choices.pick(&[10_000_000, 1_000_000, 1_000]);
        let wanted = self.choices.within(low.max(4_000_000) / grid, high.max(0) / grid) * grid;
        let (item, x) = self.target(Axis::X, wanted.clamp(low, high));
        items.push(item);
        self.state.move_to(Axis::X, x);
        if self.choices.chance(60) {
            self.axis_word(Axis::Z, &mut items);
        }
        if self.choices.chance(70) && !self.state.clamped && self.state.joined {
            let c = self.some_angle();
            let (item, c) = self.c_word(c);
            items.push(item);
            self.state.turn_to(c);
        }
        self.travelled(from, self.present(), None);
        self.state.after_cutting = mode == Mode::Linear;
        self.push(items);
    }

    /// An angle in [0, 360) degrees, often a round one.
    pub(super) fn some_angle(&mut self) -> i64 {
        let grid = self.choices.weighted(&[(30, 30_000_000), (30, 10_000_000), (20, 1_000_000), (20, 1_000)]);
        self.choices.within(0, 359_999_000 / grid) * grid
    }

    /// A block between contours.
    pub(super) fn between_contours(&mut self) {
        self.begin();
        match self.choices.below(5) {
            0 if self.allows(Feature::Dwell) => self.dwell(),
            1 => self.modes(),
            2 => self.shift(),
            3 if self.allows(Feature::Variable) => self.assignment(),
            _ => self.auxiliary(),
        }
        self.begin();
        if !self.still_ready() && !self.state.control.steady && self.state.joined {
            let mut items = Vec::new();
            if self.state.clamped {
                self.state.clamped = false;
                items.push(Item::m(146));
            }
            if !self.state.per_minute {
                self.state.per_minute = true;
                items.extend([Item::g(94), self.feed_word()]);
            }
            if !items.is_empty() {
                self.push(items);
            }
        }
    }
}

/// Whether it is this M code, as a plain number.
fn is_m(item: &Item, code: i64) -> bool {
    matches!(item, Item::Word(word) if word.address == "M"
        && matches!(&word.value, Value::Plain(number) if *number == Number::whole(code)))
}
