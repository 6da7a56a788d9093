//! Targets in conversion mode: points, and the program X and C that they become (execution of contours, 4 and 7;
//! E100L-CSC-03, E100L-CSC-04, E100L-CSC-06, E100L-CGF-14).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{ConversionZeroShift, RuleSet};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{C, X};
use crate::engine::words::{Address, Words};

use super::plane::{diameter, direction};
use super::{Conversion, POINT, Station, unspecified};

impl Interpreter<'_> {
    /// The kept point, if the axes stand where it has put them.
    pub(in crate::engine) fn held_point(&self) -> Option<Station> {
        let (kept, shift) = self.state.contour.conversion?.kept?;
        let state = &self.state;
        let now = (state.program(X), state.program(C), state.zero_shift[C]);
        ((kept.x, kept.c, shift) == now || planted::is(Bug::LostPointHolds)).then_some(kept)
    }

    /// Keeps the point that a block has programmed.
    pub(in crate::engine) fn keep_point(&mut self, station: Station) {
        let shift = self.state.zero_shift[C];
        if let Some(conversion) = &mut self.state.contour.conversion {
            conversion.kept = Some((station, shift));
        }
    }

    /// The point that a block programs, counted from a point that is needed unless both words are absolute; none
    /// when it is needed and does not hold.
    pub(in crate::engine) fn target_point(&self, words: &Words, held: Option<Station>) -> Option<Spot> {
        let incremental = self.state.incremental;
        if words.present() & POINT == POINT && !incremental {
            let [p, q] = [Address::X, Address::Y].map(|address| words.get(address).unwrap_or_default());
            return Some(Spot { p, q });
        }
        let from = held?.point;
        let along =
            |address, from| words.get(address).map_or(from, |word| coordinate(from, word, incremental));
        Some(Spot { p: along(Address::X, from.p), q: along(Address::Y, from.q) })
    }

    /// The point that a positioning programs, and what it becomes.
    pub(in crate::engine) fn programmed_station(&mut self, words: &Words) -> Result<Station, Fault> {
        match self.target_point(words, self.held_point()) {
            Some(point) => Ok(self.converted(point)),
            None => Err(unspecified(CSC_06, "start")),
        }
    }

    /// A point with the program X and C that it becomes.
    pub(in crate::engine) fn converted(&mut self, point: Spot) -> Station {
        let axis = self.conversion_axis();
        Station { point, x: diameter(point), c: direction(point, axis, &mut self.slow) }
    }

    /// The angle in which the first axis of the coordinates lies: that of conversion mode, or 0 out of it.
    pub(in crate::engine) fn conversion_axis(&self) -> i64 {
        let Some(Conversion { angle, .. }) = self.state.contour.conversion else { return 0 };
        match self.setup.parameters.conversion_zero_shift {
            ConversionZeroShift::Included => angle,
            ConversionZeroShift::Excluded if planted::is(Bug::ShiftTurnsBack) => {
                angle.saturating_add(self.state.zero_shift[C])
            }
            ConversionZeroShift::Excluded => angle.saturating_sub(self.state.zero_shift[C]),
        }
    }

    /// What a motion in conversion mode cites for its words.
    pub(in crate::engine) fn conversion_rules(&self, words: &Words) -> RuleSet {
        let one = words.has(Address::X) != words.has(Address::Y);
        let mut rules = const { RuleSet::of(&[CSC_02, CSC_03]) };
        for (holds, rule) in
            [(one, CSC_06), (self.state.incremental, CSC_07), (self.state.zero_shift[C] != 0, CSC_04)]
        {
            if holds {
                rules = rules.with(rule);
            }
        }
        rules
    }
}
