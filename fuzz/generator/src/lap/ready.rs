//! What a call needs of the modes, and the blocks that give it.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::{Builder, Kind};
use crate::program::Item;
use crate::state::Mode;

impl Builder<'_, '_, '_> {
    /// Ends what would forbid a call, a block at a time; false where that cannot be.
    pub(crate) fn ready_for_lap(&mut self) -> bool {
        let state = &self.state;
        let refused = state.control.steady
            || state.control.has_modes()
            || state.compensation.is_on()
            || state.mode == Mode::None
            || !self.permits_kind(Kind::Lap)
            || state.incremental && !self.allows(Feature::Absolute);
        if refused || state.setup.options.lap == 0 && state.lap.written {
            return false;
        }
        if self.state.compensation.left_over {
            self.line(Mode::Rapid);
            self.begin();
        }
        if self.state.barriers.is_watched() && self.allows(Feature::Aux) {
            for code in [24, 20] {
                self.state.barriers.note_m(code);
            }
            self.push(vec![Item::m(24), Item::m(20)]);
            self.begin();
        }
        let mut items = Vec::new();
        if self.state.incremental {
            items.push(self.incremental_word(false));
        }
        if !self.state.feed {
            items.push(self.feed_word());
        }
        if !items.is_empty() {
            self.push(items);
            self.begin();
        }
        if self.state.compensation.radius() == 0
            && !self.state.setup.nose_radius.is_empty()
            && self.allows(Feature::RadiusCompensation)
            && self.choices.chance(50)
        {
            let word = self.tool_word();
            self.push(vec![word]);
            self.begin();
        }
        !self.state.compensation.left_over
    }

    /// Feeds per revolution, speeds in G97 and a main spindle without C axis, for threads.
    pub(super) fn ready_for_lap_threads(&mut self) -> bool {
        if !self.allows(Feature::Thread) || !self.ready_for_threads() {
            return false;
        }
        if self.allows(Feature::Aux) {
            // The lead along Z.
            self.push(vec![Item::m(26)]);
            self.begin();
        }
        if self.state.per_minute {
            self.state.per_minute = false;
            let feed = self.feed_word();
            self.push(vec![Item::g(95), feed]);
            self.begin();
        }
        true
    }
}
