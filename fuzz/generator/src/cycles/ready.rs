//! What cycles need of the modes, and the blocks that allow them.

use crate::builder::{Builder, Kind};
use crate::program::Item;
use crate::state::{Axis, Mode};
use turnspec_oracle::vocabulary::{Feature, MachineType};

use super::has_driven;

impl Builder<'_, '_, '_> {
    /// Ends a displacement that is left over; whether a groove may be cut here.
    pub(crate) fn ready_for_grooves(&mut self) -> bool {
        if self.state.compensation.left_over && !self.state.compensation.is_on() {
            self.line(Mode::Rapid);
            self.begin();
        }
        !(self.state.compensation.is_on() || self.state.compensation.left_over)
    }

    /// Whether cycles of driven tools may stand here: the C axis belongs to turret A (E100L-MIRR-20), and what runs
    /// more than once does not find it as it was left.
    pub(crate) fn may_drive(&self) -> bool {
        let axis =
            self.permits_kind(Kind::CAxis) && self.state.setup.machine.r#type != MachineType::TwoSaddles;
        let absolute = !self.state.incremental || self.allows(Feature::Absolute);
        has_driven(&self.profile) && axis && absolute && !self.state.control.steady
    }

    /// Blocks that join and release the C axis, choose its direction and take the tool to a cycle start; false where
    /// compensation forbids a cycle.
    pub(super) fn ready_to_drive(&mut self) -> bool {
        if !self.ready_for_grooves() {
            return false;
        }
        if !self.state.joined {
            self.note_m(110);
            self.push(vec![Item::m(110)]);
            self.begin();
        }
        let mut codes = Vec::new();
        if self.state.clamped || self.choices.chance(15) {
            codes.push(146);
        }
        if self.choices.chance(35) {
            codes.push(self.choices.pick(&[15, 16]));
        }
        if self.choices.chance(35) && self.allows(Feature::Aux) {
            codes.push(self.choices.pick(&[211, 212, 213, 214]));
        }
        let together = self.choices.chance(30);
        let mut items = Vec::new();
        for code in codes {
            self.note_m(code);
            items.push(Item::m(code));
            if !together {
                self.push(std::mem::take(&mut items));
                self.begin();
            }
        }
        if !items.is_empty() {
            self.push(items);
            self.begin();
        }
        if self.choices.chance(75) {
            let point = [Axis::X, Axis::Z].map(|axis| self.state.somewhere(axis, self.choices));
            self.position(point);
        }
        true
    }

    /// Words of a first block that the modes need: G90, the feed mode of the cycle.
    pub(super) fn modes_of_cycle(&mut self, per_minute: Option<bool>, items: &mut Vec<Item>) {
        if self.state.incremental || self.choices.chance(10) && self.allows(Feature::Absolute) {
            items.push(self.incremental_word(false));
        }
        match per_minute {
            Some(per_minute) => self.feed_mode(per_minute, items),
            None if self.choices.chance(20) => self.feed_mode(!self.state.per_minute, items),
            None => {}
        }
    }
}
