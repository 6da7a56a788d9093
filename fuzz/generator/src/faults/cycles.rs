//! Faults of grooving, drilling and tapping cycles, and of cycles of driven tools.

use turnspec_oracle::vocabulary::Feature;

use super::cycle_texts as texts;
use super::{Fault, choose};
use crate::builder::Builder;
use crate::compensation::Side;
use crate::cycles;
use crate::state::{Axis, Mode};

const MM: i64 = 1_000_000;

impl Builder<'_, '_, '_> {
    /// A fault of any family, mostly one of cycles where the program is to have them.
    pub(crate) fn cycle_fault_or_other(&mut self) -> Fault {
        if self.cycles && self.choices.chance(88) {
            return self.choices.weighted(texts::FAULTS);
        }
        choose(self.choices, &self.state.setup)
    }

    /// Adds blocks with this fault.
    pub(super) fn cycle_fault(&mut self, fault: Fault) -> bool {
        if !self.cycles || !cycles::is_within(&self.profile) || self.choices.chance(10) {
            return false;
        }
        let compensated = self.state.compensation.is_on();
        if !compensated && !self.ready_for_grooves() {
            return false;
        }
        match fault {
            Fault::CompensationNotAllowed => self.cycle_in_compensation(texts::IN_COMPENSATION),
            Fault::Unspecified if self.choices.chance(7) => {
                self.cycle_in_compensation(&[]);
                self.state.compensation.side = Side::Off;
                self.one_of(texts::BESIDE_COMPENSATION)
            }
            _ if compensated => false,
            Fault::TravelLimitNegative | Fault::TravelLimitPositive => self.cycle_beyond_limit(fault),
            Fault::CoordinateRange => self.groove_out_of_range(),
            Fault::Barrier => self.groove_into_barrier(),
            Fault::NoFeed if self.state.feed => false,
            Fault::StepLimit => {
                let low = self.choices.within(8, 60).unsigned_abs();
                let before = std::mem::replace(&mut self.state.setup.limits.steps, low);
                let placed = self.text_of_cycle(fault);
                if !placed {
                    self.state.setup.limits.steps = before;
                }
                placed
            }
            _ => self.text_of_cycle(fault),
        }
    }

    /// A text of one of the families, where it can stand.
    fn text_of_cycle(&mut self, fault: Fault) -> bool {
        let of = |list: &'static [(Fault, &'static [&'static str])]| {
            list.iter().find(|(known, _)| *known == fault).map_or(&[] as &[&str], |(_, texts)| *texts)
        };
        let grooving = self.allows(Feature::Grooving);
        let (grooves, taps) =
            if grooving { (of(texts::GROOVES), of(texts::TAPS)) } else { (&[] as &[_], &[] as &[_]) };
        let driven = if self.may_drive() { of(texts::DRIVEN) } else { &[] };
        let place = self.choices.below(grooves.len() + taps.len() + driven.len());
        if let Some(text) = grooves.get(place) {
            return self.placed(text);
        }
        if let Some(text) = taps.get(place - grooves.len()) {
            let joins = text.contains("M110") && !self.may_drive();
            return !joins && self.ready_for_threads() && self.placed(text);
        }
        let Some(text) = driven.get(place - grooves.len() - taps.len()) else { return false };
        let feed = self.state.units.write_length(MM / 2).text();
        self.blocks(&["M110", "M146", &format!("G90 G94 F{feed}")]) && self.placed(text)
    }

    /// A text with its amounts and coordinates.
    pub(super) fn placed(&mut self, text: &str) -> bool {
        let mut written = String::new();
        let mut rest = text;
        while let Some(mark) = rest.find(['#', '@']) {
            let (before, marked) = rest.split_at(mark);
            written.push_str(before);
            let digits = |character: char| !matches!(character, '0'..='9' | '-' | '.');
            let end = marked[1..].find(digits).map_or(marked.len(), |end| end + 1);
            let amount = (marked[1..end].parse::<f64>().unwrap_or_default() * MM as f64) as i64;
            let base =
                match (marked.starts_with('@'), written.trim_end_matches(['=', 'A', 'B']).ends_with('X')) {
                    (false, _) => 0,
                    (true, true) => self.state.program(Axis::X),
                    (true, false) => self.state.program(Axis::Z),
                };
            written.push_str(&self.state.units.write_length(base + amount).text());
            rest = &marked[end..];
        }
        written.push_str(rest);
        self.blocks(&written.split('\n').collect::<Vec<_>>())
    }

    /// One of these texts while compensation is in force.
    fn cycle_in_compensation(&mut self, list: &[&str]) -> bool {
        if !self.state.compensation.is_on() {
            self.in_force("");
        }
        !list.is_empty() && self.one_of(list)
    }

    /// A limit close to the present position, and a cycle of which one motion lies beyond it.
    fn cycle_beyond_limit(&mut self, fault: Fault) -> bool {
        if self.state.is_eia() || !self.allows(Feature::SystemVariable) {
            return false;
        }
        let axis = if self.choices.chance(50) { Axis::X } else { Axis::Z };
        let positive = fault == Fault::TravelLimitPositive;
        let name = format!("V{}VL{}", if positive { 'P' } else { 'N' }, axis.address());
        let way = if positive { 3 } else { -3 };
        let limit = (self.state.machine[axis as usize] + way * MM) / 1_000 * 1_000;
        let limit = self.state.units.write_length(limit).text();
        let way = self.state.sign(axis) * way * self.choices.pick(&[2, 5]);
        let (code, approach) = if axis == Axis::X { ("G73", "I") } else { ("G74", "K") };
        let text = match self.choices.below(3) {
            0 => format!("G91 {code} {}#{way} D#2 F#1", axis.address()),
            1 if self.may_drive() => format!("M110\nM146\nG90 G94 F#1 G181 {approach}#2 R#{way}"),
            1 | 2 => format!("G91 {code} {}#{way} {approach}#1 D#9 F#1", axis.address()),
            _ => return false,
        };
        self.allows(Feature::Grooving) && self.blocks(&[&format!("{name}={limit}")]) && self.placed(&text)
    }

    fn groove_out_of_range(&mut self) -> bool {
        let far = if self.state.units.system.is_inch() { 250_000 * MM } else { 99_999_999_000 };
        let far = self.state.units.write_length(if self.choices.chance(50) { far } else { -far }).text();
        let (axis, code) = if self.choices.chance(50) { ("X", 73) } else { ("Z", 74) };
        let text = format!("G{code} {axis}{far} D99999999 F1");
        self.allows(Feature::Grooving) && self.blocks(&["G91", &format!("G00 {axis}{far}"), &text])
    }

    /// A groove through a jaw beside the present point.
    fn groove_into_barrier(&mut self) -> bool {
        if !self.allows(Feature::Barrier) || !self.allows(Feature::Grooving) || !self.jaw_beside() {
            return false;
        }
        self.state.mode = Mode::Rapid;
        self.state.incremental = true;
        self.placed("G91 G74 X#2 Z#-30 I#2 D#10 F#1 M25")
    }
}
