//! The blocks of a definition.

use turnspec_oracle::vocabulary::Feature;

use super::place::Place;
use super::plan::{Element, Form, Kind, Outline, Plan};
use crate::builder::Builder;
use crate::geometry::Point;
use crate::program::{Block, Item, Line, Word};
use crate::state::{Axis, Mode};

/// How a definition is written.
struct Writing<'w> {
    plan: &'w Plan,
    place: &'w Place,
    /// Whether G87 will carry it out.
    finished: bool,
    /// Program coordinates X and Z that were reached.
    at: [i64; 2],
    /// Where the block before begins, and the angle of this one in micro-degrees, if that one has A alone.
    open: Option<([i64; 2], i64)>,
}

impl Builder<'_, '_, '_> {
    /// A definition with this name.
    pub(super) fn definition(&mut self, name: &str, plan: &Plan, place: &Place, finished: bool) {
        let mut writing = Writing { plan, place, finished, at: [0, 0], open: None };
        let head = Item::g(if plan.across { 82 } else { 81 });
        let mut name = Some(name.to_owned());
        if let Some(blank) = &plan.blank {
            self.contour_block(name.take(), vec![Item::g(83)]);
            self.outline(&mut writing, blank, true);
            name = self.own_name();
        }
        self.contour_block(name, vec![head]);
        self.outline(&mut writing, &plan.contour, false);
    }

    /// A sequence name now and then.
    fn own_name(&mut self) -> Option<String> {
        let named = self.choices.chance(8);
        named.then(|| self.sequence_name()).flatten()
    }

    /// A block of a definition.
    fn contour_block(&mut self, sequence: Option<String>, mut items: Vec<Item>) {
        if items.len() > 1 && self.choices.chance(10) {
            self.choices.shuffle(&mut items);
        }
        self.lines.push(Line::Block(Block { sequence, items, ..Block::default() }));
        self.begin_ahead();
    }

    /// The first motion, the elements, and G80 behind a contour.
    fn outline(&mut self, writing: &mut Writing<'_>, outline: &Outline, blank: bool) {
        self.begin_ahead();
        let mut items = Vec::new();
        let outer = self.state.incremental;
        let absolute = self.allows(Feature::Absolute) && self.choices.chance(15);
        if outer || absolute {
            items.push(self.incremental_word(false));
        }
        self.state.mode = if writing.plan.linear { Mode::Linear } else { Mode::Rapid };
        items.push(Item::g(self.state.mode as i64));
        let [x, z] = writing.place.point(outline.first);
        for (axis, wanted) in [(Axis::X, x), (Axis::Z, z)] {
            let (item, reached) = self.coordinate(axis, wanted, 0);
            items.push(item);
            writing.at[axis as usize] = reached;
        }
        if writing.plan.nose.is_some() && !blank {
            let usual = if writing.place.keeps_sense() { 41 } else { 42 };
            let side = if self.choices.chance(90) { usual } else { 83 - usual };
            items.push(Item::g(side));
        }
        self.contour_block(None, items);
        for (number, element) in outline.elements.iter().enumerate() {
            let mut items = Vec::new();
            if self.choices.chance(6) && self.allows(Feature::Incremental) && self.allows(Feature::Absolute) {
                items.push(self.incremental_word(!self.state.incremental));
            }
            if writing.plan.kind == Kind::Thread {
                let next = outline.elements.get(number + 1);
                self.leg_of_contour(writing, element, next, number == 0, &mut items);
            } else {
                self.element_of_contour(writing, element, blank, &mut items);
            }
            if !blank
                && number + 1 == outline.elements.len()
                && writing.plan.nose.is_none()
                && self.choices.chance(30)
            {
                items.push(Item::g(80));
                return self.contour_block(None, items);
            }
            let name = self.own_name();
            self.contour_block(name, items);
        }
        if self.state.incremental {
            let word = self.incremental_word(false);
            if blank {
                // A blank ends before the next contour begins in G90.
                self.state.incremental = true;
            } else {
                self.contour_block(None, vec![word]);
            }
        }
        if !blank {
            self.end_of_contour(writing, outline);
        }
    }

    /// G40 in compensation, and G80.
    fn end_of_contour(&mut self, writing: &mut Writing<'_>, outline: &Outline) {
        if writing.plan.nose.is_some() {
            let [height, run] = outline.end();
            let mut items = vec![Item::g(40)];
            let aside = if self.choices.chance(50) { 0 } else { 1_000_000 };
            let goal = [height + 20_000_000, run + aside];
            self.axes_of_contour(writing, goal, false, &mut items);
            self.contour_block(None, items);
        }
        self.contour_block(None, vec![Item::g(80)]);
    }

    /// Words X and Z to a height and a run: both, or those that differ from the place reached.
    fn axes_of_contour(
        &mut self,
        writing: &mut Writing<'_>,
        to: [i64; 2],
        both: bool,
        items: &mut Vec<Item>,
    ) {
        let point = writing.place.point(to);
        for axis in [Axis::X, Axis::Z] {
            let (wanted, from) = (point[axis as usize], writing.at[axis as usize]);
            if both || (wanted - from).abs() >= self.state.units.finest() {
                let (item, reached) = self.coordinate(axis, wanted, from);
                items.push(item);
                writing.at[axis as usize] = reached;
            }
        }
    }

    /// An element with what may stand beside it.
    fn element_of_contour(
        &mut self,
        writing: &mut Writing<'_>,
        element: &Element,
        blank: bool,
        items: &mut Vec<Item>,
    ) {
        let same = writing.place.keeps_sense();
        let mode = match element.form {
            Form::Line | Form::Corner { .. } => Mode::Linear,
            Form::Quarter { clockwise, .. } | Form::Bow { clockwise, .. } if clockwise == same => {
                Mode::Clockwise
            }
            _ => Mode::CounterClockwise,
        };
        self.select(mode, items);
        // A radius needs both coordinates (E100L-CIRC-14).
        let by_radius = matches!(element.form, Form::Bow { .. } | Form::Quarter { .. });
        self.axes_of_contour(writing, element.to, by_radius, items);
        let inch = self.state.units.system.is_inch();
        match element.form {
            Form::Line => {}
            Form::Quarter { centre, .. } if !inch && self.choices.chance(75) => {
                let [sigma, gamma] = writing.place.senses;
                let along = [sigma * centre[0], gamma * centre[1]];
                let [i, k] = if writing.plan.across { [along[1], along[0]] } else { along };
                for (address, amount) in [("I", i), ("K", k)] {
                    if amount != 0 || self.choices.chance(40) {
                        items.push(self.plain_length(address, amount).0);
                    }
                }
            }
            Form::Quarter { centre, .. } => {
                let radius = centre[0].abs().max(centre[1].abs());
                // Two increments more where lengths are cut.
                let radius = if inch { radius + 2 * self.state.units.finest() } else { radius };
                items.push(self.plain_length("L", radius).0);
            }
            Form::Bow { radius, .. } => items.push(self.plain_length("L", radius).0),
            Form::Corner { code, leg } => {
                items.push(Item::g(code));
                items.push(self.plain_length("L", leg).0);
            }
        }
        self.beside_element(writing, blank, items);
    }

    /// E, F and S beside an element.
    fn beside_element(&mut self, writing: &Writing<'_>, blank: bool, items: &mut Vec<Item>) {
        let (feed, threads) = (self.state.feed, self.state.threads.clone());
        if self.choices.chance(if blank { 4 } else { 18 }) {
            items.push(self.contour_feed_word("E"));
        }
        if self.choices.chance(10) {
            items.push(self.contour_feed_word("F"));
        }
        self.state.feed = feed;
        self.state.threads = threads;
        if writing.finished && self.choices.chance(4) && self.allows(Feature::Spindle) {
            let speed = self.spindle_speed();
            items.push(speed);
        }
    }

    /// A feed with an address.
    pub(super) fn contour_feed_word(&mut self, address: &'static str) -> Item {
        match self.feed_word() {
            Item::Word(word) => Item::Word(Word { address, ..word }),
            other => other,
        }
    }

    /// A leg of a thread, or a line among them.
    fn leg_of_contour(
        &mut self,
        writing: &mut Writing<'_>,
        element: &Element,
        next: Option<&Element>,
        first: bool,
        items: &mut Vec<Item>,
    ) {
        let mode = if first { Mode::GrowingThread } else { self.leg_mode() };
        self.select(mode, items);
        self.target_of_leg(writing, element, next, items);
        if mode != Mode::Linear && writing.plan.across && self.allows(Feature::Aux) {
            // The lead along X.
            items.push(Item::m(27));
        }
        let (feed, threads) = (self.state.feed, self.state.threads.clone());
        if first || self.choices.chance(20) {
            items.push(self.feed_word());
        }
        self.state.feed = feed;
        self.state.threads = threads;
        if mode == Mode::GrowingThread {
            if self.choices.chance(15) {
                items.push(self.length("E", 10_000).0);
            }
            if self.choices.chance(12) && self.allows(Feature::CAxis) {
                let start = self.choices.within(0, 35) * 10_000_000;
                items.push(self.angle("C", start).0);
            }
        }
        if mode != Mode::Linear && self.choices.chance(10) {
            let starts = self.choices.within(1, 4);
            items.push(Item::whole("J", starts));
        }
    }

    /// Words of the end of a leg: A alone now and then, with A, X and Z in the block behind it (E100L-ANG-06).
    fn target_of_leg(
        &mut self,
        writing: &mut Writing<'_>,
        element: &Element,
        next: Option<&Element>,
        items: &mut Vec<Item>,
    ) {
        if let Some((from, angle)) = writing.open.take() {
            writing.at = from;
            self.axes_of_contour(writing, element.to, true, items);
            items.push(self.inclination(angle));
            return;
        }
        let at = |[x, z]: [i64; 2]| Point::of(x, z);
        let (from, corner) = (at(writing.at), at(writing.place.point(element.to)));
        if let Some(next) = next
            && self.may_be_open()
            && self.choices.chance(30)
        {
            let end = at(writing.place.point(next.to));
            let [first, second] = [corner.minus(from), end.minus(corner)].map(Point::milli);
            if Point::direction(first).cross(Point::direction(second)).abs() > 0.03 {
                items.push(self.inclination(first));
                writing.open = Some((writing.at, second));
                return;
            }
        }
        self.axes_of_contour(writing, element.to, false, items);
    }

    fn leg_mode(&mut self) -> Mode {
        self.choices.weighted(&[(6, Mode::GrowingThread), (2, Mode::ShrinkingThread), (2, Mode::Linear)])
    }
}
