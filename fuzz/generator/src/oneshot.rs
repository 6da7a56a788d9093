//! Blocks of one-shot codes without a motion of lines and arcs: dwell, zero shift, speed clamp, torque.

use turnspec_oracle::vocabulary::{Feature, Length};

use crate::builder::Builder;
use crate::number::Number;
use crate::program::{Item, Value, Word};
use crate::state::Axis;

impl Builder<'_, '_, '_> {
    /// G04 (E100L-DWELL-01).
    pub(crate) fn dwell(&mut self) {
        let unit = self.state.units.dwell_unit();
        let hundredths = self.choices.pick(&[1, 50, 100, 150, 1_000, 12_345, 999_999]);
        let number = match unit {
            1 => Number::whole(hundredths),
            10 => Number::decimal(hundredths, 1),
            _ => Number::decimal(hundredths, 2),
        };
        let (value, _) = self.value(number);
        let mut items = vec![Item::g(4), Item::Word(Word { address: "F", value })];
        if self.choices.chance(15) {
            self.m_words(&mut items, 2);
        }
        self.push(items);
    }

    /// G50 with axes, with S, or with both (E100L-G50-01, E100L-SMAX-01).
    pub(crate) fn shift(&mut self) {
        let mut items = vec![Item::g(50)];
        let frame = self.allows(Feature::ZeroShift) && !self.state.compensation.is_on();
        let clamp = self.choices.chance(40) && self.allows(Feature::Spindle) || !frame;
        if clamp {
            let speed = self.choices.pick(&[1_500, 3_000, 100, 0, 65_535]);
            items.push(self.whole("S", speed));
            self.state.threads.note_clamp(speed);
        }
        if !clamp || self.choices.chance(30) && frame {
            self.shift_words(&mut items);
        }
        self.push(items);
    }

    /// Words of a zero shift, one at least.
    pub(crate) fn shift_words(&mut self, items: &mut Vec<Item>) {
        let before = items.len();
        let w = self.state.setup.options.w_axis && self.choices.chance(30);
        let chosen = [(Axis::X, self.choices.chance(60)), (Axis::Z, self.choices.chance(60)), (Axis::W, w)];
        for (axis, _) in chosen.into_iter().filter(|(_, chosen)| *chosen) {
            let present = self.state.program(axis);
            let near = present + self.choices.within(-20_000, 20_000) * 1_000;
            let (item, value) = self.length(axis.address(), near);
            self.state.shift[axis as usize] += present - value;
            items.push(item);
        }
        if items.len() == before || self.choices.chance(20) {
            let wanted = self.choices.within(-359, 359) * 1_000_000;
            let (item, angle) = self.angle("C", wanted);
            self.state.c_shift += self.state.program_c() - angle;
            items.push(item);
        }
    }

    /// G29, G28 or G22.
    pub(crate) fn torque(&mut self) {
        match self.choices.below(4) {
            0 => self.push(vec![Item::g(28)]),
            1 if !self.state.is_eia() => {
                let most = i64::from(self.state.setup.parameters.torque_limit_upper);
                let mut items = vec![Item::g(29)];
                let w = self.state.setup.options.w_axis && self.choices.chance(50);
                if !w || self.choices.chance(30) {
                    let percent = self.choices.within(1, most);
                    items.push(self.whole("PZ", percent));
                }
                if w {
                    let percent = self.choices.within(1, most);
                    items.push(self.whole("PW", percent));
                }
                self.push(items);
            }
            _ if self.torque_skip(Stop::Between) => {}
            _ => self.push(vec![Item::g(28)]),
        }
    }

    /// G22 with a torque stop where it is wanted; false when it cannot be written here.
    pub(crate) fn torque_skip(&mut self, stop: Stop) -> bool {
        let delayed = self.state.setup.parameters.torque_monitor_delay > 0;
        let compensation = &self.state.compensation;
        let refused = compensation.is_on() || compensation.left_over;
        if self.state.is_eia() || refused || delayed && (stop == Stop::Early || !self.state.per_minute) {
            return false;
        }
        let w = self.state.setup.options.w_axis && self.choices.chance(40);
        let axis = if w { Axis::W } else { Axis::Z };
        let start = self.state.program(axis);
        let (low, high) = self.state.window(axis);
        let up = start < (low + high) / 2;
        let (direction, room) = if up { (1, high - start) } else { (-1, start - low) };
        if room < 8_000_000 {
            return false;
        }
        let travel = self.choices.within(4_000, room / 2_000) * 1_000;
        let (target_item, target) = self.target(axis, start + direction * travel);
        let approach = self.choices.within(500, travel / 2_000) * 1_000;
        let (approach_item, approach) = self.length("D", approach);
        let beyond = self.choices.within(500, (room - travel).min(20_000_000) / 2_000) * 1_000;
        let (beyond_item, beyond) = self.length("L", beyond);
        let (p1, p2) = (target - direction * approach, target + direction * beyond);
        let place = match stop {
            Stop::Between => p1 + direction * self.choices.within(1, (approach + beyond) / 1_000) * 1_000,
            Stop::Early => start + direction * self.choices.within(1, (travel - approach) / 2_000) * 1_000,
            Stop::Never => p2 + direction * self.choices.within(1, 5_000) * 1_000,
        };
        let place = place + self.state.frame(axis);
        self.state.setup.inputs.torque_stops.push(Length(place));
        self.state.machine[axis as usize] = place;
        let percent = self.choices.within(1, 100);
        let preset = self.whole(if w { "PW" } else { "PZ" }, percent);
        let feed = self.slow_feed();
        self.push(vec![Item::g(22), target_item, approach_item, beyond_item, feed, preset]);
        self.state.threads.end_chain();
        self.state.after_cutting = true;
        true
    }

    /// An F word of at most 2 500 mm/min.
    fn slow_feed(&mut self) -> Item {
        self.state.feed = true;
        let (amount, unit) = if self.state.per_minute {
            (self.choices.within(100, 2_400) * 1_000_000, self.state.units.minute_unit())
        } else {
            (self.choices.within(100, 1_000) * 1_000, self.state.units.length_unit())
        };
        self.state.threads.note_feed(!self.state.per_minute, amount as f64);
        let number = Number::decimal(amount * 1_000 / unit, 3);
        Item::Word(Word { address: "F", value: Value::Plain(number) })
    }
}

/// Where the torque of a G22 block reaches its preset value.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stop {
    /// Behind the approach point, in reach.
    Between,
    /// During the approach.
    Early,
    /// Out of reach.
    Never,
}
