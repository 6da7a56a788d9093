//! How many blocks a run may still begin (E100L-GOTO-03).

/// The blocks that are left; never fewer than none.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Steps(u64);

impl Steps {
    /// So many blocks.
    #[must_use]
    pub fn new(most: u64) -> Self {
        Self(most)
    }

    /// How many are left.
    #[must_use]
    pub fn left(self) -> u64 {
        self.0
    }

    /// Begins so many blocks; false if not all of them are left, and then nothing changes.
    #[inline]
    pub fn take(&mut self, count: u64) -> bool {
        match self.0.checked_sub(count) {
            Some(left) => {
                self.0 = left;
                true
            }
            None => false,
        }
    }
}
