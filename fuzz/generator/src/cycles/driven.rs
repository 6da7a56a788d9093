//! A run of a cycle of driven tools: from its first block to G180 and the positioning that has to follow.

use turnspec_oracle::vocabulary::G184Tapping;

use crate::builder::Builder;
use crate::program::Item;
use crate::state::{Axis, Mode};

/// The hole cycles, the key way often, and the thread cycles.
const HOLES: &[i64] = &[181, 182, 183, 183, 184, 184, 189, 178, 179, 190, 190, 190];
const HELICES: &[i64] = &[185, 186, 187, 188];

/// The most blocks that follow a first one, but for one.
const FOLLOWERS: usize = 6;

impl Builder<'_, '_, '_> {
    /// A run of a cycle, or a positioning where none can be.
    pub(super) fn driven(&mut self) {
        if !self.ready_to_drive() {
            return self.line(Mode::Rapid);
        }
        let extended = !self.state.is_eia();
        let helix = extended && self.choices.chance(30);
        let code = self.choices.pick(if helix { HELICES } else { HOLES });
        if !extended && self.is_synchronised(code) {
            return self.line(Mode::Rapid);
        }
        self.speeds_of_cycle(code);
        let first = |builder: &mut Self| {
            if helix { builder.first_helix(code) } else { builder.first_hole(code) }
        };
        if !self.attempt(first) {
            self.begin();
            return self.line(Mode::Rapid);
        }
        self.rest_of_cycle();
        let point = [Axis::X, Axis::Z].map(|axis| self.state.somewhere(axis, self.choices));
        self.position(point);
    }

    /// The blocks behind the first one, as far as G180.
    pub(super) fn rest_of_cycle(&mut self) {
        for _ in 0..self.choices.below(FOLLOWERS) {
            if self.choices.chance(25) {
                self.between_holes();
            }
            if !self.is_spent() && !self.attempt(Self::next_in_cycle) {
                break;
            }
        }
        self.end_of_cycle();
    }

    /// Whether a cycle turns the tool with its feed.
    pub(super) fn is_synchronised(&self, code: i64) -> bool {
        let tapping = self.state.setup.parameters.g184_tapping == G184Tapping::Synchronised;
        matches!(code, 178 | 179) || code == 184 && tapping
    }

    /// SB and SA in front of a cycle, as it needs them.
    pub(super) fn speeds_of_cycle(&mut self, code: i64) {
        if self.state.is_eia() {
            return;
        }
        let mut items = Vec::new();
        if self.is_synchronised(code) || self.choices.chance(75) {
            let zero = !self.is_synchronised(code) && self.choices.chance(8);
            let speed = if zero { 0 } else { self.choices.pick(&[400, 1_000, 100, 1, 65_535]) };
            items.push(self.whole("SB", speed));
        }
        if matches!(code, 185..=188) {
            let speed = self.choices.pick(&[4, 12, 1, 20]);
            items.push(self.whole("SA", speed));
        }
        if !items.is_empty() {
            self.begin();
            self.push(items);
        }
    }

    /// Whether a Q was given: no hole may follow (E100L-MCYC-21).
    fn is_spent(&self) -> bool {
        self.state.cycles.hole.is_some_and(|hole| hole.spent)
    }

    fn next_in_cycle(&mut self) -> bool {
        if self.state.cycles.helix.is_some() { self.next_helix() } else { self.next_hole() }
    }

    /// G180; X and Z have to come behind it.
    fn end_of_cycle(&mut self) {
        self.begin();
        self.push(vec![Item::g(180)]);
        let goes = self.return_of_helix();
        let cycles = &mut self.state.cycles;
        (cycles.mode, cycles.hole, cycles.helix) = (false, None, None);
        self.state.after_cutting = false;
        if !goes {
            self.state.compensation.does_not_fit();
        }
        if self.choices.chance(10) {
            self.assignment_between();
        }
    }
}
