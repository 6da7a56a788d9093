//! Motions into a barrier.

use turnspec_oracle::vocabulary::Feature;

use super::Fault;
use crate::builder::Builder;

impl Builder<'_, '_, '_> {
    /// Adds blocks with this fault.
    pub(super) fn barrier_fault(&mut self, fault: Fault) -> bool {
        if fault != Fault::Barrier || !self.allows(Feature::Barrier) {
            return false;
        }
        if !self.state.barriers.is_wanted() && !self.jaw_beside() {
            return false;
        }
        self.enter_barrier()
    }
}
