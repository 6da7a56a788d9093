//! Words of every thread: lead, its change, start angle, chamfer and spindle, and what may stand beside them.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::companions::has;
use crate::number::Number;
use crate::program::{Item, Word};

use super::pass::Lead;

/// The least and the greatest lead in nanometres, with room for roundings.
const LEADS: std::ops::RangeInclusive<f64> = 1_001.0..=999_000_000.0;

impl Builder<'_, '_, '_> {
    /// Modes, S, T and M codes beside a thread.
    pub(super) fn beside_thread(&mut self, items: &mut Vec<Item>) {
        self.beside_cut(true, items);
    }

    /// The same; without `tools` what may stand in a block that look-ahead reads (E100L-ANG-05).
    pub(super) fn beside_cut(&mut self, tools: bool, items: &mut Vec<Item>) {
        let steady = self.state.control.steady;
        let dimension = self.allows(Feature::Absolute) && self.allows(Feature::Incremental);
        if self.choices.chance(20) && dimension {
            let incremental = self.choices.chance(50);
            items.push(self.incremental_word(incremental));
        }
        if self.choices.chance(5) {
            self.state.per_minute = self.choices.chance(50);
            items.push(Item::g(if self.state.per_minute { 94 } else { 95 }));
        }
        if tools && self.choices.chance(5) && self.allows(Feature::Tool) && !steady {
            items.push(self.tool_word());
        }
        if self.choices.chance(8) && self.allows(Feature::Spindle) {
            items.push(self.turning_speed());
        }
    }

    /// An S word of a spindle that turns.
    pub(super) fn turning_speed(&mut self) -> Item {
        let speed = self.choices.pick(&[300, 500, 1_000, 2_000, 1, 60, 65_535]);
        self.state.threads.note_speed(false, speed);
        self.whole("S", speed)
    }

    /// M codes that belong to threads, or others; `compound` adds the pattern and the flank.
    pub(super) fn codes_of_thread(&mut self, compound: bool, items: &mut Vec<Item>) {
        let steady = self.state.control.steady;
        let aux = self.allows(Feature::Aux);
        if !aux || !steady && self.choices.chance(30) {
            if self.choices.chance(30) {
                self.m_words(items, 3);
            }
            return;
        }
        let chamfer = self.choices.chance(45) && self.may_chamfer();
        if steady || chamfer != self.state.threads.chamfer || self.choices.chance(20) {
            self.thread_code(if chamfer { 23 } else { 22 }, items);
        }
        if chamfer && (!self.is_turning() || self.choices.chance(10)) && self.allows(Feature::Spindle) {
            let code = self.choices.pick(&[3, 3, 4]);
            if self.bears_m(code) {
                self.note_turning(code);
                self.thread_code(code, items);
            }
            if !has(items, "S") {
                items.push(self.turning_speed());
            }
        }
        if compound && (steady || self.choices.chance(50)) {
            let code = self.choices.pick(&[73, 74, 75]);
            self.thread_code(code, items);
        }
        if compound && (steady || self.choices.chance(50)) {
            let code = self.choices.pick(&[32, 33, 33, 34]);
            self.thread_code(code, items);
        }
    }

    fn thread_code(&mut self, code: i64, items: &mut Vec<Item>) {
        self.state.threads.note_m(code);
        items.push(Item::m(code));
    }

    /// Whether a chamfer finds a spindle that turns, or one that may be started.
    fn may_chamfer(&self) -> bool {
        self.is_turning() || self.allows(Feature::Spindle) && self.bears_m(3)
    }

    /// Whether the main spindle turns.
    fn is_turning(&self) -> bool {
        self.state.turning_speed().is_some()
    }

    /// F and J, as they are needed; the lead in nanometres.
    pub(super) fn lead_words(&mut self, items: &mut Vec<Item>) -> f64 {
        let threads = &self.state.threads;
        if let Some(feed) = threads.feed.filter(|feed| LEADS.contains(&(feed / threads.divisor)))
            && self.choices.chance(55)
        {
            if self.choices.chance(8) {
                self.divisor_word(feed, items);
            }
            return feed / self.state.threads.divisor;
        }
        let feed =
            self.choices.pick(&[1_500_000, 2_000_000, 3_000_000, 1_250_000, 500_000, 6_000_000, 25_400_000]);
        let feed = if self.choices.chance(30) { self.choices.within(300, 8_000) * 1_000 } else { feed };
        let (number, amount) = self.per_revolution(feed as f64);
        let (value, _) = self.value(number);
        items.push(Item::Word(Word { address: "F", value }));
        self.state.feed = true;
        self.state.threads.note_feed(true, amount);
        if self.choices.chance(20) {
            self.divisor_word(amount, items);
        }
        amount / self.state.threads.divisor
    }

    fn divisor_word(&mut self, feed: f64, items: &mut Vec<Item>) {
        let divisor = self.choices.pick(&[2, 3, 4, 7, 11, 16, 1]);
        if LEADS.contains(&(feed / divisor as f64)) {
            self.state.threads.divisor = divisor as f64;
            items.push(self.whole("J", divisor));
        }
    }

    /// A number for an amount per revolution in nanometres, and the amount that it is.
    fn per_revolution(&self, amount: f64) -> (Number, f64) {
        let unit = self.state.units.length_unit() as f64;
        let decimals = self.state.units.length_decimals() + 1;
        let scale = 10_f64.powi(decimals.into());
        let mantissa = (amount / unit * scale).round().clamp(-9_999_999.0, 9_999_999.0);
        let mantissa = if mantissa == 0.0 && amount > 0.0 { 1.0 } else { mantissa };
        (Number::decimal(mantissa as i64, decimals), mantissa / scale * unit)
    }

    /// E for a thread of this length, within the range of leads; the change that it is.
    pub(super) fn change_word(
        &mut self,
        lead: f64,
        length: f64,
        sign: Option<f64>,
        items: &mut Vec<Item>,
    ) -> f64 {
        let ends = self.choices.pick(&[1.02, 1.3, 2.0, 0.98, 0.8, 0.5, 3.0, 0.1]);
        let wanted = (ends * lead).clamp(2_000.0, 900_000_000.0);
        let change = (wanted * wanted - lead * lead) / (2.0 * length.max(1.0));
        let change = sign.map_or(change, |sign| change.abs() * sign);
        let (number, change) = self.per_revolution(if sign.is_some() { change.abs() } else { change });
        let (value, _) = self.value(number);
        items.push(Item::Word(Word { address: "E", value }));
        let change = sign.map_or(change, |sign| change * sign);
        if (Lead { start: lead, change }).at(length).is_none() && self.choices.chance(95) {
            items.pop();
            return 0.0;
        }
        change
    }

    /// The C word of a start angle.
    pub(super) fn start_angle(&mut self, items: &mut Vec<Item>) {
        if self.allows(Feature::CAxis) {
            let degrees = self.choices.pick(&[180_000, 120_000, 90_000, 0, 359_999, 1]);
            items.push(self.angle("C", degrees * 1_000).0);
        }
    }

    /// A length that is a word of one of the cycles, as it is read.
    pub(crate) fn amount(&mut self, address: &'static str, wanted: i64, items: &mut Vec<Item>) -> i64 {
        let (item, value) = self.length(address, wanted);
        items.push(item);
        value
    }
}
