//! Calls of a definition: G85 with G84, G86, G87, G88.

use turnspec_oracle::vocabulary::{BalancedInfeed, Feature};

use super::place::Place;
use super::plan::{Kind, Plan};
use crate::builder::Builder;
use crate::program::{Block, Item, Line, Statement};
use crate::state::Axis;

const MM: i64 = 1_000_000;

/// A call by its code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Call {
    Bar = 85,
    Copy = 86,
    Finish = 87,
    Thread = 88,
}

impl Call {
    /// One call of a definition, or several.
    pub fn draw(builder: &mut Builder<'_, '_, '_>, plan: &Plan) -> Vec<Self> {
        let rough: &[(usize, Self)] = match plan.kind {
            Kind::Thread => &[(1, Self::Thread)],
            Kind::Turning => &[(55, Self::Bar), (30, Self::Copy), (15, Self::Finish)],
        };
        let mut calls = vec![builder.choices.weighted(rough)];
        while calls.len() < 4 && builder.choices.chance(25) {
            calls.push(builder.choices.weighted(rough));
        }
        if plan.kind == Kind::Turning && calls[0] != Self::Finish && builder.choices.chance(30) {
            calls.push(Self::Finish);
        }
        calls
    }
}

impl Builder<'_, '_, '_> {
    /// The way to the AP start, and a call. `again`: another one has been before it.
    pub(super) fn lap_call(&mut self, call: Call, again: bool, name: &str, plan: &Plan, place: &Place) {
        let stays = again && self.choices.chance(40);
        if !stays {
            self.position(place.point(place.start));
        }
        self.begin();
        let mut items = Vec::new();
        let mut returns = true;
        match call {
            Call::Bar | Call::Copy => {
                self.depth_and_feed(call, plan, place, &mut items);
                self.allowances(call, plan, place, &mut items);
                if self.choices.chance(10) && self.allows(Feature::Aux) {
                    items.push(Item::m(85));
                    returns = false;
                }
            }
            Call::Finish => {
                self.allowances(call, plan, place, &mut items);
                returns = false;
            }
            Call::Thread => self.heights_of_call(plan, &mut items),
        }
        if self.choices.chance(10) {
            self.choices.shuffle(&mut items);
        }
        let delete = self.deletable();
        let sequence = self.own_call_name();
        let statement = Some(Statement::Lap(call as i64, name.to_owned()));
        self.lines.push(Line::Block(Block { delete, sequence, statement, items }));
        self.state.after_cutting = false;
        if !returns {
            self.come_back(place);
        }
    }

    fn own_call_name(&mut self) -> Option<String> {
        let named = self.choices.chance(10);
        named.then(|| self.sequence_name()).flatten()
    }

    /// A positioning from a place that is not known.
    fn come_back(&mut self, place: &Place) {
        let wanted = place.point(place.start);
        self.begin_ahead();
        let mut items = Vec::new();
        self.select(crate::state::Mode::Rapid, &mut items);
        let from = self.present();
        for (axis, wanted) in [Axis::X, Axis::Z].into_iter().zip(wanted) {
            let (item, target) = self.coordinate(axis, wanted, 0);
            items.push(item);
            self.state.move_to(axis, target);
        }
        self.travelled(from, self.present(), None);
        self.push(items);
    }

    /// D and F, and what G84 changes.
    fn depth_and_feed(&mut self, call: Call, plan: &Plan, place: &Place, items: &mut Vec<Item>) {
        let (low, _) = plan.extent(0);
        let whole = place.start[0] - low.min(0);
        let most = if plan.blank.is_some() && call == Call::Copy { 8 } else { 14 };
        let parts = self.choices.within(1, most);
        let step = match self.choices.below(10) {
            0 => place.start[0],
            1 => whole * 2,
            _ => whole / parts + self.choices.within(0, 20) * 1_000,
        };
        let step = step.max(whole / 20).max(100_000);
        self.amount("D", step, items);
        if self.choices.chance(85) {
            items.push(self.feed_word());
        }
        if call == Call::Bar && self.choices.chance(25) && !self.state.is_eia() {
            self.change_points(step, plan, place, items);
        }
    }

    /// G84 with one point or two.
    fn change_points(&mut self, step: i64, plan: &Plan, place: &Place, items: &mut Vec<Item>) {
        let (a, b) = if plan.across {
            (["ZA", "DA", "FA"], ["ZB", "DB", "FB"])
        } else {
            (["XA", "DA", "FA"], ["XB", "DB", "FB"])
        };
        items.push(Item::g(84));
        let second = self.choices.chance(50);
        // Often on levels of passes.
        let on_level = self.choices.chance(50);
        for (names, tenths, passes, wanted) in [(a, 7, 1, true), (b, 3, 3, second)] {
            if !wanted {
                continue;
            }
            let height = if on_level { place.start[0] - passes * step } else { place.start[0] * tenths / 10 };
            // A point that is not given changes nothing, whatever words of it there are.
            if !self.choices.chance(8) {
                items.push(self.length(names[0], place.level(height)).0);
            }
            if self.choices.chance(60) {
                let other = self.choices.pick(&[step / 2, step * 2, step * 3 / 4]);
                items.push(self.length(names[1], other.max(100_000)).0);
            }
            if self.choices.chance(50) {
                items.push(self.feed_of_call(names[2]));
            }
        }
    }

    fn feed_of_call(&mut self, address: &'static str) -> Item {
        let (feed, threads) = (self.state.feed, self.state.threads.clone());
        let item = self.contour_feed_word(address);
        (self.state.feed, self.state.threads) = (feed, threads);
        item
    }

    /// U and W, smaller than what is cut.
    fn allowances(&mut self, call: Call, plan: &Plan, place: &Place, items: &mut Vec<Item>) {
        let clearance = i64::from(self.state.setup.parameters.lap_clearance) * 1_000;
        for address in ["U", "W"] {
            let infeed = (address == "U") != plan.across;
            if !self.choices.chance(40) {
                continue;
            }
            let wanted = self.choices.pick(&[200_000, 500_000, 100_000, 0, 1_000, MM]);
            let most = match (call, infeed) {
                (_, true) => place.start[0] - 1_000,
                // From the start itself no side can be told.
                (Call::Finish, false) if place.start[1] == 0 => 0,
                (Call::Copy, false) if plan.blank.is_some() => clearance,
                _ => MM,
            };
            self.amount(address, wanted.min(most), items);
        }
    }

    /// D, H, B, the allowance and M codes of G88.
    fn heights_of_call(&mut self, plan: &Plan, items: &mut Vec<Item>) {
        let height = self.choices.within(5, 30) * 100_000;
        let allowance = self.choices.pick(&[0, 0, 100_000, 200_000]);
        let parts = self.choices.within(1, 6);
        self.amount("D", ((height - allowance) / parts).max(50_000), items);
        self.amount("H", height, items);
        if self.choices.chance(60) {
            let angle = self.choices.pick(&[60_000_000, 55_000_000, 0, 30_000_000, 90_000_000]);
            items.push(self.angle("B", angle).0);
        }
        if allowance > 0 {
            self.amount(if plan.across { "W" } else { "U" }, allowance, items);
        }
        if !self.allows(Feature::Aux) {
            return;
        }
        if self.choices.chance(50) {
            let code = self.choices.pick(&[32, 33, 34]);
            self.state.threads.note_m(code);
            items.push(Item::m(code));
        }
        let refused = self.state.setup.readings.balanced_infeed == BalancedInfeed::Refused;
        if self.choices.chance(60) || refused && self.state.threads.is_balanced() {
            let codes: &[i64] =
                if refused && !self.choices.chance(5) { &[73, 74] } else { &[73, 74, 74, 75] };
            let code = self.choices.pick(codes);
            self.state.threads.note_m(code);
            items.push(Item::m(code));
        }
    }
}
