//! Faults of LAP.

use turnspec_oracle::vocabulary::Feature;

use super::lap_texts as texts;
use super::{Fault, lacks_codes};
use crate::builder::{Builder, Kind};
use crate::compensation::Side;
use crate::lap;

const MM: i64 = 1_000_000;

impl Builder<'_, '_, '_> {
    /// A fault of LAP, mostly, where the program is to have it.
    pub(super) fn some_lap_fault(&mut self) -> Option<Fault> {
        (self.lap && self.choices.chance(85)).then(|| self.choices.weighted(texts::FAULTS))
    }

    /// Adds blocks with this fault.
    pub(super) fn lap_fault(&mut self, fault: Fault) -> bool {
        if !self.lap
            || !lap::is_within(&self.profile)
            || self.choices.chance(8)
            || !self.permits_kind(Kind::Lap)
        {
            return false;
        }
        match fault {
            Fault::LapLevel => self.below_level(),
            Fault::CompensationNotAllowed => self.call_in_compensation(false),
            Fault::Unspecified if self.choices.chance(10) => self.call_in_compensation(true),
            Fault::NoFeed if self.state.feed || self.state.incremental => false,
            Fault::NoFeed => self.lap_text(fault),
            Fault::Barrier if !self.allows(Feature::Barrier) || !self.jaw_beside() => false,
            _ if !self.ready_for_lap() => false,
            Fault::TravelLimitNegative | Fault::TravelLimitPositive
                if !self.allows(Feature::SystemVariable) =>
            {
                false
            }
            Fault::StepLimit => {
                let low = self.choices.within(8, 60).unsigned_abs();
                let before = std::mem::replace(&mut self.state.setup.limits.steps, low);
                let placed = self.lap_text(fault);
                if !placed {
                    self.state.setup.limits.steps = before;
                }
                placed
            }
            _ => self.lap_text(fault),
        }
    }

    /// One of the texts of a fault.
    fn lap_text(&mut self, fault: Fault) -> bool {
        match texts::TEXTS.iter().find(|(known, _)| *known == fault) {
            Some((_, list)) => self.one_lap_text(list),
            None => false,
        }
    }

    /// One of these texts, with its definitions written out.
    fn one_lap_text(&mut self, list: &[&str]) -> bool {
        let beyond = self.state.units.write_length(self.choices.pick(&[MM, 3 * MM])).text();
        let text = self
            .choices
            .pick(list)
            .replace('~', texts::ALONG)
            .replace('^', texts::ACROSS)
            .replace('!', &beyond);
        if self.state.is_eia() && lacks_codes(&text) {
            return false;
        }
        self.placed(&text)
    }

    /// A code that needs more than the option has.
    fn below_level(&mut self) -> bool {
        if self.state.setup.options.lap == 3 {
            return self.one_lap_text(&["G83", "NQ1 G83"]);
        }
        if self.state.lap.written {
            return false;
        }
        self.state.setup.options.lap = 0;
        self.one_lap_text(texts::WITHOUT_LEVEL)
    }

    /// A call while compensation is in force, or while a displacement is left over.
    fn call_in_compensation(&mut self, ended: bool) -> bool {
        let before = self.one_lap_text(&["~"]);
        if !before || !self.allows(Feature::RadiusCompensation) {
            return false;
        }
        self.in_force("");
        if ended {
            self.state.compensation.side = Side::Off;
            self.blocks(&["G40"]);
        }
        self.one_lap_text(texts::IN_COMPENSATION)
    }
}
